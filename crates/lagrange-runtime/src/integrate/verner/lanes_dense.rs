//! States within steps in lanes.

use super::dense::{FixedPart, Span, interpolated};
use super::interpolant::{
    STAGE_17, STAGE_18, STAGE_19, STAGE_20, STAGE_21, STAGE_22, STAGE_23, STAGE_24, STAGE_25,
};
use super::stage::{RATES, STAGES};
use super::stepper::{CHECKED, END, LARGEST_DEFECT};
use super::tolerance::Tolerated;
use crate::integrate::clock::Clock;
use crate::integrate::compensated::Compensated;
use crate::integrate::explicit::TableauRow;
use crate::integrate::lane_wise::{chosen, is_equal};
use crate::scalar::Scalar;
use crate::system::{Equations, SideBySide, StateVector};
use crate::tolerance::DEFECT;

/// The stages that only the interpolant needs, which follow the stage at the end.
const ROWS: [TableauRow; RATES - END - 1] = [
    STAGE_17.row(),
    STAGE_18.row(),
    STAGE_19.row(),
    STAGE_20.row(),
    STAGE_21.row(),
    STAGE_22.row(),
    STAGE_23.row(),
    STAGE_24.row(),
    STAGE_25.row(),
];
/// The fractions of steps at which defects are evaluated.
const PARTS: [FixedPart; CHECKED.len()] = [FixedPart::new(CHECKED[0]), FixedPart::new(CHECKED[1])];

/// The last steps by [`Verner98`](super::Verner98) in lanes.
#[derive(Clone, Copy, Debug)]
pub struct VernerLastStep<S, Y> {
    /// Start of the steps.
    pub(super) clock: Clock<S>,
    pub(super) state: Compensated<Y>,
    /// Their rates. If a step was not completed, its stage rates belong to an earlier one.
    rates: [Y; RATES],
}

/// The ends of steps of length `h`.
#[derive(Clone, Copy)]
pub(super) struct StepEnd<'r, S, Y> {
    pub(super) h: S,
    pub(super) t: S,
    pub(super) y: &'r Y,
}

impl<S: SideBySide<Element: Scalar>, Y: StateVector<S>> VernerLastStep<S, Y> {
    /// Creates an empty step at this state.
    #[inline(always)]
    pub(super) fn new(clock: Clock<S>, state: Compensated<Y>) -> Self {
        VernerLastStep { clock, state, rates: [Y::ZERO; RATES] }
    }

    /// Stores the start of steps.
    #[inline(always)]
    pub(super) fn begin(&mut self, clock: Clock<S>, state: Compensated<Y>) {
        (self.clock, self.state) = (clock, state);
    }

    /// Returns steps of length `h` from their start.
    #[inline(always)]
    fn span(&self, h: S) -> Span<S, Y> {
        Span { t: self.clock.time(), y: *self.state.value(), h }
    }

    /// Computes the rates that the interpolant needs from those of the stages. Returns the ratio of
    /// its error to the permitted error; at most one is accurate enough.
    #[inline(always)]
    pub(super) fn complete<E: Equations<S, State = Y>>(
        &mut self,
        equations: &E,
        stages: &[Y; STAGES],
        reached: StepEnd<'_, S, Y>,
        tolerated: &Tolerated<S>,
    ) -> S {
        self.rates[..STAGES].copy_from_slice(stages);
        let (span, rates) = (self.span(reached.h), &mut self.rates);
        let mut largest = S::ZERO;
        // A single call site, so that the right-hand side is inlined once.
        for stage in END..RATES + CHECKED.len() {
            let (time, point) = match stage {
                END => (reached.t, *reached.y),
                RATES.. => {
                    let part = &PARTS[stage - RATES];
                    (S::from_f64(part.s).multiply_add(span.h, span.t), part.state(&span, rates))
                }
                _ => {
                    let row = &ROWS[stage - END - 1];
                    (row.time(span.t, span.h), row.point(&span.y, span.h, rates))
                }
            };
            let rate = equations.rhs(time, &point);
            if stage < RATES {
                rates[stage] = rate;
            } else {
                let defect = PARTS[stage - RATES].defect(rate, rates);
                largest = largest.max(tolerated.norm(span.h, &defect, &span.y, reached.y));
            }
        }
        let rounding =
            S::splat(DEFECT.part::<S::Element>()) * tolerated.norm(span.h, &rates[0], &span.y, reached.y);
        largest / (S::from_f64(LARGEST_DEFECT) + rounding)
    }

    /// Computes the states at these times; exactly the ends at the end times.
    #[inline(always)]
    pub(super) fn interpolate(&self, reached: StepEnd<'_, S, Y>, t: S) -> Y {
        let span = self.span(reached.h);
        let within = interpolated(&span, (t - span.t) / span.h, &self.rates);
        chosen(is_equal(t, reached.t), reached.y, &within)
    }
}
