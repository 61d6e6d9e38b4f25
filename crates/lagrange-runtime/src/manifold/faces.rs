//! Contact points of a face and what lies on it.

use super::separation::Separation;
use super::{Block, Manifold, Touch};
use crate::linalg::space::Triple;
use crate::linalg::vector::{combined, difference, dot};
use crate::scalar::Scalar;

/// Corners of a face that is clipped by four planes.
const MAX_CORNERS: usize = 8;

/// A convex polygon.
struct Polygon<S> {
    corners: [Triple<S>; MAX_CORNERS],
    count: usize,
}

impl<S: Scalar> Polygon<S> {
    fn new() -> Self {
        Polygon { corners: [[S::ZERO; 3]; MAX_CORNERS], count: 0 }
    }

    fn corners(&self) -> &[Triple<S>] {
        &self.corners[..self.count]
    }

    /// Adds a corner, unless it is there already. Segments and points count as polygons.
    fn push(&mut self, corner: Triple<S>) {
        if self.count < MAX_CORNERS && !self.corners().contains(&corner) {
            self.corners[self.count] = corner;
            self.count += 1;
        }
    }

    /// Returns the part of it in which n·p ≤ limit.
    fn clipped(&self, normal: &Triple<S>, limit: S) -> Self {
        let mut clipped = Polygon::new();
        let beyond = |corner: &Triple<S>| dot(normal, corner) - limit;
        for (k, corner) in self.corners().iter().enumerate() {
            let next = &self.corners()[(k + 1) % self.count];
            let (here, there) = (beyond(corner), beyond(next));
            if here <= S::ZERO {
                clipped.push(*corner);
            }
            // From inside to outside, so that a segment is cut in the same point both ways.
            if here < S::ZERO && there > S::ZERO {
                clipped.push(combined(corner, here / (here - there), &difference(next, corner)));
            } else if there < S::ZERO && here > S::ZERO {
                clipped.push(combined(next, there / (there - here), &difference(corner, next)));
            }
        }
        clipped
    }
}

/// Returns the contact points of the face that separates two cuboids; none if nothing is over it.
pub(super) fn between_faces<S: Scalar>(
    first: &Block<S>,
    second: &Block<S>,
    found: &Separation<S>,
) -> Manifold<S> {
    let mut manifold = Manifold::new();
    let Some((is_first, axis)) = found.face else { return manifold };
    let (owner, other) = if is_first { (first, second) } else { (second, first) };
    // The normal out of the face.
    let outward = if is_first { found.normal.map(|component| -component) } else { found.normal };
    let mut polygon = facing(other, &outward);
    for side in (0..3).filter(|&side| side != axis) {
        let (direction, half) = (owner.axes[side], owner.half[side]);
        let middle = dot(&direction, &owner.center);
        polygon = polygon.clipped(&direction, middle + half);
        polygon = polygon.clipped(&direction.map(|component| -component), half - middle);
    }
    let level = dot(&outward, &owner.center) + owner.half[axis];
    for corner in polygon.corners() {
        let gap = dot(&outward, corner) - level;
        let foot = combined(corner, -gap, &outward);
        let (on_first, on_second) = if is_first { (foot, *corner) } else { (*corner, foot) };
        manifold.push(Touch { on_first, on_second, normal: found.normal, gap });
    }
    manifold
}

/// Returns the face of a cuboid that lies against a direction the most; of a segment an end or all
/// of it.
fn facing<S: Scalar>(block: &Block<S>, outward: &Triple<S>) -> Polygon<S> {
    let slope = |axis: usize| dot(&block.axes[axis], outward);
    let steepest =
        (1..3).fold(0, |best, axis| if slope(axis).abs() > slope(best).abs() { axis } else { best });
    let [u, v] = [(steepest + 1) % 3, (steepest + 2) % 3];
    let mut own = [S::ZERO; 3];
    own[steepest] = if slope(steepest) > S::ZERO { -block.half[steepest] } else { block.half[steepest] };
    let mut polygon = Polygon::new();
    for [left, right] in [[-S::ONE, -S::ONE], [S::ONE, -S::ONE], [S::ONE, S::ONE], [-S::ONE, S::ONE]] {
        (own[u], own[v]) = (left * block.half[u], right * block.half[v]);
        polygon.push(block.place(&own));
    }
    polygon
}
