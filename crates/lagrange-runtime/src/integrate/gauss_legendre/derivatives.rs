//! Exact derivatives of a step.
//!
//! The slopes of the stages, Fᵢ = f(tᵢ, Yᵢ) with Yᵢ = y + h Σ aᵢⱼ Fⱼ, have the derivatives ∂Fᵢ =
//! J(Yᵢ) ∂Yᵢ + ∂f/∂p. These equations are those of the stages for the linear rates J(Yᵢ) ∂y +
//! ∂f/∂p, and are solved in the same way.

use core::array;

use super::PlainGaussLegendre;
use super::plain::{Plain, Stages};
use super::tableau::{Coefficients, Tableau};
use crate::integrate::fixed::{Formula, Step};
use crate::integrate::jacobian::Source;
use crate::integrate::method::{Method, Work};
use crate::integrate::step_derivatives::{DerivativeColumns, DifferentiableStep, Slopes, StepDerivativesOf};
use crate::linalg::vector::{add, combined};
use crate::scalar::Number;
use crate::system::{ParametricSystem, StepFailure};

impl<M: ParametricSystem, const STAGES: usize> DifferentiableStep<M> for PlainGaussLegendre<M::Scalar, STAGES>
where
    Tableau<M::Scalar, STAGES>: Coefficients,
    Self: Method<M>,
{
    fn step_derivatives<const K: usize>(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        indices: [usize; K],
    ) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>> {
        let (h, mut plain, mut work) = (self.step, Plain::<M, STAGES>::new(), Work::default());
        let step = Step { system, t, y, h };
        let end = combined(y, M::Scalar::ONE, &plain.increment(&step, &mut work)?);
        let (stages, tableau) = (plain.stages.0, plain.tableau);
        let mut slopes: [_; STAGES] = array::from_fn(|_| Slopes::zeros(y));
        for (i, slopes) in slopes.iter_mut().enumerate() {
            let mut place = *y;
            tableau.a[i].iter().zip(&stages).for_each(|(part, slope)| add(&mut place, h * *part, slope));
            *slopes = Slopes::at(system, tableau.c[i].multiply_add(h, t), &place, &indices)?;
        }
        let mut columns = |source| {
            let linear = plain.linearised(&step, &stages, source, &mut work)?;
            let (mut columns, mut failure) = (DerivativeColumns::<M, K>::start(y), None);
            columns.update(|variable, column| {
                let rates = |stage: usize, change: &M::State| slopes[stage].along(variable, change);
                let mut stages: Stages<M, STAGES> = array::from_fn(|stage| rates(stage, column));
                match plain.settled((column, h), &linear, &mut stages, rates, &mut work) {
                    Ok(change) => add(column, M::Scalar::ONE, &change),
                    Err(error) => failure = Some(error),
                }
            });
            failure.map_or(Ok(columns), Err)
        };
        let columns = columns(Source::System).or_else(|_| columns(Source::Differences))?;
        columns.of_end(end)
    }
}
