//! Systems whose equations can be evaluated for several motions at once, in lanes.

use super::{OdeSystem, StateVector};
use crate::scalar::{Lanes, Number, Scalar};

/// Numbers in lanes.
pub trait SideBySide: Number {
    /// The type of the number in one lane.
    type Element: Number;
    /// A number of this kind with a single lane, which has the results of one of these lanes.
    type One: SideBySide<Element = Self::Element>;
    /// Number of lanes.
    const LANES: usize;

    /// Returns the number in this lane, counted from zero.
    fn lane(self, lane: usize) -> Self::Element;

    /// Stores a number in this lane and leaves the others unchanged.
    fn set_lane(&mut self, lane: usize, value: Self::Element);

    /// Returns the same number in every lane.
    #[inline(always)]
    fn splat(value: Self::Element) -> Self {
        Self::ZERO.each(|_| value)
    }

    /// Applies a function to the number in each lane.
    #[inline(always)]
    fn each(self, function: impl Fn(Self::Element) -> Self::Element) -> Self {
        self.zip(self, |element, _| function(element))
    }

    /// Applies a function to the two numbers in each lane.
    #[inline(always)]
    fn zip(self, other: Self, function: impl Fn(Self::Element, Self::Element) -> Self::Element) -> Self {
        let mut value = self;
        for lane in 0..Self::LANES {
            value.set_lane(lane, function(self.lane(lane), other.lane(lane)));
        }
        value
    }
}

impl<T: Scalar, const N: usize, const FUSED: bool> SideBySide for Lanes<T, N, FUSED> {
    type Element = T;
    type One = Lanes<T, 1, FUSED>;
    const LANES: usize = N;

    #[inline(always)]
    fn lane(self, lane: usize) -> T {
        self.0[lane]
    }

    #[inline(always)]
    fn set_lane(&mut self, lane: usize, value: T) {
        self.0[lane] = value;
    }

    #[inline(always)]
    fn splat(value: T) -> Self {
        Lanes([value; N])
    }

    #[inline(always)]
    fn each(self, function: impl Fn(T) -> T) -> Self {
        Lanes::each(self, function)
    }

    #[inline(always)]
    fn zip(self, other: Self, function: impl Fn(T, T) -> T) -> Self {
        Lanes::zip(self, other, function)
    }
}

/// The equations of a system for numbers of another type, with parameters of that type.
pub trait Equations<S: Number>: Copy {
    /// The state `[q…, v…]`.
    type State: StateVector<S>;
    /// Storage for the Taylor series of the motion; `()` if there are none.
    type Series: Default;

    /// Computes the right-hand side ẏ = f(t, y), as [`OdeSystem`](super::OdeSystem::rhs) does.
    fn rhs(&self, t: S, y: &Self::State) -> Self::State;

    /// True if [`differentiated`](Self::differentiated) is implemented.
    const HAS_DERIVATIVES: bool = false;

    /// Computes the right-hand side with its derivatives. Writes ∂f/∂y in rows to `jacobian`.
    /// Writes ∂f/∂p to one column for each of the parameters and inputs at these indices. Emitted
    /// types provide them with `emit { jacobian, lanes }`.
    #[inline(always)]
    fn differentiated(
        &self,
        _t: S,
        y: &Self::State,
        _jacobian: &mut <Self::State as StateVector<S>>::Square,
        _indices: &[usize],
        _columns: &mut [Self::State],
    ) -> Self::State {
        let mut rates = *y;
        rates.as_mut().fill(S::NAN);
        rates
    }

    /// Computes the coefficients of the motion, as
    /// [`TaylorSystem::expand`](super::TaylorSystem::expand) does; NaN if there are no series.
    #[inline(always)]
    fn expand<const FUSED: bool>(
        &self,
        _t: S,
        _y: &Self::State,
        _series: &mut Self::Series,
        coefficients: &mut [Self::State],
    ) {
        coefficients.iter_mut().for_each(|coefficients| coefficients.as_mut().fill(S::NAN));
    }
}

/// A system that provides its equations for numbers in lanes. Emitted types implement it if the
/// declaration has `emit { lanes }`.
///
/// Every motion has its own parameters, so parameters are also numbers in lanes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not have equations for lanes",
    note = "add `emit {{ lanes }}` to its declaration"
)]
pub trait LanesSystem: OdeSystem {
    /// The equations in numbers of the type S.
    type Lanes<S: Number>: Equations<S>;

    /// Returns the equations with the parameters of this system in every lane.
    fn lanes<S: Number>(&self, splat: impl Fn(Self::Scalar) -> S) -> Self::Lanes<S>;

    /// Stores the parameters of this system in one lane.
    fn set_lane<S: SideBySide<Element = Self::Scalar>>(&self, lanes: &mut Self::Lanes<S>, lane: usize);
}

/// A visitor of systems whose equations can be evaluated in lanes.
pub trait LanesVisitor<M> {
    /// The result.
    type Output;

    /// Visits the system.
    fn visit(self) -> Self::Output
    where
        M: LanesSystem;
}
