//! Diagnostics for systems that are hard to compile or to integrate.

use crate::model::Product;
use lagrange_algebra::code::Precision;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::emit):

    expensive(size, checking, optimising, gigabytes) =
        "the methods take {size} operations: the compiler needs roughly {checking:.0} s \
         and {gigabytes:.1} GB to check them, up to {optimising:.0} s more to optimise them";
    expensive_help(smaller) = "{smaller}; `#[allow(deprecated)]` on the struct silences this warning";
    SMALLER =
        "omit methods with `emit { no … }`, or compute forces between many bodies in a loop and pass them as inputs";
    hopeless(limit) =
        "this system takes more than {limit} operations, too many to compile in reasonable time";

    too_many(given, kind, most) =
        "this system has {given} {kind}, and with more than {most} it takes too long to derive and to compile";
    FEWER_HELP =
        "declare a part of it, and compute forces between many such parts in a loop that passes them as inputs";
    FEWER_CONSTRAINTS_HELP = "leave out constraints that follow from others";
    FEWER_OUTPUTS_HELP = "compute indexed quantities from the state, in a function of your crate";
    FEWER_CONTACTS_HELP =
        "each contact point counts, and so does its friction; remove contacts of bodies that cannot touch";
    too_many_events(most) = "a system can have at most {most} events";
    FEWER_EVENTS_HELP = "pass events that do not affect the system to a simulation instead";
    too_many_pairs(contacts, velocities) =
        "steps of {contacts} contacts and {velocities} velocities take too much memory";
    fewer_pairs_help(most) =
        "the product of both numbers can be at most {most}; declare bodies that never meet as separate systems";
    many_contacts(most) = "a system of more than {most} contacts and frictions needs the method `Stepped`";

    unlocated_switches(all, room) =
        "the equations of motion have jumps or kinks on {all} surfaces, of which runs can locate {room}: steps across the others lose their order";
    UNLOCATED_HELP =
        "they come from `if`, `abs`, `sign`, `min` and `max`; smooth functions such as `tanh` or `sqrt(x^2 + e^2)` have none; `#[allow(deprecated)]` on the struct silences this warning";
    CALLED_HERE = "the function is called here";
    excluded(product, exclusion) = "`{product}` cannot be combined with {exclusion}";
    without_series(cause) = "this motion has no Taylor series: {cause}";
    WITHOUT_SERIES_HELP = "remove it and integrate with `Verner98`, which only needs the right-hand side";
    NOTHING_LINEAR = "`regressor` has no columns: the inverse dynamics is not linear in any parameter";
    NOTHING_LINEAR_HELP =
        "declare masses, moments of inertia, stiffness or damping with `param`, or bodies; or remove it";
    LARGE_IN_KERNEL_HELP = "choose larger units, or remove it";

    EVENTS = "events, which a run locates";
    NOISE = "noise, which only `EulerMaruyama` and `StochasticRungeKutta4` integrate";
    FUNCTIONS = "functions of the crate, tables or equations to `solve`, which are unavailable on devices";
    DELAYS = "delayed signals, whose past a run keeps";
    WITHOUT_DEFAULTS = "parameters without a default, since tests need values";
    CONTACTS =
        "rigid contacts or friction, whose modes change the equations; a contact with a `stiffness` has none";
    CONSTRAINTS = "constraints, whose forces are computed at run time";
    REDUNDANT = "constraints that follow from others, whose forces are not determined";
    SWITCHES =
        "jumps or kinks, such as those of `if`, `abs`, `sign`, `min` and `max`, whose sides a run fixes in each step";
    INDEFINITE = "an indefinite mass matrix, which needs a fallback solution";
    ORIENTATIONS = "orientations, whose quaternions a run normalises after every step";
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
