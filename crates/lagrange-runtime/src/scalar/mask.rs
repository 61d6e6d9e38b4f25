//! Truth values of numbers in lanes.

use core::fmt::Debug;
use core::ops::{BitAnd, BitOr, Not};

/// The result of comparing [numbers](super::Number): a `bool`, or one truth value per lane.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> + 'static
{
    /// Returns the same value in every lane.
    fn splat(value: bool) -> Self;

    /// True if it is true anywhere.
    fn any(self) -> bool;

    /// True if it is true everywhere.
    fn all(self) -> bool;

    /// True if it is true in this lane, counted from zero.
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
