//! Programs as the body of a function: of Rust, and by [`statements`] of C and
//! JavaScript.
//!
//! The statements read like handwritten code. A value with a name, or with several uses, becomes a
//! `let`; all others are written where they are used, up to a bounded length. Labels of the program
//! serve as names. Other names list the factors of a value: `sin_theta`, `x_dot_sq`, `m_l`. If
//! there are too many factors, names indicate dependencies: `const_0` for parameters only, `pos_0`
//! for time and coordinates, `vel_0` for velocities.
//!
//! Elementary functions are called by their bare names; a body lists the functions that it needs in
//! scope.

mod body;
mod fragment;
mod literal;
mod names;
mod naming;
mod pairs;
mod parts;
mod sine_cosine;
mod solved;
mod statements;
mod values;
mod writer;

pub use body::{FunctionBody, Scalar, Unrepresentable};
pub use literal::float;
pub use names::Names;
pub use statements::{Precision, SCRIPT_PRELUDE, Surroundings, Target, prelude, statements};

use crate::program::{Op, Program};
use lagrange_expr::symbol::{Role, Symbols};
use values::{RECIPROCAL, SELECTIONS, write};
use writer::BodyWriter;

/// Writes a program as Rust.
///
/// # Errors
/// If a constant of the program is out of the range of the scalar.
pub fn body(
    program: &Program,
    symbols: &Symbols,
    scalar: &Scalar,
    names: &mut Names,
) -> Result<FunctionBody, Unrepresentable> {
    // All other functions are reserved words of the language, so symbols cannot have their names.
    ["sin_cos", "sin_cos_each", "multiply_add", RECIPROCAL]
        .into_iter()
        .for_each(|function| names.reserve(function));
    if matches!(scalar, Scalar::SideBySide { .. }) {
        SELECTIONS.into_iter().for_each(|function| names.reserve(function));
    }
    for (_, op) in program.values() {
        if let Op::Opaque(function, _) = op {
            names.reserve(&function.rust_name());
        }
    }
    let used = used_roles(program);
    // Symbols are named first, so that nothing else takes their names.
    used.iter().for_each(|&role| drop(names.role(symbols, role)));
    write(BodyWriter::new(program, symbols, scalar, names), used)
}

fn used_roles(program: &Program) -> Vec<Role> {
    let role = |op: &Op| match op {
        Op::Input(role) => Some(*role),
        _ => None,
    };
    let mut used = program.values().filter_map(|(_, op)| role(op)).collect::<Vec<_>>();
    used.sort_unstable();
    used
}

#[cfg(test)]
mod tests;
