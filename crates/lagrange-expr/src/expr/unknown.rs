//! Values that are implicitly defined by equations.
//!
//! Algebraic unknowns y of an equal number of equations 0 = r(x₁, …, y) are functions y(x₁, …) of
//! their arguments. Expressions contain each as a call of an [`Opaque`] function. The residuals r,
//! with separate symbols for the arguments and the unknowns, are stored alongside in the graph.

use super::{ExprId, Graph};
use crate::opaque::Opaque;
use crate::symbol::Role;

/// Functions that are defined by an equal number of equations: a single one, or several coupled
/// ones.
#[derive(Clone, Debug)]
pub struct AlgebraicUnknowns {
    /// The functions.
    pub functions: Vec<Opaque>,
    /// The symbols of their arguments.
    pub arguments: Vec<ExprId>,
    /// The symbols of their values.
    pub values: Vec<ExprId>,
    /// Expressions that are zero at the solution, in these symbols.
    pub residuals: Vec<ExprId>,
    /// Values from which the iteration starts, functions of the arguments.
    pub starts: Vec<ExprId>,
    /// Maximum number of steps; equations without a solution by then count as unsolvable.
    pub iterations: u32,
}

impl AlgebraicUnknowns {
    /// Returns all expressions of the definition.
    pub fn expressions(&self) -> Vec<ExprId> {
        [&self.arguments[..], &self.values, &self.residuals, &self.starts].concat()
    }

    /// Replaces the expressions.
    pub fn map(&self, map: impl Fn(ExprId) -> ExprId) -> AlgebraicUnknowns {
        let all = |expressions: &[ExprId]| expressions.iter().map(|&id| map(id)).collect();
        AlgebraicUnknowns {
            functions: self.functions.clone(),
            arguments: all(&self.arguments),
            values: all(&self.values),
            residuals: all(&self.residuals),
            starts: all(&self.starts),
            iterations: self.iterations,
        }
    }
}

impl Graph {
    /// Creates a new symbol for an argument or the value of an algebraic unknown.
    pub fn operand(&mut self, name: &str) -> ExprId {
        let role = Role::Operand(self.operands);
        self.operands += 1;
        self.symbol(name, role)
    }

    /// Adds functions that are defined by equations.
    pub fn add_unknowns(&mut self, unknowns: AlgebraicUnknowns) {
        self.unknowns.push(unknowns);
    }

    /// Returns the implicit definitions, in the order of declaration.
    pub fn unknowns(&self) -> &[AlgebraicUnknowns] {
        &self.unknowns
    }

    /// Returns the equations that define a function, if there are any.
    pub fn equations_of(&self, function: &Opaque) -> Option<&AlgebraicUnknowns> {
        self.unknowns.iter().find(|unknowns| unknowns.functions.contains(function))
    }
}
