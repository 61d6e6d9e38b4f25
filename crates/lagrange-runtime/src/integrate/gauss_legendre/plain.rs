//! Gauss methods in the state itself.
//!
//! The stages contain slopes Fᵢ = f(t + cᵢ h, y + h Σ aᵢⱼ Fⱼ). For stiff systems, the solution of
//! these equations is more accurate than f at its rounded argument. The step therefore sums the
//! solution.

use crate::integrate::canonical::{Pencil, magnitude};
use crate::integrate::fixed::{Formula, Step, WithinStep};
use crate::integrate::gauss_legendre::linearised::Linearised;
use crate::integrate::gauss_legendre::tableau::{Coefficients, Tableau};
use crate::integrate::jacobian::Source;
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations};
use crate::integrate::prediction::Prediction;
use crate::linalg::pivoted::Matrix;
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, ScalarOf, State, StateVector, StepFailure};

pub(super) type Stages<M, const K: usize> = [State<M>; K];
type StageDerivatives<M> = Pencil<ScalarOf<M>, State<M>>;
/// The derivatives of the equations of the stages, and their factors.
pub(super) type LinearStages<M, const K: usize> = (StageDerivatives<M>, Linearised<ScalarOf<M>, State<M>, K>);

/// The formula of [`PlainGaussLegendre`](crate::integrate::PlainGaussLegendre) with K stages.
#[derive(Debug)]
pub struct Plain<M: OdeSystem + ?Sized, const K: usize> {
    pub(super) tableau: Tableau<ScalarOf<M>, K>,
    rounding: ScalarOf<M>,
    prediction: Prediction<ScalarOf<M>, State<M>, K>,
    /// Slopes of the step in progress, and its length.
    pub(super) stages: (Stages<M, K>, ScalarOf<M>),
}

impl<M: OdeSystem + ?Sized, const K: usize> Plain<M, K>
where
    Tableau<ScalarOf<M>, K>: Coefficients,
{
    pub(super) fn new() -> Self {
        let tableau = Tableau::<ScalarOf<M>, K>::coefficients();
        Plain {
            tableau,
            rounding: Scalar::epsilon(),
            prediction: Prediction::new(tableau.c, tableau.c),
            stages: ([State::<M>::ZERO; K], ScalarOf::<M>::ONE),
        }
    }
}

impl<M: OdeSystem + ?Sized, const K: usize> Clone for Plain<M, K> {
    fn clone(&self) -> Self {
        Plain { ..*self }
    }
}

impl<M: OdeSystem + ?Sized, const K: usize> Formula<M> for Plain<M, K> {
    fn variables(&mut self, _system: &M, _t: M::Scalar, y: &M::State) -> M::State {
        self.prediction.forget();
        *y
    }

    fn increment(&mut self, step: &Step<'_, M>, work: &mut Work) -> Result<M::State, StepFailure<M::Scalar>> {
        let slope = step.system.rhs(step.t, step.y);
        work.evaluations += 1;
        let predicted = self.prediction.slopes(&slope, step.h);
        let first = self.solve(step, predicted, Source::System, work);
        first.or_else(|_| self.solve(step, [slope; K], Source::Differences, work))
    }

    fn accept(&mut self, _t: M::Scalar) {
        let (slopes, h) = self.stages;
        self.prediction.learn(slopes, h);
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, work: &mut Work) -> M::State {
        within.plain_state::<K>(work)
    }
}

impl<M: OdeSystem + ?Sized, const K: usize> Plain<M, K> {
    /// Computes the change of the state, iterating from these slopes of the stages.
    fn solve(
        &mut self,
        step: &Step<'_, M>,
        mut stages: Stages<M, K>,
        source: Source,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let Step { system, t, y, h } = *step;
        let linear = self.linearised(step, &stages, source, work)?;
        let nodes = self.tableau.c;
        let rates = |stage: usize, place: &M::State| system.rhs(nodes[stage].multiply_add(h, t), place);
        let change = self.settled((y, h), &linear, &mut stages, rates, work)?;
        self.stages = (stages, h);
        Ok(change)
    }

    /// Solves the equations of the stages with these rates, and returns the sum h Σ bᵢ Fᵢ.
    pub(super) fn settled(
        &self,
        (y, h): (&M::State, M::Scalar),
        (pencil, linearised): &LinearStages<M, K>,
        stages: &mut Stages<M, K>,
        rates: impl Fn(usize, &M::State) -> M::State,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let mut equations =
            StageEquations::<M, _, K> { y, h, rates, tableau: &self.tableau, pencil, linearised };
        newton::solve(&mut equations, stages, self.rounding, work)?;
        let mut change = y.zeros();
        for (weight, slope) in self.tableau.b.iter().zip(stages.iter()) {
            add(&mut change, h * *weight, slope);
        }
        Ok(change)
    }

    /// Returns the equations with derivatives frozen in the middle of the step.
    pub(super) fn linearised(
        &self,
        step: &Step<'_, M>,
        stages: &Stages<M, K>,
        source: Source,
        work: &mut Work,
    ) -> Result<LinearStages<M, K>, StepFailure<M::Scalar>> {
        let pencil = self.pencil(step, stages, source, work);
        let linearised = Linearised::new(&pencil, &self.tableau).ok_or(StepFailure::NotFinite)?;
        Ok((pencil, linearised))
    }

    /// Computes the derivatives of the equations in the middle of the step.
    fn pencil(
        &self,
        step: &Step<'_, M>,
        stages: &Stages<M, K>,
        source: Source,
        work: &mut Work,
    ) -> StageDerivatives<M> {
        let half = step.h / M::Scalar::from_f64(2.0);
        let mut y = *step.y;
        for (weight, slope) in self.tableau.b.iter().zip(stages) {
            add(&mut y, half * *weight, slope);
        }
        let jacobian = source.jacobian(step.system, (step.t + half, &y), step.h, work);
        let linear = jacobian.map(|jacobian| jacobian.with(|i, j| step.h * jacobian[(i, j)]));
        let zeros = Matrix::zeros(step.y);
        Pencil { constant: Matrix::identity(step.y), derivatives: linear.map(|linear| (linear, zeros)) }
    }
}

/// The equations of the stages of a step from `y`, where a function of the stage's index and place
/// returns its rates.
struct StageEquations<'a, M: OdeSystem + ?Sized, F, const K: usize> {
    y: &'a State<M>,
    h: M::Scalar,
    rates: F,
    tableau: &'a Tableau<M::Scalar, K>,
    pencil: &'a StageDerivatives<M>,
    linearised: &'a Linearised<M::Scalar, M::State, K>,
}

impl<M: OdeSystem + ?Sized, F: Fn(usize, &M::State) -> M::State, const K: usize>
    Equations<M::Scalar, M::State, K> for StageEquations<'_, M, F, K>
{
    #[inline]
    fn residual(&mut self, slopes: &Stages<M, K>, work: &mut Work) -> Stages<M, K> {
        let mut residual = [self.y.zeros(); K];
        for (i, residual) in residual.iter_mut().enumerate() {
            let mut argument = *self.y;
            for (part, slope) in self.tableau.a[i].iter().zip(slopes) {
                add(&mut argument, self.h * *part, slope);
            }
            *residual = (self.rates)(i, &argument);
            add(residual, -M::Scalar::ONE, &slopes[i]);
        }
        work.evaluations += K as u64;
        residual
    }

    fn correction(&self, residual: &Stages<M, K>) -> Stages<M, K> {
        self.linearised.solve(residual)
    }

    fn magnitude(&self, slopes: &Stages<M, K>) -> M::State {
        self.pencil.magnitude(&magnitude(newton::largest(slopes), self.y, self.h))
    }
}
