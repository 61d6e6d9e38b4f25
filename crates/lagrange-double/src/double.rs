//! The number and its arithmetic.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::{fused, fused_product, ordered_sum, product, sum};

/// A real number as the unevaluated sum of two doubles, about 106 bits or 32 decimal digits.
///
/// The upper double is the nearest to the number. Infinity and NaN are represented by the upper
/// double. `Debug` shows both doubles, `Display` 32 decimal digits.
///
/// ```
/// use lagrange_double::Double;
///
/// let third = Double::from(1.0) / Double::from(3.0);
/// assert_eq!(third.to_string(), "0.33333333333333333333333333333333");
/// assert_eq!("9.81".parse::<Double>().unwrap().to_string(), "9.81");
/// ```
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug, Default)]
pub struct Double {
    pub(crate) upper: f64,
    pub(crate) lower: f64,
}

impl Double {
    /// Adds two doubles exactly.
    #[inline]
    pub fn from_sum(a: f64, b: f64) -> Self {
        let (upper, lower) = sum(a, b);
        Double::joined(upper, lower, upper)
    }

    /// Returns the nearest double, and the remainder.
    #[inline]
    pub fn parts(self) -> (f64, f64) {
        (self.upper, self.lower)
    }

    /// Returns the sum of two doubles, or the plain result if the sum is zero or not finite. The
    /// plain result then has the right sign and kind.
    #[inline(always)]
    fn joined(upper: f64, lower: f64, plain: f64) -> Self {
        let is_sum = lower.is_finite() && upper.is_finite() && upper != 0.0;
        let (upper, lower) = if is_sum { (upper, lower) } else { (plain, 0.0) };
        Double { upper, lower }
    }

    /// Computes `self * factor + addend` for sums of products. The error is a few units of 2⁻¹⁰⁵ of
    /// the larger of the product and the addend, and infinity becomes NaN.
    ///
    /// Source: Ogita, Rump, Oishi, "Accurate sum and dot product", *SIAM Journal on Scientific
    /// Computing* 26 (2005) 1955–1988, algorithm 5.3.
    #[inline(always)]
    pub(crate) fn accumulated(self, factor: Double, addend: Double) -> Double {
        let (upper, error) = fused_product(self.upper, factor.upper);
        let crossed = fused(self.upper, factor.lower, fused(self.lower, factor.upper, error));
        let (sum, sum_error) = sum(upper, addend.upper);
        let (upper, lower) = ordered_sum(sum, sum_error + (crossed + addend.lower));
        Double { upper, lower }
    }

    pub(crate) const fn of(upper: f64) -> Self {
        Double { upper, lower: 0.0 }
    }
}

impl From<f64> for Double {
    #[inline]
    fn from(value: f64) -> Self {
        Double::of(value)
    }
}

impl From<Double> for f64 {
    #[inline]
    fn from(value: Double) -> f64 {
        value.upper
    }
}

impl Neg for Double {
    type Output = Double;
    #[inline(always)]
    fn neg(self) -> Double {
        Double { upper: -self.upper, lower: -self.lower }
    }
}

impl Add for Double {
    type Output = Double;
    #[inline(always)]
    fn add(self, other: Double) -> Double {
        let (upper, upper_error) = sum(self.upper, other.upper);
        let (lower, lower_error) = sum(self.lower, other.lower);
        let (v, v_error) = ordered_sum(upper, upper_error + lower);
        let (z, z_error) = ordered_sum(v, lower_error + v_error);
        Double::joined(z, z_error, upper)
    }
}

impl Sub for Double {
    type Output = Double;
    #[inline(always)]
    fn sub(self, other: Double) -> Double {
        self + -other
    }
}

impl Mul for Double {
    type Output = Double;
    #[inline(always)]
    fn mul(self, other: Double) -> Double {
        let (upper, error) = product(self.upper, other.upper);
        let crossed = self.upper * other.lower + self.lower * other.upper;
        let (z, z_error) = ordered_sum(upper, error + crossed);
        Double::joined(z, z_error, upper)
    }
}

impl Div for Double {
    type Output = Double;
    #[inline(always)]
    fn div(self, other: Double) -> Double {
        let quotient = self.upper / other.upper;
        let (upper, error) = product(quotient, other.upper);
        let (multiple, multiple_error) = ordered_sum(upper, quotient * other.lower + error);
        let remainder = (self.upper - multiple) + (self.lower - multiple_error);
        let (z, z_error) = ordered_sum(quotient, remainder / other.upper);
        Double::joined(z, z_error, quotient)
    }
}
