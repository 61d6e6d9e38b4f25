//! Handwritten recursive algorithms and the code emitted for bodies in space give the same results.

use std::array::from_fn;

use crate::handwritten::{Inline, Platform};
use crate::rigid_bodies::Chain;
use crate::robots::{panda, universal_5, universal_10, ur5};

/// Tolerance relative to the largest entry.
const TOLERANCE: f64 = 1e-12;
const STATES: u64 = 50;

/// Draws a number between −2 and 2 (Steele, Lea, Flood, *Fast splittable pseudorandom number
/// generators*).
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut bits = *state;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 51) as f64 - 2.0
}

/// Returns coordinates, velocities and wanted accelerations.
fn states<const N: usize>() -> impl Iterator<Item = [[f64; N]; 3]> {
    let mut seed = 16;
    (0..STATES).map(move |_| from_fn(|_| from_fn(|_| random(&mut seed))))
}

#[track_caller]
fn assert_same(what: &str, emitted: &[f64], by_hand: &[f64]) {
    let largest = emitted.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    for (a, b) in emitted.iter().zip(by_hand) {
        assert!((a - b).abs() <= TOLERANCE * largest, "{what}: {emitted:?} emitted, {by_hand:?} by hand");
    }
}

macro_rules! assert_agreement {
    ($robot:ident, $standard:ident, $fast:ident) => {
        let chain = Chain::new(&$robot::JOINTS, 9.81);
        let (standard, fast) = ($robot::$standard::default(), $robot::$fast::default());
        for [q, v, a] in states() {
            let by_hand = chain.accelerations::<Platform>(&q, &v);
            assert_same("accelerations", &standard.acceleration(0.0, &q, &v), &by_hand);
            let by_hand = chain.accelerations::<Inline>(&q, &v);
            assert_same("fast accelerations", &fast.acceleration(0.0, &q, &v), &by_hand);
            let by_hand = chain.inverse_dynamics::<Platform>(&q, &v, &a);
            assert_same("inverse dynamics", &standard.inverse_dynamics(0.0, &q, &v, &a), &by_hand);
            let by_hand = chain.mass_matrix::<Platform>(&q);
            assert_same("mass matrix", standard.mass_matrix(0.0, &q).as_flattened(), by_hand.as_flattened());
        }
    };
}

#[test]
fn arms_move_alike() {
    assert_agreement!(ur5, Ur5, FastUr5);
    assert_agreement!(panda, Panda, FastPanda);
}

#[test]
fn chains_of_universal_joints_move_alike() {
    assert_agreement!(universal_5, Universal5, FastUniversal5);
    assert_agreement!(universal_10, Universal10, FastUniversal10);
}
