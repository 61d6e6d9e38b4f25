//! Contact points of cuboids and capsules: faces and edges.
//!
//! Both are a [`Block`], a cuboid with a radius around it. A cuboid has the radius zero, and a
//! capsule two half sizes of zero. Two blocks touch in up to eight points, each with a place, the
//! common normal and a gap. Their places in the result are fixed, so that forces can be kept from
//! one step to the next.
//!
//! 1. **Separation** (`separation`): the faces of both cuboids and the products of their edges are
//!    all directions in which they may be apart, or overlap least.
//! 2. **Faces** (`faces`): if a face separates them most, its sides clip the opposite face. Each
//!    corner of what remains is a contact point, with its own gap along the normal.
//! 3. **Features** (`features`): otherwise, edges or corners are closest. Their closest points are
//!    the only contact, but parallel edges have one at either end of what they share.
//!
//! The smallest gap is the distance of the blocks, and if they overlap the negative depth. The
//! depth is the length of the shortest displacement that separates them. Blocks that are farther
//! apart than their sizes have one contact with a lower bound of their distance.
//!
//! A face takes precedence over edges that separate blocks by 10⁻⁹ of their size more. Contact
//! points of a block at rest would otherwise change with rounding.
//!
//! A cube with the side 2 lies at the height 1.9 over another one. They touch in four points with
//! the gap −0.1 and the normal (0, 0, 1). Moved by 1 along x, the upper cube keeps four points. Two
//! are at x = 0, where it ends, and two at x = 1, where the lower one does.
//!
//! Source of separating axes: Gottschalk, Lin, Manocha, "OBBTree", *SIGGRAPH* 1996, §5. Of closest
//! segments: Ericson, *Real-Time Collision Detection*, §5.1.9. Of clipping: Sutherland, Hodgman,
//! "Reentrant polygon clipping", *Commun. ACM* 17 (1974) 32–42.

mod faces;
mod features;
mod separation;
#[cfg(test)]
mod tests;

use core::array;

use self::faces::between_faces;
use self::features::closest_features;
use self::separation::{Separation, separation};
use crate::linalg::space::{Triple, multiple, norm};
use crate::linalg::vector::{combined, difference, dot};
use crate::scalar::Scalar;

/// The largest number of points in which two blocks touch.
pub const MAX_TOUCHES: usize = 8;

/// Numbers of a contact point: a place in each block, the normal, a tangent and a distance.
pub const TOUCH_LENGTH: usize = 13;

/// A cuboid with a radius around it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Block<S> {
    /// Its centre.
    pub center: [S; 3],
    /// Its axes, perpendicular unit vectors.
    pub axes: [[S; 3]; 3],
    /// Half of its size along each axis; zero where it has none.
    pub half: [S; 3],
    /// The radius around it.
    pub radius: S,
}

/// A contact point of two blocks.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Touch<S> {
    /// The place in the first cuboid, without the radius around it.
    pub on_first: [S; 3],
    /// The place in the second cuboid, without the radius around it.
    pub on_second: [S; 3],
    /// The unit normal, from the second block to the first.
    pub normal: [S; 3],
    /// Distance of the blocks there; negative where they overlap.
    pub gap: S,
}

/// Contact points of two blocks, in fixed places.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Manifold<S> {
    touches: [Touch<S>; MAX_TOUCHES],
    count: usize,
}

impl<S: Scalar> Block<S> {
    /// Returns the sum of the half sizes and the radius.
    fn size(&self) -> S {
        self.half.iter().fold(self.radius, |sum, half| sum + *half)
    }

    /// True if it extends along an axis.
    fn extends(&self, axis: usize) -> bool {
        self.half[axis] > S::ZERO
    }

    /// Returns the place of a point in its axes, from its centre.
    fn own(&self, point: &Triple<S>) -> Triple<S> {
        let arm = difference(point, &self.center);
        self.axes.map(|axis| dot(&axis, &arm))
    }

    /// Returns the place of own coordinates.
    fn place(&self, own: &Triple<S>) -> Triple<S> {
        let mut place = self.center;
        for (axis, &length) in self.axes.iter().zip(own) {
            place = combined(&place, length, axis);
        }
        place
    }

    /// Returns half of the extent along a direction.
    fn reach(&self, direction: &Triple<S>) -> S {
        let shares = self.axes.iter().zip(&self.half);
        shares.fold(S::ZERO, |sum, (axis, half)| dot(axis, direction).abs().multiply_add(*half, sum))
    }
}

impl<S: Scalar> Manifold<S> {
    /// Creates a manifold without contact points.
    fn new() -> Self {
        let none = [S::ZERO; 3];
        let touch = Touch { on_first: none, on_second: none, normal: none, gap: S::ZERO };
        Manifold { touches: [touch; MAX_TOUCHES], count: 0 }
    }

    fn push(&mut self, touch: Touch<S>) {
        if self.count < MAX_TOUCHES {
            self.touches[self.count] = touch;
            self.count += 1;
        }
    }

    /// Returns the contact points, at least one.
    pub fn touches(&self) -> &[Touch<S>] {
        &self.touches[..self.count]
    }

    /// Returns the smallest gap.
    pub fn gap(&self) -> S {
        let gaps = self.touches().iter().map(|touch| touch.gap);
        gaps.reduce(|least, gap| if gap < least { gap } else { least }).unwrap_or(S::NAN)
    }
}

/// Returns the contact points of two blocks. If a number is NaN, so are their gaps.
pub fn manifold<S: Scalar>(first: &Block<S>, second: &Block<S>) -> Manifold<S> {
    let size = first.size() + second.size();
    let found = separation(first, second, size);
    let radius = first.radius + second.radius;
    let mut manifold = match found {
        Separation { distance, .. } if distance > size || !distance.is_finite() => far(first, second, &found),
        Separation { face: Some(_), .. } => {
            let faces = between_faces(first, second, &found);
            match faces.count > 0 && faces.gap() <= found.distance + slack(size) {
                true => faces,
                false => closest_features(first, second, &found, size),
            }
        }
        _ => closest_features(first, second, &found, size),
    };
    for touch in &mut manifold.touches[..manifold.count] {
        touch.gap = touch.gap - radius;
    }
    manifold
}

/// Returns the centres as the contact of blocks that are far apart.
fn far<S: Scalar>(first: &Block<S>, second: &Block<S>, found: &Separation<S>) -> Manifold<S> {
    let mut manifold = Manifold::new();
    let (on_first, on_second) = (first.center, second.center);
    manifold.push(Touch { on_first, on_second, normal: found.normal, gap: found.distance });
    manifold
}

/// Returns distances that count as equal for blocks of this size: 10⁻⁹ of it for `f64`.
fn slack<S: Scalar>(size: S) -> S {
    S::from_f64(0.0625) * S::epsilon().sqrt() * size
}

/// Returns the first contact points of two blocks as numbers.
///
/// They are the places in the coordinates of both blocks, the normal n, a tangent, and the gap less
/// n·(p₁ − p₂). Both blocks are given by their centre, their axes and half sizes, and the radius
/// around them. Places beyond the last contact point repeat the first one, with a gap that is
/// larger by the size of the blocks. Nothing touches there.
pub fn touches<S: Scalar, const M: usize>(numbers: [S; 32]) -> [S; M] {
    let block = |at: usize| {
        let triple = |from: usize| array::from_fn(|i| numbers[at + from + i]);
        let axes = array::from_fn(|axis| triple(3 + 3 * axis));
        Block { center: triple(0), axes, half: triple(12), radius: numbers[at + 15] }
    };
    let (first, second) = (block(0), block(16));
    let found = manifold(&first, &second);
    let mut results = [S::ZERO; M];
    for (k, results) in results.chunks_mut(TOUCH_LENGTH).enumerate() {
        let is_present = k < found.count;
        let touch = &found.touches[if is_present { k } else { 0 }];
        let core = dot(&touch.normal, &difference(&touch.on_first, &touch.on_second));
        let beyond = if is_present { S::ZERO } else { first.size() + second.size() };
        let [a, b] = [first.own(&touch.on_first), second.own(&touch.on_second)];
        let tangent = tangent(&second, &touch.normal);
        let vectors = a.iter().chain(&b).chain(&touch.normal).chain(&tangent).copied();
        let numbers = vectors.chain([touch.gap + beyond - core]);
        results.iter_mut().zip(numbers).for_each(|(result, number)| *result = number);
    }
    results
}

/// Returns the unit vector across a normal that is closest to the axis of a block the least along
/// it.
fn tangent<S: Scalar>(block: &Block<S>, normal: &Triple<S>) -> Triple<S> {
    let slope = |axis: usize| dot(&block.axes[axis], normal).abs();
    let least = (1..3).fold(0, |least, axis| if slope(axis) < slope(least) { axis } else { least });
    let axis = &block.axes[least];
    let across = combined(axis, -dot(axis, normal), normal);
    multiple(S::ONE / norm(&across), &across)
}
