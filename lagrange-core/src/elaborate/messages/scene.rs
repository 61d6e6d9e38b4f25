//! Diagnostics for rigid bodies.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    needs_bodies(name) = "`{name}` is not defined for a system without rigid bodies";
    BODY_HELP = "declare one: `body name { … }`";

    /// Description of the dimensions of drawn solids.
    DIMENSION = "a dimension of a solid";
    only_in_space(product) = "`{product}` is for bodies and frames in space, but these move in the plane";
    IN_THE_PLANE_HELP = "`emit { motion }` gives the positions and velocities of bodies in the plane";
    not_in_the_plane(body) =
        "positions of `{body}` need two components; its mass, moment of inertia and angle need one";
    PLANE_HELP = "write positions as `(x, y)`, and mass, moment of inertia and angle as numbers";
    place_with_velocities(name) = "the frame of `{name}` must not depend on velocities";
    PLACE_WITH_VELOCITIES_HELP =
        "write its position and angles without velocities, or emit neither `frames` nor `frame_jacobians`";
    reserved_body(what, name, method) =
        "{what} cannot be called `{name}` here, since the system already has a method `{method}`";
}
