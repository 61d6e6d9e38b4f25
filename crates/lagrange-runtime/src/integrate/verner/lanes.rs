//! The pair for several motions in lanes.
//!
//! A step is the same as in `stepper` for a system without constraints, with two differences. Rates
//! are not reused by the next attempt, since other lanes may have advanced. Lengths of steps are
//! computed to three digits. A motion that appears stiff is abandoned: a single run reports it.
//!
//! Both take nodes and weights from `tableau`. They stay two steppers because the stages of one
//! motion are written out there. A loop over the rows, as here, returns the same bits with 1.15 to
//! 1.9 times the instructions. It takes 8 to 10 % longer for two to four numbers in a state. In
//! lanes, fifteen copies of the equations would be too large.

use super::Verner98;
use super::control::POWER;
use super::lanes_control::LanesControl;
use super::lanes_dense::{StepEnd, VernerLastStep};
use super::stage::{STAGES, Stage};
use super::stiffness::is_at_limit;
use super::tableau::{
    ADVANCE, ERROR, STAGE_1, STAGE_2, STAGE_3, STAGE_4, STAGE_5, STAGE_6, STAGE_7, STAGE_8, STAGE_9,
    STAGE_10, STAGE_11, STAGE_12, STAGE_13, STAGE_14, STAGE_15,
};
use super::tolerance::Tolerated;
use crate::integrate::clock::{Clock, least_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::explicit::TableauRow;
use crate::integrate::lane_wise::{Counts, are_finite, is_equal};
use crate::integrate::method::{LanesMethod, LanesStepper, MAX_LANES, Work};
use crate::integrate::stiffness::{Stiffness, are_many};
use crate::linalg::vector::combined;
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{Domain, Equations, SideBySide, StateVector};
use crate::tolerance::SAME_STATE;

/// Number of rates needed for the choice of a first step.
const FIRST_STAGES: u64 = 2;

/// Integrations by [`Verner98`] in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct VernerLanes<S, Y> {
    settings: Settings<S>,
    clock: Clock<S>,
    state: Compensated<Y>,
    control: LanesControl<S>,
    /// Maximum length of the next step.
    longest: S,
    /// Lengths of the last attempted steps, and their rates.
    h: S,
    rates: [Y; STAGES],
    counts: Counts,
    stiffness: [Stiffness; MAX_LANES],
}

/// The settings common to all lanes.
#[derive(Clone, Copy, Debug)]
struct Settings<S> {
    tolerated: Tolerated<S>,
    end: S,
    /// The length of the first step, if it is set.
    first: Option<S>,
    /// Maximum step lengths of a moving state, and of a state at rest.
    longest: [S; 2],
    most_steps: u64,
    refuses_stiff: bool,
}

impl<T: Scalar> LanesMethod<T> for Verner98<T> {
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>> = VernerLanes<S, E::State>;

    #[inline(always)]
    fn empty_lanes<S, E>(&self, [t, end]: [T; 2], domain: &'static Domain) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        let Tolerated { relative, absolute, domain } = self.tolerated(domain);
        let settings = Settings {
            tolerated: Tolerated { relative: S::splat(relative), absolute: S::splat(absolute), domain },
            end: S::splat(end),
            first: self.first_step.map(S::splat),
            longest: [false, true].map(|is_at_rest| S::splat(self.longest(end - t, is_at_rest))),
            most_steps: self.max_steps,
            refuses_stiff: self.refuses_stiff,
        };
        VernerLanes {
            settings,
            clock: Clock::new(S::splat(t), S::ZERO),
            state: Compensated::new(E::State::ZERO),
            control: LanesControl::new(S::ZERO),
            longest: S::ZERO,
            h: S::ZERO,
            rates: [E::State::ZERO; STAGES],
            counts: Counts::new(),
            stiffness: [Stiffness::default(); MAX_LANES],
        }
    }

    #[inline(always)]
    fn take<S, E, O, F>(
        stepper: &mut Self::Stepper<S, E>,
        lane: usize,
        other: &Self::Stepper<O, F>,
        from: usize,
    ) where
        S: SideBySide<Element = T>,
        E: Equations<S>,
        O: SideBySide<Element = T>,
        F: Equations<O>,
    {
        stepper.clock.take(lane, &other.clock, from);
        stepper.state.take(lane, &other.state, from);
        stepper.control.take(lane, &other.control, from);
        stepper.longest.set_lane(lane, other.longest.lane(from));
        stepper.counts.take(lane, &other.counts, from);
        stepper.stiffness[lane] = other.stiffness[from];
    }
}

impl<S: Number> Settings<S> {
    /// Returns the maximum step lengths of moving states and of states at rest.
    #[inline(always)]
    fn longest(&self, is_at_rest: S::Mask) -> S {
        let [moving, at_rest] = self.longest;
        S::select(is_at_rest, at_rest, moving)
    }

    /// Returns first steps, NaN if there is none, and the maximum step lengths.
    #[inline(always)]
    fn first_step<E: Equations<S>>(&self, equations: &E, t: S, y: &E::State) -> (S, S) {
        let [_, at_rest] = self.longest;
        let (mut rates, mut trial, mut longest) = ([E::State::ZERO; 2], S::ZERO, at_rest);
        // A single call site, so that the right-hand side is inlined once.
        for stage in 0..2 {
            let h = S::select(self.end.less(t), -trial, trial);
            rates[stage] = equations.rhs(t + h, &combined(y, h, &rates[0]));
            if stage == 0 {
                longest = self.longest(self.tolerated.is_at_rest(at_rest, &rates[0], y));
                trial = self.tolerated.trial(y, &rates[0], longest);
            }
        }
        let [rate, ahead] = &rates;
        (self.tolerated.first_step(y, [rate, ahead], trial, (longest, POWER)), longest)
    }
}

/// The stages of a step.
pub(super) const ROWS: [TableauRow; STAGES] = [
    START.row(),
    STAGE_1.row(),
    STAGE_2.row(),
    STAGE_3.row(),
    STAGE_4.row(),
    STAGE_5.row(),
    STAGE_6.row(),
    STAGE_7.row(),
    STAGE_8.row(),
    STAGE_9.row(),
    STAGE_10.row(),
    STAGE_11.row(),
    STAGE_12.row(),
    STAGE_13.row(),
    STAGE_14.row(),
    STAGE_15.row(),
];
/// The start of a step.
const START: Stage<0> = Stage { node: 0.0, weights: [] };

impl<S, Y> VernerLanes<S, Y>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// Evaluates the stages of steps of these lengths.
    #[inline(always)]
    fn evaluate<E: Equations<S, State = Y>>(&mut self, equations: &E, h: S) {
        let (t, y) = (self.clock.time(), *self.state.value());
        // A single call site, as above.
        for (stage, row) in ROWS.iter().enumerate() {
            let point = row.point(&y, h, &self.rates);
            self.rates[stage] = equations.rhs(row.time(t, h), &point);
        }
    }

    /// Computes the states after steps of these lengths, whose stages are known.
    #[inline(always)]
    fn advanced(&self, h: S, increment: &Y) -> Compensated<Y> {
        let mut increment = *increment;
        for component in increment.as_mut() {
            *component = *component * h;
        }
        let mut state = self.state;
        state.add(&increment);
        state
    }

    /// Returns the motions that appear stiff, given the lengths of the last steps, the states
    /// before them, and the lanes in which they were accepted.
    #[cold]
    #[inline(never)]
    fn look_stiff(&mut self, h: S, before: &Y, is_taken: S::Mask) -> [bool; MAX_LANES] {
        let ends = [14, 15].map(|stage: usize| ROWS[stage].point(before, h, &self.rates));
        let lengths = (h, self.settings.end - self.clock.time());
        let rounding = S::splat(SAME_STATE.part::<S::Element>());
        let [one, other] = [(&ends[0], &self.rates[14]), (&ends[1], &self.rates[15])];
        let is_at_limit = is_at_limit(lengths, one, other, rounding);
        let mut look_stiff = [false; MAX_LANES];
        for (lane, looks_stiff) in look_stiff.iter_mut().enumerate().take(S::LANES) {
            let stiffness = &mut self.stiffness[lane];
            if is_taken.lane(lane) && stiffness.is_due(self.counts.taken(lane) - 1) {
                *looks_stiff = stiffness.count(is_at_limit.lane(lane));
            }
        }
        look_stiff
    }

    /// Returns the ends of the last steps, in lanes in which they were accepted.
    #[inline(always)]
    fn reached(&self) -> StepEnd<'_, S, Y> {
        StepEnd { h: self.h, t: self.clock.time(), y: self.state.value() }
    }

    /// Reverts steps that were too long for the interpolant, with this excess of its error.
    #[cold]
    fn take_back(&mut self, last: &VernerLastStep<S, Y>, excess: S, are_refused: S::Mask) {
        self.clock = Clock::select(are_refused, &last.clock, &self.clock);
        self.state = Compensated::select(are_refused, &last.state, &self.state);
        self.control.take_back(self.h.abs(), excess, are_refused);
        for lane in 0..S::LANES {
            if are_refused.lane(lane) {
                self.counts.take_back(lane);
            }
        }
    }

    /// Abandons motions.
    #[cold]
    fn give_up(&mut self, which: impl Fn(&Self, usize) -> bool) {
        for lane in 0..S::LANES {
            if which(self, lane) {
                self.clock.set_time(lane, S::Element::NAN);
            }
        }
    }
}

impl<S, E> LanesStepper<S, E> for VernerLanes<S, E::State>
where
    S: SideBySide<Element: Scalar>,
    E: Equations<S>,
{
    type LastStep = VernerLastStep<S, E::State>;

    type Workspace = ();

    #[inline(always)]
    fn workspace() {}

    #[inline(always)]
    fn start(&mut self, equations: &E, y: &E::State) {
        let (step, longest) = self.settings.first_step(equations, self.clock.time(), y);
        self.control = LanesControl::new(self.settings.first.unwrap_or(step));
        self.longest = longest;
        self.state = Compensated::new(*y);
    }

    #[inline(always)]
    fn last_step(&self) -> Self::LastStep {
        VernerLastStep::new(self.clock, self.state)
    }

    #[inline(always)]
    fn begin(&self, last: &mut Self::LastStep) {
        last.begin(self.clock, self.state);
    }

    #[inline(always)]
    fn step(&mut self, equations: &E, (): &mut ()) {
        let Settings { tolerated, end, most_steps, refuses_stiff, .. } = self.settings;
        let (t, y) = (self.clock.time(), *self.state.value());
        let length = self.control.step.min(self.longest);
        let mut clock = self.clock.with_step(length);
        let h = clock.advance(end);
        let is_lost_in_time =
            (length.less(least_step(t)) | self.clock.is_stopped(&clock)) & !is_equal(t, end);
        let is_lost = is_lost_in_time | !S::ZERO.less(length);

        self.evaluate(equations, h);
        let increment = ADVANCE.weighted(&self.rates);
        let state = self.advanced(h, &increment);
        let error = tolerated.norm(h, &ERROR.weighted(&self.rates), &y, state.value());
        let error = S::select(are_finite(state.value()), error, S::NAN);
        let is_taken = error.less_equal(S::ONE);

        self.h = h;
        self.control.follow(h.abs(), error, is_taken);
        let longest = self.settings.longest(tolerated.is_at_rest(h, &increment, &y));
        self.longest = S::select(is_taken, longest, self.longest);
        self.clock = Clock::select(is_taken, &clock, &self.clock);
        self.state = Compensated::select(is_taken, &state, &self.state);
        let are_spent = self.counts.count::<S>(is_taken, most_steps);
        if are_spent || is_lost.any() {
            self.give_up(|motions, lane| motions.counts.tried(lane) > most_steps || is_lost.lane(lane));
        }
        if refuses_stiff && (is_taken & are_many((h, end - self.clock.time()))).any() {
            let look_stiff = self.look_stiff(h, &y, is_taken);
            self.give_up(|_, lane| look_stiff[lane]);
        }
    }

    #[inline(always)]
    fn confirm(&mut self, equations: &E, last: &mut Self::LastStep, asked: S::Mask) {
        let excess = last.complete(equations, &self.rates, self.reached(), &self.settings.tolerated);
        let are_refused = asked & !excess.less_equal(S::ONE);
        if are_refused.any() {
            self.take_back(last, excess, are_refused);
        }
    }

    #[inline(always)]
    fn interpolate(&self, (): &(), last: &Self::LastStep, t: S) -> E::State {
        last.interpolate(self.reached(), t)
    }

    #[inline(always)]
    fn time(&self) -> S {
        self.clock.time()
    }

    #[inline(always)]
    fn state(&self) -> &E::State {
        self.state.value()
    }

    fn limit_steps(&mut self, most: u64) {
        self.settings.most_steps = self.settings.most_steps.min(most);
    }

    fn work(&self, lane: usize) -> Work {
        let (steps, tried) = (self.counts.taken(lane), self.counts.tried(lane));
        let evaluations = FIRST_STAGES + tried * STAGES as u64;
        Work { steps, rejections: tried - steps, evaluations, ..Work::default() }
    }
}
