//! Implementations of the number traits used by emitted code.

use lagrange_runtime::{Number, Scalar};

use crate::double::Double;

/// A multiple of the largest error of a sum: 2⁻¹⁰⁴.
const EPSILON: f64 = f64::from_bits((1023 - 104) << 52);

impl Number for Double {
    type Mask = bool;

    const ZERO: Self = Double::of(0.0);
    const ONE: Self = Double::of(1.0);
    const NAN: Self = Double::of(f64::NAN);

    #[inline]
    fn from_f64(value: f64) -> Self {
        Double::of(value)
    }

    #[inline]
    fn from_sum(nearest: f64, remainder: f64) -> Self {
        Double::from_sum(nearest, remainder)
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

    fn floor_below(self, count: usize) -> Option<usize> {
        let floor = self.upper as usize;
        let is_above = floor as f64 == self.upper && self.lower < 0.0;
        Some(floor.saturating_sub(usize::from(is_above)).min(count.saturating_sub(1)))
    }

    fn sin_cos(self) -> (Self, Self) {
        if !self.is_finite() {
            return (Double::NAN, Double::NAN);
        }
        let (sine, cosine) = self.sine_and_cosine();
        // The sine of zero has the sign of zero.
        let sine = if self.upper == 0.0 { self } else { sine.to_double() };
        (sine, cosine.to_double())
    }

    fn sin(self) -> Self {
        self.sin_cos().0
    }

    fn cos(self) -> Self {
        self.sin_cos().1
    }

    fn tan(self) -> Self {
        self.tangent()
    }

    fn asin(self) -> Self {
        self.arcsine()
    }

    fn acos(self) -> Self {
        self.arccosine()
    }

    fn atan2(self, abscissa: Self) -> Self {
        self.angle_with(abscissa)
    }

    fn sinh(self) -> Self {
        self.hyperbolic_sine()
    }

    fn cosh(self) -> Self {
        self.hyperbolic_cosine()
    }

    fn tanh(self) -> Self {
        self.hyperbolic_tangent()
    }

    fn exp(self) -> Self {
        self.exponential()
    }

    fn ln(self) -> Self {
        self.logarithm()
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.root()
    }

    #[inline(always)]
    fn fused_multiply_add(self, factor: Self, addend: Self) -> Self {
        self.accumulated(factor, addend)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        if self.upper.is_sign_negative() { -self } else { self }
    }

    fn hypot(self, other: Self) -> Self {
        self.length_with(other)
    }

    fn powf(self, exponent: Self) -> Self {
        self.power(exponent)
    }
}

impl Scalar for Double {
    #[inline]
    fn is_finite(self) -> bool {
        self.upper.is_finite() && self.lower.is_finite()
    }

    #[inline]
    fn epsilon() -> Self {
        Double::of(EPSILON)
    }

    #[inline]
    fn rough_log2(self) -> Self {
        Double::of(self.upper.rough_log2())
    }

    #[inline]
    fn rough_exp2(self) -> Self {
        Double::of(self.upper.rough_exp2())
    }
}
