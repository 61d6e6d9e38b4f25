//! A system read at run time: a spring pendulum, a mass on an elastic rod.
//!
//! The computer algebra behind the macro is a library, `lagrange-core`. It parses a declaration
//! from text, derives the equations and evaluates them with an interpreter. It is intended for
//! tools, and for systems that are unknown at compile time. The interpreter is much slower than
//! compiled code.
//!
//! The declaration below is both compiled and interpreted, and the accelerations are compared. Look
//! for the equations, the structure and the cost, which are also the documentation of the emitted
//! struct. The accelerations should agree to rounding.
//!
//! If the declaration is in a file, `lagrange equations FILE` writes the same.

mod common;

use std::error::Error;
use std::process::ExitCode;

use common::compare;
use lagrange::symbolic::derive::StrategyChoice;
use lagrange::symbolic::pipeline::{Derived, NumericSystem, parse};

/// Compiles a declaration and keeps its text.
macro_rules! compiled_with_text {
    ($($declaration:tt)*) => {
        lagrange::system! { $($declaration)* }
        const TEXT: &str = stringify!($($declaration)*);
    };
}

compiled_with_text! {
    #[derive(Clone, Debug)]
    pub struct SpringPendulum;

    param m: kg = 1.0, k: N/m = 40.0, l0: m = 1.0, g: m/s^2 = 9.81;
    coord r: m, theta: rad;
    let position = (r * sin(theta), -r * cos(theta));
    kinetic = kinetic_energy(m, dot(position));
    potential = gravitational_energy(m, g, position.y) + spring_energy(k, r - l0);
}

fn main() -> ExitCode {
    let result = both_ways();
    if let Err(error) = &result {
        // Errors in a declaration are readable: each has its line, its column and help.
        eprintln!("{error}");
    }
    ExitCode::from(u8::from(result.is_err()))
}

/// Prints the derived properties of a system.
fn describe(text: &str) -> Result<Derived, Box<dyn Error>> {
    let mut derived = parse(text)?.derive(StrategyChoice::Cheapest)?;
    print!("{}", derived.report);
    derived.documentation().iter().for_each(|line| println!("{line}"));
    println!("\n# The same in LaTeX\n\n{}\n", derived.equations_latex());
    Ok(derived)
}

/// Compares the interpreter with the compiled type.
fn both_ways() -> Result<(), Box<dyn Error>> {
    let interpreted = NumericSystem::new(&describe(TEXT)?);
    let compiled = SpringPendulum::default();
    for (q, v) in [([1.2, 0.3], [0.0, 0.0]), ([0.9, -1.1], [0.7, 2.5]), ([1.5, 3.0], [-2.0, 1.0])] {
        let [a, expected] =
            [interpreted.acceleration(0.0, &q, &v), compiled.acceleration(0.0, &q, &v).into()];
        let rows = [("r_ddot", a[0], expected[0]), ("theta_ddot", a[1], expected[1])];
        compare(&format!("interpreter and compiled type at q = {q:?}, v = {v:?}"), 1e-14, &rows);
    }
    Ok(())
}
