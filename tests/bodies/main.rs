//! Systems of rigid bodies declared with bodies: the same motions as by hand, and textbook
//! values.

mod balance;
mod changing_masses;
mod four_bar;
mod joints;
mod ladder;
mod pairs;
#[path = "../references/mod.rs"]
mod references;
mod rope;
mod slope;
mod squeezer;

/// Asserts that a number has its expected value, relative to the larger of 1 and its magnitude.
#[track_caller]
fn assert_within(tolerance: f64, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance * expected.abs().max(1.0), "{found} is not {expected}: {error:e} off");
}
