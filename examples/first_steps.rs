//! Ten lines: declare a system, simulate it, plot its motion.
//!
//! `cargo run --example first_steps --features plot` writes two drawings and prints their paths.
//! Look for the energy, which only drifts by parts in 10¹⁰.

use std::env::temp_dir;
use std::error::Error;

use lagrange::Simulate;

lagrange::system! {
    /// A bead on a ring that turns about its vertical diameter.
    pub struct Bead;
    param m: kg = 0.1, r: m = 0.5, omega: rad/s = 7.0, g: m/s^2 = 9.81;
    coord theta: rad = 0.1;
    kinetic = 1/2 * m * r^2 * (dot(theta)^2 + omega^2 * sin(theta)^2);
    potential = -m * g * r * cos(theta);
}

fn main() -> Result<(), Box<dyn Error>> {
    let bead = Bead::default();
    let trajectory = bead.simulate(bead.start()).until(10.0).tolerance(1e-10).every(0.01).energy().run()?;
    for (name, picture) in [("bead.svg", "theta and theta_dot"), ("bead_energy.svg", "energy")] {
        println!("{picture} over {} s: {}", trajectory.end_time(), temp_dir().join(name).display());
    }
    trajectory.plot_states(temp_dir().join("bead.svg"))?;
    trajectory.plot_energy(temp_dir().join("bead_energy.svg"))?;
    Ok(())
}
