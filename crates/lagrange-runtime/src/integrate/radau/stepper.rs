//! The method in progress.

mod equations;

use self::equations::goal;
use super::Radau5;
use super::control::{POWER, ReuseControl};
use super::dense::StepTaken;
use super::linear::LinearSystem;
use super::newton::{NewtonOutcome, StageChanges, StageFactors};
use super::tableau::STAGES;
use crate::integrate::attempt::{Attempt, Crawling, Judgement};
use crate::integrate::clock::Clock;
use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted, check_finite, correct, corrected};
use crate::integrate::method::{Stepper, Work};
use crate::integrate::verner::tolerance::{Tolerated, longest_step};
use crate::linalg::vector::{add, difference};
use crate::scalar::Number;
use crate::system::{OdeSystem, StateVector, StepFailure};

/// The Jacobian is evaluated again if corrections decrease by less than this ratio in more than two
/// iterations.
const SLOW: f64 = 1e-3;

/// An integration by [`Radau5`] in progress.
#[derive(Clone, Debug)]
pub struct RadauStepper<M: OdeSystem + ?Sized> {
    settings: Radau5<M::Scalar>,
    /// The tolerances of estimates and of the remainder of Newton's method.
    estimated: Tolerated<M::Scalar>,
    goal: M::Scalar,
    /// The interval from the start to the end known at the start.
    span: M::Scalar,
    control: ReuseControl<M::Scalar>,
    clock: Clock<M::Scalar>,
    state: Compensated<M::State>,
    /// Clock and state before the last step.
    before: (Clock<M::Scalar>, Compensated<M::State>),
    is_at_rest: bool,
    /// The Jacobian; `None` before the first evaluation.
    linearised: Option<LinearSystem<M::Scalar, M::State>>,
    /// True if the Jacobian belongs to the present state.
    is_fresh: bool,
    /// True if it must be evaluated before the next step.
    is_due: bool,
    factors: Option<StageFactors<M::Scalar, M::State>>,
    /// The expected sum of further corrections, relative to the last one.
    remainder: M::Scalar,
    /// The last step, and the index of its end that is the present state; zero if it was reverted.
    last: StepTaken<M::Scalar, M::State>,
    end: usize,
    crawling: Crawling<M::Scalar>,
    work: Work,
}

/// The state after a step, and the step.
type Advanced<M> =
    (Compensated<<M as OdeSystem>::State>, StepTaken<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>);

impl<M: OdeSystem + ?Sized> RadauStepper<M> {
    pub(super) fn start(
        settings: Radau5<M::Scalar>,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        check_finite(end, y)?;
        let (clock, state) = (Clock::new(t, M::Scalar::ZERO), Compensated::new(*y));
        let estimated = settings.estimated(system.domain());
        let mut stepper = RadauStepper {
            settings,
            estimated,
            goal: goal(&estimated),
            span: end - t,
            control: ReuseControl::new(M::Scalar::ZERO),
            clock,
            state,
            before: (clock, state),
            is_at_rest: false,
            linearised: None,
            is_fresh: false,
            is_due: true,
            factors: None,
            remainder: M::Scalar::ONE,
            last: StepTaken::none(t, *y, y.zeros()),
            end: 1,
            crawling: Crawling::new(t),
            work: Work::default(),
        };
        stepper.restart(system, t, y)?;
        Ok(stepper)
    }

    /// Returns the rate at the present state.
    fn rate(&self) -> &M::State {
        &self.last.rates[self.end]
    }

    /// Returns the maximum step length from the present state.
    fn longest(&self) -> M::Scalar {
        longest_step(self.settings.longest_step, self.span, self.is_at_rest)
    }

    /// Returns the next step to try; an error if it is lost in rounding.
    fn next(&self, limit: M::Scalar) -> Result<Attempt<M::Scalar>, StepFailure<M::Scalar>> {
        let length = self.control.step.min(self.longest());
        Attempt::new(&self.clock, length, limit, self.settings.longest_step, self.control.was_rejected())
    }

    /// Tries a step.
    fn attempt(&mut self, system: &M, Attempt { h, clock }: Attempt<M::Scalar>) -> Judgement<M::Scalar> {
        let (stages, convergence) = match self.solve(system, h) {
            Ok(solved) => solved,
            Err(cause) => return self.retreat(h, cause),
        };
        let error = self.error(system, h, &stages);
        let is_accurate = error <= M::Scalar::ONE;
        if !is_accurate {
            self.control.reject(h.abs(), error, convergence.iterations);
            self.work.rejections += 1;
            return Judgement::Inaccurate;
        }
        match self.advanced(system, (h, &clock), stages) {
            Ok((state, span)) => self.accept((clock, state), span, error, &convergence),
            Err(cause) => return self.retreat(h, cause),
        }
        Judgement::Taken
    }

    /// Computes the step and the state after it, on the constraints.
    fn advanced(
        &self,
        system: &M,
        (h, clock): (M::Scalar, &Clock<M::Scalar>),
        stages: StageChanges<M::State>,
    ) -> Result<Advanced<M>, StepFailure<M::Scalar>> {
        let (mut state, mut change) = (self.state, stages[STAGES - 1]);
        state.add(&change);
        check_finite(clock.time(), state.value())?;
        let reached = *state.value();
        correct(system, clock.time(), &mut state)?;
        if system.is_constrained() {
            add(&mut change, M::Scalar::ONE, &difference(state.value(), &reached));
        }
        let rate = system.rhs(clock.time(), state.value());
        check_finite(clock.time(), &rate)?;
        let (ends, rates) = ([*self.state.value(), *state.value()], [*self.rate(), rate]);
        let slopes = [self.last.slopes[self.end]; 2];
        let mut span = StepTaken { t: self.clock.time(), h, ends, change, stages, rates, slopes };
        span.slopes[1] = span.end_slope();
        Ok((state, span))
    }

    /// Continues from the end of a step.
    fn accept(
        &mut self,
        (clock, state): (Clock<M::Scalar>, Compensated<M::State>),
        span: StepTaken<M::Scalar, M::State>,
        error: M::Scalar,
        convergence: &NewtonOutcome<M::Scalar>,
    ) {
        self.work.steps += 1;
        self.work.evaluations += 1;
        self.control.accept(span.h.abs(), error, convergence.iterations);
        let is_slow = convergence.rate.is_some_and(|rate| rate > M::Scalar::from_f64(SLOW));
        self.is_due = convergence.iterations > 2 && is_slow;
        self.is_fresh = false;
        self.is_at_rest = self.estimated.is_at_rest(M::Scalar::ONE, &span.change, &span.ends[0]);
        self.before = (self.clock, self.state);
        (self.clock, self.state) = (clock, state);
        (self.last, self.end) = (span, 1);
    }

    /// Rejects a step of length `h` that could not be computed.
    fn retreat(&mut self, h: M::Scalar, cause: StepFailure<M::Scalar>) -> Judgement<M::Scalar> {
        self.control.retreat(h.abs());
        self.work.rejections += 1;
        Judgement::Lost(cause)
    }
}

impl<M: OdeSystem + ?Sized> Stepper<M> for RadauStepper<M> {
    fn time(&self) -> M::Scalar {
        self.clock.time()
    }

    fn state(&self) -> &M::State {
        self.state.value()
    }

    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        self.crawling.check()?;
        let mut lost = None;
        loop {
            if self.work.steps + self.work.rejections >= self.settings.max_steps {
                return Err(StepFailure::TooManySteps { limit: self.settings.max_steps });
            }
            let attempt = self.next(limit).map_err(|underflow| lost.unwrap_or(underflow))?;
            lost = match self.attempt(system, attempt) {
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
        match &self.linearised {
            Some(linearised) if t != self.last.t => {
                let s = (t - self.last.t) / self.last.h;
                corrected(system, t, self.last.state(linearised.positions(), s))
            }
            _ => self.last.ends[0],
        }
    }

    fn confirm(&mut self, system: &M) -> bool {
        let span = self.last;
        if span.h == M::Scalar::ZERO || self.excess(system, &span) <= M::Scalar::ONE {
            return true;
        }
        let smooth = span.smooth();
        let excess = self.excess(system, &smooth);
        if excess <= M::Scalar::ONE {
            self.last = smooth;
            return true;
        }
        (self.clock, self.state) = self.before;
        (self.end, self.is_due) = (0, false);
        self.control.reject(span.h.abs(), excess, 1);
        self.work.steps -= 1;
        self.work.rejections += 1;
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
        self.is_at_rest = true;
        self.is_at_rest = self.estimated.is_at_rest(self.longest(), &rate, y);
        let step = match self.settings.first_step {
            Some(first) => first,
            None if self.span == M::Scalar::ZERO => M::Scalar::ZERO,
            None => {
                self.work.evaluations += 1;
                let bounds = (self.longest(), self.span < M::Scalar::ZERO);
                self.estimated.first_step_of(system, (t, y), &rate, bounds, POWER)?
            }
        };
        self.control = ReuseControl::new(step);
        self.clock = Clock::new(t, M::Scalar::ZERO);
        self.state = Compensated::new(*y);
        (self.last, self.end) = (StepTaken::none(t, *y, rate), 1);
        (self.is_due, self.remainder) = (true, M::Scalar::ONE);
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}
