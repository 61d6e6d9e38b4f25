//! Restarts on motions under forces that jump at known times.

use std::string::ToString;
use std::vec::Vec;

use super::Restarts;
use crate::event::Occurrence;
use crate::integrate::{Method, PlainGaussLegendre, RungeKutta4, Stepper, Verner98};
use crate::run::{integrate, integrate_with_events};
use crate::system::{Action, Direction, OdeSystem};

/// ẍ = 0 before the time 0, then 1, −2, 3, … between jumps one second apart.
#[derive(Clone, Copy)]
struct Pushed {
    /// True if the instant of a jump belongs to the push before it.
    is_late: bool,
    /// True if it provides the times of its jumps.
    tells: bool,
}

impl OdeSystem for Pushed {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, [_, v]: &[f64; 2]) -> [f64; 2] {
        let second = if self.is_late { t.ceil() - 1.0 } else { t.floor() };
        [*v, push(second)]
    }

    fn next_restart(&self, t: f64, end: f64) -> Option<f64> {
        let next = if end < t { t.ceil() - 1.0 } else { t.floor() + 1.0 };
        self.tells.then_some(next)
    }
}

fn push(second: f64) -> f64 {
    if second.rem_euclid(2.0) == 0.0 { second + 1.0 } else { -(second + 1.0) }
}

/// Returns the state half a second after this many seconds, from rest at the origin. No force acts
/// before time 0.
fn half_past(seconds: i32) -> [f64; 2] {
    let pushed = |[x, v]: [f64; 2], second: i32, time: f64| {
        let a = push(f64::from(second));
        [x + time * (v + a * time / 2.0), v + a * time]
    };
    let whole = (0..seconds).fold([0.0, 0.0], |state, second| pushed(state, second, 1.0));
    pushed(whole, seconds, 0.5)
}

fn assert_near(found: [f64; 2], wanted: [f64; 2], what: &str) {
    let error = (found[0] - wanted[0]).abs().max((found[1] - wanted[1]).abs());
    assert!(error < 1e-13, "{what}: {found:?} for {wanted:?}");
}

const SYSTEMS: [Pushed; 2] = [Pushed { is_late: false, tells: true }, Pushed { is_late: true, tells: true }];

/// Methods that are exact for constant forces are exact across jumps, however jumps are defined.
#[test]
fn no_step_sees_a_jump() {
    for system in SYSTEMS {
        let ends = [
            integrate(&system, -0.5, [0.0; 2], 6.5, &Verner98::tolerance(1e-6), |_, _| {}),
            integrate(&system, -0.5, [0.0; 2], 6.5, &RungeKutta4 { step: 0.3 }, |_, _| {}),
            integrate(&system, -0.5, [0.0; 2], 6.5, &PlainGaussLegendre::<f64, 2> { step: 0.3 }, |_, _| {}),
        ];
        for end in ends {
            assert_near(end.expect("finite"), half_past(6), "forwards");
        }
        let back = integrate(&system, 6.5, half_past(6), -0.5, &Verner98::tolerance(1e-6), |_, _| {});
        assert_near(back.expect("finite"), [0.0; 2], "backwards");
    }
    let silent = Pushed { is_late: false, tells: false };
    let [x, _] =
        integrate(&silent, -0.5, [0.0; 2], 6.5, &RungeKutta4 { step: 0.3 }, |_, _| {}).expect("finite");
    assert!((x - half_past(6)[0]).abs() > 1e-3, "the jumps matter: {x}");
}

#[test]
fn given_times_and_those_of_the_system_are_merged() {
    let system = SYSTEMS[0];
    for (given, end, wanted) in [
        (&[0.5, 1.0, 1.5, 9.0][..], 2.5, &[0.5, 1.0, 1.5, 2.0, 2.5][..]),
        (&[1.5, 1.0, 0.5, 0.25], -0.5, &[1.5, 1.0, 0.5, 0.25, 0.0, -0.5]),
    ] {
        let start = if end < 0.0 { 2.0 } else { 0.0 };
        let method = RungeKutta4 { step: 10.0 };
        let mut stepper = method.start(&system, start, &[0.0; 2], end).expect("starts");
        let mut restarts = Restarts::new(start, end, given);
        let mut times = Vec::new();
        while stepper.time() != end && times.len() < 20 {
            restarts.resume(&system, &mut stepper).expect("finite");
            restarts.step(&system, &mut stepper, None, |_, _| true).expect("finite");
            times.push(restarts.time(&stepper));
        }
        assert_eq!(times, wanted);
    }
}

#[test]
fn nothing_is_tried_in_vain() {
    for system in SYSTEMS {
        let mut stepper = Verner98::tolerance(1e-12).start(&system, -0.5, &[0.0; 2], 4.5).expect("starts");
        let mut restarts = Restarts::new(-0.5, 4.5, &[]);
        while stepper.time() != 4.5 {
            restarts.resume(&system, &mut stepper).expect("finite");
            restarts.step(&system, &mut stepper, None, |_, _| true).expect("finite");
        }
        assert_eq!(stepper.work().rejections, 0);
        assert_near(*stepper.state(), half_past(4), "the end");
    }
}

/// Restart times that are past, NaN, or at the end are ignored.
#[test]
fn times_that_are_not_ahead_do_nothing() {
    struct Odd(f64);
    impl OdeSystem for Odd {
        type Scalar = f64;
        type State = [f64; 1];

        fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
            [1.0]
        }

        fn next_restart(&self, _t: f64, _end: f64) -> Option<f64> {
            Some(self.0)
        }
    }
    for time in [-1.0, 0.0, f64::MIN_POSITIVE, f64::NAN, f64::INFINITY, 2.0, 2.0 - f64::EPSILON, 3.0] {
        let mut steps = 0;
        let method = RungeKutta4 { step: 1.0 };
        let end = integrate(&Odd(time), 0.0, [0.0], 2.0, &method, |_, _| steps += 1).expect("finite");
        assert!(end == [2.0] && steps <= 4, "{time}: {steps} steps to {end:?}");
    }
}

/// Restarts and events in one run: an event within a step, and one that replaces the state at the
/// time of a restart.
#[test]
fn events_come_in_between() {
    let system = SYSTEMS[0];
    let mut seen = Vec::new();
    let watch = ([Direction::Rising; 2], |t: f64, _: &[f64; 2]| [t - 0.5, t - 2.0]);
    let react = |event: &Occurrence<f64, [f64; 2]>| {
        seen.push((event.event, event.time));
        if event.event == 1 { Action::Replace([0.0, 0.0]) } else { Action::Continue }
    };
    let method = Verner98::tolerance(1e-10);
    let (_, end) =
        integrate_with_events(&system, (0.0, [0.0; 2]), 2.5, &method, watch, react).expect("finite");
    assert_eq!(seen.iter().map(|(event, _)| *event).collect::<Vec<_>>(), [0, 1]);
    assert!((seen[0].1 - 0.5).abs() < 1e-12 && (seen[1].1 - 2.0).abs() < 1e-12, "{seen:?}");
    assert_near(end, [0.375, 1.5], "half a second from rest");
}

#[test]
fn a_restart_that_fails_is_an_error_at_the_jump() {
    struct Ends;
    impl OdeSystem for Ends {
        type Scalar = f64;
        type State = [f64; 1];

        fn rhs(&self, t: f64, _y: &[f64; 1]) -> [f64; 1] {
            [if t < 1.0 { 1.0 } else { f64::NAN }]
        }

        fn next_restart(&self, _t: f64, _end: f64) -> Option<f64> {
            Some(1.0)
        }
    }
    let error = integrate(&Ends, 0.0, [0.0], 2.0, &Verner98::tolerance(1e-6), |_, _| {}).expect_err("NaN");
    let what = error.cause.to_string();
    assert!(what.starts_with("the rate of the component at index 0 is NaN at time 1.0"), "{what}");
    assert!((error.time - 1.0).abs() < 1e-15 && (error.state[0] - 1.0).abs() < 1e-14, "{error:?}");
}
