//! The equations of a step, its error and the error of its interpolant.

use super::RadauStepper;
use crate::integrate::jacobian::{differences, known, sizes};
use crate::integrate::newton::finite;
use crate::integrate::radau::dense::StepTaken;
use crate::integrate::radau::linear::LinearSystem;
use crate::integrate::radau::newton::{
    NewtonOutcome, StageChanges, StageFactors, StageSystem, numbers, weighted,
};
use crate::integrate::radau::tableau::{ERROR, STAGES};
use crate::integrate::verner::tolerance::Tolerated;
use crate::linalg::vector::{combined, difference};
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, StateVector, StepFailure};

/// Maximum remainder of Newton iterations as a fraction of the tolerance; for small tolerances, the
/// root of the tolerance applies instead.
const LARGEST_REMAINDER: f64 = 0.03;
/// Minimum remainder of Newton iterations, in roundings.
const ROUNDINGS: f64 = 10.0;
/// Maximum relative difference of step lengths for which factors are reused.
const SAME_LENGTH: f64 = 1e-6;
/// Fractions of a step at which the defect of its interpolant is evaluated, where it is large for
/// cubic and for quintic ones.
const CHECKED: [f64; 2] = [0.2, 0.55];

/// The changes at the stages of a step, and the outcome of Newton's method.
pub(super) type SolvedStages<M> =
    (StageChanges<<M as OdeSystem>::State>, NewtonOutcome<<M as OdeSystem>::Scalar>);

impl<M: OdeSystem + ?Sized> RadauStepper<M> {
    /// Evaluates the Jacobian at the present state for steps of length `h`.
    #[cold]
    fn linearise(&mut self, system: &M, h: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        let (t, y, rate) = (self.clock.time(), self.state.value(), &self.last.rates[self.end]);
        let jacobian = known(system, t, y, &mut self.work).unwrap_or_else(|| {
            let Tolerated { relative, absolute, domain } = self.settings.tolerated(system.domain());
            let sizes = sizes(y, h, rate, (absolute / relative).min(M::Scalar::ONE), domain);
            differences(system, (t, y), rate, &sizes, &mut self.work)
        });
        if !finite(jacobian.0.as_ref()) {
            return Err(StepFailure::NotFinite);
        }
        self.linearised = Some(LinearSystem::new(jacobian));
        (self.is_fresh, self.is_due, self.factors) = (true, false, None);
        Ok(())
    }

    /// Solves the equations of a step of length `h`.
    pub(super) fn solve(
        &mut self,
        system: &M,
        h: M::Scalar,
    ) -> Result<SolvedStages<M>, StepFailure<M::Scalar>> {
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

    /// Iterates with the present Jacobian.
    fn iterate(&mut self, system: &M, h: M::Scalar) -> Result<SolvedStages<M>, StepFailure<M::Scalar>> {
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
        let mut stages = [self.state.value().zeros(); STAGES];
        if self.last.h != M::Scalar::ZERO {
            stages = self.last.continued(if self.end == 0 { M::Scalar::ZERO } else { M::Scalar::ONE }, h);
        }
        let y = self.state.value();
        let weights = weights(&self.estimated, y, &stages[STAGES - 1]);
        let (t, goal) = (self.clock.time(), self.goal);
        let equations = StageSystem { system, t, y, h, weights: &weights, goal };
        let root = self.remainder.max(M::Scalar::epsilon()).sqrt();
        let remainder = root * root.sqrt();
        let convergence = equations.solve(linearised, factors, &mut stages, remainder, &mut self.work)?;
        self.remainder = convergence.remainder;
        Ok((stages, convergence))
    }

    /// Estimates the error of a step relative to the tolerance.
    pub(super) fn error(&mut self, system: &M, h: M::Scalar, stages: &StageChanges<M::State>) -> M::Scalar {
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

    /// Estimates the error of an interpolant of the last step relative to the tolerance; at most
    /// one is accurate enough.
    pub(super) fn excess(&mut self, system: &M, span: &StepTaken<M::Scalar, M::State>) -> M::Scalar {
        let (Some(linearised), Some(factors)) = (&self.linearised, &self.factors) else {
            return M::Scalar::NAN;
        };
        let (tolerated, positions) = (self.settings.tolerated(system.domain()), linearised.positions());
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

/// Returns the fraction of the tolerance that Newton's method may leave as remainder.
pub(super) fn goal<S: Scalar>(tolerated: &Tolerated<S>) -> S {
    let loosest = tolerated.relative.max(tolerated.absolute);
    let rounding = S::from_f64(ROUNDINGS) * S::epsilon() / loosest;
    rounding.max(S::from_f64(LARGEST_REMAINDER).min(loosest.sqrt()))
}

/// Returns the reciprocals of the tolerated errors of the components of a state with approximately
/// this change.
fn weights<S: Scalar, Y: StateVector<S>>(tolerated: &Tolerated<S>, y: &Y, change: &Y) -> Y {
    let mut weights = *y;
    for (component, (weight, change)) in weights.as_mut().iter_mut().zip(change.as_ref()).enumerate() {
        let size = weight.abs().max((*weight + *change).abs());
        *weight = S::ONE / tolerated.of(component, size);
    }
    weights
}
