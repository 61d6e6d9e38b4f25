//! Samples of motions in lanes beside those of runs by themselves.

use super::{DoublePendulum, pendulums};
use crate::ensemble::{Ensemble, KeepSamples};
use crate::integrate::{Method, RungeKutta4};
use crate::simulate::Undriven;

type Sampled<'a, M, K> = Ensemble<'a, M, K, Undriven, KeepSamples>;

/// The largest difference between samples in lanes and those of runs, of which there are so many for each motion.
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
