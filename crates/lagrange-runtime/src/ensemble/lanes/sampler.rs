//! Samples of motions in lanes.

use std::vec::Vec;

use crate::integrate::{LanesStepper, MAX_LANES};
use crate::scalar::{Mask, Number, Scalar};
use crate::simulate::Grid;
use crate::system::{Equations, SideBySide, StateVector};

/// Samples of the motions that are in lanes at present, with states of type Y. The type W holds the
/// data of the last steps.
pub(super) struct Sampler<S: SideBySide, Y, W> {
    /// The times of the samples of every motion.
    grid: Grid<S::Element>,
    /// The times of the samples that the motion in each lane has yet to reach.
    ahead: [Grid<S::Element>; MAX_LANES],
    /// The time of the next sample in each lane; NaN after the last one.
    next: S,
    last: W,
    kept: [SamplesWithin<S::Element, Y>; MAX_LANES],
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
    /// Creates a sampler for the times of a grid.
    pub(super) fn new(grid: Grid<S::Element>, last: W) -> Self {
        let kept = core::array::from_fn(|_| Vec::new());
        Sampler { grid, ahead: [grid; MAX_LANES], next: S::NAN, last, kept, number: 0 }
    }

    /// Prepares this lane for a new motion.
    pub(super) fn start(&mut self, lane: usize) {
        self.ahead[lane] = self.grid;
        self.kept[lane] = Vec::with_capacity(self.number);
        self.advance(lane);
    }

    /// Returns the samples of the motion in this lane, which has ended or was given up.
    pub(super) fn end(&mut self, lane: usize) -> SamplesWithin<S::Element, Y> {
        let kept = core::mem::take(&mut self.kept[lane]);
        self.number = self.number.max(kept.len());
        self.next.set_lane(lane, S::Element::NAN);
        kept
    }

    /// Prepares for the attempt of a step.
    #[inline(always)]
    pub(super) fn begin<E: Equations<S>>(&mut self, stepper: &impl LanesStepper<S, E, LastStep = W>) {
        stepper.begin(&mut self.last);
    }

    /// Keeps the samples within the last steps. Steps whose interpolation is not good enough are
    /// taken back.
    #[inline(always)]
    pub(super) fn keep<E: Equations<S>, L: LanesStepper<S, E, LastStep = W>>(
        &mut self,
        equations: &E,
        stepper: &mut L,
        workspace: &L::Workspace,
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
            let states = stepper.interpolate(workspace, &self.last, self.next);
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
