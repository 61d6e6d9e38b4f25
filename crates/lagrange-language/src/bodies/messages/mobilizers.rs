//! Diagnostics for joints with coordinates, in the plane and in space.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::bodies):

    CLOSE_LOOP_HELP =
        "joints form trees: close a loop by `pin P to Q;` between points of two bodies, or by a `constraint`";
    AXIS_ZERO = "this axis has no direction";
    GROUND_IS_AT_REST = "the ground is at rest, so no joint can place it";
    LEADS_OUT_HELP = "vectors of three components make a scene spatial, such as `gravity = (0, 0, -g);`";
    PLACE_FIRST_HELP = "write the joint that places it before this statement";
    PLACED_HERE = "it is placed here";
    AXIS_IN_THE_PLANE = "bodies in the plane rotate about its normal";
    AXIS_IN_THE_PLANE_HELP = "write a vector that is not zero, such as `axis: (1, 0);`";
    at_of(joint) = "the position of this {joint} joint";
    turned_of(joint) = "the orientation of this {joint} joint";
    axis_of(joint) = "the axis of this {joint} joint";
    unplaced(what, name) = "{what} `{name}` has no position";
    unplaced_yet(name) = "`{name}` has no position yet";
    placed_twice(name) = "`{name}` already has a position";
    joined_to_itself(name) = "this joint connects `{name}` with itself";
    FRAME_PLACE_HELP = "a joint places it: `weld arm to name { at: (x, y); }`";
}
