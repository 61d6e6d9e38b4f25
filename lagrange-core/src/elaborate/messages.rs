//! Diagnostics for the meaning of a declaration.

use crate::model::Product;
use lagrange_expr::expr::Dependencies;

pub(super) mod events;
pub(super) mod inertia;
pub(super) mod names;
pub(super) mod scene;
pub(super) mod solve;
pub(super) mod states;
pub(super) mod tables;

pub(super) fn scalar_needed(what: &str, found: &str) -> String {
    format!("{what} must be a scalar, but this is {found}")
}

pub(super) const HOW_TO_GET_A_SCALAR: &str = "use a component such as `.x`, or `norm(v)`, or `inner(v, w)`";

pub(super) fn vector_needed(what: &str, found: &str) -> String {
    format!("{what} must be a vector, but this is {found}")
}

pub(super) fn kinds_differ(operation: &str, left: &str, right: &str) -> String {
    format!("cannot {operation} {left} and {right}")
}

pub(super) const KINDS_HELP: &str = "make both scalars, with components such as `.x` or `norm(v)`, or both vectors of as many components, such as `(0, e)`";
pub(super) const VECTOR_HELP: &str = "write a vector, such as `(x, y)`";
pub(super) const PRODUCT_OF_VECTORS: &str = "the product of two vectors is ambiguous";
pub(super) const INNER_OR_CROSS: &str =
    "use `inner(v, w)` for the scalar and `cross(v, w)` for the vector product";
pub(super) const DIVISION_BY_VECTOR: &str = "cannot divide by a vector";
pub(super) const DIVISION_BY_ZERO: &str = "division by zero";

pub(super) const FUNCTION_HELP: &str = "write its arguments in parentheses after it";
pub(super) const TUPLE_SIZE_HELP: &str =
    "write as many names as there are components, `let (a, b) = (e, f);`, or a single one, `let v = (e, f);`";
pub(super) const ZERO_BASE_HELP: &str = "a negative power of zero is undefined";
pub(super) const DIVISION_HELP: &str = "this divisor is zero for all values of the parameters";

pub(super) const NUMBER_TOO_LONG: &str = "the numbers in this expression become too long to remain exact";
pub(super) const NUMBER_TOO_LONG_HELP: &str = "round a constant before using it repeatedly";

pub(super) fn root_of_negative(base: &str, exponent: &str) -> String {
    let exponent = if exponent.contains(['/', '-']) { format!("({exponent})") } else { exponent.to_owned() };
    format!("({base})^{exponent} is not a real number")
}

pub(super) fn varying_power_of_negative(base: &str) -> String {
    format!(
        "a power of the negative number {base} is real only for integer exponents, and this exponent may have other values"
    )
}

pub(super) const NEGATIVE_BASE_HELP: &str =
    "make the base positive; the sign in `-2^x` applies to the power, that in `(-2)^x` to the base";

pub(super) const NOT_REAL: &str = "this is not a real number";

pub(super) fn defined_where(function: &str, domain: &str) -> String {
    format!("`{function}` is defined {domain}")
}

pub(super) fn excessive(is_constant: bool, scalar: &str) -> String {
    format!("{} is too large for `{scalar}`", number_in(is_constant))
}

pub(super) fn vanishing(is_constant: bool, scalar: &str) -> String {
    format!("{} is too small for `{scalar}`, where it would lose digits", number_in(is_constant))
}

fn number_in(is_constant: bool) -> &'static str {
    if is_constant { "this number" } else { "a number in this expression" }
}

pub(super) const VANISHING_HELP: &str = "choose smaller units, or remove it";

pub(super) fn no_component(component: &str, kind: &str) -> String {
    format!("there is no component `{component}` in {kind}")
}

pub(super) const COMPONENTS: &str = "vectors have the components `x`, `y` and, in space, `z`";

pub(super) fn rate_of_input(name: &str) -> String {
    format!("the rate of input `{name}` is unknown")
}

/// Message for the rate of what is made of numbers and parameters.
pub(super) fn rate_of_constant(what: &str) -> String {
    format!("`{what}` does not change during the motion, so its rate is zero")
}

pub(super) const RATE_OF_CONSTANT_HELP: &str = "remove the rate, declare the quantity as a `coord`, or write it as a function of `t`; the scalar product is `inner(v, w)`";

pub(super) const RATE_OF_FORCE_HELP: &str =
    "remove the rate: forces follow from the motion, not from a separate equation";

pub(super) fn rate_of_force(name: &str) -> String {
    format!("the rate of the force `{name}` is unknown")
}

pub(super) const RATE_OF_INPUT_HELP: &str =
    "an input may change at any time; make its rate another `input`, or the quantity a `coord`";

/// `name` is that of the culprit, if it has one.
pub(super) fn must_not_depend(place: &str, kind: Dependencies, name: &str) -> String {
    let culprit = match kind {
        Dependencies::VELOCITY => "velocities".to_owned(),
        Dependencies::STATE => format!("the state `{name}`"),
        Dependencies::MULTIPLIER => format!("the multiplier `{name}`"),
        Dependencies::REACTION => format!("the force `{name}`"),
        _ => "accelerations".to_owned(),
    };
    format!("{place} must not depend on {culprit}")
}

pub(super) const NO_VELOCITY: &str = "this is not a velocity: it is not a sum of rates";
pub(super) const NO_VELOCITY_HELP: &str = "a force works along a velocity such as `dot(x)` or `dot(x) - r * dot(phi)`; at a point, write `force F at P;`";
pub(super) const PLACE_HELP: &str = "places and angles are functions of the coordinates and of time";
pub(super) const POTENTIAL_HELP: &str =
    "put terms with velocities into `kinetic`, `lagrangian` or `dissipation`";
pub(super) const ONLY_OUTPUTS_HOLD_ACCELERATIONS: &str = "`ddot` is accepted in outputs, events and Gibbs functions; the force of a constraint, contact or friction, in outputs";

pub(super) fn input_in_kinetic(name: &str) -> String {
    format!("the rate of input `{name}` is needed here but unknown: it multiplies a velocity")
}

pub(super) fn not_constant(what: &str) -> String {
    format!("{what} cannot depend on this")
}

pub(super) const NOT_CONSTANT_HELP: &str =
    "compute it from numbers, `pi` and `const` names only; a `let` may depend on anything";

pub(super) fn both_lagrangian_and(other: &str) -> String {
    format!("`{other}` cannot be combined with `lagrangian`")
}

pub(super) const LAGRANGIAN_HELP: &str = "L = T - V: give either `lagrangian`, or `kinetic` and `potential`";
pub(super) const LAGRANGIAN_IS_HERE: &str = "the Lagrangian is given here";
pub(super) const NO_COORDINATES: &str = "a system needs at least one generalised coordinate";
pub(super) const COORDINATES_HELP: &str = "declare them with `coord x, theta;`";
pub(super) const NO_ENERGY: &str = "a system needs a kinetic energy or a Lagrangian";
pub(super) const ENERGY_HELP: &str = "write `kinetic = …;` and `potential = …;`, or `lagrangian = …;`";

pub(super) fn no_inertia(name: &str) -> String {
    format!(
        "`{name}` has no inertia: the kinetic energy does not grow with its velocity, so nothing determines its acceleration"
    )
}

pub(super) const NO_INERTIA_HELP: &str = "add its kinetic energy, or make it a `param` or an `input`";

pub(super) const NEGATIVE_INERTIA: &str = "this mass or moment of inertia is negative";

pub(super) fn negative_kinetic_energy(name: &str) -> String {
    format!("this kinetic energy decreases as `{name}` moves faster, but inertia is positive")
}

pub(super) const NEGATIVE_INERTIA_HELP: &str =
    "check the sign; a Lagrangian that is not T − V can be given as `lagrangian = …;`";

pub(super) const MOMENTA_JUMP: &str =
    "energies need second derivatives by velocities, but here a momentum jumps where this changes its branch";

pub(super) const MOMENTA_JUMP_HELP: &str = "write an even power, such as `1/2*m*norm(v)^2`, or a `force`, `dissipation` or `friction` for a resistance to motion";

pub(super) const GIBBS_WITHOUT_ACCELERATIONS: &str = "this Gibbs function does not depend on accelerations";
pub(super) const GIBBS_OF_HIGH_DEGREE: &str =
    "a Gibbs function must be a polynomial of degree two in the accelerations";
pub(super) const GIBBS_HELP: &str = "add up ½ m |a|² of all masses m, with accelerations such as `ddot(x)`";

pub(super) fn not_a_coordinate(name: &str) -> String {
    format!("`{name}` is not a coordinate")
}

pub(super) const FORCE_HELP: &str =
    "`force x = …;` acts on a coordinate; `force (fx, fy) at (px, py);` acts at a point";

pub(super) fn largest_help(scalar: &str, largest: f64) -> String {
    format!("`{scalar}` holds numbers up to about {largest:.1e}: choose larger units")
}

/// Longer lists do not help.
const MAX_LISTED: usize = 10;

pub(super) fn coordinates_are(names: &[&str], usage: &str) -> String {
    match names {
        [] => COORDINATES_HELP.to_owned(),
        [name] => format!("the coordinate is `{name}`"),
        _ if names.len() > MAX_LISTED => usage.to_owned(),
        _ => format!("the coordinates are `{}`", names.join("`, `")),
    }
}

pub(super) fn reserved_output(name: &str) -> String {
    format!("an output cannot be called `{name}`, since the system already has a member of that name")
}

pub(super) const OTHER_NAME_HELP: &str = "choose another name";

pub(super) fn velocity_field_collides(name: &str, coordinate: &str) -> String {
    format!("`{name}` collides with the name of the velocity of `{coordinate}`")
}

pub(super) fn coordinate_is_here(name: &str) -> String {
    format!("the velocity of this coordinate is called `{name}_dot`")
}

pub(super) fn unknown_product(name: &str) -> String {
    format!("`{name}` cannot be emitted")
}

pub(super) fn products() -> String {
    let names = Product::ALL.map(|product| format!("`{}`", product.name()));
    format!("the options are {}; write `no` before one to omit it", names.join(", "))
}

pub(super) fn needs_separate_energies(name: &str) -> String {
    format!("`{name}` is not defined for a system given by its `lagrangian`")
}

pub(super) fn needs_constraints(name: &str) -> String {
    format!("`{name}` is not defined for a system without constraints")
}

pub(super) const CONSTRAINT_HELP: &str = "write `constraint name = e;` for e = 0";

pub(super) fn needed_product(name: &str) -> String {
    format!("`{name}` cannot be left out here")
}

pub(super) fn needed_product_help(name: &str, reason: &str) -> String {
    format!("remove `no {name}`: {reason}")
}

pub(super) const NEEDED_BY_MOMENTUM_RATES: &str =
    "methods that use `momentum_rates` compute velocities with it";
pub(super) const NEEDED_BY_PROJECTION: &str = "it projects states back onto the constraints";

pub(super) fn derivative_of_jumps(name: &str) -> String {
    format!("`{name}` does not exist for a system with contacts or dry friction: its accelerations jump")
}

pub(super) const DERIVATIVE_OF_JUMPS_HELP: &str = "remove it; implicit methods iterate without it";

pub(super) fn acts_here(name: &str) -> String {
    format!("`{name}` acts or not, depending on its mode")
}

pub(super) fn tuple_size(names: usize, found: &str) -> String {
    format!("{names} names for {found}")
}

pub(super) const DERIVED_DEFAULT: &str = "`Default` is implemented by `system!` from the declared defaults";
pub(super) const DERIVED_DEFAULT_HELP: &str = "remove `Default` from the `derive`";

/// Message for traits that types with such fields cannot have.
pub(super) fn underivable(names: &[&str], scalar: &str) -> String {
    let names = names.join("`, `");
    format!(
        "`{names}` cannot be derived: parameters and inputs are fields of type `{scalar}`, which is not `Eq`, since NaN differs from itself"
    )
}

pub(super) const UNDERIVABLE_HELP: &str =
    "derive `PartialEq` and `PartialOrd` only; as a key use the bits of a number, `to_bits()`";

pub(super) fn number_too_large(name: &str, scalar: &str) -> String {
    format!("the default of `{name}` is too large for `{scalar}`")
}

pub(super) fn number_too_small(name: &str, scalar: &str) -> String {
    format!("the default of `{name}` is too small for `{scalar}`, where it would lose digits")
}

// Constraints.

pub(super) fn constrains_nothing(name: &str) -> String {
    format!("the constraint `{name}` does not depend on any coordinate")
}

pub(super) fn impossible_constraint(name: &str, value: &str) -> String {
    format!(
        "the constraint `{name}` cannot be satisfied: it does not depend on any coordinate and is {value}, not 0"
    )
}

pub(super) const CONSTRAINS_NOTHING_HELP: &str =
    "write a function of coordinates or velocities that is to be zero";

pub(super) fn nonlinear_constraint(name: &str) -> String {
    format!("the constraint `{name}` is not linear in the velocities")
}

pub(super) const NONLINEAR_CONSTRAINT_HELP: &str =
    "constraints are functions of coordinates and time, or sums of velocities times such functions";

pub(super) fn repeated_constraint(name: &str, other: &str) -> String {
    format!("the constraint `{name}` repeats `{other}`, so nothing determines its multiplier")
}

pub(super) fn contradicting_constraint(name: &str, other: &str) -> String {
    format!("the constraint `{name}` contradicts `{other}`: no motion satisfies both")
}

/// Message for two constraints that differ by what parameters decide.
pub(super) fn nearly_repeated(name: &str, other: &str, difference: &str) -> String {
    format!("the constraint `{name}` contradicts `{other}`, or repeats it where `{difference}` is zero")
}

pub(super) const CONTRADICTING_HELP: &str =
    "remove one of them, or make them one constraint with the right value";
pub(super) const REPEATED_CONSTRAINT_HELP: &str = "remove one of them";
pub(super) const OTHER_CONSTRAINT_IS_HERE: &str = "the other one is here";

pub(super) fn no_place(what: &str) -> String {
    format!("{what} must be made of coordinates and time")
}

pub(super) const REPEATED_JOINT: &str = "this joint repeats another constraint";
pub(super) const FORCE_OF_IMPLIED: &str =
    "this joint has no separate force, since the coordinates already satisfy it";
pub(super) const FORCE_OF_IMPLIED_HELP: &str =
    "add coordinates that can violate the joint: the multiplier of its constraint is then the force";

pub(super) const REDUCED_CONSTRAINTS: &str = "a system with constraints cannot be reduced yet";
pub(super) const REDUCED_CONSTRAINTS_HELP: &str =
    "remove the `reduce`, or choose coordinates that satisfy the constraint identically";
pub(super) const CONSTRAINT_IS_HERE: &str = "a constraint is here";

// Reduced types.

pub(super) fn reduced_quaternion(name: &str) -> String {
    format!("`{name}` is a component of a unit quaternion, which has no meaning without the others")
}
pub(super) const REDUCED_QUATERNION_HELP: &str =
    "describe a frozen or small orientation by angles, as three revolute joints";

pub(super) const REDUCTION_HELP: &str = "`freeze` and `small` take coordinates: `freeze x = 0; small theta;`";
pub(super) const ALL_FROZEN: &str = "every coordinate is frozen, so nothing can move";
pub(super) const ALL_FROZEN_HELP: &str = "leave at least one coordinate free, or make it `small`";
pub(super) const PINNED_VALUE: &str = "the value of a coordinate that is frozen or small";
pub(super) const CONSTANT_IN_MOTION_HELP: &str =
    "compute it from numbers, `pi`, `const` names and parameters, which do not change during the motion";
pub(super) const TYPE_NAME_HELP: &str = "each declared type `Name` comes with `NameState`, `NameColumns`, `NameInputs`, `NamePrepared` and `NameLanes`: choose a different name";

pub(super) fn reduced_twice(name: &str) -> String {
    format!("`{name}` is named twice in this reduction")
}

pub(super) const NAMED_TWICE_HELP: &str = "remove one of them";
pub(super) const NAMED_HERE: &str = "first named here";

pub(super) fn type_name_taken(name: &str) -> String {
    format!("the type name `{name}` is already taken")
}

pub(super) const TYPE_NAMED_HERE: &str = "by this declaration";

pub(super) fn no_expansion(part: &str, coordinate: Option<&str>) -> String {
    match coordinate {
        Some(name) => format!("{part} has no second-order expansion about this value of `{name}`"),
        None => format!("{part} has no second-order expansion about these values"),
    }
}

pub(super) const NO_EXPANSION_HELP: &str = "it is not defined there or has a kink there: a coordinate can be small only where energies and forces are smooth";

pub(super) fn undefined_when_frozen(part: &str) -> String {
    format!("{part} is not defined with this coordinate at this value")
}

pub(super) const UNDEFINED_HELP: &str =
    "it divides by zero there, for example; freeze the coordinate at another value";

pub(super) fn output_of_reduced(name: &str) -> String {
    format!(
        "beside `reduce`, an output cannot be called `{name}`, since reduced types have a method of that name"
    )
}

pub(super) fn inertia_lost(coordinate: &str) -> String {
    format!("`{coordinate}` has no inertia in this reduced system")
}

pub(super) const INERTIA_LOST_HELP: &str = "its kinetic energy vanishes with the frozen coordinates, or is of higher than second order in the small ones";
