//! Detection of marks that rotate and move without changing their shape.
//!
//! The least-squares rotation between two sets of corresponding points about their means is the
//! angle of Σ (a·b, a×b). Source: Kanatani, *Statistical Optimization for Geometric Computation*
//! (1996), the plane case of fitting a rotation.

use std::f64::consts::TAU;

use crate::film::points;
use crate::geometry::{cross, dot, length, moved, subtract};
use crate::picture::{Point, Segment};

/// The pose of a mark: its coordinates are rotated by the angle and then translated.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Pose {
    /// Origin of its coordinates, in pixels.
    pub(super) at: Point,
    /// Angle in radians, clockwise on screen, since y points downwards.
    pub(super) angle: f64,
}

/// Maximum distance of points from their positions under a rigid motion, in pixels; equal to the
/// rounding of written numbers.
const TOLERANCE: f64 = 0.01;

/// Returns the shape in its own coordinates, and its pose in each picture with the mark; none if
/// the shape changes.
pub(super) fn rigid_motion(
    first: &[Segment],
    shapes: &[Option<&[Segment]>],
) -> Option<(Vec<Segment>, Vec<Option<Pose>>)> {
    let pivot = mean(&all_points(first))?;
    let own = moved(first, |point| subtract(point, pivot));
    let corners = all_points(&own);
    let mut angle = 0.0;
    let mut poses = Vec::with_capacity(shapes.len());
    for shape in shapes {
        let Some(shape) = shape else {
            poses.push(None);
            continue;
        };
        let pose = fit(&corners, &all_points(shape), angle)?;
        angle = pose.angle;
        poses.push(Some(pose));
    }
    Some((own, poses))
}

/// Returns the pose that maps points about the origin to others, with the angle nearest to the
/// previous one.
fn fit(own: &[Point], points: &[Point], before: f64) -> Option<Pose> {
    let at = mean(points)?;
    let (mut along, mut across) = (0.0, 0.0);
    for (a, point) in own.iter().zip(points) {
        let b = subtract(*point, at);
        along += dot(*a, b);
        across += cross(*a, b);
    }
    let angle = across.atan2(along);
    let angle = angle + TAU * ((before - angle) / TAU).round();
    let pose = Pose { at, angle };
    let (sin, cos) = angle.sin_cos();
    let is_there = |(a, point): (&Point, &Point)| {
        let there = [at[0] + cos * a[0] - sin * a[1], at[1] + sin * a[0] + cos * a[1]];
        length(subtract(*point, there)) <= TOLERANCE
    };
    own.iter().zip(points).all(is_there).then_some(pose)
}

fn all_points(segments: &[Segment]) -> Vec<Point> {
    segments.iter().copied().flat_map(points).collect()
}

fn mean(points: &[Point]) -> Option<Point> {
    let count = points.len() as f64;
    let sum = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    (!points.is_empty()).then(|| [sum(0), sum(1)])
}
