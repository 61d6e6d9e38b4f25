//! Diagnostics for statements about plane rigid bodies, with what helps against mistakes in them.

use super::quoted;

pub(in crate::syntax) const BODY_HELP: &str =
    "write `body name { mass: m; inertia: disk(m, r); center: (x, y); angle: phi; }`";
pub(in crate::syntax) const LINE_HELP: &str = "write `line name { through: (x, y); angle: e; }`";
pub(in crate::syntax) const SPRING_HELP: &str =
    "write `spring { from: p; to: q; stiffness: k; rest: l; }`, with a name behind `spring` if it needs one";
pub(in crate::syntax) const DAMPER_HELP: &str =
    "write `damper { from: p; to: q; damping: c; }`, with a name behind `damper` if it needs one";
pub(in crate::syntax) const TORSION_SPRING_HELP: &str =
    "write `torsion_spring { from: ground; to: arm; stiffness: k; rest: e; }`";
pub(in crate::syntax) const TORSION_DAMPER_HELP: &str =
    "write `torsion_damper { from: ground; to: arm; damping: c; }`";
pub(in crate::syntax) const PIN_HELP: &str = "write `pin p to q;` or `pin name = p to q;`";
pub(in crate::syntax) const SLIDE_HELP: &str =
    "write `slide p on floor;` or `slide name = p on floor;`, with the name of a line";
pub(in crate::syntax) const ROLL_HELP: &str = "write `roll wheel on floor;` or `roll name = wheel on floor, radius: r;`, with the names of a body and a line";
pub(in crate::syntax) const COMPOUND_HELP: &str =
    "write `compound { disk(r), mass: m; hole disk(s), mass: n, at: (a, b); }`";
pub(in crate::syntax) const SOLID_HELP: &str =
    "write the name of a solid with its dimensions, such as `disk(r)` or `rectangle(a, b)`";
pub(in crate::syntax) const EMPTY_COMPOUND: &str = "this body has no parts";
pub(in crate::syntax) const LINE_HELP_END: &str = "what is said between the braces ends in `;`";
pub(in crate::syntax) const NEXT_LABEL: &str = "the next line begins here";

/// Message for a word in front of a colon that means nothing there; `owner` has its article.
pub(in crate::syntax) fn unknown_label(label: &str, owner: &str) -> String {
    format!("{} says nothing about {owner}", quoted(label))
}

/// Labels that something may have, in words.
pub(in crate::syntax) fn labels_are(owner: &str, labels: &[&str]) -> String {
    format!("what can be said of {owner}: `{}`", labels.join("`, `"))
}

pub(in crate::syntax) fn label(owner: &str) -> String {
    format!("what is said of {owner}")
}

pub(in crate::syntax) fn labelled(label: &str) -> String {
    match label {
        "shape" => "write `shape: disk(r);`".to_owned(),
        "on" => "write `on: cart;`, with the name of a body".to_owned(),
        "radius" => ROLL_HELP.to_owned(),
        label => format!("write `{label}: …;`"),
    }
}
