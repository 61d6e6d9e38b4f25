//! The Hamiltonian of a system, and Hamilton's equations.

use super::velocities::factors;
use crate::linalg::pivoted::Matrix;
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{CanonicalSystem, EnergyFunction, Positions, StateVector, StepFailure};

/// Maximum number of Newton steps.
const MAX_STEPS: u32 = 60;
/// Fraction of a Newton step below which it is no longer halved.
const SHORTEST: f64 = 1e-6;

/// Hamilton's form of the equations of motion, in coordinates q and momenta p = ∂L/∂v.
///
/// Every system with momenta has this form, such as emitted types with `emit { momentum_rates }`.
/// Velocities are computed from momenta by Newton's method with shortened steps. One step suffices
/// if L is quadratic in the velocities. Source: Goldstein, Poole, Safko, *Classical Mechanics*, 3rd
/// ed., §8.1.
///
/// ```
/// use lagrange::integrate::Hamiltonian;
///
/// lagrange::system! {
///     /// A bead on a wire that turns with the angular velocity w.
///     struct Bead;
///     param m = 2, w = 3;
///     coord r;
///     lagrangian = 1/2 * m * (dot(r)^2 + r^2 * w^2);
///     emit { momentum_rates }
/// }
///
/// // H = p²/(2m) − m r² w²/2, which is not the energy.
/// let bead = Bead::default();
/// assert_eq!(bead.hamiltonian(0.0, &[0.5], &[4.0])?, 4.0 - 2.25);
/// // r' = p/m, p' = m r w²
/// assert_eq!(bead.hamilton_equations(0.0, &[0.5], &[4.0])?, ([2.0], [9.0]));
/// # Ok::<(), lagrange::system::StepFailure<f64>>(())
/// ```
pub trait Hamiltonian: CanonicalSystem {
    /// Computes the velocities for given momenta, with p = ∂L/∂v.
    ///
    /// # Errors
    /// If the mass matrix is singular, or a value is not finite.
    fn velocities_of(
        &self,
        t: Self::Scalar,
        q: &Positions<Self>,
        p: &Positions<Self>,
    ) -> Result<Positions<Self>, StepFailure<Self::Scalar>> {
        let mut v = p.zeros();
        let mut missing = lacking(self, t, (q, p), &v);
        for _ in 0..MAX_STEPS {
            let factors = factors(&Matrix(self.mass_matrix(t, q, &v)))?;
            let change = factors.solve(&missing.0);
            let (closer, left) = step(self, t, (q, p), &v, &change, missing.1);
            if !left.1.is_finite() {
                return Err(StepFailure::NotFinite);
            }
            if left.1 >= missing.1 {
                return Ok(v);
            }
            (v, missing) = (closer, left);
        }
        Err(StepFailure::NotConverged { iterations: MAX_STEPS })
    }

    /// Computes the Hamiltonian H(t, q, p) = p·v − L, which is the energy at the velocities that
    /// correspond to the momenta.
    ///
    /// # Errors
    /// As for [`velocities_of`](Self::velocities_of).
    fn hamiltonian(
        &self,
        t: Self::Scalar,
        q: &Positions<Self>,
        p: &Positions<Self>,
    ) -> Result<Self::Scalar, StepFailure<Self::Scalar>>
    where
        Self: EnergyFunction,
    {
        let v = self.velocities_of(t, q, p)?;
        Ok(self.energy(t, q, &v))
    }

    /// Computes the rates of coordinates and momenta, q̇ = ∂H/∂p and ṗ = −∂H/∂q + Q. Here Q
    /// contains the forces without a potential.
    ///
    /// # Errors
    /// As for [`velocities_of`](Self::velocities_of).
    #[expect(clippy::type_complexity, reason = "a pair of vectors, or a failure")]
    fn hamilton_equations(
        &self,
        t: Self::Scalar,
        q: &Positions<Self>,
        p: &Positions<Self>,
    ) -> Result<(Positions<Self>, Positions<Self>), StepFailure<Self::Scalar>> {
        let v = self.velocities_of(t, q, p)?;
        Ok((v, self.momentum_rates(t, q, &v)))
    }
}

impl<M: CanonicalSystem> Hamiltonian for M {}

/// Computes p − ∂L/∂v and the sum of its magnitudes.
fn lacking<M: CanonicalSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, p): (&Positions<M>, &Positions<M>),
    v: &Positions<M>,
) -> (Positions<M>, M::Scalar) {
    let mut missing = *p;
    add(&mut missing, -M::Scalar::ONE, &system.momenta(t, q, v));
    let sum = missing.as_ref().iter().fold(M::Scalar::ZERO, |sum, entry| sum + entry.abs());
    (missing, sum)
}

/// Returns the result of the longest among a Newton step and its halves that reduces the residual,
/// or of the shortest one.
fn step<M: CanonicalSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, p): (&Positions<M>, &Positions<M>),
    from: &Positions<M>,
    change: &Positions<M>,
    missing: M::Scalar,
) -> (Positions<M>, (Positions<M>, M::Scalar)) {
    let mut part = M::Scalar::ONE;
    loop {
        let mut v = *from;
        add(&mut v, part, change);
        let left = lacking(system, t, (q, p), &v);
        if left.1 < missing || part < M::Scalar::from_f64(SHORTEST) || missing == M::Scalar::ZERO {
            return (v, left);
        }
        part = part * M::Scalar::from_f64(0.5);
    }
}
