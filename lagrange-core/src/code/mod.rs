//! Programs as the body of a Rust function.
//!
//! The statements read like code written by hand: what has a name or is used several times becomes a
//! `let`, everything else is written where it is used, up to a bounded length. Names are the labels of the
//! program where it has any, and otherwise say what a value is made of (`sin_theta`, `x_dot_sq`, `m_l`)
//! or what it changes with: `const_0` with nothing but parameters, `pos_0` with time and coordinates,
//! `vel_0` with velocities.
//!
//! Elementary functions are called by their bare names; a body says which of them it needs in scope.

mod fragment;
mod literal;
mod names;
mod naming;
mod pairs;
mod parts;
mod sine_cosine;
mod values;
mod writer;

use std::collections::BTreeSet;
use std::fmt;

use proc_macro2::{Ident, TokenStream};

pub use names::Names;

use crate::program::{Op, Program};
use crate::symbol::{Role, Symbols};
use values::write;
use writer::BodyWriter;

/// The type that emitted code computes with.
#[derive(Clone, Debug)]
pub enum Scalar {
    /// `f64`; literals are written plainly.
    F64,
    /// `f32`; literals are written plainly, rounded once.
    F32,
    /// A type parameter bounded by `Scalar`; literals are converted from `f64`.
    Generic(Ident),
}

/// A program as Rust.
#[derive(Clone, Debug)]
pub struct FunctionBody {
    /// The `let` statements.
    pub statements: TokenStream,
    /// An expression for each output of the program, to be evaluated after the statements.
    pub outputs: Vec<TokenStream>,
    /// The symbols that must be bound, under the names that [`Names::role`] gives them, in the order of
    /// roles: parameters, inputs, time, coordinates, velocities, accelerations.
    pub used: Vec<Role>,
    /// The functions of `lagrange::private` that must be in scope.
    pub functions: BTreeSet<&'static str>,
}

/// Constants that are not finite when rounded to the scalar.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unrepresentable {
    /// The constants in words, each once.
    pub constants: Vec<String>,
}

impl fmt::Display for Unrepresentable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "number too large for the scalar: {}", self.constants.join(", "))
    }
}

impl std::error::Error for Unrepresentable {}

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
    // Every other function is a word of the language, which no symbol can be called.
    ["sin_cos", "sin_cos_each", "multiply_add"].into_iter().for_each(|function| names.reserve(function));
    let used = used_roles(program);
    // Symbols get their names before anything else can take them.
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
