//! Bodies composed of several parts.

use super::{polygon, polygon_center, steiner};
use crate::scalar::Scalar;

/// The mass properties of a plane body: mass, centre of mass and moment of inertia.
///
/// Bodies are composed by [`with`](MassGeometry::with) and [`without`](MassGeometry::without).
/// Parts are brought to their places by [`moved`](MassGeometry::moved) and
/// [`turned`](MassGeometry::turned).
///
/// ```
/// use lagrange::inertia::{MassGeometry, disk, semicircular_disk, semicircular_disk_center};
///
/// // Two half-disks make a disk.
/// let half = MassGeometry::new(1.0, semicircular_disk_center(0.5), semicircular_disk(1.0, 0.5_f64));
/// let whole = half.with(half.turned(std::f64::consts::PI));
/// assert!((whole.inertia - disk(2.0, 0.5)).abs() < 1e-15);
/// assert!(whole.center[0].hypot(whole.center[1]) < 1e-15);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MassGeometry<S> {
    /// The mass m; kg.
    pub mass: S,
    /// The centre of mass; m.
    pub center: [S; 2],
    /// The moment of inertia about the centre of mass; kg m².
    pub inertia: S,
}

impl<S: Scalar> MassGeometry<S> {
    /// Creates a body with this mass, this centre of mass, and this moment of inertia about the
    /// centre of mass.
    pub fn new(mass: S, center: [S; 2], inertia: S) -> MassGeometry<S> {
        MassGeometry { mass, center, inertia }
    }

    /// Creates a homogeneous polygon from its corners in either orientation; NaN whenever
    /// [`polygon`] returns NaN.
    pub fn polygon(mass: S, corners: &[[S; 2]]) -> MassGeometry<S> {
        MassGeometry { mass, center: polygon_center(corners), inertia: polygon(mass, corners) }
    }

    /// Combines both by Steiner's theorem. The moment of inertia is J₁ + J₂ + m₁ m₂/(m₁ + m₂) d²,
    /// where d is the distance of the centres of mass.
    ///
    /// The centre of mass is not finite if the masses add up to zero.
    #[must_use]
    pub fn with(self, part: MassGeometry<S>) -> MassGeometry<S> {
        let mass = self.mass + part.mass;
        let fraction = part.mass / mass;
        let offset = [part.center[0] - self.center[0], part.center[1] - self.center[1]];
        let distance = offset[0].hypot(offset[1]);
        MassGeometry {
            mass,
            center: [self.center[0] + fraction * offset[0], self.center[1] + fraction * offset[1]],
            inertia: steiner(self.inertia + part.inertia, self.mass * fraction, distance),
        }
    }

    /// Removes a part: adds it with a negative mass and moment of inertia.
    ///
    /// The hole must lie within the body, which is not checked.
    #[must_use]
    pub fn without(self, hole: MassGeometry<S>) -> MassGeometry<S> {
        self.with(MassGeometry { mass: -hole.mass, center: hole.center, inertia: -hole.inertia })
    }

    /// Translates the body.
    #[must_use]
    pub fn moved(self, by: [S; 2]) -> MassGeometry<S> {
        MassGeometry { center: [self.center[0] + by[0], self.center[1] + by[1]], ..self }
    }

    /// Rotates the body about the origin by an angle in rad, counterclockwise.
    #[must_use]
    pub fn turned(self, angle: S) -> MassGeometry<S> {
        let (sine, cosine) = angle.sin_cos();
        let [x, y] = self.center;
        MassGeometry { center: [cosine * x - sine * y, sine * x + cosine * y], ..self }
    }

    /// Returns the moment of inertia about a point: J + m r², by Steiner's theorem.
    pub fn about(self, point: [S; 2]) -> S {
        let distance = (self.center[0] - point[0]).hypot(self.center[1] - point[1]);
        steiner(self.inertia, self.mass, distance)
    }
}
