//! Decimals: numbers as written in a file, with their values.
//!
//! Numbers in a declaration are as exact as in the file, and are written briefly, without
//! superfluous zeros.

use std::fmt;

/// Range of powers of ten in which a number is written without an exponent.
const PLAIN: std::ops::RangeInclusive<i64> = -5..=9;
/// Maximum number of digits of an exponent, more than any number needs.
const LONGEST_EXPONENT: usize = 6;

/// A finite decimal and its value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Decimal {
    /// Digits without the sign.
    digits: String,
    is_negative: bool,
    value: f64,
}

impl Decimal {
    /// Parses a text as a finite number; `None` if it is not one.
    pub(crate) fn parse(text: &str) -> Option<Decimal> {
        let (unsigned, is_negative) = match text.strip_prefix('-') {
            Some(rest) => (rest, true),
            None => (text.strip_prefix('+').unwrap_or(text), false),
        };
        let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent_of(exponent)?),
            None => (unsigned, 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = [whole, fraction].concat();
        if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
            return None;
        }
        let magnitude = unsigned.parse::<f64>().ok().filter(|value| value.is_finite())?;
        let point = i64::try_from(whole.len()).ok()? + exponent;
        // Numbers that underflow are zero.
        let digits = if magnitude == 0.0 { "0".to_owned() } else { written(&digits, point) };
        let is_negative = is_negative && magnitude > 0.0;
        Some(Decimal { digits, is_negative, value: if is_negative { -magnitude } else { magnitude } })
    }

    /// Returns the shortest decimal of a computed finite number.
    pub(crate) fn of(value: f64) -> Decimal {
        Decimal::parse(&format!("{value:e}")).unwrap_or_else(Decimal::zero)
    }

    /// Returns the decimal of a computed number, without the digits affected by rounding.
    pub(crate) fn rounded(value: f64) -> Decimal {
        Decimal::parse(&format!("{value:.14e}")).unwrap_or_else(Decimal::zero)
    }

    pub(crate) fn zero() -> Decimal {
        Decimal { digits: "0".to_owned(), is_negative: false, value: 0.0 }
    }

    pub(crate) fn value(&self) -> f64 {
        self.value
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.value == 0.0
    }

    pub(crate) fn magnitude(&self) -> Decimal {
        Decimal { is_negative: false, value: self.value.abs(), ..self.clone() }
    }

    pub(crate) fn negated(&self) -> Decimal {
        let is_negative = !self.is_negative && !self.is_zero();
        Decimal { is_negative, value: -self.value + 0.0, ..self.clone() }
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.is_negative { "-" } else { "" }, self.digits)
    }
}

fn exponent_of(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let significant = digits.trim_start_matches('0');
    let is_number = !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
    let magnitude = if significant.is_empty() { "0" } else { significant };
    let is_short = significant.len() <= LONGEST_EXPONENT;
    let magnitude = magnitude.parse::<i64>().ok().filter(|_| is_number && is_short)?;
    Some(if text.starts_with('-') { -magnitude } else { magnitude })
}

/// Writes digits, not all zero, with a decimal point after this number of them.
fn written(digits: &str, point: i64) -> String {
    let leading = digits.len() - digits.trim_start_matches('0').len();
    let significant = digits.trim_matches('0');
    let point = point - leading as i64;
    let count = significant.len() as i64;
    if !PLAIN.contains(&(point - 1)) && point != count {
        let (first, rest) = significant.split_at(1);
        let rest = if rest.is_empty() { String::new() } else { format!(".{rest}") };
        return format!("{first}{rest}e{}", point - 1);
    }
    if point <= 0 {
        return format!("0.{}{significant}", "0".repeat(point.unsigned_abs() as usize));
    }
    if point >= count {
        return format!("{significant}{}", "0".repeat((point - count) as usize));
    }
    let (whole, fraction) = significant.split_at(point as usize);
    format!("{whole}.{fraction}")
}

#[cfg(test)]
mod tests {
    use super::Decimal;

    #[test]
    fn numbers_are_written_short_and_keep_their_digits() {
        let cases = [
            ("0", "0"),
            ("-0.000", "0"),
            ("+1.50", "1.5"),
            (".5", "0.5"),
            ("5.", "5"),
            ("00012.0", "12"),
            ("1200", "1200"),
            ("3.1415926535897932384626", "3.1415926535897932384626"),
            ("-1e-3", "-0.001"),
            ("2.50E+2", "250"),
            ("0.00000057", "5.7e-7"),
            ("1.25e-12", "1.25e-12"),
            ("6e23", "6e23"),
            ("1e-99999", "0"),
        ];
        for (text, written) in cases {
            let number = Decimal::parse(text).expect("a number");
            assert_eq!(number.to_string(), written);
            assert_eq!(Decimal::parse(written), Some(number));
        }
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in [
            "",
            "-",
            ".",
            "e3",
            "1e",
            "nan",
            "inf",
            "0x10",
            "1,5",
            "1 2",
            "1e400",
            "--1",
            "1.2.3",
            "1e9999999",
        ] {
            assert_eq!(Decimal::parse(text), None, "{text}");
        }
    }

    #[test]
    fn computed_numbers_are_those_that_were_computed() {
        for value in [0.1 + 0.2, -1.0 / 3.0, 1e-17, 12345678.9, 5e-324] {
            let number = Decimal::of(value);
            assert_eq!((number.value(), number.to_string().parse()), (value, Ok(value)));
            assert_eq!(number.negated().to_string().parse(), Ok(-value));
        }
        assert_eq!(Decimal::zero().negated(), Decimal::zero());
    }
}
