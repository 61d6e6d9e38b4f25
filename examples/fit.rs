//! Masses and friction of a double pendulum, estimated from a film of it.
//!
//! The lengths and the mass of the upper weight are measured. A camera recorded both angles every
//! 0.02 s for 4 s, with errors of 0.01 and 0.02 rad. It occasionally missed the lower weight. The
//! file is `examples/data/double_pendulum.csv`.
//!
//! Angles alone do not determine both masses and the friction: if all of them are doubled, the
//! pendulum moves in the same way. The first fit reports this. With one mass known the others can
//! be determined.
//!
//! References: `tools/fit.py`, by `least_squares` of SciPy along handwritten equations. Look for
//! the standard errors: they cover the values used to generate the data, 0.2 kg, 0.01 and 0.004 N m
//! s.

mod common;

use std::error::Error;

use common::compare;
use lagrange::fit::{Data, FitError, Fits};

lagrange::system! {
    /// Two weights on massless rods, with friction in both joints.
    #[derive(Clone, Debug)]
    pub struct DoublePendulum;

    param m1: kg = 0.3, m2: kg = 0.5, l1: m = 0.5, l2: m = 0.4, g: m/s^2 = 9.81;
    param c1: N*m*s = 0.02, c2: N*m*s = 0.02;
    coord theta1: rad, theta2: rad;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    dissipation = 1/2 * c1 * dot(theta1)^2 + 1/2 * c2 * (dot(theta2) - dot(theta1))^2;
    emit { jacobian }
}

/// Values and standard errors.
const REFERENCE: [(&str, f64, f64); 5] = [
    ("m2", 2.003295515e-01, 6.80157e-04),
    ("c1", 9.877319796e-03, 4.58226e-04),
    ("c2", 4.014156225e-03, 5.28283e-05),
    ("theta1", 1.001369796e+00, 1.47036e-03),
    ("theta2", -4.988166474e-01, 1.66183e-03),
];

fn main() -> Result<(), Box<dyn Error>> {
    let data = Data::read_csv(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/double_pendulum.csv"))?;
    let pendulum = DoublePendulum::default();
    let fit = || {
        let fit =
            pendulum.fit([1.1, -0.4, 0.0, 0.0], data.clone()).noise("theta1", 0.01).noise("theta2", 0.02);
        let fit = fit.vary("m2", 0.01..=5.0).vary("c1", 0.0..).vary("c2", 0.0..);
        fit.vary("theta1", ..).vary("theta2", ..)
    };
    match fit().vary("m1", 0.01..=5.0).run() {
        Err(error @ FitError::Undetermined(_)) => println!("{error}\n"),
        other => panic!("the data tell a mass that they do not: {other:?}"),
    }

    let fitted = fit().run()?;
    println!("{fitted}\n");
    let values = REFERENCE.map(|(name, value, _)| (name, fitted.value(name).unwrap_or(f64::NAN), value));
    compare("fitted values", 1e-6, &values);
    let errors =
        REFERENCE.map(|(name, _, error)| (name, fitted.standard_error(name).unwrap_or(f64::NAN), error));
    compare("standard errors", 1e-7, &errors);
    Ok(())
}
