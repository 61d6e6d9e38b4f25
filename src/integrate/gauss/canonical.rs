//! Gauss methods in coordinates and momenta.
//!
//! Hamilton's equations with velocities in the place of momenta: the stages hold velocities Vᵢ that satisfy
//!
//! ```text
//! Qᵢ = q + h Σ aᵢⱼ Vⱼ,    P(Qᵢ, Vᵢ) = p + h Σ aᵢⱼ R(Qⱼ, Vⱼ),    P = ∂L/∂v,    R = ∂L/∂q + Q,
//! ```
//!
//! so that no mass matrix has to be inverted within a stage. To first order, a change of the velocities changes what is
//! left of the second equation by −(M − hA(∂R/∂v − ∂P/∂q) − h²A² ∂R/∂q), and differentiating d/dt P = R along the motion
//! gives ∂R/∂v − ∂P/∂q = M ∂a/∂v + dM/dt and ∂R/∂q = M ∂a/∂q + d/dt ∂P/∂q. The last term is left out: it changes the
//! number of iterations alone, and no more than the change of the derivatives within the step does.

use crate::integrate::error::Cause;
use crate::integrate::fixed::Formula;
use crate::integrate::gauss::dense;
use crate::integrate::gauss::linearised::{Linearised, Pencil, add};
use crate::integrate::gauss::tableau::{Coefficients, Tableau};
use crate::integrate::linear::Matrix;
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations, finite};
use crate::integrate::prediction::{Prediction, sum, weights};
use crate::integrate::velocities::{factors, velocities};
use crate::scalar::Scalar;
use crate::system::{CanonicalSystem, MechanicalSystem, OdeSystem, StateVector, join, split};

type Number<M> = <M as OdeSystem>::Scalar;
type Vector<M> = <M as MechanicalSystem>::Coordinates;
type Stages<M, const K: usize> = [Vector<M>; K];
type Derivatives<M> = Pencil<Number<M>, Vector<M>>;
type Mass<M> = Matrix<Number<M>, Vector<M>>;

/// The formula of [`GaussLegendre`](crate::integrate::GaussLegendre) with K stages.
#[derive(Debug)]
pub struct Canonical<M: CanonicalSystem + ?Sized, const K: usize> {
    tableau: Tableau<Number<M>, K>,
    rounding: Number<M>,
    /// How the velocity at the end of a step follows from its stages and its start.
    end: ([Number<M>; K], Number<M>),
    prediction: Prediction<Number<M>, Vector<M>, K>,
    /// Velocities and mass matrix at the present state.
    velocities: Vector<M>,
    mass: Mass<M>,
    /// The rate of the mass matrix over the last step.
    mass_rate: Mass<M>,
    /// Velocities at the stages of the step that is being taken, and its length.
    stages: (Stages<M, K>, Number<M>),
    /// Velocities and mass matrix at its end.
    next: (Vector<M>, Mass<M>),
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Canonical<M, K>
where
    Tableau<Number<M>, K>: Coefficients,
{
    pub(super) fn new() -> Self {
        let tableau = Tableau::<Number<M>, K>::coefficients();
        Canonical {
            tableau,
            rounding: newton::rounding(),
            end: weights(&tableau.c, Number::<M>::ZERO, Number::<M>::ONE),
            prediction: Prediction::new(tableau.c),
            velocities: Vector::<M>::ZERO,
            mass: Matrix::ZERO,
            mass_rate: Matrix::ZERO,
            stages: ([Vector::<M>::ZERO; K], Number::<M>::ONE),
            next: (Vector::<M>::ZERO, Matrix::ZERO),
        }
    }
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Clone for Canonical<M, K> {
    fn clone(&self) -> Self {
        Canonical { ..*self }
    }
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Formula<M> for Canonical<M, K> {
    fn variables(&mut self, system: &M, t: M::Scalar, y: &M::State) -> M::State {
        let (q, v) = split::<M>(y);
        self.velocities = v;
        self.mass = Matrix(system.mass_matrix(t, &q, &v));
        self.mass_rate = Matrix::ZERO;
        self.prediction.forget();
        join::<M>(&q, &system.momenta(t, &q, &v))
    }

    fn increment(
        &mut self,
        system: &M,
        t: M::Scalar,
        variables: &M::State,
        h: M::Scalar,
        work: &mut Work,
    ) -> Result<M::State, Cause<M::Scalar>> {
        let (q, p) = split::<M>(variables);
        let start = [self.velocities; K];
        let predicted = self.prediction.slopes(&self.velocities, h);
        let step = Step { system, t, q, p, h };
        self.solve(&step, predicted, work).or_else(|_| self.solve(&step, start, work))
    }

    fn state(
        &mut self,
        system: &M,
        t: M::Scalar,
        variables: &M::State,
        work: &mut Work,
    ) -> Result<M::State, Cause<M::Scalar>> {
        let (q, p) = split::<M>(variables);
        let (stages, h) = self.stages;
        let guess = sum(&self.end.0, &stages, self.end.1, &self.velocities);
        let mass = Matrix(system.mass_matrix(t, &q, &guess));
        let v = velocities(system, t, (&q, &p), guess, &mass, h, work)?;
        self.next = (v, mass);
        Ok(join::<M>(&q, &v))
    }

    fn accept(&mut self, _t: M::Scalar) {
        let (stages, h) = self.stages;
        let (velocities, mass) = self.next;
        self.prediction.learn(stages, h);
        self.mass_rate = Matrix::of(|i, j| (mass[(i, j)] - self.mass[(i, j)]) / h);
        self.mass = mass;
        self.velocities = velocities;
    }

    fn interpolate(
        &mut self,
        system: &M,
        from: (M::Scalar, &M::State),
        to: (M::Scalar, &M::State),
        t: M::Scalar,
        work: &mut Work,
    ) -> M::State {
        dense::between::<M, K>(system, from, to, t, work)
    }
}

/// A step to be taken.
struct Step<'a, M: CanonicalSystem + ?Sized> {
    system: &'a M,
    t: M::Scalar,
    q: M::Coordinates,
    p: M::Coordinates,
    h: M::Scalar,
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Canonical<M, K> {
    /// The change of coordinates and momenta, iterating from these velocities of the stages.
    fn solve(
        &mut self,
        step: &Step<'_, M>,
        mut stages: Stages<M, K>,
        work: &mut Work,
    ) -> Result<M::State, Cause<M::Scalar>> {
        let pencil = self.pencil(step, &stages, work)?;
        let Some(linearised) = pencil.factors(&self.tableau) else {
            return Err(factors(&pencil.constant).err().unwrap_or(Cause::NotFinite));
        };
        let tableau = &self.tableau;
        let mut equations =
            StageEquations { step, tableau, pencil, linearised, rates: [Vector::<M>::ZERO; K] };
        newton::solve(&mut equations, &mut stages, self.rounding, work)?;
        let (mut q, mut p) = (Vector::<M>::ZERO, Vector::<M>::ZERO);
        for ((weight, velocities), rates) in tableau.b.iter().zip(&stages).zip(&equations.rates) {
            add(&mut q, step.h * *weight, velocities);
            add(&mut p, step.h * *weight, rates);
        }
        self.stages = (stages, step.h);
        Ok(join::<M>(&q, &p))
    }

    /// The derivatives of the equations in the middle of the step.
    fn pencil(
        &self,
        step: &Step<'_, M>,
        stages: &Stages<M, K>,
        work: &mut Work,
    ) -> Result<Derivatives<M>, Cause<M::Scalar>> {
        let h = step.h;
        let half = h / M::Scalar::from_f64(2.0);
        let mass = Matrix::of(|i, j| self.mass_rate[(i, j)].multiply_add(half, self.mass[(i, j)]));
        let (mut q, mut v) = (step.q, Vector::<M>::ZERO);
        for (weight, stage) in self.tableau.b.iter().zip(stages) {
            add(&mut v, *weight, stage);
        }
        add(&mut q, half, &v);
        let Some(jacobian) = step.system.jacobian(step.t + half, &join::<M>(&q, &v)) else {
            return Ok(Pencil { constant: mass, derivatives: None });
        };
        work.jacobians += 1;
        let jacobian = Matrix::<M::Scalar, M::State>(jacobian);
        if !finite(jacobian.0.as_ref()) {
            return Err(Cause::NotFinite);
        }
        let n = mass.rows();
        let by_q = mass.times(&Matrix::of(|i, j| h * h * jacobian[(n + i, j)]));
        let by_v = mass.times(&Matrix::of(|i, j| h * jacobian[(n + i, n + j)]));
        let by_v = Matrix::of(|i, j| self.mass_rate[(i, j)].multiply_add(h, by_v[(i, j)]));
        Ok(Pencil { constant: mass, derivatives: Some((by_v, by_q)) })
    }
}

/// The equations of the stages.
struct StageEquations<'a, M: CanonicalSystem + ?Sized, const K: usize> {
    step: &'a Step<'a, M>,
    tableau: &'a Tableau<M::Scalar, K>,
    pencil: Derivatives<M>,
    linearised: Linearised<M::Scalar, M::Coordinates, K>,
    /// The rates of momenta at the last evaluation.
    rates: Stages<M, K>,
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Equations<M::Scalar, M::Coordinates, K>
    for StageEquations<'_, M, K>
{
    #[inline]
    fn residual(&mut self, velocities: &Stages<M, K>, work: &mut Work) -> Stages<M, K> {
        let Step { system, t, q, p, h } = *self.step;
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

    fn correction(&self, residual: &Stages<M, K>) -> Stages<M, K> {
        self.linearised.solve(residual)
    }

    fn magnitude(&self, velocities: &Stages<M, K>) -> M::Coordinates {
        let mut unknowns = newton::largest(velocities);
        for (unknown, q) in unknowns.as_mut().iter_mut().zip(self.step.q.as_ref()) {
            *unknown = *unknown + (M::Scalar::ONE + q.abs()) / self.step.h.abs();
        }
        self.pencil.magnitude(&unknowns)
    }
}
