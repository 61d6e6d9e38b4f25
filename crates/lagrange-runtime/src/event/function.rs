//! Functions in the search for zeros.

use crate::scalar::Scalar;
use crate::system::Direction;

/// Maximum ratio of a value after a replacement to the value at the event for which the function
/// counts as unchanged.
const NEARLY: f64 = 4.0;

/// The state of one function.
#[derive(Clone, Copy, Debug)]
pub(super) struct EventFunction<S> {
    pub(super) direction: Direction,
    /// True for functions of contacts and friction, which count as positive when started or
    /// restarted.
    pub(super) is_switch: bool,
    /// The value at the time reached by the search.
    pub(super) here: S,
    /// A number whose sign counts: that of the last nonzero value; zero if there was none.
    pub(super) sign: S,
    pub(super) claim: Claim,
    /// The value at the last start.
    pub(super) start: S,
    /// The largest magnitude observed.
    pub(super) range: S,
    /// True if its values have been noise so far.
    is_noise: bool,
    /// True if the last replacement of the state did not change it.
    pub(super) is_kept: bool,
    /// Its last two events, the later one first: the search looks beyond an event before the state
    /// is replaced.
    fired: [Option<Fired<S>>; 2],
}

/// An event of a function.
#[derive(Clone, Copy, Debug)]
struct Fired<S> {
    time: S,
    /// The value at the event, and the sign before it.
    value: S,
    sign: S,
}

/// The reason why a sign counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Claim {
    /// It was observed.
    Found,
    /// The function belongs to a mode, which begins with this sign.
    Switch,
    /// A zero occurred and the state was replaced, but the function did not change. It is at zero,
    /// on the side from which it came unless it continues to the other one.
    Turned,
}

impl<S: Scalar> EventFunction<S> {
    /// Starts with this value.
    pub(super) fn new(direction: Direction, value: S) -> Self {
        EventFunction {
            direction,
            is_switch: false,
            here: value,
            sign: value,
            claim: Claim::Found,
            start: value,
            range: value.abs(),
            is_noise: false,
            is_kept: false,
            fired: [None; 2],
        }
    }

    /// True if the sign that counts was not observed since the last start.
    pub(super) fn is_armed(&self) -> bool {
        self.claim != Claim::Found
    }

    /// True if values within rounding have no sign. Contacts and friction derive theirs from their
    /// modes, and hops begin there.
    pub(super) fn may_be_noise(&self) -> bool {
        !self.is_switch && !self.is_armed()
    }

    /// True if its zero was an event at this time.
    pub(super) fn has_fired_at(&self, t: S) -> bool {
        self.fired[0].is_some_and(|fired| fired.time == t)
    }

    /// Restarts at time `t` with this value.
    pub(super) fn begin(&mut self, t: S, value: S) {
        let fired = self.fired.into_iter().flatten().find(|fired| fired.time == t);
        let turned = fired.filter(|fired| value.abs() <= S::from_f64(NEARLY) * fired.value.abs());
        (self.sign, self.claim) = match turned {
            _ if self.is_switch && value.is_finite() => (S::ONE, Claim::Switch),
            Some(fired) => (fired.sign, Claim::Turned),
            None => (value, Claim::Found),
        };
        (self.here, self.start, self.fired) = (value, value, [None; 2]);
        (self.is_noise, self.is_kept) = (false, false);
        self.measure(value);
    }

    /// Updates the largest magnitude.
    pub(super) fn measure(&mut self, value: S) {
        self.range = self.range.max(value.abs());
    }

    /// Crosses zero as it was about to when the state was replaced.
    pub(super) fn go_on(&mut self) {
        (self.sign, self.claim) = (-self.sign, Claim::Found);
    }

    /// Advances to a time at which the function has this value, with no event on the way. Zero has
    /// no sign.
    pub(super) fn learn(&mut self, value: S) {
        (self.here, self.is_noise) = (value, false);
        let is_rounding = self.is_armed() && value * self.sign < S::ZERO;
        if value != S::ZERO && !is_rounding {
            (self.sign, self.claim) = (value, Claim::Found);
        }
    }

    /// Advances to a time at which the function has this value, with only noise on the way.
    pub(super) fn ignore(&mut self, value: S) {
        (self.here, self.is_noise) = (value, true);
    }

    /// Advances to an event of another function, where this one has this value. If this is an event
    /// of this function, too, it remains to be found.
    pub(super) fn pass(&mut self, value: S) {
        self.here = value;
        if !self.is_armed() && value != S::ZERO && !self.direction.counts(self.sign, value) {
            self.sign = value;
        }
    }

    /// Records its zero as an event at `time`, with this value.
    pub(super) fn fire(&mut self, time: S, value: S) {
        self.fired = [Some(Fired { time, value, sign: self.sign }), self.fired[0]];
        (self.here, self.sign, self.claim) = (value, -self.sign, Claim::Found);
    }

    /// True if a run that ends at the time reached ends on an event: exactly on a zero, reached
    /// from the right side. It counts once.
    pub(super) fn ends_on_zero(&mut self) -> bool {
        let is_reached = self.here == S::ZERO && self.direction.counts(self.sign, -self.sign);
        if is_reached && !self.is_armed() && !self.is_noise {
            self.sign = S::ZERO;
            return true;
        }
        false
    }
}
