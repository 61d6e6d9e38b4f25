//! Andrews' squeezing mechanism: seven bodies, three closed loops, and a motor that accelerates it
//! within 30 ms.
//!
//! It is the standard test of programs for mechanisms (Schiehlen, *Multibody Systems Handbook*;
//! Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., §VII.7). Six constraints
//! leave one degree of freedom, and their multipliers are the forces in the joints. The references
//! at t = 0.03 s were computed in more than 160-bit arithmetic with two step counts.
//!
//! Only motor and spring do work, so T + V − M β is conserved. Look for this invariant, for the
//! residuals of the constraints, and for the crank, which makes two and a half turns.

mod common;
#[path = "../tests/mechanisms/squeezer.rs"]
mod squeezer;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use squeezer::{START, Squeezer, SqueezerState};

/// Accelerations and multipliers at the start; all others are zero.
const FIRST: [f64; 4] =
    [14_222.443_919_954_114, -10_666.832_939_965_585, -98.566_870_396_241_09, 6.122_688_344_255_662];
/// Angles at t = 0.03 s.
const LAST: [f64; 7] = [
    15.810_771_195_153_707,
    -15.756_371_058_411_839,
    0.040_822_240_119_645_8,
    -0.534_730_116_342_079_6,
    0.524_409_965_879_954_1,
    0.534_730_116_342_079_6,
    1.048_080_741_041_938,
];
const INVARIANT: f64 = 1.437_832_957_532_132_6;

fn main() -> Result<(), Box<dyn Error>> {
    let squeezer = Squeezer::default();
    first_instant(&squeezer);

    let trajectory = squeezer
        .simulate(START)
        .until(0.03)
        .tolerance(1e-13)
        .observe("invariant", invariant)
        .observe("residual", residual)
        .run()?;
    let end = trajectory.last();
    let rows: [_; 7] = std::array::from_fn(|i| (trajectory.names()[i].as_str(), end[i], LAST[i]));
    compare("t = 0.03 s", 1e-11, &rows);

    let [invariants, residuals] =
        ["invariant", "residual"].map(|name| trajectory.column(name).unwrap_or_default());
    let off = invariants.iter().map(|value| (value - INVARIANT).abs()).fold(0.0, f64::max);
    let open = residuals.iter().copied().fold(0.0, f64::max);
    println!("largest error of T + V - M beta {off:.1e} J, of a constraint {open:.1e} m");
    println!("{} steps, {} evaluations", trajectory.work().steps, trajectory.work().evaluations);
    assert!(off < 1e-11 && open < 1e-14);
    Ok(())
}

/// Compares accelerations and joint forces when the motor is switched on.
fn first_instant(squeezer: &Squeezer) {
    let start = SqueezerState::from(START);
    let (q, v) = (start.coordinates(), start.velocities());
    let (a, forces) = (squeezer.acceleration(0.0, &q, &v), squeezer.multipliers(0.0, &q, &v));
    let rows = [
        ("beta_ddot", a[0], FIRST[0]),
        ("theta_ddot", a[1], FIRST[1]),
        ("gamma_ddot", a[2], 0.0),
        ("g1", forces[0], FIRST[2]),
        ("g2", forces[1], FIRST[3]),
        ("g3", forces[2], 0.0),
        ("g5", forces[4], 0.0),
    ];
    compare("t = 0, forces in N", 1e-10, &rows);
}

/// Computes T + V − M β.
fn invariant(squeezer: &Squeezer, t: f64, y: &[f64; 14]) -> f64 {
    let state = SqueezerState::from(*y);
    squeezer.energy(t, &state.coordinates(), &state.velocities()) - squeezer.drive * state.beta
}

/// Returns the gap by which the loops are open, in m.
fn residual(squeezer: &Squeezer, t: f64, y: &[f64; 14]) -> f64 {
    let state = SqueezerState::from(*y);
    let residuals = squeezer.constraints(t, &state.coordinates(), &state.velocities());
    residuals.into_iter().map(f64::abs).fold(0.0, f64::max)
}
