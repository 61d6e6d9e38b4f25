//! `f64` and `f32` as numbers, with the functions of the standard library or, without it, of
//! `libm`.

use super::order::{f32_in_order, f64_in_order};
use super::{Elementary, Number, Scalar, rough};

/// Calls the method of the standard library or, without it, a function of `libm`. The second name
/// is the function for `f32`.
macro_rules! platform {
    ($scalar:ident :: abs | $libm:ident $libmf:ident ($x:expr)) => {
        // The core library also provides this function.
        $scalar::abs($x)
    };
    (f64 :: $method:ident | $libm:ident $libmf:ident ($($argument:expr),*)) => {
        platform!(@f64::$method | $libm($($argument),*))
    };
    (f32 :: $method:ident | $libm:ident $libmf:ident ($($argument:expr),*)) => {
        platform!(@f32::$method | $libmf($($argument),*))
    };
    (@$scalar:ident :: $method:ident | $libm:ident ($($argument:expr),*)) => {{
        #[cfg(feature = "std")]
        let value = $scalar::$method($($argument),*);
        #[cfg(not(feature = "std"))]
        let value = libm::$libm($($argument),*);
        value
    }};
}

/// Implements `Number` and `Scalar`, with the functions of the list.
macro_rules! implement_scalar {
    (
        $scalar:ident, sin_cos_each: $sin_cos_each:ident, in_order: $in_order:ident,
        lanes: [$sines_and_cosines:ident, $values:ident, $angles:ident, $lengths:ident];
        $(
            $name:ident $arguments:tt C($libm:ident, $libmf:ident) lanes $lanes:tt {
                $(#[$doc:meta])*
                fn($self:ident $(, $other:ident)?) $default:tt
            }
        )*
    ) => {
        impl Scalar for $scalar {
            #[inline]
            fn is_finite(self) -> bool {
                $scalar::is_finite(self)
            }

            #[inline(always)]
            fn sines_and_cosines<const FUSED: bool, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                lagrange_math::$sines_and_cosines::<FUSED, N>(angles)
            }

            #[inline(always)]
            fn values<const FUSED: bool, const N: usize>(function: Elementary, arguments: [Self; N]) -> [Self; N] {
                lagrange_math::$values::<FUSED, N>(function, arguments)
            }

            #[inline(always)]
            fn angles<const FUSED: bool, const N: usize>(ordinates: [Self; N], abscissas: [Self; N]) -> [Self; N] {
                lagrange_math::$angles::<FUSED, N>(ordinates, abscissas)
            }

            #[inline(always)]
            fn lengths<const FUSED: bool, const N: usize>(x: [Self; N], y: [Self; N]) -> [Self; N] {
                lagrange_math::$lengths::<FUSED, N>(x, y)
            }

            #[inline(always)]
            fn rough_log2(self) -> Self {
                rough::log2(self.into()) as $scalar
            }

            #[inline(always)]
            fn rough_exp2(self) -> Self {
                rough::exp2(self.into()) as $scalar
            }
        }

        impl Number for $scalar {
            type Mask = bool;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const NAN: Self = $scalar::NAN;

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $scalar
            }

            #[inline(always)]
            fn less(self, other: Self) -> bool {
                self < other
            }

            #[inline(always)]
            fn less_equal(self, other: Self) -> bool {
                self <= other
            }

            #[inline(always)]
            fn select(mask: bool, then: Self, otherwise: Self) -> Self {
                if mask { then } else { otherwise }
            }

            #[inline]
            fn floor_below(self, count: usize) -> Option<usize> {
                // Negative numbers and NaN become 0, and too large ones the largest integer.
                Some((self as usize).min(count.saturating_sub(1)))
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                platform!($scalar::sin_cos | sincos sincosf($in_order(self)))
            }

            #[inline(always)]
            fn reciprocal(self) -> Self {
                $in_order(1.0 / self)
            }

            #[inline(always)]
            fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
                lagrange_math::$sin_cos_each(angles)
            }

            #[inline]
            fn powf(self, exponent: Self) -> Self {
                if self.is_nan() || exponent.is_nan() {
                    return $scalar::NAN;
                }
                platform!($scalar::powf | pow powf(self, exponent))
            }

            #[inline]
            fn multiply_add(self, factor: Self, addend: Self) -> Self {
                if cfg!(target_feature = "fma") {
                    self.fused_multiply_add(factor, addend)
                } else {
                    self * factor + addend
                }
            }

            #[inline(always)]
            fn fused_multiply_add(self, factor: Self, addend: Self) -> Self {
                platform!($scalar::mul_add | fma fmaf(self, factor, addend))
            }

            $(
                #[inline]
                fn $name($self $(, $other: Self)?) -> Self {
                    platform!($scalar::$name | $libm $libmf($self $(, $other)?))
                }
            )*
        }
    };
}

lagrange_math::functions! {
    implement_scalar f64, sin_cos_each: sin_cos_each, in_order: f64_in_order,
    lanes: [sines_and_cosines, values, angles, lengths];
}

lagrange_math::functions! {
    implement_scalar f32, sin_cos_each: sin_cos_each_f32, in_order: f32_in_order,
    lanes: [sines_and_cosines_f32, values_f32, angles_f32, lengths_f32];
}
