//! Contacts of `contact` statements, against handwritten ones, closed forms and conserved
//! quantities.
//!
//! `cargo motions --test contacts` runs these tests.
#![cfg(any(not(debug_assertions), clippy))]

mod boxes;
mod by_hand;
mod flat;
mod moving;
mod plates;
mod robot;
mod round;
mod stepped;

const G: f64 = 9.81;

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance, "{found} instead of {wanted}");
    }
}

/// Returns the state of a free body: position, no rotation, velocities.
fn flat(place: [f64; 3], [a, b, c]: [f64; 3], [p, q, r]: [f64; 3]) -> [f64; 13] {
    let [x, y, z] = place;
    [x, y, z, 1.0, 0.0, 0.0, 0.0, a, b, c, p, q, r]
}

/// Returns the period of a pendulum for a length and an amplitude, by the arithmetic–geometric
/// mean.
fn pendulum_period(length: f64, amplitude: f64) -> f64 {
    let (mut a, mut g) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    std::f64::consts::TAU * (length / G).sqrt() / a
}
