//! Diagnostics for statements about plane rigid bodies, with what helps against mistakes in them.

use super::forms::form;
use super::quoted;

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
        "radius" => form("roll").to_owned(),
        label => format!("write `{label}: …;`"),
    }
}
