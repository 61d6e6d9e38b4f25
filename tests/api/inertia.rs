//! Moments of inertia, derived by integration: functions of Rust, of the language, and the laws
//! that they obey.

mod compound;
mod derived;
mod formulas;
mod language;
mod laws;
mod quadrature;

/// Whether two numbers agree to thirteen digits, or to so much of `scale` if that is larger.
#[track_caller]
fn assert_same(what: &str, found: f64, expected: f64, scale: f64) {
    let error = (found - expected).abs();
    assert!(error <= 1e-13 * expected.abs().max(scale), "{what}: {found} is not {expected}");
}
