//! Values that equations define implicitly.
//!
//! An algebraic unknown y of an equation 0 = r(x₁, …, y) is a function y(x₁, …) of its arguments.
//! Expressions mention it as a call of an [`Opaque`] function. Its residual r, with separate
//! symbols for the arguments and the unknown, is stored beside them in the graph.

use super::{ExprId, Graph};
use crate::opaque::Opaque;
use crate::symbol::Role;

/// A function that an equation defines.
#[derive(Clone, Debug)]
pub struct AlgebraicUnknown {
    /// The function.
    pub function: Opaque,
    /// The symbols of its arguments.
    pub arguments: Vec<ExprId>,
    /// The symbol of its value.
    pub value: ExprId,
    /// Expression that is zero at the solution, in these symbols.
    pub residual: ExprId,
    /// Value from which the iteration starts, a function of the arguments.
    pub start: ExprId,
    /// Number of steps after which the equation counts as one without a solution.
    pub iterations: u32,
}

impl AlgebraicUnknown {
    /// Returns all expressions that define it.
    pub fn expressions(&self) -> Vec<ExprId> {
        [&self.arguments[..], &[self.value, self.residual, self.start]].concat()
    }

    /// Replaces the expressions.
    pub fn map(&self, map: impl Fn(ExprId) -> ExprId) -> AlgebraicUnknown {
        AlgebraicUnknown {
            function: self.function.clone(),
            arguments: self.arguments.iter().map(|&argument| map(argument)).collect(),
            value: map(self.value),
            residual: map(self.residual),
            start: map(self.start),
            iterations: self.iterations,
        }
    }
}

impl Graph {
    /// Makes a new symbol for an argument or the value of an algebraic unknown.
    pub fn operand(&mut self, name: &str) -> ExprId {
        let role = Role::Operand(self.operands);
        self.operands += 1;
        self.symbol(name, role)
    }

    /// Adds a function that an equation defines.
    pub fn add_unknown(&mut self, unknown: AlgebraicUnknown) {
        self.unknowns.push(unknown);
    }

    /// Returns the implicit definitions, in the order of declaration.
    pub fn unknowns(&self) -> &[AlgebraicUnknown] {
        &self.unknowns
    }

    /// Returns the equation that defines a function, if one does.
    pub fn unknown(&self, function: &Opaque) -> Option<&AlgebraicUnknown> {
        self.unknowns.iter().find(|unknown| unknown.function == *function)
    }
}
