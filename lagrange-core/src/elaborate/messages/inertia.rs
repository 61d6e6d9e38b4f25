//! Diagnostics for mass geometry: function calls, and obligations on masses and moments of inertia.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    vector_needed(what, dimension, found) =
        "{what} must be a vector of {dimension} components, but this is {found}";
    TENSOR_HELP =
        "about the centre of mass, no principal moment exceeds the sum of the others; products are matrix entries, xy = -∫ x y dm";
    no_such_solid(usage) = "`{usage}` cannot have these dimensions";
    not_fixed(what) = "{what} must not change during the motion";
    moving_matter(what) = "{what} must not depend on coordinates or velocities";
    MOVING_MATTER_HELP =
        "make it a `state`, whose rate may depend on the motion: `state m = 1; dot(m) = -c * dot(x);`";
    matter_of_input(what) = "{what} must not depend on inputs or delayed values, since their rates are unknown";
    MATTER_OF_INPUT_HELP =
        "make it a `state` with the rate as an input, `dot(m) = u;`, or a `discrete` state that events assign";
    inertia_alone(body) = "the moment of inertia of `{body}` changes without its mass";
    INERTIA_ALONE_HELP =
        "what moves within a body exerts forces on it: declare it as a body of its own, or write `kinetic` instead";
    regressor_of_changing_mass(body) = "`regressor` needs constant parameters, but the mass of `{body}` changes";
    REGRESSOR_OF_CHANGING_MASS_HELP = "use `inverse_dynamics`, which depends on the mass at each instant";
    BODY_IS_HERE = "the body is declared here";
    GRAVITY_NOT_UNIFORM = "`gravity` must not depend on coordinates: it is the same everywhere";
    FREE_OF_MOTION_HELP =
        "where energies depend on the motion in another way, write them yourself with `kinetic` and `potential`";

    HOLES_LIE_WITHIN =
        "this moment is about the centre of mass; holes of a `compound` lie within the other parts";

    HOLES_BELONG_IN_A_COMPOUND =
        "where mass is missing, write `compound { …; hole disk(r), mass: m, at: (X, Y); }`, where m is positive and less than the mass of the other parts";

    /// `condition` gives the values of symbols for which the numbers hold.
    other_inertia(body, stated, of_shape, condition) =
        "{condition}the stated moment of inertia of `{body}` is {stated}, but that of its shape is {of_shape}";
    WITH_DEFAULTS = "with the defaults of the parameters ";

    SHAPE_IS_HERE = "the shape is given here";
    OTHER_INERTIA_HELP =
        "remove `inertia` to use that of the shape; if the mass is unevenly distributed, `#[allow(deprecated)]` on the struct silences this warning";

    PLANE_VECTOR_HELP = "write its two components: `(x, y)`";
    body_stands_still(name) =
        "body `{name}` cannot move: neither its position nor its angle depends on a coordinate";
    BODY_STANDS_STILL_HELP =
        "write its centre with coordinates: `coord x, y;` and `center: (x, y);`; anything at rest needs no body, for example a `line`";
}

pub(in crate::elaborate) fn too_few_arguments(name: &str, least: usize, found: usize) -> String {
    let given = match found {
        0 => "none is given".to_owned(),
        1 => "only 1 is given".to_owned(),
        _ => format!("only {found} are given"),
    };
    format!("`{name}` takes at least {least} arguments, but {given}")
}

pub(in crate::elaborate) fn vector_help(dimension: usize) -> &'static str {
    match dimension {
        2 => PLANE_VECTOR_HELP,
        _ => "write its three components: `(x, y, z)`",
    }
}

pub(in crate::elaborate) fn tensor_impossible(body: &str, is_certain: bool) -> String {
    let when = if is_certain { "" } else { " with the defaults of its parameters" };
    format!("the moments and products of inertia of `{body}` are physically impossible{when}")
}

pub(in crate::elaborate) fn mass_not_positive(body: &str, value: &str, is_constant: bool) -> String {
    let condition = if is_constant { "" } else { WITH_DEFAULTS };
    format!("{condition}the mass of `{body}` is {value}, but masses are positive")
}

pub(in crate::elaborate) fn inertia_negative(body: &str, value: &str, is_constant: bool) -> String {
    let condition = if is_constant { "" } else { WITH_DEFAULTS };
    format!("{condition}the moment of inertia of `{body}` is {value}, but must not be negative")
}

/// Writes `for m = 2, r = 3 `.
pub(in crate::elaborate) fn for_values(values: &[(String, f64)]) -> String {
    let values = values.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>();
    format!("for {} ", values.join(", "))
}
