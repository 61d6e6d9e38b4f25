//! Wording of mistakes in URDF files.

use std::fmt::Display;

use crate::robot::KINDS;
use lagrange_core::diagnostics::messages;

messages! {
    pub(super):

    NOT_A_ROBOT = "this is not a <robot>";
    XACRO = "this is a xacro file, from which URDF is generated";
    XACRO_HELP = "run `xacro robot.urdf.xacro > robot.urdf` and import what it writes";
    NO_LINKS = "the robot has no links";
    TWICE = "this is repeated";
    EMPTY_NAME = "it has no name";
    UNKNOWN_ELEMENT = "this element is unknown and ignored";
    UNREADABLE_ELEMENT = "this element is unknown here, and ignoring it may change the motion";
    UNREADABLE_ELEMENT_HELP = "move it to where it belongs, or remove it";
    VERSION_HELP = "files of version 1.0, 1.1 and 1.2 can be imported";
    TURNED_TWICE = "`rpy` and `quat_xyzw` both state the orientation";
    TURNED_TWICE_HELP = "remove one of them";
    QUATERNION_ZERO = "the quaternion is zero";
    IDENTITY_HELP = "the identity is `quat_xyzw=\"0 0 0 1\"`";
    LOOP = "joints form a loop: every link is the child of one";
    TREE_HELP = "joints form a tree; close its loops by `pin P to Q;` in the declaration";
    AXIS_ZERO = "the axis is zero";
    NOTHING_MOVES = "nothing moves: there is no joint that moves a mass";
    NOTHING_MOVES_HELP = "with a free base (`--free`) it moves as one body";
    MASSLESS_INERTIA = "there is inertia without mass";
    MASSLESS_INERTIA_HELP = "give the link a mass; without <inertial> it is a frame, which has neither";
    IMPOSSIBLE_INERTIA = "these moments and products of inertia are physically impossible";
    IMPOSSIBLE_INERTIA_HELP =
        "about the centre of mass no principal moment exceeds the sum of the other two; `--trust-inertia` accepts them as parameters";
    FREE_BASE_HELP =
        "give the base or a link that is fixed to it an <inertial>, or import it without `--free`";
    WITHOUT_INERTIA_HELP =
        "give the link or one that is fixed to it an <inertial> with moments of inertia, or make its joint `fixed`";
    MASS_NOT_POSITIVE = "the mass is negative";
    MIMICS_ITSELF = "the joint mimics itself";
    MIMIC_CIRCLE = "the joint mimics one that mimics it, directly or through others";
    LIMITS_CROSSED = "the lower limit is above the upper one";
    NEGATIVE_DAMPING = "the damping is negative, so the motion would gain energy";
    DAMPING_LEFT_OUT = "the damping of a joint with several coordinates is ignored";
    NO_GEOMETRY = "there is no <box>, <cylinder>, <sphere> or <mesh>";
    HELD = "it moves no mass, so its motion is undetermined: its coordinate is held at zero";
    MIMIC_LEFT_OUT = "it has no coordinate, so its <mimic> is ignored";
    MIMICS_NONE = "the joint that it mimics has no coordinate";
    CONTINUOUS_LIMITS = "a continuous joint turns without end, so `lower` and `upper` are ignored";
    NO_RANGE = "its limits leave no range of motion, so no stops are added";
    NO_EFFORT = "its effort is not positive, so its input is not limited";
    NEGATIVE_FRICTION = "the dry friction is negative, so the motion would gain energy";
    FRICTION_LEFT_OUT = "the dry friction of a joint with several coordinates is ignored";
    BOX_LEFT_OUT = "its collision shape is a box, for which no contact is added";
    CYLINDER_LEFT_OUT = "its collision shape is a cylinder, for which no contact is added";
    LEFT_OUT_HELP = "`--corners LINK` makes contacts of the corners of its boxes and the rims of its cylinders";
    SHAPE_LEFT_OUT = "it collides as a mesh, which does not become a contact";
    SHAPE_LEFT_OUT_HELP = "declare points of it: `contact name = link.point(X, Y, Z) on ground { friction: mu; }`";
    NOTHING_TOUCHES = "no moving link has a sphere as its collision shape";
    LEVEL = "its collision shape stays at a constant height, so no contact is added";
    NO_CORNERS = "it has no moving collision box or cylinder, so there are no corners or rims for contacts";
    FEWER_EVENTS_HELP = "for other methods, import fewer limits, friction or contacts, or remove some from the file";
    MIMIC_HELP = "revolute, continuous and prismatic joints that move a mass have one";
    element(tag, name) = "{tag} {}", quoted(name);
    missing_element(tag) = "<{tag}> is missing";
    missing_attribute(attribute) = "the attribute `{attribute}` is missing";
    write(form) = "write `{form}`";
    no_number(attribute, text) = "`{attribute}` must be a number, but this is {}", quoted(text);
    unknown_attribute(name) = "the attribute `{}` is unknown and ignored", shortened(name);
    unreadable_attribute(name) =
        "the attribute `{}` is unknown, and ignoring it may change the motion", shortened(name);
    unknown_version(version) = "unknown URDF version {}", quoted(version);
    repeated(tag, line) = "this name already belongs to the {tag} in line {line}";
    unknown_link(role, name) = "unknown {role} link {}", quoted(name);
    many_events(count, most) =
        "its limits, friction and contacts are {count}, and with more than {most} the robot needs the method `Stepped`";
    unknown_cornered(name) = "unknown link {} of `--corners`", quoted(name);
    unknown_joint(name) = "unknown joint {} to mimic", quoted(name);
    in_loop(link) = "joints form a loop through link {}, away from the base", quoted(link);
    unknown_kind(kind) = "unknown joint type {}", quoted(kind);
    negative(attribute) = "`{attribute}` is negative";
    without_inertia(reason) = "it lacks mass or moments of inertia: {reason}";
    not_accepted(report) = "the imported declaration is rejected: {report}";
}

/// Maximum number of characters of a name or a number that a message quotes.
const MAX_QUOTED: usize = 60;

/// Returns text of the file in quotation marks: shortened, and with escapes for invisible
/// characters.
fn quoted(text: impl Display) -> String {
    format!("{:?}", shortened(text))
}

/// Returns the beginning of a text of the file.
pub(super) fn shortened(text: impl Display) -> String {
    let text = text.to_string();
    match text.char_indices().nth(MAX_QUOTED) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

pub(super) fn did_you_mean(name: &str) -> String {
    format!("did you mean `{}`?", name.escape_debug())
}

pub(super) fn wrong_count(attribute: &str, needed: usize, count: usize) -> String {
    let needed = if needed == 4 { "four" } else { "three" };
    format!("`{attribute}` must be {needed} numbers, but these are {count}")
}

pub(super) fn known_attributes(names: &[&str]) -> String {
    format!("remove it if it has no effect; the known attributes are {}", names.join(", "))
}

pub(super) fn foreign(prefix: Option<&str>) -> String {
    match prefix {
        Some(prefix) => {
            format!(
                "names with the prefix `{}:` belong to another program and are ignored",
                shortened(prefix)
            )
        }
        None => "this element belongs to another namespace and is ignored".to_owned(),
    }
}

pub(super) fn undeclared_prefix(prefix: &str) -> String {
    let prefix = shortened(prefix);
    format!("declare the prefix: `<robot xmlns:{prefix}=\"{prefix}\" …>`")
}

pub(super) fn two_parents(link: &str, joint: &str, line: u32) -> String {
    let (joint, link) = (quoted(joint), quoted(link));
    format!("joint {joint} in line {line} already places link {link}")
}

pub(super) fn two_roots(first: &str, line: u32) -> String {
    let first = quoted(first);
    format!("no joint places this link, nor link {first} in line {line}: only one can be the base")
}

pub(super) fn kinds_help(near: Option<&str>) -> String {
    match near {
        Some(near) => did_you_mean(near),
        None => format!("types are {}", KINDS.map(|(word, _)| word).join(", ")),
    }
}

pub(super) fn and_others(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => ", here and in one more place".to_owned(),
        _ => format!(", here and in {count} more places"),
    }
}
