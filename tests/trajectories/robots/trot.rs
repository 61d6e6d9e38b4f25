//! A quadruped trots: diagonal legs swing together, on foot paths given in advance.
//!
//! Masses, centres of mass and joints are those of `examples/quadruped.rs`, a Unitree Go2. Motors
//! hold joints at angles that put the feet on their paths. Nothing measures the trunk.

use std::f64::consts::{FRAC_PI_2, TAU};

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::simulate::Trajectory;

use crate::{assert_near, tilt};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Go2;

    param mu = 0.8, damping: N*m*s/rad = 20;
    gravity = (0, 0, -9.81);
    body trunk { mass: 7.277000000000002; centroid: (0.020079174385048755, 0, -0.005103488525491267); inertia: (0.0257151774237163, 0.10295388328825997, 0.11264519436454368, 0.0001216600000000001, 0.001523257166511061, -0.000031200000000000006); }
    free trunk;

    part Leg(trunk, front, left, damping, mu) {
        input u[3];
        body hip { mass: 0.767; centroid: (-0.004773402868318123 [m] * front, 0.0016974837027379402 [m] * left, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, -0.0000021220993324641458 [kg*m^2] * front * left, 0.000001065392550195567 [kg*m^2] * front, -0.0000014027352647979139 [kg*m^2] * left); }
        body thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, -0.02302074939564867 [m] * left, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, 0.00009030533435616439 [kg*m^2] * left, -0.00029910392372602736, 0.0008351509180338437 [kg*m^2] * left); }
        body calf { mass: 0.194; centroid: (0.004350103092783504, -0.0007739690721649483 [m] * left, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, 0.0000005096540206185566 [kg*m^2] * left, 0.00000014759587628866708, 0.000011313958762886598 [kg*m^2] * left); }
        revolute roll = trunk to hip { at: (0.1934 [m] * front, 0.0465 [m] * left, 0); axis: (1, 0, 0); damping: damping; }
        revolute pitch = hip to thigh { at: (0, 0.0955 [m] * left, 0); axis: (0, 1, 0); damping: damping; }
        revolute knee = thigh to calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: damping; }
        force roll = u[0];
        force pitch = u[1];
        force knee = u[2];
        contact foot = calf.point(0, 0, -0.213 [m]) on ground { friction: mu; radius: 0.022; }
        output normal = foot.normal;
        output slip = foot.slip;
    }
    leg[i in 0..4]: Leg {
        trunk: trunk; front: [1, 1, -1, -1]; left: [1, -1, 1, -1]; damping: damping; mu: mu;
    }
}

const STEP: f64 = 1e-3;
/// Stiffness of the motors, in N m/rad.
const STIFFNESS: f64 = 800.0;
/// Length of thigh and calf.
const LINK: f64 = 0.213;
/// Height of the hips above the centres of the feet on the ground.
const HEIGHT: f64 = 0.28;
/// Time for which a pair of feet stays on the ground.
const STANCE: f64 = 0.2;
/// Height by which feet are lifted.
const LIFT: f64 = 0.05;
/// Time in which the speed grows from zero.
const RAMP: f64 = 0.8;
/// Duration of the trot.
const END: f64 = 4.0;

/// Speed at which feet on the ground move backwards relative to the trunk.
const SPEED: f64 = 0.4;
/// Radius of a foot.
const FOOT: f64 = 0.022;

/// Returns the place of a foot relative to its hip, forwards and up. At both ends of the swing, it
/// moves as the ground does.
fn path(t: f64, leg: usize) -> [f64; 2] {
    let late = if leg == 1 || leg == 2 { 0.5 } else { 0.0 };
    let phase = 2.0 * (0.5 * t / STANCE + late).fract();
    let reach = 0.5 * SPEED * STANCE * (t / RAMP).min(1.0);
    if phase < 1.0 {
        return [reach * (1.0 - 2.0 * phase), -HEIGHT];
    }
    let swing = phase - 1.0;
    let (sin, cos) = (TAU * swing).sin_cos();
    [reach * (2.0 * swing - 1.0 - sin / FRAC_PI_2), 0.5 * LIFT * (1.0 - cos) - HEIGHT]
}

/// Returns roll, pitch and knee that put a foot at this place relative to its hip.
fn angles([x, z]: [f64; 2]) -> [f64; 3] {
    let knee = -2.0 * (x.hypot(z) / (2.0 * LINK)).acos();
    [0.0, (-x).atan2(-z) - 0.5 * knee, knee]
}

/// Returns the angles of all joints that put the feet on their paths.
fn wanted(t: f64) -> [f64; 12] {
    let legs = [0, 1, 2, 3].map(|leg| angles(path(t, leg)));
    std::array::from_fn(|i| legs[i / 3][i % 3])
}

fn trotted() -> Trajectory<Go2> {
    let mut start = [0.0; 37];
    (start[2], start[3]) = (HEIGHT + FOOT, 1.0);
    start[7..19].copy_from_slice(&wanted(0.0));
    // Joints have dampers, so motors compensate for the rates that are wanted.
    let law = |go2: &Go2, t: f64, state: Go2State| {
        let (q, now, next) = (state.coordinates(), wanted(t), wanted(t + STEP));
        let motor = |i: usize| STIFFNESS * (now[i] - q[7 + i]) + go2.damping * (next[i] - now[i]) / STEP;
        Go2Inputs::from(std::array::from_fn(motor))
    };
    let go2 = Go2::default();
    let method = Stepped::every(STEP).largest_residual(1e-6);
    go2.simulate(start).until(END).method(method).sampled(STEP, law).outputs().run().expect("it trots")
}

#[test]
fn a_quadruped_trots_at_the_speed_of_its_feet() {
    let run = trotted();
    let states = run.iter().map(|(_, y)| y).collect::<Vec<_>>();
    // Five cycles at full speed.
    let forwards = states[4000][0] - states[2000][0];
    assert_near("distance", [forwards].into_iter(), 2.0 * SPEED, 0.03);
    assert_near("deviation", states.iter().map(|y| y[1]), 0.0, 0.02);
    assert_near("height", states.iter().map(|y| y[2]), HEIGHT + FOOT, 0.015);
    assert_near("tilt", states.iter().map(|y| tilt([y[3], y[4], y[5], y[6]])), 0.0, 0.03);
    assert_eq!(run.work().inexact, 0);
}

#[test]
fn feet_of_a_trot_are_lifted_in_turn_and_slip_little() {
    let run = trotted();
    for leg in 0..4 {
        let column = |name: &str| run.column(&format!("leg[{leg}].{name}")).expect("recorded");
        let (normal, x, y) = (column("normal"), column("slip.x"), column("slip.y"));
        let loaded = (2000..4000).filter(|k| normal[*k] > 0.0).collect::<Vec<_>>();
        let part = loaded.len() as f64 / 2000.0;
        assert!((0.4..0.6).contains(&part), "leg {leg} is on the ground for {part} of the time");
        let slid = loaded.iter().map(|k| STEP * x[*k].hypot(y[*k])).sum::<f64>();
        assert!(slid < 0.02 * 2.0 * SPEED, "leg {leg} slides by {slid} m in 2 s");
    }
}
