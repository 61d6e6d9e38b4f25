//! A hand of three fingers holds a ball by friction.
//!
//! Springs and dampers of the joints press n fingertips with the forces N against the equator of
//! the ball. The weight m g hangs on the friction n μ N, so the smallest coefficient is
//! μ = m g/(n N). Springs are relaxed at the angles at which they balance these forces and the
//! weights of the links.

use lagrange::Simulate;
use lagrange::contact::{Friction, Stepped};
use lagrange::simulate::Trajectory;

use crate::{G, assert_near};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Hand;

    param mu = 0.5, m = 0.2, k: N*m/rad = 20, c: N*m*s/rad = 0.05, relaxed1: rad = 0, relaxed2: rad = 0;
    gravity = (0, 0, -9.81);
    body ball { mass: m; shape: solid_sphere(0.04); }
    free ball;

    part Finger(ball, phi, mu, k, c, relaxed1, relaxed2) {
        body near { mass: 0.05; shape: solid_cylinder(0.01, 0.06); centroid: (0, 0, -0.03); }
        body far { mass: 0.03; shape: solid_cylinder(0.01, 0.05); centroid: (0, 0, -0.025); }
        revolute base = ground to near { at: (0.06 [m] * cos(phi), 0.06 [m] * sin(phi), 0); turned: (0, 0, phi); axis: (0, 1, 0); damping: c; }
        revolute knuckle = near to far { at: (0, 0, -0.06); axis: (0, 1, 0); damping: c; }
        potential = 1/2 * k * ((base - relaxed1)^2 + (knuckle - relaxed2)^2);
        contact tip = far.point(0, 0, -0.05 [m]) on ball { radius: 0.01; friction: mu; }
        output normal = tip.normal;
    }
    finger[i in 0..3]: Finger {
        ball: ball; phi: i * 2 * pi / 3; mu: mu; k: k; c: c; relaxed1: relaxed1; relaxed2: relaxed2;
    }
}

const STEP: f64 = 1e-3;
/// Force with which each finger presses.
const GRIP: f64 = 4.0;
/// Radius of the ball, and distances of bases and fingertips from the axis of the hand.
const BALL: f64 = 0.04;
const BASE: f64 = 0.06;
const TIP: f64 = 0.05;
/// Lengths of the links of a finger, and their masses.
const LENGTHS: [f64; 2] = [0.06, 0.05];
const MASSES: [f64; 2] = [0.05, 0.03];
/// Angle of the first joints: fingers open outwards.
const OPEN: f64 = -0.5;

/// Returns the angle of the second joint, and the height of the fingertip below the base.
fn pose() -> [f64; 2] {
    let inwards = BASE - TIP - LENGTHS[0] * OPEN.sin();
    let far = (inwards / LENGTHS[1]).asin();
    [far - OPEN, LENGTHS[0] * OPEN.cos() + LENGTHS[1] * far.cos()]
}

/// Returns a hand with this coefficient of friction, and its start, at which springs balance the
/// forces of a ball that is held.
fn hand(mu: f64) -> (Hand, [f64; 25]) {
    let mut hand = Hand { mu, ..Hand::default() };
    let [knuckle, depth] = pose();
    let (near, far) = (OPEN, OPEN + knuckle);
    let middle = [-LENGTHS[0] * near.sin(), -LENGTHS[0] * near.cos()];
    // From the joints to the point of contact, outwards and up.
    let levers = [[BALL - BASE, -depth], [BALL - BASE - middle[0], -depth - middle[1]]];
    let weight = hand.m * G / 3.0;
    let touch = levers.map(|[out, up]| GRIP * up + weight * out);
    let far_weight = 0.5 * MASSES[1] * G * LENGTHS[1] * far.sin();
    let near_weight = (0.5 * MASSES[0] + MASSES[1]) * G * LENGTHS[0] * near.sin();
    hand.relaxed1 = near + (near_weight + far_weight - touch[0]) / hand.k;
    hand.relaxed2 = knuckle + (far_weight - touch[1]) / hand.k;
    let mut start = [0.0; 25];
    (start[2], start[3]) = (-depth, 1.0);
    start[7..13].copy_from_slice(&[near, knuckle, near, knuckle, near, knuckle]);
    (hand, start)
}

/// Lets the hand hold the ball with this part of the least friction.
fn held(part: f64) -> Trajectory<Hand> {
    let least = 0.2 * G / (3.0 * GRIP);
    let (hand, start) = hand(part * least);
    let run = hand.simulate(start).until(1.0).method(Stepped::every(STEP).largest_residual(1e-6));
    run.outputs().run().expect("it moves")
}

#[test]
fn it_holds_a_ball_with_more_than_the_least_friction_and_drops_it_with_less() {
    let tight = held(1.02);
    assert_near("heights", tight.iter().map(|(_, y)| y[2]), -pose()[1], 1e-12);
    for finger in 0..3 {
        let normal = tight.column(&format!("finger[{finger}].normal")).expect("recorded");
        assert_near("normal forces", normal[1..].iter().copied(), GRIP, 1e-9);
    }
    let mode = tight.system_at_end().map(|hand| hand.finger_0_tip_friction);
    assert_eq!((mode, tight.work().inexact), (Some(Friction::Sticks), 0));
    let loose = held(0.98);
    let fallen = -pose()[1] - loose.last()[2];
    assert!(fallen > 0.1, "it fell {fallen} m");
}
