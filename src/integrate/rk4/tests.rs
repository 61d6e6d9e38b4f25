//! The method on hand-written systems whose solutions are known.

use std::string::ToString;
use std::vec::Vec;

use super::{rk4, rk4_step};
use crate::integrate::IntegrationError;
use crate::scalar::Scalar;
use crate::system::OdeSystem;

/// ẍ = −x with solution (cos t, −sin t) from (1, 0).
struct Oscillator;

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -x]
    }
}

/// ẏ = f(t): an integral.
struct Integral<S>(fn(S) -> S);

impl<S: Scalar> OdeSystem for Integral<S> {
    type Scalar = S;
    type State = [S; 1];

    fn rhs(&self, t: S, _y: &[S; 1]) -> [S; 1] {
        [(self.0)(t)]
    }
}

/// ẏ = y² with solution 1/(1 − t) from 1, which no number represents from t = 1 on.
struct BlowUp;

impl OdeSystem for BlowUp {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, y: &[f64; 1]) -> [f64; 1] {
        [y[0] * y[0]]
    }
}

fn oscillator_error(steps: usize) -> f64 {
    let end = 3.0_f64;
    let [x, v] = rk4(&Oscillator, 0.0, [1.0, 0.0], end, steps, |_, _| {}).expect("finite");
    (x - end.cos()).hypot(v + end.sin())
}

#[test]
fn the_order_is_four() {
    for steps in [20, 40, 80, 160] {
        let order = (oscillator_error(steps) / oscillator_error(2 * steps)).log2();
        assert!((order - 4.0).abs() < 0.1, "{order} at {steps} steps");
    }
}

#[test]
fn one_step_of_a_linear_system_is_its_taylor_polynomial() {
    let h = 0.25;
    let [x, v] = rk4_step(&Oscillator, 0.0, &[1.0, 0.0], h);
    assert!((x - (1.0 - h.powi(2) / 2.0 + h.powi(4) / 24.0)).abs() < 1e-15);
    assert!((v + (h - h.powi(3) / 6.0)).abs() < 1e-15);
}

#[test]
fn cubics_in_time_are_integrated_exactly() {
    let cubic = Integral(|t: f64| 4.0 * t * t * t - 6.0 * t);
    assert_eq!(rk4(&cubic, 0.0, [1.0], 2.0, 1, |_, _| {}), Ok([5.0]));
    assert_eq!(rk4(&cubic, 0.0, [1.0], 2.0, 8, |_, _| {}), Ok([5.0]));
}

#[test]
fn rounding_errors_do_not_grow_with_the_number_of_steps() {
    let steps = 1_000_000;
    let rate = Integral(|_: f32| 0.1);
    let [end] = rk4(&rate, 0.0, [0.0], 100.0, steps, |_, _| {}).expect("finite");
    assert!((end - 10.0).abs() <= 4.0 * f32::EPSILON * 10.0, "{end}");
}

#[test]
fn backward_time_returns_to_the_start() {
    let start = [0.3, -1.2];
    let there = rk4(&Oscillator, 1.0, start, 4.0, 2000, |_, _| {}).expect("finite");
    let back = rk4(&Oscillator, 4.0, there, 1.0, 2000, |_, _| {}).expect("finite");
    assert!((back[0] - start[0]).abs() < 1e-13 && (back[1] - start[1]).abs() < 1e-13, "{back:?}");
}

#[test]
fn times_are_fractions_of_the_span_and_end_exactly() {
    let mut times = Vec::new();
    let outcome = rk4(&Oscillator, 0.0, [1.0, 0.0], 0.7, 7, |t, _| times.push(t));
    assert!(outcome.is_ok());
    let wanted: Vec<f64> = (0..=7).map(|k| f64::from(k) * 0.7 / 7.0).collect();
    assert_eq!(times[..7], wanted[..7]);
    assert_eq!(times[7..], [0.7]);
}

#[test]
fn the_last_observation_is_the_result() {
    let mut last = None;
    let end = rk4(&Oscillator, 0.0, [1.0, 0.0], 5.0, 50, |_, y| last = Some(*y));
    assert_eq!(end.ok(), last);
}

#[test]
fn nan_stops_at_the_last_good_state() {
    let root = Integral(|t: f64| (1.0 - t).sqrt());
    let mut good = Vec::new();
    let outcome = rk4(&root, 0.0, [0.0], 2.0, 16, |t, y| good.push((t, *y)));
    let (time, state) = good[good.len() - 1];
    assert_eq!(outcome, Err(IntegrationError::NotFinite { time, state }));
    assert_eq!(time, 1.0);
    assert!((state[0] - 2.0 / 3.0).abs() < 1e-2);
}

#[test]
fn overflow_stops_as_well() {
    let outcome = rk4(&BlowUp, 0.0, [1.0], 2.0, 100, |_, y| assert!(y[0].is_finite()));
    let Err(error @ IntegrationError::NotFinite { time, state }) = outcome else {
        panic!("{outcome:?}");
    };
    assert!((1.0..1.2).contains(&time) && state[0].is_finite());
    assert!(error.to_string().ends_with(&std::format!("in the step from time {time:?}")), "{error}");
}

#[test]
fn an_initial_state_that_is_not_finite_is_refused() {
    let outcome = rk4(&Oscillator, 3.0, [f64::INFINITY, 0.0], 3.0, 0, |_, _| panic!("observed"));
    assert_eq!(outcome, Err(IntegrationError::NotFinite { time: 3.0, state: [f64::INFINITY, 0.0] }));
}

#[test]
fn spans_without_length_or_steps() {
    let start = [0.3, -1.2];
    for steps in [0, 1, 3] {
        let mut observations = 0;
        let outcome = rk4(&Oscillator, 2.0, start, 2.0, steps, |t, _| {
            assert_eq!(t, 2.0);
            observations += 1;
        });
        assert_eq!(outcome, Ok(start));
        assert_eq!(observations, steps + 1);
    }
    assert_eq!(rk4(&Oscillator, 2.0, start, 3.0, 0, |_, _| {}), Err(IntegrationError::NoSteps));
    for end in [f64::NAN, f64::INFINITY] {
        assert!(rk4(&Oscillator, 2.0, start, end, 5, |_, _| {}).is_err());
    }
}

#[test]
fn systems_behind_a_pointer_to_a_trait_are_taken() {
    let system: &dyn OdeSystem<Scalar = f64, State = [f64; 2]> = &Oscillator;
    assert_eq!(rk4_step(system, 0.0, &[1.0, 0.0], 0.1), rk4_step(&Oscillator, 0.0, &[1.0, 0.0], 0.1));
}
