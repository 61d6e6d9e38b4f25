//! The state of one function in the search for zeros.

use crate::scalar::Scalar;
use crate::system::Direction;

/// A value after a replacement that is larger than that at the event by no more than this factor is
/// still that of the event.
const NEARLY: f64 = 4.0;

/// The state of one function.
#[derive(Clone, Copy, Debug)]
pub(super) struct EventFunction<S> {
    pub(super) direction: Direction,
    /// True if the function counts as positive from where it was started or restarted: that of a
    /// contact or friction.
    pub(super) is_switch: bool,
    /// The value where the search has got to.
    pub(super) here: S,
    /// A number of the sign that counts: that of the last value that was not zero; zero if there
    /// was none.
    pub(super) sign: S,
    pub(super) claim: Claim,
    /// The value at the last start.
    pub(super) start: S,
    /// The largest magnitude that it was found to have.
    pub(super) range: S,
    /// True if its values were noise up to here.
    is_noise: bool,
    /// True if the last replacement of the state did not change it.
    pub(super) is_kept: bool,
    /// Its last two events, the later one first: what lies behind an event is looked at before the
    /// state is replaced there.
    fired: [Option<Fired<S>>; 2],
}

/// An event of a function.
#[derive(Clone, Copy, Debug)]
struct Fired<S> {
    time: S,
    /// The value there, and the sign that it had before.
    value: S,
    sign: S,
}

/// On what ground a sign counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Claim {
    /// It was found.
    Found,
    /// The function belongs to a mode, which begins with it.
    Switch,
    /// A zero occurred and the state was replaced, but the function is where it was. It is at zero,
    /// on the side from which it came unless it continues to the other one.
    Turned,
}

impl<S: Scalar> EventFunction<S> {
    /// Starts where the function has this value.
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

    /// True if the sign that counts was not found since the last start.
    pub(super) fn is_armed(&self) -> bool {
        self.claim != Claim::Found
    }

    /// True if values within rounding have no sign. Those of contacts and friction have theirs by
    /// their modes, and hops begin there.
    pub(super) fn may_be_noise(&self) -> bool {
        !self.is_switch && !self.is_armed()
    }

    /// True if its zero was an event at this time.
    pub(super) fn has_fired_at(&self, t: S) -> bool {
        self.fired[0].is_some_and(|fired| fired.time == t)
    }

    /// Starts anew at time `t`, where the function has this value.
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

    /// Keeps in view how large it gets.
    pub(super) fn measure(&mut self, value: S) {
        self.range = self.range.max(value.abs());
    }

    /// Passes zero as it was about to when the state was replaced.
    pub(super) fn go_on(&mut self) {
        (self.sign, self.claim) = (-self.sign, Claim::Found);
    }

    /// Goes on to a place where the function has this value, with no event on the way. Zero has no
    /// sign.
    pub(super) fn learn(&mut self, value: S) {
        (self.here, self.is_noise) = (value, false);
        let is_rounding = self.is_armed() && value * self.sign < S::ZERO;
        if value != S::ZERO && !is_rounding {
            (self.sign, self.claim) = (value, Claim::Found);
        }
    }

    /// Goes on to a place where the function has this value, with nothing but noise on the way.
    pub(super) fn ignore(&mut self, value: S) {
        (self.here, self.is_noise) = (value, true);
    }

    /// Continues to an event of another function at which this one has this value. A sign that
    /// makes an event of it here, too, remains to be found.
    pub(super) fn pass(&mut self, value: S) {
        self.here = value;
        if !self.is_armed() && value != S::ZERO && !self.direction.counts(self.sign, value) {
            self.sign = value;
        }
    }

    /// Its zero was the event at time `t`, where it has this value.
    pub(super) fn fire(&mut self, time: S, value: S) {
        self.fired = [Some(Fired { time, value, sign: self.sign }), self.fired[0]];
        (self.here, self.sign, self.claim) = (value, -self.sign, Claim::Found);
    }

    /// True if a run that ends where the function is now ends on an event: exactly on its zero,
    /// reached from the right side. It counts once.
    pub(super) fn ends_on_zero(&mut self) -> bool {
        let is_reached = self.here == S::ZERO && self.direction.counts(self.sign, -self.sign);
        if is_reached && !self.is_armed() && !self.is_noise {
            self.sign = S::ZERO;
            return true;
        }
        false
    }
}
