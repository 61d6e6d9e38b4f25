//! A four-bar linkage that turns a thousand times.
//!
//! Three bars and the ground form a loop, which two constraints close. One degree of freedom
//! remains. Nothing is dissipated, so the mechanism returns to its initial state with every turn of
//! the crank. The time of a turn follows from the energy alone,
//!
//! ```text
//! T = ∫ sqrt(I(s)/(2 (E − V(s)))) ds    over a turn, with the kinetic energy ½ I(s) ṡ² at the crank's angle s
//! ```
//!
//! (Landau, Lifshitz, *Mechanics*, §11), computed with 40 digits and without any equations of
//! motion.
//!
//! Look for the angles after a thousand of these periods, which should equal the initial ones plus
//! a thousand turns. The residuals of the constraints and the energy should not grow.

mod common;
#[path = "../tests/mechanisms/four_bar.rs"]
mod four_bar;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use four_bar::{FourBar, FourBarState, START};
use lagrange::Simulate;

/// Duration of a thousand turns in seconds.
const THOUSAND_TURNS: f64 = 173.358_935_930_585_8;

fn main() -> Result<(), Box<dyn Error>> {
    let linkage = FourBar::default();
    let trajectory = linkage
        .simulate(START)
        .until(THOUSAND_TURNS)
        .tolerance(1e-12)
        .energy()
        .observe("residual", residual)
        .every(THOUSAND_TURNS / 1e4)
        .run()?;

    let (end, mut expected) = (trajectory.last(), START);
    expected[0] += 1000.0 * TAU;
    let rows: [_; 6] = std::array::from_fn(|i| (trajectory.names()[i].as_str(), end[i], expected[i]));
    compare("after a thousand turns", 2e-7, &rows);

    let [energies, residuals] =
        ["energy", "residual"].map(|name| trajectory.column(name).unwrap_or_default());
    let drift = energies.iter().map(|energy| (energy / energies[0] - 1.0).abs()).fold(0.0, f64::max);
    let open = residuals.iter().copied().fold(0.0, f64::max);
    println!("largest drift of the energy {drift:.1e}, opening of the loop {open:.1e} m");
    println!("{} steps, {} evaluations", trajectory.work().steps, trajectory.work().evaluations);
    assert!(drift < 1e-10 && open < 1e-12);
    Ok(())
}

/// Returns the gap by which the loop is open, in m.
fn residual(linkage: &FourBar, t: f64, y: &[f64; 6]) -> f64 {
    let state = FourBarState::from(*y);
    let [x, y] = linkage.constraints(t, &state.coordinates(), &state.velocities());
    x.hypot(y)
}
