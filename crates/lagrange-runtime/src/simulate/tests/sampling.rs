//! Sampling times.

use std::vec;
use std::vec::Vec;

use super::{Oscillator, START, assert_exact};
use crate::integrate::RungeKutta4;
use crate::simulate::Simulate;
use crate::simulate::builder::default_method;
use crate::simulate::sampling::Grid;
use crate::system::{SettingError, StepFailure};

fn sampled(from: f64, until: f64, every: f64) -> Vec<f64> {
    let run = Oscillator.simulate(START).from(from).until(until).every(every).tolerance(1e-10).run();
    let trajectory = run.expect("runs");
    let (first, last) = (trajectory.first(), trajectory.last());
    assert_eq!((trajectory.state(0), trajectory.state(trajectory.len() - 1)), (Some(first), Some(last)));
    if from.abs() < 1e6 {
        assert_exact(&trajectory, 1e-8);
    }
    trajectory.times().to_vec()
}

#[test]
fn times_are_multiples_of_the_interval_without_accumulation() {
    let times = sampled(0.0, 100.0, 0.1);
    let expected: Vec<f64> = (0..=1000).map(|k| f64::from(k) * 0.1).collect();
    assert_eq!(times, expected);
}

#[test]
fn an_interval_that_does_not_divide_the_span_ends_with_a_shorter_one() {
    assert_eq!(sampled(0.0, 1.0, 0.3), [0.0, 0.3, 0.6, 3.0 * 0.3, 1.0]);
}

#[test]
fn rounding_adds_no_sample_next_to_the_end() {
    // 3 · 0.1 exceeds 0.3, and 3 · 0.7 falls short of 2.1.
    assert_eq!(sampled(0.0, 0.3, 0.1), [0.0, 0.1, 0.2, 0.3]);
    assert_eq!(sampled(0.0, 2.1, 0.7), [0.0, 0.7, 1.4, 2.1]);
}

#[test]
fn time_may_run_backwards() {
    assert_eq!(sampled(1.0, -1.0, 0.5), [1.0, 0.5, 0.0, -0.5, -1.0]);
}

#[test]
fn an_interval_longer_than_the_span_leaves_both_ends() {
    assert_eq!(sampled(2.0, 3.0, 7.0), [2.0, 3.0]);
}

#[test]
fn a_late_start_keeps_times_apart() {
    let times = sampled(1e9, 1e9 + 1.0, 0.1);
    assert_eq!(times.len(), 11);
    assert_eq!((times[0], times[10]), (1e9, 1e9 + 1.0));
    assert!(times.windows(2).all(|pair| (pair[1] - pair[0] - 0.1).abs() < 3e-7));
}

#[test]
fn a_late_start_leads_to_the_same_states() {
    let run = |from: f64| {
        let start = Oscillator.simulate(START).from(from);
        start.lasting(10.0).tolerance(1e-11).run().expect("runs").last()
    };
    let (early, late) = (run(0.0), run(1e9));
    assert!((early[0] - late[0]).abs() < 1e-9 && (early[1] - late[1]).abs() < 1e-9);
}

#[test]
fn a_run_of_no_length_is_one_sample() {
    assert_eq!(sampled(0.7, 0.7, 0.1), [0.7]);
    let trajectory = Oscillator.simulate(START).until(0.0).dense().run().expect("runs");
    assert_eq!(trajectory.times(), [0.0]);
    assert_eq!(trajectory.last(), START);
    assert_eq!(trajectory.at(0.0), Ok(START));
    assert_eq!(trajectory.work().steps, 0);
}

#[test]
fn ends_only_keeps_two_samples() {
    let trajectory = Oscillator.simulate(START).until(10.0).ends_only().run().expect("runs");
    assert_eq!(trajectory.times(), [0.0, 10.0]);
    let last_asked_wins = Oscillator.simulate(START).until(1.0).ends_only().every_step().every(0.5);
    assert_eq!(last_asked_wins.run().expect("runs").len(), 3);
}

#[test]
fn samples_at_the_ends_of_steps_are_the_states_there() {
    let simulation = || Oscillator.simulate(START).until(2.0).method(RungeKutta4 { step: 0.25 });
    let (steps, samples) = (simulation().run().expect("runs"), simulation().every(0.5).run().expect("runs"));
    let every_other: Vec<_> = steps.iter().step_by(2).collect();
    assert_eq!(samples.iter().collect::<Vec<_>>(), every_other);
}

#[test]
fn a_duration_counts_from_the_start() {
    let trajectory = Oscillator.simulate(START).from(3.0).lasting(-2.0).ends_only().run().expect("runs");
    assert_eq!(trajectory.times(), [3.0, 1.0]);
    assert_exact(&trajectory, 1e-8);
}

#[test]
fn intervals_that_make_no_sense_are_refused() {
    for interval in [0.0, -0.1, f64::NAN, f64::INFINITY, 1e-17] {
        let error =
            Oscillator.simulate(START).from(1.0).until(2.0).every(interval).run().expect_err("refused");
        assert!(matches!(error.cause, StepFailure::Setting(_)), "{interval}: {error}");
        assert_eq!(error.trajectory.times(), vec![1.0]);
    }
    let late = Oscillator.simulate(START).from(1e15).until(1e15 + 9.0).every(0.3).run().expect_err("refused");
    assert!(
        matches!(late.cause, StepFailure::Setting(SettingError::Invalid(what)) if what.contains("rounding error")),
        "{late}"
    );
}

#[test]
fn more_samples_than_can_be_kept_are_refused_with_their_number() {
    for (until, interval, samples) in [(2.0, 1e-9, 2e9), (1e15, 100.0, 1e13), (-1e15, 100.0, 1e13)] {
        let error = Oscillator.simulate(START).until(until).every(interval).run().expect_err("too many");
        let StepFailure::Setting(SettingError::TooManySamples { samples: found, .. }) = error.cause else {
            panic!("{error}")
        };
        assert!((found / samples - 1.0).abs() < 1e-9, "{found}");
        assert!(std::format!("{error}").contains(".ends_only()"), "{error}");
        assert_eq!(error.trajectory.work().steps, 0);
    }
}

#[test]
fn instants_are_apart_by_more_than_the_rounding_of_time() {
    let start = 1_048_576.0;
    let is_accepted =
        |roundings: f64| Grid::new([start, start + 1.0], roundings * f64::EPSILON * start).is_ok();
    assert_eq!([2.0, 64.0].map(is_accepted), [false, true]);
}

#[test]
fn the_default_tolerance_is_what_numbers_can_give() {
    assert_eq!(default_method::<f64>().relative, 1e-9);
    assert!((5e-7..3e-6).contains(&default_method::<f32>().relative));
}

#[test]
fn given_times_are_kept_exactly_with_start_and_end() {
    let times = [0.0, 0.1 + 0.2, 0.7, 2.0];
    let run = |end: f64, times: &[f64]| {
        let run =
            Oscillator.simulate(START).until(end).at_times(times.iter().copied()).tolerance(1e-10).run();
        run.map(|trajectory| {
            assert_exact(&trajectory, 1e-8);
            trajectory.times().to_vec()
        })
    };
    assert_eq!(run(2.0, &times).expect("runs"), times);
    assert_eq!(run(2.0, &[1.5]).expect("runs"), [0.0, 1.5, 2.0]);
    assert_eq!(run(2.0, &[]).expect("runs"), [0.0, 2.0]);
    assert_eq!(run(-2.0, &[-0.5, -0.75]).expect("runs"), [0.0, -0.5, -0.75, -2.0]);
    for (end, wrong) in
        [(2.0, [0.5, 0.5]), (2.0, [0.7, 0.5]), (2.0, [0.5, 2.5]), (-1.0, [-0.5, 0.5]), (2.0, [0.5, f64::NAN])]
    {
        let error = run(end, &wrong).expect_err("refused");
        let text = std::format!("{error}");
        assert!(text.starts_with("times of samples must follow each other"), "{text}");
    }
}
