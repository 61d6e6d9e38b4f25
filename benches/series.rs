//! Taylor series against the default pair: a row for each motion and tolerance, with steps, errors
//! and microseconds of both.
//!
//! `cargo bench -p lagrange-benches --bench series`. The two alternate, and each time is the
//! shortest of many. Errors are those of the final state, in its largest component, against a
//! series of order 36.
//!
//! Further rows compare both in lanes, on one thread, with microseconds of one motion among many.
//! Starts differ slightly, except that of the motion whose error is shown.

use std::hint::black_box;
use std::time::Instant;

use lagrange::Ensembles;
use lagrange::ensemble::SharedSystem;
use lagrange::integrate::{Method, Stepper, Taylor, Verner98};
use lagrange::system::{OdeSystem, TaylorSystem};

lagrange::system! {
    /// Two point masses on massless rods.
    struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    emit { lanes, taylor }
}

lagrange::system! {
    /// A planet around a fixed sun.
    struct Kepler;

    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + (r * dot(phi))^2);
    potential = -1 / r;
    emit { lanes, taylor }
}

lagrange::system! {
    /// Six point masses on massless rods.
    struct Chain;

    param m[6] = 1.0, l[6] = 1.0, g = 9.81;
    coord theta[6];
    for i in 0..6 {
        let x[i] = sum(j in 0..i + 1, l[j] * sin(theta[j]));
        let y[i] = -sum(j in 0..i + 1, l[j] * cos(theta[j]));
    }
    kinetic = sum(i in 0..6, 1/2 * m[i] * (dot(x[i])^2 + dot(y[i])^2));
    potential = sum(i in 0..6, m[i] * g * y[i]);
    emit { lanes, taylor }
}

lagrange::system! {
    /// A heavy body with a fixed point.
    struct Top;

    param a = 1.0, c = 0.5, h = 0.7;
    quaternion r;
    kinetic = 1/2 * a * (r_wx^2 + r_wy^2) + 1/2 * c * r_wz^2;
    potential = h * (1 - 2 * (r_qx^2 + r_qy^2));
    emit { taylor }
}

lagrange::system! {
    /// The sun and the five outer planets: lengths in astronomical units, times in days, masses in
    /// those of the sun.
    struct OuterPlanets;

    const n = 6;
    param m[n] = [
        1.00000597682, 0.000954786104043, 0.000285583733151, 0.0000437273164546, 0.0000517759138449,
        1 / 130000000,
    ];
    param g = 2.95912208286e-4;
    coord x[n], y[n], z[n];
    kinetic = sum(i in 0..n, 1/2 * m[i] * (dot(x[i])^2 + dot(y[i])^2 + dot(z[i])^2));
    potential = -g * sum(i in 0..n, sum(j in 0..i,
        m[i] * m[j] / sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2 + (z[i] - z[j])^2)));
    emit { taylor }
}

/// Positions and velocities of the sun and the outer planets on 5 September 1994. Source: Hairer,
/// Lubich, Wanner, *Geometric Numerical Integration*, table I.2.2.
const PLANETS: [[f64; 6]; 6] = [
    [0.0; 6],
    [-3.5023653, -3.8169847, -1.5507963, 0.00565429, -0.00412490, -0.00190589],
    [9.0755314, -3.0458353, -1.6483708, 0.00168318, 0.00483525, 0.00192462],
    [8.3101420, -16.2901086, -7.2521278, 0.00354178, 0.00137102, 0.00055029],
    [11.4707666, -25.7294829, -10.8169456, 0.00288930, 0.00114527, 0.00039677],
    [-15.5387357, -25.2225594, -3.1902382, 0.00276725, -0.00170702, -0.00136504],
];

const REPEATS: usize = 40;
/// Number of motions in an ensemble.
const MOTIONS: usize = 32;
/// Number of measurements of an ensemble.
const ROUNDS: usize = 100;
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-9, 1e-12, 1e-14];

/// Returns the end of a motion, and its number of steps.
fn end<M: OdeSystem<Scalar = f64>>(
    system: &M,
    start: &M::State,
    end: f64,
    method: &impl Method<M>,
) -> (M::State, String) {
    let mut stepper = method.start(system, 0.0, start, end).expect("starts");
    while stepper.time() < end {
        stepper.step(system, end).expect("goes on");
    }
    (*stepper.state(), stepper.work().steps.to_string())
}

/// Returns the end of the first motion of an ensemble on one thread, and no number of steps.
fn first_end<M: SharedSystem<Scalar = f64>>(
    system: &M,
    start: &M::State,
    end: f64,
    method: &(impl Method<M> + Clone + Sync),
) -> (M::State, String) {
    let starts = |index, random: &mut lagrange::ensemble::Random| {
        let (mut state, most) = (*start, if index == 0 { 0.0 } else { 1e-2 });
        state.as_mut().iter_mut().for_each(|entry| *entry += most * random.normal());
        state
    };
    let motions = system.ensemble(MOTIONS).start(starts).until(end).method(method.clone()).threads(1);
    assert!(motions.is_in_lanes());
    let ends = motions.run().expect("runs");
    (ends.state(0).expect("ended"), "–".to_owned())
}

/// Returns the microseconds of a run.
fn microseconds<T>(run: impl FnOnce() -> T) -> f64 {
    let began = Instant::now();
    black_box(run());
    1e6 * began.elapsed().as_secs_f64()
}

/// Returns the end of a motion by a method, and its number of steps.
type EndOf<'a, M, K> = &'a dyn Fn(&K) -> (<M as OdeSystem>::State, String);

fn compare<M: TaylorSystem<Scalar = f64>>(name: &str, system: &M, start: M::State, until: f64) {
    let exact = Taylor { order: Some(36), ..Taylor::tolerance(1e-17) };
    let (reference, _) = end(system, &start, until, &exact);
    let ends: (EndOf<'_, M, _>, EndOf<'_, M, _>) =
        (&|series| end(system, &start, until, series), &|pair| end(system, &start, until, pair));
    table::<M>(name, &reference, ends, (REPEATS, 1));
}

fn compare_in_lanes<M: TaylorSystem<Scalar = f64> + SharedSystem>(
    name: &str,
    system: &M,
    start: M::State,
    until: f64,
) {
    let exact = Taylor { order: Some(36), ..Taylor::tolerance(1e-17) };
    let (reference, _) = end(system, &start, until, &exact);
    let ends: (EndOf<'_, M, _>, EndOf<'_, M, _>) =
        (&|series| first_end(system, &start, until, series), &|pair| first_end(system, &start, until, pair));
    table::<M>(&format!("{name} in lanes"), &reference, ends, (ROUNDS, MOTIONS));
}

/// Prints rows for both methods, with times of one of several motions.
fn table<M: OdeSystem<Scalar = f64>>(
    name: &str,
    reference: &M::State,
    (by_series, by_pair): (EndOf<'_, M, Taylor<f64>>, EndOf<'_, M, Verner98<f64>>),
    (repeats, motions): (usize, usize),
) {
    let error = |y: &M::State| {
        let pairs = y.as_ref().iter().zip(reference.as_ref());
        pairs.fold(0.0_f64, |most, (found, expected)| most.max((found - expected).abs()))
    };
    for tolerance in TOLERANCES {
        let (series, pair) = (Taylor::tolerance(tolerance), Verner98::tolerance(tolerance));
        let [of_series, of_pair] = [by_series(&series), by_pair(&pair)];
        let (mut best, mut best_pair) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..repeats {
            best = best.min(microseconds(|| by_series(&series)) / motions as f64);
            best_pair = best_pair.min(microseconds(|| by_pair(&pair)) / motions as f64);
        }
        println!(
            "{name:>24} {tolerance:e}: series {:>5} steps {:.1e} {best:>8.1}   pair {:>5} steps {:.1e} {best_pair:>8.1}",
            of_series.1,
            error(&of_series.0),
            of_pair.1,
            error(&of_pair.0),
        );
    }
}

fn main() {
    let right = std::f64::consts::FRAC_PI_2;
    let pendulum = DoublePendulum::default();
    compare("double pendulum", &pendulum, [2.0, 1.5, 0.0, 0.0], 10.0);
    compare("right angles", &pendulum, [right, right, 0.0, 0.0], 10.0);
    // Eccentricity 0.6, ten revolutions of length 2π.
    compare("Kepler", &Kepler, [0.4, 0.0, 0.0, 5.0], 20.0 * std::f64::consts::PI);
    let chain = [1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    compare("chain of six", &Chain::default(), chain, 3.0);
    compare_in_lanes("double pendulum", &pendulum, [2.0, 1.5, 0.0, 0.0], 10.0);
    compare_in_lanes("Kepler", &Kepler, [0.4, 0.0, 0.0, 5.0], 20.0 * std::f64::consts::PI);
    compare_in_lanes("chain of six", &Chain::default(), chain, 3.0);
    compare("heavy top", &Top::default(), [0.9, 0.3, 0.1, 0.3, 0.1, 0.2, 5.0], 10.0);
    // Coordinates are listed axis by axis.
    let planets = std::array::from_fn(|entry| PLANETS[entry % 6][entry / 6]);
    compare("outer planets", &OuterPlanets::default(), planets, 20_000.0);
}
