//! Taylor series in lanes, compared with references, closed forms and single runs.

use std::f64::consts::TAU;

use lagrange::Ensembles;
use lagrange::ensemble::{Ensemble, Failure, SharedSystem};
use lagrange::integrate::{StepFailure, Taylor};
use lagrange::system::TaylorSystem;

use crate::references::{Numbers, state};

lagrange::system! {
    /// Two equal masses on rods.
    #[derive(Clone)]
    struct Pair<S>;

    param m = 1.0, l = 1.0, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l * sin(theta1), -l * cos(theta1));
    let (x2, y2) = (x1 + l * sin(theta2), y1 - l * cos(theta2));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2);
    potential = m * g * y1 + m * g * y2;
    emit { lanes, taylor }
}

lagrange::system! {
    /// A planet around a fixed sun.
    #[derive(Clone)]
    struct Planet;

    param mu = 1.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -mu / hypot(x, y);
    emit { lanes, taylor }
}

lagrange::system! {
    /// A mass on a spring, pushed back and forth.
    #[derive(Clone)]
    struct Shaken;

    param w = 2.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    force x = cos(w * t);
    emit { lanes, taylor }
}

lagrange::system! {
    /// A wheel on a motor with inductance.
    #[derive(Clone)]
    struct Motor;

    param k = 0.3, r = 1.5, inductance = 0.05;
    coord theta;
    state current;
    kinetic = 1/2 * dot(theta)^2;
    potential = 1/2 * theta^2;
    force theta = k * current;
    dot(current) = (1 - r * current - k * dot(theta)) / inductance;
    emit { lanes, taylor }
}

lagrange::system! {
    /// Four masses on rods.
    #[derive(Clone)]
    struct Chain;

    const n = 4;
    param m[n] = 0.1, l[n] = 0.1, g = 9.81;
    coord theta[n];
    let p[0] = (0, 0);
    for i in 0..n {
        let p[i+1] = p[i] + l[i] * (sin(theta[i]), -cos(theta[i]));
        kinetic = kinetic_energy(m[i], dot(p[i+1]));
        potential = gravitational_energy(m[i], g, p[i+1].y);
    }
    emit { lanes, taylor }
}

lagrange::system! {
    /// A mass whose force is undefined after a time.
    #[derive(Clone)]
    struct Root;

    param end = 1.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = sqrt(end - t);
    emit { lanes, taylor }
}

lagrange::system! {
    /// A mirror on a spring, which must not turn far.
    #[derive(Clone)]
    struct Mirror;

    param k = 1;
    coord tilt in -2e-6..=2e-6 nominal 1e-6;
    kinetic = 1/2 * dot(tilt)^2;
    potential = 1/2 * k * tilt^2;
    emit { lanes, taylor }
}

lagrange::system! {
    /// A mass on a spring from a table.
    #[derive(Clone)]
    struct Tabled;

    table spring(x) = [(-2, 3), (-1, 1), (0, 0), (1, -1), (2, -3)], interpolation: natural, outside: extend;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = spring(x);
    emit { lanes, taylor }
}

lagrange::system! {
    /// A tank that drains and remains empty.
    #[derive(Clone)]
    struct Tank;

    coord x;
    state level;
    kinetic = 1/2 * dot(x)^2;
    dot(level) = -sqrt(level);
    emit { lanes, taylor }
}

type Series<'a, M> = Ensemble<'a, M, Taylor<f64>>;

/// Returns the largest difference of ends in lanes and in single runs.
fn difference<M: SharedSystem<Scalar = f64> + TaylorSystem + 'static>(
    ensemble: impl Fn() -> Series<'static, M>,
) -> f64 {
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    assert!(lanes.failures().is_empty() && alone.failures().is_empty());
    let columns = lanes.table().columns().zip(alone.table().columns());
    let differences = columns.flat_map(|(found, expected)| found.iter().zip(expected));
    differences.fold(0.0, |most, (found, expected)| most.max((found - expected).abs()))
}

/// Returns chaotic double pendulums; the first has a reference.
fn pairs(number: usize, tolerance: f64) -> Series<'static, Pair<f64>> {
    static PAIR: Pair<f64> = Pair { m: 1.0, l: 1.0, g: 9.81 };
    let start = |index, _: &mut _| [2.0 - 0.01 * index as f64, 1.5, 0.0, 0.0];
    PAIR.ensemble(number).start(start).until(10.0).method(Taylor::tolerance(tolerance))
}

#[test]
fn chaotic_motions_reach_their_references() {
    let expected: [f64; 4] = state("double_pendulum", Numbers::Binary, 10.0);
    for (tolerance, most) in [(1e-6, 1e-4), (1e-9, 1e-7), (1e-12, 1e-10), (1e-14, 2e-12)] {
        assert!(pairs(17, tolerance).is_in_lanes());
        let [one, many] = [1, 17].map(|number| pairs(number, tolerance).run().expect("runs"));
        let found = many.state(0).expect("ended");
        let error = found.iter().zip(expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(error < most, "{tolerance:e}: {error:e}");
        assert_eq!(one.state(0).map(|state| state.map(f64::to_bits)), Some(found.map(f64::to_bits)));
    }
}

#[test]
fn orbits_close_forwards_and_backwards() {
    static PLANET: Planet = Planet { mu: 1.0 };
    let radius = |index: usize| 0.4 + 0.02 * index as f64;
    let fast = |index: usize| (2.0 / radius(index) - 1.0).sqrt();
    let start = move |index, _: &mut _| [radius(index), 0.0, 0.0, fast(index)];
    for end in [TAU, -3.0 * TAU] {
        let ensemble = PLANET.ensemble(17).start(start).until(end).method(Taylor::tolerance(1e-14));
        assert!(ensemble.is_in_lanes());
        let ends = ensemble.run().expect("runs");
        for index in 0..17 {
            let [x, y, ..] = ends.state(index).expect("ended");
            let error = (x - radius(index)).hypot(y);
            assert!(error < 3e-12, "{index} until {end}: {error:e}");
        }
    }
}

/// Motions with other parameters, and samples in between: x = (cos w t − cos t)/(1 − w²).
#[test]
fn forces_that_depend_on_time_and_parameters_have_exact_samples() {
    let shaken = Shaken::default();
    let of = |index: usize| 1.5 + 0.1 * index as f64;
    for end in [6.0, -6.0] {
        let motions = shaken.ensemble(19).start(|_, _| [0.0, 0.0]);
        let motions = motions.parameters(|index, shaken| shaken.w = of(index)).until(end);
        let ensemble = motions.method(Taylor::tolerance(1e-13)).every(0.25);
        assert!(ensemble.is_in_lanes());
        let samples = ensemble.run().expect("runs");
        assert_eq!(samples.len(), 19);
        for (index, trajectory) in samples.iter() {
            let w = of(index);
            assert_eq!(trajectory.len(), 25);
            for (t, x) in trajectory.times().iter().zip(trajectory.x()) {
                let expected = ((w * t).cos() - t.cos()) / (1.0 - w * w);
                assert!((x - expected).abs() < 1e-12, "{w} at {t}: {x} {expected}");
            }
        }
    }
}

#[test]
fn first_order_states_and_mass_matrices_agree_with_single_runs() {
    static MOTOR: Motor = Motor { k: 0.3, r: 1.5, inductance: 0.05 };
    let motors = || {
        let motions = MOTOR.ensemble(9).start(|index, _| [0.1 * index as f64, -1.0, 0.0]);
        let motions = motions.parameters(|index, motor| motor.k = 0.1 * index as f64).until(1.0);
        motions.method(Taylor::tolerance(1e-12))
    };
    let largest = difference(motors);
    assert!(largest < 1e-12, "{largest:e}");
    static CHAIN: Chain = Chain { m: [0.1; 4], l: [0.1; 4], g: 9.81 };
    let chains = || {
        let start = |index: usize, _: &mut _| {
            std::array::from_fn(|entry| if entry < 4 { 0.3 + 0.02 * index as f64 } else { 0.0 })
        };
        CHAIN.ensemble(11).start(start).until(1.0).method(Taylor::tolerance(1e-12))
    };
    let largest = difference(chains);
    assert!(0.0 < largest && largest < 1e-9, "{largest:e}");
}

#[test]
fn single_precision_has_series_in_lanes() {
    let pair = Pair::<f32>::default();
    let ensemble = || {
        let motions = pair.ensemble(10).start(|index, _| [0.1 * index as f32, 0.3, 0.0, 0.0]).until(2.0);
        motions.method(Taylor::tolerance(1e-6))
    };
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    assert!(lanes.failures().is_empty());
    for (found, expected) in lanes.table().columns().zip(alone.table().columns()) {
        assert!(found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 3e-4));
    }
}

/// Asserts that motions fail in lanes as they do alone, and returns the indices.
fn failures<M: SharedSystem<Scalar = f64> + TaylorSystem + 'static>(
    ensemble: impl Fn() -> Series<'static, M>,
) -> Vec<usize> {
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    let texts = |failures: &[Failure<M>]| failures.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(texts(lanes.failures()), texts(alone.failures()));
    for index in 0..lanes.len() {
        assert_eq!(lanes.state(index).is_some(), alone.state(index).is_some());
    }
    lanes.failures().iter().map(|failure| failure.index).collect()
}

#[test]
fn motions_fail_as_they_do_alone() {
    static ROOT: Root = Root { end: 1.0 };
    let roots = || {
        let motions = ROOT.ensemble(12).start(|index, _| [if index == 4 { f64::NAN } else { 0.0 }, 0.5]);
        let motions = motions.parameters(|index, root| root.end = if index % 9 == 2 { 0.7 } else { 2.5 });
        motions.until(2.0).method(Taylor::tolerance(1e-9))
    };
    assert_eq!(failures(roots), [2, 4, 11]);
    static SHAKEN: Shaken = Shaken { w: 2.0 };
    let hurried = |most: u64| {
        let motions = SHAKEN.ensemble(9).start(|index, _| [0.1 * index as f64, 1.0]);
        let motions = motions.parameters(|index, shaken| shaken.w = if index == 7 { 400.0 } else { 2.0 });
        motions.until(20.0).method(Taylor::tolerance(1e-9)).max_steps(most)
    };
    assert_eq!(failures(|| hurried(100)), [7]);
    assert_eq!(failures(|| hurried(3)).len(), 9);
    static MIRROR: Mirror = Mirror { k: 1.0 };
    let mirrors = || {
        let start = |index: usize, _: &mut _| [0.0, if index % 3 == 1 { 5e-6 } else { 9e-8 * index as f64 }];
        MIRROR.ensemble(20).start(start).until(9.0).method(Taylor::tolerance(1e-9))
    };
    assert_eq!(failures(mirrors), [1, 4, 7, 10, 13, 16, 19]);
}

#[test]
fn stiff_motions_are_refused_among_others() {
    static MOTOR: Motor = Motor { k: 0.3, r: 1.5, inductance: 0.05 };
    let motors = || {
        let motions = MOTOR.ensemble(9).start(|index, _| [0.1 * index as f64, -1.0, 0.0]);
        let motions =
            motions.parameters(|index, motor| motor.inductance = if index == 3 { 1e-5 } else { 0.05 });
        motions.until(2000.0).method(Taylor::tolerance(1e-8))
    };
    assert_eq!(failures(motors), [3]);
    let ends = motors().run().expect("runs");
    assert!(matches!(ends.failures()[0].cause, StepFailure::Stiff { .. }), "{:?}", ends.failures());
}

/// The level (1 − t/2)² is left to a single run where it reaches zero.
#[test]
fn tanks_remain_empty() {
    let tank = Tank;
    let start = |index, _: &mut _| [0.0, 1.0 + 0.1 * index as f64, 0.0];
    let ensemble = tank.ensemble(5).start(start).until(4.0).method(Taylor::tolerance(1e-9));
    assert!(ensemble.is_in_lanes());
    let ends = ensemble.run().expect("runs");
    let levels = ends.column("level").expect("there");
    assert!(levels.iter().all(|level| level.abs() < 1e-9), "{levels:?}");
}

#[test]
fn steps_end_at_points_of_tables_in_single_runs_only() {
    let tabled = Tabled;
    let motions = || tabled.ensemble(3).start(|index, _| [1.5 + 0.1 * index as f64, 0.0]).until(3.0);
    assert!(motions().is_in_lanes());
    let series = || motions().method(Taylor::tolerance(1e-12));
    assert!(!series().is_in_lanes());
    let (ends, alone) = (series().run().expect("runs"), series().one_by_one().run().expect("runs"));
    assert_eq!(ends.x(), alone.x());
}
