//! Diagnostics for models without equations of motion.

pub(super) const SINGULAR_MASS_MATRIX: &str =
    "the mass matrix is singular: the kinetic energy leaves some motion of the coordinates without inertia";

/// Returns the message, with the names of the coordinates if these are known.
pub(super) fn singular_mass_matrix(coordinates: &[&str]) -> String {
    match coordinates {
        [] => SINGULAR_MASS_MATRIX.to_owned(),
        [name] => format!("the mass matrix is singular: `{name}` can move without inertia"),
        names => {
            format!("the mass matrix is singular: `{}` can move together without inertia", names.join("`, `"))
        }
    }
}

pub(super) const SINGULAR_HELP: &str =
    "add the missing kinetic energy, or describe the motion with fewer coordinates";

pub(super) const NO_INVERSE: &str =
    "`inverse_mass_matrix` does not exist: only constraints give some motion of the coordinates an inertia";

pub(super) const NO_INVERSE_HELP: &str = "add the missing kinetic energy, or take responses to forces from `acceleration`, with an `input` as the force";
