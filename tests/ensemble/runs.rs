//! Motions of an ensemble can do everything that a single run can.

use std::sync::atomic::{AtomicU64, Ordering};

use lagrange::Ensembles;
use lagrange::contact::Stepped;
use lagrange::ensemble::Moments;
use lagrange::integrate::RungeKutta4;
use lagrange::simulate::{Simulate, Trajectory};
use lagrange::system::Direction;

use crate::{DoublePendulum, start};

lagrange::system! {
    /// A cart pushed by a force.
    #[derive(Clone, Debug)]
    struct Cart;
    param m = 1.0;
    coord x;
    input u;
    kinetic = 1/2 * m * dot(x)^2;
    force x = u;
    output twice = 2 * x;
}

lagrange::system! {
    /// A ball that bounces on the ground.
    #[derive(Clone, Debug)]
    struct Ball;
    param g = 10.0, e = 0.5;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event bounce = y, falling => impact(e);
}

lagrange::system! {
    /// A wheel that falls on a floor with friction.
    #[derive(Clone, Debug)]
    struct Wheel;
    param mu = 0.3, bounce = 0.5;
    coord x, y, phi;
    gravity = (0, -9.81);
    body wheel { mass: 1; center: (x, y); angle: phi; shape: disk(0.2); }
    contact touch = wheel on ground { friction: mu; restitution: bounce; }
}

#[test]
fn another_method_is_that_of_a_single_run() {
    let pendulum = DoublePendulum::default();
    let method = RungeKutta4 { step: 0.01 };
    let starts = [[1.0, 2.0, 0.0, 0.0], [0.5, 0.0, 0.0, 1.0]];
    let ends = pendulum.ensemble(starts).until(2.0).method(method).energy().run().expect("runs");
    assert_eq!(ends.names(), ["theta1", "theta2", "theta1_dot", "theta2_dot", "energy"]);
    for (index, start) in starts.into_iter().enumerate() {
        let trajectory = pendulum.simulate(start).until(2.0).method(method).energy().run().expect("runs");
        assert_eq!(ends.state(index), Some(trajectory.last()));
        let energy =
            |found: &Trajectory<DoublePendulum>| found.column("energy").expect("known").last().copied();
        assert_eq!(ends.column("energy").expect("known").get(index).copied(), energy(&trajectory));
    }
}

#[test]
fn steps_of_contacts_have_the_bits_of_single_runs() {
    let wheel = Wheel::default();
    let vary = |index: usize, wheel: &mut Wheel| wheel.mu = 0.02 * index as f64;
    let start = |index: usize| [0.0, 0.3, 0.0, 1.0 + index as f64, 0.0, 0.0];
    let ensemble = || wheel.ensemble(12).start(move |index, _| start(index)).parameters(vary).until(0.5);
    let method = Stepped::every(1e-3);
    let ends = ensemble().method(method).threads(2).run().expect("runs");
    let samples = ensemble().method(method).every(0.05).run().expect("runs");
    assert!(!ensemble().method(method).is_in_lanes() && ends.failures().is_empty());
    for index in 0..12 {
        let mut alone = wheel.clone();
        vary(index, &mut alone);
        let simulate = || alone.simulate(start(index)).until(0.5).method(method);
        let bits = |state: [f64; 6]| state.map(f64::to_bits);
        assert_eq!(ends.state(index).map(bits), Some(bits(simulate().run().expect("runs").last())));
        let single = simulate().every(0.05).run().expect("runs");
        let motion = samples.motion(index).expect("is there").expect("does not fail");
        assert_eq!((single.x(), single.phi()), (motion.x(), motion.phi()));
    }
    let turned = [0, 11].map(|index| ends.phi()[index]);
    assert!(turned[0] == 0.0 && turned[1] < -1.0, "friction turns the wheel: {turned:?}");
}

#[test]
fn samples_are_trajectories() {
    let pendulum = DoublePendulum::default();
    let samples = pendulum.ensemble(70).start(start).until(1.0).every(0.25).threads(2).run().expect("runs");
    assert_eq!((samples.len(), samples.iter().count(), samples.failures().count()), (70, 70, 0));
    let trajectory = samples.motion(69).expect("is there").expect("does not fail");
    assert_eq!(trajectory.times(), [0.0, 0.25, 0.5, 0.75, 1.0]);
    let single = pendulum.simulate(trajectory.first()).until(1.0).every(0.25).run().expect("runs");
    assert_eq!(single.theta1(), trajectory.theta1());
    assert!(samples.motion(70).is_none());
}

#[test]
fn a_law_drives_every_motion() {
    let cart = Cart::default();
    let ensemble = cart.ensemble(10).start(|i, _| [i as f64, 0.0]).until(3.0);
    let ends = ensemble.drive(|_, _, state| CartInputs { u: -4.0 * state.x }).outputs().run().expect("runs");
    assert_eq!(ends.names(), ["x", "x_dot", "u", "twice"]);
    for (i, x) in ends.x().iter().enumerate() {
        assert!((x - i as f64 * 6.0_f64.cos()).abs() < 1e-7, "{i}: {x}");
        assert_eq!(ends.column("u").expect("known")[i], -4.0 * x);
    }
}

#[test]
fn every_motion_has_a_controller_of_its_own() {
    let cart = Cart::default();
    let controller = |index: usize| {
        let mut pushes = index as f64;
        move |_: &Cart, _: f64, _: CartState| {
            pushes += 1.0;
            CartInputs { u: pushes }
        }
    };
    let ensemble = cart.ensemble(100).start(|_, _| [0.0, 0.0]).until(3.0);
    let ends = ensemble.sampled(1.0, controller).threads(2).run().expect("runs");
    for (i, v) in ends.x_dot().iter().enumerate() {
        assert!((v - (6.0 + 3.0 * i as f64)).abs() < 1e-9, "{i}: {v}");
    }
}

#[test]
fn events_stop_motions_at_their_time() {
    let ball = Ball::default();
    let ensemble = ball.ensemble(20).start(|i, _| [5.0 + i as f64, 0.0]).until(9.0);
    let ends = ensemble.stop_at("low", Direction::Falling, |_, _, [y, _]| y - 1.0).run().expect("runs");
    for (i, time) in ends.times().iter().enumerate() {
        let expected = ((4.0 + i as f64) / 5.0).sqrt();
        assert!((time - expected).abs() < 1e-9, "{i}: {time}");
    }
}

#[test]
fn declared_events_happen_in_motions() {
    let ball = Ball::default();
    let bounces = ball.ensemble(8).start(|i, _| [5.0 + i as f64, 0.0]).until(2.0);
    let bounces = bounces.reduce(0_u64, |sum, motion| *sum += motion.trajectory().events().len() as u64);
    let single = |i| ball.simulate([5.0 + f64::from(i), 0.0]).until(2.0).run().expect("runs").events().len();
    assert_eq!(*bounces.expect("runs"), (0..8).map(|i| single(i) as u64).sum::<u64>());
    assert!(single(0) > 0);
}

#[test]
fn parameters_of_motions_are_columns() {
    let pendulum = DoublePendulum::default();
    let ensemble = || {
        let start = |i: usize, random: &mut _| if i == 3 { [f64::NAN; 4] } else { start(i, random) };
        let motions = pendulum.ensemble(5).start(start).parameters(|i, p| p.m2 = 1.0 + i as f64);
        motions.until(0.1).threads(2)
    };
    let ends = ensemble().energy().run().expect("runs");
    let state = ["theta1", "theta2", "theta1_dot", "theta2_dot"];
    assert_eq!(ends.names(), [&state[..], &["energy", "m1", "m2", "l1", "l2", "g"]].concat());
    assert_eq!(ends.column("m2").expect("known"), [1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(ends.column("g").expect("known"), [9.81; 5]);
    assert!(ends.theta1()[3].is_nan());
    // An observed column replaces the parameter of the same name.
    let ends = ensemble().observe("m2", |system, _, _| 2.0 * system.m2).run().expect("runs");
    assert_eq!(ends.names(), [&state[..], &["m2", "m1", "l1", "l2", "g"]].concat());
    assert_eq!(ends.column("m2").expect("known")[4], 10.0);
    let alike = pendulum.ensemble(5).start(start).until(0.1).run().expect("runs");
    assert_eq!(alike.names(), state);
}

#[test]
fn times_run_from_the_given_start_and_backwards() {
    let cart = Cart::default();
    let ends = cart.ensemble([[0.0, 1.0]]).from(5.0).until(2.0).run().expect("runs");
    assert_eq!(ends.times(), [2.0]);
    assert!((ends.x()[0] + 3.0).abs() < 1e-12);
}

#[test]
fn progress_counts_to_the_end() {
    let pendulum = DoublePendulum::default();
    let (last, calls) = (AtomicU64::new(0), AtomicU64::new(0));
    let ensemble = pendulum.ensemble(300).start(start).until(1.0).threads(2).progress(|done| {
        assert!(done.motions >= last.swap(done.motions, Ordering::Relaxed));
        assert_eq!(done.of, 300);
        calls.fetch_add(1, Ordering::Relaxed);
    });
    let moments = ensemble.reduce(Moments::new(), |moments, motion| moments.add(motion.end_time()));
    assert_eq!(moments.expect("runs").mean(), 1.0);
    assert_eq!(last.into_inner(), 300);
    assert!(calls.into_inner() >= 2);
}

#[test]
fn motions_are_run_again_one_by_one() {
    let pendulum = DoublePendulum::default();
    let ensemble = pendulum.ensemble(10).start(start).until(1.0).seed(3);
    let motion = ensemble.motion(4).expect("is there").expect("does not fail");
    assert_eq!(ensemble.run().expect("runs").state(4), Some(motion.last()));
}
