//! Integrations by this crate.

use lagrange::integrate::{Method, Stepper, Verner98};
use lagrange::system::OdeSystem;

use crate::problem::{Motion, Run, Solver};

lagrange::system! {
    /// Two point masses on massless rods, with the constants of the handwritten functions.
    pub struct DoublePendulum;

    const m = 1, l = 1, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l * sin(theta1), -l * cos(theta1));
    let (x2, y2) = (x1 + l * sin(theta2), y1 - l * cos(theta2));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2);
    potential = m * g * y1 + m * g * y2;
}

lagrange::system! {
    /// The double pendulum with inline sines and cosines.
    #[accuracy(fast)]
    pub struct FastDoublePendulum;

    const m = 1, l = 1, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l * sin(theta1), -l * cos(theta1));
    let (x2, y2) = (x1 + l * sin(theta2), y1 - l * cos(theta2));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2);
    potential = m * g * y1 + m * g * y2;
}

lagrange::system! {
    /// The double pendulum with parameters that can be changed at run time.
    pub struct AnyDoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

lagrange::system! {
    /// A planet around a fixed sun.
    pub struct Kepler;

    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -1 / r;
}

lagrange::system! {
    /// The Kepler problem with parameters that can be changed at run time.
    pub struct AnyKepler;

    param m = 1.0, mu = 1.0;
    coord r, phi;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -mu * m / r;
}

/// Returns Verner's pair on an emitted system.
pub(crate) fn solver<M>(name: &'static str, system: M, motion: Motion) -> Solver
where
    M: OdeSystem<Scalar = f64, State = [f64; 4]> + 'static,
{
    let run = move |tolerance| {
        let Motion { start, end } = motion;
        let mut stepper = Verner98::tolerance(tolerance).start(&system, 0.0, &start, end).ok()?;
        while stepper.time() != end {
            stepper.step(&system, end).ok()?;
        }
        Some(Run { state: *stepper.state(), evaluations: stepper.work().evaluations })
    };
    Solver { name, is_peer: false, run: Box::new(run) }
}
