//! The earliest event in a piece of a step.

use super::{Detector, check};
use crate::event::candidate::Candidate;
use crate::event::function::EventFunction;
use crate::event::locate::{MOST_ROUNDS, Sample, locate};
use crate::event::piece::{EventValues, Piece, Sight};
use crate::event::polynomial::POINTS;
use crate::integrate::EventSource::Given;
use crate::scalar::Scalar;
use crate::system::StepFailure;

/// Maximum number of halvings in search of a short hop.
const MAX_HALVINGS: u32 = 60;

/// The first event in a piece.
pub(super) enum First<S> {
    /// No event.
    None,
    /// An event of this function at this time.
    At(usize, S),
    /// No event: this function continues through the zero that it had when the state was replaced.
    Passing(usize),
    /// Undecided; a shorter piece is needed.
    Unclear,
}

/// The functions that are noise throughout a piece, among those examined so far.
struct Noise<S, const K: usize> {
    are: [bool; K],
    /// The change of each function by rounding, computed on demand.
    roundings: Option<[S; K]>,
}

impl<S: Scalar, const K: usize> Noise<S, K> {
    /// True if this function, evaluated as `sight`, is noise throughout the piece.
    fn holds(
        &mut self,
        (event, function): (usize, &EventFunction<S>),
        sight: &Sight<S>,
        piece: &Piece<S, K>,
        at: &mut EventValues<'_, S, K>,
    ) -> bool {
        // A run may end on a zero at the end of the piece.
        let is_suspect = *sight != Sight::Nothing || piece.values[POINTS - 1][event] == S::ZERO;
        if is_suspect && function.may_be_noise() {
            let roundings = self.roundings.get_or_insert_with(|| piece.roundings(at));
            self.are[event] = piece.values.iter().all(|values| values[event].abs() <= roundings[event]);
        }
        self.are[event]
    }
}

impl<S: Scalar, const K: usize> Detector<S, K> {
    /// Returns the first event in a piece, and true for each function that might have one but is
    /// noise throughout the piece.
    pub(super) fn earliest(
        &self,
        piece: &Piece<S, K>,
        accuracy: S,
        at: &mut EventValues<'_, S, K>,
    ) -> Result<(First<S>, [bool; K]), StepFailure<S>> {
        let mut noise = Noise { are: [false; K], roundings: None };
        if piece.values.iter().any(|values| check(*values).is_err()) {
            return Ok((First::Unclear, noise.are));
        }
        let is_shortest = self.search.is_shortest();
        // Functions that had no time to leave zero since the last event do not continue through it.
        let passable = (self.repetitions <= 1).then_some(self.started);
        let mut first: Option<Candidate<S, K>> = None;
        for (event, function) in self.functions.iter().enumerate() {
            let sight = piece.sight(event, function, passable, is_shortest);
            if noise.holds((event, function), &sight, piece, at) {
                continue;
            }
            let time = match sight {
                Sight::Nothing => continue,
                Sight::AtOnce => self.reached,
                Sight::Between { from, to, sign } => {
                    let (times, sign) = ((from, to), sign.sign());
                    if first.as_ref().is_some_and(|first| first.is_before(event, times, sign)) {
                        continue;
                    }
                    match self.crossing(times, (event, function, sign), accuracy, at)? {
                        Some(time) => time,
                        None if is_shortest => continue,
                        None => return Ok((First::Unclear, noise.are)),
                    }
                }
                Sight::Unclear => return Ok((First::Unclear, noise.are)),
                Sight::Passing => return Ok((First::Passing(event), noise.are)),
            };
            let distance = |time: S| (time - self.reached).abs();
            if first.as_ref().is_none_or(|first| distance(time) < distance(first.time)) {
                first = Some(Candidate::new((event, time), self.reached, accuracy, at));
            }
        }
        Ok((first.map_or(First::None, |first| First::At(first.event, first.time)), noise.are))
    }

    /// Locates the change of sign of a function that has this sign, or is assumed to have it,
    /// between these times. `None` if it does not have the other sign at the end.
    fn crossing(
        &self,
        times: (S, S),
        (event, function, sign): (usize, &EventFunction<S>, S),
        accuracy: S,
        at: &mut EventValues<'_, S, K>,
    ) -> Result<Option<S>, StepFailure<S>> {
        let Some((before, after)) = self.bracket(times, (function, sign), &mut |t| at(t, false)[event])
        else {
            return Ok(None);
        };
        let located = locate(before, after, accuracy, &mut |t| at(t, false)[event]);
        let lost = StepFailure::EventNotLocated { event: Given(event), bisections: MOST_ROUNDS };
        located.map(Some).ok_or(lost)
    }

    /// Returns places at which the function has this sign and the other one, between these times.
    /// If it is only assumed to have the first, they are from the start on. `None` if it does not
    /// have the other one at the end.
    fn bracket(
        &self,
        (from, to): (S, S),
        (function, sign): (&EventFunction<S>, S),
        value: &mut dyn FnMut(S) -> S,
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
        value: &mut dyn FnMut(S) -> S,
    ) -> Option<(Sample<S>, Sample<S>)> {
        for _ in 0..MAX_HALVINGS {
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
