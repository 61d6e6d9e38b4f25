//! Diagnostics for the meaning of a declaration.

use crate::model::Product;
use lagrange_expr::diagnostics::messages;
use lagrange_expr::expr::Dependencies;
use lagrange_language::syntax::ast::ArrayShape;

pub(super) mod delays;
pub(super) mod events;
pub(super) mod history;
pub(super) mod inertia;
pub(super) mod names;
pub(super) mod noise;
pub(super) mod partials;
pub(super) mod ranges;
pub(super) mod scene;
pub(super) mod solve;
pub(super) mod start;
pub(super) mod states;
pub(super) mod tables;

messages! {
    pub(super):

    scalar_needed(what, found) = "{what} must be a scalar, but this is {found}";
    POWER_HELP = "write `inner(v, v)` for the square of a vector, and `A * A` for that of a matrix";
    HOW_TO_GET_A_SCALAR = "use a component such as `.x` or `v[0]`, or `norm(v)`, or `inner(v, w)`";
    vector_needed(what, found) = "{what} must be a vector, but this is {found}";
    kinds_differ(operation, left, right) = "cannot {operation} {left} and {right}";
    EQUALITY = "quantities that vary during the motion cannot be compared for equality";
    EQUALITY_HELP =
        "`==` and `!=` compare discrete states, parameters and numbers; compare this with `<`, `<=`, `>` or `>=`";
    KINDS_HELP =
        "make both scalars, with components such as `.x` or `norm(v)`, or both vectors with the same number of components, such as `(0, e)`";
    VECTOR_HELP = "write a vector, such as `(x, y)`";
    PRODUCT_OF_VECTORS = "the product of two vectors is ambiguous";
    INNER_OR_CROSS = "use `inner(v, w)` for the scalar and `cross(v, w)` for the vector product";
    ROW_TIMES_MATRIX = "a vector is a column, on the right of its matrix: `A * v`, or `transpose(A) * v`";
    PRODUCT_HELP = "a matrix needs as many columns as the right operand has rows; `transpose(A)` exchanges them";
    DIVISION_BY_VECTOR = "cannot divide by a vector or a matrix";
    no_cross(count) = "`cross` is defined for vectors of 2 or 3 components, but these have {count}";
    CROSS_HELP = "take the cross product of vectors in the plane or in space; `inner(v, w)` takes any length";
    matrix_needed(function, found) = "the argument of `{function}` must be a matrix, but this is {found}";
    MATRIX_HELP = "write a matrix by rows, such as `((a, b), (c, d))`; a vector needs no transpose, `inner(v, w)`";
    rows_differ(first, other) = "the rows of a matrix must have equal lengths, but this is {other} and another row is {first}";
    ROWS_HELP = "write a matrix by rows with the same number of entries each, such as `((a, b), (c, d))`";
    no_entry(indices, found) = "there is no entry `{indices}` in {found}";
    shape_needed(wanted, found) = "{wanted} is needed here, but this is {found}";
    SHAPE_HELP = "the name on the left is a whole array; give it a value of its shape, or write an index behind it";
    matrix_output(found) = "an output is a scalar or a vector, but this is {found}";
    MATRIX_OUTPUT_HELP = "write one output for each row, such as `output row = A[0];`";
    DIVISION_BY_ZERO = "division by zero";

    FUNCTION_HELP = "write its arguments in parentheses after it";
    TUPLE_SIZE_HELP =
        "write as many names as there are components or rows, `let (a, b) = (e, f);`, or a single one, `let v = (e, f);`";
    ZERO_BASE_HELP = "a negative power of zero is undefined";
    DIVISION_HELP = "this divisor is zero for all values of the parameters";

    NUMBER_TOO_LONG = "the numbers in this expression become too long to remain exact";
    NUMBER_TOO_LONG_HELP = "round a constant before using it repeatedly";
    varying_power_of_negative(base) =
        "a power of the negative number {base} is real only for integer exponents, and this exponent may have other values";
    NEGATIVE_BASE_HELP =
        "make the base positive; the sign in `-2^x` applies to the power, that in `(-2)^x` to the base";

    NOT_REAL = "this is not a real number";
    defined_where(function, domain) = "`{function}` is defined {domain}";
    VANISHING_HELP = "choose smaller units, or remove it";
    no_component(component, kind) = "there is no component `{component}` in {kind}";
    TRANSPOSE_HELP = "write `transpose(A)`";
    COMPONENTS = "vectors have the components `x`, `y` and, in space, `z`; others have indices, `v[3]`";
    rate_of_input(name) = "the rate of input `{name}` is unknown";

    /// Message for the rate of an expression of numbers, parameters and discrete states.
    rate_of_constant(what) = "`{what}` does not change continuously, so its rate is zero";
    RATE_OF_CONSTANT_HELP =
        "remove the rate, declare the quantity as a `coord`, or write it as a function of `t`; the scalar product is `inner(v, w)`";

    RATE_OF_FORCE_HELP = "remove the rate: forces follow from the motion, not from a separate equation";
    rate_of_force(name) = "the rate of the force `{name}` is unknown";
    RATE_OF_INPUT_HELP =
        "an input may change at any time; make its rate another `input`, or the quantity a `coord`";

    NO_VELOCITY = "this is not a velocity: it is not a sum of rates";
    NO_VELOCITY_HELP =
        "a force works along a velocity such as `dot(x)` or `dot(x) - r * dot(phi)`; at a point, write `force F at P;`";
    PLACE_HELP = "places and angles are functions of the coordinates and of time";
    POTENTIAL_HELP = "put terms with velocities into `kinetic`, `lagrangian` or `dissipation`";
    ONLY_OUTPUTS_HOLD_ACCELERATIONS =
        "`ddot` is accepted in outputs, events and Gibbs functions; the force of a constraint, contact or friction, in outputs";
    input_in_kinetic(name) =
        "the rate of input `{name}` is needed here but unknown: it multiplies a velocity";
    not_constant(what) = "{what} cannot depend on this";
    NOT_CONSTANT_HELP =
        "compute it from numbers, `pi` and `const` names only; a `let` may depend on anything";
    both_lagrangian_and(other) = "`{other}` cannot be combined with `lagrangian`";
    LAGRANGIAN_HELP = "L = T - V: give either `lagrangian`, or `kinetic` and `potential`";
    LAGRANGIAN_IS_HERE = "the Lagrangian is given here";
    NO_COORDINATES = "a system needs at least one generalised coordinate";
    COORDINATES_HELP = "declare them with `coord x, theta;`";
    NO_ENERGY = "a system needs a kinetic energy or a Lagrangian";
    ENERGY_HELP = "write `kinetic = …;` and `potential = …;`, or `lagrangian = …;`";
    no_inertia(name) =
        "`{name}` has no inertia: the kinetic energy does not grow with its velocity, so nothing determines its acceleration";
    NOT_SQUARED_HELP = "a kinetic energy takes the square of the velocity, as in `1/2 * m * dot(x)^2`";
    NO_INERTIA_HELP = "add its kinetic energy, or make it a `param` or an `input`";

    NEGATIVE_INERTIA = "this mass or moment of inertia is negative";
    negative_kinetic_energy(name) =
        "this kinetic energy decreases as `{name}` moves faster, but inertia is positive";
    negative_by_default(name) =
        "with the defaults, this kinetic energy decreases as `{name}` moves faster";
    negative_dissipation(name) =
        "with the defaults, this dissipation speeds `{name}` up instead of slowing it down";
    NEGATIVE_DISSIPATION_HELP =
        "the force is -∂R/∂v of R: a damper has `dissipation = 1/2 * c * dot(x)^2;` with a positive c";
    NEGATIVE_INERTIA_HELP =
        "check the sign; a Lagrangian that is not T − V can be given as `lagrangian = …;`";

    MOMENTA_JUMP =
        "energies need second derivatives with respect to velocities, but here a momentum jumps where this changes its branch";

    MOMENTA_JUMP_HELP =
        "write an even power, such as `1/2*m*norm(v)^2`, or a `force`, `dissipation` or `friction` for a resistance to motion";

    GIBBS_WITHOUT_ACCELERATIONS = "this Gibbs function does not depend on accelerations";
    GIBBS_OF_HIGH_DEGREE = "a Gibbs function must be a polynomial of degree two in the accelerations";
    GIBBS_HELP = "add up ½ m |a|² of all masses m, with accelerations such as `ddot(x)`";
    not_a_coordinate(name) = "`{name}` is not a coordinate";
    FORCE_HELP = "`force x = …;` acts on a coordinate; `force (fx, fy) at (px, py);` acts at a point";
    reserved_output(name) =
        "an output cannot be called `{name}`, since the system already has a member of that name";
    OTHER_NAME_HELP = "choose another name";
    velocity_field_collides(name, coordinate) =
        "`{name}` collides with the name of the velocity of `{coordinate}`";
    coordinate_is_here(name) = "the velocity of this coordinate is called `{name}_dot`";
    unknown_product(name) = "`{name}` cannot be emitted";
    needs_separate_energies(name) = "`{name}` is not defined for a system given by its `lagrangian`";
    needs_constraints(name) = "`{name}` is not defined for a system without constraints";
    needs_events(name) = "`{name}` is not defined for a system without events";
    EVENT_HELP = "write `event name = e, falling => record;` for a zero of e";
    EVENT_OF_JUMPS_HELP = "remove it, or the accelerations and multipliers from the functions of events";
    CONSTRAINT_HELP = "write `constraint name = e;` for e = 0";
    needed_product(name) = "`{name}` cannot be left out here";
    needed_product_help(name, reason) = "remove `no {name}`: {reason}";
    NEEDED_BY_MOMENTUM_RATES = "methods that use `momentum_rates` compute velocities with it";
    NEEDED_BY_PROJECTION = "it projects states back onto the constraints";
    derivative_of_jumps(name) =
        "`{name}` does not exist for a system with rigid contacts or dry friction: its accelerations jump";
    DISCRETE_LINEAR_MODEL = "`system_matrix` cannot be combined with discrete states or clocks";
    HESSIAN_OF_ORIENTATION = "`lagrangian_hessian` cannot be combined with orientations by unit quaternions";
    HESSIAN_OF_ORIENTATION_HELP =
        "describe the orientation by angles, or take the derivatives of motions from `tangent_jacobian`";
    CORIOLIS_OF_MOVING_INERTIA =
        "`coriolis_matrix` does not exist for a system whose mass matrix depends on velocities";
    CORIOLIS_OF_MOVING_INERTIA_HELP =
        "take the vector of these terms from `bias`, or their derivatives from `jacobian`";
    DISCRETE_IS_HERE = "this changes discontinuously";
    DISCRETE_LINEAR_MODEL_HELP =
        "declare a `param` for what stays, or an `input` for what a sampled controller sets";
    DERIVATIVE_OF_JUMPS_HELP = "remove it; implicit methods iterate without it";
    acts_here(name) = "`{name}` acts only in some modes";
    tuple_size(names, found) = "{names} names for {found}";
    DERIVED_DEFAULT = "`Default` is implemented by `system!` from the declared defaults";
    DERIVED_DEFAULT_HELP = "remove `Default` from the `derive`";

    UNDERIVABLE_HELP =
        "derive `PartialEq` and `PartialOrd` only; as a key use the bits of a number, `to_bits()`";
    number_too_large(name, scalar) = "the default of `{name}` is too large for `{scalar}`";
    number_too_small(name, scalar) =
        "the default of `{name}` is too small for `{scalar}`, where it would lose digits";
    constrains_nothing(name) = "the constraint `{name}` does not depend on any coordinate";
    impossible_constraint(name, value) =
        "the constraint `{name}` cannot be satisfied: it does not depend on any coordinate and is {value}, not 0";
    CONSTRAINS_NOTHING_HELP = "write a function of coordinates or velocities that is to be zero";
    nonlinear_constraint(name) = "the constraint `{name}` is not linear in the velocities";
    NONLINEAR_CONSTRAINT_HELP =
        "constraints are functions of coordinates and time, or sums of velocities times such functions";
    repeated_constraint(name, other) =
        "the constraint `{name}` repeats `{other}`, so nothing determines its multiplier";
    contradicting_constraint(name, other) =
        "the constraint `{name}` contradicts `{other}`: no motion satisfies both";

    /// Message for two constraints whose difference depends on parameters.
    nearly_repeated(name, other, difference) =
        "the constraint `{name}` contradicts `{other}`, or repeats it where `{difference}` is zero";
    CONTRADICTING_HELP = "remove one of them, or make them one constraint with the right value";
    REPEATED_CONSTRAINT_HELP = "remove one of them";
    OTHER_CONSTRAINT_IS_HERE = "the other one is here";
    no_place(what) = "{what} must be made of coordinates and time";
    REPEATED_JOINT = "this joint repeats another constraint";
    FORCE_OF_IMPLIED = "this joint has no separate force, since the coordinates already satisfy it";
    FORCE_OF_IMPLIED_HELP =
        "add coordinates that can violate the joint: the multiplier of its constraint is then the force";

    REDUCED_CONSTRAINTS = "a system with constraints cannot be reduced yet";
    REDUCED_CONSTRAINTS_HELP =
        "remove the `reduce`, or choose coordinates that satisfy the constraint identically";
    CONSTRAINT_IS_HERE = "a constraint is here";
    reduced_quaternion(name) =
        "`{name}` is a component of a unit quaternion, which has no meaning without the others";
    REDUCED_QUATERNION_HELP = "describe a frozen or small orientation by angles, as three revolute joints";

    IGNORED_QUATERNION_HELP = "describe an orientation by angles, of which one may be cyclic";
    REDUCTION_HELP = "`freeze`, `small` and `ignore` take coordinates: `freeze x = 0; small theta;`";
    ALL_FROZEN = "every coordinate is frozen, so nothing can move";
    ALL_FROZEN_HELP = "leave at least one coordinate free, or make it `small`";
    ALL_IGNORED = "all coordinates are ignored";
    ALL_IGNORED_HELP = "keep at least one coordinate; if all are ignored, their rates depend only on time";
    PINNED_VALUE = "the value of a coordinate that is frozen or small";
    CONSTANT_IN_MOTION_HELP =
        "compute it from numbers, `pi`, `const` names and parameters, which do not change during the motion";
    TYPE_NAME_HELP =
        "each declared type `Name` comes with `NameState`, `NameColumns`, `NameInputs`, `NamePrepared` and `NameLanes`: choose a different name";
    reduced_twice(name) = "`{name}` is named twice in this reduction";
    NAMED_TWICE_HELP = "remove one of them";
    NAMED_HERE = "first named here";
    type_name_taken(name) = "the type name `{name}` is already taken";
    TYPE_NAMED_HERE = "by this declaration";

    NO_EXPANSION_HELP =
        "it is not defined there or has a kink there: a coordinate can be small only where energies and forces are smooth";
    undefined_when_frozen(part) = "{part} is not defined with this coordinate at this value";
    UNDEFINED_HELP = "it divides by zero there, for example; freeze the coordinate at another value";
    output_of_reduced(name) =
        "beside `reduce`, an output cannot be called `{name}`, since reduced types have a method of that name";
    momentum_taken(name) = "the reduced type has a parameter `{name}`, but this name is taken";
    NEEDED_BY_IGNORED = "a reduced type with ignored coordinates takes their momenta from it";
    ignored_in_energy(name) = "`{name}` cannot be ignored: the Lagrangian depends on it";
    DEPENDS_HERE = "this term depends on it";
    NOT_CYCLIC_HELP =
        "only the momentum of a cyclic coordinate is constant: choose coordinates in which it is cyclic, or keep it";
    ignored_with_force(name) = "`{name}` cannot be ignored: a force acts on it";
    FORCED_HERE = "this force";
    IGNORED_FORCE_HELP = "the force changes its momentum; keep the coordinate";
    ignored_with_dissipation(name) = "`{name}` cannot be ignored: dissipation acts on it";
    DISSIPATED_HERE = "its velocity occurs here";
    IGNORED_DISSIPATION_HELP = "dissipation changes its momentum; keep the coordinate";
    ignored_nonlinear(name) = "`{name}` cannot be ignored: its momentum is not linear in velocities";
    IGNORED_NONLINEAR_HELP = "the kinetic energy must be quadratic in the velocities for that";
    ignored_undetermined(name) =
        "`{name}` cannot be ignored: its velocity does not follow from the momenta of ignored coordinates";
    IGNORED_UNDETERMINED_HELP = "keep it, or one of the others that it moves with";
    ignored_undefined(name) = "`{name}` cannot be ignored: the Lagrangian is not defined where it is 0";
    IGNORED_UNDEFINED_HELP = "choose the coordinate, or the values of those that are frozen, differently";
    inertia_lost(coordinate) = "`{coordinate}` has no inertia in this reduced system";
    INERTIA_LOST_HELP =
        "its kinetic energy vanishes with the frozen coordinates, or is of higher than second order in the small ones";
}

/// Returns advice for invalid indices.
pub(super) fn indices_of(shape: ArrayShape) -> String {
    match shape {
        ArrayShape::Scalar => "remove the indices: this is a single number".to_owned(),
        ArrayShape::Vector(count) => format!("write one index, from 0 to {}", count.saturating_sub(1)),
        ArrayShape::Matrix([rows, columns]) => format!(
            "write a row from 0 to {} and a column from 0 to {}, `A[0][0]`, or a row alone",
            rows.saturating_sub(1),
            columns.saturating_sub(1)
        ),
    }
}

pub(super) fn root_of_negative(base: &str, exponent: &str) -> String {
    let exponent = if exponent.contains(['/', '-']) { format!("({exponent})") } else { exponent.to_owned() };
    format!("({base})^{exponent} is not a real number")
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

/// Returns the message for a forbidden dependence. `name` is the name of the culprit, if it has
/// one.
pub(super) fn must_not_depend(place: &str, kind: Dependencies, name: &str) -> String {
    let culprit = match kind {
        Dependencies::VELOCITY => "velocities".to_owned(),
        Dependencies::STATE => format!("the state `{name}`"),
        Dependencies::DISCRETE => format!("the discrete state `{name}`"),
        Dependencies::MULTIPLIER => format!("the multiplier `{name}`"),
        Dependencies::REACTION => format!("the force `{name}`"),
        _ => "accelerations".to_owned(),
    };
    format!("{place} must not depend on {culprit}")
}

/// Maximum length of helpful lists.
const MAX_LISTED: usize = 10;

pub(super) fn coordinates_are(names: &[&str], usage: &str) -> String {
    match names {
        [] => COORDINATES_HELP.to_owned(),
        [name] => format!("the coordinate is `{name}`"),
        _ if names.len() > MAX_LISTED => usage.to_owned(),
        _ => format!("the coordinates are `{}`", names.join("`, `")),
    }
}

pub(super) fn products() -> String {
    let names = Product::ALL.map(|product| format!("`{}`", product.name()));
    format!("the options are {}; write `no` before one to omit it", names.join(", "))
}

/// Returns the message for traits that types with such fields cannot implement.
pub(super) fn underivable(names: &[&str], scalar: &str) -> String {
    let names = names.join("`, `");
    format!(
        "`{names}` cannot be derived: parameters and inputs are fields of type `{scalar}`, which is not `Eq`, since NaN differs from itself"
    )
}

pub(super) fn no_expansion(part: &str, coordinate: Option<&str>) -> String {
    match coordinate {
        Some(name) => format!("{part} has no second-order expansion about this value of `{name}`"),
        None => format!("{part} has no second-order expansion about these values"),
    }
}

pub(super) fn largest_help(scalar: &str, largest: f64) -> String {
    format!("`{scalar}` holds numbers up to about {largest:.1e}: choose larger units")
}
