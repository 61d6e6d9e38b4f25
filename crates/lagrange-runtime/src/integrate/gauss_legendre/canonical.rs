//! Gauss methods in coordinates and momenta.
//!
//! They solve Hamilton's equations with velocities instead of momenta: the stages contain
//! velocities Vᵢ that satisfy
//!
//! ```text
//! Qᵢ = q + h Σ aᵢⱼ Vⱼ,    P(Qᵢ, Vᵢ) = p + h Σ aᵢⱼ R(Qⱼ, Vⱼ),    P = ∂L/∂v,    R = ∂L/∂q + Q,
//! ```
//!
//! so no mass matrix must be inverted within a stage. To first order, a change of the velocities
//! changes the residual of the second equation by −(M − hA(∂R/∂v − ∂P/∂q) − h²A² ∂R/∂q).

use crate::integrate::canonical::{CanonicalStep, Derivatives, Reached, factors, magnitude};
use crate::integrate::fixed::{Formula, Step, WithinStep};
use crate::integrate::gauss_legendre::linearised::Linearised;
use crate::integrate::gauss_legendre::tableau::{Coefficients, Tableau};
use crate::integrate::jacobian::Source;
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations};
use crate::integrate::prediction::{Prediction, sum, weights};
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{CanonicalSystem, ScalarOf, StateVector, StepFailure, Vector, join};

type CanonicalStages<M, const K: usize> = [Vector<M>; K];

/// The formula of [`GaussLegendre`](crate::integrate::GaussLegendre) with K stages.
#[derive(Debug)]
pub struct Canonical<M: CanonicalSystem + ?Sized, const K: usize> {
    tableau: Tableau<ScalarOf<M>, K>,
    rounding: ScalarOf<M>,
    /// Weights of the stages and of the start in the velocity at the end of a step.
    end: ([ScalarOf<M>; K], ScalarOf<M>),
    prediction: Prediction<ScalarOf<M>, Vector<M>, K>,
    reached: Reached<M>,
    /// Velocities at the stages of the step in progress, and its length.
    stages: (CanonicalStages<M, K>, ScalarOf<M>),
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Canonical<M, K>
where
    Tableau<ScalarOf<M>, K>: Coefficients,
{
    pub(super) fn new() -> Self {
        let tableau = Tableau::<ScalarOf<M>, K>::coefficients();
        Canonical {
            tableau,
            rounding: Scalar::epsilon(),
            end: weights(&tableau.c, ScalarOf::<M>::ZERO, ScalarOf::<M>::ONE),
            prediction: Prediction::new(tableau.c, tableau.c),
            reached: Reached::NOTHING,
            stages: ([Vector::<M>::ZERO; K], ScalarOf::<M>::ONE),
        }
    }
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Clone for Canonical<M, K> {
    fn clone(&self) -> Self {
        Canonical { reached: self.reached.clone(), ..*self }
    }
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Formula<M> for Canonical<M, K> {
    fn variables(&mut self, system: &M, t: M::Scalar, y: &M::State) -> M::State {
        self.prediction.forget();
        self.reached.start(system, t, y)
    }

    fn increment(&mut self, step: &Step<'_, M>, work: &mut Work) -> Result<M::State, StepFailure<M::Scalar>> {
        let start = [self.reached.velocities; K];
        let predicted = self.prediction.slopes(&self.reached.velocities, step.h);
        let step = CanonicalStep::of(step);
        let first = self.solve(&step, predicted, Source::System, work);
        first.or_else(|_| self.solve(&step, start, Source::Differences, work))
    }

    fn state(
        &mut self,
        system: &M,
        t: M::Scalar,
        variables: &M::State,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let (stages, h) = self.stages;
        let guess = sum(&self.end.0, &stages, self.end.1, &self.reached.velocities);
        self.reached.finish(system, (t, variables), guess, h, work)
    }

    fn follow(&mut self, system: &M, t: M::Scalar, ends: (&M::State, &M::State), variables: &mut M::State) {
        self.reached.follow(system, t, ends, variables);
    }

    fn accept(&mut self, _t: M::Scalar) {
        let (stages, h) = self.stages;
        self.prediction.learn(stages, h);
        self.reached.accept(h);
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, work: &mut Work) -> M::State {
        within.canonical_state::<K>(work)
    }
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Canonical<M, K> {
    /// Computes the change of coordinates and momenta, iterating from these velocities of the
    /// stages.
    fn solve(
        &mut self,
        step: &CanonicalStep<'_, M>,
        mut stages: CanonicalStages<M, K>,
        source: Source,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let mut mean = Vector::<M>::ZERO;
        for (weight, stage) in self.tableau.b.iter().zip(&stages) {
            add(&mut mean, *weight, stage);
        }
        let pencil = self.reached.derivatives(step, &mean, source, work)?;
        let Some(linearised) = Linearised::new(&pencil, &self.tableau) else {
            return Err(factors(&pencil.constant).err().unwrap_or(StepFailure::NotFinite));
        };
        let tableau = &self.tableau;
        let mut equations =
            CanonicalEquations { step, tableau, pencil, linearised, rates: [Vector::<M>::ZERO; K] };
        newton::solve(&mut equations, &mut stages, self.rounding, work)?;
        let (mut q, mut p) = (Vector::<M>::ZERO, Vector::<M>::ZERO);
        for ((weight, velocities), rates) in tableau.b.iter().zip(&stages).zip(&equations.rates) {
            add(&mut q, step.h * *weight, velocities);
            add(&mut p, step.h * *weight, rates);
        }
        self.stages = (stages, step.h);
        Ok(join::<M>(&q, &p))
    }
}

/// The equations of the stages.
struct CanonicalEquations<'a, M: CanonicalSystem + ?Sized, const K: usize> {
    step: &'a CanonicalStep<'a, M>,
    tableau: &'a Tableau<M::Scalar, K>,
    pencil: Derivatives<M>,
    linearised: Linearised<M::Scalar, M::Coordinates, K>,
    /// The rates of momenta at the last evaluation.
    rates: CanonicalStages<M, K>,
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Equations<M::Scalar, M::Coordinates, K>
    for CanonicalEquations<'_, M, K>
{
    #[inline]
    fn residual(&mut self, velocities: &CanonicalStages<M, K>, work: &mut Work) -> CanonicalStages<M, K> {
        let CanonicalStep { system, t, q, p, h } = *self.step;
        let Tableau { a, c, .. } = self.tableau;
        let mut residual = [p; K];
        for i in 0..K {
            let (mut position, time) = (q, c[i].multiply_add(h, t));
            for (part, velocity) in a[i].iter().zip(velocities) {
                add(&mut position, h * *part, velocity);
            }
            self.rates[i] = system.momentum_rates(time, &position, &velocities[i]);
            add(&mut residual[i], -M::Scalar::ONE, &system.momenta(time, &position, &velocities[i]));
        }
        for (residual, row) in residual.iter_mut().zip(a) {
            for (part, rates) in row.iter().zip(&self.rates) {
                add(residual, h * *part, rates);
            }
        }
        work.evaluations += K as u64;
        residual
    }

    fn correction(&self, residual: &CanonicalStages<M, K>) -> CanonicalStages<M, K> {
        self.linearised.solve(residual)
    }

    fn magnitude(&self, velocities: &CanonicalStages<M, K>) -> M::Coordinates {
        self.pencil.magnitude(&magnitude(newton::largest(velocities), &self.step.q, self.step.h))
    }
}
