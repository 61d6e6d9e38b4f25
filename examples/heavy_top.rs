//! A fast symmetric top about a fixed point, released at an angle of 0.5 rad.
//!
//! The Euler angles of precession φ and spin ψ are cyclic: their momenta are conserved, the
//! vertical and the axial component of the angular momentum. Together with the energy, there are
//! three conserved quantities for three coordinates, so the motion is regular: it precesses slowly
//! and nods fast. The reference state at t = 10 s was computed in 160-bit arithmetic with two step
//! counts that agree in all printed digits.
//!
//! Routh's reduction turns the two momenta into parameters. The remaining motion has one
//! coordinate, θ, and a run reconstructs both ignored angles, which reach the same reference.
//!
//! Look for the range of θ. The top, released without precession, falls a little, and the spin
//! lifts it back to its start, again and again.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A symmetric top about a fixed point on its axis.
    #[derive(Clone, Debug)]
    pub struct HeavyTop;

    /// Moment of inertia across the axis, about the fixed point.
    param i1: kg*m^2 = 1.0;
    /// Moment of inertia about the axis.
    param i3: kg*m^2 = 0.5;
    /// Weight times distance of the centre of mass from the fixed point.
    param mgl: N*m = 1.0;
    coord phi: rad, theta: rad = 0.5, psi: rad;
    start dot(psi) = 10;
    let axial = dot(psi) + dot(phi) * cos(theta);
    kinetic = 1/2 * i1 * (dot(theta)^2 + dot(phi)^2 * sin(theta)^2) + 1/2 * i3 * axial^2;
    potential = mgl * cos(theta);

    /// The nutation of the top, which moves by one coordinate.
    reduce Nutation { ignore phi, psi; }
}

/// Angles φ, θ, ψ, then their rates, at t = 10 s.
const REFERENCE: [f64; 6] = [
    2.0467725656913784,
    0.5380072870902001,
    98.23587791650361,
    0.3589581073543498,
    0.06219658865528939,
    9.691751364894902,
];

fn main() -> Result<(), Box<dyn Error>> {
    let top = HeavyTop::default();
    let trajectory = top.simulate(top.start()).until(10.0).tolerance(1e-13).every(0.01).run()?;
    let end = trajectory.last();
    let rows: [_; 6] = std::array::from_fn(|i| (trajectory.names()[i].as_str(), end[i], REFERENCE[i]));
    compare("t = 10 s", 1e-11, &rows);

    let nutation = Nutation::from_state(&top, 0.0, top.start());
    let start = NutationState::from(top.start());
    let reduced = nutation.simulate(start).until(10.0).tolerance(1e-13).run()?;
    let end_of_reduced: [f64; 6] = nutation.expand(10.0, reduced.last().into()).into();
    let rows: [_; 6] =
        std::array::from_fn(|i| (trajectory.names()[i].as_str(), end_of_reduced[i], REFERENCE[i]));
    compare("t = 10 s by the nutation alone", 1e-11, &rows);

    let names = ["momentum of phi", "momentum of psi", "energy"];
    let (now, before) = (conserved(&top, end.into()), conserved(&top, top.start()));
    let rows: [_; 3] = std::array::from_fn(|i| (names[i], now[i], before[i]));
    compare("conserved quantities at the end and at the start", 1e-12, &rows);
    let least = trajectory.theta().iter().copied().fold(f64::INFINITY, f64::min);
    let most = trajectory.theta().iter().copied().fold(f64::NEG_INFINITY, f64::max);
    println!("theta stays between {least:.6} and {most:.6}");
    assert!(least >= 0.5 - 1e-12);
    Ok(())
}

/// Returns the momenta of the cyclic coordinates and the energy.
fn conserved(top: &HeavyTop, state: HeavyTopState) -> [f64; 3] {
    let (q, v) = (state.coordinates(), state.velocities());
    let [p_phi, _, p_psi] = top.momenta(0.0, &q, &v);
    [p_phi, p_psi, top.energy(0.0, &q, &v)]
}
