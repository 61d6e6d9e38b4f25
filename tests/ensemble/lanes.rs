//! Emitted systems in lanes.

use lagrange::Ensembles;
use lagrange::ensemble::Random;
use lagrange::integrate::{RungeKutta4, StormerVerlet};
use lagrange::scalar::Scalar;
use lagrange::system::Direction;

lagrange::system! {
    /// A pendulum on a cart.
    #[derive(Clone)]
    pub(crate) struct CartPole;

    param m_cart = 1.0, m = 0.1, l = 0.5, g = 9.81;
    coord x, theta;

    let (x_bob, y_bob) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * m_cart * dot(x)^2 + 1/2 * m * (dot(x_bob)^2 + dot(y_bob)^2);
    potential = m * g * y_bob;
    emit { lanes }
}

lagrange::system! {
    /// A mass that is pushed.
    struct Pushed;

    coord x;
    input u;
    kinetic = 1/2 * dot(x)^2;
    force x = u;
    emit { lanes }
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
    emit { lanes }
}

lagrange::system! {
    /// A mirror on a spring, which must not turn far.
    #[derive(Clone)]
    struct Mirror<S>;

    param k = 1;
    coord tilt in -2e-6..=2e-6 nominal 1e-6;
    kinetic = 1/2 * dot(tilt)^2;
    potential = 1/2 * k * tilt^2;
    emit { lanes }
}

fn start(index: usize, random: &mut Random) -> [f64; 4] {
    [if index == 3 { f64::NAN } else { 0.0 }, random.uniform(-2.0..2.0), 0.0, 0.1]
}

#[test]
fn ends_are_those_of_runs_to_within_the_tolerance() {
    let cart = CartPole::default();
    let ensemble = || {
        let motions =
            cart.ensemble(20).start(start).parameters(|index, cart| cart.l = 0.3 + 0.01 * index as f64);
        motions.until(1.0).tolerance(1e-9).energy()
    };
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    assert_eq!(lanes.names(), alone.names());
    assert_eq!((lanes.failures().len(), lanes.failures()[0].index), (1, 3));
    assert_eq!(lanes.column("l"), alone.column("l"));
    for (found, expected) in lanes.table().columns().zip(alone.table().columns()) {
        for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
            let is_near = (found - expected).abs() < 1e-8;
            assert!(
                is_near || (found.is_nan() && expected.is_nan() && index == 3),
                "{index}: {found} {expected}"
            );
        }
    }
    let equal = || ensemble().method(RungeKutta4 { step: 0.01 });
    let (lanes, alone) = (equal().run().expect("runs"), equal().one_by_one().run().expect("runs"));
    for (found, expected) in lanes.theta().iter().zip(alone.theta()) {
        assert!(
            (found - expected).abs() < 1e-13 || (found.is_nan() && expected.is_nan()),
            "{found} {expected}"
        );
    }
}

#[test]
fn inputs_that_change_and_events_are_left_to_runs() {
    let pushed = Pushed { u: 2.0 };
    let ensemble = || pushed.ensemble(3).start(|_, _| [0.0, 0.0]).until(1.0);
    assert!(ensemble().is_in_lanes());
    let ends = ensemble().run().expect("runs");
    assert!(ends.x().iter().all(|x| (x - 1.0).abs() < 1e-12), "{:?}", ends.x());

    let law = || ensemble().drive(|_, t, _| PushedInputs { u: 6.0 * t });
    assert!(!law().is_in_lanes());
    let ends = law().run().expect("runs");
    assert!(ends.x().iter().all(|x| (x - 1.0).abs() < 1e-9), "{:?}", ends.x());
    assert!(!ensemble().sampled(0.1, |_| |_: &Pushed, _, _| PushedInputs { u: 0.0 }).is_in_lanes());

    let stopped = || ensemble().stop_at("half", Direction::Crossing, |_, _, y| y[0] - 0.5);
    assert!(!stopped().is_in_lanes());
    let ends = stopped().run().expect("runs");
    assert!(ends.x().iter().all(|x| (x - 0.5).abs() < 1e-9), "{:?}", ends.x());
}

#[test]
fn samples_of_symplectic_methods_go_in_lanes() {
    let pushed = Pushed { u: 2.0 };
    let motions = pushed.ensemble(3).start(|_, _| [0.0, 0.0]).until(1.0);
    let ensemble = motions.method(StormerVerlet { step: 0.1 }).every(0.25);
    assert!(ensemble.is_in_lanes());
    let samples = ensemble.run().expect("runs");
    assert_eq!((samples.len(), samples.failures().count()), (3, 0));
    for (_, trajectory) in samples.iter() {
        assert_eq!(trajectory.times(), [0.0, 0.25, 0.5, 0.75, 1.0]);
        let errors = trajectory.times().iter().zip(trajectory.x()).map(|(t, x)| (x - t * t).abs());
        assert!(errors.fold(0.0, f64::max) < 1e-14, "{:?}", trajectory.x());
    }
}

/// Returns the amplitude of a mirror; every third one turns too far.
fn amplitude(index: usize) -> f64 {
    if index % 3 == 1 { 5e-6 } else { 9e-8 * index as f64 }
}

/// Motions that stay are accurate to their nominal value, whatever others do. Those that leave the
/// range fail as they do alone.
#[test]
fn ranges_are_checked_in_each_lane() {
    check_ranges::<f64>(1e-9, 1e-13);
    check_ranges::<f32>(1e-5, 1e-10);
}

fn check_ranges<S: Scalar + Into<f64> + Send + Sync>(tolerance: f64, largest_error: f64) {
    let (mirror, number) = (Mirror::<S>::default(), S::from_f64);
    let motions = |count: usize| {
        let tilt = |index| if index == 6 { 3e-6 } else { 0.0 };
        let start = move |index, _: &mut Random| [tilt(index), amplitude(index)].map(number);
        mirror.ensemble(count).start(start).until(number(9.0)).tolerance(number(tolerance))
    };
    assert!(motions(21).is_in_lanes());
    let (lanes, few) = (motions(21).run().expect("runs"), motions(5).run().expect("runs"));
    let (alone, samples) =
        (motions(21).one_by_one().run().expect("runs"), motions(21).every(number(0.5)).run().expect("runs"));
    let failures = |failures: &[lagrange::ensemble::Failure<Mirror<S>>]| {
        failures.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(failures(lanes.failures()), failures(alone.failures()));
    assert_eq!(samples.failures().count(), lanes.failures().len());
    let failed = lanes.failures().iter().map(|failure| failure.index).collect::<Vec<_>>();
    assert_eq!(failed, [1, 4, 6, 7, 10, 13, 16, 19]);
    for index in (0..21).filter(|index| !failed.contains(index)) {
        let error: f64 = Into::<f64>::into(lanes.tilt()[index]) - amplitude(index) * 9.0_f64.sin();
        assert!(error.abs() < largest_error, "{index}: {error}");
        assert!(few.tilt().get(index).is_none_or(|tilt| *tilt == lanes.tilt()[index]));
    }
    let fixed = motions(21).method(RungeKutta4 { step: number(0.01) });
    assert!(fixed.is_in_lanes());
    assert_eq!(fixed.run().expect("runs").failures().len(), failed.len());
}

/// Uniform numbers between −2e-6 and 2e-6 have the mean square 4e-12/3. It is estimated with a
/// standard error of 2/√(5 n) of it.
#[test]
fn starts_are_uniform_within_ranges() {
    let mirror = Mirror::<f64>::default();
    let motions = |seed| mirror.ensemble(4000).start_within_ranges([1.0, 3e-7]).until(0.0).seed(seed);
    let ends = motions(5).run().expect("runs");
    assert!(ends.failures().is_empty() && ends.tilt_dot().iter().all(|rate| *rate == 3e-7));
    let tilts = ends.tilt();
    assert!(tilts.iter().all(|tilt| tilt.abs() <= 2e-6));
    let square = tilts.iter().map(|tilt| tilt * tilt).sum::<f64>() / 4000.0 / (4e-12 / 3.0);
    assert!((square - 1.0).abs() < 3.0 * 2.0 / (5.0 * 4000.0_f64).sqrt(), "{square}");
    assert_ne!(motions(6).run().expect("runs").tilt(), tilts);
}

#[cfg(feature = "parquet")]
#[test]
fn files_do_not_mix_lanes_with_runs() {
    use lagrange::ensemble::EnsembleError;

    let folder = std::env::temp_dir().join(format!("lagrange_lanes_{}", std::process::id()));
    let cart = CartPole::default();
    let ensemble = || cart.ensemble(20).start(start).until(0.5).motions_per_part(7);
    assert_eq!(ensemble().save_parquet(&folder).expect("saves").written, 3);
    let again = ensemble().save_parquet(&folder).expect("is there");
    let refused = ensemble().one_by_one().save_parquet(&folder);
    std::fs::remove_dir_all(&folder).expect("was there");
    assert_eq!((again.written, again.found), (0, 3));
    let Err(EnsembleError::OtherEnsemble { differs: [there, _], .. }) = refused else {
        panic!("{refused:?}")
    };
    assert!(there.starts_with("in lanes, products "), "{there}");
}

#[test]
fn first_order_states_go_in_lanes() {
    let motor = Motor::default();
    let ensemble = || {
        let motions = motor.ensemble(9).start(|index, _| [0.1 * index as f64, -1.0, 0.0]);
        motions.parameters(|index, motor| motor.k = 0.1 * index as f64).until(1.0).tolerance(1e-10)
    };
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().expect("runs"), ensemble().one_by_one().run().expect("runs"));
    let named = |name: &str| (lanes.column(name).expect("there"), alone.column(name).expect("there"));
    for (found, expected) in ["theta", "current", "theta_dot"].map(named) {
        assert!(found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-9));
    }
}
