//! Contacts with a stiffness, against closed forms, independent references, rigid contacts and
//! conserved quantities.
//!
//! `cargo motions --test compliant` runs these tests.
#![cfg(any(not(debug_assertions), clippy))]

mod friction;
mod impacts;
mod limits;
mod pairs;
mod products;

const G: f64 = 9.81;

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance, "{found} instead of {wanted}");
    }
}
