//! The method in progress.

use super::Radau5;
use super::control::{Control, POWER};
use super::dense::Span;
use super::linear::Linearised;
use super::newton::{Convergence, Equations, StageFactors, Stages, numbers, weighted};
use super::tableau::{ERROR, STAGES};
use crate::integrate::attempt::{Attempt, Crawling};
use crate::integrate::clock::Clock;
use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted, check_finite, correct, corrected};
use crate::integrate::jacobian::{differences, known, sizes};
use crate::integrate::method::{Stepper, Work};
use crate::integrate::newton::finite;
use crate::integrate::verner::tolerance::{Tolerated, longest_step};
use crate::linalg::vector::{add, combined, difference};
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, StateVector, StepFailure};

/// Newton iterations go on until this part of the tolerance is left of corrections, or its root,
const LARGEST_REMAINDER: f64 = 0.03;
/// but not below so many roundings.
const ROUNDINGS: f64 = 10.0;
/// The Jacobian is evaluated anew where corrections fall by less than this in more than two iterations.
const SLOW: f64 = 1e-3;
/// Factors for a step whose length differs by less than this are as good.
const SAME_LENGTH: f64 = 1e-6;
/// Parts of a step after which the defect of its interpolant is looked at: where it is large for cubic and for quintic ones.
const CHECKED: [f64; 2] = [0.2, 0.55];

/// An integration by [`Radau5`] in progress.
#[derive(Clone, Debug)]
pub struct RadauStepper<M: OdeSystem + ?Sized> {
    settings: Radau5<M::Scalar>,
    /// What is tolerated of estimates, and of what Newton's method leaves.
    estimated: Tolerated<M::Scalar>,
    goal: M::Scalar,
    /// From the start to the end that was in view there.
    span: M::Scalar,
    control: Control<M::Scalar>,
    clock: Clock<M::Scalar>,
    state: Compensated<M::State>,
    /// Clock and state before the last step.
    before: (Clock<M::Scalar>, Compensated<M::State>),
    is_at_rest: bool,
    /// The Jacobian, unless one is due.
    linearised: Option<Linearised<M::Scalar, M::State>>,
    /// True if the Jacobian is that of the present state.
    is_fresh: bool,
    /// True if it is to be evaluated before the next step.
    is_due: bool,
    factors: Option<StageFactors<M::Scalar, M::State>>,
    /// What followed the last correction of the last iterations, as a part of it.
    remainder: M::Scalar,
    /// The last step, and which of its ends the present state is: the first where it was taken back.
    last: Span<M::Scalar, M::State>,
    end: usize,
    crawling: Crawling<M::Scalar>,
    work: Work,
}

/// The judgement of an attempt.
enum Judgement<S> {
    /// The step was taken.
    Taken,
    /// Its error was too large.
    Inaccurate,
    /// It could not be computed, or led where the system is not defined, or where constraints cannot be satisfied.
    Lost(StepFailure<S>),
}

/// The changes at the stages of a step, and how they were found.
type Solved<M> = (Stages<<M as OdeSystem>::State>, Convergence<<M as OdeSystem>::Scalar>);

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
        let estimated = settings.estimated();
        let mut stepper = RadauStepper {
            settings,
            estimated,
            goal: goal(&estimated),
            span: end - t,
            control: Control::new(M::Scalar::ZERO),
            clock,
            state,
            before: (clock, state),
            is_at_rest: false,
            linearised: None,
            is_fresh: false,
            is_due: true,
            factors: None,
            remainder: M::Scalar::ONE,
            last: Span::none(t, *y, M::State::ZERO),
            end: 1,
            crawling: Crawling::new(t),
            work: Work::default(),
        };
        stepper.restart(system, t, y)?;
        Ok(stepper)
    }

    /// The rate at the present state.
    fn rate(&self) -> &M::State {
        &self.last.rates[self.end]
    }

    /// The longest step from the present state.
    fn longest(&self) -> M::Scalar {
        longest_step(self.settings.longest_step, self.span, self.is_at_rest)
    }

    /// The next step to try, or that it is lost in rounding.
    fn next(&self, limit: M::Scalar) -> Result<Attempt<M::Scalar>, StepFailure<M::Scalar>> {
        let length = self.control.step.min(self.longest());
        Attempt::new(&self.clock, length, limit, self.settings.longest_step, self.control.was_rejected())
    }

    /// Evaluates the Jacobian at the present state for steps of the length `h`.
    #[cold]
    fn linearise(&mut self, system: &M, h: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        let (t, y, rate) = (self.clock.time(), self.state.value(), &self.last.rates[self.end]);
        let jacobian = known(system, t, y, &mut self.work).unwrap_or_else(|| {
            let Tolerated { relative, absolute } = self.settings.tolerated();
            let sizes = sizes(y, h, rate, (absolute / relative).min(M::Scalar::ONE));
            differences(system, (t, y), rate, &sizes, &mut self.work)
        });
        if !finite(jacobian.0.as_ref()) {
            return Err(StepFailure::NotFinite);
        }
        self.linearised = Some(Linearised::new(jacobian));
        (self.is_fresh, self.is_due, self.factors) = (true, false, None);
        Ok(())
    }

    /// Solves the equations of a step of the length `h`.
    fn solve(&mut self, system: &M, h: M::Scalar) -> Result<Solved<M>, StepFailure<M::Scalar>> {
        if self.is_due {
            self.linearise(system, h)?;
        }
        let mut solved = self.iterate(system, h);
        if solved.is_err() && !self.is_fresh {
            self.linearise(system, h)?;
            solved = self.iterate(system, h);
        }
        solved
    }

    /// Iterates with the Jacobian as it is.
    fn iterate(&mut self, system: &M, h: M::Scalar) -> Result<Solved<M>, StepFailure<M::Scalar>> {
        let Some(linearised) = &self.linearised else { return Err(StepFailure::NotFinite) };
        let fits = |known: &StageFactors<M::Scalar, M::State>| {
            (known.h - h).abs() <= M::Scalar::from_f64(SAME_LENGTH) * h.abs()
        };
        let factors = match self.factors.take().filter(fits) {
            Some(factors) => factors,
            None => {
                self.work.factorisations += 1;
                StageFactors::new(linearised, h).ok_or(StepFailure::NotConverged { iterations: 0 })?
            }
        };
        let factors = self.factors.insert(factors);
        let mut stages = [M::State::ZERO; STAGES];
        if self.last.h != M::Scalar::ZERO {
            stages = self.last.continued(if self.end == 0 { M::Scalar::ZERO } else { M::Scalar::ONE }, h);
        }
        let y = self.state.value();
        let weights = weights(&self.estimated, y, &stages[STAGES - 1]);
        let (t, goal) = (self.clock.time(), self.goal);
        let equations = Equations { system, t, y, h, weights: &weights, goal };
        let root = self.remainder.max(M::Scalar::epsilon()).sqrt();
        let remainder = root * root.sqrt();
        let convergence = equations.solve(linearised, factors, &mut stages, remainder, &mut self.work)?;
        self.remainder = convergence.remainder;
        Ok((stages, convergence))
    }

    /// The estimated error of a step relative to the tolerance.
    fn error(&mut self, system: &M, h: M::Scalar, stages: &Stages<M::State>) -> M::Scalar {
        let (Some(linearised), Some(factors)) = (&self.linearised, &self.factors) else {
            return M::Scalar::NAN;
        };
        let y = self.state.value();
        let new = combined(y, M::Scalar::ONE, &stages[STAGES - 1]);
        let mut known = weighted(&numbers(&ERROR), stages);
        known.as_mut().iter_mut().for_each(|entry| *entry = *entry / h);
        let filtered =
            |rate: &M::State| factors.real.solve(linearised, &combined(rate, M::Scalar::ONE, &known));
        let norm = |error: &M::State| self.estimated.norm(M::Scalar::ONE, error, y, &new);
        let error = filtered(self.rate());
        let size = norm(&error);
        if size <= M::Scalar::ONE || !self.control.doubts() {
            return size;
        }
        self.work.evaluations += 1;
        norm(&filtered(&system.rhs(self.clock.time(), &combined(y, M::Scalar::ONE, &error))))
    }

    /// Tries a step.
    fn attempt(&mut self, system: &M, Attempt { h, clock }: Attempt<M::Scalar>) -> Judgement<M::Scalar> {
        let (stages, convergence) = match self.solve(system, h) {
            Ok(solved) => solved,
            Err(cause) => return self.retreat(h, cause),
        };
        let error = self.error(system, h, &stages);
        if !(error <= M::Scalar::ONE) {
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

    /// The state after a step, on the constraints, and the step.
    fn advanced(
        &self,
        system: &M,
        (h, clock): (M::Scalar, &Clock<M::Scalar>),
        stages: Stages<M::State>,
    ) -> Result<(Compensated<M::State>, Span<M::Scalar, M::State>), StepFailure<M::Scalar>> {
        let (mut state, mut change) = (self.state, stages[STAGES - 1]);
        state.add(&change);
        check_finite(clock.time(), state.value())?;
        let reached = *state.value();
        correct(system, clock.time(), &mut state)?;
        if M::IS_CONSTRAINED {
            add(&mut change, M::Scalar::ONE, &difference(state.value(), &reached));
        }
        let rate = system.rhs(clock.time(), state.value());
        check_finite(clock.time(), &rate)?;
        let (ends, rates) = ([*self.state.value(), *state.value()], [*self.rate(), rate]);
        let slopes = [self.last.slopes[self.end]; 2];
        let mut span = Span { t: self.clock.time(), h, ends, change, stages, rates, slopes };
        span.slopes[1] = span.end_slope();
        Ok((state, span))
    }

    /// Goes on from the end of a step.
    fn accept(
        &mut self,
        (clock, state): (Clock<M::Scalar>, Compensated<M::State>),
        span: Span<M::Scalar, M::State>,
        error: M::Scalar,
        convergence: &Convergence<M::Scalar>,
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

    /// Throws a step of the length `h` away that could not be computed.
    fn retreat(&mut self, h: M::Scalar, cause: StepFailure<M::Scalar>) -> Judgement<M::Scalar> {
        self.control.retreat(h.abs());
        self.work.rejections += 1;
        Judgement::Lost(cause)
    }

    /// The error of an interpolant of the last step relative to the tolerance; one is just accurate enough.
    fn excess(&mut self, system: &M, span: &Span<M::Scalar, M::State>) -> M::Scalar {
        let (Some(linearised), Some(factors)) = (&self.linearised, &self.factors) else {
            return M::Scalar::NAN;
        };
        let (tolerated, positions) = (self.settings.tolerated(), linearised.positions());
        let mut most = M::Scalar::ZERO;
        for s in CHECKED.map(M::Scalar::from_f64) {
            let rate = system.rhs(s.multiply_add(span.h, span.t), &span.state(positions, s));
            let defect = difference(&span.slope_at(positions, s), &rate);
            let error = factors.real.solve(linearised, &defect);
            most = most.max(tolerated.norm(M::Scalar::ONE, &error, &span.ends[0], &span.ends[1]));
        }
        self.work.evaluations += CHECKED.len() as u64;
        most
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
                    self.crawling.look(attempt.h, self.clock.time(), M::IS_CONSTRAINED);
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
        self.control = Control::new(step);
        self.clock = Clock::new(t, M::Scalar::ZERO);
        self.state = Compensated::new(*y);
        (self.last, self.end) = (Span::none(t, *y, rate), 1);
        (self.is_due, self.remainder) = (true, M::Scalar::ONE);
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}

/// The part of the tolerance that Newton's method may leave.
fn goal<S: Scalar>(tolerated: &Tolerated<S>) -> S {
    let loosest = tolerated.relative.max(tolerated.absolute);
    let rounding = S::from_f64(ROUNDINGS) * S::epsilon() / loosest;
    rounding.max(S::from_f64(LARGEST_REMAINDER).min(loosest.sqrt()))
}

/// Reciprocals of what is tolerated of the components of a state that changes by about this.
fn weights<S: Scalar, Y: StateVector<S>>(tolerated: &Tolerated<S>, y: &Y, change: &Y) -> Y {
    let mut weights = *y;
    for (weight, change) in weights.as_mut().iter_mut().zip(change.as_ref()) {
        let size = weight.abs().max((*weight + *change).abs());
        *weight = S::ONE / tolerated.relative.multiply_add(size, tolerated.absolute);
    }
    weights
}
