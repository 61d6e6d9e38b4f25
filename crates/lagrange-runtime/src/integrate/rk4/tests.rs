//! The method on hand-written systems with known solutions.

use std::string::ToString;
use std::vec::Vec;

use super::{RungeKutta4, rk4_step};
use crate::integrate::{IntegrationError, Method, Stepper};
use crate::run::integrate;
use crate::scalar::Scalar;
use crate::system::{Component, OdeSystem, StepFailure, Undefined};

/// ẍ = −x with solution (cos t, −sin t) from (1, 0).
struct Oscillator;

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -x]
    }
}

/// ẏ = f(t), an integral.
struct Integral<S>(fn(S) -> S);

impl<S: Scalar> OdeSystem for Integral<S> {
    type Scalar = S;
    type State = [S; 1];

    fn rhs(&self, t: S, _y: &[S; 1]) -> [S; 1] {
        [(self.0)(t)]
    }
}

/// ẏ = y² with solution 1/(1 − t) from 1, which is not representable from t = 1 on.
struct BlowUp;

impl OdeSystem for BlowUp {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, y: &[f64; 1]) -> [f64; 1] {
        [y[0] * y[0]]
    }
}

type Outcome<S, Y> = Result<Y, IntegrationError<S, Y>>;

/// Integrates without observing states between start and end.
fn rk4<M: OdeSystem>(
    system: &M,
    t0: M::Scalar,
    y0: M::State,
    end: M::Scalar,
    step: M::Scalar,
) -> Outcome<M::Scalar, M::State> {
    integrate(system, t0, y0, end, &RungeKutta4 { step }, |_, _| {})
}

fn oscillator_error(steps: u32) -> f64 {
    let end = 3.0_f64;
    let [x, v] = rk4(&Oscillator, 0.0, [1.0, 0.0], end, end / f64::from(steps)).expect("finite");
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
    assert_eq!(rk4(&cubic, 0.0, [1.0], 2.0, 2.0), Ok([5.0]));
    assert_eq!(rk4(&cubic, 0.0, [1.0], 2.0, 0.25), Ok([5.0]));
}

#[test]
fn rounding_errors_do_not_grow_with_the_number_of_steps() {
    let rate = Integral(|_: f32| 0.1);
    let [end] = rk4(&rate, 0.0, [0.0], 100.0, 1e-4).expect("finite");
    assert!((end - 10.0).abs() <= 4.0 * f32::EPSILON * 10.0, "{end}");
}

#[test]
fn backward_time_returns_to_the_start() {
    let start = [0.3, -1.2];
    let there = rk4(&Oscillator, 1.0, start, 4.0, 1.5e-3).expect("finite");
    let back = rk4(&Oscillator, 4.0, there, 1.0, 1.5e-3).expect("finite");
    assert!((back[0] - start[0]).abs() < 1e-13 && (back[1] - start[1]).abs() < 1e-13, "{back:?}");
}

#[test]
fn times_are_multiples_of_the_step_and_end_exactly() {
    let mut times = Vec::new();
    let method = RungeKutta4 { step: 0.1 };
    let outcome = integrate(&Oscillator, 0.0, [1.0, 0.0], 0.75, &method, |t, _| times.push(t));
    assert!(outcome.is_ok());
    let wanted: Vec<f64> = (0..=7).map(|k| f64::from(k) * 0.1).collect();
    let [multiples @ .., end] = &times[..] else { panic!("nothing was observed") };
    assert_eq!(multiples.len(), wanted.len());
    for (time, wanted) in multiples.iter().zip(wanted) {
        assert!((time - wanted).abs() <= f64::EPSILON * wanted, "{time} and not {wanted}");
    }
    assert_eq!(*end, 0.75);
}

#[test]
fn a_span_of_whole_steps_takes_no_further_one_for_rounding() {
    for (end, step, steps) in [(0.7, 0.1, 7), (100.0, 1e-4, 1_000_000), (3.0, 3.0 / 7.0, 7)] {
        let mut observations = 0;
        let method = RungeKutta4 { step };
        let outcome = integrate(&Integral(|_: f64| 1.0), 0.0, [0.0], end, &method, |_, _| observations += 1);
        assert!(outcome.is_ok());
        assert_eq!(observations, steps + 1);
    }
}

#[test]
fn the_last_observation_is_the_result() {
    let mut last = None;
    let method = RungeKutta4 { step: 0.1 };
    let end = integrate(&Oscillator, 0.0, [1.0, 0.0], 5.0, &method, |_, y| last = Some(*y));
    assert!(end.is_ok());
    assert_eq!(end.ok(), last);
}

#[test]
fn nan_stops_at_the_last_good_state() {
    let root = Integral(|t: f64| (1.0 - t).sqrt());
    let mut good = Vec::new();
    let method = RungeKutta4 { step: 0.125 };
    let outcome = integrate(&root, 0.0, [0.0], 2.0, &method, |t, y| good.push((t, *y)));
    let (time, state) = good[good.len() - 1];
    let error = outcome.expect_err("NaN");
    assert_eq!((error.time, error.state), (time, state));
    assert!(
        matches!(error.cause, StepFailure::Undefined(Undefined::Rate { time, .. }) if time > 1.0),
        "{error}"
    );
    assert_eq!(time, 1.0);
    assert!((state[0] - 2.0 / 3.0).abs() < 1e-2);
}

#[test]
fn overflow_stops_as_well() {
    let method = RungeKutta4 { step: 0.02 };
    let outcome = integrate(&BlowUp, 0.0, [1.0], 2.0, &method, |_, y| assert!(y[0].is_finite()));
    let error = outcome.expect_err("no number represents the solution");
    assert!((1.0..1.2).contains(&error.time) && error.state[0].is_finite());
    assert!(error.to_string().ends_with(&std::format!("(at time {:?})", error.time)), "{error}");
}

/// ẍ = −ω²x − 2ζωẋ together with a slow oscillation.
struct Damped {
    frequency: f64,
    damping: f64,
}

impl OdeSystem for Damped {
    type Scalar = f64;
    type State = [f64; 4];

    fn rhs(&self, _t: f64, [x, slow, v, w]: &[f64; 4]) -> [f64; 4] {
        let Damped { frequency, damping } = self;
        [*v, *w, -frequency * frequency * x - 2.0 * damping * frequency * v, -slow]
    }
}

/// The step named in the message is the longest possible one, except that the stability domain is
/// not a circle. A slightly shorter one is stable from any start, and no stable step is rejected.
#[test]
fn the_longest_step_of_stiff_oscillations_is_named() {
    for (frequency, damping) in [(1e2, 0.0), (1e4, 0.02), (1e4, 0.3), (1e6, 0.7), (1e3, 0.95)] {
        let system = Damped { frequency, damping };
        for start in [[1e-3, 1.0, 0.0, 0.0], [0.0, 0.3, 1.0, -0.2], [1e-3, 0.0, 0.1 * frequency, 1.0]] {
            let run = |step: f64| {
                let end = if step * frequency > 1e6 { 3.0 * step } else { 200.0 * step };
                integrate(&system, 0.0, start, end, &RungeKutta4 { step }, |_, _| {})
            };
            for factor in [4.0, 30.0, 1e3, 1e80, 1e300] {
                let error = run(factor / frequency).expect_err("unstable");
                let StepFailure::StepTooLong { step, limit } = error.cause else {
                    panic!("{frequency} {damping} {factor}: {error}")
                };
                assert_eq!(step, factor / frequency);
                assert!(
                    (limit * frequency / 2.785 - 1.0).abs() < 0.02,
                    "{frequency} {damping} {factor}: {limit}"
                );
                assert!(run(0.98 * limit).is_ok(), "{frequency} {damping}");
            }
            assert!(run(1.0 / frequency).is_ok() && run(2.5 / frequency).is_ok(), "{frequency} {damping}");
        }
    }
    let error = integrate(
        &Damped { frequency: 1e3, damping: 0.1 },
        0.0,
        [1.0, 0.0, 0.0, 0.0],
        1.0,
        &RungeKutta4 { step: 0.01 },
        |_, _| {},
    );
    let what = error.expect_err("unstable").to_string();
    assert!(
        what.starts_with("a step of 0.01 is too long for this method, unstable above about 0.00278"),
        "{what}"
    );
}

#[test]
fn infinite_starts_are_refused() {
    let start = [f64::INFINITY, 0.0];
    let method = RungeKutta4 { step: 0.1 };
    let outcome = integrate(&Oscillator, 3.0, start, 3.0, &method, |_, _| panic!("observed"));
    let cause =
        StepFailure::Undefined(Undefined::State { component: Component::Index(0), value: f64::INFINITY });
    assert_eq!(outcome, Err(IntegrationError { cause, time: 3.0, state: start }));
    for end in [f64::NAN, f64::INFINITY] {
        let outcome = rk4(&Oscillator, 2.0, [0.3, -1.2], end, 0.1);
        let what = outcome.map_err(|error| error.cause.to_string());
        assert_eq!(what, Err(std::format!("the time of the end is {end:?}")));
    }
}

#[test]
fn spans_without_length_are_the_start_alone() {
    let start = [0.3, -1.2];
    let mut observations = 0;
    let outcome = integrate(&Oscillator, 2.0, start, 2.0, &RungeKutta4 { step: 0.1 }, |t, _| {
        assert_eq!(t, 2.0);
        observations += 1;
    });
    assert_eq!(outcome, Ok(start));
    assert_eq!(observations, 1);
}

#[test]
fn steps_without_length_are_refused() {
    for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let outcome = rk4(&Oscillator, 2.0, [0.3, -1.2], 3.0, step);
        assert!(
            matches!(outcome, Err(IntegrationError { cause: StepFailure::Setting(_), .. })),
            "{outcome:?}"
        );
    }
}

#[test]
fn late_times_take_as_many_steps_as_early_ones() {
    let rate = Integral(|_: f32| 1.0);
    let method = RungeKutta4 { step: 0.01 };
    for start in [0.0_f32, 1e3, 3e4] {
        let mut steps = 0;
        let [end] = integrate(&rate, start, [0.0], start + 5.0, &method, |_, _| steps += 1).expect("finite");
        assert!((end - 5.0).abs() < 1e-5 && (500..=502).contains(&steps), "{start}: {end} in {steps}");
    }
    let late = integrate(&rate, 1e6, [0.0], 1e6 + 5.0, &method, |_, _| {}).expect_err("lost");
    assert_eq!(late.cause, StepFailure::StepLost { step: 0.01, time: 1e6 });
}

#[test]
fn steps_that_no_time_can_tell_are_refused() {
    for step in [1e-300, 1e-17] {
        let refused = rk4(&Oscillator, 0.0, [0.3, -1.2], 1.0, step).expect_err("no end");
        assert_eq!(refused.cause, StepFailure::StepLost { step, time: 1.0 });
    }
    let what = rk4(&Oscillator, 1e15, [0.3, -1.2], 1e15 + 4.0, 0.01).expect_err("lost").to_string();
    assert!(
        what.starts_with("steps of 0.01 are below the rounding error of the time 1000000000000000"),
        "{what}"
    );
}

#[test]
fn steps_turn_round_for_a_limit_behind() {
    let mut stepper = RungeKutta4 { step: 0.1 }.start(&Oscillator, 0.0, &[1.0, 0.0], 1.0).expect("starts");
    for limit in [1.0, 1.0, 0.0, 0.0] {
        stepper.step(&Oscillator, limit).expect("finite");
    }
    assert_eq!(stepper.time(), 0.0, "two steps there and two back");
    assert!((stepper.state()[0] - 1.0).abs() < 1e-6);
}
