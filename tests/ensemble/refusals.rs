//! Errors are reported, and affect nothing else.

use std::ops::ControlFlow;

use lagrange::Ensembles;
use lagrange::ensemble::{Done, EnsembleError, Moments, Random, Shard};
use lagrange::integrate::{RungeKutta4, StepFailure};
use lagrange::system::Direction;

use crate::lanes::CartPole;
use crate::{DoublePendulum, start};

#[track_caller]
fn assert_says<T>(result: Result<T, EnsembleError>, text: &str) {
    let error = result.err().expect("is wrong").to_string();
    assert!(error.contains(text), "{error}");
}

#[test]
fn settings_that_make_no_sense_are_errors() {
    let pendulum = DoublePendulum::default();
    let ensemble = |number| pendulum.ensemble(number).start(start).until(1.0);
    assert_says(ensemble(0).run(), "at least one motion");
    assert_says(pendulum.ensemble(Vec::<[f64; 4]>::new()).until(1.0).run(), "at least one motion");
    assert_says(pendulum.ensemble(10).until(1.0).run(), ".start(");
    assert_says(pendulum.ensemble([[0.0; 4]]).start(start).until(1.0).run(), "a list of starts and");
    assert_says(ensemble(10).threads(0).run(), "at least one thread");
    assert_says(ensemble(10).threads(100_000).run(), "at most 4096 threads");
    assert_says(ensemble(10).motions_per_part(0).run(), "a part must contain");
    assert_says(ensemble(10).shard(Shard::of(2, 2)).run(), "no shard 2 of 2");
    assert_says(ensemble(10).shard(Shard::of(0, 2)).run(), "more than there are parts, 1");
    assert_says(ensemble(10).motion(10).map(drop), "no motion 10");
    assert_says(
        pendulum.ensemble(10).start_within_ranges([0.0; 4]).until(1.0).run(),
        "a lower and an upper bound",
    );
    for end in [f64::NAN, f64::INFINITY] {
        let ensemble = || pendulum.ensemble(10).start(start).until(end);
        assert_says(ensemble().run(), "must both be finite");
        assert_says(ensemble().every(0.1).motion(0).map(drop), "must both be finite");
    }
    assert_says(ensemble(10).tolerance(-1.0).run(), "tolerances must be");
    assert_says(ensemble(10).method(RungeKutta4 { step: 0.0 }).run(), "the step size must be");
    assert_says(ensemble(10).energy().energy().run(), "two columns are called `energy`");
    assert_says(ensemble(10).every(-1.0).run(), "sampling interval");
    assert_says(ensemble(10).every(1e-12).run().map(drop), "samples exceed the limit");
}

/// In two ways: one by one, and in lanes. No motion begins.
#[test]
fn settings_are_checked_before_anything_moves() {
    let (pendulum, cart) = (DoublePendulum::default(), CartPole::default());
    let unstarted = |_: usize, _: &mut Random| -> [f64; 4] { panic!("begins") };
    let alone = || pendulum.ensemble(10).start(unstarted).until(1.0);
    let lanes = || cart.ensemble(10).start(unstarted).until(1.0);
    assert!(lanes().is_in_lanes() && !alone().is_in_lanes());
    assert_says(alone().tolerance(-1.0).run(), "tolerances must be");
    assert_says(lanes().tolerance(-1.0).run(), "tolerances must be");
    let steps = "the step size must be";
    assert_says(alone().method(RungeKutta4 { step: -1.0 }).run(), steps);
    for step in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
        assert_says(lanes().method(RungeKutta4 { step }).run(), steps);
    }
    assert_says(alone().longest_step(0.0).run(), "step sizes must be");
    assert_says(lanes().longest_step(0.0).run(), "step sizes must be");
    let shorten = "reduce it instead";
    assert_says(alone().method(RungeKutta4 { step: 0.1 }).longest_step(0.1).run(), shorten);
    assert_says(lanes().method(RungeKutta4 { step: 0.1 }).longest_step(0.1).run(), shorten);
    assert_says(alone().every(0.0).run(), "sampling interval");
    assert_says(lanes().every(f64::NAN).run(), "sampling interval");
    assert_says(lanes().every(1e-9).run(), "samples exceed the limit");
    assert_says(alone().restart_at([f64::NAN]).run(), "times of restart");
    let twice = "two columns are called `theta1_dot`";
    assert_says(alone().observe("theta1_dot", |_, t, _| t).run(), twice);
    assert_says(alone().observe("", |_, t, _| t).reduce(0_u64, |_, _| {}), "an empty name");
    assert_says(lanes().observe("t", |_, t, _| t).motion(3).map(drop), "the name of the time");
}

#[test]
fn a_failed_motion_is_a_row_and_the_others_continue() {
    let pendulum = DoublePendulum::default();
    let nan =
        |i: usize, random: &mut _| if i % 3 == 1 { [f64::NAN, 0.0, 0.0, 0.0] } else { start(i, random) };
    let ends = pendulum.ensemble(100).start(nan).until(1.0).threads(2).run().expect("runs");
    assert_eq!((ends.len(), ends.failures().len()), (100, 33));
    let failure = &ends.failures()[1];
    assert_eq!((failure.index, failure.time), (4, 0.0));
    assert!(failure.state[0].is_nan() && ends.theta1()[4].is_nan() && ends.times()[4].is_nan());
    assert_eq!(failure.to_string(), "motion 4: `theta1` of the state is NaN (at time 0.0)");
    assert_eq!(ends.state(4), None);
    assert!(ends.state(5).is_some_and(|state| state.iter().all(|value| value.is_finite())));
    let reduced = pendulum.ensemble(100).start(nan).until(1.0);
    let reduced = reduced.reduce(Moments::new(), |moments, motion| moments.add(motion.end().theta1));
    let reduced = reduced.expect("runs");
    assert_eq!((reduced.count(), reduced.failed(), reduced.failures().len()), (67, 33, 33));
    assert!(reduced.mean().is_finite());
}

#[test]
fn parameters_outside_their_domain_are_failures() {
    let pendulum = DoublePendulum::default();
    let ensemble = pendulum.ensemble(3).start(start).parameters(|i, p| p.l1 = i as f64).until(1.0);
    let ends = ensemble.run().expect("runs");
    let failed: Vec<_> = ends.failures().iter().map(|failure| failure.index).collect();
    assert_eq!(failed, [0]);
}

#[test]
fn motions_fail_where_they_fail() {
    let pendulum = DoublePendulum::default();
    let ends = pendulum.ensemble(10).start(start).until(1e6).max_steps(50).run().expect("runs");
    let failure = &ends.failures()[9];
    assert_eq!(failure.cause, StepFailure::TooManySteps { limit: 50 });
    assert!(failure.time > 0.0 && failure.state.iter().all(|value| value.is_finite()));
}

#[test]
fn a_panic_is_an_error_that_names_its_motion() {
    let pendulum = DoublePendulum::default();
    for threads in [1, 2] {
        let panics = |i: usize, _: &mut _| if i >= 70 { panic!("no start for {i}") } else { [0.0; 4] };
        let result = pendulum.ensemble(1000).start(panics).until(0.1).threads(threads).run();
        assert_says(result, "motion 70 panicked: no start for 70");
        let ensemble = pendulum.ensemble(1000).start(|_, _| [0.0; 4]).until(0.1).threads(threads);
        let reduced = ensemble.reduce(0_u64, |_, motion| assert!(motion.index() < 70, "is beyond"));
        assert_says(reduced, "motion 70 panicked: is beyond");
    }
}

/// In two ways: one by one, and in lanes, whose columns are computed from final states.
#[test]
fn observers_may_panic() {
    let (pendulum, cart) = (DoublePendulum::default(), CartPole::default());
    let alone =
        pendulum.ensemble(9).start(start).until(0.1).observe("seen", |_, _, _| panic!("is not observed"));
    assert_says(alone.run(), "motion 0 panicked: is not observed");
    let lanes = cart.ensemble(9).start(start).until(0.1).observe("seen", |_, _, _| panic!("is not observed"));
    assert!(lanes.is_in_lanes());
    assert_says(lanes.run(), "motion 0 panicked: is not observed");
}

#[test]
fn progress_that_panics_is_an_error_whenever_it_does() {
    let (pendulum, cart) = (DoublePendulum::default(), CartPole::default());
    for threads in [1, 2] {
        for at_end in [false, true] {
            let panics = move |done: Done| assert!(at_end && done.motions < done.of, "is done");
            let alone = pendulum.ensemble(100).start(start).until(0.1).threads(threads).progress(panics);
            assert_says(alone.run(), "the progress callback panicked: is done");
            let lanes = cart.ensemble(100).start(start).until(0.1).threads(threads).progress(panics);
            assert_says(lanes.reduce(0_u64, |_, _| {}), "the progress callback panicked: is done");
        }
    }
}

#[test]
fn more_than_memory_holds_is_refused_before_anything_is_computed() {
    let pendulum = DoublePendulum::default();
    let ensemble = || pendulum.ensemble(1 << 50).start(|_, _| -> [f64; 4] { panic!("begins") }).until(1.0);
    assert_says(ensemble().run(), "the ends of 1125899906842624 motions need at least 45035996.3 GB");
    assert_says(ensemble().every(0.01).run(), "the samples of 1125899906842624 motions");
    // The number of samples is unknown for motions that may be stopped.
    let many = pendulum.ensemble(1000).start(|_, _| -> [f64; 4] { panic!("begins") }).until(1e6).every(0.1);
    let stopped = many.stop_at("start", Direction::Crossing, |_, t, _| t);
    assert_says(stopped.run(), "motion 0 panicked: begins");
}

#[test]
fn an_empty_range_is_reported() {
    let pendulum = DoublePendulum::default();
    let ensemble = pendulum.ensemble(10).start(|_, random| [random.uniform(1.0..1.0), 0.0, 0.0, 0.0]);
    assert_says(ensemble.until(0.1).run(), "motion 0 panicked: there is no random number in 1.0..1.0");
}

#[test]
fn progress_cancels() {
    let pendulum = DoublePendulum::default();
    for threads in [1, 2] {
        let ensemble = pendulum.ensemble(1_000_000).start(start).until(1.0).threads(threads);
        let result = ensemble.progress(|_| ControlFlow::<()>::Break(())).run();
        let Err(EnsembleError::Cancelled { motions }) = result else { panic!("{result:?}") };
        assert!(motions < 1000, "{motions}");
    }
}

/// Each of these motions would take hours.
#[test]
fn progress_cancels_within_a_motion() {
    let cart = CartPole::default();
    for is_alone in [true, false] {
        let endless = cart.ensemble(3).start(start).until(1e9).threads(2);
        let endless = if is_alone { endless.one_by_one() } else { endless };
        assert_eq!(endless.is_in_lanes(), !is_alone);
        let mut calls = 0;
        let result = endless.progress(|done| {
            calls += 1;
            assert_eq!((done.motions, done.of), (0, 3));
            if calls < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        let Err(EnsembleError::Cancelled { motions: 0 }) = result.run() else { panic!("is cancelled") };
        assert_eq!(calls, 4);
    }
}
