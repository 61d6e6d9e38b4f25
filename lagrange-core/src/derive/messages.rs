//! Diagnostics for models without equations of motion.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    SINGULAR_MASS_MATRIX =
        "the mass matrix is singular: the kinetic energy leaves some motion of the coordinates without inertia";
    SINGULAR_HELP = "add the missing kinetic energy, or describe the motion with fewer coordinates";
    NO_INVERSE =
        "`inverse_mass_matrix` does not exist: only constraints give some motion of the coordinates an inertia";
    NO_INVERSE_HELP =
        "add the missing kinetic energy, or take responses to forces from `acceleration`, with an `input` as the force";
}

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
