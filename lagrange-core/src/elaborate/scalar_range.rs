//! Range of the numbers that a scalar holds.

use crate::syntax::ast::ScalarType;

/// The name of the scalar that limits numbers, and the largest that it holds.
pub(super) fn largest(scalar: &ScalarType) -> (&'static str, f64) {
    match scalar {
        ScalarType::F32 => ("f32", f64::from(f32::MAX)),
        ScalarType::F64 | ScalarType::Generic(_) => ("f64", f64::MAX),
    }
}

/// Whether a number stays finite when it is rounded to the scalar.
pub(super) fn holds(scalar: &ScalarType, value: f64) -> bool {
    match scalar {
        ScalarType::F32 => (value as f32).is_finite(),
        ScalarType::F64 | ScalarType::Generic(_) => value.is_finite(),
    }
}
