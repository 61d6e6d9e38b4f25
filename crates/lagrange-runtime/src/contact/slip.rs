//! Slip velocities of friction along a line and in a plane.

use core::array;

use super::{Friction, Mode, Terms};
use crate::linalg::vector::dot;
use crate::scalar::{Number, Scalar};

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Returns the direction in which friction k slips, if there is one.
    ///
    /// In a plane this is the direction of the slip velocity, or its opposite after the velocity
    /// has passed zero. Such a slip velocity then continues smoothly up to the event at zero. If it
    /// is only rounding, the previous direction is kept. Any other direction would jump between the
    /// stages of a step, however short the step is.
    pub(super) fn direction(&self, k: usize, is_planar: bool, friction: Friction) -> Option<[S; 2]> {
        let (heading, rounding) = match friction {
            Friction::Slips => return present_direction(self.slip(k, is_planar)),
            Friction::SlipsForwards | Friction::GivesWay(_) | Friction::Sticks => {
                ([S::ONE, S::ZERO], S::ZERO)
            }
            Friction::SlipsBackwards => ([-S::ONE, S::ZERO], S::ZERO),
            Friction::SlipsTowards(heading, pace) => (heading.components(), pace.rounding::<S>()),
        };
        if !is_planar {
            return Some(heading);
        }
        let slip = self.slip(k, true);
        let side = if dot(&slip, &heading) < S::ZERO { -S::ONE } else { S::ONE };
        let ahead = array::from_fn(|i| rounding.multiply_add(heading[i], side * slip[i]));
        present_direction(ahead).or(Some(heading))
    }

    /// Returns the slip velocity of friction k; its second component is zero unless it acts in a
    /// plane.
    pub(super) fn slip(&self, k: usize, is_planar: bool) -> [S; 2] {
        [self.rates[k], if is_planar { self.rates[k + 1] } else { S::ZERO }]
    }
}

/// True if friction k acts in a plane: the next reaction is its second component.
pub(super) fn is_planar<const K: usize>(modes: &[Mode; K], k: usize) -> bool {
    matches!(modes.get(k + 1), Some(Mode::Across(_)))
}

/// Returns the direction of a slip velocity, unless it is zero.
pub(super) fn present_direction<S: Scalar>(slip: [S; 2]) -> Option<[S; 2]> {
    let length = length(&slip);
    (length > S::ZERO).then(|| slip.map(|component| component / length))
}

/// Computes √(x² + y²) without overflow.
pub(super) fn length<S: Scalar>(vector: &[S; 2]) -> S {
    let [x, y] = vector.map(Number::abs);
    let (larger, smaller) = if y > x { (y, x) } else { (x, y) };
    if smaller == S::ZERO {
        return larger;
    }
    let ratio = smaller / larger;
    larger * (S::ONE + ratio * ratio).sqrt()
}
