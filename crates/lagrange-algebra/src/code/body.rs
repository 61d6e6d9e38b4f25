//! The body of a function, and the scalar that it computes with.

use std::collections::BTreeSet;
use std::fmt;

use proc_macro2::{Ident, TokenStream};

use lagrange_expr::symbol::Role;

/// The type that emitted code computes with.
#[derive(Clone, Debug)]
pub enum Scalar {
    /// `f64`; literals are written plainly.
    F64,
    /// `f32`; literals are written plainly, rounded once.
    F32,
    /// A type parameter bounded by `Scalar`; literals are converted from `f64`.
    Generic(Ident),
    /// A type parameter bounded by `Number`, which may hold several numbers in lanes: choices
    /// compute both values and select one. Literals are converted from `f64`.
    SideBySide {
        /// The type parameter.
        number: Ident,
        /// True if each number is an `f32`; literals are then rounded to `f32` before conversion.
        is_single: bool,
        /// True if each number may have more digits than an `f64`.
        is_generic: bool,
    },
}

impl Scalar {
    /// True if numbers may have more digits than an `f64`. Literals then come with their
    /// remainders.
    pub(super) fn may_be_wide(&self) -> bool {
        matches!(self, Scalar::Generic(_) | Scalar::SideBySide { is_generic: true, .. })
    }
}

/// A program as Rust.
#[derive(Clone, Debug)]
pub struct FunctionBody {
    /// The `let` statements.
    pub statements: TokenStream,
    /// An expression for each output of the program, to be evaluated after the statements.
    pub outputs: Vec<TokenStream>,
    /// The symbols that must be bound, under the names that [`Names::role`](super::Names::role)
    /// gives them, in the order of roles: parameters, inputs, time, coordinates, velocities,
    /// accelerations.
    pub used: Vec<Role>,
    /// The functions of `lagrange::private` that must be in scope.
    pub functions: BTreeSet<&'static str>,
}

/// Constants that are not finite when rounded to the scalar.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unrepresentable {
    /// The constants as text, each once.
    pub constants: Vec<String>,
}

impl fmt::Display for Unrepresentable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "number too large for the scalar: {}", self.constants.join(", "))
    }
}

impl std::error::Error for Unrepresentable {}
