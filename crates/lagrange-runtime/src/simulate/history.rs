//! The past of delayed signals.
//!
//! The equations ẏ = f(t, y, s(t − τ)) are integrated by the method of steps. No step is longer
//! than the shortest delay, so that every delayed value lies in steps that were accepted. These are
//! kept as [polynomials](super::dense) of the signals s.
//!
//! Where the mᵗʰ derivative of the state jumps, the derivative m + 1 jumps one delay later. Steps
//! end at these times until that derivative is of no concern for the order of the method. Take
//! τ = 1 and a rate that jumps at 0. The second derivative of y jumps at 1, the third one at 2.
//!
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.17; Bellen,
//! Zennaro, *Numerical Methods for Delay Differential Equations*, §3.2 and §4.1.

use std::vec::Vec;

use crate::scalar::Scalar;
use crate::simulate::dense::Dense;
use crate::system::StateVector;
use crate::tolerance::SAME_EVENT;

/// A time at which a derivative of the state jumps; the one of order 0 is the state itself.
#[derive(Clone, Copy, Debug)]
struct Break<S> {
    time: S,
    order: u32,
}

/// The signals of a run so far, as far as delays reach back.
pub(super) struct History<S, Y> {
    lags: Y,
    /// The signals before the start of the run.
    before: Y,
    steps: Dense<S, Y>,
    /// Times to come, the first one last.
    breaks: Vec<Break<S>>,
    /// Derivatives of higher orders may jump within steps.
    order: u32,
    /// The time that was reached, from which the present step starts.
    from: S,
}

impl<S: Scalar, Y: StateVector<S>> History<S, Y> {
    /// Starts at a time before which the signals are unknown, for a method of this order. Rates
    /// that are given jump at the times `restarts`.
    pub(super) fn new(start: S, lags: Y, order: u32, restarts: &[S]) -> Self {
        let (before, steps) = (unknown(lags), Dense::new(order));
        let order = order.min(highest_order(lags.as_ref().len()));
        let mut history = History { lags, before, steps, breaks: Vec::new(), order, from: start };
        history.spread(start, 1);
        restarts.iter().filter(|time| **time > start).for_each(|time| history.spread(*time, 0));
        history
    }

    /// Sets the signals before the start where no function of time gives them.
    pub(super) fn set_before(&mut self, signals: Y) {
        self.before = signals;
    }

    /// Notes that the signals jump at the start.
    pub(super) fn jump_at_start(&mut self) {
        self.spread(self.from, 0);
    }

    /// Returns each signal as it was one delay before `t`; NaN where that is not known yet. The
    /// function `before` may give signals at times before the start.
    pub(super) fn delayed(&self, t: S, before: impl Fn(S) -> Option<Y>) -> Y {
        let mut values = self.before;
        let mut last: Option<(S, Y)> = None;
        for (place, lag) in self.lags.as_ref().iter().enumerate() {
            let signals = match last {
                Some((same, signals)) if same == *lag => signals,
                _ => self.at(t, *lag, &before),
            };
            values.as_mut()[place] = signals.as_ref()[place];
            last = Some((*lag, signals));
        }
        values
    }

    /// Returns the signals at `t − lag`. An end of a step counts as passed once the run has gone on
    /// from one delay later. Times are compared there, since (s + τ) − τ is not s.
    fn at(&self, t: S, lag: S, before: impl Fn(S) -> Option<Y>) -> Y {
        let steps = self.steps.steps();
        let is_passed = |edge: S| match Self::is_at(t, edge) {
            true => self.from >= edge || Self::is_at(self.from, edge),
            false => t > edge,
        };
        let Some(index) = steps.partition_point(|(from, _)| is_passed(*from + lag)).checked_sub(1) else {
            return before(t - lag).unwrap_or(self.before);
        };
        let (from, to) = steps[index];
        if t > to + lag && !Self::is_at(t, to + lag) {
            return unknown(self.before);
        }
        let part = (t - lag - from) / (to - from);
        self.steps.within(index, part.max(S::ZERO).min(S::ONE))
    }

    /// True if two times differ by rounding only.
    fn is_at(one: S, other: S) -> bool {
        (one - other).abs() <= SAME_EVENT.part::<S>() * one.abs().max(other.abs())
    }

    /// Returns the time to which the next step may go.
    pub(super) fn limit(&self) -> Option<S> {
        let shortest = self.lags.as_ref().iter().copied().reduce(S::min)?;
        let limit = self.from + shortest;
        let is_break =
            self.breaks.last().is_some_and(|next| next.time <= limit || Self::is_at(next.time, limit));
        (!is_break).then_some(limit)
    }

    /// Returns the first time after `t` at which a step is to end.
    pub(super) fn next_break(&self, t: S) -> Option<S> {
        self.breaks.iter().rev().map(|next| next.time).find(|time| *time > t)
    }

    /// Returns the times within the step to `to` at which signals are to be known.
    pub(super) fn times(&self, to: S) -> Vec<S> {
        if to > self.from { self.steps.times((self.from, to)).collect() } else { Vec::new() }
    }

    /// Keeps the signals at these times, and goes on from there. Signals jump there if that
    /// `is_jump`.
    pub(super) fn reach(&mut self, to: S, signals: &[Y], is_jump: bool) {
        if !signals.is_empty() {
            self.steps.append((self.from, to), signals);
        }
        self.from = to;
        while let Some(next) =
            self.breaks.last().copied().filter(|next| next.time <= to || Self::is_at(next.time, to))
        {
            self.breaks.pop();
            self.spread(to, next.order);
        }
        if is_jump {
            self.spread(to, 0);
        }
        let longest = self.lags.as_ref().iter().copied().fold(S::ZERO, S::max);
        let (is_at, past) = (Self::is_at, |end: S| end + longest);
        self.steps.forget(|(_, end)| past(*end) < to && !is_at(past(*end), to));
    }

    /// Notes that a derivative of this order jumps at a time, and one of the next order each delay
    /// later.
    fn spread(&mut self, time: S, order: u32) {
        if order >= self.order {
            return;
        }
        let lags = self.lags;
        for lag in lags.as_ref() {
            let new = Break { time: time + *lag, order: order + 1 };
            let after = self.breaks.partition_point(|other| other.time > new.time);
            let around = after.saturating_sub(1)..(after + 1).min(self.breaks.len());
            match around.into_iter().find(|&index| Self::is_at(self.breaks[index].time, new.time)) {
                Some(same) => self.breaks[same].order = self.breaks[same].order.min(new.order),
                None => self.breaks.insert(after, new),
            }
        }
    }
}

/// Maximum number of breaks that one jump causes.
const MAX_BREAKS: u64 = 300;

/// Returns the highest order of derivatives whose jumps are followed. One jump causes as many
/// breaks of the orders up to n as there are sums of up to n of the lags, (lags + n)!/(lags! n!) − 1.
/// For eight lags that is 44 for n = 2, and 164 for n = 3. Jumps of higher orders are left to the
/// control of errors.
fn highest_order(lags: usize) -> u32 {
    let (mut sums, mut order) = (1, 0);
    while sums <= MAX_BREAKS && order < u32::from(u8::MAX) {
        order += 1;
        sums = sums * (lags as u64 + u64::from(order)) / u64::from(order);
    }
    (order - 1).max(1)
}

/// Returns unknown signals, as many as these.
pub(super) fn unknown<S: Scalar, Y: StateVector<S>>(mut signals: Y) -> Y {
    signals.as_mut().fill(S::from_f64(f64::NAN));
    signals
}
