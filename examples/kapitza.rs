//! Kapitza's pendulum: a pivot that vibrates fast enough makes the upright position stable.
//!
//! The pivot of a pendulum of length l moves as a cos ωt along the vertical. Averaged over a fast
//! vibration the upright position is a minimum of the effective potential if
//!
//! ```text
//! a² ω² > 2 g l,
//! ```
//!
//! and small deviations from it then oscillate with Ω² = a² ω²/(2 l²) − g/l (Landau, Lifshitz, *Mechanics*,
//! §30). Here l = 1 m and a = 0.1 m, so that the bound is ω = 44.3 rad/s. The reference states at t =
//! 5 s were computed in 200-bit arithmetic with two step counts that agree in all printed digits.
//!
//! The vibration does work at the power −∂L/∂t. Its integral, by Simpson's rule, is the change of
//! the energy.
//!
//! Look for the largest deviation from upright, θ = π: small for ω = 60 rad/s, several turns for 30
//! rad/s.

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A pendulum whose pivot vibrates along the vertical; θ is measured from the lower position.
    #[derive(Clone, Debug)]
    pub struct Kapitza;

    param m: kg = 1.0, l: m = 1.0, a: m = 0.1, omega: rad/s = 60.0, g: m/s^2 = 9.81;
    coord theta: rad;

    let (x, y) = (l * sin(theta), a * cos(omega * t) - l * cos(theta));
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    emit { power }
}

/// A vibration with the state that it leads to at t = 5 s.
struct Run {
    title: &'static str,
    omega: f64,
    end: [f64; 2],
}

const STABLE: Run =
    Run { title: "omega = 60 rad/s, stable", omega: 60.0, end: [3.1597313460929035, 0.46945385801884876] };
const UNSTABLE: Run =
    Run { title: "omega = 30 rad/s, unstable", omega: 30.0, end: [-8.12131262418247, -0.9455167958966941] };
const START: [f64; 2] = [3.0, 0.0];

/// Time between samples, of which a period of the pivot has more than a hundred.
const STEP: f64 = 2.5e-4;

fn main() -> Result<(), Box<dyn Error>> {
    assert!(largest_deviation(&STABLE)? < 0.2);
    assert!(largest_deviation(&UNSTABLE)? > PI);
    Ok(())
}

/// Compares a run with its reference; the largest deviation from the upright position.
fn largest_deviation(run: &Run) -> Result<f64, Box<dyn Error>> {
    let pendulum = Kapitza { omega: run.omega, ..Kapitza::default() };
    let simulation = pendulum.simulate(START).until(5.0).tolerance(1e-13).every(STEP);
    let trajectory = simulation.energy().outputs().run()?;
    let largest = trajectory.theta().iter().map(|theta| (theta - PI).abs()).fold(0.0, f64::max);
    let [theta, theta_dot] = trajectory.last();
    let rows = [("theta", theta, run.end[0]), ("theta_dot", theta_dot, run.end[1])];
    compare(run.title, 1e-10, &rows);
    let power = trajectory.column("power_time").ok_or("no power")?;
    let supplied = simpson(power, STEP);
    let energy = trajectory.column("energy").ok_or("no energy")?;
    let stored = energy[energy.len() - 1] - energy[0];
    compare("energy, J", 1e-6, &[("stored", stored, supplied)]);
    let bound = 2.0 * pendulum.g * pendulum.l;
    println!("a^2 omega^2 = {:.1}, 2 g l = {bound:.1}", (pendulum.a * pendulum.omega).powi(2));
    println!("largest deviation from upright: {largest:.3} rad\n");
    Ok(largest)
}

/// The integral of values at an odd number of equidistant points.
fn simpson(values: &[f64], step: f64) -> f64 {
    values.windows(3).step_by(2).map(|v| step / 3.0 * (v[0] + 4.0 * v[1] + v[2])).sum()
}
