//! Samples of motions in lanes compared with samples of single runs.

use std::string::ToString;
use std::vec::Vec;

use super::{DoublePendulum, Pulse, Root, pendulums};
use crate::ensemble::{Ensemble, Ensembles, KeepSamples, Motion, Samples};
use crate::integrate::{Method, RungeKutta4, Verner98};
use crate::simulate::Undriven;

type Sampled<'a, M, K> = Ensemble<'a, M, K, Undriven, KeepSamples>;

/// Returns the largest difference between samples in lanes and in single runs, `number` per motion.
fn largest_difference<K>(
    ensemble: impl Fn() -> Sampled<'static, DoublePendulum<f64>, K>,
    number: usize,
) -> f64
where
    K: Method<DoublePendulum<f64>> + Clone + Sync,
{
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    let mut largest = 0.0_f64;
    for index in lanes.motions() {
        let [found, expected] =
            [&lanes, &alone].map(|samples| samples.motion(index).expect("is there").expect("ended"));
        assert_eq!((found.len(), found.times(), found.names()), (number, expected.times(), expected.names()));
        for (found, expected) in found.table().columns().zip(expected.table().columns()) {
            let differences = found.iter().zip(expected).map(|(found, expected)| (found - expected).abs());
            largest = differences.fold(largest, f64::max);
        }
    }
    largest
}

const PENDULUM: DoublePendulum<f64> = DoublePendulum { ratio: 0.5, gravity: 9.81 };

#[test]
fn samples_are_those_of_runs_to_within_the_tolerance() {
    for (tolerance, most) in [(1e-6, 2e-5), (1e-9, 2e-8), (1e-12, 2e-11)] {
        let forwards = || {
            pendulums(&PENDULUM, 20).tolerance(tolerance).every(0.01).observe("moment", |_, t, y| t * y[0])
        };
        let difference = largest_difference(forwards, 31);
        assert!(0.0 < difference && difference < most, "{tolerance}: {difference}");
    }
    let equal = || pendulums(&PENDULUM, 20).method(RungeKutta4 { step: 0.02 }).every(0.03);
    let difference = largest_difference(equal, 11);
    assert!(difference < 1e-12, "{difference}");
}

#[test]
fn single_precision_and_backward_time_have_samples_in_lanes_too() {
    let single = DoublePendulum { ratio: 0.5_f32, gravity: 9.81 };
    let ensemble =
        || single.ensemble(9).start(|index, _| [0.1 * index as f32, 1.0, 0.0, 0.0]).until(-1.0).every(0.1);
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    for ((_, found), (_, expected)) in lanes.iter().zip(alone.iter()) {
        assert_eq!((found.len(), found.times()), (11, expected.times()));
        let states = found.states().flatten().zip(expected.states().flatten());
        states.for_each(|(found, expected)| assert!((found - expected).abs() < 1e-4, "{found} {expected}"));
    }
}

#[test]
fn motions_fail_with_the_samples_that_they_have_alone() {
    const ROOT: Root<f64> = Root { end: 1.0 };
    let roots = || {
        let motions = ROOT.ensemble(12).start(|_, _| [0.0, 0.5]);
        motions
            .parameters(|index, root| root.end = if index % 9 == 2 { 0.7 } else { 2.5 })
            .until(2.0)
            .every(0.3)
    };
    let (lanes, alone) = (roots().run().expect("runs"), roots().one_by_one().run().expect("runs"));
    let failures = |samples: &Samples<Root<f64>>| {
        let failures =
            samples.failures().map(|(index, error)| (index, error.to_string(), error.trajectory.len()));
        failures.collect::<Vec<_>>()
    };
    assert_eq!(failures(&lanes).len(), 2);
    assert_eq!(failures(&lanes), failures(&alone));
    assert!(lanes.iter().all(|(_, trajectory)| trajectory.len() == 8));
}

#[test]
fn reductions_see_samples() {
    let number = |ensemble: Sampled<'_, DoublePendulum<f64>, Verner98<f64>>| {
        let reduced = ensemble.reduce(0_usize, |sum, motion| *sum += motion.trajectory().len());
        reduced.expect("runs").into_value()
    };
    let ensemble = || pendulums(&PENDULUM, 70).every(0.1);
    assert_eq!(number(ensemble()), 4 * 70);
    assert_eq!(number(ensemble().every(0.05)), 7 * 70);
}

#[test]
fn steps_that_do_not_tell_states_within_are_taken_back() {
    const PULSE: Pulse<f64> = Pulse { time: 1.0 };
    let pulses = || {
        let motions = PULSE.ensemble(40).start(|_, _| [0.0, 1.0]);
        motions.parameters(|index, pulse| pulse.time = 3.0 + 0.1 * index as f64).until(10.0).tolerance(1e-6)
    };
    let rejections =
        |sum: &mut u64, motion: &Motion<'_, Pulse<f64>>| *sum += motion.trajectory().work().rejections;
    let ends = pulses().reduce(0, rejections).expect("runs").into_value();
    let samples = pulses().every(0.1).reduce(0, rejections).expect("runs").into_value();
    let alone = pulses().every(0.1).one_by_one().reduce(0, rejections).expect("runs").into_value();
    assert!(ends < samples && alone / 2 < samples && samples < 2 * alone, "{ends} {samples} {alone}");
}

#[test]
fn times_of_samples_without_sense_are_errors() {
    let message = |ensemble: Sampled<'_, DoublePendulum<f64>, _>| {
        ensemble.run().map(|_| ()).expect_err("no sense").to_string()
    };
    let positive = "the sampling interval must be positive and finite";
    assert_eq!(message(pendulums(&PENDULUM, 3).every(-0.1)), positive);
    let many = message(pendulums(&PENDULUM, 3).every(1e-10));
    assert!(many.contains("samples exceed the limit"), "{many}");
}
