//! Methods of fixed step on emitted types.

use lagrange::Number;
use lagrange::integrate::{BlanesMoan4, Method, RungeKutta4, StormerVerlet, SymplecticEuler, integrate};
use lagrange::system::OdeSystem;

lagrange::system! {
    struct Pendulum<S>;

    param l = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * (l * dot(theta))^2;
    potential = -g * l * cos(theta);
}

lagrange::system! {
    struct Planet<S>;

    param mu = 1.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -mu / hypot(x, y);
}

lagrange::system! {
    /// A mass on a spring whose other end moves; from rest at 0 it follows (cos t − cos 2t)/3.
    struct Driven<S>;

    param k = 4.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = spring_energy(k, x - cos(t) / k);
}

/// Returns the state at `end`, and the largest difference from `reached`.
fn error<M, K, const N: usize>(system: &M, start: [f64; N], end: f64, reached: [f64; N], method: &K) -> f64
where
    M: OdeSystem,
    M::State: From<[M::Scalar; N]> + Into<[M::Scalar; N]>,
    M::Scalar: Into<f64>,
    K: Method<M>,
{
    let start = start.map(M::Scalar::from_f64).into();
    let end = M::Scalar::from_f64(end);
    let y =
        integrate(system, M::Scalar::ZERO, start, end, method, |_, _| {}).expect("an ordinary motion").into();
    y.into_iter().zip(reached).fold(0.0, |largest: f64, (y, exact)| largest.max((y.into() - exact).abs()))
}

fn driven_end(t: f64) -> [f64; 2] {
    [(t.cos() - (2.0 * t).cos()) / 3.0, (2.0 * (2.0 * t).sin() - t.sin()) / 3.0]
}

/// Returns log₂ of the ratio of errors as steps are halved, for the driven mass, half an orbit and
/// a swing.
fn observed<K>(method: fn(f64) -> K, steps: f64) -> [f64; 3]
where
    K: Method<Driven<f64>> + Method<Planet<f64>> + Method<Pendulum<f64>>,
{
    let ratio = |error: &dyn Fn(f64) -> f64| (error(1.0 / steps) / error(0.5 / steps)).log2();
    let (near, far) = (0.7_f64, 1.3_f64);
    let (start, reached) = ([near, 0.0, 0.0, (far / near).sqrt()], [-far, 0.0, 0.0, -(near / far).sqrt()]);
    let (swing, half) = ([0.0, 2.0], swing_end());
    [
        ratio(&|part| error(&Driven::<f64>::default(), [0.0; 2], 4.0, driven_end(4.0), &method(4.0 * part))),
        ratio(&|part| {
            let method = method(std::f64::consts::PI * part);
            error(&Planet::<f64>::default(), start, std::f64::consts::PI, reached, &method)
        }),
        ratio(&|part| error(&Pendulum::<f64>::default(), swing, 2.0, half, &method(2.0 * part))),
    ]
}

/// Returns the state of the swing two seconds after the lowest point, by a method tested elsewhere,
/// with short steps.
fn swing_end() -> [f64; 2] {
    let method = RungeKutta4 { step: 2.5e-4 };
    integrate(&Pendulum::default(), 0.0, [0.0, 2.0], 2.0, &method, |_, _| {}).expect("an ordinary motion")
}

#[track_caller]
fn assert_order(orders: [f64; 3], wanted: f64) {
    assert!(orders.iter().all(|order| (order - wanted).abs() < 0.1), "{orders:?}");
}

#[test]
fn orders_are_those_of_the_methods() {
    assert_order(observed(|step| SymplecticEuler { step }, 4000.0), 1.0);
    assert_order(observed(|step| StormerVerlet { step }, 400.0), 2.0);
    assert_order(observed(|step| BlanesMoan4 { step }, 160.0), 4.0);
    assert_order(observed(|step| RungeKutta4 { step }, 640.0), 4.0);
}

#[test]
fn single_precision_is_as_good_as_its_numbers() {
    let driven = Driven::<f32>::default();
    let composed = error(&driven, [0.0; 2], 10.0, driven_end(10.0), &BlanesMoan4 { step: 0.02 });
    let classical = error(&driven, [0.0; 2], 10.0, driven_end(10.0), &RungeKutta4 { step: 0.02 });
    assert!(composed < 4e-6 && classical < 4e-6, "{composed:e} {classical:e}");
}

#[test]
fn explicit_time_is_a_coordinate_of_the_splitting() {
    let method = BlanesMoan4 { step: 0.05 };
    let there = integrate(&Driven::default(), 0.0, [0.1, 0.2], 7.0, &method, |_, _| {}).expect("finite");
    let [x, v] = integrate(&Driven::default(), 7.0, there, 0.0, &method, |_, _| {}).expect("finite");
    assert!((x - 0.1).abs() < 1e-14 && (v - 0.2).abs() < 1e-14, "{x} {v}");
}
