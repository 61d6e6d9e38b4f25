//! A step with constraints on positions.
//!
//! The impulse of the constraints at the start makes positions at the end satisfy them. The impulse
//! at the end does so for the velocities there (SHAKE and RATTLE):
//!
//! ```text
//! u = v + β₀ h a(t, q) + M⁻¹A(q)ᵀμ,    q₁ = q + h u,    c(t₁, q₁) = 0,
//! v₁ = u + β₁ h a(t₁, q₁) + M⁻¹A(q₁)ᵀν,    ċ(t₁, q₁, v₁) = 0.
//! ```
//!
//! Accelerations that include constraint forces differ by combinations of the rows of A, which the
//! impulses compensate. The velocities at which they are evaluated are therefore irrelevant. With
//! half kicks this is RATTLE, which is symplectic, symmetric and of order two. With one kick it is
//! the symplectic Euler method of order one.
//!
//! Sources: Ryckaert, Ciccotti, Berendsen, Journal of Computational Physics 23 (1977), 327–341;
//! Andersen, Journal of Computational Physics 52 (1983), 24–34; Hairer, Lubich, Wanner, *Geometric
//! Numerical Integration*, 2nd ed., §VII.1.3.

use crate::integrate::canonical::magnitude;
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations};
use crate::integrate::splitting::{Composition, Trial};
use crate::linalg::vector::{add, combined};
use crate::scalar::{Number, Scalar};
use crate::system::{LeapfrogSystem, MechanicalSystem, OdeSystem, StateVector, StepFailure};

/// A trial step with the change of the velocities.
type Tried<M> = (
    Trial<<M as OdeSystem>::Scalar, <M as MechanicalSystem>::Coordinates>,
    <M as MechanicalSystem>::Coordinates,
);

/// Computes the step with a kick before and after one drift, from `q` and `v` at time `t`, where
/// the acceleration is `start`.
pub(super) fn composed<M: LeapfrogSystem + ?Sized, const DRIFTS: usize>(
    system: &M,
    composition: &Composition<DRIFTS>,
    t: M::Scalar,
    (q, v): (&M::Coordinates, &M::Coordinates),
    h: M::Scalar,
    start: &M::Coordinates,
    work: &mut Work,
) -> Result<Tried<M>, StepFailure<M::Scalar>> {
    let (number, one) = (M::Scalar::from_f64, M::Scalar::ONE);
    let mut gain = combined(&M::Coordinates::ZERO, number(composition.first) * h, start);
    let mut impulse = Impulse { system, t, q, h, sum: M::Coordinates::ZERO, last: M::Coordinates::ZERO };
    let mut velocities = [combined(v, one, &gain)];
    newton::solve(&mut impulse, &mut velocities, Scalar::epsilon(), work)?;
    gain = combined(&gain, one, &impulse.sum);
    let velocity = combined(v, one, &gain);
    let change = combined(&M::Coordinates::ZERO, h, &velocity);
    let (end, position) = (t + h, combined(q, one, &change));
    let acceleration = system.acceleration(end, &position, &velocity);
    let last = composition.rest.iter().fold(0.0, |_, (_, kick)| *kick);
    gain = combined(&gain, number(last) * h, &acceleration);
    let reaction = system.velocity_correction(end, &position, &combined(v, one, &gain));
    gain = combined(&gain, one, &reaction);
    Ok((Trial { h, change, accelerations: [*start, acceleration] }, gain))
}

/// The equations for velocities that lead onto the constraints.
struct Impulse<'a, M: LeapfrogSystem + ?Sized> {
    system: &'a M,
    t: M::Scalar,
    q: &'a M::Coordinates,
    h: M::Scalar,
    /// The sum of all changes of the velocities except the last one, which is still pending.
    sum: M::Coordinates,
    last: M::Coordinates,
}

impl<M: LeapfrogSystem + ?Sized> Equations<M::Scalar, M::Coordinates, 1> for Impulse<'_, M> {
    #[inline]
    fn residual(&mut self, [velocity]: &[M::Coordinates; 1], _work: &mut Work) -> [M::Coordinates; 1] {
        let (one, h) = (M::Scalar::ONE, self.h);
        let to = combined(self.q, h, velocity);
        let correction = self.system.position_correction(self.t, self.q, self.t + h, &to);
        add(&mut self.sum, one, &self.last);
        self.last = combined(&M::Coordinates::ZERO, one / h, &correction);
        [self.last]
    }

    fn correction(&self, residual: &[M::Coordinates; 1]) -> [M::Coordinates; 1] {
        *residual
    }

    fn magnitude(&self, [velocity]: &[M::Coordinates; 1]) -> M::Coordinates {
        magnitude(*velocity, self.q, self.h)
    }
}
