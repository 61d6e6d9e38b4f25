//! Samples of motions in lanes.

use std::vec::Vec;

use crate::integrate::{LanesStepper, MOST_LANES};
use crate::scalar::{Mask, Number, Scalar};
use crate::simulate::Grid;
use crate::system::{Equations, SideBySide, StateVector};

/// Samples of the motions that are in lanes at present, of states Y, with what is known of the last
/// steps, W.
pub(super) struct Sampler<S: SideBySide, Y, W> {
    /// The times of the samples of every motion,
    grid: Grid<S::Element>,
    /// and those that the motion in each lane has yet to reach.
    ahead: [Grid<S::Element>; MOST_LANES],
    /// The first of them; NaN if there is none.
    next: S,
    last: W,
    kept: [SamplesWithin<S::Element, Y>; MOST_LANES],
    /// Number of samples per motion, known once the first motion has ended.
    number: usize,
}

/// Times and states of a motion between its start and its end.
pub(in crate::ensemble) type SamplesWithin<T, Y> = Vec<(T, Y)>;

impl<S, Y, W> Sampler<S, Y, W>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S::Element>,
    W: Copy,
{
    /// Samples at the times of a grid.
    pub(super) fn new(grid: Grid<S::Element>, last: W) -> Self {
        let kept = core::array::from_fn(|_| Vec::new());
        Sampler { grid, ahead: [grid; MOST_LANES], next: S::NAN, last, kept, number: 0 }
    }

    /// A motion starts in this lane.
    pub(super) fn start(&mut self, lane: usize) {
        self.ahead[lane] = self.grid;
        self.kept[lane] = Vec::with_capacity(self.number);
        self.advance(lane);
    }

    /// The motion in this lane has ended or was given up; what was kept of it.
    pub(super) fn end(&mut self, lane: usize) -> SamplesWithin<S::Element, Y> {
        let kept = core::mem::take(&mut self.kept[lane]);
        self.number = self.number.max(kept.len());
        self.next.set_lane(lane, S::Element::NAN);
        kept
    }

    /// A step is about to be tried.
    #[inline(always)]
    pub(super) fn begin<E: Equations<S>>(&mut self, stepper: &impl LanesStepper<S, E, LastStep = W>) {
        stepper.begin(&mut self.last);
    }

    /// Keeps what samples there are of the last steps, of which those are taken back that do not
    /// tell states within them.
    #[inline(always)]
    pub(super) fn keep<E: Equations<S>>(
        &mut self,
        equations: &E,
        stepper: &mut impl LanesStepper<S, E, LastStep = W>,
    ) {
        let (next, reached) = (self.next, stepper.time());
        let are_within = self.are_due(reached) & !(next.less_equal(reached) & reached.less_equal(next));
        if are_within.any() {
            stepper.confirm(equations, &mut self.last, are_within);
        }
        loop {
            let are_due = self.are_due(stepper.time());
            if !are_due.any() {
                break;
            }
            let states = stepper.interpolate(&self.last, self.next);
            self.push(are_due, states.as_ref());
        }
    }

    /// Returns the lanes that have samples up to these times.
    #[inline(always)]
    fn are_due(&self, reached: S) -> S::Mask {
        if self.grid.is_backwards() { reached.less_equal(self.next) } else { self.next.less_equal(reached) }
    }

    /// Keeps the next samples in these lanes.
    #[inline(always)]
    fn push(&mut self, lanes: S::Mask, states: &[S]) {
        for lane in 0..S::LANES {
            if !lanes.lane(lane) {
                continue;
            }
            let mut state = Y::ZERO;
            for (component, lanes) in state.as_mut().iter_mut().zip(states) {
                *component = lanes.lane(lane);
            }
            self.kept[lane].push((self.next.lane(lane), state));
            self.advance(lane);
        }
    }

    /// Looks for the next sample in this lane.
    #[inline(always)]
    fn advance(&mut self, lane: usize) {
        self.next.set_lane(lane, self.ahead[lane].next().unwrap_or(S::Element::NAN));
    }
}
