//! The rules by which reactions act, and the choices between them.

use crate::scalar::Scalar;

/// The rule by which a reaction acts.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Rule<S> {
    /// Not at all.
    Absent,
    /// Its rate stays zero.
    Holds,
    /// r = −c |kinetic limit|, where c is the component of the direction of slipping: 1 forwards,
    /// −1 backwards, and a cosine in a plane.
    Slips(S),
    /// r = −kinetic limit, which has the sign of the slip velocity already.
    Smooth,
}

/// The choices of a reaction.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Choice<S> {
    /// Nothing but this.
    Only(Rule<S>),
    /// To press or to part.
    Touch,
    /// To hold or to slip; with [`Across`](Choice::Across) behind it in a plane.
    Rest,
    /// To slip in a plane, in any direction.
    GiveWay,
    /// The choice of the reaction before it, whose second component this is.
    Across,
}

/// Rules that fit together, and the reactions under them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled<S, const K: usize> {
    pub(super) rules: [Rule<S>; K],
    pub(super) reactions: [S; K],
}

impl<S: Scalar> Choice<S> {
    /// The number of rules that it leaves to be tried.
    pub(super) fn count(self) -> usize {
        match self {
            Choice::Only(_) | Choice::GiveWay | Choice::Across => 1,
            Choice::Touch => 2,
            Choice::Rest => 3,
        }
    }

    /// The rule to be tried at this place.
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
    /// The rules of friction that slips in this direction, without any if there is none.
    pub(super) fn slipping(direction: Option<[S; 2]>) -> [Rule<S>; 2] {
        direction.map_or([Rule::Absent; 2], |direction| direction.map(Rule::Slips))
    }
}
