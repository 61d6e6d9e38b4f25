//! Range of the numbers that a scalar can represent.

use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::ScalarType;

/// Returns the name of the scalar that limits numbers, and its largest number.
pub(super) fn largest(scalar: &ScalarType) -> (&'static str, f64) {
    match scalar {
        ScalarType::F32 => ("f32", f64::from(f32::MAX)),
        ScalarType::F64 | ScalarType::Generic(_) => ("f64", f64::MAX),
    }
}

/// Reason why a scalar cannot represent a number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Misfit {
    /// The number would be infinite.
    TooLarge,
    /// The number would be zero or subnormal, with fewer digits than other numbers.
    TooSmall,
}

/// Returns the misfit of a number that is rounded to the scalar; `None` if it keeps its digits.
pub(super) fn misfit(scalar: &ScalarType, number: &Number) -> Option<Misfit> {
    misfit_of_value(scalar, number.to_f64())
        .or_else(|| (!number.is_zero() && number.to_f64() == 0.0).then_some(Misfit::TooSmall))
}

/// Returns the misfit of a number that is already in `f64`.
pub(super) fn misfit_of_value(scalar: &ScalarType, value: f64) -> Option<Misfit> {
    let (rounded, least) = match scalar {
        ScalarType::F32 => (f64::from(value as f32), f64::from(f32::MIN_POSITIVE)),
        ScalarType::F64 | ScalarType::Generic(_) => (value, f64::MIN_POSITIVE),
    };
    match rounded.abs() {
        _ if !rounded.is_finite() => Some(Misfit::TooLarge),
        size if size < least && value != 0.0 => Some(Misfit::TooSmall),
        _ => None,
    }
}
