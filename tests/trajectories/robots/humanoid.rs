//! A humanoid of 29 degrees of freedom stands, and takes a step.
//!
//! Motors hold joints at angles that put pelvis and feet on paths given in advance. The pelvis
//! moves over one foot, the other foot is lifted, put forward and loaded. All of it is so slow that
//! the robot stays in balance at rest. Nothing measures the pelvis.

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::simulate::Trajectory;

use crate::{G, assert_near, tilt};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Humanoid;

    param mu = 0.8, c: N*m*s/rad = 150, c_arm: N*m*s/rad = 4;
    gravity = (0, 0, -9.81);
    body pelvis { mass: 8; shape: cuboid(0.2, 0.3, 0.15); }
    free pelvis;

    input turn[3];
    frame yawed;
    frame bent;
    body torso { mass: 20; shape: cuboid(0.2, 0.35, 0.5); centroid: (0, 0, 0.3); }
    revolute waist_yaw = pelvis to yawed { at: (0, 0, 0.1); damping: c; }
    revolute waist_pitch = yawed to bent { axis: (0, 1, 0); damping: c; }
    revolute waist_roll = bent to torso { axis: (1, 0, 0); damping: c; }
    force waist_yaw = turn[0];
    force waist_pitch = turn[1];
    force waist_roll = turn[2];

    part Leg(pelvis, left, c, mu) {
        input u[6];
        frame turned;
        frame spread;
        frame ankle;
        body thigh { mass: 5; shape: solid_cylinder(0.06, 0.4); centroid: (0, 0, -0.2); }
        body shank { mass: 3; shape: solid_cylinder(0.05, 0.4); centroid: (0, 0, -0.2); }
        body foot { mass: 1.5; shape: cuboid(0.24, 0.12, 0.04); centroid: (0.03, 0, -0.04); }
        revolute yaw = pelvis to turned { at: (0, 0.1 [m] * left, 0); damping: c; }
        revolute roll = turned to spread { axis: (1, 0, 0); damping: c; }
        revolute pitch = spread to thigh { axis: (0, 1, 0); damping: c; }
        revolute knee = thigh to shank { at: (0, 0, -0.4); axis: (0, 1, 0); damping: c; }
        revolute tip = shank to ankle { at: (0, 0, -0.4); axis: (0, 1, 0); damping: c; }
        revolute tilt = ankle to foot { axis: (1, 0, 0); damping: c; }
        force yaw = u[0];
        force roll = u[1];
        force pitch = u[2];
        force knee = u[3];
        force tip = u[4];
        force tilt = u[5];
        for i in 0..4 { contact sole[i] = foot.corner(i) on ground { friction: mu; } }
        output place = foot.origin;
        output load = sum(i in 0..4, sole[i].normal);
    }
    leg[i in 0..2]: Leg { pelvis: pelvis; left: [1, -1]; c: c; mu: mu; }

    part Arm(torso, left, c) {
        input u[4];
        frame swung;
        frame raised;
        body upper { mass: 2; shape: solid_cylinder(0.04, 0.3); centroid: (0, 0, -0.15); }
        body lower { mass: 1.5; shape: solid_cylinder(0.035, 0.3); centroid: (0, 0, -0.15); }
        revolute pitch = torso to swung { at: (0, 0.23 [m] * left, 0.5); axis: (0, 1, 0); damping: c; }
        revolute roll = swung to raised { axis: (1, 0, 0); damping: c; }
        revolute yaw = raised to upper { damping: c; }
        revolute elbow = upper to lower { at: (0, 0, -0.3); axis: (0, 1, 0); damping: c; }
        force pitch = u[0];
        force roll = u[1];
        force yaw = u[2];
        force elbow = u[3];
    }
    arm[i in 0..2]: Arm { torso: torso; left: [1, -1]; c: c_arm; }
}

/// Number of joints with motors.
const JOINTS: usize = 23;
const STEP: f64 = 1e-3;
/// Stiffness of the motors of legs and waist, and of arms.
const STIFFNESS: [f64; 2] = [8000.0, 100.0];
/// Length of thigh and shank.
const LINK: f64 = 0.4;
/// Height of the hips above the ankles, and of ankles above soles.
const HEIGHT: f64 = 0.74;
const ANKLE: f64 = 0.06;
/// Distance of hips and feet from the middle.
const ASIDE: f64 = 0.1;
/// Distance by which the pelvis moves aside. The leg that is lifted stays behind, so this is more
/// than the distance of the foot.
const SHIFT: f64 = 0.12;
/// Length of the step, and height by which the foot is lifted.
const STRIDE: f64 = 0.15;
const LIFT: f64 = 0.05;
const END: f64 = 8.0;

/// Returns a smooth rise from 0 to 1 between two times.
fn rise(t: f64, from: f64, to: f64) -> f64 {
    let part = ((t - from) / (to - from)).clamp(0.0, 1.0);
    0.5 * (1.0 - (std::f64::consts::PI * part).cos())
}

/// Returns the place of the hips, and of the ankle of the foot that moves, at a time.
fn paths(t: f64) -> [[f64; 3]; 2] {
    let aside = SHIFT * (rise(t, 0.5, 2.0) - rise(t, 4.0, 5.5));
    let hips = [0.5 * STRIDE * rise(t, 4.0, 5.5), aside, HEIGHT];
    let lift = LIFT * (rise(t, 2.0, 2.6) - rise(t, 3.2, 3.8));
    [hips, [STRIDE * rise(t, 2.4, 3.4), -ASIDE, lift]]
}

/// Returns the angles of a leg whose foot is level, with its ankle here relative to the hip.
fn leg([x, y, z]: [f64; 3]) -> [f64; 6] {
    let (roll, down) = (y.atan2(-z), y.hypot(z));
    let knee = 2.0 * (x.hypot(down) / (2.0 * LINK)).acos();
    let pitch = (-x).atan2(down) - 0.5 * knee;
    [0.0, roll, pitch, knee, -pitch - knee, -roll]
}

/// Returns the angles of all joints: waist, legs, arms.
fn wanted(t: f64) -> [f64; JOINTS] {
    let [hips, moved] = paths(t);
    let mut angles = [0.0; JOINTS];
    for (i, ankle) in [[0.0, ASIDE, 0.0], moved].into_iter().enumerate() {
        let hip = [hips[0], hips[1] + ASIDE * [1.0, -1.0][i], hips[2]];
        let relative = std::array::from_fn(|axis| ankle[axis] - hip[axis]);
        angles[3 + 6 * i..9 + 6 * i].copy_from_slice(&leg(relative));
    }
    angles
}

/// Stands, takes the step and stands again.
fn stepped() -> Trajectory<Humanoid> {
    let mut start = [0.0; 59];
    (start[2], start[3]) = (HEIGHT + ANKLE, 1.0);
    start[7..30].copy_from_slice(&wanted(0.0));
    let law = |robot: &Humanoid, t: f64, state: HumanoidState| {
        let (q, now, next) = (state.coordinates(), wanted(t), wanted(t + STEP));
        HumanoidInputs::from(std::array::from_fn(|i| {
            let (k, c) = if i < 15 { (STIFFNESS[0], robot.c) } else { (STIFFNESS[1], robot.c_arm) };
            k * (now[i] - q[7 + i]) + c * (next[i] - now[i]) / STEP
        }))
    };
    let method = Stepped::every(STEP).largest_residual(1e-6);
    let robot = Humanoid::default();
    let run = robot.simulate(start).until(END).method(method).sampled(STEP, law);
    run.outputs().run().expect("it stands")
}

#[test]
fn a_humanoid_takes_a_step_and_stands() {
    let run = stepped();
    let column = |name: &str| run.column(name).expect("recorded");
    let states = run.iter().map(|(_, y)| y).collect::<Vec<_>>();
    let end = run.last();
    assert_near("tilt of the pelvis", states.iter().map(|y| tilt([y[3], y[4], y[5], y[6]])), 0.0, 0.03);
    // The foot is in the air from 2.4 s to 3.4 s, and put down a step further. The other one stays.
    let [load, place] = [column("leg[1].load"), column("leg[1].place.x")];
    assert_near("load of the lifted foot", load[2400..3400].iter().copied(), 0.0, 0.0);
    assert_near("lifted foot", place[8000..].iter().copied(), STRIDE, 5e-3);
    assert_near("standing foot", column("leg[0].place.x").iter().copied(), 0.0, 5e-3);
    // At rest, both feet carry the weight, and the pelvis is between them.
    let carried = load[8000] + column("leg[0].load")[8000];
    assert_near("weight", [carried].into_iter(), 54.0 * G, 0.1);
    assert_near("pelvis", [end[0] - 0.5 * STRIDE, end[1]].into_iter(), 0.0, 5e-3);
    assert_near("velocities", end[30..].iter().copied(), 0.0, 2e-3);
    assert_eq!(run.work().inexact, 0);
}
