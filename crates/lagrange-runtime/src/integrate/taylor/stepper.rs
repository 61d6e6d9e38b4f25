//! A motion followed along its Taylor series.

use super::Taylor;
use super::expansion::Expansion;
use super::rule::StepRule;
use super::stiffness::is_at_limit;
use super::widest::{WideTask, compute};
use crate::integrate::clock::{Clock, least_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted, check_finite, correct, corrected};
use crate::integrate::method::{Stepper, Work};
use crate::integrate::stiffness::{LimitedStep, StiffnessTest};
use crate::linalg::vector::{combined, l1_norm};
use crate::scalar::{Number, Scalar};
use crate::system::{MAX_ORDER, StateVector, StepFailure, TaylorSystem};
use crate::tolerance::SAME_STATE;

/// Message for rates that follow from another elimination than that of the series.
const NO_SERIES: &str = "the equations have no Taylor series here, since constraints depend on each other or a pivot of the \
                         mass matrix vanishes: choose `Verner98` (`verner`)";

/// An integration by [`Taylor`] series in progress.
#[derive(Clone, Debug)]
pub struct TaylorStepper<M: TaylorSystem + ?Sized> {
    rule: StepRule<M::Scalar>,
    max_steps: u64,
    clock: Clock<M::Scalar>,
    state: Compensated<M::State>,
    /// The expansion at the present state, and the expansion of the last step.
    expansions: [Expansion<M::Scalar, M::State>; 2],
    /// Index of the expansion at the present state.
    present: usize,
    series: M::Series,
    stiffness: StiffnessTest<M::Scalar>,
    work: Work,
}

/// The length of a step.
#[derive(Clone, Copy)]
struct StepLength<S> {
    length: S,
    /// True if it is as short as it can be and leads to another piece of a table, where rates may
    /// have jumped.
    is_across: bool,
    /// Number of further refusals because the series turns away from zero.
    turns_left: u32,
}

/// Shorter steps may not help where a component below what is tolerated turns by rounding.
const MAX_TURNS: u32 = 8;

/// The result of a step that was tried.
enum SeriesStep<S> {
    Taken,
    Rejected,
    /// A straight step of this length leads a component to zero, where the series turns away.
    Turned(S),
}

/// The expansion of a motion through a state.
struct Expand<'a, M: TaylorSystem + ?Sized> {
    system: &'a M,
    rule: &'a StepRule<M::Scalar>,
    series: &'a mut M::Series,
    expansion: &'a mut Expansion<M::Scalar, M::State>,
}

impl<M: TaylorSystem + ?Sized> WideTask for Expand<'_, M> {
    type Output = ();

    #[inline(always)]
    fn compute<const FUSED: bool>(self) {
        let Expand { system, rule, series, expansion } = self;
        let coefficients = &mut expansion.coefficients[..rule.order];
        system.expand::<FUSED>(expansion.t, &expansion.y, series, coefficients);
        expansion.follow(rule);
    }
}

impl<M: TaylorSystem + ?Sized> TaylorStepper<M> {
    pub(super) fn start(
        settings: Taylor<M::Scalar>,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        check_finite(end, y)?;
        let (order, length) = (settings.chosen_order(system.product_groups()), M::Scalar::ZERO);
        let expansion = Expansion { t, y: *y, order, length, coefficients: [M::State::ZERO; MAX_ORDER] };
        let mut stepper = TaylorStepper {
            rule: StepRule::new(&settings, order, end - t, system.domain()),
            max_steps: settings.max_steps,
            clock: Clock::new(t, M::Scalar::ZERO),
            state: Compensated::new(*y),
            expansions: [expansion; 2],
            present: 0,
            series: M::series(),
            stiffness: StiffnessTest::new(),
            work: Work::default(),
        };
        stepper.restart(system, t, y)?;
        Ok(stepper)
    }
}

impl<M: TaylorSystem + ?Sized> TaylorStepper<M> {
    /// Checks the rates of the present expansion, at this time and state.
    ///
    /// # Errors
    /// If they are not finite.
    fn check_rates(&self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        check_finite(t, &self.ahead().coefficients[0]).map_err(|cause| {
            match check_finite(t, &system.rhs(t, y)) {
                Ok(()) => StepFailure::Stuck(NO_SERIES),
                Err(_) => cause,
            }
        })
    }

    /// Returns the expansion at the present state.
    fn ahead(&self) -> &Expansion<M::Scalar, M::State> {
        &self.expansions[self.present]
    }

    /// Returns the expansion of the last step.
    fn last(&self) -> &Expansion<M::Scalar, M::State> {
        &self.expansions[1 - self.present]
    }

    /// Marks the present state as the end of no step.
    fn forget_last(&mut self) {
        let Expansion { t, y, .. } = *self.ahead();
        let last = &mut self.expansions[1 - self.present];
        (last.t, last.y) = (t, y);
    }

    /// Expands the motion about a state.
    fn expand(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        let present = &mut self.expansions[self.present];
        (present.t, present.y) = (t, *y);
        let task = Expand { system, rule: &self.rule, series: &mut self.series, expansion: present };
        compute(task, self.rule.fused);
        self.work.evaluations += 1;
    }

    /// Stops with an error if stability limits the next step towards `limit`.
    #[cold]
    #[inline(never)]
    fn refuse_stiff(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        let Some(stability) = self.rule.stability else { return Ok(()) };
        let Expansion { t, y, order, length: h, coefficients } = &self.expansions[self.present];
        let coefficients = &coefficients[..*order];
        let is_at_limit = is_at_limit(&stability, (*h, limit - *t), y, coefficients);
        if !self.stiffness.count(is_at_limit && *order == self.rule.order) {
            return Ok(());
        }
        let (rate, direction) = (&coefficients[0], coefficients[order - 1]);
        let step = LimitedStep { t: *t, h: *h, point: (y, rate), direction, change: *h * l1_norm(rate) };
        self.stiffness.refuse(system, step, (stability, self.rule.tolerance), &mut self.work)
    }

    /// Tries a step of this length.
    fn attempt(
        &mut self,
        system: &M,
        next: StepLength<M::Scalar>,
        limit: M::Scalar,
    ) -> Result<SeriesStep<M::Scalar>, StepFailure<M::Scalar>> {
        let mut clock = self.clock.with_step(next.length);
        let h = clock.advance(limit);
        if self.clock.is_stopped(&clock) {
            return Err(StepFailure::StepUnderflow { step: next.length });
        }
        self.follow(system, (clock, h), next)
    }

    /// Tries to follow the present expansion for a time `h`, after which the clock stands there.
    fn follow(
        &mut self,
        system: &M,
        (clock, h): (Clock<M::Scalar>, M::Scalar),
        StepLength { is_across, turns_left, .. }: StepLength<M::Scalar>,
    ) -> Result<SeriesStep<M::Scalar>, StepFailure<M::Scalar>> {
        let mut state = self.state;
        let [change, slope] = self.ahead().advance(&self.rule, h);
        state.add(&change);
        if self.ahead().is_straight() {
            state = landed(&self.state, &state);
        }
        check_finite(clock.time(), state.value())?;
        correct(system, clock.time(), &mut state)?;
        let y = *state.value();
        self.present = 1 - self.present;
        self.expand(system, clock.time(), &y);
        let rates = self.check_rates(system, clock.time(), &y);
        let mut outcome = SeriesStep::Rejected;
        if rates.is_ok() && (is_across || self.last().fits(&self.rule, h, &slope, self.ahead())) {
            match self.last().landing(&self.rule, h, &slope, self.ahead()) {
                Some(length) if turns_left > 0 => outcome = SeriesStep::Turned(length),
                _ => {
                    (self.clock, self.state) = (clock, state);
                    self.work.steps += 1;
                    return Ok(SeriesStep::Taken);
                }
            }
        }
        self.present = 1 - self.present;
        self.forget_last();
        rates.map(|()| outcome)
    }

    /// Tries a straight step of this length; true if it was taken.
    #[cold]
    fn land(&mut self, system: &M, length: M::Scalar, limit: M::Scalar) -> bool {
        let (t, y) = (self.clock.time(), *self.state.value());
        let least = least_step(t);
        let mut clock = self.clock.with_step(length.max(least + least));
        let h = clock.advance(limit);
        let rates = system.rhs(clock.time(), &combined(&y, h, &self.ahead().coefficients[0]));
        self.work.evaluations += 1;
        self.expansions[self.present].straighten(&self.rule, h, &rates);
        let step = StepLength { length, is_across: false, turns_left: 0 };
        let is_taken = matches!(self.follow(system, (clock, h), step), Ok(SeriesStep::Taken));
        if !is_taken {
            self.expand(system, t, &y);
        }
        is_taken
    }

    /// Returns the length of the next step: as far as the series is accurate and tables are the
    /// polynomials that it holds.
    fn length(&self, limit: M::Scalar) -> StepLength<M::Scalar> {
        let accurate = self.ahead().length;
        let h = if limit < self.clock.time() { -accurate } else { accurate };
        let (reach, least) = (M::reach(&self.series, h).abs(), least_step(self.clock.time()));
        let is_across = reach < accurate && reach <= least + least;
        StepLength { length: reach.max(least), is_across, turns_left: MAX_TURNS }
    }
}

/// Lets components be zero that a straight step has led there to rounding.
fn landed<S: Scalar, Y: StateVector<S>>(before: &Compensated<Y>, after: &Compensated<Y>) -> Compensated<Y> {
    let (mut value, mut remainder) = (*after.value(), *after.remainder());
    let components = value.as_mut().iter_mut().zip(remainder.as_mut());
    for ((value, remainder), before) in components.zip(before.value().as_ref()) {
        if value.abs() <= SAME_STATE.part::<S>() * before.abs() {
            (*value, *remainder) = (S::ZERO, S::ZERO);
        }
    }
    Compensated::with_remainder(value, remainder)
}

impl<M: TaylorSystem + ?Sized> Stepper<M> for TaylorStepper<M> {
    fn time(&self) -> M::Scalar {
        self.clock.time()
    }

    fn state(&self) -> &M::State {
        self.state.value()
    }

    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        if self.stiffness.is_due(self.work.steps) {
            self.refuse_stiff(system, limit)?;
        }
        let mut next = self.length(limit);
        let mut lost = None;
        loop {
            if self.work.steps + self.work.rejections >= self.max_steps {
                return Err(StepFailure::TooManySteps { limit: self.max_steps });
            }
            let is_step = next.length > M::Scalar::ZERO && next.length >= least_step(self.clock.time());
            if !is_step {
                return Err(lost.unwrap_or(StepFailure::StepUnderflow { step: next.length }));
            }
            match self.attempt(system, next, limit) {
                Ok(SeriesStep::Taken) => return Ok(()),
                Ok(SeriesStep::Turned(length)) if self.land(system, length, limit) => return Ok(()),
                Ok(SeriesStep::Turned(_)) => next.turns_left -= 1,
                Ok(SeriesStep::Rejected) => lost = None,
                Err(cause @ StepFailure::StepUnderflow { .. }) => return Err(lost.unwrap_or(cause)),
                Err(cause) => lost = Some(cause),
            }
            self.work.rejections += 1;
            let left = (limit - self.clock.time()).abs();
            next.length = next.length.min(left) * M::Scalar::from_f64(0.5);
        }
    }

    fn last_time(&self) -> M::Scalar {
        self.last().t
    }

    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State {
        if t == self.clock.time() {
            return *self.state.value();
        }
        if t == self.last().t {
            return self.last().y;
        }
        let change = self.last().change(&self.rule, t - self.last().t);
        let mut y = self.last().y;
        for (component, change) in y.as_mut().iter_mut().zip(change.as_ref()) {
            *component = *component + *change;
        }
        corrected(system, t, y)
    }

    fn limit_steps(&mut self, most: u64) {
        self.max_steps = self.max_steps.min(most);
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        let y = &admitted(system, t, y)?;
        self.expand(system, t, y);
        self.check_rates(system, t, y)?;
        self.clock = Clock::new(t, M::Scalar::ZERO);
        self.state = Compensated::new(*y);
        self.forget_last();
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}
