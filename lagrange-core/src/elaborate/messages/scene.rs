//! Diagnostics for rigid bodies.

pub(in crate::elaborate) fn needs_bodies(name: &str) -> String {
    format!("`{name}` is not defined for a system without rigid bodies")
}

pub(in crate::elaborate) const BODY_HELP: &str = "declare one: `body name { … }`";

/// Description of the dimensions of drawn solids.
pub(in crate::elaborate) const DIMENSION: &str = "a dimension of a solid";

pub(in crate::elaborate) fn only_in_space(product: &str) -> String {
    format!("`{product}` is for bodies and frames in space, but these move in the plane")
}

pub(in crate::elaborate) const IN_THE_PLANE_HELP: &str =
    "`emit { motion }` gives the positions and velocities of bodies in the plane";

pub(in crate::elaborate) fn not_in_the_plane(body: &str) -> String {
    format!("positions of `{body}` need two components; its mass, moment of inertia and angle need one")
}

pub(in crate::elaborate) const PLANE_HELP: &str =
    "write positions as `(x, y)`, and mass, moment of inertia and angle as numbers";

pub(in crate::elaborate) fn place_with_velocities(name: &str) -> String {
    format!("the frame of `{name}` must not depend on velocities")
}

pub(in crate::elaborate) const PLACE_WITH_VELOCITIES_HELP: &str =
    "write its position and angles without velocities, or emit neither `frames` nor `frame_jacobians`";

pub(in crate::elaborate) fn reserved_body(what: &str, name: &str, method: &str) -> String {
    format!("{what} cannot be called `{name}` here, since the system already has a method `{method}`")
}
