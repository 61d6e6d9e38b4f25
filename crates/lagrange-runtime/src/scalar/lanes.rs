//! Several numbers in lanes that pass through the same formulas.
//!
//! Every operation is a loop over the lanes that is always inlined. It compiles to vector
//! instructions of the caller's target. Formulas may therefore also be called by a function that
//! enables target features beyond those of its crate.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Elementary, Mask, Number, Scalar};

/// N numbers of type T, one in each lane.
///
/// The result of a lane has the same bits, regardless of the contents and the number of other
/// lanes. Sums, products and square roots are computed as for T.
/// [`multiply_add`](Number::multiply_add) rounds once if FUSED and twice otherwise, on every
/// target; without the instruction, it is a slow call. [`powi`](Number::powi) consists of products,
/// as for one number; [`powf`](Number::powf) calls that of T, lane by lane.
///
/// Other elementary functions are computed for all lanes together, from the same source for both
/// values of FUSED. Errors, in units in the last place, are at most
///
/// | `f64` | |
/// |---|---|
/// | `sin`, `cos` | 0.9 |
/// | `tan` | 1 |
/// | `asin`, `acos`, `atan`, `atan2` | 0.7; `atan2` 1 where a coordinate other than zero is below 10⁻²⁷⁰ or above 10²⁷⁰ in magnitude |
/// | `sinh`, `cosh`, `tanh` | 0.8 |
/// | `exp` | 0.6, or 1.2 below 2⁻¹⁰²² |
/// | `ln` | 1 |
/// | `hypot` | 0.6 |
///
/// For `f32`, they are computed in `f64` and rounded once, to 0.5000001 units in the last place.
/// Special values, including signed zeros, infinity and NaN, are as specified by [`Number`].
///
/// ```
/// use lagrange::Number;
/// use lagrange::scalar::Lanes;
///
/// let angles = Lanes::<f64, 4>([0.0, 0.1, 0.2, 0.3]);
/// let (sine, cosine) = angles.sin_cos();
/// let Lanes(ones) = sine * sine + cosine * cosine;
/// assert!(ones.iter().all(|one| (one - 1.0).abs() < 1e-15));
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Lanes<T, const N: usize, const FUSED: bool = false>(pub [T; N]);

/// A truth value for each of N lanes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LaneMask<const N: usize>(pub [bool; N]);

impl<T: Scalar, const N: usize, const FUSED: bool> Lanes<T, N, FUSED> {
    /// Applies a function to the number in each lane.
    #[inline(always)]
    pub(crate) fn each(self, function: impl Fn(T) -> T) -> Self {
        let mut value = self;
        for i in 0..N {
            value.0[i] = function(self.0[i]);
        }
        value
    }

    /// Applies a function to the two numbers in each lane.
    #[inline(always)]
    pub(crate) fn zip(self, other: Self, function: impl Fn(T, T) -> T) -> Self {
        let mut value = self;
        for i in 0..N {
            value.0[i] = function(self.0[i], other.0[i]);
        }
        value
    }

    #[inline(always)]
    fn compare(self, other: Self, comparison: impl Fn(T, T) -> bool) -> LaneMask<N> {
        let mut mask = [false; N];
        for (i, is_true) in mask.iter_mut().enumerate() {
            *is_true = comparison(self.0[i], other.0[i]);
        }
        LaneMask(mask)
    }
}

/// Implements operators, given in rows of trait, method and sign.
macro_rules! implement_operators {
    ($($operator:ident $method:ident $sign:tt;)*) => {
        $(impl<T: Scalar, const N: usize, const FUSED: bool> $operator for Lanes<T, N, FUSED> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let mut value = self;
                for i in 0..N {
                    value.0[i] = self.0[i] $sign other.0[i];
                }
                value
            }
        })*
    };
}

implement_operators! {
    Add add +;
    Sub sub -;
    Mul mul *;
    Div div /;
}

impl<T: Scalar, const N: usize, const FUSED: bool> Neg for Lanes<T, N, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|number| -number)
    }
}

/// Defines methods that compute all lanes together, for list rows with a formula for lanes.
macro_rules! together {
    ($(
        $name:ident $arguments:tt C $c:tt lanes($($variant:ident: $module:ident::$formula:ident $(, $domain:ident)?)?) $method:tt
    )*) => {
        $($(#[inline(always)]
        fn $name(self) -> Self {
            Lanes(T::values::<FUSED, N>(Elementary::$variant, self.0))
        })?)*
    };
}

impl<T: Scalar, const N: usize, const FUSED: bool> Number for Lanes<T, N, FUSED> {
    type Mask = LaneMask<N>;

    const ZERO: Self = Lanes([T::ZERO; N]);
    const ONE: Self = Lanes([T::ONE; N]);
    const NAN: Self = Lanes([T::NAN; N]);

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Lanes([T::from_f64(value); N])
    }

    #[inline(always)]
    fn from_sum(nearest: f64, remainder: f64) -> Self {
        Lanes([T::from_sum(nearest, remainder); N])
    }

    #[inline(always)]
    fn less(self, other: Self) -> LaneMask<N> {
        self.compare(other, |one, other| one < other)
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> LaneMask<N> {
        self.compare(other, |one, other| one <= other)
    }

    #[inline(always)]
    fn select(mask: LaneMask<N>, then: Self, otherwise: Self) -> Self {
        let mut value = otherwise;
        for i in 0..N {
            value.0[i] = if mask.0[i] { then.0[i] } else { otherwise.0[i] };
        }
        value
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sines, cosines) = T::sines_and_cosines::<FUSED, N>(self.0);
        (Lanes(sines), Lanes(cosines))
    }

    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        if !FUSED {
            return self * factor + addend;
        }
        let mut value = self;
        for i in 0..N {
            value.0[i] = self.0[i].fused_multiply_add(factor.0[i], addend.0[i]);
        }
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.each(T::abs)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(T::sqrt)
    }

    #[inline(always)]
    fn atan2(self, abscissa: Self) -> Self {
        Lanes(T::angles::<FUSED, N>(self.0, abscissa.0))
    }

    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        Lanes(T::lengths::<FUSED, N>(self.0, other.0))
    }

    /// Computes each lane separately.
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.zip(exponent, T::powf)
    }

    lagrange_math::functions!(together);
}

impl<const N: usize> Mask for LaneMask<N> {
    #[inline(always)]
    fn splat(value: bool) -> Self {
        LaneMask([value; N])
    }

    #[inline(always)]
    fn any(self) -> bool {
        let mut any = false;
        for i in 0..N {
            any |= self.0[i];
        }
        any
    }

    #[inline(always)]
    fn all(self) -> bool {
        let mut all = true;
        for i in 0..N {
            all &= self.0[i];
        }
        all
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> bool {
        self.0[lane]
    }
}

impl<const N: usize> BitAnd for LaneMask<N> {
    type Output = Self;

    #[inline(always)]
    fn bitand(mut self, other: Self) -> Self {
        for i in 0..N {
            self.0[i] &= other.0[i];
        }
        self
    }
}

impl<const N: usize> BitOr for LaneMask<N> {
    type Output = Self;

    #[inline(always)]
    fn bitor(mut self, other: Self) -> Self {
        for i in 0..N {
            self.0[i] |= other.0[i];
        }
        self
    }
}

impl<const N: usize> Not for LaneMask<N> {
    type Output = Self;

    #[inline(always)]
    fn not(mut self) -> Self {
        for i in 0..N {
            self.0[i] = !self.0[i];
        }
        self
    }
}
