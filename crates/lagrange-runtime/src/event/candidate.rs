//! The earliest event found so far in a piece.
//!
//! Locating an event takes ten evaluations or more. If a function has not crossed zero just before
//! the earliest event, its event is not earlier and is not located. If many functions cross zero
//! together, only one is located.

use super::piece::EventValues;
use crate::scalar::Scalar;

/// The earliest event found so far in a piece that starts at `reached`.
pub(super) struct Candidate<S, const K: usize> {
    pub(super) event: usize,
    pub(super) time: S,
    reached: S,
    /// A time just before the event that cannot be distinguished from it, and the values of all
    /// functions at that time.
    before: Option<(S, [S; K])>,
}

impl<S: Scalar, const K: usize> Candidate<S, K> {
    /// Evaluates all functions just before an event of this function at this time.
    pub(super) fn new(
        (event, time): (usize, S),
        reached: S,
        accuracy: S,
        at: &mut EventValues<'_, S, K>,
    ) -> Self {
        let distance = (time - reached).abs() - accuracy;
        let just_before = if time < reached { reached - distance } else { reached + distance };
        let is_seen = K > 1 && distance > S::ZERO;
        Candidate { event, time, reached, before: is_seen.then(|| (just_before, at(just_before, false))) }
    }

    /// True if a function is known not to cross zero before this event. It has this sign at the
    /// first of these times, and the other one at the second.
    pub(super) fn is_before(&self, event: usize, (from, to): (S, S), sign: S) -> bool {
        let Some((before, values)) = &self.before else { return self.time == self.reached };
        let [from, to, before] = [from, to, *before].map(|time| (time - self.reached).abs());
        from >= before || before <= to && values[event] * sign > S::ZERO
    }
}
