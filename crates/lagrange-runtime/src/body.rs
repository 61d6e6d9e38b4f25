//! The motion of rigid bodies: velocities and accelerations of their points, instantaneous centres,
//! angular momentum.
//!
//! [`Motion`] describes a body in the plane, [`SpatialMotion`] a body in space.
//!
//! The own coordinates X, Y of a body in the plane rotate with the body by its angle φ,
//! counterclockwise. Let ω = φ̇ and e_z × (x, y) = (−y, x). A point Q of the body at ρ from another
//! point P of the body then has
//!
//! ```text
//! v_Q = v_P + ω e_z × ρ,    a_Q = a_P + ω̇ e_z × ρ − ω² ρ.
//! ```
//!
//! Both are evaluated at one moment of a motion, without forces or integration. Types declared with
//! `emit { motion }` return one for each body.
//!
//! ```
//! use lagrange::body::Motion;
//!
//! // A wheel of radius ½ that rolls to the right along y = 0 touches it in its instantaneous centre.
//! let wheel = Motion {
//!     mass: 2.0,
//!     inertia: 0.25,
//!     centroid: [0.0, 0.0],
//!     center: [3.0, 0.5],
//!     angle: 0.0,
//!     velocity: [1.0, 0.0],
//!     angular_velocity: -2.0,
//!     acceleration: [0.0, 0.0],
//!     angular_acceleration: 0.0,
//! };
//! assert_eq!(wheel.instant_center(), Some([3.0, 0.0]));
//! assert_eq!(wheel.velocity_at([0.0, 0.5]), [2.0, 0.0]);
//! assert_eq!(wheel.kinetic_energy(), 1.5);
//! ```
//!
//! Source: Meriam, Kraige, *Engineering Mechanics: Dynamics*, ch. 5 (kinematics) and ch. 6 (the
//! axiom of angular momentum).

mod spatial;

use crate::Scalar;

pub use spatial::SpatialMotion;

/// The motion of a plane rigid body at one moment.
///
/// Positions are in m, angles in rad, masses in kg, times in s, if the numbers of the declaration
/// are. Points of the body are given in own coordinates `[X, Y]`, places in the plane as `[x, y]`.
/// If a value is not finite, every number that depends on it is NaN or infinite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Motion<S> {
    /// The mass.
    pub mass: S,
    /// The moment of inertia about the centre of mass.
    pub inertia: S,
    /// The centre of mass in the body's own coordinates.
    pub centroid: [S; 2],
    /// The position of the centre of mass.
    pub center: [S; 2],
    /// The angle φ by which the body-fixed axes are rotated.
    pub angle: S,
    /// The velocity of the centre of mass.
    pub velocity: [S; 2],
    /// The angular velocity ω.
    pub angular_velocity: S,
    /// The acceleration of the centre of mass.
    pub acceleration: [S; 2],
    /// The angular acceleration ω̇.
    pub angular_acceleration: S,
}

/// The acceleration of a point Q of a body in three parts. They refer to another point P of the
/// body at distance −ρ.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Acceleration<S> {
    /// a_P, the acceleration of P.
    pub reference: [S; 2],
    /// ω̇ e_z × ρ, at right angles to ρ.
    pub tangential: [S; 2],
    /// −ω² ρ, from Q towards P.
    pub radial: [S; 2],
}

impl<S: Scalar> Acceleration<S> {
    /// Returns the total acceleration, the sum of its parts.
    #[must_use]
    pub fn total(&self) -> [S; 2] {
        sum(self.reference, sum(self.tangential, self.radial))
    }
}

/// Places and directions.
impl<S: Scalar> Motion<S> {
    /// Rotates a direction from body-fixed axes into the plane.
    #[must_use]
    pub fn vector(&self, [x, y]: [S; 2]) -> [S; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [cos * x - sin * y, sin * x + cos * y]
    }

    /// Returns the position of a body-fixed point.
    #[must_use]
    pub fn point(&self, own: [S; 2]) -> [S; 2] {
        sum(self.center, self.between(self.centroid, own))
    }

    /// Returns the own coordinates of the body's point at a place, even outside of its shape: the
    /// inverse of [`point`](Motion::point).
    #[must_use]
    pub fn own(&self, place: [S; 2]) -> [S; 2] {
        sum(self.centroid, self.turned_back(difference(place, self.center)))
    }

    /// Returns a direction of the plane in body-fixed axes.
    fn turned_back(&self, [x, y]: [S; 2]) -> [S; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [cos * x + sin * y, cos * y - sin * x]
    }

    /// Returns ρ from one point of the body to another.
    fn between(&self, from: [S; 2], to: [S; 2]) -> [S; 2] {
        self.vector(difference(to, from))
    }
}

/// Velocities.
impl<S: Scalar> Motion<S> {
    /// Returns the velocity of a point of the body.
    #[must_use]
    pub fn velocity_at(&self, own: [S; 2]) -> [S; 2] {
        sum(self.velocity, scaled(self.angular_velocity, turned(self.between(self.centroid, own))))
    }

    /// Returns the two parts v_P and ω e_z × ρ of the velocity of a point Q of the body, relative
    /// to the point P. Their sum is [`velocity_at`](Motion::velocity_at) for every P.
    #[must_use]
    pub fn velocity_from(&self, own: [S; 2], reference: [S; 2]) -> [[S; 2]; 2] {
        let about = scaled(self.angular_velocity, turned(self.between(reference, own)));
        [self.velocity_at(reference), about]
    }

    /// Returns the instantaneous centre of rotation r_S + e_z × v_S / ω: the place where the point
    /// of the body has no velocity.
    ///
    /// `None` if ω is zero, as in pure translation, or if the centre is not finite, as in a NaN
    /// state. There is no tolerance. If ω differs from zero only by rounding, the centre is very
    /// far away. To omit such centres, compare their distance with a length of your system.
    #[must_use]
    pub fn instant_center(&self) -> Option<[S; 2]> {
        finite(sum(self.center, self.instant_arm()))
    }

    /// Returns the instantaneous centre in the body's own coordinates, where its path is the moving
    /// centrode; `None` as for [`instant_center`](Motion::instant_center).
    #[must_use]
    pub fn own_instant_center(&self) -> Option<[S; 2]> {
        finite(sum(self.centroid, self.turned_back(self.instant_arm())))
    }

    /// Computes e_z × v_S / ω, which is not finite if ω is zero.
    fn instant_arm(&self) -> [S; 2] {
        turned(self.velocity).map(|component| component / self.angular_velocity)
    }
}

/// Accelerations.
impl<S: Scalar> Motion<S> {
    /// Returns the acceleration of a point of the body, in parts relative to the centre of mass.
    #[must_use]
    pub fn acceleration_at(&self, own: [S; 2]) -> Acceleration<S> {
        self.parts(self.acceleration, self.between(self.centroid, own))
    }

    /// Returns the acceleration of a point of the body, in parts relative to the point `reference`,
    /// also in own coordinates. The total does not depend on the reference, but the parts do.
    #[must_use]
    pub fn acceleration_from(&self, own: [S; 2], reference: [S; 2]) -> Acceleration<S> {
        self.parts(self.acceleration_at(reference).total(), self.between(reference, own))
    }

    fn parts(&self, reference: [S; 2], rho: [S; 2]) -> Acceleration<S> {
        let square = self.angular_velocity * self.angular_velocity;
        Acceleration {
            reference,
            tangential: scaled(self.angular_acceleration, turned(rho)),
            radial: scaled(-square, rho),
        }
    }
}

/// Momentum and energy.
impl<S: Scalar> Motion<S> {
    /// Computes m v_S.
    #[must_use]
    pub fn linear_momentum(&self) -> [S; 2] {
        scaled(self.mass, self.velocity)
    }

    /// Returns the angular momentum m (r_S − r_O) × v_S + J_S ω about a place O at rest, positive
    /// counterclockwise.
    #[must_use]
    pub fn angular_momentum(&self, about: [S; 2]) -> S {
        let arm = difference(self.center, about);
        cross(arm, self.linear_momentum()) + self.inertia * self.angular_velocity
    }

    /// Computes ½ m v_S² + ½ J_S ω².
    #[must_use]
    pub fn kinetic_energy(&self) -> S {
        let omega = self.angular_velocity;
        let twice = self.mass * norm_squared(self.velocity) + self.inertia * (omega * omega);
        S::from_f64(0.5) * twice
    }

    /// Returns the moment of inertia J_P = J_S + m r² about a point of the body at distance r from
    /// the centre of mass (Steiner).
    #[must_use]
    pub fn inertia_about(&self, own: [S; 2]) -> S {
        self.inertia + self.mass * norm_squared(difference(own, self.centroid))
    }

    /// Computes the moment of all forces on the body about one of its points P, positive
    /// counterclockwise. By the axiom of angular momentum, it is J_P ω̇ + m (ρ_S × a_P)_z, with ρ_S
    /// from P to the centre of mass.
    ///
    /// For the centre of mass this is J_S ω̇, for a point at rest J_P ω̇.
    #[must_use]
    pub fn moment_about(&self, own: [S; 2]) -> S {
        let acceleration = self.acceleration_at(own).total();
        let carried = self.mass * cross(self.between(own, self.centroid), acceleration);
        self.inertia_about(own) * self.angular_acceleration + carried
    }
}

fn finite<S: Scalar>(place: [S; 2]) -> Option<[S; 2]> {
    place.iter().all(|component| component.is_finite()).then_some(place)
}

/// Computes e_z × a.
fn turned<S: Scalar>([x, y]: [S; 2]) -> [S; 2] {
    [-y, x]
}

fn sum<S: Scalar>(a: [S; 2], b: [S; 2]) -> [S; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn difference<S: Scalar>(a: [S; 2], b: [S; 2]) -> [S; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn scaled<S: Scalar>(factor: S, a: [S; 2]) -> [S; 2] {
    a.map(|component| factor * component)
}

fn norm_squared<S: Scalar>([x, y]: [S; 2]) -> S {
    x * x + y * y
}

/// Computes (a × b)_z.
fn cross<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests;
