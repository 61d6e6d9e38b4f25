//! Elementary functions of wide numbers, by series in reduced arguments.
//!
//! J.-M. Muller, *Elementary Functions*, 3rd ed., 2016, chapters 3 and 11.

use crate::wide::Wide;

/// Powers of two beyond which every result overflows or underflows.
const LARGEST_POWER: i32 = 1 << 12;
/// The first bits of 1/√2.
const ROOT_OF_HALF: u64 = 0xb504_f333_f9de_6484;

/// Computes sine and cosine of an angle of at most π/4.
pub(crate) fn sin_cos(angle: Wide) -> (Wide, Wide) {
    let square = angle.times(angle).negated();
    let cosine =
        (1..=15).rev().fold(Wide::ONE, |sum, k| Wide::ONE.plus(square.times(sum).over((2 * k - 1) * 2 * k)));
    (angle.times(sine_series(square)), cosine)
}

/// Computes 1 + z/3! + z²/5! + ….
fn sine_series(z: Wide) -> Wide {
    (1..=15).rev().fold(Wide::ONE, |sum, k| Wide::ONE.plus(z.times(sum).over(2 * k * (2 * k + 1))))
}

/// Computes e to a power of moderate size.
pub(crate) fn exp(x: Wide) -> Wide {
    let (doublings, _) = x.divided_by(Wide::LN_2).split();
    let doublings = doublings.clamp(-LARGEST_POWER, LARGEST_POWER);
    let rest = x.minus(Wide::LN_2.times(Wide::integer(i64::from(doublings)))).scaled(-4);
    let mut power = (1..=16).rev().fold(Wide::ONE, |sum, k| Wide::ONE.plus(rest.times(sum).over(k)));
    for _ in 0..4 {
        power = power.times(power);
    }
    power.scaled(doublings)
}

/// Computes hyperbolic sine and cosine.
pub(crate) fn sinh_cosh(x: Wide) -> (Wide, Wide) {
    let power = exp(x);
    let reciprocal = Wide::ONE.divided_by(power);
    let cosine = power.plus(reciprocal).scaled(-1);
    if x.is_below(&Wide::ONE) {
        return (x.times(sine_series(x.times(x))), cosine);
    }
    (power.minus(reciprocal).scaled(-1), cosine)
}

/// Computes the natural logarithm of a positive number.
pub(crate) fn ln(x: Wide) -> Wide {
    let is_upper = x.mantissa[0] > ROOT_OF_HALF;
    let doublings = if is_upper { x.exponent } else { x.exponent - 1 };
    let rest = ln_near_one(x.scaled(-doublings).minus(Wide::ONE));
    Wide::LN_2.times(Wide::integer(i64::from(doublings))).plus(rest)
}

/// Computes ln(1 + x) = 2 artanh(x / (2 + x)) for 1 + x within [1/√2, √2].
pub(crate) fn ln_near_one(x: Wide) -> Wide {
    let s = x.divided_by(Wide::power_of_two(1).plus(x));
    let square = s.times(s);
    let series = (0..28).rev().fold(Wide::ZERO, |sum, k| Wide::ONE.over(2 * k + 1).plus(square.times(sum)));
    s.times(series).scaled(1)
}

/// Computes the angle in [0, π] of a point in the upper half plane, other than the origin.
pub(crate) fn angle(ordinate: Wide, abscissa: Wide) -> Wide {
    let across = abscissa.magnitude();
    let acute = if across.is_below(&ordinate) {
        Wide::PI.scaled(-1).minus(arctangent(across.divided_by(ordinate)))
    } else {
        arctangent(ordinate.divided_by(across))
    };
    if abscissa.is_negative { Wide::PI.minus(acute) } else { acute }
}

/// Computes the angle of a tangent in [0, 1]: halved three times, then by series.
fn arctangent(tangent: Wide) -> Wide {
    let half = |t: Wide| t.divided_by(Wide::ONE.plus(Wide::ONE.plus(t.times(t)).root()));
    let tangent = half(half(half(tangent)));
    let square = tangent.times(tangent).negated();
    let series = (0..22).rev().fold(Wide::ZERO, |sum, k| Wide::ONE.over(2 * k + 1).plus(square.times(sum)));
    tangent.times(series).scaled(3)
}
