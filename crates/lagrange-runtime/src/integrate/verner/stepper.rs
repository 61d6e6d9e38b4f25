//! The pair in progress.

use super::Verner98;
use super::control::{Control, POWER};
use super::dense::{Span, complete, defect, interpolate};
use super::stage::RATES;
use super::stiffness::{is_at_limit, stability};
use super::tableau::{
    ADVANCE, ERROR, STAGE_1, STAGE_2, STAGE_3, STAGE_4, STAGE_5, STAGE_6, STAGE_7, STAGE_8, STAGE_9,
    STAGE_10, STAGE_11, STAGE_12, STAGE_13, STAGE_14, STAGE_15,
};
use crate::integrate::attempt::{Attempt, Crawling, Judgement};
use crate::integrate::clock::Clock;
use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted, check_finite, correct, corrected};
use crate::integrate::method::{Stepper, Work};
use crate::integrate::stiffness::{LimitedStep, StiffnessTest};
use crate::linalg::vector::{combined, l1_distance};
use crate::scalar::Number;
use crate::system::{OdeSystem, StateVector, StepFailure};
use crate::tolerance::{DEFECT, SAME_STATE};

/// The parts of a step at which the defect of the interpolant is evaluated. They are the middle of
/// the widest gap between stages, and near the end, where the defect of smooth motions is large.
pub(super) const CHECKED: [f64; 2] = [0.34, 0.94];
/// The interpolant is rejected if its defect times the step exceeds this times the tolerance. For
/// smooth motions the defect at the places above is a third to a half of the estimated error of the
/// step. The error within the step is smaller.
pub(super) const LARGEST_DEFECT: f64 = 2.0;
/// Index of the rate at the end of a step, which starts the next one.
pub(super) const END: usize = 16;

/// An integration by [`Verner98`] in progress.
#[derive(Clone, Debug)]
pub struct VernerStepper<M: OdeSystem + ?Sized> {
    settings: Verner98<M::Scalar>,
    /// The interval from the start to the end known at the start.
    span: M::Scalar,
    control: Control<M::Scalar>,
    stiffness: StiffnessTest<M::Scalar>,
    clock: Clock<M::Scalar>,
    state: Compensated<M::State>,
    /// Clock and state before the last step.
    before: (Clock<M::Scalar>, Compensated<M::State>),
    is_at_rest: bool,
    /// The last step, and its rates.
    last: Span<M::Scalar, M::State>,
    rates: [M::State; RATES],
    /// Number of known rates of the last step.
    known: Known,
    crawling: Crawling<M::Scalar>,
    work: Work,
}

/// The known rates of the last step.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Known {
    /// Only rates of the stages.
    Stages,
    /// Also the rate at its end.
    End,
    /// Also the rates for the interpolant.
    All,
}

impl<M: OdeSystem + ?Sized> VernerStepper<M> {
    pub(super) fn start(
        settings: Verner98<M::Scalar>,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        check_finite(end, y)?;
        let (clock, state) = (Clock::new(t, M::Scalar::ZERO), Compensated::new(*y));
        let mut stepper = VernerStepper {
            settings,
            span: end - t,
            control: Control::new(M::Scalar::ZERO),
            stiffness: StiffnessTest::new(),
            clock,
            state,
            before: (clock, state),
            is_at_rest: false,
            last: Span { t, y: *y, h: M::Scalar::ZERO },
            rates: [y.zeros(); RATES],
            known: Known::End,
            crawling: Crawling::new(t),
            work: Work::default(),
        };
        stepper.restart(system, t, y)?;
        Ok(stepper)
    }

    /// Returns the next step to try; an error if it is lost in rounding.
    fn next(&self, limit: M::Scalar) -> Result<Attempt<M::Scalar>, StepFailure<M::Scalar>> {
        let length = self.control.step.min(self.settings.longest(self.span, self.is_at_rest));
        let (longest, was_rejected) = (self.settings.longest_step, self.control.was_rejected());
        Attempt::new(&self.clock, length, limit, longest, was_rejected)
    }

    /// Evaluates the stages of a step and returns the last two of them, which lie at its end.
    #[inline(always)]
    fn stages(&mut self, system: &M, y: &M::State, h: M::Scalar) -> [M::State; 2] {
        let t = self.clock.time();
        let rates = &mut self.rates;
        macro_rules! rate {
            ($($index:literal: $stage:ident),*) => {
                $( rates[$index] = system.rhs($stage.time(t, h), &$stage.point(y, h, rates)); )*
            };
        }
        rate!(
            1: STAGE_1, 2: STAGE_2, 3: STAGE_3, 4: STAGE_4, 5: STAGE_5, 6: STAGE_6, 7: STAGE_7, 8: STAGE_8,
            9: STAGE_9, 10: STAGE_10, 11: STAGE_11, 12: STAGE_12, 13: STAGE_13
        );
        let end = STAGE_14.point(y, h, rates);
        rates[14] = system.rhs(STAGE_14.time(t, h), &end);
        let other_end = STAGE_15.point(y, h, rates);
        rates[15] = system.rhs(STAGE_15.time(t, h), &other_end);
        self.work.evaluations += 15;
        [end, other_end]
    }

    /// Returns the rate at the end of the last step, computing it if necessary.
    fn end_rate(&mut self, system: &M) -> M::State {
        if self.known < Known::End {
            self.rates[END] = system.rhs(self.clock.time(), self.state.value());
            self.known = Known::End;
            self.work.evaluations += 1;
        }
        self.rates[END]
    }

    /// Computes the rates that the interpolant needs, unless they are known.
    fn complete(&mut self, system: &M) {
        if self.known < Known::All {
            self.end_rate(system);
            complete(system, &self.last, &mut self.rates);
            self.known = Known::All;
            self.work.evaluations += 9;
        }
    }

    /// Returns the error of the interpolant of the last step relative to the tolerance; at most one
    /// is accurate enough.
    fn excess(&self, system: &M) -> M::Scalar {
        let Span { y, h, .. } = &self.last;
        let tolerated = self.settings.tolerated(system.domain());
        let norm = |error: &M::State| tolerated.norm(*h, error, y, self.state.value());
        let rounding = DEFECT.part::<M::Scalar>() * norm(&self.rates[0]);
        let mut largest = M::Scalar::ZERO;
        for s in CHECKED {
            let defect = defect(system, &self.last, M::Scalar::from_f64(s), &self.rates);
            largest = largest.max(norm(&defect));
        }
        largest / (M::Scalar::from_f64(LARGEST_DEFECT) + rounding)
    }

    /// Discards the last step, whose rates are about to be overwritten.
    fn forget_last(&mut self) {
        let t = self.clock.time();
        self.last = Span { t, y: *self.state.value(), h: M::Scalar::ZERO };
    }

    /// Tries a step towards `limit`.
    fn attempt(
        &mut self,
        system: &M,
        Attempt { h, clock }: Attempt<M::Scalar>,
        limit: M::Scalar,
    ) -> Result<Judgement<M::Scalar>, StepFailure<M::Scalar>> {
        let y = *self.state.value();
        let ends = self.stages(system, &y, h);
        let mut state = self.advanced(h);
        let tolerated = self.settings.tolerated(system.domain());
        let error = tolerated.norm(h, &ERROR.weighted(&self.rates), &y, state.value());
        let is_finite = check_finite(clock.time(), state.value()).is_ok();
        if !(error <= M::Scalar::ONE && is_finite) {
            return Ok(self.reject(h, if is_finite { error } else { M::Scalar::NAN }));
        }
        if let Err(cause) = correct(system, clock.time(), &mut state) {
            self.reject(h, M::Scalar::NAN);
            return Ok(Judgement::Lost(cause));
        }
        if self.settings.refuses_stiff && self.stiffness.is_due(self.work.steps) {
            self.refuse_stiff(system, (h, limit - clock.time()), &ends)?;
        }
        self.work.steps += 1;
        self.control.accept(h.abs(), error);
        self.last = Span { t: self.clock.time(), y, h };
        self.is_at_rest = tolerated.is_at_rest(h, &ADVANCE.weighted(&self.rates), &y);
        self.before = (self.clock, self.state);
        (self.clock, self.state, self.known) = (clock, state, Known::Stages);
        Ok(Judgement::Taken)
    }

    /// Rejects a step of length `h` with this error.
    fn reject(&mut self, h: M::Scalar, error: M::Scalar) -> Judgement<M::Scalar> {
        self.control.reject(h.abs(), error);
        self.work.rejections += 1;
        match check_finite(h, &self.rates[15]) {
            Ok(()) => Judgement::Inaccurate,
            Err(cause) => Judgement::Lost(cause),
        }
    }

    /// Stops with an error if stability limits steps of length `h`, given the remaining time. Two
    /// stages lie at the end of the step; their states `ends` differ in the direction of fastest
    /// growth.
    fn refuse_stiff(
        &mut self,
        system: &M,
        (h, ahead): (M::Scalar, M::Scalar),
        ends: &[M::State; 2],
    ) -> Result<(), StepFailure<M::Scalar>> {
        let [one, other] = [(&ends[0], &self.rates[14]), (&ends[1], &self.rates[15])];
        if !self.stiffness.count(is_at_limit((h, ahead), one, other, SAME_STATE.part::<M::Scalar>())) {
            return Ok(());
        }
        let step = LimitedStep {
            t: self.clock.time(),
            h,
            point: one,
            direction: combined(&ends[0], -M::Scalar::ONE, &ends[1]),
            change: l1_distance(self.state.value(), &ends[0]),
        };
        let tolerance = self.settings.relative.max(self.settings.absolute);
        self.stiffness.refuse(system, step, (stability(), tolerance), &mut self.work)
    }

    /// Computes the state after a step of length `h`, whose stages are known.
    fn advanced(&self, h: M::Scalar) -> Compensated<M::State> {
        let mut increment = ADVANCE.weighted(&self.rates);
        for component in increment.as_mut() {
            *component = *component * h;
        }
        let mut state = self.state;
        state.add(&increment);
        state
    }
}

impl<M: OdeSystem + ?Sized> Stepper<M> for VernerStepper<M> {
    fn time(&self) -> M::Scalar {
        self.clock.time()
    }

    fn state(&self) -> &M::State {
        self.state.value()
    }

    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        self.crawling.check()?;
        self.rates[0] = self.end_rate(system);
        self.forget_last();
        let mut lost = None;
        loop {
            if self.work.steps + self.work.rejections >= self.settings.max_steps {
                return Err(StepFailure::TooManySteps { limit: self.settings.max_steps });
            }
            let attempt = self.next(limit).map_err(|underflow| lost.unwrap_or(underflow))?;
            lost = match self.attempt(system, attempt, limit)? {
                Judgement::Taken => {
                    self.crawling.look(attempt.h, self.clock.time(), system.is_constrained());
                    return Ok(());
                }
                Judgement::Inaccurate => None,
                Judgement::Lost(cause) => Some(cause),
            };
        }
    }

    fn last_time(&self) -> M::Scalar {
        self.last.t
    }

    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State {
        if t == self.clock.time() {
            return *self.state.value();
        }
        if t == self.last.t {
            return self.last.y;
        }
        self.complete(system);
        corrected(system, t, interpolate(&self.last, (t - self.last.t) / self.last.h, &self.rates))
    }

    fn confirm(&mut self, system: &M) -> bool {
        let h = self.last.h;
        if h == M::Scalar::ZERO {
            return true;
        }
        self.complete(system);
        let excess = self.excess(system);
        self.work.evaluations += CHECKED.len() as u64;
        if excess <= M::Scalar::ONE {
            return true;
        }
        (self.clock, self.state) = self.before;
        (self.rates[END], self.known) = (self.rates[0], Known::End);
        self.forget_last();
        self.work.steps -= 1;
        self.reject(h, excess);
        false
    }

    fn limit_steps(&mut self, most: u64) {
        self.settings.max_steps = self.settings.max_steps.min(most);
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        let y = &admitted(system, t, y)?;
        let rate = system.rhs(t, y);
        self.work.evaluations += 1;
        check_finite(t, &rate)?;
        let tolerated = self.settings.tolerated(system.domain());
        self.is_at_rest = tolerated.is_at_rest(self.settings.longest(self.span, true), &rate, y);
        let step = match self.settings.first_step {
            Some(first) => first,
            None if self.span == M::Scalar::ZERO => M::Scalar::ZERO,
            None => {
                self.work.evaluations += 1;
                let bounds = (self.settings.longest(self.span, self.is_at_rest), self.span < M::Scalar::ZERO);
                tolerated.first_step_of(system, (t, y), &rate, bounds, POWER)?
            }
        };
        self.control = Control::new(step);
        self.clock = Clock::new(t, M::Scalar::ZERO);
        self.state = Compensated::new(*y);
        self.forget_last();
        self.rates[END] = rate;
        self.known = Known::End;
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}
