//! The earliest event in a piece of a step.

use super::{Detector, check};
use crate::event::candidate::Candidate;
use crate::event::function::EventFunction;
use crate::event::locate::{MOST_ROUNDS, Sample, locate};
use crate::event::piece::{Piece, Sight};
use crate::event::polynomial::POINTS;
use crate::integrate::EventSource::Given;
use crate::scalar::Scalar;
use crate::system::StepFailure;

/// A step is halved so often in search of a hop that is shorter.
const MOST_HALVINGS: u32 = 60;

/// The first event in a piece.
pub(super) enum First<S> {
    /// There is none.
    None,
    /// The event of this function at this time.
    At(usize, S),
    /// None of this function, which goes on through the zero that it had when the state was
    /// replaced.
    Passing(usize),
    /// A shorter piece would tell.
    Unclear,
}

impl<S: Scalar, const K: usize> Detector<S, K> {
    /// The first event in a piece, and true for each function that might have one but is noise in
    /// all of the piece.
    pub(super) fn earliest(
        &self,
        piece: &Piece<S, K>,
        accuracy: S,
        at: &mut impl FnMut(S, bool) -> [S; K],
    ) -> Result<(First<S>, [bool; K]), StepFailure<S>> {
        let (is_shortest, mut is_noise) = (self.search.is_shortest(), [false; K]);
        if piece.values.iter().any(|values| check(*values).is_err()) {
            return Ok((First::Unclear, is_noise));
        }
        let mut roundings = None;
        // What had no time to leave zero since the last event was not meant to go on through it.
        let passable = (self.repetitions <= 1).then_some(self.started);
        let mut first: Option<Candidate<S, K>> = None;
        for (event, function) in self.functions.iter().enumerate() {
            let sight = piece.sight(event, function, passable, is_shortest);
            // At its end a run may end on a zero.
            let is_suspect = sight != Sight::Nothing || piece.values[POINTS - 1][event] == S::ZERO;
            if is_suspect && function.may_be_noise() {
                let roundings = roundings.get_or_insert_with(|| piece.roundings(&mut *at));
                is_noise[event] = piece.values.iter().all(|values| values[event].abs() <= roundings[event]);
            }
            let time = match sight {
                Sight::Nothing => continue,
                _ if is_noise[event] => continue,
                Sight::AtOnce => self.reached,
                Sight::Between { from, to, sign }
                    if first
                        .as_ref()
                        .is_some_and(|first| first.is_before(event, (from, to), sign.sign())) =>
                {
                    continue;
                }
                Sight::Between { from, to, sign } => {
                    match self.bracket((from, to), (function, sign.sign()), |t| at(t, false)[event]) {
                        Some((before, after)) => {
                            locate(before, after, accuracy, |t| at(t, false)[event]).ok_or(
                                StepFailure::EventNotLocated { event: Given(event), bisections: MOST_ROUNDS },
                            )?
                        }
                        None if is_shortest => continue,
                        None => return Ok((First::Unclear, is_noise)),
                    }
                }
                Sight::Unclear => return Ok((First::Unclear, is_noise)),
                Sight::Passing => return Ok((First::Passing(event), is_noise)),
            };
            let distance = |time: S| (time - self.reached).abs();
            if first.as_ref().is_none_or(|first| distance(time) < distance(first.time)) {
                first = Some(Candidate::new((event, time), self.reached, accuracy, |t| at(t, false)));
            }
        }
        Ok((first.map_or(First::None, |first| First::At(first.event, first.time)), is_noise))
    }

    /// Returns places at which the function has this sign and the other one, between these times.
    /// If it is only assumed to have the first, they are from the start on. `None` if it does not
    /// have the other one at the end.
    fn bracket(
        &self,
        (from, to): (S, S),
        (function, sign): (&EventFunction<S>, S),
        mut value: impl FnMut(S) -> S,
    ) -> Option<(Sample<S>, Sample<S>)> {
        let after = (to, value(to));
        let is_change = after.1 * sign < S::ZERO;
        if !is_change {
            return None;
        }
        let before = if from == self.reached { function.here } else { value(from) };
        if before * sign > S::ZERO {
            return Some(((from, before), after));
        }
        if function.is_armed() && function.sign * sign > S::ZERO {
            return self.hop((after, sign), value);
        }
        Some(((from, sign), after))
    }

    /// Locates a change between the start and `t` for a function that counted as of this sign at
    /// the start and has the other one. Halves the time from the start. The result is the latest
    /// place at which it had the sign and the place after it. If it never had, it passed zero at
    /// the start.
    fn hop(
        &self,
        ((mut t, mut found), sign): (Sample<S>, S),
        mut value: impl FnMut(S) -> S,
    ) -> Option<(Sample<S>, Sample<S>)> {
        for _ in 0..MOST_HALVINGS {
            let middle = self.started + S::from_f64(0.5) * (t - self.started);
            if middle == self.started || middle == t {
                break;
            }
            let at = value(middle);
            if at * sign > S::ZERO {
                return Some(((middle, at), (t, found)));
            }
            (t, found) = (middle, at);
        }
        found.is_finite().then_some(((t, sign), (t, found)))
    }
}
