//! Rates along a motion, and conserved quantities.

use lagrange_core::pipeline::NumericSystem;

/// Relative error of a difference quotient of order four with steps of [`STEP`].
const DIFFERENCE_TOLERANCE: f64 = 1e-9;
const STEP: f64 = 1.0 / 4096.0;

pub(crate) fn assert_near(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let largest = expected.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * largest, "{what}: {found:?}, not {expected:?}");
    }
}

/// Returns the rate of a function of the state along the motion. It has the fourth order, by
/// Richardson extrapolation of central differences between Runge–Kutta steps to either side.
fn rates(system: &NumericSystem, q: &[f64], v: &[f64], f: impl Fn(&[f64], &[f64]) -> Vec<f64>) -> Vec<f64> {
    let start = [q, v].concat();
    let at = |s: f64| {
        let y = stepped(system, &start, s);
        f(&y[..q.len()], &y[q.len()..])
    };
    let quotient = |s: f64| {
        let (after, before) = (at(s), at(-s));
        after.iter().zip(before).map(|(after, before)| (after - before) / (2.0 * s)).collect::<Vec<_>>()
    };
    let (coarse, fine) = (quotient(STEP), quotient(0.5 * STEP));
    fine.iter().zip(coarse).map(|(fine, coarse)| fine + (fine - coarse) / 3.0).collect()
}

/// Returns the state after a step.
fn stepped(system: &NumericSystem, y: &[f64], step: f64) -> Vec<f64> {
    let moved =
        |rate: &[f64], part: f64| y.iter().zip(rate).map(|(y, rate)| y + part * step * rate).collect();
    let rate = |y: Vec<f64>| system.rhs(0.0, &y);
    let first = rate(y.to_vec());
    let second = rate(moved(&first, 0.5));
    let third = rate(moved(&second, 0.5));
    let fourth = rate(moved(&third, 1.0));
    let mean = (0..y.len()).map(|k| (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]) / 6.0);
    moved(&mean.collect::<Vec<_>>(), 1.0)
}

/// Asserts that a function of the state is conserved, relative to the magnitude of its parts.
pub(crate) fn assert_constant(
    system: &NumericSystem,
    state: [&[f64]; 2],
    f: impl Fn(&[f64], &[f64]) -> Vec<f64>,
    what: &str,
) {
    let [q, v] = state;
    let size = f(q, v).iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
    let rates = rates(system, q, v, f);
    assert!(
        rates.iter().all(|rate| rate.abs() <= DIFFERENCE_TOLERANCE * size),
        "{what}: {rates:?} of {size}"
    );
}
