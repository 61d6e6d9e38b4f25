//! Decimal text.

use core::fmt;
use core::str::FromStr;

use crate::double::Double;
use crate::wide::Wide;

/// Number of digits that are written.
const DIGITS: i32 = 32;
/// Maximum number of digits that are read; later ones are ignored.
const MAX_DIGITS: usize = 60;
/// Powers of ten beyond which every number is zero or infinite.
const LARGEST_POWER: i64 = 2000;

/// The error for a text that is not a decimal number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ParseDoubleError;

impl fmt::Display for ParseDoubleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "not a decimal number: write digits with an optional point and exponent, such as `-9.81e-3`",
        )
    }
}

impl core::error::Error for ParseDoubleError {}

impl FromStr for Double {
    type Err = ParseDoubleError;

    /// Parses a decimal number in the syntax of `f64`, with full precision.
    fn from_str(text: &str) -> Result<Self, ParseDoubleError> {
        let is_special = |text: &str| text.bytes().all(|byte| byte.is_ascii_alphabetic());
        let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
        if is_special(unsigned) {
            return text.parse::<f64>().map(Double::of).map_err(|_| ParseDoubleError);
        }
        let magnitude = decimal(unsigned)?.to_double();
        Ok(if text.starts_with('-') { -magnitude } else { magnitude })
    }
}

/// Parses digits, a point and an exponent.
fn decimal(text: &str) -> Result<Wide, ParseDoubleError> {
    let (digits, exponent) = match text.split_once(['e', 'E']) {
        Some((digits, exponent)) => (digits, power(exponent)?),
        None => (text, 0),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if whole.len() + fraction.len() == 0 || !are_digits(whole) || !are_digits(fraction) {
        return Err(ParseDoubleError);
    }
    let mut value = Wide::ZERO;
    let mut dropped = 0;
    let significant = whole.bytes().chain(fraction.bytes()).skip_while(|&byte| byte == b'0');
    for (i, byte) in significant.enumerate() {
        if i < MAX_DIGITS {
            value = value.times(Wide::integer(10)).plus(Wide::integer(i64::from(byte - b'0')));
        } else {
            dropped += 1;
        }
    }
    let power = exponent.saturating_add(dropped).saturating_sub(fraction.len() as i64);
    if value.is_zero() {
        return Ok(value);
    }
    Ok(times_power_of_ten(value, power.clamp(-LARGEST_POWER, LARGEST_POWER) as i32).rounded())
}

/// Parses an exponent; large ones are clamped.
fn power(text: &str) -> Result<i64, ParseDoubleError> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    if unsigned.is_empty() || !unsigned.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(ParseDoubleError);
    }
    let magnitude = unsigned.parse().unwrap_or(i64::MAX / 2);
    Ok(if text.starts_with('-') { -magnitude } else { magnitude })
}

/// Computes the number times 10 to a power, by repeated squaring.
fn times_power_of_ten(value: Wide, power: i32) -> Wide {
    let (mut product, mut square) = (Wide::ONE, Wide::integer(10));
    let mut remaining = power.unsigned_abs();
    while remaining > 0 {
        if remaining % 2 == 1 {
            product = product.times(square);
        }
        square = square.times(square);
        remaining /= 2;
    }
    if power < 0 { value.divided_by(product) } else { value.times(product) }
}

/// Returns the leading digits of a positive number as an integer, and the power of ten of the first
/// digit.
fn digits(value: Wide) -> (u128, i32) {
    let limit = 10_u128.pow(DIGITS as u32);
    // log₁₀ 2 is a little less than 1233/4096, so the guess may be too large by one.
    let mut power = ((value.exponent - 1) * 1233).div_euclid(4096);
    loop {
        let digits = times_power_of_ten(value, DIGITS - 1 - power).to_integer();
        if digits >= limit {
            power += 1;
        } else if digits < limit / 10 {
            power -= 1;
        } else {
            return (digits, power);
        }
    }
}

impl fmt::Display for Double {
    /// Writes 32 digits without trailing zeros.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (upper, _) = self.parts();
        if upper == 0.0 || !upper.is_finite() {
            return write!(f, "{upper}");
        }
        let (digits, power) = digits(self.wide().magnitude());
        let sign = if self.is_negative() { "-" } else { "" };
        let text = Digits::new(digits);
        if (-5..DIGITS).contains(&power) {
            return text.fixed(f, sign, power);
        }
        text.fixed(f, sign, 0)?;
        write!(f, "e{power}")
    }
}

/// The digits of a number as characters.
struct Digits {
    characters: [u8; DIGITS as usize],
    /// Number of digits without trailing zeros.
    count: usize,
}

impl Digits {
    fn new(mut digits: u128) -> Self {
        let mut characters = [b'0'; DIGITS as usize];
        for character in characters.iter_mut().rev() {
            *character += (digits % 10) as u8;
            digits /= 10;
        }
        let zeros = characters.iter().rev().take_while(|&&character| character == b'0').count();
        Digits { characters, count: DIGITS as usize - zeros }
    }

    /// Writes the digits with the first one at this power of ten.
    fn fixed(&self, f: &mut fmt::Formatter<'_>, sign: &str, power: i32) -> fmt::Result {
        f.write_str(sign)?;
        if power < 0 {
            f.write_str("0.")?;
            (power + 1..0).try_for_each(|_| f.write_str("0"))?;
            return self.write(f, 0..self.count);
        }
        let whole = power as usize + 1;
        self.write(f, 0..whole)?;
        if self.count > whole {
            f.write_str(".")?;
            self.write(f, whole..self.count)?;
        }
        Ok(())
    }

    fn write(&self, f: &mut fmt::Formatter<'_>, range: core::ops::Range<usize>) -> fmt::Result {
        self.characters[range].iter().try_for_each(|&digit| fmt::Write::write_char(f, digit.into()))
    }
}
