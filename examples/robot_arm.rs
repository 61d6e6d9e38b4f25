//! A robot arm with six joints, declared with one line for each body and each joint.
//!
//! Masses, centroids and joints are taken from the public description of the UR5. Accelerations
//! without torques are compared with those of Pinocchio's articulated-body algorithm. Then the arm
//! follows a path of its joints under computed torques: inverse dynamics of the desired motion,
//! with springs and dampers on deviations. Its hand carries a load that the controller does not
//! know.
//!
//! Look for the small deviation of the hand from its path, and for its lag without feedback.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A UR5 with a load in its hand.
    #[derive(Clone, Debug)]
    pub struct RobotArm;

    /// Weight in the hand.
    param weight: N = 0;
    input u1: N*m, u2: N*m, u3: N*m, u4: N*m, u5: N*m, u6: N*m;

    gravity = (0, 0, -9.81);
    body shoulder { mass: 3.7; inertia: (0.010267495893, 0.010267495893, 0.00666); }
    body upper_arm { mass: 8.393; centroid: (0, 0, 0.28); inertia: (0.22689067591, 0.22689067591, 0.0151074); }
    body forearm { mass: 2.275; centroid: (0, 0, 0.25); inertia: (0.049443313556, 0.049443313556, 0.004095); }
    body wrist1 { mass: 1.219; inertia: (0.111172755531, 0.111172755531, 0.21942); }
    body wrist2 { mass: 1.219; inertia: (0.111172755531, 0.111172755531, 0.21942); }
    body wrist3 { mass: 0.1879; inertia: (0.0171364731454, 0.0171364731454, 0.033822); }

    revolute pan = ground to shoulder { at: (0, 0, 0.089159); }
    revolute lift = shoulder to upper_arm { at: (0, 0.13585, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    revolute elbow = upper_arm to forearm { at: (0, -0.1197, 0.425); axis: (0, 1, 0); }
    revolute roll1 = forearm to wrist1 { at: (0, 0, 0.39225); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    revolute roll2 = wrist1 to wrist2 { at: (0, 0.093, 0); }
    revolute roll3 = wrist2 to wrist3 { at: (0, 0, 0.09465); axis: (0, 1, 0); }

    force pan = u1;
    force lift = u2;
    force elbow = u3;
    force roll1 = u4;
    force roll2 = u5;
    force roll3 = u6;
    force (0, 0, -weight) at wrist3.point(0, 0.0823 m, 0);
    output hand = wrist3.point(0, 0.0823 m, 0);
}

/// Coordinates and velocities of a state.
const STATE: ([f64; 6], [f64; 6]) = (
    [
        -1.6574033314255026,
        -1.0527579736156012,
        1.2050978608255876,
        0.32864814425747113,
        -1.6234854310384033,
        -0.2674922390541048,
    ],
    [
        -0.04189740371833195,
        -0.6805221707258429,
        0.46915430281842907,
        -0.7726559601571932,
        -0.21754361900867591,
        0.03348036524272735,
    ],
);
const ACCELERATIONS: [f64; 6] = [
    1.4063440862208123,
    9.494371311748454,
    12.148137086261498,
    -21.492332174242005,
    1.220779193101263,
    -1.27306933866015,
];

/// Stiffness of the feedback per inertia, in 1/s².
const STIFFNESS: f64 = 400.0;
/// Damping of the feedback per inertia, in 1/s: critical.
const DAMPING: f64 = 40.0;

fn main() -> Result<(), Box<dyn Error>> {
    let arm = RobotArm::default();
    let (q, v) = STATE;
    let accelerations = arm.acceleration(0.0, &q, &v);
    let names = ["pan", "lift", "elbow", "roll1", "roll2", "roll3"];
    let rows: [_; 6] = std::array::from_fn(|i| (names[i], accelerations[i], ACCELERATIONS[i]));
    compare("accelerations without torques", 1e-13, &rows);

    let loaded = RobotArm { weight: 5.0, ..arm };
    let [followed, strayed] = [(STIFFNESS, DAMPING), (0.0, 0.0)].map(|gains| furthest(&loaded, gains));
    let (followed, strayed) = (followed?, strayed?);
    println!(
        "hand off its path by {:.2} mm at most, without feedback by {:.0} mm",
        followed * 1e3,
        strayed * 1e3
    );
    assert!(followed < 5e-3 && strayed > 0.1);
    Ok(())
}

/// Returns oscillating joint angles, with their rates and accelerations.
fn path(t: f64) -> [[f64; 6]; 3] {
    let (from, by, rate) = ([0.0, -1.2, 1.0, -0.5, -1.5, 0.0], [0.8, 0.5, -0.7, 0.4, 0.6, 1.0], 2.0);
    let (sin, cos) = (rate * t).sin_cos();
    let along = |factor: f64| std::array::from_fn(|i| factor * by[i]);
    [std::array::from_fn(|i| from[i] + by[i] * (1.0 - cos)), along(rate * sin), along(rate * rate * cos)]
}

/// Computes the torques (Siciliano, Sciavicco, Villani, Oriolo, *Robotics*, §8.5.2) of a controller
/// that knows the arm but not its load.
fn torques(t: f64, state: RobotArmState, (stiffness, damping): (f64, f64)) -> RobotArmInputs {
    let (q, v) = (state.coordinates(), state.velocities());
    let [wanted, rate, acceleration] = path(t);
    let corrected = std::array::from_fn(|i| {
        acceleration[i] + damping * (rate[i] - v[i]) + stiffness * (wanted[i] - q[i])
    });
    RobotArmInputs::from(RobotArm::default().inverse_dynamics(t, &q, &v, &corrected))
}

/// Returns the largest distance of the hand from its target, within 2 s.
fn furthest(arm: &RobotArm, gains: (f64, f64)) -> Result<f64, Box<dyn Error>> {
    let [start, rest, _] = path(0.0);
    let law = |_: &RobotArm, t: f64, state: RobotArmState| torques(t, state, gains);
    let start = [start, rest].concat();
    let start = <[f64; 12]>::try_from(start).map_err(|_| "six angles and six rates")?;
    let motion = arm.simulate(start).until(2.0).drive(law).tolerance(1e-9).every(0.01).run()?;
    let distances = motion.iter().map(|(t, y)| {
        let [is, should] = [RobotArmState::from(y).coordinates(), path(t)[0]].map(|q| arm.hand(t, &q, &rest));
        is.iter().zip(should).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    });
    Ok(distances.fold(0.0, f64::max))
}
