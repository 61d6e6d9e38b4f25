//! Errors at the end of steps and within them.

use super::{DRIVEN, Force, HENON_HEILES, KEPLER, PENDULUM, difference, run};
use crate::integrate::{BlanesMoan4, Method, RungeKutta4, Stepper, StormerVerlet, SymplecticEuler};
use crate::system::OdeSystem;

/// A motion with its end, and the numbers of steps that reveal the order of a method of high and of
/// low order.
struct Case<M: OdeSystem> {
    system: M,
    start: M::State,
    end: f64,
    reached: M::State,
    steps: u32,
}

fn pendulum() -> Case<Force<f64, 1, 2>> {
    let fine = run(&PENDULUM, [1.5, 0.0], 6.0, &RungeKutta4 { step: 1e-3 });
    Case { system: PENDULUM, start: [1.5, 0.0], end: 6.0, reached: fine, steps: 40 }
}

fn driven() -> Case<Force<f64, 1, 2>> {
    let end = 4.0_f64;
    let reached = [(end.cos() - (2.0 * end).cos()) / 3.0, (2.0 * (2.0 * end).sin() - end.sin()) / 3.0];
    Case { system: DRIVEN, start: [0.0, 0.0], end, reached, steps: 40 }
}

/// Returns an orbit of eccentricity 0.3 from the nearest point: after half a period the planet is
/// at the farthest point.
fn kepler() -> Case<Force<f64, 2, 4>> {
    let (near, far) = (0.7_f64, 1.3_f64);
    let start = [near, 0.0, 0.0, (far / near).sqrt()];
    let reached = [-far, 0.0, 0.0, -(near / far).sqrt()];
    Case { system: KEPLER, start, end: core::f64::consts::PI, reached, steps: 160 }
}

fn henon_heiles() -> Case<Force<f64, 2, 4>> {
    let start = [0.1, 0.2, 0.3, -0.1];
    let fine = run(&HENON_HEILES, start, 8.0, &RungeKutta4 { step: 1e-3 });
    Case { system: HENON_HEILES, start, end: 8.0, reached: fine, steps: 40 }
}

/// Returns log₂ of the ratio of errors when steps are halved.
fn observed<M, K, const N: usize>(case: &Case<M>, finer: u32, method: fn(f64) -> K) -> f64
where
    M: OdeSystem<Scalar = f64, State = [f64; N]>,
    K: Method<M>,
{
    let error = |steps: u32| {
        let end = run(&case.system, case.start, case.end, &method(case.end / f64::from(steps)));
        difference(&end, &case.reached)
    };
    (error(finer * case.steps) / error(2 * finer * case.steps)).log2()
}

/// Tests one method on every system; `finer` multiplies the steps.
macro_rules! order_is {
    ($name:ident, $method:ident, $order:literal, $finer:literal) => {
        #[test]
        fn $name() {
            let method = |step| $method { step };
            let orders = [
                observed(&pendulum(), $finer, method),
                observed(&driven(), $finer, method),
                observed(&kepler(), $finer, method),
                observed(&henon_heiles(), $finer, method),
            ];
            for order in orders {
                assert!((order - $order).abs() < 0.1, "{orders:?}");
            }
        }
    };
}

order_is!(symplectic_euler_is_of_order_one, SymplecticEuler, 1.0, 16);
order_is!(stormer_verlet_is_of_order_two, StormerVerlet, 2.0, 2);
order_is!(blanes_moan_is_of_order_four, BlanesMoan4, 4.0, 1);
order_is!(runge_kutta_is_of_order_four, RungeKutta4, 4.0, 4);

#[test]
fn methods_of_one_step_and_order_name_the_order_that_is_observed() {
    fn order<K: Method<Force<f64, 1, 2>>>(method: &K) -> u32 {
        method.order()
    }
    let step = 0.1;
    assert_eq!(order(&SymplecticEuler { step }), 1);
    assert_eq!(order(&StormerVerlet { step }), 2);
    assert_eq!(order(&BlanesMoan4 { step }), 4);
    assert_eq!(order(&RungeKutta4 { step }), 4);
}

#[test]
fn blanes_moan_is_far_more_accurate_than_runge_kutta_at_equal_cost() {
    let case = henon_heiles();
    let composed = run(&case.system, case.start, case.end, &BlanesMoan4 { step: 0.3 });
    let classical = run(&case.system, case.start, case.end, &RungeKutta4 { step: 0.2 });
    let (composed, classical) = (difference(&composed, &case.reached), difference(&classical, &case.reached));
    assert!(composed < classical / 50.0, "{composed:e} and {classical:e}");
}

/// Returns the largest errors of coordinates and of velocities within the first step from rest at
/// (1, 0). They are relative to the computed end of the step.
fn within<K: Method<Force<f64, 1, 2>>>(method: &K, step: f64) -> [f64; 2] {
    let oscillator = super::OSCILLATOR;
    let mut stepper = method.start(&oscillator, 0.0, &[1.0, 0.0], step).expect("valid");
    stepper.step(&oscillator, step).expect("stable");
    let end = *stepper.state();
    let drift = [end[0] - step.cos(), end[1] + step.sin()];
    let mut largest = [0.0_f64; 2];
    for k in 0..=16 {
        let t = step * f64::from(k) / 16.0;
        let y = stepper.interpolate(&oscillator, t);
        // The error of the step itself is not attributed to the interpolation.
        let exact = [t.cos() + drift[0] * t / step, -t.sin() + drift[1] * t / step];
        largest = core::array::from_fn(|i| largest[i].max((y[i] - exact[i]).abs()));
    }
    largest
}

#[test]
fn states_within_a_step_are_of_matching_order() {
    let [coarse, fine] = [0.4, 0.2].map(|step| within(&BlanesMoan4 { step }, step));
    let orders: [f64; 2] = core::array::from_fn(|i| (coarse[i] / fine[i]).log2());
    assert!(orders.iter().all(|order| *order > 4.8), "{orders:?} of {coarse:?}");
    let [coarse, fine] = [0.4, 0.2].map(|step| within(&RungeKutta4 { step }, step));
    let orders: [f64; 2] = core::array::from_fn(|i| (coarse[i] / fine[i]).log2());
    assert!(orders.iter().all(|order| *order > 3.8), "{orders:?} of {coarse:?}");
}

#[test]
fn states_within_short_steps_lose_no_digits() {
    let [position, velocity] = within(&BlanesMoan4 { step: 1e-5 }, 1e-5);
    assert!(position < 4e-16 && velocity < 4e-16, "{position:e} {velocity:e}");
}

#[test]
fn interpolation_meets_both_ends_of_the_last_step() {
    let method = StormerVerlet { step: 0.1 };
    let mut stepper = method.start(&PENDULUM, 0.0, &[1.0, 0.5], 10.0).expect("valid");
    stepper.step(&PENDULUM, 10.0).expect("stable");
    let between = *stepper.state();
    stepper.step(&PENDULUM, 10.0).expect("stable");
    assert_eq!(stepper.interpolate(&PENDULUM, stepper.last_time()), between);
    assert_eq!(stepper.interpolate(&PENDULUM, stepper.time()), *stepper.state());
    let nearly = stepper.interpolate(&PENDULUM, stepper.time() - 1e-14);
    assert!(difference(&nearly, stepper.state()) < 1e-13);
}

#[test]
fn one_step_costs_what_is_promised() {
    fn evaluations<K: Method<Force<f64, 1, 2>>>(method: &K) -> u64 {
        let mut stepper = method.start(&PENDULUM, 0.0, &[1.0, 0.5], 10.0).expect("valid");
        stepper.step(&PENDULUM, 10.0).expect("stable");
        let first = stepper.work().evaluations;
        for _ in 0..10 {
            stepper.step(&PENDULUM, 10.0).expect("stable");
        }
        assert_eq!(stepper.work().steps, 11);
        (stepper.work().evaluations - first) / 10
    }
    let step = 0.1;
    assert_eq!(evaluations(&SymplecticEuler { step }), 1);
    assert_eq!(evaluations(&StormerVerlet { step }), 1);
    assert_eq!(evaluations(&BlanesMoan4 { step }), 6);
    assert_eq!(evaluations(&RungeKutta4 { step }), 4);
}
