//! The common parts of implicit methods in coordinates and momenta.
//!
//! They advance momenta p = ∂L/∂v and compute velocities from them. Their equations contain the
//! changes of P(Q, V) = ∂L/∂v and of the rates R(Q, V) = ∂L/∂q + Q of momenta. Newton's method
//! needs derivatives of these. Differentiation of d/dt P = R along the motion leads to
//!
//! ```text
//! ∂P/∂v = M,    ∂R/∂v − ∂P/∂q = M ∂a/∂v + dM/dt,    ∂R/∂q = M ∂a/∂q + d/dt ∂P/∂q,
//! ```
//!
//! so the Jacobian of the system and the mass matrix suffice. The last term is omitted. It affects
//! only the number of iterations, and no more than the change of the derivatives within a step.

mod constrained;
mod hamiltonian;
mod pencil;
mod velocities;

use crate::integrate::canonical::constrained::constrained_velocities;
use crate::integrate::fixed::Step;
use crate::integrate::jacobian::Source;
use crate::integrate::method::Work;
use crate::linalg::pivoted::Matrix;
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{CanonicalSystem, MechanicalSystem, OdeSystem, StateVector, StepFailure, join, split};

pub(super) use self::constrained::{stiffened, stiffness};
pub use self::hamiltonian::Hamiltonian;
pub(super) use self::pencil::Pencil;
pub(super) use self::velocities::{factors, velocities};

type Mass<M> = Matrix<<M as OdeSystem>::Scalar, <M as MechanicalSystem>::Coordinates>;

/// The derivatives of the equations of a step.
pub(super) type Derivatives<M> = Pencil<<M as OdeSystem>::Scalar, <M as MechanicalSystem>::Coordinates>;

/// A step from coordinates and momenta.
#[derive(Debug)]
pub(super) struct CanonicalStep<'a, M: CanonicalSystem + ?Sized> {
    pub(super) system: &'a M,
    pub(super) t: M::Scalar,
    pub(super) q: M::Coordinates,
    pub(super) p: M::Coordinates,
    pub(super) h: M::Scalar,
}

impl<'a, M: CanonicalSystem + ?Sized> CanonicalStep<'a, M> {
    /// Splits the variables of a step into coordinates and momenta.
    pub(super) fn of(&Step { system, t, y, h }: &Step<'a, M>) -> Self {
        let (q, p) = split::<M>(y);
        CanonicalStep { system, t, q, p, h }
    }
}

/// Velocities and the mass matrix at the present state.
#[derive(Debug)]
pub(super) struct Reached<M: CanonicalSystem + ?Sized> {
    pub(super) velocities: M::Coordinates,
    mass: Mass<M>,
    /// The rate of the mass matrix over the last step.
    mass_rate: Mass<M>,
    /// Velocities and mass matrix at the end of the step in progress.
    next: (M::Coordinates, Mass<M>),
}

impl<M: CanonicalSystem + ?Sized> Clone for Reached<M> {
    fn clone(&self) -> Self {
        let Reached { velocities, mass, mass_rate, next } = self;
        Reached {
            velocities: *velocities,
            mass: mass.clone(),
            mass_rate: mass_rate.clone(),
            next: next.clone(),
        }
    }
}

impl<M: CanonicalSystem + ?Sized> Reached<M> {
    /// No state yet.
    pub(super) const NOTHING: Self = Reached {
        velocities: M::Coordinates::ZERO,
        mass: Matrix::ZERO,
        mass_rate: Matrix::ZERO,
        next: (M::Coordinates::ZERO, Matrix::ZERO),
    };

    /// Starts at a state and returns its coordinates and momenta.
    pub(super) fn start(&mut self, system: &M, t: M::Scalar, y: &M::State) -> M::State {
        let (q, v) = split::<M>(y);
        self.velocities = v;
        self.mass = Matrix(system.mass_matrix(t, &q, &v));
        self.mass_rate = Matrix::ZERO;
        join::<M>(&q, &system.momenta(t, &q, &v))
    }

    /// Computes the state from coordinates and momenta at the end of a step of length `h`, and from
    /// a guess of velocities.
    pub(super) fn finish(
        &mut self,
        system: &M,
        (t, variables): (M::Scalar, &M::State),
        guess: M::Coordinates,
        h: M::Scalar,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let (q, p) = split::<M>(variables);
        let mass = Matrix(system.mass_matrix(t, &q, &guess));
        let v = velocities(system, t, (&q, &p), guess, &mass, h, work)?;
        self.next = (v, mass);
        Ok(join::<M>(&q, &v))
    }

    /// Computes the force Aᵀμ that constraints add to the momenta at the end of a step, from a
    /// guess. It makes the velocities admissible.
    pub(super) fn hold(
        &mut self,
        system: &M,
        t: M::Scalar,
        (q, p): (&M::Coordinates, &M::Coordinates),
        guess: M::Coordinates,
        h: M::Scalar,
        work: &mut Work,
    ) -> Result<M::Coordinates, StepFailure<M::Scalar>> {
        let mass = Matrix(system.mass_matrix(t, q, &guess));
        let [v, reaction] = constrained_velocities(system, t, (q, p), guess, &mass, h, work)?;
        self.next = (v, mass);
        Ok(reaction)
    }

    /// Returns the velocities at the end of the step in progress, after constraints were enforced.
    pub(super) fn held(&self) -> M::Coordinates {
        self.next.0
    }

    /// Follows the correction of the state at the end of the step in progress, and corrects the
    /// variables. Momenta change by the difference between those of the corrected and of the
    /// original state. Unaffected momenta therefore keep all digits.
    pub(super) fn follow(
        &mut self,
        system: &M,
        t: M::Scalar,
        (from, to): (&M::State, &M::State),
        variables: &mut M::State,
    ) {
        let ((q, v), (q_to, v_to)) = (split::<M>(from), split::<M>(to));
        let (_, mut p) = split::<M>(variables);
        let mut change = system.momenta(t, &q_to, &v_to);
        add(&mut change, -M::Scalar::ONE, &system.momenta(t, &q, &v));
        add(&mut p, M::Scalar::ONE, &change);
        self.next.0 = v_to;
        *variables = join::<M>(&q_to, &p);
    }

    /// Continues from the end of the step of length `h`.
    pub(super) fn accept(&mut self, h: M::Scalar) {
        let (velocities, mass) = &self.next;
        self.mass_rate = Matrix::of(|i, j| (mass[(i, j)] - self.mass[(i, j)]) / h);
        self.mass.clone_from(mass);
        self.velocities = *velocities;
    }

    /// Computes the derivatives of the equations in the middle of a step with the mean velocity
    /// `v`.
    pub(super) fn derivatives(
        &self,
        step: &CanonicalStep<'_, M>,
        v: &M::Coordinates,
        source: Source,
        work: &mut Work,
    ) -> Result<Derivatives<M>, StepFailure<M::Scalar>> {
        let h = step.h;
        let half = h / M::Scalar::from_f64(2.0);
        let mass = Matrix::of(|i, j| self.mass_rate[(i, j)].multiply_add(half, self.mass[(i, j)]));
        let mut q = step.q;
        add(&mut q, half, v);
        let Some(jacobian) = source.jacobian(step.system, (step.t + half, &join::<M>(&q, v)), h, work) else {
            return Ok(Pencil { constant: mass, derivatives: None });
        };
        let n = mass.rows();
        let by_q = mass.times(&Matrix::of(|i, j| h * h * jacobian[(n + i, j)]));
        let by_v = mass.times(&Matrix::of(|i, j| h * jacobian[(n + i, n + j)]));
        let by_v = Matrix::of(|i, j| self.mass_rate[(i, j)].multiply_add(h, by_v[(i, j)]));
        Ok(Pencil { constant: mass, derivatives: Some((by_v, by_q)) })
    }
}

/// Returns the magnitude of slopes, plus the slopes that would move `from` by itself or by one
/// within a step of length `h`. Changes of slopes below the rounding of this magnitude have no
/// effect in floating point.
pub(super) fn magnitude<S: Scalar, Y: StateVector<S>>(mut slopes: Y, from: &Y, h: S) -> Y {
    for (slope, from) in slopes.as_mut().iter_mut().zip(from.as_ref()) {
        *slope = slope.abs() + (S::ONE + from.abs()) / h.abs();
    }
    slopes
}
