//! What a motion changes, and what it keeps.

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

/// The rate of a function of the state along the motion: to the fourth order by Richardson's extrapolation of central differences
/// along q + v s + a s²/2.
fn rates(system: &NumericSystem, q: &[f64], v: &[f64], f: impl Fn(&[f64], &[f64]) -> Vec<f64>) -> Vec<f64> {
    let a = system.acceleration(0.0, q, v);
    let at = |s: f64| {
        let place = (0..q.len()).map(|k| q[k] + s * v[k] + 0.5 * s * s * a[k]).collect::<Vec<_>>();
        let velocity = (0..q.len()).map(|k| v[k] + s * a[k]).collect::<Vec<_>>();
        f(&place, &velocity)
    };
    let quotient = |s: f64| {
        let (after, before) = (at(s), at(-s));
        after.iter().zip(before).map(|(after, before)| (after - before) / (2.0 * s)).collect::<Vec<_>>()
    };
    let (coarse, fine) = (quotient(STEP), quotient(0.5 * STEP));
    fine.iter().zip(coarse).map(|(fine, coarse)| fine + (fine - coarse) / 3.0).collect()
}

/// A function of the state does not change, compared with the size of what is between its parts.
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
