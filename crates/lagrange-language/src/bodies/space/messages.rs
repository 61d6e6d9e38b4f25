//! Diagnostics for bodies and joints in space.

use super::solids::SOLIDS_IN_SPACE;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    JOINT_PLACES_HELP =
        "a joint places it, `revolute q = ground to name { at: (x, y, z); }`, or write where it is: `origin: (x, y, z); angles: (a, b, c); sequence: zyx;`";
    AXIS_HELP = "write a vector that is not zero, such as `axis: (0, 0, 1);`";
    PITCH_MISSING = "this screw has no pitch";
    PITCH_HELP = "write how far it advances in a turn, `pitch: p;`";
    ANGLES_HELP = "in space an orientation takes three angles: `angles: (psi, theta, phi); sequence: zxz;`";
    CENTER_HELP = "write `origin: (x, y, z);` or `center: (x, y, z);`, or let a joint place the body";
    TENSOR_NEEDED_HELP =
        "give it a tensor about its centre of mass, `inertia: (xx, yy, zz, xy, xz, yz);`, principal moments, `inertia: (xx, yy, zz);`, or a shape, `shape: cuboid(a, b, c);`";

    PITCH = "the pitch of a screw";

    DECLARE_LINK_HELP = "declare it first: `body name { mass: m; inertia: (xx, yy, zz); }` or `frame name;`";
    one_angle(name) = "body `{name}` moves in space, where one angle does not define an orientation";
    angles_without_sequence(name) = "the angles of `{name}` need the axes of their rotations";
    sequence_without_angles(name) = "the sequence of `{name}` needs angles";
    no_tensor(name) = "body `{name}` has no tensor of inertia";
    angles_of(name) = "the angles of `{name}`";
    GRAVITY = "gravity";
    tensor_of(name) = "the tensor of inertia of `{name}`";
    no_function(function) = "`{function}` is only defined for bodies in the plane";
    mass_of_frame(name) = "`{name}` is a frame and has no mass";
    PART_ANGLE = "a part of a compound in space has no single angle";

    PART_ANGLE_HELP = "write `turned: (roll, pitch, yaw)`";
    ORIENTATION_OF_PART = "the orientation of a part";
    FORCE = "a force at a point of a body in space";
    TORQUE = "a torque on a body in space";
    FRAME_HELP = "declare a body instead: `body name { mass: m; inertia: (xx, yy, zz); }`";
    FUNCTIONS_HELP =
        "in space there are `point`, `vector`, `angular_velocity`, `angular_acceleration`, `linear_momentum` and `angular_momentum`";
}

pub(super) fn no_link(name: &str, found: Option<&str>) -> String {
    match found {
        Some(found) => format!("`{name}` is {found}, but joints connect bodies and frames"),
        None => format!("unknown body or frame `{name}`"),
    }
}

pub(super) fn usage(function: &str) -> String {
    let arguments = match function {
        "point" | "vector" => "X, Y, Z",
        "angular_momentum" => "P",
        _ => "",
    };
    format!("write `name.{function}({arguments})`")
}

pub(super) fn solids_are() -> String {
    let names = SOLIDS_IN_SPACE.iter().map(|solid| format!("`{}`", solid.usage())).collect::<Vec<_>>();
    format!("shapes in space are {}", names.join(", "))
}
