//! The motion of rigid bodies in space.
//!
//! The rotation R maps body-fixed axes to the world. ω and α = ω̇ are in world axes, and ρ = R
//! (own − centroid). The point Q of a body with the centre of mass S then has
//!
//! ```text
//! r_Q = r_S + ρ,    v_Q = v_S + ω × ρ,    a_Q = a_S + α × ρ + ω × (ω × ρ).
//! ```
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms*, ch. 2; Goldstein, Poole, Safko, *Classical
//! Mechanics*, §4.9, 5.1 and 5.3.

use crate::Scalar;
use crate::linalg::space::{Triple, cross, multiple};
use crate::linalg::vector::{combined, difference, dot};

/// The motion of a rigid body in space at one moment.
///
/// Positions are in m, masses in kg, times in s, angles in rad, if the numbers of the declaration
/// are. Own coordinates refer to the frame in which the declaration states centroid and inertia.
/// All other vectors are in world axes.
///
/// ```
/// use lagrange::body::SpatialMotion;
///
/// // A top spins about its own z-axis, which lies along the x-axis of the world.
/// let top = SpatialMotion {
///     mass: 2.0,
///     inertia: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]],
///     centroid: [0.0, 0.0, 0.5],
///     center: [0.5, 0.0, 0.0],
///     rotation: [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]],
///     velocity: [0.0; 3],
///     angular_velocity: [4.0, 0.0, 0.0],
///     acceleration: [0.0; 3],
///     angular_acceleration: [0.0; 3],
/// };
/// assert_eq!(top.point([0.0; 3]), [0.0; 3]);
/// assert_eq!(top.angular_momentum(), [12.0, 0.0, 0.0]);
/// assert_eq!(top.kinetic_energy(), 24.0);
/// assert_eq!(top.velocity_of([0.0, 1.0, 0.5]), [0.0, 0.0, 4.0]);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpatialMotion<S> {
    /// The mass.
    pub mass: S,
    /// The tensor of inertia about the centre of mass in body-fixed axes, in rows. It is zero
    /// for a body that never turns and declares none.
    pub inertia: [Triple<S>; 3],
    /// The centre of mass in own coordinates.
    pub centroid: Triple<S>,
    /// The position of the centre of mass.
    pub center: Triple<S>,
    /// The rotation R from body-fixed axes to those of the world, in rows: its columns are the
    /// body's axes.
    pub rotation: [Triple<S>; 3],
    /// The velocity of the centre of mass.
    pub velocity: Triple<S>,
    /// The angular velocity ω.
    pub angular_velocity: Triple<S>,
    /// The acceleration of the centre of mass.
    pub acceleration: Triple<S>,
    /// The angular acceleration ω̇.
    pub angular_acceleration: Triple<S>,
}

/// Places and directions.
impl<S: Scalar> SpatialMotion<S> {
    /// Computes R a: rotates a direction from body-fixed axes into the world.
    #[must_use]
    pub fn vector(&self, own: Triple<S>) -> Triple<S> {
        self.rotation.map(|row| dot(&row, &own))
    }

    /// Computes Rᵀ v, the components of a world vector in body-fixed axes: the inverse of
    /// [`vector`](SpatialMotion::vector).
    #[must_use]
    pub fn to_body(self, vector: Triple<S>) -> Triple<S> {
        let [x, y, z] = self.rotation;
        let [along_x, along_y] = [multiple(vector[0], &x), multiple(vector[1], &y)];
        sum(sum(along_x, along_y), multiple(vector[2], &z))
    }

    /// Returns the place of the point with these own coordinates.
    #[must_use]
    pub fn point(&self, own: Triple<S>) -> Triple<S> {
        sum(self.center, self.arm(own))
    }

    /// Returns ρ from the centre of mass to a point.
    fn arm(&self, own: Triple<S>) -> Triple<S> {
        self.vector(difference(&own, &self.centroid))
    }
}

/// Velocities and accelerations of points.
impl<S: Scalar> SpatialMotion<S> {
    /// Returns the velocity v_S + ω × ρ of the point with these own coordinates.
    #[must_use]
    pub fn velocity_of(&self, own: Triple<S>) -> Triple<S> {
        sum(self.velocity, cross(&self.angular_velocity, &self.arm(own)))
    }

    /// Returns the acceleration a_S + α × ρ + ω × (ω × ρ) of the point with these own coordinates.
    #[must_use]
    pub fn acceleration_of(&self, own: Triple<S>) -> Triple<S> {
        let (arm, spin) = (self.arm(own), self.angular_velocity);
        let tangential = cross(&self.angular_acceleration, &arm);
        let centripetal = cross(&spin, &cross(&spin, &arm));
        sum(self.acceleration, sum(tangential, centripetal))
    }
}

/// Momentum and energy.
impl<S: Scalar> SpatialMotion<S> {
    /// Computes m v_S.
    #[must_use]
    pub fn linear_momentum(&self) -> Triple<S> {
        multiple(self.mass, &self.velocity)
    }

    /// Returns the angular momentum m r_S × v_S + R J Rᵀ ω about the origin of the world.
    #[must_use]
    pub fn angular_momentum(&self) -> Triple<S> {
        self.angular_momentum_about([S::ZERO; 3])
    }

    /// Returns the angular momentum m (r_S − r_P) × v_S + R J Rᵀ ω about a place P at rest.
    #[must_use]
    pub fn angular_momentum_about(&self, place: Triple<S>) -> Triple<S> {
        let orbital = cross(&difference(&self.center, &place), &self.linear_momentum());
        sum(orbital, self.vector(self.own_spin()[1]))
    }

    /// Computes ½ m v_S² + ½ ω·J ω.
    #[must_use]
    pub fn kinetic_energy(&self) -> S {
        let [own, momentum] = self.own_spin();
        let twice = self.mass * dot(&self.velocity, &self.velocity) + dot(&own, &momentum);
        S::from_f64(0.5) * twice
    }

    /// Returns ω and J ω in body-fixed axes.
    fn own_spin(&self) -> [Triple<S>; 2] {
        let own = self.to_body(self.angular_velocity);
        [own, self.inertia.map(|row| dot(&row, &own))]
    }
}

fn sum<S: Scalar>(a: Triple<S>, b: Triple<S>) -> Triple<S> {
    combined(&a, S::ONE, &b)
}

#[cfg(test)]
mod tests;
