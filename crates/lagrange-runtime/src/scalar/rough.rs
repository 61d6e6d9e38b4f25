//! Logarithms and powers to three digits, which is sufficient for step lengths. They use neither
//! branches nor tables, so several steps can be computed at once.
//!
//! Exponents are read from and written to the bits of a number. Polynomials through Chebyshev nodes
//! provide the rest.

/// Coefficients of log₂ m for m from 1 to 2, to 1.1 · 10⁻⁴.
const LOG2: [f64; 5] = [
    -2.505_614_661_98,
    4.049_616_892_585_97,
    -2.099_402_281_188_16,
    0.635_511_116_520_28,
    -0.080_010_876_906_8,
];
/// Coefficients of 2ˣ for x from −1/2 to 1/2, to 1.1 · 10⁻⁴.
const EXP2: [f64; 4] =
    [0.999_924_481_455_52, 0.693_121_033_991_55, 0.242_640_082_832_77, 0.055_922_035_647_26];
/// The bits of an `f64` below its exponent.
const MANTISSA: u64 = (1 << 52) - 1;
const BIAS: u64 = 1023;
/// 2⁵²: a small integer written to its last bits is added to it.
const WHOLE: f64 = 4_503_599_627_370_496.0;
/// 1.5 · 2⁵²: adding it to a small number rounds the number to an integer in the last bits, also
/// for negative numbers.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// Computes the binary logarithm of a positive normal number.
#[inline(always)]
pub(super) fn log2(x: f64) -> f64 {
    let bits = x.to_bits();
    let mantissa = f64::from_bits((bits & MANTISSA) | 1_f64.to_bits());
    // On many targets, conversions of integers are not vector instructions.
    let exponent = f64::from_bits((bits >> 52) | WHOLE.to_bits()) - (WHOLE + BIAS as f64);
    exponent + polynomial(LOG2, mantissa)
}

/// Raises two to this power, clamped to [−100, 100].
#[inline(always)]
pub(super) fn exp2(x: f64) -> f64 {
    let x = if x > 100.0 { 100.0 } else { x };
    let x = if x < -100.0 { -100.0 } else { x };
    let shifted = x + SHIFT;
    let power = f64::from_bits(shifted.to_bits().wrapping_add(BIAS) << 52);
    power * polynomial(EXP2, x - (shifted - SHIFT))
}

#[inline(always)]
fn polynomial<const N: usize>(coefficients: [f64; N], x: f64) -> f64 {
    let mut sum = 0.0;
    for coefficient in coefficients.into_iter().rev() {
        sum = sum * x + coefficient;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::{exp2, log2};

    #[test]
    fn errors_are_below_what_is_said() {
        for i in 0..100_000 {
            let x = f64::from(i - 50_000) / 600.0;
            let power = x.exp2();
            assert!((exp2(x) / power - 1.0).abs() < 1.1e-4, "{x}");
            assert!((log2(power) - x).abs() < 1.1e-4, "{x}");
        }
        assert_eq!((exp2(1e9), exp2(-1e9)), (exp2(100.0), exp2(-100.0)));
    }
}
