//! Numbers.

use proc_macro2::Literal;

use super::messages;
use super::messages::habits;
use super::messages::units;
use super::parser::{Parsed, Parser};
use lagrange_expr::limits::MAX_LITERAL_LENGTH;
use lagrange_expr::number::Number;
use lagrange_expr::units::meant;

/// Suffixes of numbers in Rust.
pub(super) const TYPES: [&str; 14] =
    ["f32", "f64", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32", "u64", "u128", "usize"];

impl Parser<'_> {
    /// Returns the exact value of a literal.
    pub(super) fn number(&mut self, literal: &Literal) -> Parsed<Number> {
        let (text, span) = (literal.to_string(), literal.span());
        if !text.starts_with(|first: char| first.is_ascii_digit()) {
            return Err(match text.starts_with(['"', '\'']) {
                true => self.fail_with_help(span, habits::STRING, habits::unquoted(&text)),
                false => self.fail_with_help(span, messages::no_number(&text), messages::NUMBER_HELP),
            });
        }
        let (decimal, suffix) = text.split_at(decimal_length(&text));
        if decimal == "0" && suffix.starts_with(['x', 'o', 'b']) {
            return Err(self.fail_with_help(span, messages::NOT_DECIMAL, messages::NUMBER_HELP));
        }
        if !suffix.is_empty() {
            let digits = decimal.trim_end_matches('_');
            if !TYPES.contains(&suffix) {
                let (message, help) = match self.is_free_unit(suffix) {
                    true => {
                        (units::WITHOUT_SPACE, units::with_space(digits, meant(suffix).unwrap_or(suffix)))
                    }
                    false => (messages::LETTERS, messages::letters_help(digits, suffix)),
                };
                return Err(self.fail_with_help(span, message, help));
            }
            return Err(self.fail_with_help(span, messages::SUFFIX, messages::suffix_help(digits)));
        }
        let value = if text.len() > MAX_LITERAL_LENGTH { None } else { Number::parse_decimal(&text) };
        value.ok_or_else(|| {
            let message = messages::excessive_number(&text);
            self.fail_with_help(span, message, messages::EXCESSIVE_NUMBER_HELP)
        })
    }
}

/// Returns the length of the decimal number in a literal; a type suffix may follow.
fn decimal_length(text: &str) -> usize {
    let mantissa = leading(text, |byte| byte.is_ascii_digit() || byte == b'_' || byte == b'.');
    let Some(exponent) = text[mantissa..].strip_prefix(['e', 'E']) else {
        return mantissa;
    };
    let unsigned = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    let digits = leading(unsigned, |byte| byte.is_ascii_digit() || byte == b'_');
    if unsigned[..digits].bytes().any(|byte| byte.is_ascii_digit()) {
        text.len() - unsigned.len() + digits
    } else {
        mantissa
    }
}

fn leading(text: &str, fits: impl Fn(u8) -> bool) -> usize {
    text.bytes().take_while(|&byte| fits(byte)).count()
}
