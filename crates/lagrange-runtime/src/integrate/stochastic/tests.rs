//! Steps with noise for handwritten systems.

use std::vec::Vec;

use super::euler_maruyama::EulerMaruyamaScheme;
use super::runge_kutta::StochasticRungeKutta4Scheme;
use super::{EulerMaruyama, MAX_NOISES, Scheme, StepPath, StochasticRungeKutta4, WienerPath};
use crate::integrate::method::{Method, Stepper, Work};
use crate::integrate::{RungeKutta4, Verner98};
use crate::linalg::vector::StateVector;
use crate::scalar::Scalar;
use crate::system::{NoiseKind, OdeSystem, SettingError, StepFailure, WhiteNoise};

/// ẍ = −4 x − ẋ + w
struct Oscillator<S>(core::marker::PhantomData<S>);

impl<S: Scalar> OdeSystem for Oscillator<S> {
    type Scalar = S;
    type State = [S; 2];

    fn rhs(&self, _t: S, [x, v]: &[S; 2]) -> [S; 2] {
        [*v, -S::from_f64(4.0) * *x - *v]
    }

    fn noise(&self) -> WhiteNoise {
        WhiteNoise { count: 1, kind: NoiseKind::Additive }
    }

    fn diffuse(&self, _t: S, _y: &[S; 2], increments: &[S]) -> [S; 2] {
        [S::ZERO, increments[0]]
    }
}

const OSCILLATOR: Oscillator<f64> = Oscillator(core::marker::PhantomData);

/// ẏ = w, with a kind chosen by a test.
struct Wiener(NoiseKind);

impl OdeSystem for Wiener {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn noise(&self) -> WhiteNoise {
        WhiteNoise { count: 1, kind: self.0 }
    }

    fn diffuse(&self, _t: f64, _y: &[f64; 1], increments: &[f64]) -> [f64; 1] {
        [increments[0]]
    }
}

const WIENER: Wiener = Wiener(NoiseKind::Additive);

/// Returns the change of a state in a step along this path.
fn change<F: Scheme<Oscillator<f64>>>(y: [f64; 2], h: f64, part: [f64; 2]) -> [f64; 2] {
    let mut path = StepPath { count: 1, parts: [[0.0; 2]; MAX_NOISES] };
    path.parts[0] = part;
    F::increment(&OSCILLATOR, 0.0, &y, h, &path, &mut Work::default())
}

/// Computes the stationary covariance [⟨x²⟩, ⟨x v⟩, ⟨v²⟩] of steps without random numbers. A step
/// multiplies the state by R and adds a W + b H.
fn stationary<F: Scheme<Oscillator<f64>>>(h: f64) -> [f64; 3] {
    let [[a, c], [b, d]] = [[1.0, 0.0], [0.0, 1.0]].map(|unit: [f64; 2]| {
        let [x, v] = change::<F>(unit, h, [0.0; 2]);
        [unit[0] + x, unit[1] + v]
    });
    let [w, k] = [[1.0, 0.0], [0.0, 1.0]].map(|part| change::<F>([0.0; 2], h, part));
    let added = |i: usize, j: usize| h * w[i] * w[j] + h / 12.0 * k[i] * k[j];
    let mut covariance = [0.0; 3];
    for _ in 0..(60.0 / h) as usize {
        let [xx, xv, vv] = covariance;
        covariance = [
            a * a * xx + 2.0 * a * b * xv + b * b * vv + added(0, 0),
            a * c * xx + (a * d + b * c) * xv + b * d * vv + added(0, 1),
            c * c * xx + 2.0 * c * d * xv + d * d * vv + added(1, 1),
        ];
    }
    covariance
}

/// Returns errors relative to equipartition: ⟨v²⟩ = S/2c and ⟨x²⟩ = ⟨v²⟩/k, without correlation.
fn errors_of_covariances<F: Scheme<Oscillator<f64>>>(step: f64) -> [f64; 3] {
    [1.0, 2.0, 4.0].map(|halves| {
        let [xx, xv, vv] = stationary::<F>(step / halves);
        (xx - 0.125).abs() + xv.abs() + (vv - 0.5).abs()
    })
}

fn orders(errors: [f64; 3]) -> [f64; 2] {
    [errors[0] / errors[1], errors[1] / errors[2]].map(f64::log2)
}

#[test]
fn covariances_of_linear_systems_have_the_orders_one_and_four() {
    let euler = orders(errors_of_covariances::<EulerMaruyamaScheme>(0.02));
    assert!(euler.iter().all(|order| (order - 1.0).abs() < 0.1), "{euler:?}");
    let errors = errors_of_covariances::<StochasticRungeKutta4Scheme>(0.05);
    assert!(errors[2] < 1e-6 && orders(errors).iter().all(|order| (order - 4.0).abs() < 0.2), "{errors:?}");
}

#[test]
fn without_noise_steps_are_those_of_the_classical_method() {
    let y = [0.3, -0.7];
    let [x, v] = change::<StochasticRungeKutta4Scheme>(y, 0.1, [0.0; 2]);
    let expected = crate::integrate::rk4_step(&OSCILLATOR, 0.0, &y, 0.1);
    assert!((y[0] + x - expected[0]).abs() < 1e-16 && (y[1] + v - expected[1]).abs() < 1e-16);
}

/// Returns the ends of steps to these limits, each followed by a restart.
fn ends<K: Method<Wiener>>(method: &K, from: f64, limits: &[f64]) -> Vec<f64> {
    let mut stepper = method.start(&WIENER, from, &[0.0], 10.0).expect("starts");
    let end = |&limit: &f64| {
        while stepper.time() < limit {
            stepper.step(&WIENER, limit).expect("steps");
        }
        let y = *stepper.state();
        stepper.restart(&WIENER, limit, &y).expect("restarts");
        y[0]
    };
    limits.iter().map(end).collect()
}

/// Interruptions, late starts and shorter steps all use the same path.
#[test]
fn an_interrupted_motion_stays_on_its_path() {
    let path = WienerPath::of_seed(5);
    let euler = EulerMaruyama { step: 0.1, path };
    let whole = ends(&euler, 0.0, &[0.3, 1.0, 2.0]);
    let interrupted = ends(&euler, 0.0, &[0.11, 0.3, 0.32, 0.35, 0.75, 1.0, 1.23, 2.0]);
    let late = ends(&euler, 0.3, &[1.0, 2.0]);
    let short = ends(&EulerMaruyama { step: 0.025, path: path.halved(2) }, 0.0, &[0.3, 1.0, 2.0]);
    let curved = StochasticRungeKutta4 { step: 0.1, path };
    let curved = ends(&curved, 0.0, &[0.11, 0.3, 0.32, 0.35, 0.75, 1.0, 1.23, 2.0]);
    for (at, other) in [(0, interrupted[1]), (1, interrupted[5]), (2, interrupted[7])] {
        assert!((whole[at] - other).abs() < 1e-13, "{whole:?} {interrupted:?}");
    }
    assert!((late[1] - (whole[2] - whole[0])).abs() < 1e-13, "{late:?}");
    assert!(whole.iter().zip(&short).all(|(a, b)| (a - b).abs() < 1e-13), "{short:?}");
    assert!((whole[2] - curved[7]).abs() < 1e-13 && (interrupted[3] - curved[3]).abs() > 1e-3, "{curved:?}");
}

#[test]
fn steps_end_at_multiples_of_their_length() {
    for from in [-0.32, 0.0, 0.07, 0.3, 1e6] {
        let method = EulerMaruyama { step: 0.1, path: WienerPath::of_seed(5) };
        let mut stepper = method.start(&WIENER, from, &[0.0], from + 10.0).expect("starts");
        for _ in 0..50 {
            stepper.step(&WIENER, f64::INFINITY).expect("steps");
            let multiple = (stepper.time() / 0.1).round();
            assert_eq!(stepper.time(), multiple * 0.1);
        }
        assert!((stepper.time() - from - 5.0).abs() < 0.1 + 1e-9, "{from}: {}", stepper.time());
    }
}

/// Between its ends, the path is a chord or a parabola, and the other terms are cubic.
#[test]
fn states_within_a_step_lie_on_a_smooth_curve() {
    let method = StochasticRungeKutta4 { step: 0.1, path: WienerPath::of_seed(5) };
    let mut stepper = method.start(&OSCILLATOR, 0.0, &[1.0, 0.0], 1.0).expect("starts");
    stepper.step(&OSCILLATOR, 1.0).expect("steps");
    let before = *stepper.state();
    stepper.step(&OSCILLATOR, 1.0).expect("steps");
    let (end, [from, to]) = (*stepper.state(), [stepper.last_time(), stepper.time()]);
    let mut at = |t| stepper.interpolate(&OSCILLATOR, t);
    assert_eq!([at(from), at(to)], [before, end]);
    let near = at(to - 1e-9);
    assert!(near.iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-7), "{near:?} {end:?}");
    // The rates of positions are the velocities.
    let ([x0, _], [x1, _]) = (at(0.15 - 1e-5), at(0.15 + 1e-5));
    assert!(((x1 - x0) / 2e-5 - at(0.15)[1]).abs() < 0.05);
}

#[test]
fn narrow_numbers_follow_the_same_path() {
    let path = WienerPath::of_seed(9);
    let narrow = Oscillator::<f32>(core::marker::PhantomData);
    let mut single = StochasticRungeKutta4 { step: 0.01_f32, path }
        .start(&narrow, 0.0, &[1.0, 0.0], 30.0)
        .expect("starts");
    let mut double = StochasticRungeKutta4 { step: 0.01_f64, path }
        .start(&OSCILLATOR, 0.0, &[1.0, 0.0], 30.0)
        .expect("starts");
    for _ in 0..3000 {
        single.step(&narrow, 30.0).expect("steps");
        double.step(&OSCILLATOR, 30.0).expect("steps");
    }
    assert_eq!((single.time(), double.time()), (30.0, 30.0));
    let far = single.state().iter().zip(double.state()).map(|(a, b)| (f64::from(*a) - b).abs());
    assert!(far.fold(0.0, f64::max) < 1e-4, "{:?} {:?}", single.state(), double.state());
}

/// Returns the reason why a motion does not start.
fn refusal<M: OdeSystem<Scalar = f64>>(system: &M, method: &impl Method<M>, end: f64) -> &'static str {
    let refused = method.check().map_err(StepFailure::Setting);
    match refused.and_then(|()| method.start(system, 0.0, &M::State::ZERO, end).map(drop)) {
        Err(StepFailure::Setting(SettingError::Invalid(why))) => why,
        other => panic!("{other:?}"),
    }
}

#[test]
fn methods_and_systems_that_do_not_go_together_are_refused() {
    let path = WienerPath::of_seed(1);
    let euler = EulerMaruyama { step: 0.1, path };
    let names_methods = |why: &str| why.contains("EulerMaruyama") && why.contains("StochasticRungeKutta4");
    assert!(names_methods(refusal(&WIENER, &Verner98::tolerance(1e-6), 1.0)));
    assert!(names_methods(refusal(&WIENER, &RungeKutta4 { step: 0.1 }, 1.0)));
    let many = refusal(&Wiener(NoiseKind::Multiplicative), &euler, 1.0);
    assert!(many.contains("take `StochasticRungeKutta4`"), "{many}");
    assert_eq!(refusal(&WIENER, &euler, -1.0), super::BACKWARDS);
    assert_eq!(refusal(&WIENER, &EulerMaruyama { step: 0.1, path: path.halved(32) }, 1.0), super::TOO_FINE);
    assert!(refusal(&WIENER, &EulerMaruyama { step: -0.1, path }, 1.0).contains("positive"));
    let silent = crate::integrate::rk4_step::<Silent>;
    assert_eq!(silent(&Silent, 0.0, &[1.0], 0.1), [1.0]);
    assert_eq!(refusal(&Silent, &euler, 1.0), super::NO_NOISE);
}

/// ẏ = 0
struct Silent;

impl OdeSystem for Silent {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }
}
