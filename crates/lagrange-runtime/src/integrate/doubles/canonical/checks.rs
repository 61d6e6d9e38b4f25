//! Common checks of methods for these systems.

use std::vec::Vec;

use crate::integrate::{GaussLegendre6, Method};
use crate::linalg::pivoted::{Factors, Matrix};
use crate::run::integrate;
use crate::system::{CanonicalSystem, MechanicalSystem, OdeSystem, StateVector, join, split};

/// Returns the largest difference between components of two states.
pub(crate) fn distance(one: &[f64], other: &[f64]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).fold(0.0, |largest, (a, b)| largest.max((a - b).abs()))
}

/// Returns the final state of a method, which must not fail.
pub(crate) fn reached<M, K>(system: &M, t: f64, start: M::State, end: f64, method: &K) -> M::State
where
    M: OdeSystem<Scalar = f64>,
    K: Method<M>,
{
    integrate(system, t, start, end, method, |_, _| {}).expect("converges")
}

/// Checks that halving steps divides the error by two to the order of the method, within a tenth of
/// the order.
pub(crate) fn check_order<M, K>(system: &M, start: M::State, end: f64, steps: u32, method: impl Fn(f64) -> K)
where
    M: CanonicalSystem<Scalar = f64>,
    K: Method<M>,
{
    let reference = reached(system, 0.0, start, end, &GaussLegendre6 { step: end / 2000.0 });
    let error = |steps| {
        let end = reached(system, 0.0, start, end, &method(end / f64::from(steps)));
        distance(end.as_ref(), reference.as_ref())
    };
    let (coarse, fine, order) = (error(steps), error(2 * steps), method(1.0).order());
    let observed = (coarse / fine).log2();
    assert!((observed - f64::from(order)).abs() < 0.1, "{observed}: {coarse:e}, {fine:e}");
}

/// Returns coordinates and momenta of a state.
pub(crate) fn canonical<M: CanonicalSystem>(system: &M, t: M::Scalar, y: &M::State) -> M::State {
    let (q, v) = split::<M>(y);
    join::<M>(&q, &system.momenta(t, &q, &v))
}

/// Returns the largest entry of JᵀΩJ − Ω for the derivative J of one step in coordinates and
/// momenta.
///
/// J is computed by differences of fourth order. Their errors are below 1e-9 if the step resolves
/// the motion.
pub(crate) fn defect_of_symplecticity<M, K>(system: &M, start: M::State, step: f64, method: &K) -> f64
where
    M: CanonicalSystem<Scalar = f64>,
    K: Method<M>,
{
    let middle = canonical(system, 0.0, &start);
    let map = |place: usize, shift: f64| {
        let mut variables = middle;
        variables.as_mut()[place] += shift;
        let end = reached(system, 0.0, natural_state(system, &variables), step, method);
        canonical(system, step, &end)
    };
    let size = middle.as_ref().len();
    let columns: Vec<Vec<f64>> = (0..size).map(|place| derivative(|shift| map(place, shift))).collect();
    let product = |a: &[f64], b: &[f64]| -> f64 {
        (0..size / 2).map(|i| a[i] * b[size / 2 + i] - a[size / 2 + i] * b[i]).sum()
    };
    let mut defect = 0.0_f64;
    for i in 0..size {
        for j in 0..size {
            let expected =
                if j == i + size / 2 { 1.0 } else { 0.0 } - if i == j + size / 2 { 1.0 } else { 0.0 };
            defect = defect.max((product(&columns[i], &columns[j]) - expected).abs());
        }
    }
    defect
}

/// Computes the derivative at zero.
pub(crate) fn derivative<Y: StateVector<f64>>(f: impl Fn(f64) -> Y) -> Vec<f64> {
    let h = 1e-3;
    let [a, b, c, d] = [f(-2.0 * h), f(-h), f(h), f(2.0 * h)];
    let entry = |y: &Y, i: usize| y.as_ref()[i];
    (0..a.as_ref().len())
        .map(|i| (entry(&a, i) - entry(&d, i) + 8.0 * (entry(&c, i) - entry(&b, i))) / (12.0 * h))
        .collect()
}

/// Returns the state of coordinates and momenta if momenta are the mass matrix times velocities.
fn natural_state<M: CanonicalSystem<Scalar = f64>>(system: &M, variables: &M::State) -> M::State {
    let (q, p) = split::<M>(variables);
    let mass = system.mass_matrix(0.0, &q, &<M as MechanicalSystem>::Coordinates::ZERO);
    join::<M>(&q, &Factors::new(Matrix(mass)).expect("regular").solve(&p))
}
