//! The direction in which two cuboids are farthest apart, or overlap least.
//!
//! Along the unit vector n, the cuboids are apart by n·d − Σ |n·a| h. Here, d is the vector between
//! their centres, and a h are their half sides. Normals of the faces of both and the products of
//! their edges are tried. If the largest of these distances is positive, they are apart, and it is
//! a lower bound of their distance. Otherwise, it is the negative depth. A cuboid without a size
//! along two axes is a segment and has no faces, one without any is a point.

use super::{Block, slack};
use crate::linalg::singular::negligible;
use crate::linalg::space::{Triple, cross, multiple, norm};
use crate::linalg::vector::{combined, difference, dot};
use crate::scalar::Scalar;

/// A direction with the distance along it.
pub(super) struct Separation<S> {
    /// The unit vector from the second cuboid to the first.
    pub(super) normal: Triple<S>,
    pub(super) distance: S,
    /// The face whose normal it is: whether of the first cuboid, and its axis.
    pub(super) face: Option<(bool, usize)>,
    /// The axes of the edges whose product it is.
    pub(super) edges: Option<(usize, usize)>,
}

/// Returns the direction in which two cuboids are farthest apart. A face takes precedence over
/// edges.
pub(super) fn separation<S: Scalar>(first: &Block<S>, second: &Block<S>, size: S) -> Separation<S> {
    let arm = difference(&first.center, &second.center);
    let measure = |normal: Triple<S>, face, edges| {
        let ahead = dot(&normal, &arm);
        let normal = if ahead < S::ZERO { normal.map(|component| -component) } else { normal };
        let distance = ahead.abs() - first.reach(&normal) - second.reach(&normal);
        Separation { normal, distance, face, edges }
    };
    let mut best: Option<Separation<S>> = None;
    let mut offer = |found: Separation<S>| {
        let is_better = |best: &Separation<S>| {
            found.distance > best.distance + slack(size) || !found.distance.is_finite()
        };
        if best.as_ref().is_none_or(is_better) {
            best = Some(found);
        }
    };
    for (is_first, block) in [(true, first), (false, second)] {
        for axis in (0..3).filter(|&axis| has_face(block, axis)) {
            offer(measure(block.axes[axis], Some((is_first, axis)), None));
        }
    }
    for i in (0..3).filter(|&i| first.extends(i)) {
        for j in (0..3).filter(|&j| second.extends(j)) {
            if let Some(normal) = product(&first.axes[i], &second.axes[j]) {
                offer(measure(normal, None, Some((i, j))));
            }
        }
    }
    best.unwrap_or_else(|| measure(aside(first, second, &arm), None, None))
}

/// True if the cuboid has a face across an axis.
pub(super) fn has_face<S: Scalar>(block: &Block<S>, axis: usize) -> bool {
    (0..3).all(|other| other == axis || block.extends(other))
}

/// Returns the sine of the angle below which edges may touch at both ends of what they share: 10⁻⁶
/// for `f64`.
pub(super) fn parallel<S: Scalar>() -> S {
    S::from_f64(64.0) * S::epsilon().sqrt()
}

/// Returns the unit vector across two edges; `None` if they are parallel.
fn product<S: Scalar>(a: &Triple<S>, b: &Triple<S>) -> Option<Triple<S>> {
    let across = cross(a, b);
    let length = norm(&across);
    if length <= negligible() {
        return None;
    }
    // Of edges that are almost parallel, the product is mostly rounding, which is not across them.
    let along = |edge: &Triple<S>, normal: &Triple<S>| combined(normal, -dot(edge, normal), edge);
    let normal = along(b, &along(a, &multiple(S::ONE / length, &across)));
    Some(multiple(S::ONE / norm(&normal), &normal))
}

/// Returns a direction for parallel segments or points: that of the vector between them, or if they
/// overlap any across.
fn aside<S: Scalar>(first: &Block<S>, second: &Block<S>, arm: &Triple<S>) -> Triple<S> {
    let segment = [first, second].into_iter().find_map(|block| {
        let axis = (0..3).find(|&axis| block.extends(axis))?;
        Some(block.axes[axis])
    });
    let axis = segment.unwrap_or([S::ZERO; 3]);
    let across = difference(arm, &multiple(dot(&axis, arm), &axis));
    let length = norm(&across);
    if length > S::ZERO {
        return multiple(S::ONE / length, &across);
    }
    let least = (0..3).fold(0, |least, i| if axis[i].abs() < axis[least].abs() { i } else { least });
    let mut other = [S::ZERO; 3];
    other[least] = S::ONE;
    let across = difference(&other, &multiple(dot(&axis, &other), &axis));
    multiple(S::ONE / norm(&across), &across)
}
