//! Range of the numbers that a scalar holds.

use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::ScalarType;

/// The name of the scalar that limits numbers, and the largest that it holds.
pub(super) fn largest(scalar: &ScalarType) -> (&'static str, f64) {
    match scalar {
        ScalarType::F32 => ("f32", f64::from(f32::MAX)),
        ScalarType::F64 | ScalarType::Generic(_) => ("f64", f64::MAX),
    }
}

/// Why a scalar does not hold a number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Misfit {
    /// It would be infinite.
    TooLarge,
    /// It would be subnormal, with fewer digits than other numbers, or zero.
    TooSmall,
}

/// Returns the misfit of a number that is rounded to the scalar; `None` if it keeps its digits.
pub(super) fn misfit(scalar: &ScalarType, number: &Number) -> Option<Misfit> {
    misfit_of_value(scalar, number.to_f64())
        .or_else(|| (!number.is_zero() && number.to_f64() == 0.0).then_some(Misfit::TooSmall))
}

/// Returns the misfit of a number that is in `f64` already.
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
