//! Number types for emitted code.
//!
//! [`Number`] is the contract between emitted formulas and a number type. It is not a general
//! numeric abstraction: it contains only the operations that the language of `system!` can express.
//! [`Scalar`] adds the needs of runs, events and contacts, such as an order for branches. `f64` and
//! `f32` implement both, with the functions of the platform under the `std` feature and the
//! functions of `libm` without it. [`Portable`] numbers have the same bits everywhere.

mod lanes;
mod mask;
mod order;
mod platform;
mod portable;
mod rough;

pub use self::lanes::{LaneMask, Lanes};
pub use self::mask::Mask;
pub use self::portable::Portable;
pub use lagrange_math::Elementary;
#[doc(hidden)]
pub use lagrange_math::functions;

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Declares a method for each row of the list.
macro_rules! methods {
    ($(
        $name:ident $arguments:tt C $c:tt lanes $lanes:tt {
            $(#[$doc:meta])*
            fn($self:ident $(, $other:ident)?) $default:tt
        }
    )*) => {
        $($(#[$doc])* fn $name($self $(, $other: Self)?) -> Self $default)*
    };
}

/// Selects the value of each function that lanes compute together.
macro_rules! value_of {
    (
        $function:ident of $x:ident:
        $(
            $name:ident $arguments:tt C $c:tt lanes($($variant:ident: $module:ident::$formula:ident $(, $domain:ident)?)?) $method:tt
        )*
    ) => {
        match $function {
            $($(Elementary::$variant => $x.$name(),)?)*
        }
    };
}

/// A real number with elementary functions, or several numbers in lanes that pass through the same
/// formulas.
///
/// Angles are in radians. Outside the domain of a function the result is NaN. NaN arguments lead to
/// NaN results, except for `hypot` with an infinite and `powi` with a zero argument, as documented
/// there. Emitted code relies on this to avoid hiding a failed computation. Zeros keep their sign
/// according to IEEE 754.
///
/// Numbers in lanes cannot branch, since lanes may need different branches. They compute both and
/// [`select`](Number::select). Numbers that can branch have the [mask](Mask) type `bool` and are
/// [`Scalar`]s.
///
/// Functions with a default are optional. Defaults are accurate to a few units in the last place,
/// in double precision or less. They build on the required functions: `atan` on
/// [`atan2`](Number::atan2), and `sin_cos` on sine and cosine. A new function of the language
/// always has a default.
pub trait Number:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The result of a comparison: `bool`, or one truth value per lane.
    type Mask: Mask;

    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Not a number.
    const NAN: Self;

    /// Converts to the nearest number; infinite if the magnitude is out of range.
    fn from_f64(value: f64) -> Self;

    /// Converts a number that is given as the sum of its nearest `f64` and what that lacks. By
    /// default the nearest number is converted; numbers wider than `f64` add both.
    #[inline]
    fn from_sum(nearest: f64, remainder: f64) -> Self {
        let _ = remainder;
        Self::from_f64(nearest)
    }

    /// True if this is less than the other; false if either is NaN.
    fn less(self, other: Self) -> Self::Mask;

    /// True if this is less than or equal to the other; false if either is NaN.
    fn less_equal(self, other: Self) -> Self::Mask;

    /// Selects the first number if the mask is true, otherwise the second.
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// Returns the largest whole number that is not above this one, clamped to at least 0 and less
    /// than `count`; 0 for NaN. `None` for numbers in lanes and by default. Tables then use another
    /// search.
    #[inline]
    fn floor_below(self, count: usize) -> Option<usize> {
        let _ = count;
        None
    }

    /// Computes sine and cosine; NaN at infinity.
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    /// Computes sine and cosine of each angle, for declarations with `#[accuracy(fast)]`; NaN at
    /// infinity.
    ///
    /// For `f64` and `f32`, [`lagrange_math`] computes several at a time if the target can. The
    /// error is below 0.9 units in the last place for `f64`, and below 0.5000001 for `f32`. For
    /// other numbers, the default calls [`sin_cos`](Number::sin_cos). The result for an angle must
    /// not depend on the others.
    ///
    /// ```
    /// use lagrange::Number;
    ///
    /// let [(sin_a, cos_a), (sin_b, cos_b)] = f64::sin_cos_each([0.3, 0.5]);
    /// assert!((sin_a * cos_b + cos_a * sin_b - 0.8_f64.sin()).abs() < 1e-15);
    /// ```
    #[inline(always)]
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        angles.map(Self::sin_cos)
    }

    lagrange_math::functions!(methods);

    /// Computes `1 / self`. For `f64` and `f32`, the optimiser does not move this division behind
    /// later calls of [`sin_cos`](Number::sin_cos), nor combine it with others.
    #[inline(always)]
    fn reciprocal(self) -> Self {
        Self::ONE / self
    }

    /// Raises `self` to a real power. NaN for a negative base with an exponent that is not an
    /// integer, and for NaN in either place; otherwise as IEEE 754 `pow`.
    ///
    /// Unlike [`f64::powf`], which hides NaN in 1^NaN and NaN^0.
    fn powf(self, exponent: Self) -> Self;

    /// Returns −1, 0 or +1; zeros keep their sign, NaN stays NaN.
    #[inline(always)]
    fn sign(self) -> Self {
        let or_negative = Self::select(self.less(Self::ZERO), -Self::ONE, self);
        Self::select(Self::ZERO.less(self), Self::ONE, or_negative)
    }

    /// Returns the smaller of two numbers, `self` if they are equal; NaN if either is NaN, unlike
    /// [`f64::min`].
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        let or_other = Self::select(other.less(self), other, Self::NAN);
        Self::select(self.less_equal(other), self, or_other)
    }

    /// Returns the larger of two numbers, `self` if they are equal; NaN if either is NaN, unlike
    /// [`f64::max`].
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        let or_other = Self::select(self.less(other), other, Self::NAN);
        Self::select(other.less_equal(self), self, or_other)
    }

    /// Raises `self` to an integer power, by repeated squaring. For the exponent zero, the result
    /// is one.
    ///
    /// A negative power is the reciprocal of the positive one. Rounding errors grow in proportion
    /// to the exponent. The result depends on no library and is the same on every platform.
    #[inline(always)]
    fn powi(self, exponent: i32) -> Self {
        let mut product = Self::ONE;
        let mut square = self;
        let mut remaining = exponent.unsigned_abs();
        while remaining > 0 {
            if remaining % 2 == 1 {
                product = product * square;
            }
            remaining /= 2;
            if remaining > 0 {
                square = square * square;
            }
        }
        if exponent < 0 { Self::ONE / product } else { product }
    }

    /// Computes `self * factor + addend`. For `f64` and `f32`, it is rounded once if and only if
    /// the target feature `fma` is enabled at compile time.
    ///
    /// On a target without the instruction, a fused product is a library call, many times slower
    /// than a product and a sum. The result is then rounded twice.
    #[inline]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    /// Computes `self * factor + addend` where the processor has the instruction, as known at run
    /// time. `f64` and `f32` round once on every target; without the instruction, this is a library
    /// call.
    #[inline(always)]
    fn fused_multiply_add(self, factor: Self, addend: Self) -> Self {
        self.multiply_add(factor, addend)
    }
}

/// Computes `a * b + sum`, with [`fused_multiply_add`](Number::fused_multiply_add) if FUSED.
#[inline(always)]
pub(crate) fn product_sum<const FUSED: bool, S: Number>(a: S, b: S, sum: S) -> S {
    if FUSED { a.fused_multiply_add(b, sum) } else { a.multiply_add(b, sum) }
}

/// A single real number, which programs can compare and branch on. Methods of integration, events
/// and contacts compute with such numbers.
pub trait Scalar: Number<Mask = bool> + PartialEq + PartialOrd {
    /// True if this is neither NaN nor infinite.
    fn is_finite(self) -> bool;

    /// Returns the distance from one to the next number, like [`f64::EPSILON`].
    #[inline]
    fn epsilon() -> Self {
        spacing_at_one()
    }

    /// Computes sines and cosines of several angles, for [`Lanes`]; `f64` and `f32` fuse products
    /// if FUSED.
    #[inline(always)]
    fn sines_and_cosines<const FUSED: bool, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sines, mut cosines) = (angles, angles);
        for i in 0..N {
            (sines[i], cosines[i]) = angles[i].sin_cos();
        }
        (sines, cosines)
    }

    /// Computes values of an elementary function for several arguments, for [`Lanes`]; `f64` and
    /// `f32` fuse products if FUSED.
    #[inline(always)]
    fn values<const FUSED: bool, const N: usize>(function: Elementary, arguments: [Self; N]) -> [Self; N] {
        arguments.map(|x| lagrange_math::functions!(value_of function of x:))
    }

    /// Computes the angles of several points from their ordinates and abscissas, for [`Lanes`];
    /// `f64` and `f32` fuse products if FUSED.
    #[inline(always)]
    fn angles<const FUSED: bool, const N: usize>(ordinates: [Self; N], abscissas: [Self; N]) -> [Self; N] {
        core::array::from_fn(|i| ordinates[i].atan2(abscissas[i]))
    }

    /// Computes the lengths √(x² + y²) of several vectors, for [`Lanes`]; `f64` and `f32` fuse
    /// products if FUSED.
    #[inline(always)]
    fn lengths<const FUSED: bool, const N: usize>(x: [Self; N], y: [Self; N]) -> [Self; N] {
        core::array::from_fn(|i| x[i].hypot(y[i]))
    }

    /// Computes the binary logarithm of a positive normal number to 2 · 10⁻⁴, for step lengths. For
    /// other numbers the result is meaningless.
    #[inline(always)]
    fn rough_log2(self) -> Self {
        self.ln() / Self::from_f64(core::f64::consts::LN_2)
    }

    /// Raises two to this power, clamped to [−100, 100], to a relative 10⁻⁴, for step lengths.
    #[inline(always)]
    fn rough_exp2(self) -> Self {
        let hundred = Self::from_f64(100.0);
        let power = if hundred < self { hundred } else { self };
        let power = if power < -hundred { -hundred } else { power };
        (power * Self::from_f64(core::f64::consts::LN_2)).exp()
    }
}

/// Returns the distance from one to the next number, also for numbers in lanes.
#[inline(always)]
pub(crate) fn spacing_at_one<S: Number>() -> S {
    // A third has no finite binary expansion; its rounding error leaves this distance.
    let three = S::from_f64(3.0);
    (three * (S::from_f64(4.0) / three - S::ONE) - S::ONE).abs()
}

#[cfg(test)]
mod tests;
