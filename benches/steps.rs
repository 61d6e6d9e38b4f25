//! Steps of equal length against handwritten loops for one system.
//!
//! The loops take the same emitted right-hand sides and contain what one would write: no
//! compensated sums, no check for NaN, no test of stability. Each case is ten thousand steps.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use lagrange::integrate::{BlanesMoan4, Method, RungeKutta4, StormerVerlet, integrate};
use lagrange::system::OdeSystem;

lagrange::system! {
    pub struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

lagrange::system! {
    pub struct Planet;

    param mu = 1.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -mu / sqrt(x^2 + y^2);
}

const STEPS: u32 = 10_000;
const STEP: f64 = 1e-3;
const SWING: [f64; 4] = [1.0, 1.5, 0.0, 0.0];
const ORBIT: [f64; 4] = [0.4, 0.0, 0.0, 2.0];

/// Runs a method of the crate.
fn ours<M, K>(system: &M, start: M::State, method: &K) -> M::State
where
    M: OdeSystem<Scalar = f64>,
    K: Method<M>,
{
    let end = STEP * f64::from(STEPS);
    integrate(system, 0.0, black_box(start), end, method, |_, _| {}).expect("a finite motion")
}

/// Returns y + c k.
fn moved(y: &[f64; 4], c: f64, k: &[f64; 4]) -> [f64; 4] {
    std::array::from_fn(|i| y[i] + c * k[i])
}

fn runge_kutta_by_hand(rhs: impl Fn(f64, &[f64; 4]) -> [f64; 4], start: [f64; 4]) -> [f64; 4] {
    let (mut y, h) = (black_box(start), black_box(STEP));
    for step in 0..STEPS {
        let t = f64::from(step) * h;
        let k1 = rhs(t, &y);
        let k2 = rhs(t + h / 2.0, &moved(&y, h / 2.0, &k1));
        let k3 = rhs(t + h / 2.0, &moved(&y, h / 2.0, &k2));
        let k4 = rhs(t + h, &moved(&y, h, &k3));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    }
    y
}

fn verlet_by_hand(planet: &Planet, start: [f64; 4]) -> [f64; 4] {
    let ([mut x, mut y, mut u, mut v], h) = (black_box(start), black_box(STEP));
    let [mut ax, mut ay] = planet.acceleration(0.0, &[x, y], &[u, v]);
    for step in 1..=STEPS {
        (u, v) = (u + h / 2.0 * ax, v + h / 2.0 * ay);
        (x, y) = (x + h * u, y + h * v);
        [ax, ay] = planet.acceleration(f64::from(step) * h, &[x, y], &[u, v]);
        (u, v) = (u + h / 2.0 * ax, v + h / 2.0 * ay);
    }
    [x, y, u, v]
}

fn steps(criterion: &mut Criterion) {
    let (pendulum, planet) = (black_box(DoublePendulum::default()), black_box(Planet::default()));
    let mut group = criterion.benchmark_group("ten thousand steps");
    group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    let (classical, verlet) = (RungeKutta4 { step: STEP }, StormerVerlet { step: STEP });
    group.bench_function("double pendulum, Runge–Kutta 4", |b| {
        b.iter(|| ours(&pendulum, SWING, &classical));
    });
    let rhs = |t: f64, y: &[f64; 4]| pendulum.rhs(t, y);
    group.bench_function("the same by hand", |b| b.iter(|| runge_kutta_by_hand(rhs, SWING)));
    group.bench_function("planet, Runge–Kutta 4", |b| b.iter(|| ours(&planet, ORBIT, &classical)));
    let rhs = |t: f64, y: &[f64; 4]| planet.rhs(t, y);
    group.bench_function("that by hand", |b| b.iter(|| runge_kutta_by_hand(rhs, ORBIT)));
    group.bench_function("planet, Störmer–Verlet", |b| b.iter(|| ours(&planet, ORBIT, &verlet)));
    group.bench_function("this by hand", |b| b.iter(|| verlet_by_hand(&planet, ORBIT)));
    let composed = BlanesMoan4 { step: STEP };
    group.bench_function("planet, Blanes–Moan 4", |b| b.iter(|| ours(&planet, ORBIT, &composed)));
    group.finish();
}

criterion_group!(benches, steps);
criterion_main!(benches);
