//! Robots under joint control, in steps, against their planned motions and closed forms.
//!
//! `cargo motions --test robots` runs these tests.
#![cfg(any(not(debug_assertions), clippy))]

mod hand;
mod humanoid;
mod trot;

const G: f64 = 9.81;

/// Checks that all numbers are this one, within a tolerance.
#[track_caller]
fn assert_near(name: &str, found: impl Iterator<Item = f64>, wanted: f64, tolerance: f64) {
    for found in found {
        assert!((found - wanted).abs() <= tolerance, "{name}: {found} instead of {wanted}");
    }
}

/// Returns the angle between the vertical and the axis z of a body with this orientation.
fn tilt([_, x, y, _]: [f64; 4]) -> f64 {
    2.0 * x.hypot(y).asin()
}
