//! Gradients backwards through contacts and friction.

use lagrange::Simulate;
use lagrange::integrate::RungeKutta4;

use crate::beside::compare_with_differences;
use crate::closed_forms::{AnyBall, slopes};
use crate::differences::Pair;

/// Returns the first position, and its slope.
macro_rules! first {
    () => {
        |_, y, slope| {
            slope[0] = 1.0;
            y[0]
        }
    };
}

/// Returns the sum of half the squares of all entries, and its slope.
fn energy<const N: usize>(_: f64, y: &[f64; N], slope: &mut [f64; N]) -> f64 {
    *slope = *y;
    y.iter().map(|entry| 0.5 * entry * entry).sum()
}

#[test]
fn a_bounce_has_the_slopes_of_its_parabola_in_both_precisions() {
    let [by_g, by_e, by_start] = slopes(1.2, 9.81, 0.7, 2.0);
    let ball = AnyBall::<f64>::default();
    let gradient =
        ball.simulate([2.0, 0.0]).until(1.2).tolerance(1e-13).gradient(["g", "e"], first!()).unwrap();
    for (found, wanted) in gradient.by.iter().chain(&gradient.by_start).zip([by_g, by_e, by_start]) {
        assert!((found - wanted).abs() < 1e-10, "{found} {wanted}");
    }
    let single = AnyBall::<f32>::default();
    let gradient = single.simulate([2.0, 0.0]).until(1.2).gradient(["g", "e"], first!()).unwrap();
    for (found, wanted) in gradient.by.iter().chain(&gradient.by_start).zip([by_g, by_e, by_start]) {
        assert!((f64::from(*found) - wanted).abs() < 1e-3 * wanted.abs(), "{found} {wanted}");
    }
}

/// The next bounce follows after 2 eⁿ v/g.
#[test]
fn several_bounces_have_the_slopes_of_their_polynomial() {
    let height = |e: f64| {
        let (v, fall) = ((2.0 * 9.81 * 2.0_f64).sqrt(), (4.0 / 9.81_f64).sqrt());
        let s = 2.3 - (fall + 2.0 * v / 9.81 * (e + e * e));
        e * e * e * v * s - 9.81 / 2.0 * s * s
    };
    let slope = |h: f64| (height(0.7 + h) - height(0.7 - h)) / (2.0 * h);
    let wanted = (4.0 * slope(5e-4) - slope(1e-3)) / 3.0;
    let ball = AnyBall::<f64>::default();
    let gradient = ball.simulate([2.0, 0.0]).until(2.3).tolerance(1e-13).gradient(["e"], first!()).unwrap();
    assert!((gradient.by[0] / wanted - 1.0).abs() < 1e-9, "{} {wanted}", gradient.by[0]);
}

/// Infinitely many bounces end before, and the floor holds the ball wherever it started.
#[test]
fn a_ball_that_came_to_rest_has_no_slopes() {
    let ball = AnyBall::<f64> { e: 0.5, ..AnyBall::default() };
    let gradient = ball.simulate([2.0, 0.0]).until(4.0).gradient(["g", "e"], first!()).unwrap();
    assert!(gradient.by.iter().chain(&gradient.by_start).all(|slope| slope.abs() < 1e-6), "{gradient:?}");
}

/// The ball leaves the floor with the speed v at the start: h = v t − g t²/2, and then once more.
#[test]
fn a_contact_may_be_touched_at_the_start() {
    let ball = AnyBall::<f64>::default();
    let (v, t, g, e) = (3.0, 0.9, 9.81, 0.7);
    let run = |v: f64| ball.simulate([0.0, v]).until(t).tolerance(1e-13);
    let gradient = run(v).gradient(["g", "e"], first!()).unwrap();
    // It lands after T = 2 v/g with the speed v.
    let s = t - 2.0 * v / g;
    assert!((gradient.value - (e * v * s - g * s * s / 2.0)).abs() < 1e-12);
    let (rate, by_speed) = (e * v - g * s, e * s);
    let landing = [-2.0 * v / g / g, 2.0 / g];
    let wanted = [-s * s / 2.0 - rate * landing[0], v * s];
    for (found, wanted) in gradient.by.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-10, "{found} {wanted}");
    }
    let wanted = by_speed - rate * landing[1];
    assert!((gradient.by_start[1] - wanted).abs() < 1e-10, "{:?} {wanted}", gradient.by_start);
}

lagrange::system! {
    /// A block on a rough floor.
    #[derive(Clone, Debug)]
    struct Block<S>;
    param m = 2, mu = 0.3, g = 9.81, push = 0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    force x = push;
    friction rub = dot(x), m * g * mu;
}

/// The block comes to rest after v²/(2 μ g).
#[test]
fn a_block_that_slides_to_rest_has_the_slopes_of_its_way() {
    let block = Block::<f64>::default();
    let (v, mu, g) = (2.0, block.mu, block.g);
    let run = block.simulate([0.0, v]).until(3.0).tolerance(1e-12);
    let gradient = run.gradient(["m", "mu", "g", "push"], first!()).unwrap();
    let way = v * v / (2.0 * mu * g);
    assert!((gradient.value - way).abs() < 1e-11);
    // A force f counts as much as −μ m g.
    let wanted = [0.0, -way / mu, -way / g, way / (mu * g * block.m)];
    for (found, wanted) in gradient.by.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-10, "{:?} {wanted}", gradient.by);
    }
    assert!((gradient.by_start[0] - 1.0).abs() < 1e-11, "{:?}", gradient.by_start);
    assert!((gradient.by_start[1] - v / (mu * g)).abs() < 1e-10, "{:?}", gradient.by_start);
    let small = Block::<f32>::default();
    let single = small.simulate([0.0, 2.0]).until(3.0).gradient(["mu"], first!()).unwrap();
    assert!((f64::from(single.by[0]) / (-way / mu) - 1.0).abs() < 1e-3, "{:?}", single.by);
}

lagrange::system! {
    /// Dry friction that sticks and slips, on a moving belt.
    #[derive(Clone, Debug)]
    struct Stick;
    param m = 1.0, k = 4.0, limit = 1.0, belt = 0.3;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    friction rub = dot(x) - belt, kinetic: limit, static: 1.5 * limit;
}

/// The block sticks, breaks loose and sticks again, between samples.
#[test]
fn stick_and_slip_turns_adjoints() {
    let stick = Stick::default();
    let run = || stick.simulate([0.0, 0.0]).until(4.0).every(0.7).tolerance(1e-11);
    compare!(run(), ["m", "k", "limit", "belt"], ["x", "x_dot"], 1e-7);
    let gradient = run().gradient(["m", "k", "limit", "belt"], energy).unwrap();
    let cost = |stick: &Stick| {
        let motion = stick.simulate([0.0, 0.0]).until(4.0).every(0.7).tolerance(1e-11).run().unwrap();
        motion.states().map(|y| energy(0.0, &y, &mut [0.0; 2])).sum()
    };
    compare_with_differences(&stick, &["m", "k", "limit", "belt"], &gradient, cost, 1e-7);
    assert!(gradient.kept_states as f64 <= 3.0 * (gradient.steps as f64).sqrt() + 40.0);
}

lagrange::system! {
    /// A block that lies on the ground with dry friction, pulled by a growing force.
    #[derive(Clone, Debug)]
    struct Lying;
    param m = 1.0, mu = 0.3, pull = 2.0, g = 9.81;
    coord x, h;
    kinetic = 1/2 * m * (dot(x)^2 + dot(h)^2);
    potential = m * g * h;
    force x = pull * t;
    event ground = h, falling => impact(0);
    friction rub = dot(x), mu * ground;
}

/// Returns half the squares of positions and velocities at samples. The block rests until T = μ m
/// g/p, and then moves as p (t − T)³/6 m.
fn lying_cost(lying: &Lying) -> f64 {
    let (m, pull) = (lying.m, lying.pull);
    let at = |t: f64| {
        let since = (t - lying.mu * m * lying.g / pull).max(0.0);
        energy(t, &[pull * since.powi(3) / (6.0 * m), pull * since * since / (2.0 * m)], &mut [0.0; 2])
    };
    [0.9, 1.8, 2.7, 3.0].map(at).iter().sum()
}

/// The contact is closed from the start, so that the height of the start has no effect.
#[test]
fn a_block_that_lies_and_begins_to_slide_turns_adjoints() {
    let (lying, names) = (Lying::default(), ["m", "mu", "pull", "g"]);
    let run = || lying.simulate([0.0; 4]).until(3.0).every(0.9);
    let adaptive = run().tolerance(1e-11).gradient(names, energy).unwrap();
    let equal = run().method(RungeKutta4 { step: 1e-2 }).gradient(names, energy).unwrap();
    for gradient in [adaptive, equal] {
        compare_with_differences(&lying, &names, &gradient, lying_cost, 1e-10);
        assert!(gradient.by_start[1].abs() < 1e-11, "{:?}", gradient.by_start);
    }
}

#[test]
fn no_steps_leave_the_start_on_closed_contacts() {
    let gradient =
        Lying::default().simulate([0.5, 0.0, 0.0, 0.0]).until(0.0).gradient(["mu"], energy).unwrap();
    assert_eq!((gradient.by[0], gradient.steps), (0.0, 0));
    assert!((gradient.by_start[0] - 0.5).abs() < 1e-12 && gradient.by_start[1] == 0.0);
}

/// One of them does not bounce: a parameter of value zero, at the end of its range.
#[test]
fn impacts_one_after_the_other_turn_adjoints() {
    let pair = Pair { f: 0.0, ..Pair::default() };
    let run = || pair.simulate([1.0, 1.5, 0.0, 0.0]).until(0.8).every(0.3).tolerance(1e-11);
    compare!(run(), ["g", "e", "f"], ["a", "b", "a_dot", "b_dot"], 1e-7);
}

#[test]
fn impacts_at_the_same_time_are_refused_in_words() {
    let pair = Pair::default();
    let refusal = pair.simulate([1.0, 1.0, 0.0, 0.0]).until(0.8).gradient(["g"], first!()).unwrap_err();
    assert!(refusal.to_string().contains("contacts or friction change at the same time"), "{refusal}");
}

lagrange::system! {
    /// A block on two feet, which can also tilt.
    #[derive(Clone, Debug)]
    struct Feet;
    param mu = 0.3, g = 9.81, half = 0.5;
    coord x, h, tilt;
    kinetic = 1/2 * (dot(x)^2 + dot(h)^2 + 0.1 * dot(tilt)^2);
    potential = g * h;
    event left = h - half * sin(tilt), falling => impact(0);
    event right = h + half * sin(tilt), falling => impact(0);
    friction under_left = dot(x), mu * left;
    friction under_right = dot(x), mu * right;
}

/// Closed contacts keep the feet at the same speed, so that they stop together after v²/(2 μ g).
#[test]
fn feet_that_stop_together_have_the_slopes_of_their_common_way() {
    let (feet, v) = (Feet::default(), 2.0);
    let start = [0.0, 0.0, 0.0, v, 0.0, 0.0];
    let gradient = feet.simulate(start).until(2.0).tolerance(1e-11).gradient(["mu", "g"], first!()).unwrap();
    let way = v * v / (2.0 * feet.mu * feet.g);
    assert!((gradient.value - way).abs() < 1e-10);
    for (found, wanted) in gradient.by.iter().zip([-way / feet.mu, -way / feet.g]) {
        assert!((found - wanted).abs() < 1e-8, "{found} {wanted}");
    }
    assert!((gradient.by_start[3] - 2.0 * way / v).abs() < 1e-8, "{:?}", gradient.by_start);
}

lagrange::system! {
    /// A ball that hits another one, which lies against a wall without restitution.
    #[derive(Clone, Debug)]
    struct Row;
    param m = 1.0, n = 2.0, e = 0.5, wind = 1.0;
    coord a, b;
    kinetic = 1/2 * m * dot(a)^2 + 1/2 * n * dot(b)^2;
    force a = -wind;
    force b = -1;
    event meet = a - b, falling => impact(e);
    event wall = b, falling => impact(0);
}

/// At the impact another contact is closed, and remains so.
#[test]
fn an_impact_beside_a_closed_contact_turns_adjoints() {
    let row = Row::default();
    let run = || row.simulate([1.0, 0.0, 0.0, 0.0]).until(2.0).every(0.8).tolerance(1e-11);
    compare!(run(), ["m", "n", "e", "wind"], ["a", "b", "a_dot", "b_dot"], 1e-7);
    // The first ball bounces as from a floor.
    let [by_wind, by_e, by_start] = slopes(2.0, 1.0, 0.5, 1.0);
    let gradient = run().gradient(["wind", "e"], |t, y, slope| {
        slope[0] = if t == 2.0 { 1.0 } else { 0.0 };
        y[0]
    });
    let gradient = gradient.unwrap();
    for (found, wanted) in gradient.by.iter().chain(&gradient.by_start).zip([by_wind, by_e, by_start]) {
        assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
    }
}

lagrange::system! {
    /// A brick that falls on a corner.
    #[derive(Clone, Debug)]
    struct Brick;
    param e = 0.5, mass = 1.0;
    gravity = (0, 0, -9.81);
    body brick { mass: mass; inertia: (0.01, 0.02, 0.025); }
    free brick;
    let corner = brick.point(0.1, 0.05, -0.05);
    event floor = corner.z, falling => impact(e);
}

const BRICK: [f64; 13] = [0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 1.0, -0.5, 0.2];

#[test]
fn a_brick_on_its_corner_turns_adjoints() {
    let brick = Brick::default();
    let run = || brick.simulate(BRICK).until(0.6).every(0.25).tolerance(1e-11);
    compare!(run(), ["e", "mass"], ["brick_wx", "brick_z"], 1e-6);
}

lagrange::system! {
    /// A pendulum in Cartesian coordinates before a stop.
    #[derive(Clone, Debug)]
    struct Held;
    param l = 1, e = 0.4, g = 9.81, low = -0.7;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint rod = x^2 + y^2 - l^2;
    event stop = x - low, falling => impact(e);
}

/// A pendulum on a constraint meets a stop.
#[test]
fn contacts_may_act_beside_constraints() {
    let held = Held::default();
    let run = || held.simulate([0.8, -0.6, 0.0, 0.0]).until(1.6).every(0.4).tolerance(1e-11);
    compare!(run(), ["l", "e", "g", "low"], ["x", "y", "x_dot", "y_dot"], 1e-6);
}
