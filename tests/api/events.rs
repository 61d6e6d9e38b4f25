//! Declared events in runs of emitted types.

use std::f64::consts::PI;

use lagrange::Simulate;
use lagrange::event::MAX_LOCATED;
use lagrange::simulate::Ending;
use lagrange::system::OdeSystem;

lagrange::system! {
    /// A system with the largest number of events that the language allows.
    struct Many;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    for i in 0..448 { event e[i] = x - i - 1, rising => record; }
}

lagrange::system! {
    struct Oscillator;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    event up = x, rising => record;
    event down = x, falling => record;
    event middle = x, crossing => record;
    event end = t - 10, rising => stop;
}

lagrange::system! {
    /// Two carts of different mass on one rail collide without loss.
    struct Carts;

    param m = 1.0, n = 3.0;
    coord a, b;
    kinetic = 1/2 * m * dot(a)^2 + 1/2 * n * dot(b)^2;
    event hit = b - a, falling => {
        dot(a) = dot(a) - 2 * n / (m + n) * (dot(a) - dot(b));
        dot(b) = dot(b) + 2 * m / (m + n) * (dot(a) - dot(b));
    }
}

lagrange::system! {
    /// A ball on a string; the multiplier is positive where the string would have to push.
    struct Ball;

    param m = 0.5, l = 2.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint string = hypot(x, y) - l;
    event slack = string, rising => stop;
}

#[test]
fn the_largest_number_of_events_is_found_in_order() {
    let count = MAX_LOCATED - 64;
    assert_eq!(Many::EVENTS.len(), count);
    let run = Many.simulate([0.5, 2.0]).until(240.0).run().expect("runs");
    let found: Vec<_> = run.events().iter().map(|event| event.name.clone()).collect();
    let expected: Vec<_> = (0..count).map(|i| format!("e[{i}]")).collect();
    assert_eq!(found, expected);
    for (event, passed) in run.events().iter().zip(1..) {
        assert!((event.time - (f64::from(passed) - 0.5) / 2.0).abs() < 1e-11);
    }
}

#[test]
fn directions_choose_zeros_and_the_start_is_not_one() {
    let run = Oscillator.simulate([0.0, 1.0]).until(20.0).run().expect("runs");
    let count = |name: &str| run.events().iter().filter(|event| event.name == name).count();
    assert_eq!([count("up"), count("down"), count("middle"), count("end")], [1, 2, 3, 1]);
    let times = run.events().iter().filter(|event| event.name == "middle").map(|event| event.time);
    for (time, half_turns) in times.zip(1..) {
        assert!((time - f64::from(half_turns) * PI).abs() < 1e-8);
    }
    assert!((run.end_time() - 10.0).abs() < 1e-12);
    assert_eq!(run.ending(), Ending::Stopped);
}

#[test]
fn assignments_are_made_at_once() {
    let run = Carts { m: 1.0, n: 3.0 }.simulate([0.0, 1.0, 2.0, -1.0]).until(1.0).run().expect("runs");
    let [_, _, a, b] = run.last();
    assert!((a + 2.5).abs() < 1e-12 && (b - 0.5).abs() < 1e-12, "{a} {b}");
    assert_eq!(run.events().len(), 1);
}

/// The tension is `m v²/l − m g cos`. By the energy, the string becomes slack at the height
/// `(v₀² − 2 g l) / (3 g)` above the pivot.
#[test]
fn a_string_becomes_slack_where_its_force_would_turn() {
    let ball = Ball::default();
    let speed = (3.5 * ball.g * ball.l).sqrt();
    let run = ball.simulate([0.0, -ball.l, speed, 0.0]).until(5.0).tolerance(1e-11).run().expect("runs");
    let [x, y, ..] = run.last();
    assert!((y - ball.l / 2.0).abs() < 1e-8, "{y}");
    assert!((x.hypot(y) - ball.l).abs() < 1e-12);
    assert_eq!(run.events()[0].name, "slack");
}

#[test]
fn resets_that_accumulate_are_named() {
    lagrange::system! {
        struct Dropped;
        coord y;
        kinetic = 1/2 * dot(y)^2;
        potential = 9.81 * y;
        event floor = y, falling => { dot(y) = -dot(y) / 2; }
    }
    let error =
        Dropped.simulate([1.0, 0.0]).until(30.0).run().expect_err("it does not fall through the floor");
    let message = error.to_string();
    assert!(message.contains("event `floor`") && message.contains("`impact(…)`"), "{message}");
    assert!(error.trajectory.y().iter().all(|y| *y > -1e-9));
}
