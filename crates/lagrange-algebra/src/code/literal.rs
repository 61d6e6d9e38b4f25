//! Numbers as literals of a scalar, rounded once.

use std::cmp::Ordering;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::program::{Float, remainder};
use lagrange_expr::number::Number;

/// A constant of a program.
#[derive(Clone, Copy, Debug)]
pub(super) enum Constant<'a> {
    Exact(&'a Number),
    Rounded(Float),
}

impl Constant<'_> {
    /// Returns the shortest text that reads back as the nearest `f64`; `None` if that is not
    /// finite.
    pub(super) fn double(self) -> Option<String> {
        let value = self.to_f64();
        value.is_finite().then(|| format!("{value:?}"))
    }

    /// Returns the shortest text that reads back as the nearest `f32`; `None` if that is not
    /// finite.
    pub(super) fn single(self) -> Option<String> {
        let value = match self {
            Constant::Exact(number) => nearest_single(number),
            Constant::Rounded(value) => value.value() as f32,
        };
        value.is_finite().then(|| format!("{value:?}"))
    }

    /// Returns the shortest text of what the nearest `f64` lacks; `None` if that is nothing.
    pub(super) fn remainder(self) -> Option<String> {
        let remainder = match self {
            Constant::Exact(number) => remainder(number, number.to_f64()),
            Constant::Rounded(value) => value.remainder(),
        };
        (remainder != 0.0).then(|| format!("{remainder:e}"))
    }

    fn to_f64(self) -> f64 {
        match self {
            Constant::Exact(number) => number.to_f64(),
            Constant::Rounded(value) => value.value(),
        }
    }

    /// Describes a constant that does not fit in a message: long numbers by their order of
    /// magnitude.
    pub(super) fn describe(self) -> String {
        match self {
            Constant::Rounded(value) => value.value().to_string(),
            Constant::Exact(number) => {
                let text = number.to_string();
                let (numerator, denominator) = text.split_once('/').unwrap_or((&text, ""));
                if text.len() <= 24 {
                    return text;
                }
                let sign = if number.is_negative() { "-" } else { "" };
                let digits = numerator.trim_start_matches('-').len();
                format!("about {sign}1e{}", digits.saturating_sub(denominator.len().max(1)))
            }
        }
    }
}

/// Writes a number for code of any scalar, including NaN.
pub fn float(value: f64) -> TokenStream {
    if value.is_nan() {
        return quote!(::core::primitive::f64::NAN);
    }
    let magnitude = literal(&format!("{:?}", value.abs()));
    if value.is_sign_negative() { quote!(-#magnitude) } else { quote!(#magnitude) }
}

/// Returns a literal from the text of a finite number without a sign.
pub(super) fn literal(text: &str) -> Literal {
    text.parse().expect("a finite number without sign, written by the standard library, is a literal")
}

/// Returns the `f32` nearest to an exact number.
///
/// Rounding to `f64` first is only wrong if the result lies exactly halfway between two `f32` and
/// the number itself does not. In this case the number decides.
fn nearest_single(number: &Number) -> f32 {
    let double = number.to_f64();
    let single = double as f32;
    let error = double - f64::from(single);
    let other = if error > 0.0 { single.next_up() } else { single.next_down() };
    if error == 0.0 || !single.is_finite() || f64::from(other) - double != error {
        return single;
    }
    let (lower, upper) = if error > 0.0 { (single, other) } else { (other, single) };
    match Number::from_f64(double).map_or(Ordering::Equal, |double| number.cmp(&double)) {
        Ordering::Less => lower,
        Ordering::Equal => single,
        Ordering::Greater => upper,
    }
}

#[cfg(test)]
mod tests {
    use super::{Constant, nearest_single};
    use lagrange_expr::number::Number;

    fn number(text: &str) -> Number {
        Number::parse_decimal(text).expect("a literal")
    }

    #[test]
    fn literals_are_the_shortest_that_round_trip() {
        let texts = ["0.5", "9.81", "2", "6.674e-11", "1e300", "100000"];
        let doubles = texts.map(|text| Constant::Exact(&number(text)).double());
        let expected = ["0.5", "9.81", "2.0", "6.674e-11", "1e300", "100000.0"];
        assert_eq!(doubles, expected.map(|text| Some(text.to_owned())));
        let third = Number::ratio(1, 3).expect("no zero");
        assert_eq!(Constant::Exact(&third).double().as_deref(), Some("0.3333333333333333"));
        assert_eq!(Constant::Exact(&third).single().as_deref(), Some("0.33333334"));
    }

    #[test]
    fn remainders_continue_the_nearest_number() {
        let remainder = |text: &str| Constant::Exact(&number(text)).remainder();
        assert_eq!(remainder("0.5"), None);
        assert_eq!(remainder("1e400"), None);
        // The nearest double is 3602879701896397 / 2⁵⁵, and 0.1 · 2⁵⁵ is that less 1/5.
        assert_eq!(remainder("0.1").as_deref(), Some("-5.551115123125783e-18"));
        let opposite = -&number("0.1");
        assert_eq!(Constant::Exact(&opposite).remainder().as_deref(), Some("5.551115123125783e-18"));
    }

    #[test]
    fn numbers_out_of_range_are_refused_and_described() {
        let (large, huge) = (number("1e39"), number("1e400"));
        assert_eq!(Constant::Exact(&large).single(), None);
        assert!(Constant::Exact(&large).double().is_some());
        assert_eq!(Constant::Exact(&huge).double(), None);
        assert_eq!(Constant::Exact(&huge).describe(), "about 1e400");
        assert_eq!(Constant::Exact(&-&huge).describe(), "about -1e400");
    }

    #[test]
    fn single_precision_rounds_once() {
        // 1 + 2⁻²⁴ is halfway between two f32; the added amount is lost in f64.
        let half = Number::TWO.power(-24).expect("short");
        let tiny = Number::TWO.power(-80).expect("short");
        let halfway = &Number::ONE + &half;
        assert_eq!(nearest_single(&halfway), 1.0);
        assert_eq!(nearest_single(&(&halfway + &tiny)), 1.0 + f32::EPSILON);
        assert_eq!(nearest_single(&(&halfway - &tiny)), 1.0);
        assert_eq!(nearest_single(&-&(&halfway + &tiny)), -1.0 - f32::EPSILON);
    }
}
