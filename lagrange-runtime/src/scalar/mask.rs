//! Truth values that belong to numbers side by side.

use core::fmt::Debug;
use core::ops::{BitAnd, BitOr, Not};

/// What a comparison of [numbers](super::Number) gives: a `bool`, or as many truth values as there are numbers side by side.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> + 'static
{
    /// The same everywhere.
    fn splat(value: bool) -> Self;

    /// Whether it is true anywhere.
    fn any(self) -> bool;

    /// Whether it is true everywhere.
    fn all(self) -> bool;

    /// Whether it is true in this lane, counted from zero.
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
