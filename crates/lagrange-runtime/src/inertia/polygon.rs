//! Polygons given by their corners, as fans of triangles about the first one.
//!
//! A triangle (0, u, w) has twice the area D = u × w and its centroid at (u + w)/3. Its second
//! moment of area about the origin is D (u·u + u·w + w·w)/12. The sum over the edges of a polygon,
//! with signed areas, holds for any origin.

use crate::scalar::Scalar;

/// Returns the moment of inertia of a polygon about its centre of mass, from its corners in either
/// orientation.
///
/// D = u × w for the corners u, w at the ends of an edge, relative to the centre of mass. The
/// moment is m Σ D (u·u + u·w + w·w) / 6 Σ D, with the sums over all edges. Edges must not cross
/// each other. NaN for fewer than three corners and for corners that enclose no area.
///
/// ```
/// use lagrange::inertia::{polygon, rectangle};
///
/// let corners = [[1.0, 1.0], [3.0, 1.0], [3.0, 2.0], [1.0, 2.0_f64]];
/// assert!((polygon(6.0, &corners) - rectangle(6.0, 2.0, 1.0)).abs() < 1e-15);
/// ```
pub fn polygon<S: Scalar>(mass: S, corners: &[[S; 2]]) -> S {
    let center = polygon_center(corners);
    let moment = edges(corners, center).map(|(u, w)| cross(u, w) * (inner(u, u) + inner(u, w) + inner(w, w)));
    mass * total(moment) / (S::from_f64(6.0) * double_area(corners, center))
}

/// Returns the centre of mass of a polygon, from its corners in either orientation. Relative to the
/// first one, it is Σ D (u + w) / 3 Σ D.
///
/// Edges must not cross each other. NaN for fewer than three corners and for corners that enclose
/// no area.
pub fn polygon_center<S: Scalar>(corners: &[[S; 2]]) -> [S; 2] {
    let Some(&first) = corners.first() else { return [S::NAN; 2] };
    let area = double_area(corners, first);
    core::array::from_fn(|axis| {
        let moment = edges(corners, first).map(|(u, w)| cross(u, w) * (u[axis] + w[axis]));
        first[axis] + total(moment) / (S::from_f64(3.0) * area)
    })
}

/// Computes twice the area, positive for corners in counterclockwise order; NaN if it is zero.
fn double_area<S: Scalar>(corners: &[[S; 2]], from: [S; 2]) -> S {
    let area = total(edges(corners, from).map(|(u, w)| cross(u, w)));
    if area == S::ZERO { S::NAN } else { area }
}

/// Returns the ends of the edges, relative to a point.
fn edges<S: Scalar>(corners: &[[S; 2]], from: [S; 2]) -> impl Iterator<Item = ([S; 2], [S; 2])> {
    let seen = move |corner: &[S; 2]| [corner[0] - from[0], corner[1] - from[1]];
    let following = corners.iter().cycle().skip(1);
    corners.iter().zip(following).map(move |(corner, next)| (seen(corner), seen(next)))
}

fn total<S: Scalar>(terms: impl Iterator<Item = S>) -> S {
    terms.fold(S::ZERO, |sum, term| sum + term)
}

fn inner<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}

fn cross<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[1] - a[1] * b[0]
}
