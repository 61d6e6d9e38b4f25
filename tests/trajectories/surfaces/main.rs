//! Contacts on terrain, of rims and with friction against turning, against references, other
//! declarations and conserved quantities.
//!
//! `cargo motions --test surfaces` runs these tests.
#![cfg(any(not(debug_assertions), clippy))]

mod cart;
mod euler_disk;
mod flat;
mod rattleback;
mod rim;
mod terrain;
mod tippe_top;
mod turning;

const G: f64 = 9.81;

/// Returns the largest difference between numbers.
fn distance(found: &[f64], wanted: &[f64]) -> f64 {
    assert_eq!(found.len(), wanted.len());
    let differences = found.iter().zip(wanted).map(|(found, wanted)| (found - wanted).abs());
    differences.fold(0.0, |most, next| if next <= most { most } else { next })
}

#[track_caller]
fn assert_near(found: &[f64], wanted: &[f64], tolerance: f64) {
    let distance = distance(found, wanted);
    assert!(distance <= tolerance, "{found:?} instead of {wanted:?}: {distance:e}");
}

/// Returns the state of a free body: position, no rotation, velocities.
fn flat([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> [f64; 13] {
    [x, y, z, 1.0, 0.0, 0.0, 0.0, a, b, c, 0.0, 0.0, 0.0]
}

/// Returns the largest distance of a column from its first value.
fn drift(column: Option<&[f64]>) -> f64 {
    let column = column.expect("recorded");
    distance(column, &vec![column[0]; column.len()])
}
