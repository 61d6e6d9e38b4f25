//! Closest points of corners, edges and faces.

use super::separation::{Separation, parallel};
use super::{Block, Manifold, Touch, slack};
use crate::linalg::singular::negligible;
use crate::linalg::space::{Triple, cross, multiple, norm};
use crate::linalg::vector::{combined, difference, dot};
use crate::scalar::Scalar;

/// A pair of points in both cuboids.
#[derive(Clone, Copy)]
struct Pair<S> {
    on_first: Triple<S>,
    on_second: Triple<S>,
    distance: S,
}

/// An edge: its middle, its direction and half of its length.
#[derive(Clone, Copy)]
struct Edge<S> {
    middle: Triple<S>,
    direction: Triple<S>,
    half: S,
}

impl<S: Scalar> Edge<S> {
    /// True if the sphere around it is as close as this to a cuboid.
    fn is_within(&self, block: &Block<S>, limit: S) -> bool {
        let distance = norm(&difference(&self.middle, &within(block, &self.middle)));
        distance <= limit + self.half
    }
}

/// An edge of the first cuboid and one of the second.
type EdgePair<S> = (Edge<S>, Edge<S>);

/// Returns the contact of the closest points of two cuboids. Cuboids that overlap touch where the
/// edges of the found direction do, or at the middle of both if it has none.
pub(super) fn closest_features<S: Scalar>(
    first: &Block<S>,
    second: &Block<S>,
    found: &Separation<S>,
    size: S,
) -> Manifold<S> {
    let mut manifold = Manifold::new();
    if let Some((i, j)) = found.edges {
        let [a, b] = [(first, i, -S::ONE), (second, j, S::ONE)]
            .map(|(block, axis, side)| supporting(block, axis, &multiple(side, &found.normal)));
        let pair = nearest(&a, &b);
        if (pair.distance - found.distance.abs()).abs() <= slack(size) {
            let Pair { on_first, on_second, .. } = pair;
            manifold.push(Touch { on_first, on_second, normal: found.normal, gap: found.distance });
            return manifold;
        }
    }
    let (pair, edges) = closest_pair(first, second, size);
    let Some(pair) = pair else { return undefined(manifold) };
    let is_apart = found.distance > S::ZERO || pair.distance > slack(size);
    let normal = match is_apart && pair.distance > S::ZERO {
        true => multiple(S::ONE / pair.distance, &difference(&pair.on_first, &pair.on_second)),
        false => found.normal,
    };
    let gap = if is_apart { pair.distance } else { found.distance };
    let is_closest = |ends: &[Pair<S>; 2]| ends.iter().any(|end| end.distance <= pair.distance + slack(size));
    let ends = edges.filter(|_| is_apart).and_then(|(a, b)| shared_ends(&a, &b)).filter(is_closest);
    let pairs = ends.unwrap_or([Pair { distance: gap, ..pair }; 2]);
    for Pair { on_first, on_second, distance: gap } in
        pairs.into_iter().take(if ends.is_some() { 2 } else { 1 })
    {
        manifold.push(Touch { on_first, on_second, normal, gap });
    }
    manifold
}

/// Returns a contact of blocks with a number that is NaN.
fn undefined<S: Scalar>(mut manifold: Manifold<S>) -> Manifold<S> {
    let nan = [S::NAN; 3];
    manifold.push(Touch { on_first: nan, on_second: nan, normal: nan, gap: S::NAN });
    manifold
}

/// Returns the edge along an axis that reaches farthest in a direction.
fn supporting<S: Scalar>(block: &Block<S>, axis: usize, direction: &Triple<S>) -> Edge<S> {
    let own = [0, 1, 2].map(|other| match other == axis {
        true => S::ZERO,
        false if dot(&block.axes[other], direction) < S::ZERO => -block.half[other],
        false => block.half[other],
    });
    Edge { middle: block.place(&own), direction: block.axes[axis], half: block.half[axis] }
}

/// Returns the closest points of two cuboids that are apart, and the edges on which they are, if
/// they are.
///
/// Edges are compared only if the spheres around them are as close as the closest corner. Of two
/// corners beside each other, 9 of the 144 pairs of edges remain.
fn closest_pair<S: Scalar>(
    first: &Block<S>,
    second: &Block<S>,
    size: S,
) -> (Option<Pair<S>>, Option<EdgePair<S>>) {
    let corner = closest_corner(first, second);
    let limit = corner.map_or(S::ONE / S::ZERO, |pair| pair.distance + slack(size));
    let (mut best, mut on_edges) = (None::<Pair<S>>, None);
    for a in edges(first).filter(|a| a.is_within(second, limit)) {
        for b in edges(second).filter(|b| b.is_within(first, limit)) {
            let pair = nearest(&a, &b);
            if best.is_none_or(|best| pair.distance < best.distance) {
                best = Some(pair);
                on_edges = Some((a, b));
            }
        }
    }
    // Equal distances are those of edges, of which two points are known.
    if let Some(corner) = corner.filter(|corner| best.is_none_or(|best| corner.distance < best.distance)) {
        (best, on_edges) = (Some(corner), None);
    }
    (best.filter(|best| best.distance.is_finite()), on_edges)
}

/// Returns the corner of one cuboid that is closest to the other; `None` if none has a distance.
fn closest_corner<S: Scalar>(first: &Block<S>, second: &Block<S>) -> Option<Pair<S>> {
    let corners = corners(first).map(|corner| {
        let on_second = within(second, &corner);
        Pair { on_first: corner, on_second, distance: norm(&difference(&corner, &on_second)) }
    });
    let others = self::corners(second).map(|corner| {
        let on_first = within(first, &corner);
        Pair { on_first, on_second: corner, distance: norm(&difference(&corner, &on_first)) }
    });
    let pairs = corners.chain(others).filter(|pair| pair.distance.is_finite());
    pairs.reduce(|best, pair| if pair.distance < best.distance { pair } else { best })
}

/// Returns the corners of a cuboid, each once.
fn corners<S: Scalar>(block: &Block<S>) -> impl Iterator<Item = Triple<S>> + '_ {
    (0..8).filter_map(move |number| {
        let is_above = |axis: usize| number >> axis & 1 == 1;
        let is_repeated = (0..3).any(|axis| is_above(axis) && !block.extends(axis));
        let own = [0, 1, 2].map(|axis| if is_above(axis) { block.half[axis] } else { -block.half[axis] });
        (!is_repeated).then(|| block.place(&own))
    })
}

/// Returns the edges of a cuboid, each once.
fn edges<S: Scalar>(block: &Block<S>) -> impl Iterator<Item = Edge<S>> + '_ {
    (0..12).filter_map(move |number| {
        let (axis, sides) = (number / 4, [number & 1, number >> 1 & 1]);
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        let is_repeated = others.iter().zip(sides).any(|(&other, side)| side == 1 && !block.extends(other));
        if is_repeated || !block.extends(axis) {
            return None;
        }
        let mut own = [S::ZERO; 3];
        for (other, side) in others.into_iter().zip(sides) {
            own[other] = if side == 1 { block.half[other] } else { -block.half[other] };
        }
        Some(Edge { middle: block.place(&own), direction: block.axes[axis], half: block.half[axis] })
    })
}

/// Returns the point of a cuboid that is closest to another.
fn within<S: Scalar>(block: &Block<S>, point: &Triple<S>) -> Triple<S> {
    let own = block.own(point);
    block.place(&[0, 1, 2].map(|axis| clamped(own[axis], block.half[axis])))
}

/// Returns the closest points of two edges; of parallel ones those at the middle of what they
/// share.
///
/// Let m be the middles and u the directions. The lines through both cross at s from the first
/// middle, with ((m₁ − m₂) × u₂)·(u₁ × u₂) = −s |u₁ × u₂|². The left side is as accurate as the
/// angle.
fn nearest<S: Scalar>(a: &Edge<S>, b: &Edge<S>) -> Pair<S> {
    let arm = difference(&a.middle, &b.middle);
    let cosine = dot(&a.direction, &b.direction);
    let (on_a, on_b) = (dot(&a.direction, &arm), dot(&b.direction, &arm));
    let across = cross(&a.direction, &b.direction);
    let square = dot(&across, &across);
    let at = |first: S| clamped(cosine.multiply_add(first, on_b), b.half);
    if square <= negligible::<S>() * negligible::<S>() {
        let first = match shared(a, b) {
            Some([from, to]) => S::from_f64(0.5) * (from + to),
            None => clamped(-on_a, a.half),
        };
        return pair_at(a, b, first, at(first));
    }
    let start = -dot(&cross(&arm, &b.direction), &across) / square;
    let second = at(clamped(start, a.half));
    // Once more, because the second may have been moved to its end.
    pair_at(a, b, clamped(cosine.multiply_add(second, -on_a), a.half), second)
}

fn pair_at<S: Scalar>(a: &Edge<S>, b: &Edge<S>, first: S, second: S) -> Pair<S> {
    let on_first = combined(&a.middle, first, &a.direction);
    let on_second = combined(&b.middle, second, &b.direction);
    Pair { on_first, on_second, distance: norm(&difference(&on_first, &on_second)) }
}

/// Returns the part of the first of two parallel edges that is beside the second.
fn shared<S: Scalar>(a: &Edge<S>, b: &Edge<S>) -> Option<[S; 2]> {
    let offset = dot(&a.direction, &difference(&b.middle, &a.middle));
    let from = (offset - b.half).max(-a.half);
    let to = (offset + b.half).min(a.half);
    (from < to).then_some([from, to])
}

/// Returns the closest points at both ends of what parallel edges share; `None` of others.
fn shared_ends<S: Scalar>(a: &Edge<S>, b: &Edge<S>) -> Option<[Pair<S>; 2]> {
    let across = cross(&a.direction, &b.direction);
    if norm(&across) > parallel() {
        return None;
    }
    let arm = difference(&a.middle, &b.middle);
    let (on_b, cosine) = (dot(&b.direction, &arm), dot(&a.direction, &b.direction));
    let at = |first: S| pair_at(a, b, first, clamped(cosine.multiply_add(first, on_b), b.half));
    shared(a, b).map(|ends| ends.map(at))
}

/// Returns a number moved into [−limit, limit]. If it is NaN, it stays so.
fn clamped<S: Scalar>(value: S, limit: S) -> S {
    if value > limit {
        limit
    } else if value < -limit {
        -limit
    } else {
        value
    }
}
