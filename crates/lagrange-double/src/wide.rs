//! Numbers of 192 bits in integers, for functions with results rounded once.

use core::cmp::Ordering;

use crate::double::Double;

/// A number ± 0.m · 2ᵉ: zero, or one with a set first bit after the point. Results are truncated,
/// with a relative error of at most 2⁻¹⁸⁹.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide {
    pub(crate) is_negative: bool,
    pub(crate) exponent: i32,
    /// Words of the mantissa, most significant word first.
    pub(crate) mantissa: [u64; 3],
}

impl Wide {
    pub(crate) const ZERO: Wide = Wide { is_negative: false, exponent: 0, mantissa: [0; 3] };
    pub(crate) const ONE: Wide = Wide::power_of_two(0);
    pub(crate) const PI: Wide = Wide {
        is_negative: false,
        exponent: 2,
        mantissa: [0xc90f_daa2_2168_c234, 0xc4c6_628b_80dc_1cd1, 0x2902_4e08_8a67_cc74],
    };
    pub(crate) const LN_2: Wide = Wide {
        is_negative: false,
        exponent: 0,
        mantissa: [0xb172_17f7_d1cf_79ab, 0xc9e3_b398_03f2_f6af, 0x40f3_4326_7298_b62d],
    };

    pub(crate) const fn power_of_two(power: i32) -> Wide {
        Wide { is_negative: false, exponent: power + 1, mantissa: [1 << 63, 0, 0] }
    }

    pub(crate) fn integer(value: i64) -> Wide {
        Wide::normalised(value < 0, 64, [value.unsigned_abs(), 0, 0])
    }

    /// Creates the number ± 0.m · 2ᵉ, with its first set bit moved to the point.
    pub(crate) fn normalised(is_negative: bool, exponent: i32, mantissa: [u64; 3]) -> Wide {
        let Some(first) = mantissa.iter().position(|&word| word != 0) else { return Wide::ZERO };
        let zeros = first as u32 * 64 + mantissa[first].leading_zeros();
        Wide { is_negative, exponent: exponent - zeros as i32, mantissa: shifted_left(mantissa, zeros) }
    }

    /// Converts a finite double exactly.
    pub(crate) fn of(value: f64) -> Wide {
        let bits = value.to_bits();
        let (field, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
        let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
        Wide::normalised(value.is_sign_negative(), field.max(1) - 1023 - 52 + 64, [significand, 0, 0])
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.mantissa[0] == 0
    }

    pub(crate) fn negated(self) -> Wide {
        Wide { is_negative: !self.is_negative, ..self }
    }

    pub(crate) fn magnitude(self) -> Wide {
        Wide { is_negative: false, ..self }
    }

    /// Multiplies by 2 to a power.
    pub(crate) fn scaled(self, power: i32) -> Wide {
        if self.is_zero() { self } else { Wide { exponent: self.exponent + power, ..self } }
    }

    pub(crate) fn plus(self, other: Wide) -> Wide {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let (large, small) = if self.is_below(&other) { (other, self) } else { (self, other) };
        let shift = large.exponent.saturating_sub(small.exponent) as u32;
        let addend = shifted_right(small.mantissa, shift);
        if large.is_negative != small.is_negative {
            return Wide::normalised(large.is_negative, large.exponent, difference(large.mantissa, addend));
        }
        let (mantissa, carry) = added(large.mantissa, addend);
        if !carry {
            return Wide { mantissa, ..large };
        }
        let mut mantissa = shifted_right(mantissa, 1);
        mantissa[0] |= 1 << 63;
        Wide { exponent: large.exponent + 1, mantissa, ..large }
    }

    pub(crate) fn minus(self, other: Wide) -> Wide {
        self.plus(other.negated())
    }

    pub(crate) fn times(self, other: Wide) -> Wide {
        if self.is_zero() || other.is_zero() {
            return Wide::ZERO;
        }
        let product = upper_product(self.mantissa, other.mantissa);
        Wide::normalised(self.is_negative != other.is_negative, self.exponent + other.exponent, product)
    }

    /// Divides by a small number.
    pub(crate) fn over(self, divisor: u32) -> Wide {
        let mut remainder = 0;
        let quotient = self.mantissa.map(|word| {
            let dividend = (remainder << 64) | u128::from(word);
            remainder = dividend % u128::from(divisor);
            (dividend / u128::from(divisor)) as u64
        });
        Wide::normalised(self.is_negative, self.exponent, quotient)
    }

    /// Divides by a nonzero number. Newton's iteration for the reciprocal doubles the number of
    /// digits.
    pub(crate) fn divided_by(self, divisor: Wide) -> Wide {
        let divisor_mantissa = Wide { exponent: 0, ..divisor };
        let mut reciprocal = Wide::of(1.0 / divisor_mantissa.rough());
        for _ in 0..2 {
            let missing = Wide::ONE.minus(divisor_mantissa.times(reciprocal));
            reciprocal = reciprocal.plus(reciprocal.times(missing));
        }
        self.times(reciprocal).scaled(-divisor.exponent)
    }

    /// Returns the nearest number of 185 bits. This reverses the truncation of a few operations if
    /// the result has fewer bits.
    pub(crate) fn rounded(self) -> Wide {
        let half = Wide { is_negative: self.is_negative, ..Wide::power_of_two(self.exponent - 186) };
        let mut rounded = self.plus(half);
        rounded.mantissa[2] &= !0x7f;
        rounded
    }

    /// Computes the square root of a magnitude, by Newton's iteration for its reciprocal.
    pub(crate) fn root(self) -> Wide {
        if self.is_zero() {
            return self;
        }
        let halved = self.exponent.div_euclid(2);
        let mantissa = Wide { exponent: self.exponent.rem_euclid(2), is_negative: false, ..self };
        let mut reciprocal = Wide::of(1.0 / lagrange_runtime::Number::sqrt(mantissa.rough()));
        for _ in 0..2 {
            let missing = Wide::ONE.minus(mantissa.times(reciprocal).times(reciprocal));
            reciprocal = reciprocal.plus(reciprocal.times(missing).scaled(-1));
        }
        mantissa.times(reciprocal).scaled(halved)
    }

    /// True if the magnitude is less than that of the other number.
    pub(crate) fn is_below(&self, other: &Wide) -> bool {
        if self.is_zero() || other.is_zero() {
            return !other.is_zero();
        }
        self.exponent.cmp(&other.exponent).then(self.mantissa.cmp(&other.mantissa)) == Ordering::Less
    }

    /// Returns a double close to a number of moderate size.
    pub(crate) fn rough(self) -> f64 {
        self.leading(self.exponent.clamp(-900, 900))
    }

    /// Returns the nearest whole number, which must be of moderate size, and the remainder.
    pub(crate) fn split(self) -> (i32, Wide) {
        let rough = self.rough();
        let whole = if rough < 0.0 { (rough - 0.5) as i32 } else { (rough + 0.5) as i32 };
        (whole, self.minus(Wide::integer(i64::from(whole))))
    }

    /// Returns the mantissa rounded to a double, times 2 to this power.
    fn leading(self, exponent: i32) -> f64 {
        // Any following bit rounds ties up; a sticky bit preserves it.
        let sticky = u64::from(self.mantissa[1] != 0 || self.mantissa[2] != 0);
        let value = times_power(i128::from(self.mantissa[0] | sticky), exponent - 64);
        if self.is_negative { -value } else { value }
    }

    /// Returns the nearest integer to a magnitude below 2¹²⁷.
    pub(crate) fn to_integer(self) -> u128 {
        let half = self.magnitude().plus(Wide::power_of_two(-1));
        let bits = u128::from(half.mantissa[0]) << 64 | u128::from(half.mantissa[1]);
        if half.exponent <= 0 { 0 } else { bits >> (128 - half.exponent.min(127)) }
    }

    /// Returns the nearest sum of two doubles; infinite beyond their range.
    pub(crate) fn to_double(self) -> Double {
        let upper = self.leading(self.exponent.clamp(-2000, 2000));
        if !upper.is_finite() || upper == 0.0 {
            return Double::of(upper);
        }
        let rest = self.minus(Wide::of(upper));
        let lower = rest.leading(rest.exponent.clamp(-2000, 2000));
        Double::from_sum(upper, lower)
    }
}

/// Computes value · 2ᵖ with one rounding, in two steps. The first step is exact unless the result
/// is subnormal.
fn times_power(value: i128, power: i32) -> f64 {
    let bits = 128 - value.leading_zeros() as i32;
    // Bits below the last bit of subnormal numbers only affect rounding.
    let lost = (-1074 - power).max(0);
    let kept = bits - lost;
    let value = if kept < 53 && lost > 0 { rounded_bits(value, lost) } else { value };
    let power = if kept < 53 && lost > 0 { -1074 } else { power };
    (value as f64) * two_to(power / 2) * two_to(power - power / 2)
}

/// Divides the value by 2 to the number of lost bits, rounded to the nearest, ties to even.
fn rounded_bits(value: i128, lost: i32) -> i128 {
    if lost > 120 {
        return 0;
    }
    let (quotient, remainder, half) = (value >> lost, value & ((1 << lost) - 1), 1_i128 << (lost - 1));
    quotient + i128::from(remainder > half || remainder == half && quotient & 1 == 1)
}

/// Returns 2 to a power in the range of normal numbers.
fn two_to(power: i32) -> f64 {
    f64::from_bits(((power + 1023) as u64) << 52)
}

fn shifted_left(words: [u64; 3], bits: u32) -> [u64; 3] {
    let (skipped, bits) = (bits as usize / 64, bits % 64);
    core::array::from_fn(|i| {
        let word = |i: usize| words.get(i).copied().unwrap_or(0);
        let (upper, lower) = (word(i + skipped), word(i + skipped + 1));
        if bits == 0 { upper } else { upper << bits | lower >> (64 - bits) }
    })
}

fn shifted_right(words: [u64; 3], bits: u32) -> [u64; 3] {
    let (skipped, bits) = (bits as usize / 64, bits % 64);
    core::array::from_fn(|i| {
        let word = |back: usize| i.checked_sub(back).map_or(0, |i| words[i]);
        let (lower, upper) = (word(skipped), word(skipped + 1));
        if bits == 0 { lower } else { lower >> bits | upper << (64 - bits) }
    })
}

fn added(a: [u64; 3], b: [u64; 3]) -> ([u64; 3], bool) {
    let (mut sum, mut carry) = ([0; 3], false);
    for i in (0..3).rev() {
        let (partial, first) = a[i].overflowing_add(b[i]);
        let (word, second) = partial.overflowing_add(u64::from(carry));
        (sum[i], carry) = (word, first || second);
    }
    (sum, carry)
}

fn difference(a: [u64; 3], b: [u64; 3]) -> [u64; 3] {
    let (mut difference, mut borrow) = ([0; 3], false);
    for i in (0..3).rev() {
        let (partial, first) = a[i].overflowing_sub(b[i]);
        let (word, second) = partial.overflowing_sub(u64::from(borrow));
        (difference[i], borrow) = (word, first || second);
    }
    difference
}

/// Returns the upper half of the product.
fn upper_product(a: [u64; 3], b: [u64; 3]) -> [u64; 3] {
    let mut words = [0_u64; 6];
    for i in (0..3).rev() {
        let mut carry = 0_u128;
        for j in (0..3).rev() {
            let sum = u128::from(a[i]) * u128::from(b[j]) + u128::from(words[i + j + 1]) + carry;
            words[i + j + 1] = sum as u64;
            carry = sum >> 64;
        }
        words[i] = carry as u64;
    }
    [words[0], words[1], words[2]]
}
