//! Moments of inertia, derived by integration: functions of Rust and of the language, and the laws
//! that they satisfy.

mod compound;
mod derived;
mod formulas;
mod language;
mod laws;
mod quadrature;

/// Asserts that two numbers agree to thirteen digits, or to that fraction of `scale` if it is
/// larger.
#[track_caller]
fn assert_same(what: &str, found: f64, expected: f64, scale: f64) {
    let error = (found - expected).abs();
    assert!(error <= 1e-13 * expected.abs().max(scale), "{what}: {found} is not {expected}");
}
