//! Exact rational numbers.
//!
//! Every literal of a declaration is kept exactly: `0.1` is one tenth. Arithmetic uses machine
//! words as long as numerator and denominator fit, and big integers otherwise. Rounding happens
//! once, when a constant is written to generated code.

#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::fmt;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{CheckedAdd, CheckedMul, One, Pow, Signed, ToPrimitive, Zero};

use crate::limits::{MAX_DECIMAL_EXPONENT, MAX_NUMBER_BITS};

/// Maximum number of bits in the result of a power; larger powers are not evaluated.
const LARGEST_POWER_BITS: u64 = 4096;

/// A rational number in lowest terms, with a positive denominator.
///
/// Equal numbers have equal representations, so `==` and `Hash` are exact.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Number(Repr);

#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    Word(Ratio<i64>),
    /// Only for values that do not fit in `Word`.
    Big(Box<BigRational>),
}

impl Number {
    /// Zero.
    pub const ZERO: Number = Number(Repr::Word(Ratio::new_raw(0, 1)));
    /// One.
    pub const ONE: Number = Number(Repr::Word(Ratio::new_raw(1, 1)));
    /// Minus one.
    pub const MINUS_ONE: Number = Number(Repr::Word(Ratio::new_raw(-1, 1)));
    /// One half.
    pub const HALF: Number = Number(Repr::Word(Ratio::new_raw(1, 2)));
    /// Two.
    pub const TWO: Number = Number(Repr::Word(Ratio::new_raw(2, 1)));

    /// Returns `numerator / denominator`; `None` if the denominator is zero.
    pub fn ratio(numerator: i64, denominator: i64) -> Option<Number> {
        if denominator == 0 {
            return None;
        }
        Some(Number::from_big(BigRational::new(numerator.into(), denominator.into())))
    }

    /// Reads an unsigned integer or decimal literal such as `3`, `0.1` or `2.5e-3`; underscores may
    /// separate digits. `None` if the text is not such a literal or its exponent is unreasonable.
    pub fn parse_decimal(text: &str) -> Option<Number> {
        let text = text.replace('_', "");
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
            None => (text.as_str(), 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{fraction}");
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let scale = exponent.checked_sub(fraction.len() as i64)?;
        if scale.abs() > MAX_DECIMAL_EXPONENT {
            return None;
        }
        let power = Pow::pow(BigInt::from(10), scale.unsigned_abs());
        let digits = BigRational::from_integer(digits.parse::<BigInt>().ok()?);
        Some(Number::from_big(if scale < 0 { digits / power } else { digits * power }))
    }

    fn from_big(value: BigRational) -> Number {
        match (value.numer().to_i64(), value.denom().to_i64()) {
            (Some(numerator), Some(denominator)) => {
                Number(Repr::Word(Ratio::new_raw(numerator, denominator)))
            }
            _ => Number(Repr::Big(Box::new(value))),
        }
    }

    fn to_big(&self) -> BigRational {
        match &self.0 {
            Repr::Word(ratio) => BigRational::new_raw((*ratio.numer()).into(), (*ratio.denom()).into()),
            Repr::Big(big) => (**big).clone(),
        }
    }

    /// True if this is zero.
    pub fn is_zero(&self) -> bool {
        self.to_integer() == Some(0)
    }

    /// True if this is one.
    pub fn is_one(&self) -> bool {
        self.to_integer() == Some(1)
    }

    /// Returns the value, if it is an integer that fits in a word. Most numbers are, and their
    /// arithmetic needs no gcd.
    pub fn to_integer(&self) -> Option<i64> {
        match &self.0 {
            Repr::Word(ratio) if *ratio.denom() == 1 => Some(*ratio.numer()),
            _ => None,
        }
    }

    /// True if this is below zero.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Repr::Word(ratio) => *ratio.numer() < 0,
            Repr::Big(big) => big.is_negative(),
        }
    }

    /// True if the denominator is one.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Repr::Word(ratio) => *ratio.denom() == 1,
            Repr::Big(big) => big.is_integer(),
        }
    }

    /// True if numerator and denominator are short enough for further computation.
    pub fn is_short(&self) -> bool {
        match &self.0 {
            Repr::Word(_) => true,
            Repr::Big(big) => big.numer().bits().max(big.denom().bits()) <= MAX_NUMBER_BITS,
        }
    }

    /// True if this is an even integer.
    pub fn is_even(&self) -> bool {
        match self.to_integer() {
            Some(integer) => integer % 2 == 0,
            None => self.is_integer() && (self * &Number::HALF).is_integer(),
        }
    }

    /// True if this is an odd integer.
    pub fn is_odd(&self) -> bool {
        self.is_integer() && !self.is_even()
    }

    /// Returns the value, if it is an integer that fits.
    pub fn to_i32(&self) -> Option<i32> {
        self.to_integer().and_then(|integer| i32::try_from(integer).ok())
    }

    /// Returns the digits of an unsigned decimal and the number of decimal places. `None` if the
    /// decimal does not terminate or the number is negative.
    pub fn decimal(&self) -> Option<(String, usize)> {
        let big = self.to_big();
        let (ten, five) = (BigInt::from(10), BigInt::from(5));
        let twos = big.denom().trailing_zeros().unwrap_or(0);
        let (mut rest, mut fives) = (big.denom() >> twos, 0);
        while (&rest % &five).is_zero() {
            rest /= &five;
            fives += 1;
        }
        let places = twos.max(fives);
        let digits = || big.numer() * Pow::pow(ten, places) / big.denom();
        (rest.is_one() && !big.is_negative()).then(|| (digits().to_string(), places as usize))
    }

    /// Returns the nearest `f64`; infinite if the magnitude is out of range.
    pub fn to_f64(&self) -> f64 {
        let exact = |n: &i64| n.unsigned_abs() <= 1 << 53;
        match &self.0 {
            // Exact operands are rounded once, so the result is correctly rounded.
            Repr::Word(ratio) if exact(ratio.numer()) && exact(ratio.denom()) => {
                *ratio.numer() as f64 / *ratio.denom() as f64
            }
            _ => self.to_big().to_f64().unwrap_or(f64::NAN),
        }
    }

    /// Returns the exact value of an `f64`; `None` if that is not finite.
    pub fn from_f64(value: f64) -> Option<Number> {
        let bits = value.to_bits();
        let exponent = (bits >> 52 & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let mantissa = if exponent == 0 { fraction } else { fraction | 1 << 52 };
        let power = Number::TWO.power(exponent.max(1) - 1075).filter(|_| value.is_finite())?;
        let magnitude = &Number::from(mantissa) * &power;
        Some(if value.is_sign_negative() { -&magnitude } else { magnitude })
    }

    /// Returns the magnitude.
    pub fn abs(&self) -> Number {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// Returns `1 / self`; `None` for zero.
    pub fn reciprocal(&self) -> Option<Number> {
        (!self.is_zero()).then(|| match &self.0 {
            Repr::Word(ratio) if *ratio.numer() != i64::MIN => Number(Repr::Word(ratio.recip())),
            _ => Number::from_big(self.to_big().recip()),
        })
    }

    /// Returns the largest number, with the sign of `self`, of which both are integer multiples:
    /// 3/2 for 9/2 and −6. It is `self` if the other is zero.
    pub fn common_divisor(&self, other: &Number) -> Number {
        // p = g n and q = g d, where n/d is p/q in lowest terms.
        let ratio = other.reciprocal().map(|inverse| (self * &inverse).to_big());
        ratio.map_or_else(
            || self.clone(),
            |ratio| {
                let numerator = Number::from_big(ratio.numer().abs().into());
                numerator.reciprocal().map_or_else(|| other.abs(), |inverse| self * &inverse)
            },
        )
    }

    /// Raises `self` to an integer power; `None` for a negative power of zero and for results too
    /// long to be useful.
    pub fn power(&self, exponent: i32) -> Option<Number> {
        if exponent == 1 || self.is_one() {
            return Some(self.clone());
        }
        let base = if exponent < 0 { self.reciprocal()? } else { self.clone() };
        let magnitude = exponent.unsigned_abs();
        let big = base.to_big();
        let bits = big.numer().bits().max(big.denom().bits());
        // Powers of ±1 and 0 never grow.
        if bits > 1 && bits.saturating_mul(magnitude.into()) > LARGEST_POWER_BITS {
            return None;
        }
        Some(Number::from_big(Pow::pow(big, magnitude)))
    }

    /// Returns the exact square root of a square; `None` for every other number.
    pub fn exact_sqrt(&self) -> Option<Number> {
        if self.is_negative() {
            return None;
        }
        let big = self.to_big();
        let root = BigRational::new_raw(big.numer().sqrt(), big.denom().sqrt());
        (&root * &root == big).then(|| Number::from_big(root))
    }
}

impl From<i64> for Number {
    fn from(value: i64) -> Number {
        Number(Repr::Word(Ratio::from_integer(value)))
    }
}

impl std::ops::Add for &Number {
    type Output = Number;
    fn add(self, other: &Number) -> Number {
        if let Some(sum) = self.to_integer().zip(other.to_integer()).and_then(|(a, b)| a.checked_add(b)) {
            return Number::from(sum);
        }
        if let (Repr::Word(a), Repr::Word(b)) = (&self.0, &other.0)
            && let Some(sum) = a.checked_add(b)
        {
            return Number(Repr::Word(sum));
        }
        Number::from_big(self.to_big() + other.to_big())
    }
}

impl std::ops::Sub for &Number {
    type Output = Number;
    fn sub(self, other: &Number) -> Number {
        self + &-other
    }
}

impl std::ops::Mul for &Number {
    type Output = Number;
    fn mul(self, other: &Number) -> Number {
        if self.is_one() {
            return other.clone();
        }
        if other.is_one() {
            return self.clone();
        }
        if let Some(product) = self.to_integer().zip(other.to_integer()).and_then(|(a, b)| a.checked_mul(b)) {
            return Number::from(product);
        }
        if let (Repr::Word(a), Repr::Word(b)) = (&self.0, &other.0)
            && let Some(product) = a.checked_mul(b)
        {
            return Number(Repr::Word(product));
        }
        Number::from_big(self.to_big() * other.to_big())
    }
}

impl std::ops::Neg for &Number {
    type Output = Number;
    fn neg(self) -> Number {
        match &self.0 {
            Repr::Word(ratio) if *ratio.numer() != i64::MIN => {
                Number(Repr::Word(Ratio::new_raw(-ratio.numer(), *ratio.denom())))
            }
            _ => Number::from_big(-self.to_big()),
        }
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Number) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Number) -> Ordering {
        if let Some((a, b)) = self.to_integer().zip(other.to_integer()) {
            return a.cmp(&b);
        }
        match (&self.0, &other.0) {
            (Repr::Word(a), Repr::Word(b)) => a.cmp(b),
            _ => self.to_big().cmp(&other.to_big()),
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Repr::Word(ratio) => ratio.fmt(f),
            Repr::Big(big) => big.fmt(f),
        }
    }
}

impl fmt::Debug for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Zero for Number {
    fn zero() -> Number {
        Number::ZERO
    }
    fn is_zero(&self) -> bool {
        self.is_zero()
    }
}

impl One for Number {
    fn one() -> Number {
        Number::ONE
    }
}

impl std::ops::Add for Number {
    type Output = Number;
    fn add(self, other: Number) -> Number {
        &self + &other
    }
}

impl std::ops::Mul for Number {
    type Output = Number;
    fn mul(self, other: Number) -> Number {
        &self * &other
    }
}
