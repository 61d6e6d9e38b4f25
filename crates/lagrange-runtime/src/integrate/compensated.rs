//! Sums of many small increments without accumulation of rounding errors.
//!
//! Compensated summation after Kahan and Møller: the rounding remainder of each increment is stored
//! and added to the next one. Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*,
//! §VIII.5, algorithm 5.1.

use super::lane_wise::{chosen, take};
use crate::scalar::Number;
use crate::system::{SideBySide, StateVector};

/// A state and the rounding remainder of its increments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Compensated<Y> {
    value: Y,
    remainder: Y,
}

impl<Y> Compensated<Y> {
    /// Starts at `value`, which counts as exact.
    pub(super) fn new<S: Number>(value: Y) -> Self
    where
        Y: StateVector<S>,
    {
        let mut remainder = value;
        remainder.as_mut().fill(S::ZERO);
        Compensated { value, remainder }
    }

    /// Continues from a sum with the rounding remainder of its increments.
    pub(super) fn with_remainder(value: Y, remainder: Y) -> Self {
        Compensated { value, remainder }
    }

    /// Returns the rounding remainder of the increments.
    pub(super) fn remainder(&self) -> &Y {
        &self.remainder
    }

    /// Returns the sum so far.
    #[inline]
    pub(super) fn value(&self) -> &Y {
        &self.value
    }

    /// Replaces the sum with another value, and keeps the remainder.
    #[inline]
    pub(super) fn replace(&mut self, value: Y) {
        self.value = value;
    }

    /// Selects the first sum if the mask is true, otherwise the second.
    #[inline(always)]
    pub(super) fn select<S: Number>(mask: S::Mask, then: &Self, otherwise: &Self) -> Self
    where
        Y: StateVector<S>,
    {
        Compensated {
            value: chosen(mask, &then.value, &otherwise.value),
            remainder: chosen(mask, &then.remainder, &otherwise.remainder),
        }
    }

    /// Copies the lane `from` of another sum into a lane of this one.
    #[inline(always)]
    pub(super) fn take<S, O, Z>(&mut self, lane: usize, other: &Compensated<Z>, from: usize)
    where
        S: SideBySide,
        Y: StateVector<S>,
        O: SideBySide<Element = S::Element>,
        Z: StateVector<O>,
    {
        take(self.value.as_mut(), lane, other.value.as_ref(), from);
        take(self.remainder.as_mut(), lane, other.remainder.as_ref(), from);
    }

    /// Adds an increment, component by component.
    #[inline(always)]
    pub(super) fn add<S: Number>(&mut self, increment: &Y)
    where
        Y: StateVector<S>,
    {
        let components = self.value.as_mut().iter_mut().zip(self.remainder.as_mut());
        for ((value, remainder), increment) in components.zip(increment.as_ref()) {
            let wanted = *remainder + *increment;
            let before = *value;
            *value = before + wanted;
            *remainder = wanted + (before - *value);
        }
    }
}
