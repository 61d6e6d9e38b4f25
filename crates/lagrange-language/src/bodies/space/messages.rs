//! Diagnostics for bodies and joints in space.

use super::solids::SOLIDS_IN_SPACE;

pub(super) const JOINT_PLACES_HELP: &str = "a joint places it, `revolute q = ground to name { at: (x, y, z); }`, or write where it is: `origin: (x, y, z); angles: (a, b, c); sequence: zyx;`";
pub(super) const AXIS_HELP: &str = "write a vector that is not zero, such as `axis: (0, 0, 1);`";
pub(super) const PITCH_MISSING: &str = "this screw has no pitch";
pub(super) const PITCH_HELP: &str = "write how far it advances in a turn, `pitch: p;`";
pub(super) const ANGLES_HELP: &str =
    "in space an orientation takes three angles: `angles: (psi, theta, phi); sequence: zxz;`";
pub(super) const CENTER_HELP: &str =
    "write `origin: (x, y, z);` or `center: (x, y, z);`, or let a joint place the body";
pub(super) const TENSOR_NEEDED_HELP: &str = "give it a tensor about its centre of mass, `inertia: (xx, yy, zz, xy, xz, yz);`, principal moments, `inertia: (xx, yy, zz);`, or a shape, `shape: cuboid(a, b, c);`";

pub(super) const PITCH: &str = "the pitch of a screw";

pub(super) fn no_link(name: &str, found: Option<&str>) -> String {
    match found {
        Some(found) => format!("`{name}` is {found}, but joints connect bodies and frames"),
        None => format!("unknown body or frame `{name}`"),
    }
}

pub(super) const DECLARE_LINK_HELP: &str =
    "declare it first: `body name { mass: m; inertia: (xx, yy, zz); }` or `frame name;`";

pub(super) fn one_angle(name: &str) -> String {
    format!("body `{name}` moves in space, where one angle does not define an orientation")
}

pub(super) fn angles_without_sequence(name: &str) -> String {
    format!("the angles of `{name}` need the axes of their rotations")
}

pub(super) fn sequence_without_angles(name: &str) -> String {
    format!("the sequence of `{name}` needs angles")
}

pub(super) fn no_tensor(name: &str) -> String {
    format!("body `{name}` has no tensor of inertia")
}

pub(super) fn angles_of(name: &str) -> String {
    format!("the angles of `{name}`")
}

pub(super) const GRAVITY: &str = "gravity";

pub(super) fn tensor_of(name: &str) -> String {
    format!("the tensor of inertia of `{name}`")
}

pub(super) fn usage(function: &str) -> String {
    let arguments = match function {
        "point" | "vector" => "X, Y, Z",
        "angular_momentum" => "P",
        _ => "",
    };
    format!("write `name.{function}({arguments})`")
}

pub(super) fn no_function(function: &str) -> String {
    format!("`{function}` is only defined for bodies in the plane")
}

pub(super) fn mass_of_frame(name: &str) -> String {
    format!("`{name}` is a frame and has no mass")
}

pub(super) fn solids_are() -> String {
    let names = SOLIDS_IN_SPACE.iter().map(|solid| format!("`{}`", solid.usage())).collect::<Vec<_>>();
    format!("shapes in space are {}", names.join(", "))
}

pub(super) const PART_ANGLE: &str = "a part of a compound in space has no single angle";

pub(super) const PART_ANGLE_HELP: &str = "write `turned: (roll, pitch, yaw)`";
pub(super) const ORIENTATION_OF_PART: &str = "the orientation of a part";
pub(super) const FORCE: &str = "a force at a point of a body in space";
pub(super) const TORQUE: &str = "a torque on a body in space";
pub(super) const FRAME_HELP: &str = "declare a body instead: `body name { mass: m; inertia: (xx, yy, zz); }`";
pub(super) const FUNCTIONS_HELP: &str = "in space there are `point`, `vector`, `angular_velocity`, `angular_acceleration`, `linear_momentum` and `angular_momentum`";
