//! The motion of plane rigid bodies: velocities and accelerations of their points, instantaneous centres, angular momentum.
//!
//! A body's own coordinates X, Y turn with it by its angle φ, counterclockwise. With ω = φ̇ and e_z × (x, y) = (−y, x), a point Q
//! of the body at ρ from another point P of it has
//!
//! ```text
//! v_Q = v_P + ω e_z × ρ,    a_Q = a_P + ω̇ e_z × ρ − ω² ρ.
//! ```
//!
//! Source: Meriam, Kraige, *Engineering Mechanics: Dynamics*, ch. 5.

/// How a plane rigid body moves at one moment.
///
/// Positions are in m, angles in rad, masses in kg, if the numbers of the declaration are.
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
    /// The angle φ by which the body's own axes are turned.
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
