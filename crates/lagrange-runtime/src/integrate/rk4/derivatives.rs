//! Exact derivatives of a step.
//!
//! The rates of the stages, kᵢ = f(yᵢ), have the derivatives ∂kᵢ = J(yᵢ) ∂yᵢ + ∂f/∂p. Those of the
//! stages yᵢ = y + cᵢ h kᵢ₋₁ follow from them. These are the stages of the variational equations.

use super::{RungeKutta4, RungeKuttaStages, SIXTHS};
use crate::integrate::step_derivatives::{DerivativeColumns, DifferentiableStep, Slopes, StepDerivativesOf};
use crate::linalg::vector::combined;
use crate::scalar::Number;
use crate::system::{ParametricSystem, StepFailure};

impl<M: ParametricSystem> DifferentiableStep<M> for RungeKutta4<M::Scalar> {
    fn step_derivatives<const K: usize>(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        indices: [usize; K],
    ) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>> {
        let (h, start) = (self.step, DerivativeColumns::start(y));
        let (mut rates, mut end) = (DerivativeColumns::zeros(y), DerivativeColumns::start(y));
        let mut stages = RungeKuttaStages::new();
        for (stage, sixths) in SIXTHS.into_iter().enumerate() {
            let (ahead, place) = stages.place(stage, y, h);
            stages.rates[stage] = system.rhs(t + ahead, &place);
            start.rates_at(ahead, &mut rates, &Slopes::at(system, t + ahead, &place, &indices)?);
            end.add(h / M::Scalar::from_f64(6.0) * M::Scalar::from_f64(sixths), &rates);
        }
        end.of_end(combined(y, M::Scalar::ONE, &stages.increment(h)))
    }
}
