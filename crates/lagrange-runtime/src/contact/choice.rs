//! The rules by which reactions act, and the choices between them.

use crate::scalar::Scalar;

/// The rule by which a reaction acts.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Rule<S> {
    /// The reaction is zero.
    Absent,
    /// The rate of the reaction stays zero.
    Holds,
    /// r = −c |kinetic limit|, where c is the component of the direction of slipping: 1 forwards,
    /// −1 backwards, and a cosine in a plane.
    Slips(S),
    /// r = −kinetic limit, which has the sign of the slip velocity already.
    Smooth,
}

/// The rules that are possible for a reaction.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Choice<S> {
    /// Only this rule.
    Only(Rule<S>),
    /// The contact presses or parts.
    Touch,
    /// Friction holds or slips; in a plane [`Across`](Choice::Across) follows it.
    Rest,
    /// Friction slips in a plane, in any direction.
    GiveWay,
    /// The second component of the reaction before it, whose choice it follows.
    Across,
}

/// Rules that fit together, and the reactions under them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled<S, const K: usize> {
    pub(super) rules: [Rule<S>; K],
    pub(super) reactions: [S; K],
}

impl<S: Scalar> Choice<S> {
    /// Returns the number of rules to be tried.
    pub(super) fn count(self) -> usize {
        match self {
            Choice::Only(_) | Choice::GiveWay | Choice::Across => 1,
            Choice::Touch => 2,
            Choice::Rest => 3,
        }
    }

    /// Returns the rule to be tried at this place.
    pub(super) fn rule(self, place: usize) -> Rule<S> {
        match (self, place) {
            (Choice::Only(rule), _) => rule,
            (Choice::Touch, 1) => Rule::Absent,
            (Choice::Rest, 1) => Rule::Slips(S::ONE),
            (Choice::Rest, 2) => Rule::Slips(-S::ONE),
            (Choice::Touch | Choice::Rest | Choice::GiveWay | Choice::Across, _) => Rule::Holds,
        }
    }
}

impl<S: Scalar> Rule<S> {
    /// Returns the rules of friction that slips in this direction; without a direction there is
    /// none.
    pub(super) fn slipping(direction: Option<[S; 2]>) -> [Rule<S>; 2] {
        direction.map_or([Rule::Absent; 2], |direction| direction.map(Rule::Slips))
    }
}
