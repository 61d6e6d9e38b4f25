//! Diagnostics for statements about rigid bodies, with help.

use super::forms::form;
use super::quoted;
use crate::syntax::ast::MobilizerKind;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    COMPOUND_HELP = "write `compound { disk(r), mass: m; hole disk(s), mass: n, at: (a, b); }`";
    TENSOR_HELP =
        "write `inertia: (xx, yy, zz, xy, xz, yz);`, or `inertia: (xx, yy, zz);` with the principal moments";
    SEQUENCE_HELP =
        "write three of the letters x, y and z, such as `sequence: zxz;`, no letter twice in a row";
    SOLID_HELP = "write the name of a solid with its dimensions, such as `disk(r)` or `rectangle(a, b)`";
    VISUAL_HELP =
        "write `visual { disk(r), at: (a, b); }`, in space optionally with `turned: (roll, pitch, yaw)`";
    EMPTY_COMPOUND = "this body has no parts";
    LINE_HELP_END = "each line between the braces ends in `;`";
    NEXT_LABEL = "the next line begins here";

    /// Message for an unknown word before a colon; `owner` includes its article.
    unknown_label(label, owner) = "unknown label {} for {owner}", quoted(label);
    label(owner) = "a label of {owner}";
    MATRIX = "a tensor of inertia is not written as a matrix";
    MATRIX_HELP = "write its components, `inertia: (xx, yy, zz, xy, xz, yz);`, or principal moments, `inertia: (xx, yy, zz);`";

    /// Message for letters that are not a sequence of rotations.
    no_sequence(letters) = "{} is not a sequence of rotations", quoted(letters);

    AXIS_LETTER = "an axis is a vector";

    one_coordinate(name) = "both coordinates of this height are called `{name}`";
    MANY_COORDINATES = "a height depends on one coordinate in the plane and on two in space";
    without_rim(name) = "the contact `{name}` has an axis, but no rim";
    RIM_HELP = "write the radius of the circle about this axis, `rim: r;`";
    third_coefficient(name) = "the contact `{name}` has one coefficient of friction too many";
    lonely_coefficient(name, label, other) = "the contact `{name}` has a `{label}` coefficient, but no `{other}` one";
    CONTACT_HELP =
        "write `contact name = wheel on ground;`, or the gap by hand, `event name = gap, falling => impact(e);`";
    COEFFICIENTS_HELP =
        "write `friction: mu;` for slipping and sticking, or both `kinetic: a;` and `static: b;`";
    NO_STIFFNESS = "compliant contacts have a stiffness";
    STEPPED = "a declaration does not choose the method: rigid contacts are computed by events or in steps";
    STEPPED_HELP =
        "omit this line, and write `.method(Stepped::every(1e-3))` for the simulation, or `--method stepped --step 0.001` for the command";
    unknown_way(word) = "contacts are `rigid` or `compliant`, not {}", quoted(word);

    /// Message for a tensor with the wrong number of components.
    tensor_count(count) = "a tensor of inertia has 6 components, not {count}";
}

/// Returns advice for a label of joints in other tools.
pub(in crate::syntax) fn beside_a_joint(label: &str) -> Option<&'static str> {
    match label {
        "stiffness" | "spring" | "spring_stiffness" => Some(
            "write the spring as an energy, `potential = 1/2 * k * q^2;`, with the coordinate `q` of the joint",
        ),
        "friction" | "mu" => {
            Some("write `friction rub = dot(q), limit;` with the coordinate `q` of the joint")
        }
        "limits" | "limit" | "lower" | "upper" | "range" | "stop" => Some(
            "write an event for each end, `event end = q - 1, rising => impact(0);`, with the coordinate `q` of the joint",
        ),
        "start" | "initial" | "q0" => {
            Some("write `start q = 1, dot(q) = 2;` with the coordinate `q` of the joint")
        }
        "torque" | "force" | "motor" | "effort" => {
            Some("write `force q = u;` with the coordinate `q` of the joint")
        }
        _ => None,
    }
}

/// Returns the form of an axis that a letter denotes in other tools.
pub(in crate::syntax) fn direction_of_axis(letter: &str) -> Option<&'static str> {
    Some(match letter {
        "x" | "X" => "write `axis: (1, 0, 0);`, or `axis: (1, 0);` in the plane",
        "y" | "Y" => "write `axis: (0, 1, 0);`, or `axis: (0, 1);` in the plane",
        "z" | "Z" => "write `axis: (0, 0, 1);`",
        _ => return None,
    })
}

/// Lists the labels that an object may have.
pub(in crate::syntax) fn labels_are(owner: &str, labels: &[&str]) -> String {
    format!("the labels of {owner} are `{}`", labels.join("`, `"))
}

pub(in crate::syntax) fn labelled(label: &str) -> String {
    match label {
        "shape" => "write `shape: disk(r);`".to_owned(),
        "on" => "write `on: cart;`, with the name of a body".to_owned(),
        "radius" => form("roll").to_owned(),
        "height" => "write `height(x): …;`, or `height(x, y): …;` in space".to_owned(),
        label => format!("write `{label}: …;`"),
    }
}

/// Returns the form of a statement that declares a joint with coordinates.
pub(in crate::syntax) fn mobilizer_help(kind: MobilizerKind) -> String {
    let forms = [("at", "at: p; "), ("axis", "axis: u; "), ("pitch", "pitch: e; ")];
    let known = kind.labels();
    let forms = forms.into_iter().filter(|(label, _)| known.contains(label)).map(|(_, form)| form);
    let labels = format!("{{ {}}}", forms.collect::<String>());
    match kind {
        MobilizerKind::Free => kind.keyword().form.to_owned(),
        MobilizerKind::Weld => format!("write `weld ground to stand {labels}`"),
        kind => format!("write `{} {} = ground to link {labels}`", kind.name(), kind.written_coordinates()),
    }
}

/// Returns the message for a joint with too many or too few coordinates.
pub(in crate::syntax) fn coordinate_count(kind: &str, needed: usize, found: usize) -> String {
    let plural = if needed == 1 { "" } else { "s" };
    format!("a {kind} joint has {needed} coordinate{plural}, not {found}")
}
