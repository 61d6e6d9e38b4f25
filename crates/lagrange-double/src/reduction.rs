//! Angles of any size, less the nearest multiple of π/2.
//!
//! M. H. Payne, R. N. Hanek, "Radian reduction for trigonometric functions", *SIGNUM Newsletter* 18 (1983): of 2/π only those bits count
//! that neither make multiples of four quadrants nor are too small.

use crate::double::Double;
use crate::wide::Wide;

/// Words of a number of quadrants: two bits before the point and 446 behind it. An angle of 106 bits is no closer to a multiple of π/2
/// than about 2⁻¹²⁰, so more than 192 bits follow the first that is set.
const WORDS: usize = 7;
type Quadrants = [u64; WORDS];

/// The bits of 2/π behind the point.
const TWO_OVER_PI: [u64; 24] = [
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
    0xf0cf_bc20_9af4_361d,
    0xa9e3_9161_5ee6_1b08,
    0x6599_855f_14a0_6840,
    0x8dff_d880_4d73_2731,
    0x0606_1556_ca73_a8c9,
];

/// The nearest multiple of π/2 to a finite angle, modulo four, and the difference from it.
pub(crate) fn reduced(angle: Double) -> (u64, Wide) {
    let (upper, lower) = angle.parts();
    if upper.abs() < 0.785 {
        return (0, Wide::of(upper).plus(Wide::of(lower)));
    }
    let quadrants = added(quadrants(upper), quadrants(lower));
    let nearest = (quadrants[0] >> 62) + (quadrants[0] >> 61 & 1);
    // Without the two bits before the point, the rest is a fraction in [−1/2, 1/2) in two's complement.
    let fraction: Quadrants =
        core::array::from_fn(|i| quadrants[i] << 2 | quadrants.get(i + 1).map_or(0, |next| next >> 62));
    let is_negative = fraction[0] >> 63 == 1;
    let magnitude = if is_negative { negated(fraction) } else { fraction };
    (nearest % 4, first_bits(is_negative, &magnitude).times(Wide::PI).scaled(-1))
}

/// The leading 192 bits of a fraction.
fn first_bits(is_negative: bool, fraction: &Quadrants) -> Wide {
    let Some(first) = fraction.iter().position(|&word| word != 0) else { return Wide::ZERO };
    let zeros = fraction[first].leading_zeros();
    let word = |i: usize| fraction.get(first + i).copied().unwrap_or(0);
    let aligned =
        |i: usize| if zeros == 0 { word(i) } else { word(i) << zeros | word(i + 1) >> (64 - zeros) };
    let exponent = -(first as i32 * 64 + zeros as i32);
    Wide { is_negative, exponent, mantissa: [aligned(0), aligned(1), aligned(2)] }
}

/// A double times 2/π, modulo four.
fn quadrants(x: f64) -> Quadrants {
    let bits = x.to_bits();
    let (field, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
    let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
    let start = field.max(1) - 1023 - 52 - 2;
    let (mut product, mut carry) = ([0; WORDS], 0);
    for i in (0..WORDS).rev() {
        let sum = u128::from(significand) * u128::from(bits_from(start + 64 * i as i64)) + carry;
        (product[i], carry) = (sum as u64, sum >> 64);
    }
    if x.is_sign_negative() { negated(product) } else { product }
}

/// 64 bits of 2/π from this place behind the point.
fn bits_from(place: i64) -> u64 {
    let (index, bits) = (place.div_euclid(64), place.rem_euclid(64));
    let word = |i: i64| usize::try_from(i).ok().and_then(|i| TWO_OVER_PI.get(i)).copied().unwrap_or(0);
    if bits == 0 { word(index) } else { word(index) << bits | word(index + 1) >> (64 - bits) }
}

fn added(a: Quadrants, b: Quadrants) -> Quadrants {
    let (mut sum, mut carry) = ([0; WORDS], 0);
    for i in (0..WORDS).rev() {
        let word = u128::from(a[i]) + u128::from(b[i]) + carry;
        (sum[i], carry) = (word as u64, word >> 64);
    }
    sum
}

fn negated(a: Quadrants) -> Quadrants {
    let mut one = [0; WORDS];
    one[WORDS - 1] = 1;
    added(a.map(|word| !word), one)
}
