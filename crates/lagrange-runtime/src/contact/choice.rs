//! The choices of each reaction, and the rules chosen from them.

use super::reaction_forces::Rule;

/// The choices of a reaction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Choice {
    /// Nothing but this.
    Only(Rule),
    /// To press or to part.
    Touch,
    /// To hold or to slip.
    Rest,
}

/// Rules that fit together, and the reactions under them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled<S, const K: usize> {
    pub(super) rules: [Rule; K],
    pub(super) reactions: [S; K],
}

impl Choice {
    /// The rules that it leaves to be tried, the first of them first.
    pub(super) fn rules(self) -> &'static [Rule] {
        match self {
            Choice::Only(Rule::Absent) => &[Rule::Absent],
            Choice::Only(Rule::Holds) => &[Rule::Holds],
            Choice::Only(Rule::Forwards) => &[Rule::Forwards],
            Choice::Only(Rule::Backwards) => &[Rule::Backwards],
            Choice::Only(Rule::Smooth) => &[Rule::Smooth],
            Choice::Touch => &[Rule::Holds, Rule::Absent],
            Choice::Rest => &[Rule::Holds, Rule::Forwards, Rule::Backwards],
        }
    }
}
