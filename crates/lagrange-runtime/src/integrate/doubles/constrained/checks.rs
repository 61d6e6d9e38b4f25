//! Common checks of methods for these systems.

use std::vec::Vec;

use crate::integrate::doubles::canonical::checks::{canonical, derivative, distance, reached};
use crate::integrate::{Method, Verner98};
use crate::run::integrate;
use crate::system::{CanonicalSystem, OdeSystem, split};

/// Checks that halving steps divides the error by two to the order of the method, within a tenth of
/// the order.
pub(crate) fn check_order<M, K>(system: &M, start: M::State, end: f64, steps: u32, method: impl Fn(f64) -> K)
where
    M: OdeSystem<Scalar = f64>,
    K: Method<M>,
{
    let reference = reached(system, 0.0, start, end, &Verner98::tolerance(1e-13));
    let error = |steps| {
        let end = reached(system, 0.0, start, end, &method(end / f64::from(steps)));
        distance(end.as_ref(), reference.as_ref())
    };
    let (coarse, fine, order) = (error(steps), error(2 * steps), method(1.0).order());
    let observed = (coarse / fine).log2();
    assert!((observed - f64::from(order)).abs() < 0.1, "{observed}: {coarse:e}, {fine:e}");
}

/// Returns the largest residuals of constraints during a motion: of positions and of velocities.
pub(crate) fn residuals<M, K>(system: &M, start: M::State, end: f64, method: &K) -> [f64; 2]
where
    M: CanonicalSystem<Scalar = f64>,
    K: Method<M>,
{
    let mut largest = [0.0_f64; 2];
    let size = |residuals: &M::Coordinates| residuals.as_ref().iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    integrate(system, 0.0, start, end, method, |t, y| {
        let (q, v) = split::<M>(y);
        let values = system.constraint_values(t, &q, &v);
        largest = [largest[0].max(size(&values.positions)), largest[1].max(size(&values.velocities))];
    })
    .expect("converges");
    largest
}

/// Returns the difference between a state and the result of a motion forwards and back.
pub(crate) fn defect_of_symmetry<M, K>(system: &M, start: M::State, end: f64, method: &K) -> f64
where
    M: OdeSystem<Scalar = f64>,
    K: Method<M>,
{
    let there = reached(system, 0.0, start, end, method);
    assert!(distance(there.as_ref(), start.as_ref()) > 0.1);
    let back = reached(system, end, there, 0.0, method);
    distance(back.as_ref(), start.as_ref())
}

/// Returns the change of the symplectic form of coordinates and momenta in one step. The form is
/// evaluated for changes of the N numbers from which `chart` creates states on the constraints.
pub(crate) fn defect_of_symplecticity<M, K, const N: usize>(
    system: &M,
    chart: impl Fn([f64; N]) -> M::State,
    at: [f64; N],
    step: f64,
    method: &K,
) -> f64
where
    M: CanonicalSystem<Scalar = f64>,
    K: Method<M>,
{
    let moved = |place: usize, by: f64| {
        let mut numbers = at;
        numbers[place] += by;
        chart(numbers)
    };
    let before = |place| derivative(|by| canonical(system, 0.0, &moved(place, by)));
    let after = |place| {
        derivative(|by| canonical(system, step, &reached(system, 0.0, moved(place, by), step, method)))
    };
    let (before, after): (Vec<_>, Vec<_>) = (0..N).map(|place| (before(place), after(place))).unzip();
    let form = |a: &[f64], b: &[f64]| -> f64 {
        let half = a.len() / 2;
        (0..half).map(|i| a[i] * b[half + i] - a[half + i] * b[i]).sum()
    };
    let mut defect = 0.0_f64;
    for i in 0..N {
        for j in 0..i {
            defect = defect.max((form(&after[i], &after[j]) - form(&before[i], &before[j])).abs());
        }
    }
    defect
}
