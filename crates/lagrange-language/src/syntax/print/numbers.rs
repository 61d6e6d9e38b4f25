//! Numbers as text, exactly.

use lagrange_expr::number::Number;

/// Maximum number of zeros; more are written as a power of ten.
const MAX_ZEROS: usize = 6;

/// Form in which a number is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Form {
    /// `2`, `0.1` or `1e-9`.
    Literal,
    /// With a leading minus.
    Negative,
    /// Two integers: the decimal does not terminate.
    Quotient,
}

/// Returns the text of a number and its form.
pub(super) fn numeral(number: &Number) -> (String, Form) {
    let sign = if number.is_negative() { "-" } else { "" };
    match number.abs().decimal() {
        None => (number.to_string(), Form::Quotient),
        Some((digits, places)) => {
            let form = if sign.is_empty() { Form::Literal } else { Form::Negative };
            (format!("{sign}{}", decimal(&digits, places)), form)
        }
    }
}

/// Writes digits with this number of decimal places.
fn decimal(digits: &str, places: usize) -> String {
    let significant = digits.trim_end_matches('0');
    let zeros = digits.len() - significant.len();
    if places == 0 {
        let is_long = zeros > MAX_ZEROS && !significant.is_empty();
        return if is_long { format!("{significant}e{zeros}") } else { digits.to_owned() };
    }
    if digits.len() + MAX_ZEROS < places {
        return format!("{digits}e-{places}");
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    format!("{whole}.{fraction}")
}

#[cfg(test)]
mod tests {
    use super::{Form, numeral};
    use lagrange_expr::number::Number;

    #[test]
    fn numbers_are_written_exactly_and_short() {
        let literals = [
            ("0", "0"),
            ("0.0", "0"),
            ("1_000", "1000"),
            ("0.10", "0.1"),
            ("9.81", "9.81"),
            ("2.5e-3", "0.0025"),
            ("12.5e2", "1250"),
            ("1e-9", "1e-9"),
            ("6.674e-11", "6674e-14"),
            ("5.972e24", "5972e21"),
            ("1e400", "1e400"),
        ];
        for (literal, text) in literals {
            let number = Number::parse_decimal(literal).expect("a literal");
            assert_eq!(numeral(&number), (text.to_owned(), Form::Literal));
            assert_eq!(Number::parse_decimal(text), Some(number));
        }
    }

    #[test]
    fn other_numbers_say_how_they_bind() {
        let cases = [
            (1, 3, "1/3", Form::Quotient),
            (-1, 3, "-1/3", Form::Quotient),
            (-1, 4, "-0.25", Form::Negative),
        ];
        for (numerator, denominator, text, form) in cases {
            let number = Number::ratio(numerator, denominator).expect("no zero");
            assert_eq!(numeral(&number), (text.to_owned(), form));
        }
    }
}
