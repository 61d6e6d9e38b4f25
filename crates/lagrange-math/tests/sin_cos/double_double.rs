//! Sine and cosine with about a hundred bits, for dense comparisons: sums of two doubles (T. J.
//! Dekker, "A floating-point technique for extending the available precision", Numerische
//! Mathematik 18, 1971) and Taylor series. It shares nothing with the functions under test;
//! `stored` compares it with values from another program.

use std::f64::consts::FRAC_2_PI;

/// π/2 as the sum of three doubles, correct to 2⁻¹⁶⁰.
const HALF_PI: [f64; 3] = [
    f64::from_bits(0x3ff9_21fb_5444_2d18),
    f64::from_bits(0x3c91_a626_3314_5c07),
    f64::from_bits(0xb91f_1976_b7ed_8fbc),
];

/// The sum of two doubles, the second at most half a unit in the last place of the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleDouble(pub(crate) f64, pub(crate) f64);

const ONE: DoubleDouble = DoubleDouble(1.0, 0.0);

fn exact_sum(a: f64, b: f64) -> DoubleDouble {
    let sum = a + b;
    let of_b = sum - a;
    DoubleDouble(sum, (a - (sum - of_b)) + (b - of_b))
}

fn exact_product(a: f64, b: f64) -> DoubleDouble {
    let product = a * b;
    DoubleDouble(product, a.mul_add(b, -product))
}

impl DoubleDouble {
    fn add(self, other: DoubleDouble) -> DoubleDouble {
        let (high, low) = (exact_sum(self.0, other.0), exact_sum(self.1, other.1));
        let sum = exact_sum(high.0, high.1 + low.0);
        exact_sum(sum.0, sum.1 + low.1)
    }

    fn times(self, other: DoubleDouble) -> DoubleDouble {
        let product = exact_product(self.0, other.0);
        exact_sum(product.0, product.1 + (self.0 * other.1 + self.1 * other.0))
    }

    fn divided_by(self, divisor: f64) -> DoubleDouble {
        let quotient = self.0 / divisor;
        let rest = (-quotient).mul_add(divisor, self.0) + self.1;
        exact_sum(quotient, rest / divisor)
    }

    fn negated(self) -> DoubleDouble {
        DoubleDouble(-self.0, -self.1)
    }

    /// Returns Σ (−1)ᵏ x^(first + 2k) / (first + 2k)! for |x| ≤ 1.
    fn alternating_series(self, first: u8) -> DoubleDouble {
        let square = self.times(self);
        let mut term = if first == 0 { ONE } else { self };
        let mut sum = term;
        for k in (first..30).step_by(2) {
            let (a, b) = (f64::from(k + 1), f64::from(k + 2));
            term = term.times(square).divided_by(-a * b);
            sum = sum.add(term);
        }
        sum
    }
}

/// Returns n and x − n π/2 for the nearest n.
fn reduced(x: f64) -> (i64, DoubleDouble) {
    let n = (x * FRAC_2_PI).round();
    let parts = HALF_PI.map(|part| exact_product(-n, part));
    let start = exact_sum(x, parts[0].0);
    let rest = [DoubleDouble(parts[0].1, 0.0), parts[1], parts[2]];
    (n as i64, rest.into_iter().fold(start, DoubleDouble::add))
}

/// Returns sine and cosine of an angle of at most 10⁵ in magnitude.
pub(crate) fn sin_cos(x: f64) -> (DoubleDouble, DoubleDouble) {
    let (n, rest) = reduced(x);
    let (sine, cosine) = (rest.alternating_series(1), rest.alternating_series(0));
    match n.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, sine.negated()),
        2 => (sine.negated(), cosine.negated()),
        _ => (cosine.negated(), sine),
    }
}

/// Returns the distance of a result from a value, in units in the last place of the value.
pub(crate) fn error_in_ulps(found: f64, value: DoubleDouble) -> f64 {
    ((found - value.0) - value.1).abs() / unit_in_last_place(value.0)
}

fn unit_in_last_place(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    let smallest = f64::from_bits(1);
    if exponent <= 52 {
        smallest * 2.0_f64.powi(exponent.max(1) as i32 - 1)
    } else {
        f64::from_bits((exponent - 52) << 52)
    }
}
