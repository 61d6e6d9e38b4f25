//! Inertial parameters of a robot arm, estimated from the torques of its motors.
//!
//! The arm is a UR5 by Universal Robots, with masses and inertias from its public description, and
//! friction in the joints. Its hand carries an unknown load. The joints follow sums of sines for
//! ten seconds. Torques are measured with noise of 0.5 N m in the three large joints and of 0.05 N
//! m in the others. From these the base parameters are estimated.
//!
//! References: an arm of six revolute joints, the first one vertical, has 7 · 6 − 6 = 36 base
//! parameters. The formula is in Khalil, Dombre, *Modeling, Identification and Control of Robots*,
//! §9.4. Pinocchio's regressors have the same rank (`tools/regressors.py`). Look for standard
//! errors that cover the true values, and for the predicted torques of a motion that was not
//! measured.

mod common;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use lagrange::identification::{Estimate, Identifies};

lagrange::system! {
    /// A UR5 with viscous and dry friction.
    #[derive(Clone, Debug)]
    pub struct Ur5;

    param load: kg = 0, reach: m = 0.1;
    param viscous[6]: N*m*s/rad = 0, dry[6]: N*m = 0;
    const slip: rad/s = 0.01, palm: kg = 0.1879;
    gravity = (0, 0, -9.81);

    body shoulder { mass: 3.7; inertia: (0.0102675, 0.0102675, 0.00666); }
    revolute q1 = ground to shoulder { at: (0, 0, 0.089159); damping: viscous[0]; }
    body upper_arm { mass: 8.393; centroid: (0, 0, 0.28); inertia: (0.2268907, 0.2268907, 0.0151074); }
    revolute q2 = shoulder to upper_arm { at: (0, 0.13585, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); damping: viscous[1]; }
    body forearm { mass: 2.275; centroid: (0, 0, 0.25); inertia: (0.0494433, 0.0494433, 0.004095); }
    revolute q3 = upper_arm to forearm { at: (0, -0.1197, 0.425); axis: (0, 1, 0); damping: viscous[2]; }
    body wrist1 { mass: 1.219; inertia: (0.1111728, 0.1111728, 0.21942); }
    revolute q4 = forearm to wrist1 { at: (0, 0, 0.39225); turned: (0, pi/2, 0); axis: (0, 1, 0); damping: viscous[3]; }
    body wrist2 { mass: 1.219; inertia: (0.1111728, 0.1111728, 0.21942); }
    revolute q5 = wrist1 to wrist2 { at: (0, 0.093, 0); damping: viscous[4]; }
    body hand { mass: palm + load; inertia: (0.0171365, 0.0171365, 0.033822); centroid: (0, load * reach / (palm + load), 0); }
    revolute q6 = wrist2 to hand { at: (0, 0, 0.09465); axis: (0, 1, 0); damping: viscous[5]; }

    force q1 = -dry[0] * tanh(dot(q1) / slip);
    force q2 = -dry[1] * tanh(dot(q2) / slip);
    force q3 = -dry[2] * tanh(dot(q3) / slip);
    force q4 = -dry[3] * tanh(dot(q4) / slip);
    force q5 = -dry[4] * tanh(dot(q5) / slip);
    force q6 = -dry[5] * tanh(dot(q6) / slip);
    emit { regressor }
}

/// Noise levels.
const NOISE: [f64; 6] = [0.5, 0.5, 0.5, 0.05, 0.05, 0.05];
/// Number of base parameters of bodies.
const OF_BODIES: usize = 36;

/// Returns positions, velocities and accelerations: four harmonics of 0.1 Hz with phases that
/// depend on the seed.
fn posture(t: f64, seed: f64) -> [[f64; 6]; 3] {
    let joints: [[f64; 3]; 6] = core::array::from_fn(|joint| motion(t, seed + 2.472_136 * joint as f64));
    [0, 1, 2].map(|order| joints.map(|motion| motion[order]))
}

/// Returns the motion of one joint.
fn motion(t: f64, seed: f64) -> [f64; 3] {
    let mut motion = [0.0; 3];
    for harmonic in 1..=4 {
        let (rate, amplitude) = (TAU * 0.1 * f64::from(harmonic), 1.2 / f64::from(harmonic));
        let phase = TAU * (seed + 0.381_966 * f64::from(harmonic)).fract();
        let (sin, cos) = (rate * t + phase).sin_cos();
        motion[0] += amplitude * sin;
        motion[1] += amplitude * rate * cos;
        motion[2] -= amplitude * rate * rate * sin;
    }
    motion
}

/// A generator of normally distributed numbers, the same in every run (Box and Muller 1958, on
/// splitmix64).
struct Normal(u64);

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((bits ^ (bits >> 31)) >> 11) as f64 + 0.5) / 53.0_f64.exp2()
    }

    fn next(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}

fn measured(model: &Ur5, arm: &Ur5) -> Result<Estimate, Box<dyn Error>> {
    let (mut regression, mut normal) = (model.regression(), Normal(5));
    for step in 0..1000 {
        let t = 0.01 * f64::from(step);
        let [q, v, a] = posture(t, 0.0);
        let mut torques = arm.inverse_dynamics(t, &q, &v, &a);
        for (torque, level) in torques.iter_mut().zip(NOISE) {
            *torque += level * normal.next();
        }
        regression.add(t, &q, &v, &a, &torques);
    }
    Ok(regression.estimate()?)
}

/// Returns the root mean squares of the torques of a motion that was not measured, and of their
/// errors for given parameters.
fn validation(arm: &Ur5, parameters: &[f64]) -> [f64; 2] {
    let mut squares = [0.0; 2];
    for step in 0..500 {
        let t = 0.02 * f64::from(step);
        let [q, v, a] = posture(t, 0.37);
        let rows = arm.regressor(t, &q, &v, &a);
        for (row, torque) in rows.iter().zip(arm.inverse_dynamics(t, &q, &v, &a)) {
            let predicted = row.iter().zip(parameters).map(|(y, p)| y * p).sum::<f64>();
            squares[0] += torque * torque;
            squares[1] += (torque - predicted) * (torque - predicted);
        }
    }
    squares.map(|sum| (sum / 3000.0_f64).sqrt())
}

fn main() -> Result<(), Box<dyn Error>> {
    // The public description includes neither load nor friction.
    let model = Ur5::default();
    let arm = Ur5 {
        load: 1.5,
        viscous: [8.0, 9.0, 7.0, 1.5, 1.2, 1.0],
        dry: [6.0, 7.0, 5.0, 1.0, 0.8, 0.7],
        ..model.clone()
    };
    let base = model.base_parameters()?;
    println!("combinations that torques tell:\n{base}");
    let of_bodies = base.parameters().iter().filter(|parameter| parameter.terms[0].0.contains('.')).count();
    compare("base parameters of the bodies", 1e-15, &[("number", of_bodies as f64, OF_BODIES as f64)]);

    let estimate = measured(&model, &arm)?;
    println!("estimates ± standard errors (public description):\n{estimate}");
    let levels = NOISE.iter().zip(estimate.noise()).map(|(level, found)| ("level", found / level, 1.0));
    compare("noise", 0.1, &levels.collect::<Vec<_>>());
    let truth = arm.regressor_parameters();
    let deviations = estimate
        .values()
        .iter()
        .map(|value| (value.value - value.parameter.value(&truth)) / value.standard_error);
    let deviations = deviations.collect::<Vec<_>>();
    let count = deviations.len() as f64;
    let spread = (deviations.iter().map(|deviation| deviation * deviation).sum::<f64>() / count).sqrt();
    compare("deviations in standard errors", 0.35, &[("root mean square", spread, 1.0)]);

    let [torques, errors] = validation(&arm, estimate.parameters());
    let [_, unfitted] = validation(&arm, &model.regressor_parameters());
    println!(
        "another motion: torques of {torques:.1} N m (rms), predicted within {errors:.3} N m, by the public description within {unfitted:.1} N m"
    );
    assert!(errors < 0.01 * torques && errors < 0.02 * unfitted);
    Ok(())
}
