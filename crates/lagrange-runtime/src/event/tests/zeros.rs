//! Zeros of functions of many kinds, known in closed form.

use std::vec::Vec;

use super::{PI, pair};
use crate::event::Occurrence;
use crate::integrate::{Method, RungeKutta4, Verner98};
use crate::run::integrate_with_events;
use crate::system::{Action, Direction, OdeSystem};

/// ẏ = 0: events depend on functions of time alone.
struct Rest;

impl OdeSystem for Rest {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }
}

/// Returns the indices and times of all events of functions of time.
fn all<const E: usize>(
    method: &impl Method<Rest>,
    end: f64,
    directions: [Direction; E],
    mut functions: impl FnMut(f64) -> [f64; E],
) -> Vec<(usize, f64)> {
    let mut found = Vec::new();
    let react = |event: &Occurrence<f64, [f64; 1]>| {
        found.push((event.event, event.time));
        Action::Continue
    };
    let watch = (directions, |t: f64, _: &[f64; 1]| functions(t));
    integrate_with_events(&Rest, (0.0, [1.0]), end, method, watch, react).expect("reaches its end");
    found
}

/// Returns the times at which a function of time crosses zero, in steps of any method.
fn crossings(method: &impl Method<Rest>, end: f64, function: impl Fn(f64) -> f64) -> Vec<f64> {
    let found = all(method, end, [Direction::Crossing], |t| [function(t)]);
    found.into_iter().map(|(_, time)| time).collect()
}

/// Asserts that exactly these zeros are found, in fixed steps of several lengths and in adaptive
/// steps.
fn assert_zeros(what: &str, end: f64, wanted: &[f64], function: impl Fn(f64) -> f64) {
    let steps = [end, end / 3.0, end / 17.0].map(|step| crossings(&RungeKutta4 { step }, end, &function));
    for found in steps.into_iter().chain([crossings(&pair(), end, &function)]) {
        let missed: Vec<_> = wanted.iter().filter(|t| found.iter().all(|f| (f - **t).abs() > 1e-6)).collect();
        assert_eq!(found.len(), wanted.len(), "{what}: {missed:?} of {wanted:?} were missed");
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-9 * end, "{what}: {found} for {wanted}");
        }
    }
}

#[test]
fn every_zero_of_a_fast_oscillation_is_found() {
    for frequency in [50.0, 2000.0] {
        let wanted: Vec<f64> =
            (1..).map(|k| f64::from(k) * PI / frequency).take_while(|t| *t < 1.0).collect();
        assert!(frequency < 2000.0 || wanted.len() == 636);
        assert_zeros("a sine", 1.0, &wanted, |t| (frequency * t).sin());
        assert_zeros("a growing sine", 1.0, &wanted, |t| (frequency * t).sin() * (3.0 * t).exp());
    }
}

#[test]
fn zeros_next_to_each_other_are_found() {
    for gap in [0.1, 1e-3, 1e-5] {
        let wanted = [3.0, 3.0 + gap];
        let product = |t: f64| (t - 3.0) * (t - 3.0 - gap);
        assert_zeros("a parabola", 7.0, &wanted, product);
        assert_zeros("a bent parabola", 7.0, &wanted, |t| product(t) * (0.3 * t).cos().exp());
        assert_zeros("a parabola below", 7.0, &wanted, |t| -product(t) / (1.0 + t));
    }
}

#[test]
fn what_touches_zero_is_not_found() {
    assert_zeros("a square", 7.0, &[], |t| (t - 3.0) * (t - 3.0));
    assert_zeros("a square of a sine", 7.0, &[], |t| (3.0 * (t - 1.0)).sin().powi(2));
    assert_zeros("a kink", 7.0, &[], |t| (t - PI).abs());
    assert_zeros("a fourth power", 7.0, &[], |t| (t - 3.0).powi(4));
    assert_zeros("a cube", 7.0, &[2.0], |t| (t - 2.0).powi(3));
}

#[test]
fn kinks_and_jumps_are_found() {
    assert_zeros("a valley", 7.0, &[PI - 0.01, PI + 0.01], |t| (t - PI).abs() - 0.01);
    assert_zeros("a root", 7.0, &[2.0], |t| (t - 2.0).abs().sqrt() * (t - 2.0).signum());
    let switched: Vec<f64> = (1..10).map(|k| f64::from(k) * 0.7).collect();
    assert_zeros(
        "a square wave",
        6.9,
        &switched,
        |t| if (t / 0.7).floor() % 2.0 == 0.0 { 2.0 } else { -1.0 },
    );
}

#[test]
fn directions_are_distinguished_in_one_step() {
    let method = RungeKutta4 { step: 1.0 };
    for (direction, count) in
        [(Direction::Rising, 318), (Direction::Falling, 318), (Direction::Crossing, 636)]
    {
        assert_eq!(all(&method, 1.0, [direction], |t| [(2000.0 * t).sin()]).len(), count);
    }
}

#[test]
fn several_fast_functions_come_in_the_order_of_time() {
    let functions = |t: f64| [(300.0 * t).sin(), (70.0 * t).cos(), (t - 0.5) * (t - 0.5001), 1.0 + t];
    let found = all(&RungeKutta4 { step: 0.25 }, 1.0, [Direction::Crossing; 4], functions);
    let count = |k: usize| found.iter().filter(|(event, _)| *event == k).count();
    assert_eq!([count(0), count(1), count(2), count(3)], [95, 22, 2, 0]);
    assert!(found.windows(2).all(|pair| pair[0].1 <= pair[1].1));
}

/// Smooth functions take eight evaluations per step, and the cost of noise is bounded.
#[test]
fn functions_are_evaluated_eight_times_a_step_if_they_are_smooth() {
    let calls = |step: f64, function: fn(f64) -> f64| {
        let mut calls = 0;
        all(&RungeKutta4 { step }, 8.0, [Direction::Crossing], |t| {
            calls += 1;
            [function(t)]
        });
        calls
    };
    assert_eq!(calls(1.0, |t| 2.0 + t.sin()), 1 + 8 * 8);
    let crossing = calls(1.0, |t| t - 2.3);
    assert!(crossing < 1 + 8 * 8 + 60, "{crossing}");
    let noise = calls(8.0, |t| (1e12 * t).sin());
    assert!(noise < 100_000, "{noise}");
}

/// ẍ = −sin x + 1.2 cos(2t/3) − ẋ/2: a driven pendulum whose motion is chaotic.
struct Driven;

impl OdeSystem for Driven {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -x.sin() + 1.2 * (2.0 * t / 3.0).cos() - v / 2.0]
    }
}

/// Along a chaotic motion, the same number of zeros is found as by sampling five thousand times per
/// second.
#[test]
fn zeros_along_a_chaotic_motion_are_those_of_a_close_look() {
    let functions: [fn(&[f64; 2]) -> f64; 3] =
        [|[x, _]| (40.0 * x).sin(), |[x, v]| v * v + x.cos() - 0.3, |[_, v]| (v - 0.5) * (v - 0.5005)];
    let end = 8.0;
    for function in functions {
        let run = |values: &mut dyn FnMut(f64, f64)| {
            let react = |event: &Occurrence<f64, [f64; 2]>| {
                values(event.time, function(&event.state));
                Action::Continue
            };
            let watch = ([Direction::Crossing], |_: f64, y: &[f64; 2]| [function(y)]);
            integrate_with_events(&Driven, (0.0, [0.2, 0.0]), end, &Verner98::tolerance(1e-10), watch, react)
                .expect("finite");
        };
        let mut found = 0;
        run(&mut |_, value| {
            assert!(value.abs() < 1e-9, "{value}");
            found += 1;
        });
        let short = Verner98 { longest_step: Some(2e-4), ..Verner98::tolerance(1e-10) };
        let (mut wanted, mut last) = (0, function(&[0.2, 0.0]));
        crate::run::integrate(&Driven, 0.0, [0.2, 0.0], end, &short, |_, y| {
            wanted += usize::from(function(y) * last < 0.0);
            last = function(y);
        })
        .expect("finite");
        assert!(found == wanted && wanted > 0, "{found} for {wanted}");
    }
}

/// Reproducible random numbers in the unit interval.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Polynomials with known roots and products of sines, 60 of each, or as many as `LAGRANGE_EVENTS`
/// says:
/// `LAGRANGE_EVENTS=20000 cargo test --release -p lagrange-runtime --lib event::tests::zeros`.
#[test]
fn random_polynomials_and_products_of_sines_have_the_zeros_that_they_were_made_of() {
    let count = std::env::var("LAGRANGE_EVENTS").ok().and_then(|count| count.parse().ok()).unwrap_or(60);
    let mut random = Random(1);
    for _ in 0..count {
        let degree = 1 + (random.next() * 7.0) as usize;
        let mut roots: Vec<f64> = (0..degree).map(|_| 0.05 + 3.9 * random.next()).collect();
        roots.sort_by(f64::total_cmp);
        if roots.windows(2).all(|pair| pair[1] - pair[0] > 2e-3) {
            assert_zeros("a polynomial", 4.0, &roots, |t| roots.iter().map(|root| t - root).product());
        }
        let sines: [(f64, f64); 2] =
            core::array::from_fn(|_| (1.0 + 60.0 * random.next(), 6.0 * random.next()));
        let zeros_of = |(frequency, phase): (f64, f64)| {
            (-1..)
                .map(move |k| (f64::from(k) * PI - phase) / frequency)
                .take_while(|t| *t < 4.0)
                .filter(|t| *t > 0.0)
        };
        let mut roots: Vec<f64> = sines.into_iter().flat_map(zeros_of).collect();
        roots.sort_by(f64::total_cmp);
        let is_apart = roots.windows(2).all(|pair| pair[1] - pair[0] > 2e-3);
        if is_apart && roots.iter().all(|t| (1e-3..4.0 - 1e-3).contains(t)) {
            let product =
                |t: f64| sines.iter().map(|(frequency, phase)| (frequency * t + phase).sin()).product();
            assert_zeros("a product of sines", 4.0, &roots, product);
        }
    }
}
