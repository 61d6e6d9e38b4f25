//! Springs and dampers whose ends meet. The force of a damper has a limit there along any motion,
//! −c ṙ; the direction of a spring with a rest length has none.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{prop_assert, proptest};

const DAMPING: f64 = 0.75;
const MASS: f64 = 2.0;

fn numeric(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|parsed| parsed.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}{text}")))
}

/// Returns a body on a damper, placed by the coordinates.
fn damped(coordinates: &str, center: &str, anchor: &str) -> NumericSystem {
    numeric(&format!(
        "coord {coordinates}; body block {{ mass: {MASS}; center: {center}; }}
         damper {{ from: {anchor}; to: block; damping: {DAMPING}; }} emit {{ jacobian, momentum_rates }}"
    ))
}

/// Returns x at the time t under damping alone: m ẍ = −c ẋ.
fn exact(start: [f64; 2], t: f64) -> f64 {
    start[0] + start[1] * MASS / DAMPING * -(-DAMPING / MASS * t).exp_m1()
}

/// Returns the state after one step of the classical Runge–Kutta method.
fn step(system: &NumericSystem, y: &[f64], h: f64) -> Vec<f64> {
    let moved = |by: &[f64], h: f64| y.iter().zip(by).map(|(y, k)| y + h * k).collect::<Vec<_>>();
    let first = system.rhs(0.0, y);
    let second = system.rhs(0.0, &moved(&first, h / 2.0));
    let third = system.rhs(0.0, &moved(&second, h / 2.0));
    let last = system.rhs(0.0, &moved(&third, h));
    let mean = (0..y.len()).map(|i| (first[i] + 2.0 * (second[i] + third[i]) + last[i]) / 6.0);
    moved(&mean.collect::<Vec<_>>(), h)
}

#[test]
fn the_order_of_a_method_survives_the_passage_through_the_other_end() {
    let systems = [
        (damped("x", "(x, 0)", "(0, 0)"), 1),
        (damped("x, y", "(x, y)", "(0, 0)"), 2),
        (damped("x", "(3/5*x, 1 - 4/5*x)", "(0, 1)"), 1),
    ];
    for (system, n) in systems {
        let errors = [8, 16].map(|steps| {
            // The first stage is exactly at the other end.
            let (mut y, h) = (vec![0.0; 2 * n], 2.0 / f64::from(steps));
            y[n..].fill(1.5);
            (0..steps).for_each(|_| y = step(&system, &y, h));
            (y[0] - exact([0.0, 1.5], 2.0)).abs()
        });
        let order = (errors[0] / errors[1]).log2();
        assert!((order - 4.0).abs() < 0.2, "order {order}, {errors:?}");
    }
}

#[test]
fn derivatives_where_both_ends_meet_are_those_of_the_limit() {
    let line = damped("x", "(x, 0)", "(0, 0)");
    let found = line.product(Product::Jacobian, 0.0, &[0.0], &[0.5]).expect("it is emitted");
    assert_eq!(found, [0.0, -DAMPING / MASS]);
    let plane = damped("x, y", "(x, y)", "(0, 0)");
    let found = plane.product(Product::Jacobian, 0.0, &[0.0; 2], &[0.5, 0.0]).expect("it is emitted");
    assert_eq!(found, [0.0, 0.0, -DAMPING / MASS, 0.0, 0.0, 0.0, 0.0, -DAMPING / MASS]);
}

#[test]
fn springs_with_a_rest_length_have_no_direction_where_their_ends_meet() {
    let spring = |coordinates: &str, center: &str| {
        numeric(&format!(
            "coord {coordinates}; body block {{ mass: 1; center: {center}; }}
             spring {{ from: (0, 0); to: block; stiffness: 3; rest: 1/2; }}
             damper {{ from: (0, 0); to: block; damping: 1; }}"
        ))
    };
    let plane = spring("x, y", "(x, y)").acceleration(0.0, &[0.0; 2], &[0.0; 2]);
    assert!(plane.iter().all(|a| a.is_nan()), "{plane:?}");
    let line = spring("x", "(x, 0)");
    let [below, at, above] = [-1e-9, 0.0, 1e-9].map(|x| line.acceleration(0.0, &[x], &[0.0])[0]);
    assert!((below + 1.5).abs() < 1e-8 && at == 0.0 && (above - 1.5).abs() < 1e-8, "{below} {at} {above}");
}

proptest! {
    #![proptest_config(crate::one_in(8))]

    #[test]
    fn a_damper_of_no_length_acts_against_the_velocity(
        anchor in [-4..5_i32, -4..5_i32],
        v in [-2.0..2.0, -2.0..2.0],
        length in 1..5_i32,
    ) {
        let [px, py] = anchor;
        let plane = damped("x, y", "(x, y)", &format!("({px}, {py})"));
        let found = plane.acceleration(0.0, &anchor.map(f64::from), &v);
        for (a, v) in found.iter().zip(v) {
            prop_assert!((a + DAMPING / MASS * v).abs() < 1e-14, "{found:?}");
        }
        // The bob of a pendulum passes the other end where it hangs straight down.
        let bob = format!("({px} + {length}*sin(x), {py} - {length}*cos(x))");
        let pendulum = damped("x", &bob, &format!("({px}, {})", py - length));
        let found = [0.0, 1e-6].map(|x| pendulum.acceleration(0.0, &[x], &v[..1])[0]);
        for a in found {
            prop_assert!((a + DAMPING / MASS * v[0]).abs() < 1e-5, "{found:?}");
        }
    }
}
