//! Conversion of angles of any size to quarter turns, in integers.
//!
//! M. H. Payne, R. N. Hanek, "Radian reduction for trigonometric functions", *SIGNUM Newsletter* 18
//! (1983). Only some bits of 2/π are relevant: those that neither contribute multiples of four
//! quarters nor are too small.

/// The bits of 2/π after the point.
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

/// Returns a finite angle in quarter turns modulo four: two bits before the point, all others after
/// it.
///
/// Negative numbers are in two's complement. The error is below 2⁵⁵ in the last place.
///
/// ```
/// use lagrange_math::quarter_turns;
///
/// let [first, ..] = quarter_turns::<3>(std::f64::consts::PI);
/// assert_eq!(first >> 62, 1); // The double is just below π.
/// assert_eq!(first << 2 >> 16, u64::MAX >> 16);
/// ```
#[must_use]
pub fn quarter_turns<const WORDS: usize>(angle: f64) -> [u64; WORDS] {
    let bits = angle.to_bits();
    let (field, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
    let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
    let start = field.max(1) - 1023 - 52 - 2;
    let (mut product, mut carry) = ([0; WORDS], 0);
    for i in (0..WORDS).rev() {
        let sum = u128::from(significand) * u128::from(bits_from(start + 64 * i as i64)) + carry;
        (product[i], carry) = (sum as u64, sum >> 64);
    }
    if angle.is_sign_negative() { negated(product) } else { product }
}

/// Returns 64 bits of 2/π, starting at this place after the point.
fn bits_from(place: i64) -> u64 {
    let (index, bits) = (place.div_euclid(64), place.rem_euclid(64));
    let word = |i: i64| usize::try_from(i).ok().and_then(|i| TWO_OVER_PI.get(i)).copied().unwrap_or(0);
    if bits == 0 { word(index) } else { word(index) << bits | word(index + 1) >> (64 - bits) }
}

/// Splits quarter turns into the nearest whole number, modulo four, and the magnitude of the
/// remainder. The remainder is at most one half and begins at the point. The Boolean is true for a
/// negative remainder.
#[must_use]
pub fn nearest_quarter<const WORDS: usize>(turns: [u64; WORDS]) -> (u64, bool, [u64; WORDS]) {
    let nearest = (turns[0] >> 62) + (turns[0] >> 61 & 1);
    let fraction: [u64; WORDS] =
        core::array::from_fn(|i| turns[i] << 2 | turns.get(i + 1).map_or(0, |next| next >> 62));
    let is_negative = fraction[0] >> 63 == 1;
    (nearest % 4, is_negative, if is_negative { negated(fraction) } else { fraction })
}

fn negated<const WORDS: usize>(number: [u64; WORDS]) -> [u64; WORDS] {
    let (mut negative, mut carry) = (number, true);
    for word in negative.iter_mut().rev() {
        (*word, carry) = (!*word).overflowing_add(u64::from(carry));
    }
    negative
}
