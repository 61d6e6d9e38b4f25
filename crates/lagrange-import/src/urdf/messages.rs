//! Wording of mistakes in URDF files.

/// Characters of a name or a number of the file that a message repeats at most.
const MAX_QUOTED: usize = 60;

/// Text of the file in quotation marks: shortened, and with escapes for what cannot be seen.
fn quoted(text: &str) -> String {
    format!("{:?}", shortened(text))
}

/// The beginning of a text of the file.
pub(super) fn shortened(text: &str) -> String {
    match text.char_indices().nth(MAX_QUOTED) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

pub(super) const NOT_A_ROBOT: &str = "this is not a <robot>";
pub(super) const XACRO: &str = "this file is one for xacro, which makes URDF files";
pub(super) const XACRO_HELP: &str = "run `xacro robot.urdf.xacro > robot.urdf` and import what it writes";
pub(super) const NO_LINKS: &str = "the robot has no links";
pub(super) const TWICE: &str = "this is repeated";
pub(super) const EMPTY_NAME: &str = "it has no name";
pub(super) const UNKNOWN_ELEMENT: &str = "this element is unknown and ignored";
pub(super) const UNREADABLE_ELEMENT: &str =
    "this element is unknown here, and ignoring it may change the motion";
pub(super) const UNREADABLE_ELEMENT_HELP: &str = "move it to where it belongs, or remove it";
pub(super) const VERSION_HELP: &str = "files of version 1.0, 1.1 and 1.2 can be imported";
pub(super) const TURNED_TWICE: &str = "`rpy` and `quat_xyzw` both state the orientation";
pub(super) const TURNED_TWICE_HELP: &str = "remove one of them";
pub(super) const QUATERNION_ZERO: &str = "the quaternion is zero";
pub(super) const IDENTITY_HELP: &str = "the identity is `quat_xyzw=\"0 0 0 1\"`";
pub(super) const LOOP: &str = "joints form a loop: every link is the child of one";
pub(super) const TREE_HELP: &str = "joints form a tree; close its loops by `pin P to Q;` in the declaration";
pub(super) const AXIS_ZERO: &str = "the axis is zero";
pub(super) const NOTHING_MOVES: &str = "nothing moves: there is no joint that moves a mass";
pub(super) const NOTHING_MOVES_HELP: &str = "with a free base (`--free`) it moves as one body";
pub(super) const MASSLESS_INERTIA: &str = "there is inertia without mass";
pub(super) const MASSLESS_INERTIA_HELP: &str =
    "give the link a mass; without <inertial> it is a frame, which has neither";
pub(super) const IMPOSSIBLE_INERTIA: &str = "these moments and products of inertia are physically impossible";
pub(super) const IMPOSSIBLE_INERTIA_HELP: &str = "about the centre of mass no principal moment exceeds the sum of the other two; `--trust-inertia` accepts them as parameters";
pub(super) const FREE_BASE_HELP: &str =
    "give the base or a link that is fixed to it an <inertial>, or import it without `--free`";
pub(super) const WITHOUT_INERTIA_HELP: &str = "give the link or one that is fixed to it an <inertial> with moments of inertia, or make its joint `fixed`";
pub(super) const MASS_NOT_POSITIVE: &str = "the mass is negative";
pub(super) const MIMICS_ITSELF: &str = "the joint mimics itself";
pub(super) const MIMIC_CIRCLE: &str = "the joint mimics one that mimics it, directly or through others";
pub(super) const LIMITS_CROSSED: &str = "the lower limit is above the upper one";
pub(super) const NEGATIVE_DAMPING: &str = "the damping is negative, so the motion would gain energy";
pub(super) const DAMPING_LEFT_OUT: &str = "the damping of a joint with several coordinates is ignored";
pub(super) const NO_GEOMETRY: &str = "there is no <box>, <cylinder>, <sphere> or <mesh>";
pub(super) const HELD: &str =
    "it moves no mass, so its motion is undetermined: its coordinate is held at zero";
pub(super) const MIMIC_LEFT_OUT: &str = "it has no coordinate, so its <mimic> is ignored";
pub(super) const MIMICS_NONE: &str = "the joint that it mimics has no coordinate";
pub(super) const MIMIC_HELP: &str = "revolute, continuous and prismatic joints that move a mass have one";

pub(super) fn element(tag: &str, name: &str) -> String {
    format!("{tag} {}", quoted(name))
}

pub(super) fn missing_element(tag: &str) -> String {
    format!("<{tag}> is missing")
}

pub(super) fn missing_attribute(attribute: &str) -> String {
    format!("the attribute `{attribute}` is missing")
}

pub(super) fn write(form: &str) -> String {
    format!("write `{form}`")
}

pub(super) fn did_you_mean(name: &str) -> String {
    format!("did you mean `{}`?", name.escape_debug())
}

pub(super) fn no_number(attribute: &str, text: &str) -> String {
    format!("`{attribute}` must be a number, but this is {}", quoted(text))
}

pub(super) fn wrong_count(attribute: &str, needed: usize, count: usize) -> String {
    let needed = if needed == 4 { "four" } else { "three" };
    format!("`{attribute}` must be {needed} numbers, but these are {count}")
}

pub(super) fn unknown_attribute(name: &str) -> String {
    format!("the attribute `{}` is unknown and ignored", shortened(name))
}

pub(super) fn unreadable_attribute(name: &str) -> String {
    format!("the attribute `{}` is unknown, and ignoring it may change the motion", shortened(name))
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

pub(super) fn unknown_version(version: &str) -> String {
    format!("unknown URDF version {}", quoted(version))
}

pub(super) fn repeated(tag: &str, line: u32) -> String {
    format!("this name already belongs to the {tag} in line {line}")
}

pub(super) fn unknown_link(role: &str, name: &str) -> String {
    format!("unknown {role} link {}", quoted(name))
}

pub(super) fn unknown_joint(name: &str) -> String {
    format!("unknown joint {} to mimic", quoted(name))
}

pub(super) fn two_parents(link: &str, joint: &str, line: u32) -> String {
    let (joint, link) = (quoted(joint), quoted(link));
    format!("joint {joint} in line {line} already places link {link}")
}

pub(super) fn two_roots(first: &str, line: u32) -> String {
    let first = quoted(first);
    format!("no joint places this link, nor link {first} in line {line}: only one can be the base")
}

pub(super) fn in_loop(link: &str) -> String {
    format!("joints form a loop through link {}, away from the base", quoted(link))
}

pub(super) fn unknown_kind(kind: &str) -> String {
    format!("unknown joint type {}", quoted(kind))
}

pub(super) const KINDS: [&str; 6] = ["revolute", "continuous", "prismatic", "fixed", "floating", "planar"];

pub(super) fn kinds_help(near: Option<&str>) -> String {
    match near {
        Some(near) => did_you_mean(near),
        None => format!("types are {}", KINDS.join(", ")),
    }
}

pub(super) fn negative(attribute: &str) -> String {
    format!("`{attribute}` is negative")
}

pub(super) fn without_inertia(reason: &str) -> String {
    format!("it lacks mass or moments of inertia: {reason}")
}

pub(super) fn not_accepted(report: &str) -> String {
    format!("the imported declaration is rejected: {report}")
}

pub(super) fn and_others(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => ", here and in one more place".to_owned(),
        _ => format!(", here and in {count} more places"),
    }
}
