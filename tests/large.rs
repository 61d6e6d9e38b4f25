//! Chains of a hundred links compile, and compute what the interpreter computes.
//!
//! `RUSTFLAGS="--cfg large" cargo test -p lagrange-tests --test large` does the same for two
//! hundred.

#[macro_use]
#[path = "../benches/chains/declared.rs"]
mod declared;

use std::array::from_fn;

use lagrange::system::MechanicalSystem;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};

absolute!(absolute_100, 100);
relative!(relative_100, 100);
#[cfg(large)]
absolute!(absolute_200, 200);
#[cfg(large)]
relative!(relative_200, 200);

const ABSOLUTE: &str = include_str!("../benches/chains/absolute.lag");
const RELATIVE: &str = include_str!("../benches/chains/relative.lag");
const GRAVITY: f64 = 9.81;
/// Bounds the effect of fused multiply-adds, relative to the largest acceleration.
const ROUNDED: f64 = 1e-9;

/// Returns the numbers of a chain in some configuration.
fn spread<const N: usize>(from: f64, step: f64) -> [f64; N] {
    from_fn(|k| from + step * k as f64)
}

/// Returns the interpreter's results for a declaration.
fn interpreted<const N: usize>(
    declaration: &str,
    m: &[f64; N],
    l: &[f64; N],
    q: &[f64; N],
    v: &[f64; N],
) -> Vec<f64> {
    let values = format!("const g = {GRAVITY}, n = {N}; const m[n] = {m:?}, l[n] = {l:?};");
    let (_, statements) = declaration.split_once("coord").expect("coordinates");
    let system = parse(&format!("{values} coord{statements}")).unwrap_or_else(|report| panic!("{report}"));
    let derived = system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"));
    NumericSystem::new(&derived).acceleration(0.0, q, v)
}

fn assert_agrees<const N: usize, S>(declaration: &str, chain: fn(&[f64; N], &[f64; N], f64) -> S)
where
    S: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let (m, l) = (spread(1.0, 0.01), spread(0.8, 0.005));
    let (q, v) = (spread(0.3, 0.017), spread(-0.5, 0.023));
    let compiled = chain(&m, &l, GRAVITY).acceleration(0.0, &q, &v);
    let interpreted = interpreted(declaration, &m, &l, &q, &v);
    let largest = interpreted.iter().fold(0.0, |largest: f64, a| largest.max(a.abs()));
    assert!(largest > 1.0 && largest.is_finite(), "{largest}");
    for (a, b) in compiled.iter().zip(&interpreted) {
        assert!((a - b).abs() <= ROUNDED * largest, "{a} is not {b}");
    }
}

#[test]
fn a_hundred_links_in_absolute_angles() {
    assert_agrees(ABSOLUTE, absolute_100::chain);
}

#[test]
fn a_hundred_links_in_relative_angles() {
    assert_agrees(RELATIVE, relative_100::chain);
}

#[cfg(large)]
#[test]
fn two_hundred_links_in_absolute_angles() {
    assert_agrees(ABSOLUTE, absolute_200::chain);
}

#[cfg(large)]
#[test]
fn two_hundred_links_in_relative_angles() {
    assert_agrees(RELATIVE, relative_200::chain);
}
