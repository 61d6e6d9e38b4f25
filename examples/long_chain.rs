//! Thirty point masses on massless rods, declared in ten lines.
//!
//! The chain hangs from a point, with slightly increasing angles from rod to rod, and is released.
//! The mass matrix of its absolute angles is full. However, accelerations are computed body by
//! body, so their cost is proportional to the number of rods.
//!
//! The reference is the same chain with a handwritten mass matrix, in SciPy:
//! `tools/many_of_a_kind.py`. Look for twelve correct digits of angles and accelerations, and for
//! constant energy.
//!
//! `cargo run --example long_chain`

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A chain of point masses, its angles from the downward vertical.
    #[derive(Clone, Debug)]
    pub struct LongChain;

    const n = 30;
    param m[n]: kg = 0.1, l[n]: m = 0.1, g: m/s^2 = 9.81;
    coord theta[n]: rad;
    let p[0] = (0, 0);
    for i in 0..n {
        let p[i+1] = p[i] + l[i] * (sin(theta[i]), -cos(theta[i]));
        kinetic = kinetic_energy(m[i], dot(p[i+1]));
        potential = gravitational_energy(m[i], g, p[i+1].y);
    }
    output tip = p[n];
}

/// Indices of the first, middle and last rod.
const RODS: [usize; 3] = [0, 14, 29];
/// Values from `tools/many_of_a_kind.py`.
const ACCELERATIONS: [f64; 3] = [-2.6245707643313034, -1.8161338664874436, -1.7932216625706707];
const ANGLES: [f64; 3] = [-0.1523687295314143, -0.23063124607433866, -0.4220238308746291];
const LAST_RATE: f64 = -1.7970165998404366;

fn main() -> Result<(), Box<dyn Error>> {
    let chain = LongChain::default();
    let theta = std::array::from_fn(|i| 0.3 + 0.01 * i as f64);
    let start = LongChainState { theta, theta_dot: [0.0; 30] };
    let acceleration = chain.acceleration(0.0, &start.coordinates(), &start.velocities());
    let names = ["first rod", "middle rod", "last rod"];
    let rows = |found: [f64; 3], known: [f64; 3]| [0, 1, 2].map(|i| (names[i], found[i], known[i]));
    let found = RODS.map(|rod| acceleration[rod]);
    compare("accelerations at the start, in rad/s²", 1e-12, &rows(found, ACCELERATIONS));

    let run = chain.simulate(start).until(1.0).tolerance(1e-13).energy().run()?;
    let end = LongChainState::from(run.last());
    compare("angles after a second, in rad", 1e-12, &rows(RODS.map(|rod| end.theta[rod]), ANGLES));
    compare("rates", 1e-11, &[("last rod", end.theta_dot[29], LAST_RATE)]);
    println!("{} states; the last rod began at {} rad", run.len(), run.theta(29)[0]);
    let energy = run.column("energy").ok_or("it was asked for")?;
    compare("energy, in J", 1e-11, &[("at the end", energy[energy.len() - 1], energy[0])]);
    Ok(())
}
