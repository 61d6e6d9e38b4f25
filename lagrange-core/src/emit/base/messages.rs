//! Diagnostics for systems that are hard to compile or to integrate.

use crate::model::Product;
use lagrange_algebra::code::Precision;
use lagrange_algebra::series::NoSeries;

pub(in crate::emit) fn expensive(size: usize, checking: f64, optimising: f64, bytes: f64) -> String {
    format!(
        "the methods take {size} operations: the compiler needs roughly {checking:.0} s \
         and {:.1} GB to check them, up to {optimising:.0} s more to optimise them",
        bytes / 1e9
    )
}

pub(in crate::emit) fn expensive_help() -> String {
    format!("{}; `#[allow(deprecated)]` on the struct silences this warning", smaller())
}

pub(in crate::emit) fn hopeless(limit: usize) -> String {
    format!("this system takes more than {limit} operations, too many to compile in reasonable time")
}

pub(in crate::emit) fn too_many(given: usize, kind: &str, most: usize) -> String {
    format!(
        "this system has {given} {kind}, and with more than {most} it takes too long to derive and to compile"
    )
}

pub(in crate::emit) const FEWER_HELP: &str =
    "declare a part of it, and compute forces between many such parts in a loop that passes them as inputs";

pub(in crate::emit) const FEWER_CONSTRAINTS_HELP: &str = "leave out constraints that follow from others";

pub(in crate::emit) const FEWER_OUTPUTS_HELP: &str =
    "compute indexed quantities from the state, in a function of your crate";

pub(in crate::emit) fn too_many_events(most: usize) -> String {
    format!("a system can have at most {most} events")
}

pub(in crate::emit) const FEWER_CONTACTS_HELP: &str =
    "each contact point counts, and so does its friction; remove contacts of bodies that cannot touch";

pub(in crate::emit) fn too_many_pairs(contacts: usize, velocities: usize) -> String {
    format!("steps of {contacts} contacts and {velocities} velocities take too much memory")
}

pub(in crate::emit) fn fewer_pairs_help(most: usize) -> String {
    format!(
        "the product of both numbers can be at most {most}; declare bodies that never meet as separate systems"
    )
}

pub(in crate::emit) fn many_contacts(most: usize) -> String {
    format!("a system of more than {most} contacts and frictions needs the method `Stepped`")
}

pub(in crate::emit) const FEWER_EVENTS_HELP: &str =
    "pass events that do not affect the system to a simulation instead";

pub(in crate::emit) fn unlocated_switches(all: usize, room: usize) -> String {
    format!(
        "the equations of motion have jumps or kinks on {all} surfaces, of which runs can locate {room}: steps across the others \
         lose their order"
    )
}

pub(in crate::emit) const UNLOCATED_HELP: &str = "they come from `if`, `abs`, `sign`, `min` and `max`; smooth functions such as `tanh` or `sqrt(x^2 + e^2)` have none; \
     `#[allow(deprecated)]` on the struct silences this warning";

pub(in crate::emit) fn smaller() -> &'static str {
    "omit methods with `emit { no … }`, or compute forces between many bodies in a loop and pass them as \
     inputs"
}

pub(in crate::emit) fn excluded(product: Product, exclusion: &str) -> String {
    format!("`{}` cannot be combined with {exclusion}", product.name())
}

pub(in crate::emit) fn missing_derivative(derivative: &str, needed_by: &str) -> String {
    format!("{needed_by} needs {derivative}, for which no function is specified").replacen(
        "motion needs",
        "motion need",
        1,
    )
}

pub(in crate::emit) fn missing_derivative_help(label: &str, product: Option<&str>) -> String {
    let named = format!("specify the function that computes it: `{label}: name;`");
    match product {
        Some(product) => format!("{named}; or omit that method with `emit {{ no {product} }}`"),
        None => named,
    }
}

pub(in crate::emit) const CALLED_HERE: &str = "the function is called here";

/// Returns the help for a product excluded by a system.
pub(in crate::emit) fn without(product: Product) -> &'static str {
    match product {
        Product::Kernel => {
            "remove it; devices only run systems without constraints, rigid contacts, friction and events"
        }
        Product::Taylor => "remove it and integrate with `Verner98`",
        Product::Tests => {
            "remove it, and call `lagrange::laws::check` in tests of your own; or give each parameter a value: `param m = 1;`"
        }
        Product::Lanes => "remove it; ensembles run such systems one by one, on all threads",
        _ => {
            "remove it; only systems whose accelerations are computed in the same way for all states can be prepared"
        }
    }
}

pub(in crate::emit) fn large_in_kernel(precision: Precision, constants: &[String]) -> String {
    let scalar = match precision {
        Precision::Double => "f64",
        Precision::Single => "f32",
    };
    format!(
        "`kernel` is also emitted in `{scalar}`, for which these numbers are too large: {}",
        constants.join(", ")
    )
}

pub(in crate::emit) fn without_series(cause: &NoSeries) -> String {
    format!("this motion has no Taylor series: {cause}")
}

pub(in crate::emit) const WITHOUT_SERIES_HELP: &str =
    "remove it and integrate with `Verner98`, which only needs the right-hand side";
pub(in crate::emit) const NOTHING_LINEAR: &str =
    "`regressor` has no columns: the inverse dynamics is not linear in any parameter";
pub(in crate::emit) const NOTHING_LINEAR_HELP: &str =
    "declare masses, moments of inertia, stiffness or damping with `param`, or bodies; or remove it";
pub(in crate::emit) const LARGE_IN_KERNEL_HELP: &str = "choose larger units, or remove it";
pub(in crate::emit) const EVENTS: &str = "events, which a run locates";
pub(in crate::emit) const NOISE: &str =
    "noise, which only `EulerMaruyama` and `StochasticRungeKutta4` integrate";
pub(in crate::emit) const FUNCTIONS: &str =
    "functions of the crate, tables or equations to `solve`, which are unavailable on devices";
pub(in crate::emit) const DELAYS: &str = "delayed signals, whose past a run keeps";
pub(in crate::emit) const WITHOUT_DEFAULTS: &str = "parameters without a default, since tests need values";
pub(in crate::emit) const CONTACTS: &str =
    "rigid contacts or friction, whose modes change the equations; a contact with a `stiffness` has none";
pub(in crate::emit) const CONSTRAINTS: &str = "constraints, whose forces are computed at run time";
pub(in crate::emit) const REDUNDANT: &str =
    "constraints that follow from others, whose forces are not determined";
pub(in crate::emit) const SWITCHES: &str = "jumps or kinks, such as those of `if`, `abs`, `sign`, `min` and `max`, whose sides a run fixes in each step";
pub(in crate::emit) const INDEFINITE: &str = "an indefinite mass matrix, which needs a fallback solution";
pub(in crate::emit) const ORIENTATIONS: &str =
    "orientations, whose quaternions a run normalises after every step";
