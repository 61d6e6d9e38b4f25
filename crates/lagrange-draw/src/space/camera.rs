//! The camera for a scene in space.
//!
//! Seen from the middle of the scene, the eye is in the direction (cos ε cos α, cos ε sin α, sin
//! ε). Here α is the azimuth from x towards y, and ε the elevation above the plane of x and y. In
//! the picture z points upwards. In perspective, objects are magnified by d/(d − z), where d is the
//! distance of the eye from the middle, and z the height towards it.

use super::vector::{Vector, cross};
use crate::geometry::{add, dot, subtract, times};
use crate::look::Direction;
use crate::picture::Point;

/// An eye directed at the middle of a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Camera {
    pub(super) middle: Vector,
    /// Directions to the right, upwards and towards the eye.
    axes: [Vector; 3],
    /// Distance of the eye; none if it is infinitely far away.
    distance: Option<f64>,
}

/// Distance of the eye relative to the radius of the scene.
pub(crate) const DISTANCE: f64 = 4.0;
/// Direction towards the light: components to the right, upwards and towards the eye.
pub(super) const LIGHT: Vector = [-0.40, 0.55, 0.733];
/// Brightness of faces in shadow.
pub(super) const SHADE: f64 = 0.55;

impl Camera {
    pub(super) fn new(direction: Direction, middle: Vector, radius: f64) -> Camera {
        let ((sin, cos), (rise, level)) = (direction.azimuth.sin_cos(), direction.elevation.sin_cos());
        let (right, towards) = ([-sin, cos, 0.0], [level * cos, level * sin, rise]);
        let distance = direction.is_perspective.then_some(DISTANCE * radius);
        Camera { middle, axes: [right, cross(towards, right), towards], distance }
    }

    /// Projects a point. Returns its position to the right and upwards in world lengths, and its
    /// nearness to the eye.
    pub(super) fn seen(&self, place: Vector) -> (Point, f64) {
        let [x, y, z] = self.axes.map(|axis| dot(axis, subtract(place, self.middle)));
        let nearer = self.distance.map_or(1.0, |distance| distance / (distance - z));
        ([nearer * x, nearer * y], z)
    }

    /// Returns the direction from a point to the eye.
    pub(super) fn towards(&self, place: Vector) -> Vector {
        let [_, _, towards] = self.axes;
        match self.distance {
            Some(distance) => subtract(add(self.middle, times(distance, towards)), place),
            None => towards,
        }
    }

    /// Returns the brightness of a face with this unit normal.
    pub(super) fn brightness(&self, normal: Vector) -> f64 {
        let light = self.axes.iter().zip(LIGHT).map(|(axis, part)| part * dot(*axis, normal)).sum::<f64>();
        SHADE + (1.0 - SHADE) * light.max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Camera, Direction};

    #[test]
    fn from_x_one_sees_y_to_the_right_and_z_upwards() {
        for is_perspective in [false, true] {
            let direction = Direction { azimuth: 0.0, elevation: 0.0, is_perspective };
            let camera = Camera::new(direction, [0.0; 3], 1.0);
            let (point, near) = camera.seen([0.0, 2.0, 3.0]);
            assert_eq!((point, near), ([2.0, 3.0], 0.0));
            assert_eq!(camera.seen([0.5, 0.0, 0.0]).1, 0.5, "x comes towards the eye");
        }
    }

    #[test]
    fn in_perspective_what_is_nearer_is_larger() {
        let direction = Direction { azimuth: 0.0, elevation: 0.0, is_perspective: true };
        let camera = Camera::new(direction, [0.0; 3], 1.0);
        // For d = 4 and z = 1, the magnification is 4/3.
        let ([right, _], _) = camera.seen([1.0, 0.75, 0.0]);
        assert!((right - 1.0).abs() < 1e-15);
    }
}
