//! Diagnostics for joints with coordinates of their own, in the plane and in space.

pub(in crate::bodies) const CLOSE_LOOP_HELP: &str =
    "joints form trees: close a loop by `pin P to Q;` between points of two bodies, or by a `constraint`";
pub(in crate::bodies) const AXIS_ZERO: &str = "this axis has no direction";
pub(in crate::bodies) const GROUND_IS_AT_REST: &str = "the ground is at rest, so no joint can place it";
pub(in crate::bodies) const LEADS_OUT_HELP: &str =
    "vectors of three components make a scene spatial, such as `gravity = (0, 0, -g);`";
pub(in crate::bodies) const PLACE_FIRST_HELP: &str = "write the joint that places it before this statement";
pub(in crate::bodies) const PLACED_HERE: &str = "it is placed here";
pub(in crate::bodies) const AXIS_IN_THE_PLANE: &str = "bodies in the plane rotate about its normal";
pub(in crate::bodies) const AXIS_IN_THE_PLANE_HELP: &str =
    "write a vector that is not zero, such as `axis: (1, 0);`";

pub(in crate::bodies) fn at_of(joint: &str) -> String {
    format!("the position of this {joint} joint")
}

pub(in crate::bodies) fn turned_of(joint: &str) -> String {
    format!("the orientation of this {joint} joint")
}

pub(in crate::bodies) fn axis_of(joint: &str) -> String {
    format!("the axis of this {joint} joint")
}

pub(in crate::bodies) fn unplaced(what: &str, name: &str) -> String {
    format!("{what} `{name}` has no position")
}

pub(in crate::bodies) fn unplaced_yet(name: &str) -> String {
    format!("`{name}` has no position yet")
}

pub(in crate::bodies) fn placed_twice(name: &str) -> String {
    format!("`{name}` already has a position")
}

pub(in crate::bodies) fn joined_to_itself(name: &str) -> String {
    format!("this joint connects `{name}` with itself")
}

pub(in crate::bodies) const FRAME_PLACE_HELP: &str = "a joint places it: `weld arm to name { at: (x, y); }`";
