//! Runs that end early, and progress reports.

use core::cell::Cell;
use std::f64::consts::FRAC_PI_3;
use std::ops::ControlFlow;
use std::string::ToString;
use std::vec::Vec;

use super::{Broken, Oscillator, START, assert_exact};
use crate::integrate::RungeKutta4;
use crate::simulate::{Ending, Progress, Simulate};
use crate::system::{Component, MechanicalSystem, OdeSystem, SettingError, StepFailure, Undefined, Unnamed};

#[test]
fn a_failure_keeps_the_samples_so_far() {
    let error = Broken(0.5).simulate(START).until(10.0).every(0.1).run().expect_err("fails");
    // cos t falls below 0.5 at π/3.
    let (time, state) = (error.time(), error.state());
    assert!(time > 0.8 && time < FRAC_PI_3 + 1e-9, "{time}");
    assert!((state[0] - time.cos()).abs() < 1e-8);
    let kept = &error.trajectory;
    assert_eq!(kept.ending(), Ending::Failed);
    assert_eq!((kept.end_time(), kept.last()), (time, state));
    assert_eq!(kept.times().last(), Some(&time));
    assert!(kept.times()[..kept.len() - 1].iter().enumerate().all(|(k, t)| *t == 0.1 * k as f64));
    assert!(kept.states().flatten().all(f64::is_finite));
    assert!(kept.work().steps > 0);
}

#[test]
fn a_failure_of_a_fixed_step_reports_cause_and_time() {
    let method = RungeKutta4 { step: 0.01 };
    let error = Broken(0.5).simulate(START).until(10.0).method(method).run().expect_err("fails");
    let StepFailure::Undefined(Undefined::Rate { component, value, time }) = error.cause else {
        panic!("{error}")
    };
    assert_eq!(component, Component::Velocity("x"));
    assert!(value.is_nan() && time > error.time() && time <= error.time() + 0.01, "{time}");
    assert_eq!(error.trajectory.work().steps, 104);
    assert_eq!(error.to_string(), std::format!("{} (at time {:?})", error.cause, error.time()));
    let boxed: std::boxed::Box<dyn std::error::Error + Send + Sync> = error.into();
    assert!(boxed.to_string().contains("NaN"));
}

#[test]
fn an_initial_state_that_is_not_finite_is_refused_and_shown() {
    let error = Oscillator.simulate([f64::NAN, 0.0]).until(1.0).run().expect_err("refused");
    assert_eq!(error.to_string(), "`x` of the state is NaN (at time 0.0)");
    assert_eq!(error.trajectory.len(), 1);
    assert!(error.state()[0].is_nan());
    for end in [f64::NAN, f64::INFINITY] {
        let error = Oscillator.simulate(START).until(end).run().expect_err("refused");
        assert_eq!(error.to_string(), std::format!("the time of the end is {end:?} (at time 0.0)"));
        let error = Oscillator.simulate(START).from(end).until(1.0).run().expect_err("refused");
        assert!(error.to_string().starts_with(&std::format!("the time of the start is {end:?}")), "{error}");
    }
}

/// Holds even if samples or controllers would need infinitely many times.
#[test]
fn a_span_that_is_not_finite_is_named_before_its_samples() {
    for time in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = Oscillator.simulate(START).until(time).every(0.1).run().expect_err("refused");
        assert_eq!(error.to_string(), std::format!("the time of the end is {time:?} (at time 0.0)"));
        let error = Oscillator.simulate(START).from(time).until(1.0).every(0.1).run().expect_err("refused");
        assert!(error.to_string().starts_with(&std::format!("the time of the start is {time:?}")), "{error}");
    }
    let wide = Oscillator.simulate(START).from(-1e308).until(1e308).every(1e300).run().expect_err("refused");
    assert!(wide.to_string().contains("samples exceed the limit"), "{wide}");
}

#[test]
fn settings_come_in_any_order() {
    let one = Oscillator.simulate(START).tolerance(1e-7).every(0.5).energy().max_steps(1000);
    let one = one.method(RungeKutta4 { step: 0.1 }).from(1.0).lasting(2.0).run().expect("runs");
    let other = Oscillator.simulate(START).from(1.0).until(3.0).method(RungeKutta4 { step: 0.1 });
    let other = other.every(0.5).energy().run().expect("runs");
    assert_eq!(one.table(), other.table());
}

#[test]
fn settings_of_methods_are_checked() {
    let error = Oscillator.simulate(START).until(1.0).tolerance(-1.0).run().expect_err("refused");
    assert!(matches!(error.cause, StepFailure::Setting(_)));
    let method = RungeKutta4 { step: 0.0 };
    let error = Oscillator.simulate(START).until(1.0).method(method).run().expect_err("refused");
    assert!(matches!(error.cause, StepFailure::Setting(_)));
}

#[test]
fn no_more_steps_are_taken_than_allowed() {
    let run = |limit| {
        let simulation = Oscillator.simulate(START).until(1.0).method(RungeKutta4 { step: 0.125 });
        simulation.max_steps(limit).run()
    };
    assert_eq!(run(8).expect("just enough").len(), 9);
    let error = run(7).expect_err("one too few");
    assert_eq!(error.cause, StepFailure::TooManySteps { limit: 7 });
    assert_eq!((error.time(), error.trajectory.len()), (0.875, 8));
    assert_exact(&error.trajectory, 1e-4);
    assert_eq!(run(0).expect_err("none").trajectory.times(), [0.0]);
}

#[test]
fn progress_is_reported_about_two_hundred_times() {
    for (end, step) in [(10.0, 1e-3), (-10.0, 1e-3), (10.0, 0.5)] {
        let mut reports = Vec::new();
        let simulation = Oscillator.simulate(START).until(end).method(RungeKutta4 { step });
        simulation.progress(|progress| reports.push(progress)).run().expect("runs");
        let fractions: Vec<f64> = reports.iter().map(Progress::fraction).collect();
        assert!(fractions.windows(2).all(|pair| pair[0] < pair[1]), "{fractions:?}");
        assert_eq!(fractions.last(), Some(&1.0));
        let expected = if step > 0.1 { 20..=20 } else { 200..=203 };
        assert!(expected.contains(&fractions.len()), "{} reports", fractions.len());
        assert_eq!(reports.last().map(|progress| (progress.time, progress.end)), Some((end, end)));
    }
}

#[test]
fn a_run_that_gets_nowhere_is_reported_more_and_more_seldom() {
    let mut reports = Vec::new();
    let simulation = Oscillator.simulate(START).until(1e9).method(RungeKutta4 { step: 1e-3 });
    let trajectory = simulation
        .ends_only()
        .progress(|progress| {
            reports.push(progress.steps);
            if reports.len() < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
        .run()
        .expect("cancelled is no failure");
    assert_eq!(reports, [4096, 8192, 16384, 32768]);
    assert_eq!(trajectory.work().steps, 32768);
}

#[test]
fn a_run_is_cancelled_within_a_long_step() {
    let method = RungeKutta4 { step: 2.0 };
    let run = Oscillator.simulate(START).until(2.0).method(method).every(1e-5);
    let run = run.progress(|progress| match progress.time < 0.5 {
        true => ControlFlow::Continue(()),
        false => ControlFlow::Break(()),
    });
    let kept = run.run().expect("cancelled is no failure");
    assert_eq!(kept.ending(), Ending::Cancelled);
    assert_eq!((kept.work().steps, kept.len()), (1, 50_001));
    assert_eq!((kept.end_time(), kept.times().last()), (0.5, Some(&0.5)));
}

#[test]
fn a_cancelled_run_returns_what_it_has() {
    let simulation = Oscillator.simulate(START).until(10.0).every(0.3);
    let trajectory =
        simulation
            .method(RungeKutta4 { step: 0.125 })
            .progress(|progress| {
                if progress.fraction() < 0.5 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            })
            .run()
            .expect("cancelled is no failure");
    assert_eq!(trajectory.ending(), Ending::Cancelled);
    assert_eq!(trajectory.end_time(), 5.0);
    assert_eq!(trajectory.times().last(), Some(&5.0));
    assert_exact(&trajectory, 1e-4);
    let complete = Oscillator.simulate(START).until(1.0).run().expect("runs");
    assert_eq!(complete.ending(), Ending::Reached);
}

#[test]
fn a_run_is_cancelled_from_elsewhere() {
    let asked = Cell::new(0);
    let run = Oscillator.simulate(START).until(1e9).method(RungeKutta4 { step: 1e-3 }).ends_only();
    let run = run.cancel_when(|| asked.replace(asked.get() + 1) == 10).run().expect("is no failure");
    assert_eq!((run.ending(), asked.get()), (Ending::Cancelled, 11));
    assert!(run.work().steps < 1000, "{} steps", run.work().steps);
    let free = Oscillator.simulate(START).until(1.0);
    assert_eq!(free.cancel_when(|| false).run().expect("runs").ending(), Ending::Reached);
}

#[test]
fn the_longest_step_is_limited_where_steps_have_no_length_of_their_own() {
    let longest = |limit: f64| {
        let run =
            Oscillator.simulate(START).until(20.0).tolerance(1e-3).longest_step(limit).run().expect("runs");
        run.times().windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    };
    assert!((longest(0.25) - 0.25).abs() < 1e-12);
    assert!(longest(20.0) > 1.0, "without a limit of its own a run takes at least twenty steps");
    let refused = |run: Result<_, crate::simulate::SimulationError<Oscillator>>| {
        run.map(|_: crate::simulate::Trajectory<_>| ()).expect_err("refused").cause
    };
    for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let run = Oscillator.simulate(START).until(1.0).longest_step(limit).run();
        assert!(matches!(refused(run), StepFailure::Setting(_)), "{limit}");
    }
    let fixed = Oscillator.simulate(START).until(1.0).method(RungeKutta4 { step: 0.1 });
    let cause = refused(fixed.longest_step(0.5).run());
    assert!(
        matches!(cause, StepFailure::Setting(SettingError::Invalid(what)) if what.contains("reduce")),
        "{cause}"
    );
}

/// ẍ = 0, or NaN after the start: every step is rejected.
struct Wall;

impl OdeSystem for Wall {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, [_, v]: &[f64; 2]) -> [f64; 2] {
        [*v, if t > 0.0 { f64::NAN } else { 0.0 }]
    }
}

impl MechanicalSystem for Wall {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];

    fn acceleration(&self, t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> [f64; 1] {
        [self.rhs(t, &[*x, *v])[1]]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

#[test]
fn steps_that_are_rejected_count() {
    let error = Wall.simulate(START).until(1.0).max_steps(20).run().expect_err("gives up");
    assert_eq!(error.cause, StepFailure::TooManySteps { limit: 20 });
    assert_eq!(error.trajectory.work().rejections, 20);
    let error = Wall.simulate(START).until(1.0).run().expect_err("gives up by itself");
    let cause = error.cause.to_string();
    assert!(cause.starts_with("the acceleration `x_ddot` is NaN at time "), "{cause}");
    assert!(error.trajectory.work().rejections < 1000);
}
