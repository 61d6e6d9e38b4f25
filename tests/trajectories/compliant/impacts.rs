//! Normal forces: rest, impacts without and with dissipation, and energy.

use lagrange::Simulate;
use lagrange::integrate::Radau5;

use crate::{G, assert_near};

/// Restitution and duration of impacts, by `tools/compliant.py`.
const IMPACTS: &str = include_str!("impacts.csv");
const MASS: f64 = 1.3;
const STIFFNESS: f64 = 2e4;

lagrange::system! {
    /// A ball that falls on the ground.
    #[derive(Clone, Debug)]
    struct Ball;

    param k = 20000, g = 9.81, d = 0;
    coord y;
    gravity = (0, -g);
    body ball { mass: 1.3; center: (0, y); }
    contact touch = ball on ground { stiffness: k; dissipation: d; }
    event edge = touch.gap, crossing => record;
    output load = touch.normal;
    output push = touch.force;
}

lagrange::system! {
    /// A ball in a bowl that also bounds it from above.
    #[derive(Clone, Debug)]
    struct Bowl;

    param k = 5000, r = 0.1, large = 1;
    coord x, y;
    circle bowl { radius: large; }
    gravity = (0, -9.81);
    body ball { mass: 0.5; center: (x, y); angle: 0; shape: disk(r); }
    contact touch = ball inside bowl { stiffness: k; }
}

lagrange::system! {
    /// A ball pulled out of a sticky floor.
    #[derive(Clone, Debug)]
    struct Pulled;

    param k = 10000, d = 50, push = 100;
    coord y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (0, y); }
    contact touch = ball on ground { stiffness: k; dissipation: d; }
    force y = if t < 0.5 { 0 } else { if t < 0.53 { push } else { 0 } };
    output load = touch.normal;
    output gap = touch.gap;
}

#[test]
fn a_ball_at_rest_sinks_by_its_weight_over_the_stiffness() {
    let ball = Ball { d: 2.0, ..Ball::default() };
    let run = ball.simulate([0.001, 0.0]).until(20.0).method(Radau5::tolerance(1e-10)).record("load").run();
    let run = run.unwrap();
    assert_near([run.last()[0]], [-MASS * G / STIFFNESS], 1e-6);
    let depth = MASS * G / STIFFNESS;
    let resting = ball.simulate([-depth, 0.0]).until(10.0).record("load").run().unwrap();
    assert_near(resting.last(), [-depth, 0.0], 1e-9);
    assert_near([*resting.column("load").unwrap().last().unwrap()], [MASS * G], 1e-6);
}

/// About rest the damping is k d δ₀ = m g d, whatever the stiffness.
#[test]
fn small_oscillations_decay_with_gravity_times_dissipation() {
    let ball = Ball { d: 2.0, ..Ball::default() };
    let (depth, omega, amplitude) = (MASS * G / STIFFNESS, (STIFFNESS / MASS).sqrt(), 1e-5);
    let end = 0.2;
    let [y, v] = ball.simulate([amplitude - depth, 0.0]).until(end).tolerance(1e-12).run().unwrap().last();
    let wanted = amplitude * (-0.5 * G * ball.d * end).exp();
    let found = (y + depth).hypot(v / omega);
    assert!((found / wanted - 1.0).abs() < 0.1, "{found} {wanted}");
}

/// Impacts last from first touch until separation. Runs record both ends as events.
#[test]
fn impacts_have_the_restitution_and_the_duration_of_the_reference() {
    for line in IMPACTS.lines().skip(1) {
        let row = line.split(',').map(|entry| entry.parse().unwrap()).collect::<Vec<f64>>();
        let [d, speed, g, restitution, duration] = row.try_into().unwrap();
        let ball = Ball { g, d, ..Ball::default() };
        let fall = 1e-3;
        let run = ball.simulate([fall * speed, -(speed * speed - 2.0 * g * fall * speed).sqrt()]);
        let run = run.until(0.1).tolerance(1e-13).run().unwrap();
        let [before, after] = [0, 1].map(|index| run.events()[index].clone());
        let (first, second) = (before.state[1], after.state[1]);
        assert_near([first], [-speed], 1e-11 * speed);
        assert_near([second / speed], [restitution], 1e-9);
        assert_near([after.time - before.time], [duration], 1e-10);
    }
}

#[test]
fn energy_stays_where_nothing_is_lost() {
    let ball = Ball::default();
    let run = ball.simulate([1.0, 0.0]).until(10.0).tolerance(1e-12).energy().run().unwrap();
    let energy = run.column("energy").unwrap();
    let drift = energy.iter().map(|e| (e / energy[0] - 1.0).abs()).fold(0.0, f64::max);
    assert!(drift < 1e-11, "{drift}");
    assert!(run.events().len() >= 20);
    // Between curved walls, which it hits in every direction.
    let run = Bowl::default().simulate([0.2, 0.3, 1.0, 0.5]).until(10.0).tolerance(1e-12).energy().run();
    let energy = run.unwrap().column("energy").unwrap().to_vec();
    let drift = energy.iter().map(|e| (e / energy[0] - 1.0).abs()).fold(0.0, f64::max);
    assert!(drift < 1e-10, "{drift}");
}

/// The elastic part alone would pull: the force on a rapidly rising ball is zero, not negative.
#[test]
fn a_contact_never_pulls() {
    let pulled = Pulled::default();
    let run = pulled.simulate([-9.81 / 1e4, 0.0]).until(0.6).record("load").record("gap").run().unwrap();
    let (loads, gaps) = (run.column("load").unwrap(), run.column("gap").unwrap());
    assert!(loads.iter().all(|load| *load >= 0.0));
    let released = loads.iter().zip(gaps).filter(|(load, gap)| **load == 0.0 && **gap < 0.0).count();
    assert!(released > 2);
    // Once separated, only its weight acts.
    let radau = pulled.simulate([-9.81 / 1e4, 0.0]).until(0.6).method(Radau5::tolerance(1e-11)).run();
    assert_near(radau.unwrap().last(), run.last(), 1e-7);
}

#[test]
fn forces_vanish_in_the_air_and_depths_of_zero_have_none() {
    let ball = Ball { d: 0.5, ..Ball::default() };
    for y in [1.0, 1e-300, 0.0] {
        for v in [-3.0, 0.0, 5.0] {
            assert_eq!(ball.load(0.0, &[y], &[v]).to_bits(), 0);
            assert_eq!(ball.acceleration(0.0, &[y], &[v]), [-9.81]);
        }
    }
    // 20000 · 0.01 · (1 + 0.5 · 0.2), and the clamp.
    assert_near([ball.load(0.0, &[-0.01], &[-0.2])], [220.0], 1e-12);
    assert_eq!(ball.load(0.0, &[-0.01], &[2.5]), 0.0);
    assert_near(ball.push(0.0, &[-0.01], &[-0.2]), [0.0, 220.0], 1e-12);
}
