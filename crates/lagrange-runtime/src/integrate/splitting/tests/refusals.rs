//! States in which the methods stop, and in which they must not.

use std::vec::Vec;

use super::{DRIVEN, Force, KEPLER, PENDULUM, difference};
use crate::integrate::{
    BlanesMoan4, IntegrationError, Method, RungeKutta4, Stepper, StormerVerlet, SymplecticEuler,
};
use crate::run::integrate;
use crate::system::{Component, OdeSystem, StepFailure, Undefined};

/// A unit mass on a spring of stiffness 10⁹.
const STIFF: Force<f64, 1, 2> = Force { acceleration: |_, [x]| [-1e9 * x] };
const FREQUENCY: f64 = 31_622.776_601_683_792;

/// Returns the longest stable step according to a method, if it rejects the motion from `start`.
fn limit<M, K, const N: usize>(system: &M, start: [f64; N], end: f64, method: &K) -> Option<f64>
where
    M: OdeSystem<Scalar = f64, State = [f64; N]>,
    K: Method<M>,
{
    let largest = start.iter().fold(0.0_f64, |largest, y| largest.max(y.abs()));
    let outcome = integrate(system, 0.0, start, end, method, |_, y| {
        assert!(y.iter().all(|y| y.abs() <= 10.0 * largest * FREQUENCY), "{y:?} from {start:?}");
    });
    match outcome {
        Err(IntegrationError { cause: StepFailure::StepTooLong { limit, .. }, .. }) => Some(limit),
        Err(error) => panic!("{error}"),
        Ok(_) => None,
    }
}

/// Tests a method whose longest stable step is `$stable` divided by the frequency.
macro_rules! stiffness_is_refused {
    ($name:ident, $method:ident, $stable:literal) => {
        #[test]
        fn $name() {
            let named = limit(&STIFF, [1e-3, 0.0], 1.0, &$method { step: 1e-3 }).expect("refused");
            assert!((named * FREQUENCY / $stable - 1.0).abs() < 0.01, "{named}");
            let moving = limit(&STIFF, [0.0, 1.0], 1.0, &$method { step: 1e-3 }).expect("refused");
            assert!((moving * FREQUENCY / $stable - 1.0).abs() < 0.01, "{moving}");
            assert_eq!(limit(&STIFF, [1e-3, 0.0], 0.1, &$method { step: 0.97 * named }), None);
            let beyond = limit(&STIFF, [1e-3, 0.0], 0.1, &$method { step: 1.03 * named });
            assert!((beyond.expect("refused") / named - 1.0).abs() < 0.01);
        }
    };
}

stiffness_is_refused!(symplectic_euler_refuses_stiff_springs, SymplecticEuler, 2.0);
stiffness_is_refused!(stormer_verlet_refuses_stiff_springs, StormerVerlet, 2.0);
stiffness_is_refused!(blanes_moan_refuses_stiff_springs, BlanesMoan4, 3.16);
stiffness_is_refused!(runge_kutta_refuses_stiff_springs, RungeKutta4, 2.785);

#[test]
fn stiffness_is_refused_in_single_precision() {
    let stiff: Force<f32, 1, 2> = Force { acceleration: |_, [x]| [-1e9 * x] };
    let limits = [
        integrate(&stiff, 0.0, [1e-3, 0.0], 1.0, &StormerVerlet { step: 1e-3 }, |_, _| {}),
        integrate(&stiff, 0.0, [1e-3, 0.0], 1.0, &RungeKutta4 { step: 1e-3 }, |_, _| {}),
    ];
    for (outcome, stable) in limits.into_iter().zip([2.0, 2.785]) {
        let cause = outcome.expect_err("refused").cause;
        let near = |limit: f32| (f64::from(limit) * FREQUENCY / stable - 1.0).abs() < 0.01;
        assert!(matches!(cause, StepFailure::StepTooLong { limit, .. } if near(limit)), "{cause:?}");
    }
}

#[test]
fn the_state_of_a_refused_step_is_the_one_before() {
    let start = [1e-3, 0.0];
    let outcome = integrate(&STIFF, 5.0, start, 6.0, &StormerVerlet { step: 1e-3 }, |_, _| {});
    let error = outcome.expect_err("refused");
    assert_eq!((error.time, error.state), (5.0, start));
}

#[test]
fn a_stiff_part_at_rest_is_found_before_it_shows() {
    /// A pendulum and a stiff spring that the pendulum hardly excites.
    const BOTH: Force<f64, 2, 4> = Force { acceleration: |_, [x, y]| [-x.sin(), -1e9 * y + 1e-3 * x] };
    let outcome = integrate(&BOTH, 0.0, [1.0, 0.0, 0.0, 0.0], 10.0, &StormerVerlet { step: 1e-3 }, |_, _| {});
    let error = outcome.expect_err("refused");
    assert!(
        matches!(error.cause, StepFailure::StepTooLong { limit, .. } if (limit * FREQUENCY / 2.0 - 1.0).abs() < 0.01)
    );
    assert!(error.state[1].abs() < 1e-2, "{error:?}");
}

#[test]
fn fast_relaxation_is_refused_as_well() {
    /// ẏ = −10⁶ (y − cos t)
    struct Relaxation;

    impl OdeSystem for Relaxation {
        type Scalar = f64;
        type State = [f64; 1];

        fn rhs(&self, t: f64, [y]: &[f64; 1]) -> [f64; 1] {
            [-1e6 * (y - t.cos())]
        }
    }

    let named = limit(&Relaxation, [1.0], 1.0, &RungeKutta4 { step: 1e-3 }).expect("refused");
    assert!((named / 2.785e-6 - 1.0).abs() < 0.01, "{named}");
    assert_eq!(limit(&Relaxation, [1.0], 1e-3, &RungeKutta4 { step: 2.7e-6 }), None);
}

#[test]
fn growth_is_not_stiffness() {
    /// ẏ = y
    struct Growth;

    impl OdeSystem for Growth {
        type Scalar = f64;
        type State = [f64; 1];

        fn rhs(&self, _t: f64, y: &[f64; 1]) -> [f64; 1] {
            *y
        }
    }

    let upright: Force<f64, 1, 2> = Force { acceleration: |_, [x]| [*x] };
    assert_eq!(limit(&upright, [1e-3, 0.0], 10.0, &StormerVerlet { step: 2.5 }), None);
    assert_eq!(limit(&Growth, [1e-3], 10.0, &RungeKutta4 { step: 3.0 }), None);
}

#[test]
fn scales_of_coordinates_are_not_stiffness() {
    /// Two coupled oscillators with frequencies 1 and √3. One coordinate is measured in millionths
    /// of the unit of the other.
    const SCALED: Force<f64, 2, 4> =
        Force { acceleration: |_, [x, y]| [1e-6 * y - 2.0 * x, 1e6 * x - 2.0 * y] };
    let start = [1.0, 0.5e6, 0.0, 0.0];
    assert_eq!(limit(&SCALED, start, 50.0, &StormerVerlet { step: 0.1 }), None);
    assert_eq!(limit(&SCALED, start, 50.0, &RungeKutta4 { step: 0.1 }), None);
    assert_eq!(limit(&SCALED, start, 50.0, &BlanesMoan4 { step: 1.0 }), None);
}

#[test]
fn fast_forces_and_close_encounters_are_not_stiffness() {
    let shaken: Force<f64, 1, 2> = Force { acceleration: |t, [x]| [1e3 * (900.0 * t).sin() - x] };
    assert_eq!(limit(&shaken, [1.0, 0.0], 10.0, &StormerVerlet { step: 5e-3 }), None);
    assert_eq!(limit(&shaken, [1.0, 0.0], 10.0, &RungeKutta4 { step: 5e-3 }), None);
    let comet = [0.01, 0.0, 0.0, (2.0_f64 / 0.01 - 1.0).sqrt()];
    assert_eq!(limit(&KEPLER, comet, 13.0, &StormerVerlet { step: 1e-4 }), None);
    assert_eq!(limit(&KEPLER, comet, 13.0, &BlanesMoan4 { step: 5e-4 }), None);
    assert_eq!(limit(&KEPLER, comet, 13.0, &RungeKutta4 { step: 2e-4 }), None);
}

#[test]
fn nan_stops_at_the_last_good_state() {
    let fading: Force<f64, 1, 2> = Force { acceleration: |t, _| [(1.0 - t).sqrt()] };
    let mut good = Vec::new();
    let outcome =
        integrate(&fading, 0.0, [0.0, 0.0], 2.0, &StormerVerlet { step: 0.125 }, |t, y| good.push((t, *y)));
    let (time, state) = good[good.len() - 1];
    let error = outcome.expect_err("NaN");
    assert_eq!((error.time, error.state), (time, state));
    let StepFailure::Undefined(Undefined::Rate { component: Component::Index(1), time: later, value }) =
        error.cause
    else {
        panic!("{error}")
    };
    assert!(value.is_nan() && later > 1.0 && later < 1.0 + 1e-12, "{later}");
    assert_eq!(time, 1.0);
}

#[test]
fn a_failed_step_leaves_nothing_behind() {
    let gap: Force<f64, 1, 2> = Force { acceleration: |t, [x]| [if t > 0.35 { f64::NAN } else { -x }] };
    let method = BlanesMoan4 { step: 0.1 };
    let mut stepper = method.start(&gap, 0.0, &[1.0, 0.0], 1.0).expect("valid");
    for _ in 0..3 {
        stepper.step(&gap, 1.0).expect("before the gap");
    }
    let (before, halfway) = (*stepper.state(), stepper.interpolate(&gap, 0.25));
    assert_eq!(stepper.step(&gap, 1.0), Err(StepFailure::NotFinite));
    assert_eq!((*stepper.state(), stepper.interpolate(&gap, 0.25)), (before, halfway));
    let mut again = method.start(&gap, stepper.time(), &before, 1.0).expect("valid");
    stepper.step(&gap, 0.34).expect("a shorter step");
    again.step(&gap, 0.34).expect("a shorter step");
    assert!(difference(stepper.state(), again.state()) < 1e-16);
}

#[test]
fn after_a_restart_nothing_old_is_used() {
    let method = StormerVerlet { step: 0.1 };
    let mut stepper = method.start(&PENDULUM, 0.0, &[1.0, 0.0], 10.0).expect("valid");
    stepper.step(&PENDULUM, 10.0).expect("stable");
    let (t, other) = (stepper.time(), [-0.5, 2.0]);
    stepper.restart(&PENDULUM, t, &other).expect("finite");
    let mut fresh = method.start(&PENDULUM, t, &other, 10.0).expect("valid");
    stepper.step(&PENDULUM, 10.0).expect("stable");
    fresh.step(&PENDULUM, 10.0).expect("stable");
    assert_eq!(stepper.state(), fresh.state());
    assert_eq!(stepper.restart(&PENDULUM, t, &[f64::NAN, 0.0]), Err(StepFailure::NotFinite));
}

#[test]
fn late_times_cost_no_more_than_their_rounding() {
    let late: Force<f64, 1, 2> = Force { acceleration: |t, [x]| [(t - 1e9).cos() - 4.0 * x] };
    let mut steps = 0;
    let method = BlanesMoan4 { step: 0.01 };
    let end = integrate(&late, 1e9, [0.0, 0.0], 1e9 + 10.0, &method, |_, _| steps += 1).expect("finite");
    let exact = integrate(&DRIVEN, 0.0, [0.0, 0.0], 10.0, &method, |_, _| {}).expect("finite");
    assert!(difference(&end, &exact) < 2e-8, "{end:?} {exact:?}");
    assert_eq!(steps, 1001);
}

#[test]
fn steps_shorter_than_the_rounding_of_time_are_refused() {
    let fall = |step| {
        integrate(&PENDULUM, 1e9, [1.0, 1.0], 1e9 + 1e-4, &StormerVerlet { step }, |_, _| {})
            .map_err(|error| (error.cause, error.state))
    };
    let [angle, _] = fall(1e-6).expect("finite");
    assert!((angle - 1.0 - 1e-4).abs() < 2e-7, "{angle}");
    let refused = StepFailure::StepLost { step: 1e-8, time: 1e9 };
    assert_eq!(fall(1e-8), Err((refused, [1.0, 1.0])));
}

#[test]
fn spans_without_length_are_the_start_alone() {
    let start = [0.3, -1.2];
    assert_eq!(integrate(&PENDULUM, 2.0, start, 2.0, &SymplecticEuler { step: 0.1 }, |_, _| {}), Ok(start));
}
