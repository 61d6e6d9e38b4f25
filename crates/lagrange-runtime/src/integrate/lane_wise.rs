//! Small operations on numbers and states lane by lane.

use super::method::MAX_LANES;
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{SideBySide, StateVector};

/// Returns the larger of two numbers; the second if the first is NaN.
#[inline(always)]
pub(super) fn larger<S: SideBySide<Element: Scalar>>(one: S, other: S) -> S {
    one.zip(other, |one, other| if other < one { one } else { other })
}

/// Returns the smaller of two numbers, the second if the first is NaN.
#[inline(always)]
pub(super) fn smaller<S: SideBySide<Element: Scalar>>(one: S, other: S) -> S {
    one.zip(other, |one, other| if one < other { one } else { other })
}

/// True if two numbers are equal.
#[inline(always)]
pub(super) fn is_equal<S: Number>(one: S, other: S) -> S::Mask {
    one.less_equal(other) & other.less_equal(one)
}

/// True in each lane whose components are neither NaN nor infinite.
#[inline(always)]
pub(super) fn are_finite<S: Number, Y: StateVector<S>>(y: &Y) -> S::Mask {
    let zero = y.as_ref().iter().fold(S::ZERO, |sum, component| sum + *component * S::ZERO);
    zero.less_equal(S::ZERO)
}

/// Selects the first state if the mask is true, otherwise the second.
#[inline(always)]
pub(super) fn chosen<S: Number, Y: StateVector<S>>(mask: S::Mask, then: &Y, otherwise: &Y) -> Y {
    let mut chosen = *otherwise;
    for (chosen, then) in chosen.as_mut().iter_mut().zip(then.as_ref()) {
        *chosen = S::select(mask, *then, *chosen);
    }
    chosen
}

/// Copies the lane `from` of other numbers into a lane of these.
#[inline(always)]
pub(super) fn take<S, O>(numbers: &mut [S], lane: usize, others: &[O], from: usize)
where
    S: SideBySide,
    O: SideBySide<Element = S::Element>,
{
    for (number, other) in numbers.iter_mut().zip(others) {
        number.set_lane(lane, other.lane(from));
    }
}

/// Numbers of steps in each lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counts {
    tried: [u64; MAX_LANES],
    taken: [u64; MAX_LANES],
}

impl Counts {
    pub(super) fn new() -> Self {
        Counts { tried: [0; MAX_LANES], taken: [0; MAX_LANES] }
    }

    /// Counts a step in every lane. Returns true if the number of tries exceeds `most` in one of
    /// them.
    #[inline(always)]
    pub(super) fn count<S: SideBySide>(&mut self, is_taken: S::Mask, most: u64) -> bool {
        let mut are_spent = false;
        for lane in 0..S::LANES {
            self.tried[lane] += 1;
            self.taken[lane] += u64::from(is_taken.lane(lane));
            are_spent |= self.tried[lane] > most;
        }
        are_spent
    }

    /// Reverts the count of an accepted step in this lane.
    pub(super) fn take_back(&mut self, lane: usize) {
        self.taken[lane] -= 1;
    }

    pub(super) fn tried(&self, lane: usize) -> u64 {
        self.tried[lane]
    }

    pub(super) fn taken(&self, lane: usize) -> u64 {
        self.taken[lane]
    }

    pub(super) fn take(&mut self, lane: usize, other: &Self, from: usize) {
        self.tried[lane] = other.tried[from];
        self.taken[lane] = other.taken[from];
    }
}
