//! Reduction of angles to a multiple of π/2 and a remainder between −π/4 and π/4.
//!
//! π/2 is represented by a sum of three parts. The first two have 37 bits and the multiple at most
//! 16, so their products are exact. The first difference is exact, too (Sterbenz: its terms are
//! close to each other, and both are multiples of 2⁻⁵³). The remainder is a sum of two doubles.
//!
//! Its accuracy depends on the distance of doubles from multiples of π/2. Among all doubles up to
//! 10⁵, the nearest is 45.553093477052, at 2^−60.5 from 29 π/2. At the double nearest to each of
//! the 63 661 multiples, the relative error of the remainder is below 2^−63 (`tools/sin_cos.py
//! angles`). Other doubles are farther away.
//!
//! Larger angles are reduced in integers. No double is nearer than 2^−61 to a multiple of π/2, so
//! more than 70 correct bits of the remainder are left.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use crate::fused::multiply_add;
use crate::pair::{Pair, normal, product};
use crate::quarters::{nearest_quarter, quarter_turns};

/// Parts whose sum differs from π/2 by 2^−130.5.
const HALF_PI: [f64; 3] = [
    f64::from_bits(0x3ff9_21fb_5444_0000),
    f64::from_bits(0x3d86_8c23_4c4c_0000),
    f64::from_bits(0x3b29_8a2e_0370_7345),
];

/// π/2 minus the nearest double.
const HALF_PI_REST: f64 = f64::from_bits(0x3c91_a626_3314_5c07);

/// Adding it to a number below 2⁵¹ rounds the number to an integer in the last bits.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// The reduction x = n π/2 + `high` + `low`.
pub(crate) struct Reduced {
    /// The last two bits are those of n.
    pub(crate) quadrant: u64,
    pub(crate) high: f64,
    pub(crate) low: f64,
}

/// Reduces an angle from 0 to 10⁵; for other angles the result is meaningless.
#[inline(always)]
pub(crate) fn reduce<const FUSED: bool>(x: f64) -> Reduced {
    let shifted = multiply_add::<FUSED>(x, FRAC_2_PI, SHIFT);
    let n = shifted - SHIFT;
    let first = multiply_add::<FUSED>(-n, HALF_PI[0], x);
    let high = multiply_add::<FUSED>(-n, HALF_PI[1], first);
    // The rounding error of `high`. If the product is the larger term, the difference is exact.
    let lost = multiply_add::<FUSED>(-n, HALF_PI[1], first - high);
    Reduced { quadrant: shifted.to_bits(), high, low: multiply_add::<FUSED>(-n, HALF_PI[2], lost) }
}

/// Reduces an angle of any size; the remainder is NaN if the angle is NaN or infinite.
pub(crate) fn reduce_large(x: f64) -> Reduced {
    if !x.is_finite() {
        return Reduced { quadrant: 0, high: f64::NAN, low: f64::NAN };
    }
    let (quadrant, is_negative, rest) = nearest_quarter(quarter_turns::<3>(x));
    let (quarters, sign) = (leading(rest), if is_negative { -1.0 } else { 1.0 });
    let Pair { high, low } = product::<false>(quarters.high, FRAC_PI_2);
    let low = low + (quarters.high * HALF_PI_REST + quarters.low * FRAC_PI_2);
    let Pair { high, low } = normal(Pair { high, low });
    Reduced { quadrant, high: sign * high, low: sign * low }
}

/// Returns the leading 106 bits of a fraction that begins at the point.
fn leading([first, second, third]: [u64; 3]) -> Pair {
    let bits = u128::from(first) << 64 | u128::from(second);
    let zeros = bits.leading_zeros().min(63);
    let bits = bits << zeros | u128::from(third.checked_shr(64 - zeros).unwrap_or(0));
    let high = (bits >> 75) as f64 * power_of_two(-53 - zeros as i32);
    let low = ((bits >> 22) as u64 & ((1 << 53) - 1)) as f64;
    Pair { high, low: low * power_of_two(-106 - zeros as i32) }
}

fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
