//! Exact derivatives of a step.
//!
//! The rates of the stages, kᵢ = f(yᵢ), have the derivatives ∂kᵢ = J(yᵢ) ∂yᵢ + ∂f/∂p. Those of the
//! stages yᵢ = y + cᵢ h kᵢ₋₁ follow from them. These are the stages of the variational equations.

use super::{RungeKutta4, RungeKuttaStages};
use crate::integrate::step_derivatives::{DerivativeColumns, DifferentiableStep, Slopes, StepDerivativesOf};
use crate::linalg::vector::combined;
use crate::scalar::Number;
use crate::system::{ParametricSystem, StateVector, StepFailure};

impl<M: ParametricSystem> DifferentiableStep<M> for RungeKutta4<M::Scalar> {
    fn step_derivatives<const K: usize>(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        indices: [usize; K],
    ) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>> {
        let (h, number) = (self.step, M::Scalar::from_f64);
        let (half, third, sixth) = (h / number(2.0), h / number(3.0), h / number(6.0));
        let nodes = [(M::Scalar::ZERO, sixth), (half, third), (half, third), (h, sixth)];
        let start = DerivativeColumns::start(y);
        let (mut rates, mut end) = (DerivativeColumns::zeros(y), DerivativeColumns::start(y));
        let mut stages = [y.zeros(); 4];
        for (stage, (after, weight)) in nodes.into_iter().enumerate() {
            let before = stage.checked_sub(1).map_or(y.zeros(), |before| stages[before]);
            let place = combined(y, after, &before);
            stages[stage] = system.rhs(t + after, &place);
            start.rates_at(after, &mut rates, &Slopes::at(system, t + after, &place, &indices)?);
            end.add(weight, &rates);
        }
        let [k1, k2, k3, k4] = stages;
        let increment = RungeKuttaStages { k1, k2, k3, k4 }.increment(h);
        end.of_end(combined(y, M::Scalar::ONE, &increment))
    }
}
