//! Velocities for given momenta, under constraints.
//!
//! The remainder of the momenta is in the space of constraint forces:
//!
//! ```text
//! P(q, v) = p + Aᵀμ,    ċ(t, q, v) = A v + c_t = 0,
//! ```
//!
//! which is the projection of p onto the momenta that constraints admit, with the inverse mass
//! matrix as metric. A mass matrix that is singular without the constraints is stiffened by ρ AᵀA,
//! which affects only the multipliers if ċ = 0. Sources: Hairer, Lubich, Wanner, *Geometric
//! Numerical Integration*, 2nd ed., §VII.1.3; Benzi, Golub, Liesen, *Numerical solution of saddle
//! point problems*, Acta Numerica 14 (2005), §3.4.

use crate::integrate::canonical::magnitude;
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations, finite};
use crate::linalg::pivoted::{Factors, Matrix};
use crate::linalg::ranked::RankedFactors;
use crate::linalg::vector::{add, dot};
use crate::scalar::{Number, Scalar};
use crate::system::{
    CanonicalSystem, ConstraintValues, MechanicalSystem, OdeSystem, StateVector, StepFailure, join, split,
};

type Values<M> = ConstraintValues<<M as OdeSystem>::Scalar, <M as MechanicalSystem>::Coordinates>;

/// Computes the velocities and Aᵀμ for the momenta `p`, from a guess and the mass matrix there. The
/// length `h` of the last step determines which velocities are small.
pub(in crate::integrate) fn constrained_velocities<M: CanonicalSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, p): (&M::Coordinates, &M::Coordinates),
    guess: M::Coordinates,
    mass: &Matrix<M::Scalar, M::Coordinates>,
    h: M::Scalar,
    work: &mut Work,
) -> Result<[M::Coordinates; 2], StepFailure<M::Scalar>> {
    let values = system.constraint_values(t, q, &guess);
    let (mut unknowns, mut uncounted) = ([join::<M>(&guess, &M::Coordinates::ZERO)], Work::default());
    let saddle = Saddle::new(mass, &values)?;
    let (terms, reaction) = (magnitude(guess, q, h), M::Coordinates::ZERO);
    let mut equations = Pinned { system, t, q, p, guess, mass, values, saddle, terms, reaction };
    newton::solve(&mut equations, &mut unknowns, Scalar::epsilon(), &mut uncounted)?;
    work.evaluations += uncounted.evaluations;
    Ok([split::<M>(&unknowns[0]).0, equations.reaction])
}

/// The equations for v and μ.
struct Pinned<'a, M: CanonicalSystem + ?Sized> {
    system: &'a M,
    t: M::Scalar,
    q: &'a M::Coordinates,
    p: &'a M::Coordinates,
    guess: M::Coordinates,
    mass: &'a Matrix<M::Scalar, M::Coordinates>,
    values: Values<M>,
    saddle: Saddle<M::Scalar, M::Coordinates>,
    /// The magnitude of velocities, relative to which changes are rounding.
    terms: M::Coordinates,
    /// Aᵀμ at the last evaluation.
    reaction: M::Coordinates,
}

impl<M: CanonicalSystem + ?Sized> Equations<M::Scalar, M::State, 1> for Pinned<'_, M> {
    fn residual(&mut self, [unknowns]: &[M::State; 1], work: &mut Work) -> [M::State; 1] {
        work.evaluations += 1;
        let (one, (v, multipliers)) = (M::Scalar::ONE, split::<M>(unknowns));
        let mut change = v;
        add(&mut change, -one, &self.guess);
        let mut rates = self.values.applied(&change);
        add(&mut rates, one, &self.values.velocities);
        self.reaction = self.values.force(&multipliers);
        let mut residual = self.reaction;
        add(&mut residual, one, self.p);
        add(&mut residual, -one, &self.system.momenta(self.t, self.q, &v));
        [join::<M>(&residual, &negative(rates))]
    }

    fn correction(&self, [residual]: &[M::State; 1]) -> [M::State; 1] {
        let (force, rates) = split::<M>(residual);
        let (v, multipliers) = self.saddle.solve(&force, &rates);
        [join::<M>(&v, &multipliers)]
    }

    fn magnitude(&self, _unknowns: &[M::State; 1]) -> M::State {
        let momenta = Matrix::of(|i, j| self.mass[(i, j)].abs()).apply(&self.terms);
        join::<M>(&momenta, &self.values.sizes(&self.terms))
    }
}

/// The factors of the equations M x = f + Aᵀμ, A x = d.
#[derive(Clone, Debug)]
struct Saddle<S: Scalar, Q: StateVector<S>> {
    factors: Factors<S, Q>,
    /// ρ
    stiffness: S,
    values: ConstraintValues<S, Q>,
    /// The displacement caused by the force of each multiplier, in rows.
    moved: Q::Square,
    /// A M⁻¹ Aᵀ
    mobility: RankedFactors<S, Q>,
}

impl<S: Scalar, Q: StateVector<S>> Saddle<S, Q> {
    fn new(mass: &Matrix<S, Q>, values: &ConstraintValues<S, Q>) -> Result<Self, StepFailure<S>> {
        if !(finite(mass.0.as_ref()) && finite(values.jacobian.as_ref())) {
            return Err(StepFailure::NotFinite);
        }
        let (factors, stiffness) = match Factors::new(mass.clone()) {
            Some(factors) => (factors, S::ZERO),
            None => {
                let stiffness = stiffness(mass, values);
                let factors = Factors::new(stiffened(mass, values, stiffness));
                (factors.ok_or(StepFailure::SingularMassMatrix)?, stiffness)
            }
        };
        let mut moved = Q::ZERO_SQUARE;
        for (moved, row) in moved.as_mut().iter_mut().zip(values.jacobian.as_ref()).take(values.count()) {
            *moved = factors.solve(row);
        }
        let mobility = Matrix::of(|i, j| dot(values.row(i), &moved.as_ref()[j]));
        let mobility = RankedFactors::new(mobility, values.count()).ok_or(StepFailure::NotFinite)?;
        Ok(Saddle { factors, stiffness, values: values.clone(), moved, mobility })
    }

    fn solve(&self, force: &Q, rates: &Q) -> (Q, Q) {
        let mut loads = *force;
        add(&mut loads, self.stiffness, &self.values.force(rates));
        let mut x = self.factors.solve(&loads);
        let mut missing = *rates;
        add(&mut missing, -S::ONE, &self.values.applied(&x));
        let multipliers = self.mobility.solve(&missing);
        for (moved, multiplier) in self.moved.as_ref().iter().zip(multipliers.as_ref()) {
            add(&mut x, *multiplier, moved);
        }
        (x, multipliers)
    }
}

/// Computes the weight ρ for which ρ AᵀA has the magnitude of M.
pub(in crate::integrate) fn stiffness<S: Scalar, Q: StateVector<S>>(
    mass: &Matrix<S, Q>,
    values: &ConstraintValues<S, Q>,
) -> S {
    let largest = |rows: &[Q]| {
        let entries = rows.iter().flat_map(Q::as_ref);
        entries.fold(S::ZERO, |largest, entry| largest.max(entry.abs()))
    };
    let (mass, gradient) = (largest(mass.0.as_ref()), largest(values.jacobian.as_ref()));
    let square = gradient * gradient;
    if mass > S::ZERO && square > S::ZERO { mass / square } else { S::ONE }
}

/// Computes M + ρ AᵀA.
pub(in crate::integrate) fn stiffened<S: Scalar, Q: StateVector<S>>(
    mass: &Matrix<S, Q>,
    values: &ConstraintValues<S, Q>,
    stiffness: S,
) -> Matrix<S, Q> {
    Matrix::of(|i, j| {
        let rows = values.jacobian.as_ref().iter().take(values.count());
        let sum = rows.fold(S::ZERO, |sum, row| row.as_ref()[i].multiply_add(row.as_ref()[j], sum));
        stiffness.multiply_add(sum, mass[(i, j)])
    })
}

fn negative<S: Scalar, Q: StateVector<S>>(mut x: Q) -> Q {
    for x in x.as_mut() {
        *x = -*x;
    }
    x
}
