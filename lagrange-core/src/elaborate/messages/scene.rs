//! Diagnostics for rigid bodies.

pub(in crate::elaborate) fn needs_bodies(name: &str) -> String {
    format!("`{name}` is not defined for a system without rigid bodies")
}

pub(in crate::elaborate) const BODY_HELP: &str = "declare one: `body name { … }`";

pub(in crate::elaborate) fn not_in_the_plane(body: &str) -> String {
    format!("the places of `{body}` need two components, its mass, moment of inertia and angle one")
}

pub(in crate::elaborate) const PLANE_HELP: &str =
    "write places as `(x, y)`, and mass, moment of inertia and angle as numbers";

pub(in crate::elaborate) fn reserved_body(name: &str) -> String {
    format!("a body cannot be called `{name}` here, since the system has a method `{name}_motion` already")
}
