//! Truth values of numbers in lanes.

use core::fmt::Debug;
use core::ops::{BitAnd, BitOr, Not};

/// The result of comparing [numbers](super::Number): a `bool`, or one truth value per lane.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> + 'static
{
    /// Returns the same value in every lane.
    fn splat(value: bool) -> Self;

    /// True if the value is true in any lane.
    fn any(self) -> bool;

    /// True if the value is true in every lane.
    fn all(self) -> bool;

    /// True if the value is true in this lane, counted from zero.
    fn lane(self, lane: usize) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn splat(value: bool) -> bool {
        value
    }

    #[inline(always)]
    fn any(self) -> bool {
        self
    }

    #[inline(always)]
    fn all(self) -> bool {
        self
    }

    #[inline(always)]
    fn lane(self, _lane: usize) -> bool {
        self
    }
}
