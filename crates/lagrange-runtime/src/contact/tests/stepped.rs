//! Steps in velocities of hand-written systems.

use super::systems::{Ball, Block, CLOSED, Cradle, FREE, OPEN, STICKS, Slider};
use crate::contact::{Friction, Mode, Stepped};
use crate::integrate::{Method, Stepper};
use crate::simulate::Simulate;

/// Height of a ball released at 1, with e = 0.8, at its first highest point after a bounce.
const HIGHEST: f64 = 0.64;

#[test]
fn a_ball_bounces_by_newtons_law_and_comes_to_rest() {
    let highest = |h: f64| {
        let ball = Ball::new(0.8);
        let run = ball.simulate([1.0, 0.0]).until(1.2).method(Stepped::every(h)).run().expect("it bounces");
        let after = run.iter().filter(|(time, _)| *time > 0.5);
        after.map(|(_, [y, _])| y).fold(0.0, f64::max)
    };
    let errors = [4e-3, 1e-3].map(|h| (highest(h) - HIGHEST).abs());
    assert!(errors[0] < 0.03 && errors[1] < 0.008, "{errors:?}");
    let ball = Ball::new(0.8);
    let run = ball.simulate([1.0, 0.0]).until(6.0).method(Stepped::every(1e-3)).run().expect("it rests");
    assert!(run.iter().all(|(_, [y, _])| y > -1e-12));
    assert!(run.last().iter().all(|entry| entry.abs() < 1e-9), "{:?}", run.last());
    assert_eq!(run.system_at_end().map(|ball| ball.modes), Some([CLOSED]));
    assert!(run.events().is_empty());
}

#[test]
fn a_ball_that_overlaps_is_pushed_apart_and_gets_no_speed() {
    let ball = Ball::new(0.0);
    let run = ball.simulate([-0.1, 0.0]).until(0.1).method(Stepped::every(1e-3)).run().expect("it rises");
    assert!(run.iter().all(|(_, [y, v])| y <= 1e-12 && v.abs() < 1e-12));
    assert!(run.last()[0].abs() < 1e-7, "{:?}", run.last());
}

#[test]
fn a_block_on_a_belt_sticks_until_the_spring_tears_it_away() {
    let block = Block {
        m: 1.0,
        stiffness: 0.0,
        drive: 2.0,
        belt: 0.5,
        weight: 0.0,
        kinetic: 1.0,
        fixed: 1.5,
        modes: [FREE],
    };
    let run = block.simulate([0.0, 0.5]).until(2.0).method(Stepped::every(1e-3)).run().expect("it moves");
    let at = |wanted: f64| run.iter().find(|(time, _)| *time > wanted).map(|(_, [_, v])| v).expect("a time");
    assert!((at(0.7) - 0.5).abs() < 1e-12, "it sticks up to the static limit at 0.75");
    // For t above 0.75: v̇ = 2 t − 1.
    let wanted = 0.5 + (4.0 - 0.75 * 0.75) - 1.25;
    assert!((run.last()[1] - wanted).abs() < 5e-3, "{} for {wanted}", run.last()[1]);
    let modes = run.system_at_end().map(|block| block.modes);
    assert_eq!(modes, Some([Mode::Friction(Friction::SlipsForwards)]));
}

#[test]
fn a_block_that_is_thrown_slides_and_stops() {
    let slider = Slider {
        m: 2.0,
        g: 10.0,
        e: 0.0,
        kinetic: 0.25,
        fixed: 0.25,
        pull: 0.0,
        lift: 0.0,
        modes: [OPEN, FREE],
    };
    let run = slider.simulate([0.0, 0.0, 2.0, 0.0]).until(1.0).method(Stepped::every(1e-3)).run();
    let run = run.expect("it slides");
    let path = 4.0 / (2.0 * 2.5);
    assert!((run.last()[0] - path).abs() < 2e-3 && run.last()[2].abs() < 1e-12, "{:?}", run.last());
    assert_eq!(run.system_at_end().map(|slider| slider.modes), Some([CLOSED, STICKS]));
}

#[test]
fn balls_that_hit_each_other_together_gain_no_energy() {
    for e in [0.0, 0.5, 1.0] {
        let cradle = Cradle { masses: [1.0, 2.0, 0.5], e, modes: [OPEN; 2] };
        let start = [-0.1, 0.0, 0.0, 3.0, 0.0, 0.0];
        let run = cradle.simulate(start).until(0.2).method(Stepped::every(1e-3)).run().expect("they hit");
        let [.., a, b, c] = run.last();
        assert!((a + 2.0 * b + 0.5 * c - 3.0).abs() < 1e-12, "momentum");
        let energy = 0.5 * (a * a + 2.0 * b * b + 0.5 * c * c);
        assert!(energy <= 4.5 + 1e-12 && (e > 0.0 || energy < 2.0), "{e}: {energy}");
    }
}

#[test]
fn a_stepper_can_be_driven_by_hand() {
    let ball = Ball::new(0.0);
    let method = Stepped::every(0.01);
    let mut stepper = method.start(&ball, 0.0, &[0.01, -2.0], 10.0).expect("it starts");
    stepper.step(&ball, 10.0).expect("a step");
    assert!(stepper.state()[0].abs() < 1e-15, "it touches at the end of the step");
    stepper.step(&ball, 10.0).expect("a step");
    assert_eq!(stepper.in_modes(&ball).map(|ball| ball.modes), Some([CLOSED]));
    assert!((stepper.impulses()[0] - 2.0 * (1.0 + 0.01 * 9.81)).abs() < 1e-12, "{:?}", stepper.impulses());
    assert!(stepper.worst_residual() < 1e-12);
    let middle = stepper.interpolate(&ball, 0.015);
    assert!((middle[1] + 0.5).abs() < 1e-12, "half of the velocity that is left: {middle:?}");
    stepper.restart(&ball, 1.0, &[1.0, 0.0]).expect("in the air");
    assert_eq!(stepper.impulses(), &[0.0]);
    assert_eq!(stepper.in_modes(&ball).map(|ball| ball.modes), Some([OPEN]));
}
