//! Motions with contacts, through the loops.

use std::vec::Vec;

use super::systems::{Ball, CLOSED, Cradle, OPEN, Rod};
use crate::contact::{ContactSystem, reactions};
use crate::integrate::{IntegrationError, RungeKutta4, Verner98};
use crate::run::{integrate, integrate_with_events};
use crate::simulate::{Ending, Simulate};
use crate::system::{Action, Direction, EventKind, StepFailure, split};

/// Time at which a ball falling from 1 m at g = 9.81 first hits the ground, then that at which it
/// rests for e = 0.8.
const FIRST: f64 = 0.451_523_640_985_73;
const REST: f64 = 4.063_712_768_871_58;

fn pair() -> Verner98<f64> {
    Verner98::tolerance(1e-12)
}

fn force(ball: &Ball, t: f64, y: &[f64; 2]) -> f64 {
    let (q, v) = split::<Ball>(y);
    reactions(&ball.terms(t, &q, &v), &ball.modes)[0]
}

#[test]
fn a_ball_comes_to_rest_where_its_bounces_accumulate() {
    let ball = Ball::new(0.8);
    let simulation = ball.simulate([1.0, 0.0]).until(6.0).tolerance(1e-12);
    let trajectory = simulation.observe("N", force).run().expect("no hang and no error");
    assert_eq!(trajectory.ending(), Ending::Reached);
    let events = trajectory.events();
    assert!((events[0].time - FIRST).abs() < 1e-12);
    let Some(EventKind::Closed { at, .. }) = events.last().map(|event| event.kind) else {
        panic!("{events:?}")
    };
    assert!((at - REST).abs() < 1e-11, "{at}");
    assert!((80..120).contains(&events.len()) && trajectory.work().steps < 2_000, "{:?}", trajectory.work());
    assert_eq!(trajectory.last(), [0.0, 0.0]);
    assert_eq!(trajectory.system_at_end().map(|ball| ball.modes), Some([CLOSED]));
    let forces = trajectory.column("N").expect("observed");
    assert_eq!(forces[0], 0.0);
    assert!((forces[forces.len() - 1] - 2.0 * 9.81).abs() < 1e-14);
}

#[test]
fn every_loss_of_a_bouncing_ball_is_reported() {
    let ball = Ball::new(0.8);
    let simulation = ball.simulate([1.0, 0.0]).until(6.0).tolerance(1e-12);
    let trajectory = simulation.run().expect("runs");
    let losses: Vec<f64> = trajectory
        .events()
        .iter()
        .map(|event| match event.kind {
            EventKind::Impact(impact) | EventKind::Closed { impact, .. } => impact.energy_loss,
            other => panic!("{other:?}"),
        })
        .collect();
    assert!((losses.iter().sum::<f64>() - 2.0 * 9.81).abs() < 1e-11);
    let (_, thrown_back) = losses.split_last().expect("it falls");
    assert!(thrown_back.windows(2).all(|pair| (pair[1] - 0.64 * pair[0]).abs() < 1e-4 * pair[0]));
}

#[test]
fn a_ball_at_rest_leaves_the_floor_when_it_is_lifted() {
    // The lift exceeds the weight from t = m g/lift = 6.54.
    let ball = Ball { lift: 3.0, ..Ball::new(0.5) };
    let trajectory = ball.simulate([0.0, 0.0]).until(8.0).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    assert_eq!((event.name.as_str(), event.kind), ("floor", EventKind::Opened));
    assert!((event.time - 6.54).abs() < 1e-12);
    let since: f64 = 8.0 - 6.54;
    assert!((trajectory.last()[0] - 3.0 / 2.0 * since.powi(3) / 6.0).abs() < 1e-11);
    assert_eq!(trajectory.system_at_end().map(|ball| ball.modes), Some([OPEN]));
}

#[test]
fn a_run_can_be_continued_where_it_ended() {
    let ball = Ball { lift: 3.0, ..Ball::new(0.8) };
    let whole = ball.simulate([1.0, 0.0]).until(8.0).tolerance(1e-12).run().expect("runs");
    let first = ball.simulate([1.0, 0.0]).until(6.0).tolerance(1e-12).run().expect("runs");
    let switched = first.system_at_end().expect("the ball lies on the floor");
    let second = switched.simulate(first.last()).from(6.0).until(8.0).tolerance(1e-12).run().expect("runs");
    assert!((whole.last()[0] - second.last()[0]).abs() < 1e-11);
    assert_eq!(first.events().len() + second.events().len(), whole.events().len());
}

#[test]
fn all_loops_and_methods_tell_the_same() {
    let ball = Ball::new(0.8);
    let there =
        integrate(&ball, 0.0, [1.0, 0.0], 2.0, &pair(), |_, y| assert!(y[0] >= -1e-12)).expect("runs");
    let mut heights = Vec::new();
    let (_, same) = integrate_with_events(
        &ball,
        (0.0, [1.0, 0.0]),
        2.0,
        &pair(),
        ([Direction::Falling], |_, y: &[f64; 2]| [y[1]]),
        |top| {
            heights.push(top.state[0]);
            Action::Continue
        },
    )
    .expect("runs");
    assert_eq!(there, same);
    for (n, height) in heights.iter().enumerate() {
        assert!((height - 0.8_f64.powi(2 * n as i32 + 2)).abs() < 1e-11, "{height}");
    }
    let door = ball.simulate([1.0, 0.0]).until(2.0).tolerance(1e-12).run().expect("runs");
    assert_eq!(door.last(), same);
    let fixed = ball.simulate([1.0, 0.0]).until(2.0).method(RungeKutta4 { step: 1e-2 }).run().expect("runs");
    assert!((fixed.last()[0] - same[0]).abs() < 1e-11 && (fixed.last()[1] - same[1]).abs() < 1e-11);
}

#[test]
fn a_body_that_touches_and_goes_down_at_the_start_hits_at_once() {
    let trajectory = Ball::new(0.8).simulate([0.0, -1.0]).until(0.1).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    assert!(event.time < 1e-12 && matches!(event.kind, EventKind::Impact(_)));
    assert!((trajectory.last()[0] - (0.08 - 0.5 * 9.81 * 0.01)).abs() < 1e-12);
}

/// A ball is thrown so that it just reaches a ceiling, modelled as an inverted floor.
#[test]
fn a_ball_that_just_touches_continues() {
    let ball = Ball { g: -9.81, ..Ball::new(0.5) };
    let speed = (2.0_f64 * 9.81).sqrt();
    let trajectory = ball.simulate([1.0, -speed]).until(1.0).tolerance(1e-13).run().expect("runs");
    let slow = trajectory.events().iter().all(|event| match event.kind {
        EventKind::Impact(impact) => impact.impulse < 1e-5,
        _ => false,
    });
    assert!(slow, "{:?}", trajectory.events());
    let t: f64 = 1.0;
    assert!((trajectory.last()[0] - (1.0 - speed * t + 0.5 * 9.81 * t * t)).abs() < 1e-6);
}

#[test]
fn given_and_declared_events_come_in_the_order_of_time() {
    let trajectory = Ball::new(0.8)
        .simulate([1.0, 0.0])
        .until(1.0)
        .tolerance(1e-12)
        .event("half", Direction::Falling, |_, _, y| y[0] - 0.5)
        .event("ground", Direction::Falling, |_, _, y| y[0])
        .event("top", Direction::Falling, |_, _, y| y[1])
        .run()
        .expect("runs");
    let names: Vec<&str> = trajectory.events().iter().map(|event| event.name.as_str()).collect();
    assert_eq!(names, ["half", "floor", "ground", "top", "half"]);
    let [_, floor, ground, ..] = trajectory.events() else { panic!() };
    assert_eq!(floor.time, ground.time);
    assert!(floor.state[1] < 0.0 && ground.state[1] > 0.0, "the second finds what the first left");
}

#[test]
fn a_kick_opens_a_closed_contact() {
    let trajectory = Ball::new(0.5)
        .simulate([0.0, 0.0])
        .until(2.0)
        .tolerance(1e-12)
        .event_with("kick", Direction::Rising, |_, t, _| t - 1.0, |_, _| Action::Replace([0.0, 2.0]))
        .observe("N", force)
        .run()
        .expect("runs");
    let forces = trajectory.column("N").expect("observed");
    let kick = trajectory.events()[0].time;
    for (t, n) in trajectory.times().iter().zip(forces) {
        assert!(if *t < kick { *n == 2.0 * 9.81 } else { true });
    }
    let (after, _) = trajectory.iter().enumerate().filter(|(_, (t, _))| *t == kick).last().expect("a sample");
    assert_eq!(forces[after], 0.0, "the sample after the kick has no contact force");
    let hits: Vec<f64> = trajectory.events()[1..].iter().map(|event| event.time).collect();
    assert!((hits[0] - (1.0 + 4.0 / 9.81)).abs() < 1e-11, "{hits:?}");
}

#[test]
fn contacts_do_not_run_backwards() {
    let error = Ball::new(0.5).simulate([1.0, 0.0]).until(-1.0).run().expect_err("refused");
    assert!(matches!(error.cause, StepFailure::Setting(_)));
    let refused = integrate(&Ball::new(0.5), 0.0, [1.0, 0.0], -1.0, &pair(), |_, _| {});
    assert!(matches!(refused, Err(IntegrationError { cause: StepFailure::Setting(_), .. })));
}

#[test]
fn an_inconsistent_start_is_refused_by_name() {
    let error = Ball::new(0.5).simulate([-1.0, 0.0]).until(1.0).run().expect_err("refused");
    assert!(matches!(error.cause, StepFailure::Violated(violation) if violation.constraint == "floor"));
    assert_eq!((error.time(), error.state()), (0.0, [-1.0, 0.0]));
}

#[test]
fn balls_a_hair_apart_pass_the_motion_on() {
    let cradle = Cradle { masses: [1.0; 3], e: 1.0, modes: [OPEN; 2] };
    let start = [0.0, 1.0, 1.0 + 1e-6, 1.0, 0.0, 0.0];
    let trajectory = cradle.simulate(start).until(2.0).tolerance(1e-12).run().expect("runs");
    let y = trajectory.last();
    for (v, wanted) in y[3..].iter().zip([0.0, 0.0, 1.0]) {
        assert!((v - wanted).abs() < 1e-12, "{y:?}");
    }
}

/// A rod that falls broadside onto two supports rattles and comes to rest on both, with half of its
/// weight on each.
#[test]
fn a_rod_comes_to_rest_on_two_supports() {
    let rod = Rod::new(9.81, 0.6);
    for angle in [0.0, 0.1] {
        let start = [0.5, angle, 0.0, 0.0];
        let simulation = rod.simulate(start).until(8.0).tolerance(1e-10).max_steps(3_000);
        let trajectory = simulation.run().expect("comes to rest");
        let end = trajectory.system_at_end().expect("switched");
        assert_eq!(end.modes, [CLOSED; 2], "from {angle}");
        let (q, v) = split::<Rod>(&trajectory.last());
        let forces = reactions(&end.terms(8.0, &q, &v), &end.modes);
        assert!(forces.iter().all(|force| (force - 1.5 * 9.81).abs() < 1e-10), "{forces:?}");
    }
}
