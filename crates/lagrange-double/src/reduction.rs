//! Reduction of angles of any size by the nearest multiple of π/2.

use lagrange_math::{nearest_quarter, quarter_turns};

use crate::double::Double;
use crate::wide::Wide;

/// Number of words of a number of quadrants: two bits before the point and 446 after it. An angle
/// of 106 bits is no closer to a multiple of π/2 than about 2⁻¹²⁰. More than 192 bits therefore
/// follow the first set bit.
const WORDS: usize = 7;
type Quadrants = [u64; WORDS];

/// Returns the nearest multiple of π/2 to a finite angle, modulo four, and the remainder.
pub(crate) fn reduced(angle: Double) -> (u64, Wide) {
    let (upper, lower) = angle.parts();
    if upper.abs() < 0.785 {
        return (0, Wide::of(upper).plus(Wide::of(lower)));
    }
    let (nearest, is_negative, rest) = nearest_quarter(added(quarter_turns(upper), quarter_turns(lower)));
    (nearest, first_bits(is_negative, &rest).times(Wide::PI).scaled(-1))
}

/// Returns the leading 192 bits of a fraction.
fn first_bits(is_negative: bool, fraction: &Quadrants) -> Wide {
    let Some(first) = fraction.iter().position(|&word| word != 0) else { return Wide::ZERO };
    let zeros = fraction[first].leading_zeros();
    let word = |i: usize| fraction.get(first + i).copied().unwrap_or(0);
    let aligned =
        |i: usize| if zeros == 0 { word(i) } else { word(i) << zeros | word(i + 1) >> (64 - zeros) };
    let exponent = -(first as i32 * 64 + zeros as i32);
    Wide { is_negative, exponent, mantissa: [aligned(0), aligned(1), aligned(2)] }
}

fn added(a: Quadrants, b: Quadrants) -> Quadrants {
    let (mut sum, mut carry) = ([0; WORDS], 0);
    for i in (0..WORDS).rev() {
        let word = u128::from(a[i]) + u128::from(b[i]) + carry;
        (sum[i], carry) = (word as u64, word >> 64);
    }
    sum
}
