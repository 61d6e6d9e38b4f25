//! The cases, each with all solvers.

use crate::emitted;
use crate::peers::{self, ByHand};
use crate::problem::{Case, Motion};
use crate::references::{Numbers, state};

pub(crate) fn cases() -> [Case; 2] {
    [double_pendulum(), kepler()]
}

/// Returns the case of two point masses on massless rods, which is chaotic.
fn double_pendulum() -> Case {
    let motion = Motion { start: [2.0, 1.5, 0.0, 0.0], end: 10.0 };
    let mut solvers = peers::all(&ByHand(double_pendulum_by_hand), motion);
    solvers.push(emitted::solver("lagrange standard", emitted::DoublePendulum {}, motion));
    solvers.push(emitted::solver("lagrange fast", emitted::FastDoublePendulum {}, motion));
    solvers.push(emitted::solver("lagrange, parameters", emitted::AnyDoublePendulum::default(), motion));
    let reference = state("double_pendulum", Numbers::Binary, motion.end);
    Case { name: "double pendulum", reference, goals: &[1e-6, 1e-9, 1e-12], solvers }
}

/// Returns the case of an ellipse of eccentricity 0.6, a hundred times around, from the pericentre.
fn kepler() -> Case {
    let motion = Motion { start: [0.4, 0.0, 0.0, 5.0], end: 100.0 * core::f64::consts::TAU };
    let mut solvers = peers::all(&ByHand(kepler_by_hand), motion);
    solvers.push(emitted::solver("lagrange standard", emitted::Kepler {}, motion));
    solvers.push(emitted::solver("lagrange, parameters", emitted::AnyKepler::default(), motion));
    let reference = state("kepler", Numbers::Binary, motion.end);
    Case { name: "Kepler, 100 periods", reference, goals: &[1e-6, 1e-9], solvers }
}

/// Computes ω̇ by eliminating the tension of the outer rod; m = l = 1.
fn double_pendulum_by_hand([theta1, theta2, omega1, omega2]: &[f64; 4]) -> [f64; 4] {
    const G: f64 = 9.81;
    let (sin1, cos1) = theta1.sin_cos();
    let (sin, cos) = (theta2 - theta1).sin_cos();
    let pull = G * cos1 + omega1 * omega1;
    let across = sin / (1.0 + sin * sin) * (cos * pull + omega2 * omega2);
    [*omega1, *omega2, across - G * sin1, -(cos * across + sin * pull)]
}

fn kepler_by_hand([r, _, r_dot, phi_dot]: &[f64; 4]) -> [f64; 4] {
    let inverse = 1.0 / r;
    [*r_dot, *phi_dot, r * phi_dot * phi_dot - inverse * inverse, -2.0 * r_dot * phi_dot * inverse]
}
