//! Gradients backwards along a run, against forward derivatives along the same steps.

use lagrange::Simulate;
use lagrange::integrate::{RungeKutta4, StepFailure};

lagrange::system! {
    /// Eight masses between hardening springs, with friction, on a moving support.
    #[derive(Clone, Debug)]
    struct Chain;
    param m[8] = 1.5, k[8] = 20, c[8] = 0.1;
    coord x[8];
    input push;
    state work = 0;
    kinetic = sum(i in 0..8, 1/2 * m[i] * dot(x[i])^2);
    potential = 1/2 * k[0] * (x[0] - 0.1 * sin(2 * t))^2 + sum(i in 1..8, 1/2 * k[i] * (x[i] - x[i - 1])^2 + (x[i] - x[i - 1])^4);
    dissipation = sum(i in 0..8, 1/2 * c[i] * dot(x[i])^2);
    force x[7] = push;
    dot(work) = sum(i in 0..8, c[i] * dot(x[i])^2);
    emit { jacobian }
}

/// Names of all parameters.
const NAMES: [&str; 24] = [
    "m[0]", "m[1]", "m[2]", "m[3]", "m[4]", "m[5]", "m[6]", "m[7]", "k[0]", "k[1]", "k[2]", "k[3]", "k[4]",
    "k[5]", "k[6]", "k[7]", "c[0]", "c[1]", "c[2]", "c[3]", "c[4]", "c[5]", "c[6]", "c[7]",
];
/// Positions, first-order states and velocities.
const N: usize = 17;

fn start() -> [f64; N] {
    core::array::from_fn(|i| if i < 8 { 0.2 * (i as f64).cos() } else { 0.0 })
}

fn chain() -> Chain {
    let mut chain = Chain { push: 0.3, ..Chain::default() };
    for i in 0..8 {
        chain.m[i] += 0.1 * i as f64;
        chain.k[i] += (3 * i % 5) as f64;
    }
    chain
}

/// Returns the dissipated work, plus half the square of the last position.
fn cost(_: f64, y: &[f64; N], slope: &mut [f64; N]) -> f64 {
    (slope[7], slope[8]) = (y[7], 1.0);
    y[8] + 0.5 * y[7] * y[7]
}

fn largest_difference(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    found.iter().zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / largest
}

/// Steps differ slightly, and so do the errors of both motions.
#[test]
fn both_directions_agree_along_adaptive_steps() {
    let chain = chain();
    let simulation = || chain.simulate(start()).until(20.0).tolerance(1e-13);
    let gradient = simulation().gradient(NAMES, cost).expect("smooth");
    let motion = simulation().sensitivities_alongside(NAMES).run().expect("smooth");
    let (end, slopes) = (motion.last(), motion.sensitivities(motion.len() - 1).expect("asked for"));
    let expected = slopes.iter().map(|slope| slope[8] + end[7] * slope[7]).collect::<Vec<_>>();
    assert!((gradient.value - cost(0.0, &end, &mut [0.0; N])).abs() < 1e-12);
    let difference = largest_difference(&gradient.by, &expected);
    assert!(difference < 1e-10, "{difference:e}");
    let plain = simulation().run().expect("smooth");
    assert_eq!(gradient.steps as u64, plain.work().steps);
    assert!((gradient.value - cost(0.0, &plain.last(), &mut [0.0; N])).abs() < 1e-13);
}

#[test]
fn both_directions_agree_along_equal_steps() {
    let (chain, method) = (chain(), RungeKutta4 { step: 0.01 });
    let gradient = chain.simulate(start()).until(3.0).method(method).gradient(NAMES, cost).expect("smooth");
    let motion =
        chain.simulate(start()).until(3.0).method(method).sensitivities(NAMES).run().expect("smooth");
    let (end, slopes) = (motion.last(), motion.sensitivities(motion.len() - 1).expect("asked for"));
    let expected = slopes.iter().map(|slope| slope[8] + end[7] * slope[7]).collect::<Vec<_>>();
    let difference = largest_difference(&gradient.by, &expected);
    assert!(difference < 1e-13, "{difference:e}");
    assert_eq!(gradient.steps, 300);
}

/// Costs of samples add up, and derivatives with respect to the start cover all entries.
#[test]
fn samples_and_the_start_are_those_of_differences() {
    let (chain, method) = (chain(), RungeKutta4 { step: 0.02 });
    let squares = |_: f64, y: &[f64; N], slope: &mut [f64; N]| {
        slope[2] = 2.0 * y[2];
        y[2] * y[2]
    };
    let value = |start: [f64; N]| {
        let motion = chain.simulate(start).until(1.92).every(0.24).method(method).run().expect("smooth");
        assert_eq!(motion.len(), 9);
        motion.states().map(|y| y[2] * y[2]).sum::<f64>()
    };
    let gradient =
        chain.simulate(start()).until(1.92).every(0.24).method(method).gradient([], squares).expect("smooth");
    assert!((gradient.value - value(start())).abs() < 1e-13);
    for entry in 0..N {
        let moved = |by: f64| {
            let mut start = start();
            start[entry] += by;
            value(start)
        };
        // Richardson extrapolation of central differences.
        let central = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
        let difference = (4.0 * central(5e-4) - central(1e-3)) / 3.0;
        assert!((gradient.by_start[entry] - difference).abs() < 1e-10, "{entry}");
    }
}

#[test]
fn memory_grows_with_the_root_of_the_number_of_steps() {
    let chain = chain();
    for steps in [1, 2, 3, 4, 10, 100, 1000, 5000] {
        let method = RungeKutta4 { step: 0.01 };
        let until = 0.01 * f64::from(steps);
        let gradient =
            chain.simulate(start()).until(until).method(method).gradient(["k[0]"], cost).expect("smooth");
        assert_eq!(gradient.steps, steps as usize);
        let most = 3.0 * f64::from(steps).sqrt() + 2.0;
        assert!(gradient.kept_states as f64 <= most, "{} of {steps}", gradient.kept_states);
    }
}

#[test]
fn a_motion_that_lasts_no_time_has_the_slope_of_its_cost() {
    let gradient = chain().simulate(start()).until(0.0).gradient(["k[0]", "push"], cost).expect("smooth");
    assert_eq!((gradient.by, gradient.steps), (vec![0.0, 0.0], 0));
    assert_eq!((gradient.by_start[7], gradient.by_start[8]), (start()[7], 1.0));
    let sampled = chain().simulate(start()).until(0.0).every(0.1).gradient(["k[0]"], cost).expect("smooth");
    assert_eq!(sampled.value, gradient.value);
}

#[test]
fn time_may_run_backwards() {
    let chain = chain();
    let there = chain.simulate(start()).until(1.0).tolerance(1e-13).run().expect("smooth").last();
    let back = chain.simulate(there).from(1.0).until(0.0).tolerance(1e-13);
    let gradient = back.gradient(["k[3]"], |_, y, slope| {
        slope[3] = 1.0;
        y[3]
    });
    let gradient = gradient.expect("smooth");
    assert!((gradient.value - start()[3]).abs() < 1e-11);
    let value = |by: f64| {
        let mut moved = chain.clone();
        moved.k[3] += by;
        moved.simulate(there).from(1.0).until(0.0).tolerance(1e-13).run().expect("smooth").last()[3]
    };
    let central = |h: f64| (value(h) - value(-h)) / (2.0 * h);
    let difference = (4.0 * central(5e-3) - central(1e-2)) / 3.0;
    assert!((gradient.by[0] - difference).abs() < 1e-9, "{} {difference}", gradient.by[0]);
}

lagrange::system! {
    /// A pendulum in single precision.
    #[scalar(f32)]
    struct Small;
    param l = 0.5, g = 9.81;
    coord phi;
    kinetic = 1/2 * l^2 * dot(phi)^2;
    potential = -g * l * cos(phi);
    emit { jacobian }
}

#[test]
fn single_precision_has_gradients() {
    let small = Small::default();
    let cost = |_: f32, y: &[f32; 2], slope: &mut [f32; 2]| {
        slope[0] = 1.0;
        y[0]
    };
    let gradient = small.simulate([0.4, 0.0]).until(1.0).gradient(["l", "g"], cost).expect("smooth");
    let motion = small.simulate([0.4, 0.0]).until(1.0).sensitivities(["l", "g"]).run().expect("smooth");
    let slopes = motion.sensitivities(motion.len() - 1).expect("asked for");
    for (found, slope) in gradient.by.iter().zip(&slopes) {
        assert!((found - slope[0]).abs() < 1e-4, "{found} {}", slope[0]);
    }
}

lagrange::system! {
    /// A mass without derivatives.
    struct Plain;
    param k = 3;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
}

lagrange::system! {
    /// A mass before a stop given by a table.
    struct Stopped;
    param k = 1;
    coord x;
    table stop(x) = [(-2, 0), (1, 0), (1.1, -100)], interpolation: linear, outside: extend;
    kinetic = 1/2 * dot(x)^2;
    force x = k * stop(x) - x;
    emit { jacobian }
}

lagrange::system! {
    /// A mass on a spring with a smooth force from a table, with all series of it.
    struct Soft;
    param k = 1;
    coord x;
    table pull(x) = [(-2, -3), (0, 0), (1, 2), (2, 3)], interpolation: monotone, outside: extend;
    table hill(x) = [(-2, 1), (0, 0), (1, 1), (2, 3)], interpolation: natural, outside: extend;
    kinetic = 1/2 * dot(x)^2;
    potential = hill(x);
    force x = -k * pull(x);
    emit { jacobian, taylor }
}

lagrange::system! {
    /// A mass with friction from the slope of a table, which has kinks.
    struct Hilly;
    param k = 1;
    coord x;
    table hill(x) = [(-2, 1), (0, 0), (1, 1), (2, 3)], interpolation: monotone, outside: extend;
    kinetic = 1/2 * dot(x)^2;
    force x = -k * dot(hill(x));
    emit { jacobian }
}

fn words<T>(result: Result<T, StepFailure<f64>>) -> String {
    result.err().expect("a refusal").to_string()
}

#[test]
fn what_has_no_gradient_is_refused_in_words() {
    let position = |_: f64, y: &[f64; 2], slope: &mut [f64; 2]| {
        slope[0] = 1.0;
        y[0]
    };
    let plain = Plain::default();
    let unknown = words(plain.simulate([1.0, 0.0]).until(1.0).gradient(["mass"], position));
    assert!(unknown.contains("`mass`"), "{unknown}");
    let observed = plain.simulate([1.0, 0.0]).until(1.0).energy();
    assert!(words(observed.gradient(["k"], position)).contains("columns"));
    let reported = plain.simulate([1.0, 0.0]).until(1.0).progress(|_| ());
    assert!(words(reported.gradient(["k"], position)).contains("progress"));
    for entry in ["x", "x_dot"] {
        let refusal = words(plain.simulate([1.0, 0.0]).until(1.0).gradient([entry], position));
        assert!(refusal.contains("`by_start`"), "{refusal}");
    }
}

/// x = cos(√k t), of which the derivative with respect to k is −t sin(√k t)/(2 √k).
#[test]
fn differences_replace_derivatives_that_are_not_emitted() {
    let plain = Plain::default();
    let gradient = plain.simulate([1.0, 0.0]).until(2.0).tolerance(1e-12).gradient(["k"], |_, y, slope| {
        slope[0] = 1.0;
        y[0]
    });
    let (gradient, rate) = (gradient.expect("smooth"), 3.0_f64.sqrt());
    assert!((gradient.by[0] + (2.0 * rate).sin() / rate).abs() < 1e-10, "{:?}", gradient.by);
    assert!((gradient.by_start[1] - (2.0 * rate).sin() / rate).abs() < 1e-10);
}

/// Steps do not end at kinks of tables, where derivatives are one-sided.
#[test]
fn tables_have_gradients_if_they_have_no_kinks() {
    let cost = |_: f64, y: &[f64; 2], slope: &mut [f64; 2]| {
        slope[0] = 1.0;
        y[0]
    };
    let stopped = Stopped::default().simulate([0.0, 2.0]).until(10.0).gradient(["k"], cost);
    assert!(words(stopped).contains("kinks of tables"));
    let hilly = Hilly::default().simulate([0.0, 0.5]).until(1.0).gradient(["k"], cost);
    assert!(words(hilly).contains("kinks of tables"));
    let soft = Soft::default();
    let simulation = || soft.simulate([0.0, 0.5]).until(3.0).tolerance(1e-12);
    let gradient = simulation().gradient(["k"], cost).expect("smooth enough");
    let motion = simulation().sensitivities(["k"]).run().expect("smooth enough");
    let slopes = motion.sensitivities(motion.len() - 1).expect("asked for");
    assert!((gradient.by[0] - slopes[0][0]).abs() < 1e-8, "{} {}", gradient.by[0], slopes[0][0]);
}
