//! An arm with seven joints, whose hand moves along a tilted circle, always pointing down.
//!
//! Masses and joints are taken from the public description of the Franka Emika Panda. Seven joints
//! for six degrees of freedom of the hand leave one. With the desired twist (ω, ẋ) of the hand and
//! its Jacobian J, rates of the joints are
//!
//! ```text
//! v = z + Jᵀ (J Jᵀ)⁻¹ (twist − J z),   z = κ (q₀ − q),
//! ```
//!
//! the rates closest to z that move the hand in this way, where z returns to a comfortable posture
//! q₀. See Siciliano, Sciavicco, Villani, Oriolo, *Robotics*, §3.5. After each step inverse
//! kinematics puts the hand back on the circle, by 10⁻⁹ m or so. A thousand times a second a
//! controller computes torques. If it knew the load of the hand, deviations e of the joints would
//! decay as ë + 2 ω ė + ω² e = 0 (§8.5.2 there). It does not know the load, which causes additional
//! accelerations d, and
//! |e| ≤ max |d| / ω², since the response of a critically damped oscillator to an impulse never changes its sign.
//!
//! Torques and the motion of the hand are compared with Pinocchio's (`tools/robots.py`). Look for
//! the deviations compared with their bound.
//!
//! `cargo run --example panda --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;
use lagrange::kinematics::{FrameTask, InverseKinematics, resolved_rates};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// The arm, with motors in its joints and a weight in its hand.
    #[derive(Clone, Debug)]
    pub struct Panda;

    param weight: N = 0;
    input u1: N*m, u2: N*m, u3: N*m, u4: N*m, u5: N*m, u6: N*m, u7: N*m;

    gravity = (0, 0, -9.81);
    body l1 { mass: 4.970684; centroid: (0.003875, 0.002081, -0.04762); inertia: (0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169); }
    body l2 { mass: 0.646926; centroid: (-0.003141, -0.02872, 0.003495); inertia: (0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704); }
    body l3 { mass: 3.228604; centroid: (0.027518, 0.039252, -0.066502); inertia: (0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805); }
    body l4 { mass: 3.587895; centroid: (-0.05317, 0.104419, 0.027454); inertia: (0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641); }
    body l5 { mass: 1.225946; centroid: (-0.011953, 0.041065, -0.038437); inertia: (0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229); }
    body l6 { mass: 1.666555; centroid: (0.060149, -0.014117, -0.010517); inertia: (0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341); }
    body base { mass: 2.8; shape: solid_cylinder(0.05, 0.3); }
    /// The last link with the hand and its fingers.
    body l7 {
        mass: 1.495522;
        centroid: (0.0017208742976286579, 0.00136035441716123, 0.1004852811486558);
        inertia: (0.016529853712634626, 0.014107248642161839, 0.006676955556640956, 0.0003948922971191777, -0.0007066957106145017, -0.001051105327046708);
    }
    frame hand;

    weld ground to base { at: (0, 0, 0.15); }
    revolute q1 = ground to l1 { at: (0, 0, 0.333); }
    revolute q2 = l1 to l2 { turned: (-pi/2, 0, 0); }
    revolute q3 = l2 to l3 { at: (0, -0.316, 0); turned: (pi/2, 0, 0); }
    revolute q4 = l3 to l4 { at: (0.0825, 0, 0); turned: (pi/2, 0, 0); }
    revolute q5 = l4 to l5 { at: (-0.0825, 0.384, 0); turned: (-pi/2, 0, 0); }
    revolute q6 = l5 to l6 { turned: (pi/2, 0, 0); }
    revolute q7 = l6 to l7 { at: (0.088, 0, 0); turned: (pi/2, 0, 0); }
    weld l7 to hand { at: (0, 0, 0.2104); turned: (0, 0, -pi/4); }

    force q1 = u1;
    force q2 = u2;
    force q3 = u3;
    force q4 = u4;
    force q5 = u5;
    force q6 = u6;
    force q7 = u7;
    force (0, 0, -weight) at hand;
    emit { frames, frame_jacobians, drawing }
}

/// A posture.
const HOME: [f64; 7] = [0.0, -FRAC_PI_4, 0.0, -3.0 * FRAC_PI_4, 0.0, FRAC_PI_2, FRAC_PI_4];
/// Coordinates of a state.
const Q: [f64; 7] = [0.25, -0.5, 0.375, -2.125, -0.25, 1.75, 0.5];
/// Velocities of the state.
const V: [f64; 7] = [0.5, -0.25, 0.75, 1.0, -1.25, 0.5, 2.0];
/// Accelerations in the state.
const A: [f64; 7] = [1.0, 2.0, -1.5, 0.5, 3.0, -2.5, 1.25];
/// Torques at rest in the posture, torques of the motion, and position, angular velocity and
/// velocity of the hand, by Pinocchio 4.1. The last are its accelerations, angular first, at
/// constant velocities of the joints.
const HOLDING: [f64; 7] = [
    0.0,
    -3.9878158574251565,
    -0.6440003196651145,
    22.021020590949522,
    0.633846185489833,
    2.278164530104095,
    0.0,
];
const TORQUES: [f64; 7] = [
    0.0017712415493393464,
    -10.30684608647931,
    -5.950141711954296,
    20.793087611374457,
    0.36713927068412155,
    1.8469846767944937,
    0.023450871368836116,
];
const PLACE: [f64; 3] = [0.36625297797456646, 0.22209572097179964, 0.5125704664534304];
const TWIST: [f64; 6] = [
    0.07740748810251508,
    -2.7733994080548294,
    -0.17113270676322073,
    -0.04914850780843477,
    0.5247842971324577,
    0.6947391845303984,
];
const BIAS: [f64; 6] = [
    6.770238336707277,
    -0.3614319070280238,
    1.3697742228590783,
    -1.9157299724072188,
    0.49157479049677194,
    0.5799869976392127,
];

const END: f64 = 3.0;
const PERIOD: f64 = 1e-3;
/// Orientation of the hand with X ahead and Z down.
const DOWN: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
/// Rate of the feedback in 1/s.
const FEEDBACK: f64 = 30.0;
/// Rate of the return to the posture in 1/s.
const COMFORT: f64 = 0.5;
/// Load in N.
const LOAD: f64 = 10.0;

fn main() -> Result<(), Box<dyn Error>> {
    let arm = Panda::default();
    check_torques(&arm);
    let plan = plan(&arm)?;
    let off_circle = plan.iter().enumerate().map(|(k, joints)| {
        let (is, should) = (arm.hand_frame(0.0, &joints.q).1, circle(k as f64 * PERIOD));
        distance(is, should)
    });
    println!("circle: planned joints miss it by {:.1e} m at most", off_circle.fold(0.0, f64::max));

    let empty = follow(&arm, &plan)?;
    let loaded = Panda { weight: LOAD, ..arm };
    let run = follow(&loaded, &plan)?;
    report([&empty, &run].map(|run| deviations(run, &plan)), bounds(&loaded, &run));
    for (name, run) in [("without", &empty), ("with", &run)] {
        let off = run
            .iter()
            .map(|(t, y)| distance(loaded.hand_frame(t, &PandaState::from(y).coordinates()).1, circle(t)));
        println!("{name} load: hand off the circle by {:.4} mm at most", 1e3 * off.fold(0.0, f64::max));
    }
    draw(&loaded, &run)
}

/// Compares torques and the motion of the hand.
fn check_torques(arm: &Panda) {
    let rest = [0.0; 7];
    let holding = arm.inverse_dynamics(0.0, &HOME, &rest, &rest);
    let torques = arm.inverse_dynamics(0.0, &Q, &V, &A);
    let names = ["u1, N m", "u2", "u3", "u4", "u5", "u6", "u7"];
    compare("held at rest", 1e-13, &[0, 1, 2, 3, 4, 5, 6].map(|i| (names[i], holding[i], HOLDING[i])));
    compare("in motion", 1e-13, &[0, 1, 2, 3, 4, 5, 6].map(|i| (names[i], torques[i], TORQUES[i])));
    let (_, place) = arm.hand_frame(0.0, &Q);
    let twist = times(&arm.hand_jacobian(0.0, &Q), &V);
    let names = ["x, m", "y, m", "z, m"];
    compare("hand", 1e-14, &[0, 1, 2].map(|i| (names[i], place[i], PLACE[i])));
    let names = ["omega_x, rad/s", "omega_y", "omega_z", "v_x, m/s", "v_y", "v_z"];
    compare("its motion", 1e-14, &[0, 1, 2, 3, 4, 5].map(|i| (names[i], twist[i], TWIST[i])));
    let bias = arm.hand_bias_acceleration(0.0, &Q, &V);
    let names = ["alpha_x, rad/s^2", "alpha_y", "alpha_z", "a_x, m/s^2", "a_y", "a_z"];
    compare("its bias acceleration", 1e-14, &[0, 1, 2, 3, 4, 5].map(|i| (names[i], bias[i], BIAS[i])));
}

/// Returns the target position of the hand: once around, from rest to rest with the least jerk.
fn circle(t: f64) -> [f64; 3] {
    const START: [f64; 3] = [0.30689056659294117, 0.0, 0.4868820523028392];
    const RADIUS: f64 = 0.15;
    let part = (t / END).clamp(0.0, 1.0);
    let (sin, cos) = (TAU * part.powi(3) * (10.0 - 15.0 * part + 6.0 * part * part)).sin_cos();
    // In the plane of (0.8, 0, −0.6) and y.
    let (ahead, aside) = (RADIUS * (1.0 - cos), RADIUS * sin);
    [START[0] + 0.8 * ahead, START[1] + aside, START[2] - 0.6 * ahead]
}

/// Angles of the joints, their rates, and mean accelerations up to the next instant.
#[derive(Clone, Copy)]
struct Joints {
    q: [f64; 7],
    v: [f64; 7],
    a: [f64; 7],
}

/// Plans the joint angles at every instant: by the midpoint rule, then on the circle.
fn plan(arm: &Panda) -> Result<Vec<Joints>, Box<dyn Error>> {
    let count = (END / PERIOD).round() as usize;
    let (mut q, mut plan) = (HOME, Vec::with_capacity(count + 1));
    let mut v = rates(arm, 0.0, &q);
    for k in 0..=count {
        let t = k as f64 * PERIOD;
        let middle = rates(arm, t + 0.5 * PERIOD, &plus(&q, 0.5 * PERIOD, &v));
        let hand = [FrameTask::pose(Panda::hand_frame, Panda::hand_jacobian, (DOWN, circle(t + PERIOD)))];
        let next = arm.reach(&hand, &plus(&q, PERIOD, &middle)).solve()?.q;
        let after = rates(arm, t + PERIOD, &next);
        plan.push(Joints { q, v, a: std::array::from_fn(|i| (after[i] - v[i]) / PERIOD) });
        (q, v) = (next, after);
    }
    Ok(plan)
}

/// Returns the joint rates that move the hand along the circle and keep its orientation.
fn rates(arm: &Panda, t: f64, q: &[f64; 7]) -> [f64; 7] {
    const MOMENT: f64 = 1e-5;
    let (ahead, behind) = (circle(t + MOMENT), circle(t - MOMENT));
    let [x, y, z] = std::array::from_fn(|i| (ahead[i] - behind[i]) / (2.0 * MOMENT));
    let comfortable = std::array::from_fn(|i| COMFORT * (HOME[i] - q[i]));
    resolved_rates(&arm.hand_jacobian(t, q), &[0.0, 0.0, 0.0, x, y, z], &comfortable)
}

/// Simulates the motion under torques that are computed without knowledge of the load, and held
/// between instants.
fn follow(arm: &Panda, plan: &[Joints]) -> Result<Trajectory<Panda>, Box<dyn Error>> {
    let known = Panda::default();
    let control = |_: &Panda, t: f64, state: PandaState| {
        let wanted = plan[(t / PERIOD).round() as usize];
        let (q, v) = (state.coordinates(), state.velocities());
        let corrected = std::array::from_fn(|i| {
            wanted.a[i] + 2.0 * FEEDBACK * (wanted.v[i] - v[i]) + FEEDBACK * FEEDBACK * (wanted.q[i] - q[i])
        });
        PandaInputs::from(known.inverse_dynamics(t, &q, &v, &corrected))
    };
    let start: [f64; 14] = std::array::from_fn(|i| if i < 7 { plan[0].q[i] } else { plan[0].v[i - 7] });
    let run = arm.simulate(start).until(END).sampled(PERIOD, control).every(PERIOD).tolerance(1e-9).dense();
    Ok(run.run()?)
}

/// Returns the largest deviation of each joint.
fn deviations(run: &Trajectory<Panda>, plan: &[Joints]) -> [f64; 7] {
    run.iter().zip(plan).fold([0.0; 7], |largest, ((_, y), wanted)| {
        let q = PandaState::from(y).coordinates();
        std::array::from_fn(|i| f64::max(largest[i], (wanted.q[i] - q[i]).abs()))
    })
}

/// Returns the largest accelerations caused by the load, over ω².
fn bounds(loaded: &Panda, run: &Trajectory<Panda>) -> [f64; 7] {
    let empty = Panda::default();
    run.iter().fold([0.0; 7], |largest, (t, y)| {
        let state = PandaState::from(y);
        let (q, v) = (state.coordinates(), state.velocities());
        let (with, without) = (loaded.acceleration(t, &q, &v), empty.acceleration(t, &q, &v));
        std::array::from_fn(|i| f64::max(largest[i], (with[i] - without[i]).abs() / FEEDBACK.powi(2)))
    })
}

/// Prints deviations without load, caused by the piecewise constant torques, and with load next to
/// their bound.
///
/// # Panics
/// If a deviation exceeds the bound by more than the deviation without load.
fn report([empty, loaded]: [[f64; 7]; 2], bounds: [f64; 7]) {
    println!("{:>16} {:>24} {:>24} {:>10}", "deviation, mrad", "without load", "with load", "bound");
    for i in 0..7 {
        let [empty, loaded, bound] = [empty[i], loaded[i], bounds[i]].map(|angle| 1e3 * angle);
        println!("{:>15}{} {empty:>24.4} {loaded:>24.4} {bound:>10.4}", "q", i + 1);
        assert!(loaded < bound + empty, "a joint is further off than its bound");
    }
}

/// Draws the arm after two thirds of the time, and a film.
fn draw(arm: &Panda, run: &Trajectory<Panda>) -> Result<(), Box<dyn Error>> {
    let wanted = (0..=100).map(|k| circle(END * f64::from(k) / 100.0));
    let drawing = Drawing::of(arm)
        .title("An arm with seven joints")
        .view(0.9, 0.35)
        .nameless()
        .floor(0.0)
        .path("", wanted)
        .trace("", |arm, t, y| {
            let state = PandaState::from(*y);
            arm.hand_frame(t, &state.coordinates()).1
        });
    let shown = 0.6 * END;
    let past = run.iter().filter(|(t, _)| *t < shown).step_by(20);
    let still = drawing.clone().past(past).picture(shown, &run.at(shown)?)?;
    still.save(gallery::picture("panda.png")?)?;
    drawing.clone().film_at(30.0, run)?.save(gallery::picture("panda.html")?)?;
    drawing.size(360.0, 300.0).film_at(10.0, run)?.save(gallery::picture("panda.gif")?)?;
    Ok(())
}

fn times(matrix: &[[f64; 7]; 6], vector: &[f64; 7]) -> [f64; 6] {
    matrix.map(|row| inner(&row, vector))
}

fn inner(a: &[f64; 7], b: &[f64; 7]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn plus(a: &[f64; 7], factor: f64, b: &[f64; 7]) -> [f64; 7] {
    std::array::from_fn(|i| a[i] + factor * b[i])
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}
