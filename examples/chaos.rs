//! A shaken beam between two magnets: chaos, and the unstable orbits inside it.
//!
//! Duffing's oscillator with two wells,
//!
//! ```text
//! m ẍ + c ẋ − k₁ x + k₃ x³ = f cos ωt,
//! ```
//!
//! is chaotic for c = 0.25 and f = 0.3 if all others are one (Guckenheimer, Holmes, *Nonlinear
//! Oscillations, Dynamical Systems, and Bifurcations of Vector Fields*, §2.2). Areas in state space
//! shrink at the rate c/m for any motion. Hence both Lyapunov exponents add up to −c/m, and the
//! product of the multipliers of each periodic orbit is exp(−c T/m) with the period T.
//!
//! Look for the positive exponent, for orbits with a multiplier beyond one, and for both sums.
//!
//! `cargo run --example chaos --features linear,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use lagrange::Simulate;
use lagrange::orbits::Orbits;

lagrange::system! {
    /// The deflection x of the beam from the middle between the magnets.
    #[derive(Clone, Debug)]
    pub struct Beam;

    param m: kg = 1, k1: N/m = 1, k3: N/m^3 = 1, c: N*s/m = 0.25, f: N = 0.3, omega: rad/s = 1;
    coord x: m;
    kinetic = 1/2 * m * dot(x)^2;
    potential = -1/2 * k1 * x^2 + 1/4 * k3 * x^4;
    dissipation = 1/2 * c * dot(x)^2;
    force x = f * cos(omega * t);
    emit { jacobian }
}

/// Orbits with the period of the drive: the start of the search, and the state at t = 0 by SciPy.
const ORBITS: [(&str, [f64; 2], [f64; 2]); 3] = [
    ("orbit in the left well", [-1.0, 0.5], [-1.101_945_684_2, 0.636_462_338_3]),
    ("orbit in the middle", [-0.15, 0.02], [-0.148_988_221_8, 0.018_883_591_4]),
    ("orbit in the right well", [0.13, 0.2], [0.129_005_596_6, 0.193_679_445_9]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let beam = Beam::default();

    let exponents = beam.lyapunov([0.5, 0.0]).transient(50).run(TAU, 2000)?;
    println!("Lyapunov exponents: {:.3} and {:.3}", exponents[0], exponents[1]);
    assert!(exponents[0] > 0.1, "it is chaotic");
    compare("rate of areas", 1e-9, &[("sum of exponents", exponents.iter().sum(), -beam.c)]);

    for (name, near, reference) in ORBITS {
        let orbit = beam.orbit(near, TAU).solve()?;
        let [x, v] = orbit.state;
        compare(name, 1e-9, &[("x", x, reference[0]), ("x_dot", v, reference[1])]);
        let sizes = orbit.multipliers.iter().map(|(re, im)| re.hypot(*im)).collect::<Vec<_>>();
        println!("multipliers of the sizes {:.4} and {:.4}", sizes[0], sizes[1]);
        assert!(!orbit.is_stable(), "the motion leaves it");
        assert!((sizes[0] * sizes[1] - (-TAU * beam.c).exp()).abs() < 1e-9, "areas shrink");
    }

    // There are few enough periods that rounding errors remain invisible.
    let run = beam.simulate([0.5, 0.0]).until(12.0 * TAU).every(TAU / 200.0).tolerance(1e-13).run()?;
    run.plot_phase("x", gallery::picture("chaos.svg")?)?;
    Ok(())
}
