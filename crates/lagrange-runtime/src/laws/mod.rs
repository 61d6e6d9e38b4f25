//! Laws that the motion of a system must obey, checked by differences of its Lagrangian alone.
//!
//! The equations of motion are derived symbolically. [`check`] compares them in one state with
//! Lagrange's equations, whose derivatives are differences of order six of L(t, q, v). The energy,
//! its balance and the Jacobian are judged likewise. [`verify`] does so in many random states.
//!
//! ```
//! use lagrange::laws;
//!
//! lagrange::system! {
//!     /// A pendulum with friction.
//!     #[derive(Debug)]
//!     struct Pendulum;
//!     param l = 0.5, g = 9.81, c = 0.1;
//!     coord theta;
//!     kinetic = 1/2 * (l * dot(theta))^2;
//!     potential = -g * l * cos(theta);
//!     dissipation = 1/2 * c * dot(theta)^2;
//!     emit { tests }
//! }
//!
//! let pendulum = Pendulum::default();
//! let report = laws::check(&pendulum, 0.0, &[0.3, -2.0]);
//! assert!(report.holds(), "{report}");
//! laws::verify(&pendulum, &[0.0, 0.0])?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod differences;
mod report;
mod samples;

use std::format;
use std::vec::Vec;

use crate::scalar::{Number, Scalar};
use crate::system::{LagrangianSystem, ScalarOf};
use differences::{Nearby, derivative};
pub use report::{Finding, Report};
pub use samples::{Broken, verify};

/// Checks the laws of a system at time `t` in the state `y`, which must satisfy the constraints.
///
/// Deviations below ε^(3/8) of the terms count as rounding and truncation, 1.4e-6 of numbers in
/// double precision. Close to a corner or a jump, differences are not those of the equations, and
/// a law is [unjudged](Finding::is_judged).
pub fn check<M: LagrangianSystem>(system: &M, t: M::Scalar, y: &M::State) -> Report<M::Scalar> {
    let step = M::Scalar::epsilon().powf(M::Scalar::from_f64(1.0 / 8.0));
    let [coarse, fine] =
        [step, step * M::Scalar::from_f64(0.5)].map(|step| laws(&Nearby::new(system, t, y, step), y));
    Report { laws: coarse.into_iter().zip(fine).map(|(coarse, fine)| coarse.compared(fine)).collect() }
}

fn laws<M: LagrangianSystem>(nearby: &Nearby<'_, M>, y: &M::State) -> Vec<Finding<ScalarOf<M>>> {
    let (system, t) = (nearby.system, nearby.t);
    let lagrangian = system.lagrangian(t, &nearby.q, &nearby.v);
    let noise = nearby.noise(lagrangian);
    let forces = system.generalised_forces(t, &nearby.q, &nearby.v);
    let equation = |(index, &force): (usize, &M::Scalar)| {
        let terms = [nearby.momentum_rate(index), -nearby.slope(index), -nearby.turning(index), -force];
        Finding::new(format!("Lagrange's equation of {}", name(nearby, index)), &terms, noise)
    };
    let mut laws = forces.as_ref().iter().enumerate().map(equation).collect::<Vec<_>>();
    let power = |of: &dyn Fn(usize) -> M::Scalar| {
        nearby.v.as_ref().iter().enumerate().map(|(index, &v)| -v * of(index)).collect::<Vec<_>>()
    };
    let mut energy = power(&|index| nearby.momentum(index));
    energy.extend([lagrangian, system.energy(t, &nearby.q, &nearby.v)]);
    laws.push(Finding::new("energy v·∂L/∂v − L".into(), &energy, noise));
    let mut balance = power(&|index| forces.as_ref()[index]);
    balance.extend([nearby.energy_rate(), nearby.explicit_rate()]);
    laws.push(Finding::new("power of the forces".into(), &balance, noise));
    laws.extend(jacobian(nearby, y));
    laws
}

/// Compares the rows of the Jacobian, if the system has one, with differences of its right-hand
/// side.
fn jacobian<M: LagrangianSystem>(nearby: &Nearby<'_, M>, y: &M::State) -> Vec<Finding<ScalarOf<M>>> {
    let Some(jacobian) = nearby.system.jacobian(nearby.t, y) else { return Vec::new() };
    let entry = |row: usize, column: usize| {
        derivative(nearby.step, |by| {
            let mut moved = *y;
            moved.as_mut()[column] = moved.as_ref()[column] + by;
            nearby.system.rhs(nearby.t, &moved).as_ref()[row]
        })
    };
    let rate = nearby.system.rhs(nearby.t, y);
    let law = |(row, entries): (usize, &M::State)| {
        let differences = (0..entries.as_ref().len()).map(|column| entry(row, column)).collect::<Vec<_>>();
        let deviations =
            entries.as_ref().iter().zip(&differences).map(|(&known, &found)| (known - found).abs());
        let worst =
            deviations.fold(M::Scalar::ZERO, |worst: M::Scalar, deviation| match deviation.is_finite() {
                true => worst.max(deviation),
                false => deviation,
            });
        let noise = rate.as_ref()[row].abs() * M::Scalar::epsilon() / nearby.step;
        Finding::of(format!("row {row} of the Jacobian"), worst, &differences, noise)
    };
    jacobian.as_ref().iter().enumerate().map(law).collect()
}

/// Returns the name of a velocity, or of the coordinate whose rate it is, if it has no separate
/// name.
fn name<M: LagrangianSystem>(nearby: &Nearby<'_, M>, index: usize) -> &'static str {
    let description = nearby.system.description();
    let names =
        if description.velocities_are_rates() { description.coordinates } else { description.velocities };
    names.get(index).copied().unwrap_or("a velocity")
}
