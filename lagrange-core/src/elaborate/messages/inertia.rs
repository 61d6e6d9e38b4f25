//! Diagnostics for mass geometry: calls of its functions, and obligations about masses and moments of inertia.

pub(in crate::elaborate) fn too_few_arguments(name: &str, least: usize, found: usize) -> String {
    let given = match found {
        0 => "none is given".to_owned(),
        1 => "only 1 is given".to_owned(),
        _ => format!("only {found} are given"),
    };
    format!("`{name}` takes at least {least} arguments, but {given}")
}

pub(in crate::elaborate) fn vector_needed(what: &str, dimension: usize, found: &str) -> String {
    format!("{what} must be a vector of {dimension} components, but this is {found}")
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

pub(in crate::elaborate) const TENSOR_HELP: &str = "about the centre of mass no principal moment exceeds the sum of the other two; products are the entries of the matrix, xy = -∫ x y dm";

pub(in crate::elaborate) fn no_such_solid(usage: &str) -> String {
    format!("`{usage}` cannot have these dimensions")
}

pub(in crate::elaborate) fn mass_not_positive(body: &str, value: &str, is_constant: bool) -> String {
    let condition = if is_constant { "" } else { WITH_DEFAULTS };
    format!("{condition}the mass of `{body}` is {value}, but masses are positive")
}

pub(in crate::elaborate) fn inertia_negative(body: &str, value: &str, is_constant: bool) -> String {
    let condition = if is_constant { "" } else { WITH_DEFAULTS };
    format!("{condition}the moment of inertia of `{body}` is {value}, but must not be negative")
}

pub(in crate::elaborate) fn not_fixed(what: &str) -> String {
    format!("{what} must not change during the motion")
}

pub(in crate::elaborate) const GRAVITY_NOT_UNIFORM: &str =
    "`gravity` must not depend on coordinates: it is the same everywhere";
pub(in crate::elaborate) const FREE_OF_MOTION_HELP: &str =
    "where energies depend on the motion in another way, write them yourself with `kinetic` and `potential`";

pub(in crate::elaborate) const HOLES_LIE_WITHIN: &str =
    "this moment is about the centre of mass; holes of a `compound` lie within the other parts";

pub(in crate::elaborate) const HOLES_BELONG_IN_A_COMPOUND: &str = "where mass is missing, write `compound { …; hole disk(r), mass: m, at: (X, Y); }`, where m is positive and less than the mass of the other parts";

/// `condition` says for which values of symbols the numbers hold.
pub(in crate::elaborate) fn other_inertia(body: &str, stated: f64, of_shape: f64, condition: &str) -> String {
    format!(
        "{condition}the stated moment of inertia of `{body}` is {stated}, but that of its shape is {of_shape}"
    )
}

pub(in crate::elaborate) const WITH_DEFAULTS: &str = "with the defaults of the parameters ";

/// `for m = 2, r = 3 `
pub(in crate::elaborate) fn for_values(values: &[(String, f64)]) -> String {
    let values = values.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>();
    format!("for {} ", values.join(", "))
}

pub(in crate::elaborate) const SHAPE_IS_HERE: &str = "the shape is given here";
pub(in crate::elaborate) const OTHER_INERTIA_HELP: &str = "remove `inertia` to use that of the shape, about the centre of mass; if the mass is unevenly distributed, `#[allow(deprecated)]` on the struct silences this warning";

pub(in crate::elaborate) const PLANE_VECTOR_HELP: &str = "write its two components: `(x, y)`";

pub(in crate::elaborate) fn body_stands_still(name: &str) -> String {
    format!("body `{name}` cannot move: neither its position nor its angle depends on a coordinate")
}

pub(in crate::elaborate) const BODY_STANDS_STILL_HELP: &str = "write its centre with coordinates: `coord x, y;` and `center: (x, y);`; anything at rest needs no body, for example a `line`";
