//! Structure that the methods preserve.

use super::{DRIVEN, Force, HENON_HEILES, KEPLER, PENDULUM, difference, run};
use crate::integrate::{BlanesMoan4, Method, RungeKutta4, StormerVerlet, SymplecticEuler};
use crate::run::integrate;

/// The system of Hénon and Heiles with a time-dependent force, and the linear equations of
/// neighbouring motions. A composition of kicks and drifts treats both in the same way, so
/// neighbours follow the derivative of its step.
const NEIGHBOURS: Force<f64, 4, 8> = Force {
    acceleration: |t, [x, y, dx, dy]| {
        let [ax, ay] = (HENON_HEILES.acceleration)(t, &[*x, *y]);
        let along = -dx - 2.0 * (x * dy + y * dx);
        [ax + (3.0 * t).sin(), ay, along, -dy - 2.0 * (x * dx - y * dy)]
    },
};

/// Returns the image of (δq, δv).
fn neighbour<K: Method<Force<f64, 4, 8>>>(method: &K, [dx, dy, du, dv]: [f64; 4]) -> [f64; 4] {
    let end = run(&NEIGHBOURS, [0.3, -0.2, dx, dy, 0.1, 0.25, du, dv], 2.0, method);
    [end[2], end[3], end[6], end[7]]
}

/// Returns the violation of the conservation of Σ dq ∧ dv by the derivative over two seconds.
fn defect<K: Method<Force<f64, 4, 8>>>(method: &K) -> f64 {
    let form = |a: &[f64; 4], b: &[f64; 4]| a[0] * b[2] - a[2] * b[0] + a[1] * b[3] - a[3] * b[1];
    let basis: [[f64; 4]; 4] = core::array::from_fn(|i| core::array::from_fn(|j| f64::from(i == j)));
    let images = basis.map(|start| neighbour(method, start));
    let mut largest = 0.0_f64;
    for i in 0..4 {
        for j in 0..4 {
            largest = largest.max((form(&images[i], &images[j]) - form(&basis[i], &basis[j])).abs());
        }
    }
    largest
}

#[test]
fn the_symplectic_form_is_kept() {
    let step = 0.2;
    let defects =
        [defect(&SymplecticEuler { step }), defect(&StormerVerlet { step }), defect(&BlanesMoan4 { step })];
    assert!(defects.iter().all(|defect| *defect < 1e-14), "{defects:?}");
    assert!(defect(&RungeKutta4 { step }) > 1e-7, "the test sees a method that is not symplectic");
}

#[test]
fn symmetric_methods_return_to_the_start() {
    fn distance<K: Method<Force<f64, 1, 2>>>(method: &K) -> f64 {
        let start = [0.3, -1.2];
        let there = integrate(&DRIVEN, 1.0, start, 9.0, method, |_, _| {}).expect("finite");
        let back = integrate(&DRIVEN, 9.0, there, 1.0, method, |_, _| {}).expect("finite");
        difference(&back, &start)
    }
    assert!(distance(&StormerVerlet { step: 0.125 }) < 1e-14);
    assert!(distance(&BlanesMoan4 { step: 0.25 }) < 1e-14);
    assert!(
        distance(&SymplecticEuler { step: 0.125 }) > 1e-2,
        "the test sees a method that is not symmetric"
    );
}

#[test]
fn turned_velocities_lead_back() {
    for start in [[0.3, -1.2], [2.5, 0.1]] {
        let [angle, rate] = run(&PENDULUM, start, 20.0, &StormerVerlet { step: 0.02 });
        let [angle, rate] = run(&PENDULUM, [angle, -rate], 20.0, &StormerVerlet { step: 0.02 });
        assert!(difference(&[angle, -rate], &start) < 1e-12);
    }
}

#[test]
fn angular_momentum_is_kept_to_rounding() {
    fn change<K: Method<Force<f64, 2, 4>>>(method: &K) -> f64 {
        let start = [0.4, 0.0, 0.0, 2.0];
        let momentum = |[x, y, u, v]: &[f64; 4]| x * v - y * u;
        let mut largest = 0.0_f64;
        let watch = |_, y: &[f64; 4]| largest = largest.max((momentum(y) - momentum(&start)).abs());
        integrate(&KEPLER, 0.0, start, 60.0, method, watch).expect("finite");
        largest
    }
    let step = 5e-3;
    let changes =
        [change(&SymplecticEuler { step }), change(&StormerVerlet { step }), change(&BlanesMoan4 { step })];
    assert!(changes.iter().all(|change| *change < 2e-15), "{changes:?}");
    assert!(change(&RungeKutta4 { step }) > 1e-12, "the test sees a method that does not keep it");
}

#[test]
fn rounding_errors_do_not_grow_with_the_number_of_steps() {
    let falling: Force<f32, 1, 2> = Force { acceleration: |_, _| [0.5] };
    let method = StormerVerlet { step: 1e-4 };
    let [height, speed] = integrate(&falling, 0.0, [0.0, 0.0], 20.0, &method, |_, _| {}).expect("finite");
    assert!((height - 100.0).abs() <= 8.0 * f32::EPSILON * 100.0, "{height}");
    assert!((speed - 10.0).abs() <= 4.0 * f32::EPSILON * 10.0, "{speed}");
}

#[test]
fn single_precision_follows_double_precision() {
    let single: Force<f32, 1, 2> = Force { acceleration: |_, [x]| [-x.sin()] };
    let method = BlanesMoan4 { step: 0.05 };
    let end = integrate(&single, 0.0, [1.0, 0.0], 20.0, &method, |_, _| {}).expect("finite");
    let exact = run(&PENDULUM, [1.0, 0.0], 20.0, &BlanesMoan4 { step: 0.05 });
    assert!(difference(&end.map(f64::from), &exact) < 5e-6);
}
