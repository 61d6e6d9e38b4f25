//! Events on systems whose events are known in closed form.

mod declared;
mod resets;
mod zeros;

use std::vec::Vec;

use super::{Detector, Occurrence};
use crate::integrate::{Method, RungeKutta4, Stepper, Verner98};
use crate::run::integrate_with_events;
use crate::system::{Action, Direction, EventSource, OdeSystem, StepFailure};

/// ẍ = −x
struct Oscillator;

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -x]
    }
}

const COSINE: [f64; 2] = [1.0, 0.0];
const PI: f64 = core::f64::consts::PI;

fn pair() -> Verner98<f64> {
    Verner98::tolerance(1e-13)
}

/// Returns the times and indices of all events of the oscillator.
fn all<const E: usize>(
    method: &impl Method<Oscillator>,
    t_end: f64,
    directions: [Direction; E],
    values: impl FnMut(f64, &[f64; 2]) -> [f64; E],
) -> Vec<(usize, f64)> {
    let mut found = Vec::new();
    let react = |event: &Occurrence<f64, [f64; 2]>| {
        found.push((event.event, event.time));
        Action::Continue
    };
    let end = integrate_with_events(&Oscillator, (0.0, COSINE), t_end, method, (directions, values), react);
    assert_eq!(end.expect("reaches its end").0, t_end);
    found
}

#[test]
fn each_direction_finds_its_zeros() {
    for (direction, wanted) in [
        (Direction::Falling, &[0.5, 2.5][..]),
        (Direction::Rising, &[1.5, 3.5][..]),
        (Direction::Crossing, &[0.5, 1.5, 2.5, 3.5][..]),
    ] {
        let found = all(&pair(), 4.0 * PI, [direction], |_, y| [y[0]]);
        assert_eq!(found.len(), wanted.len());
        for ((_, time), wanted) in found.iter().zip(wanted) {
            assert!((time - wanted * PI).abs() < 1e-12, "{time} for {wanted} π");
        }
    }
}

#[test]
fn several_events_of_one_step_come_in_order() {
    let values = |t: f64, y: &[f64; 2]| [y[0], t - 0.3, t - 0.1, t - 0.1, y[1] + 0.05];
    let found = all(&pair(), 2.0, [Direction::Crossing; 5], values);
    let order: Vec<usize> = found.iter().map(|(event, _)| *event).collect();
    assert_eq!(order, [4, 2, 3, 1, 0]);
    assert!((found[0].1 - 0.05_f64.asin()).abs() < 1e-12);
    assert!((found[1].1 - 0.1).abs() < 1e-12 && (found[2].1 - 0.1).abs() < 1e-12, "{found:?}");
}

#[test]
fn one_function_may_cross_zero_twice_in_a_step() {
    let found = all(&RungeKutta4 { step: 1.0 }, 1.0, [Direction::Crossing], |t, _| [(t - 0.4) * (t - 0.6)]);
    assert_eq!(found.len(), 2);
    assert!((found[0].1 - 0.4).abs() < 1e-12 && (found[1].1 - 0.6).abs() < 1e-12);
}

#[test]
fn zero_at_the_start_does_not_fire() {
    assert_eq!(all(&pair(), 1.0, [Direction::Crossing], |_, y| [y[1]]), []);
    let later = all(&pair(), 4.0, [Direction::Crossing], |_, y| [y[1]]);
    assert!(later.len() == 1 && (later[0].1 - PI).abs() < 1e-12, "{later:?}");
}

#[test]
fn touching_zero_does_not_fire() {
    assert_eq!(all(&pair(), 2.0, [Direction::Crossing], |t, _| [(t - 0.5) * (t - 0.5)]), []);
    assert_eq!(
        all(&RungeKutta4 { step: 1.0 }, 2.0, [Direction::Crossing], |t, _| [(t - 0.5) * (t - 0.5)]),
        []
    );
}

#[test]
fn stopping_ends_at_the_event() {
    let stop = |_: &Occurrence<f64, [f64; 2]>| Action::Stop;
    let values = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0]]);
    let (t, y) =
        integrate_with_events(&Oscillator, (0.0, COSINE), 9.0, &pair(), values, stop).expect("stops");
    assert!((t - 0.5 * PI).abs() < 1e-12 && y[0].abs() < 1e-12 && (y[1] + 1.0).abs() < 1e-12);
    assert!(y[0] <= 0.0, "the event has happened");
}

#[test]
fn backward_time_finds_the_same_events() {
    let mut times = Vec::new();
    let values = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0]]);
    let react = |event: &Occurrence<f64, [f64; 2]>| {
        times.push(event.time);
        Action::Continue
    };
    integrate_with_events(&Oscillator, (0.0, COSINE), -9.0, &pair(), values, react).expect("finite");
    assert!((times[0] + 0.5 * PI).abs() < 1e-12 && (times[1] + 2.5 * PI).abs() < 1e-12, "{times:?}");
}

#[test]
fn a_replaced_state_is_gone_on_from() {
    let mut heights = Vec::new();
    let values = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0]]);
    let react = |event: &Occurrence<f64, [f64; 2]>| {
        heights.push(event.time);
        Action::Replace([0.0, -event.state[1]])
    };
    // An oscillator on one side of a wall: its period is half as long.
    integrate_with_events(&Oscillator, (0.0, COSINE), 10.0, &pair(), values, react).expect("finite");
    for (n, time) in heights.iter().enumerate() {
        assert!((time - (0.5 + n as f64) * PI).abs() < 1e-11, "{time}");
    }
    assert_eq!(heights.len(), 3);
}

#[test]
fn a_function_that_jumps_is_located_too() {
    let found = all(&pair(), 2.0, [Direction::Rising], |t, _| [if t < 0.7 { -1.0 } else { 3.0 }]);
    assert!(found.len() == 1 && (found[0].1 - 0.7).abs() < 1e-12);
}

#[test]
fn nan_in_a_function_is_an_error_with_the_last_good_state() {
    let values = ([Direction::Rising; 2], |t: f64, _: &[f64; 2]| [-1.0, (0.5 - t).sqrt()]);
    let go_on = |_: &Occurrence<f64, [f64; 2]>| Action::Continue;
    let error =
        integrate_with_events(&Oscillator, (0.0, COSINE), 9.0, &pair(), values, go_on).expect_err("NaN");
    assert_eq!(error.cause, StepFailure::EventNotFinite { event: EventSource::Given(1) });
    assert!(error.state.iter().all(|y| y.is_finite()));
}

#[test]
fn a_function_of_pure_noise_settles_or_is_refused() {
    let mut calls = 0;
    let noise = |_: f64, _: &[f64; 2]| {
        calls += 1;
        [if calls % 2 == 0 { 1.0 } else { -1.0 }]
    };
    let go_on = |_: &Occurrence<f64, [f64; 2]>| Action::Continue;
    let watch = ([Direction::Crossing], noise);
    let ended = integrate_with_events(&Oscillator, (0.0, COSINE), 1.0, &pair(), watch, go_on);
    assert!(ended.is_ok() && calls < 1_000_000, "{calls}");
}

#[test]
fn a_loop_of_ones_own_watches_step_by_step() {
    let method = RungeKutta4 { step: 1e-3 };
    let mut stepper = method.start(&Oscillator, 0.0, &COSINE, 2.0).expect("starts");
    let mut watch = Detector::new([Direction::Falling], 0.0, [1.0]);
    let mut times = Vec::new();
    while stepper.time() < 2.0 {
        stepper.step(&Oscillator, 2.0).expect("finite");
        while let Some(event) = watch.next(&Oscillator, &mut stepper, |_, y| [y[0]]).expect("located") {
            times.push(event.time);
        }
    }
    assert!(times.len() == 1 && (times[0] - 0.5 * PI).abs() < 1e-12, "{times:?}");
}

#[test]
fn a_loop_of_ones_own_asks_what_happens_at_the_same_time() {
    let values = |t: f64, _: &[f64; 2]| [t - 0.5, t - 0.5, t - 0.6];
    let mut stepper = RungeKutta4 { step: 1.0 }.start(&Oscillator, 0.0, &COSINE, 1.0).expect("starts");
    let mut watch = Detector::new([Direction::Rising; 3], 0.0, values(0.0, &COSINE));
    stepper.step(&Oscillator, 1.0).expect("finite");
    let first = watch.next(&Oscillator, &mut stepper, values).expect("located").expect("one");
    let mut at_once = || watch.next_at_once(first.time, &Oscillator, &mut stepper, values).expect("located");
    assert_eq!((first.event, at_once().map(|event| event.event)), (0, Some(1)));
    assert_eq!(at_once(), None);
    let last = watch.next(&Oscillator, &mut stepper, values).expect("located").expect("it was not lost");
    assert_eq!(last.event, 2);
}

/// ÿ = −10
struct Ball;

impl OdeSystem for Ball {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [_, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -10.0]
    }
}

#[test]
fn a_state_replaced_at_zero_does_not_fire_again() {
    for direction in [Direction::Falling, Direction::Crossing] {
        let mut bounces = Vec::new();
        let watch = ([direction], |_: f64, y: &[f64; 2]| [y[0]]);
        let bounce = |event: &Occurrence<f64, [f64; 2]>| {
            bounces.push(event.time);
            Action::Replace([0.0, -0.5 * event.state[1]])
        };
        integrate_with_events(&Ball, (0.0, [5.0, 0.0]), 2.9, &pair(), watch, bounce).expect("finite");
        // The first fall takes a second, then the hops last 1, 1/2, 1/4, …
        assert_eq!(bounces.len(), 5, "{bounces:?}");
        for (time, wanted) in bounces.iter().zip([1.0, 2.0, 2.5, 2.75, 2.875]) {
            assert!((time - wanted).abs() < 1e-11, "{time} for {wanted}");
        }
    }
}

#[test]
fn infinitely_many_bounces_are_an_error_with_the_last_state_above_ground() {
    let mut count = 0;
    let watch = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0]]);
    let bounce = |event: &Occurrence<f64, [f64; 2]>| {
        count += 1;
        Action::Replace([0.0, -0.5 * event.state[1]])
    };
    let error =
        integrate_with_events(&Ball, (0.0, [5.0, 0.0]), 4.0, &pair(), watch, bounce).expect_err("Zeno");
    assert!(matches!(error.cause, StepFailure::EventsAccumulate { .. }), "{error:?}");
    assert!((error.time - 3.0).abs() < 1e-9 && error.state[0].abs() < 1e-9, "{error:?}");
    assert!(count < 200, "{count}");
}

#[test]
fn events_at_one_time_follow_each_other() {
    let mut seen = Vec::new();
    let watch = ([Direction::Falling; 3], |_: f64, y: &[f64; 2]| [y[0], 2.0 * y[0], y[0] - 1.0]);
    let react = |event: &Occurrence<f64, [f64; 2]>| {
        seen.push((event.event, event.state[1]));
        match event.event {
            0 => Action::Replace([0.0, 3.0]),
            1 => Action::Replace([0.0, 2.0 * event.state[1]]),
            _ => Action::Continue,
        }
    };
    let (_, end) =
        integrate_with_events(&Ball, (0.0, [5.0, 0.0]), 1.1, &pair(), watch, react).expect("finite");
    let events: Vec<usize> = seen.iter().map(|(event, _)| *event).collect();
    assert_eq!(events, [2, 0, 1]);
    assert_eq!(seen[2].1, 3.0, "the second sees what the first has left");
    assert!((end[1] - (6.0 - 1.0)).abs() < 1e-9, "{end:?}");
}

#[test]
fn nan_in_a_function_at_the_start_is_an_error() {
    let values = ([Direction::Rising], |t: f64, _: &[f64; 2]| [if t > 0.0 { t - 0.5 } else { f64::NAN }]);
    let go_on = |_: &Occurrence<f64, [f64; 2]>| Action::Continue;
    let error =
        integrate_with_events(&Oscillator, (0.0, COSINE), 9.0, &pair(), values, go_on).expect_err("NaN");
    assert_eq!(error.cause, StepFailure::EventNotFinite { event: EventSource::Given(0) });
}
