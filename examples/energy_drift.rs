//! The energy drift of several methods over five minutes of a double pendulum, with bars that show
//! its size.
//!
//! The energy is conserved, so any drift is due to the method. Look for the largest drift relative
//! to the initial energy, and for its cost. The adaptive method at its tightest tolerance needs
//! fewer evaluations than the classical one, and drifts less by orders of magnitude. `--features
//! plot` draws each drift.

use std::error::Error;

use lagrange::Simulate;
use lagrange::integrate::{Method, RungeKutta4, Verner98};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// Two point masses on massless rods; angles are measured from the rest position.
    #[derive(Clone, Debug)]
    pub struct DoublePendulum;

    param m1: kg = 1.0, m2: kg = 1.0, l1: m = 1.0, l2: m = 1.0, g: m/s^2 = 9.81;
    coord theta1: rad, theta2: rad;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

const END: f64 = 300.0;
const START: [f64; 4] = [2.0, 1.5, 0.0, 0.0];

fn main() -> Result<(), Box<dyn Error>> {
    let classical = drift("runge_kutta", RungeKutta4 { step: 1e-3 })?;
    let adaptive = drift("verner", Verner98::tolerance(1e-14))?;
    assert!(classical < 1e-8 && adaptive < 1e-11 && adaptive < 1e-2 * classical);
    Ok(())
}

/// Returns the largest drift of the energy relative to its initial value.
fn drift(file: &str, method: impl Method<DoublePendulum>) -> Result<f64, Box<dyn Error>> {
    let pendulum = DoublePendulum::default();
    let name = method.name();
    let simulation = pendulum.simulate(START).until(END).method(method).every(0.1).energy();
    let trajectory =
        simulation.progress(|progress| eprint!("\r{name}: {:3.0} of {END} s", progress.time)).run()?;
    eprintln!();

    let energies = trajectory.column("energy").unwrap_or_default();
    let largest = energies.iter().map(|energy| (energy / energies[0] - 1.0).abs()).fold(0.0, f64::max);
    let work = trajectory.work();
    println!(
        "{:16} {:>9} steps {:>9} evaluations, drift {largest:.1e}",
        trajectory.method(),
        work.steps,
        work.evaluations
    );
    draw(file, &trajectory)?;
    Ok(largest)
}

#[cfg(feature = "plot")]
fn draw(file: &str, trajectory: &Trajectory<DoublePendulum>) -> Result<(), Box<dyn Error>> {
    let path = std::env::temp_dir().join(format!("drift_{file}.png"));
    trajectory.plot_energy(&path)?;
    println!("{:16} {}", "", path.display());
    Ok(())
}

#[cfg(not(feature = "plot"))]
fn draw(_file: &str, _trajectory: &Trajectory<DoublePendulum>) -> Result<(), Box<dyn Error>> {
    Ok(())
}
