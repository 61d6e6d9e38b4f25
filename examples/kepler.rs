//! A planet on an ellipse of eccentricity 0.6 around a fixed sun, in polar coordinates.
//!
//! The reference is the analytic solution with the semi-major axis 1 and the gravitational
//! parameter 1. The mean anomaly is the time t, the eccentric anomaly E solves Kepler's equation t =
//! E − e sin E, and
//!
//! ```text
//! r = 1 − e cos E,    tan(φ/2) = sqrt((1 + e)/(1 − e)) tan(E/2).
//! ```
//!
//! φ is cyclic, so that its momentum r² φ̇ = sqrt(1 − e²) is conserved, as is the energy −1/2. Look
//! for the errors after one period, 2π: the planet is back at its start, one turn further.

mod common;

use std::error::Error;
use std::f64::consts::{PI, TAU};

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A planet around a fixed sun.
    #[derive(Clone, Debug)]
    pub struct Kepler;

    param m: kg = 1.0, mu: m^3/s^2 = 1.0;
    coord r: m, phi: rad;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -mu * m / r;
}

const ECCENTRICITY: f64 = 0.6;

fn main() -> Result<(), Box<dyn Error>> {
    let planet = Kepler::default();
    let nearest = 1.0 - ECCENTRICITY;
    let momentum = (1.0 - ECCENTRICITY * ECCENTRICITY).sqrt();
    let start = [nearest, 0.0, 0.0, momentum / (nearest * nearest)];
    for (title, t) in [("a quarter of the period", PI / 2.0), ("half of it", PI), ("the whole", TAU)] {
        let trajectory = planet.simulate(start).until(t).tolerance(1e-14).ends_only().run()?;
        let end = KeplerState::from(trajectory.last());
        let (q, v) = (end.coordinates(), end.velocities());
        let [r, phi] = ellipse(t);
        let rows = [
            ("r", end.r, r),
            ("phi", end.phi, phi),
            ("momentum of phi", planet.momenta(t, &q, &v)[1], momentum),
            ("energy", planet.energy(t, &q, &v), -0.5),
        ];
        compare(title, 1e-12, &rows);
    }
    Ok(())
}

/// Returns distance and angle at time `t`, at most one period, from the analytic solution.
fn ellipse(t: f64) -> [f64; 2] {
    let mut eccentric = t;
    // Newton's method converges to rounding accuracy in a few steps this close to the root.
    for _ in 0..20 {
        let (sin, cos) = eccentric.sin_cos();
        eccentric -= (eccentric - ECCENTRICITY * sin - t) / (1.0 - ECCENTRICITY * cos);
    }
    let (sin, cos) = (eccentric / 2.0).sin_cos();
    let half = ((1.0 + ECCENTRICITY).sqrt() * sin).atan2((1.0 - ECCENTRICITY).sqrt() * cos);
    [1.0 - ECCENTRICITY * eccentric.cos(), 2.0 * half]
}
