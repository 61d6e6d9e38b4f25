//! Numerals for exact numbers.

use lagrange_expr::number::Number;

/// Maximum number of digits after the decimal point; longer decimals are written with an exponent.
const MAX_DECIMALS: usize = 6;
/// Maximum number of trailing zeros of integers; others are written with an exponent.
const MAX_ZEROS: usize = 6;

/// A number written as a numerator and, where that is shorter or the only exact way, a denominator.
pub(super) struct Numeral {
    pub(super) numerator: String,
    pub(super) denominator: Option<String>,
}

/// Returns the numeral of a nonnegative number. A fraction is written as a decimal if it terminates
/// and its denominator is a multiple of five: 9.81 and 0.1, but 1/2 and 3/4.
pub(super) fn numeral(value: &Number) -> Numeral {
    let fraction = value.to_string();
    let Some((numerator, denominator)) = fraction.split_once('/') else {
        return Numeral { numerator: integer(&fraction), denominator: None };
    };
    match decimal(value, denominator) {
        Some(decimal) => Numeral { numerator: decimal, denominator: None },
        None => Numeral { numerator: numerator.to_owned(), denominator: Some(denominator.to_owned()) },
    }
}

fn integer(digits: &str) -> String {
    let significant = digits.trim_end_matches('0');
    let zeros = digits.len() - significant.len();
    if zeros > MAX_ZEROS { format!("{significant}e{zeros}") } else { digits.to_owned() }
}

fn decimal(value: &Number, denominator: &str) -> Option<String> {
    let places = decimal_places(denominator.parse().ok()?)?;
    let scaled = value * &Number::from(10).power(i32::try_from(places).ok()?)?;
    let digits = scaled.to_string();
    if places > MAX_DECIMALS {
        return Some(format!("{digits}e-{places}"));
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    Some(format!("{whole}.{fraction}"))
}

/// Returns the number of decimal places of 1/denominator, if it terminates and the denominator is a
/// multiple of five.
fn decimal_places(mut denominator: u128) -> Option<usize> {
    let mut count = |prime: u128| {
        let mut times = 0;
        while denominator.is_multiple_of(prime) {
            denominator /= prime;
            times += 1;
        }
        times
    };
    let (twos, fives) = (count(2), count(5));
    (denominator == 1 && fives > 0).then_some(twos.max(fives))
}

#[cfg(test)]
mod tests {
    use super::numeral;
    use lagrange_expr::number::Number;

    #[test]
    fn numbers_are_written_as_people_write_them() {
        let written = |text: &str| {
            let numeral = numeral(&Number::parse_decimal(text).expect("a literal"));
            numeral.denominator.map_or(numeral.numerator.clone(), |d| format!("{}/{d}", numeral.numerator))
        };
        for same in ["0", "7", "9.81", "0.1", "0.05", "1000", "1e9", "25e-8", "667e22", "12.345678"] {
            assert_eq!(written(same), same);
        }
        assert_eq!(written("0.5"), "1/2");
        assert_eq!(written("0.75"), "3/4");
        assert_eq!(numeral(&Number::ratio(1, 30).expect("no zero")).denominator.as_deref(), Some("30"));
    }
}
