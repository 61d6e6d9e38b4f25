//! Functions of several numbers at a time.

use crate::arc;
use crate::batch::LARGEST_ANGLE;
use crate::beyond;
use crate::exponential::{self, LARGEST_HYPERBOLIC};
use crate::length;
use crate::logarithm;
use crate::tangent;

/// Defines the enumeration of the functions that lanes compute together, and their values.
macro_rules! of_lanes {
    ($(
        $name:ident $arguments:tt C $c:tt lanes($($variant:ident: $module:ident::$formula:ident $(, $domain:ident)?)?) $method:tt
    )*) => {
        /// An elementary function of one number.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Elementary {
            $($(#[doc = concat!("The function `", stringify!($name), "`.")] $variant,)?)*
        }

        #[inline(always)]
        fn of_each<const FUSED: bool, const N: usize>(function: Elementary, x: [f64; N]) -> [f64; N] {
            match function {
                $($(Elementary::$variant => {
                    of_lanes!(@values x, $name, $module::$formula::<FUSED> $(, $domain)?)
                })?)*
            }
        }
    };
    (@values $x:ident, $name:ident, $formula:expr) => {
        everywhere($x, $formula)
    };
    (@values $x:ident, $name:ident, $formula:expr, $domain:ident) => {
        each(|i| $formula($x[i]), |i| $domain($x[i]), |i| beyond::$name($x[i]))
    };
}

crate::functions!(of_lanes);

/// Computes values of a function for several numbers. Products are fused or not, as for
/// [`sines_and_cosines`](crate::sines_and_cosines).
///
/// The result for a number does not depend on the others, and is the same on every platform for
/// each choice of FUSED. Errors in units in the last place:
///
/// | | error, fused or not |
/// |---|---|
/// | `Tan`, `Ln` | 1 |
/// | `Asin`, `Acos`, `Atan` | 0.7 |
/// | `Sinh`, `Cosh`, `Tanh` | 0.8 |
/// | `Exp` | 0.6, or 1.2 below 2⁻¹⁰²² |
///
/// Special values follow IEEE 754: zeros keep their sign, and NaN stays NaN.
///
/// ```
/// use lagrange_math::{Elementary, values};
///
/// let [one, e] = values::<false, 2>(Elementary::Exp, [0.0, 1.0]);
/// assert_eq!((one, e), (1.0, std::f64::consts::E));
/// ```
#[inline(always)]
#[must_use]
pub fn values<const FUSED: bool, const N: usize>(function: Elementary, arguments: [f64; N]) -> [f64; N] {
    of_each::<FUSED, N>(function, arguments)
}

/// True for magnitudes up to [`LARGEST_ANGLE`]; false for NaN.
#[inline(always)]
fn is_angle(x: f64) -> bool {
    x.abs() <= LARGEST_ANGLE
}

/// True for magnitudes up to [`LARGEST_HYPERBOLIC`]; false for NaN.
#[inline(always)]
fn is_moderate(x: f64) -> bool {
    x.abs() <= LARGEST_HYPERBOLIC
}

/// Computes values of a formula that is valid for all numbers.
#[inline(always)]
fn everywhere<const N: usize>(arguments: [f64; N], formula: impl Fn(f64) -> f64) -> [f64; N] {
    let mut values = [0.0; N];
    for i in 0..N {
        values[i] = formula(arguments[i]);
    }
    values
}

/// Computes values of a formula by index. Another function replaces those outside the domain of the
/// formula.
#[inline(always)]
fn each<const N: usize>(
    formula: impl Fn(usize) -> f64,
    covers: impl Fn(usize) -> bool,
    beyond: impl Fn(usize) -> f64,
) -> [f64; N] {
    let mut values = [0.0; N];
    for (i, value) in values.iter_mut().enumerate() {
        *value = formula(i);
    }
    let all_covered = (0..N).fold(true, |all, i| all & covers(i));
    if !all_covered {
        for (i, value) in values.iter_mut().enumerate() {
            if !covers(i) {
                *value = beyond(i);
            }
        }
    }
    values
}

/// Computes the angles in [−π, π] of several points, given by their ordinates and abscissas.
///
/// Errors are below 0.7 units in the last place if each coordinate is zero or from 10⁻²⁷⁰ to 10²⁷⁰
/// in magnitude. For other points, including the origin, `libm` computes the angle, with the sides
/// of the cut according to IEEE 754. Otherwise, results are as for [`values`].
#[inline(always)]
#[must_use]
pub fn angles<const FUSED: bool, const N: usize>(ordinates: [f64; N], abscissas: [f64; N]) -> [f64; N] {
    let (y, x) = (ordinates, abscissas);
    each(
        |i| arc::atan2::<FUSED>(y[i], x[i]),
        |i| arc::are_coordinates(y[i], x[i]),
        |i| beyond::atan2(y[i], x[i]),
    )
}

/// Computes the lengths √(x² + y²) of several vectors.
///
/// Errors are below 0.6 units in the last place if each component is zero or from 10⁻¹³⁰ to 10¹⁵⁰
/// in magnitude. Otherwise `libm` computes the length, which is infinite if a component is
/// infinite. In all other respects, results are as for [`values`].
#[inline(always)]
#[must_use]
pub fn lengths<const FUSED: bool, const N: usize>(x: [f64; N], y: [f64; N]) -> [f64; N] {
    each(
        |i| length::hypot::<FUSED>(x[i], y[i]),
        |i| length::are_components(x[i], y[i]),
        |i| beyond::hypot(x[i], y[i]),
    )
}

/// Raises a number to a real power, with an error below one unit in the last place. The bits are
/// the same on every platform. NaN if either argument is NaN.
///
/// ```
/// assert_eq!(lagrange_math::power(2.0, 0.5), 2_f64.sqrt());
/// assert!(lagrange_math::power(-2.0, 0.5).is_nan());
/// ```
#[inline]
#[must_use]
pub fn power(base: f64, exponent: f64) -> f64 {
    if base.is_nan() || exponent.is_nan() { f64::NAN } else { libm::pow(base, exponent) }
}

/// Computes [`values`] in single precision, as rounded results of double precision.
#[inline(always)]
#[must_use]
pub fn values_f32<const FUSED: bool, const N: usize>(function: Elementary, arguments: [f32; N]) -> [f32; N] {
    narrow(values::<FUSED, N>(function, widen(arguments)))
}

/// Computes [`angles`] in single precision, as rounded results of double precision.
#[inline(always)]
#[must_use]
pub fn angles_f32<const FUSED: bool, const N: usize>(ordinates: [f32; N], abscissas: [f32; N]) -> [f32; N] {
    narrow(angles::<FUSED, N>(widen(ordinates), widen(abscissas)))
}

/// Computes [`lengths`] in single precision, as rounded results of double precision.
#[inline(always)]
#[must_use]
pub fn lengths_f32<const FUSED: bool, const N: usize>(x: [f32; N], y: [f32; N]) -> [f32; N] {
    narrow(lengths::<FUSED, N>(widen(x), widen(y)))
}

#[inline(always)]
fn widen<const N: usize>(singles: [f32; N]) -> [f64; N] {
    let mut doubles = [0.0; N];
    for i in 0..N {
        doubles[i] = f64::from(singles[i]);
    }
    doubles
}

#[inline(always)]
fn narrow<const N: usize>(doubles: [f64; N]) -> [f32; N] {
    let mut singles = [0.0; N];
    for i in 0..N {
        singles[i] = doubles[i] as f32;
    }
    singles
}
