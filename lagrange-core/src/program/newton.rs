//! Newton's method for the equation of an algebraic unknown, as programs.

use super::interpret::run_with;
use super::ir::Program;
use super::labels::Labels;
use super::lower::lower;
use super::passes::optimise;
use crate::calculus::{partial, rounding};
use crate::expr::{AlgebraicUnknown, ExprId, Graph};
use crate::opaque::Opaque;
use crate::symbol::Role;
use crate::syntax::ast::Accuracy;

/// Residuals up to this many times what rounding may leave of them count as zero.
const TOLERANCE: f64 = 4.0;

/// What the method computes, in symbols for the arguments and the value of the unknown.
#[derive(Clone, Debug)]
pub struct NewtonProgram {
    /// The function whose values it finds.
    pub function: Opaque,
    /// Roles of the arguments.
    pub arguments: Vec<Role>,
    /// Role of the unknown.
    pub value: Role,
    /// Where the method starts.
    pub start: Program,
    /// Of the residual r: r, ∂r/∂y, and the bound of what rounding leaves of it, in units of one rounding.
    pub equation: Program,
    /// The largest number of steps.
    pub iterations: u32,
}

impl NewtonProgram {
    /// Lowers the equation of an unknown.
    pub fn new(graph: &mut Graph, unknown: &AlgebraicUnknown, accuracy: Accuracy) -> NewtonProgram {
        let slope = partial(graph, unknown.residual, unknown.value);
        let equation = [unknown.residual, slope, rounding(graph, unknown)];
        let lowered = |roots: &[ExprId]| optimise(&lower(graph, roots, &Labels::default()), accuracy);
        let role = |id: ExprId| graph.symbol_of(id).map_or(Role::Time, |symbol| symbol.role);
        NewtonProgram {
            function: unknown.function.clone(),
            arguments: unknown.arguments.iter().map(|&argument| role(argument)).collect(),
            value: role(unknown.value),
            start: lowered(&[unknown.start]),
            equation: lowered(&equation),
            iterations: unknown.iterations,
        }
    }

    /// The value of the unknown, by the operations of emitted code for `f64`; NaN if none is found. `call` computes functions of the user's.
    pub fn solve(&self, arguments: &[f64], call: impl Fn(&Opaque, &[f64]) -> f64) -> f64 {
        let argument = |role: Role| {
            let place = self.arguments.iter().position(|known| *known == role);
            place.and_then(|place| arguments.get(place)).copied().unwrap_or(f64::NAN)
        };
        let mut y = run_with(&self.start, argument, &call)[0];
        for _ in 0..self.iterations {
            let value_of = |role| if role == self.value { y } else { argument(role) };
            let found = run_with(&self.equation, value_of, &call);
            let (residual, slope, rounding) = (found[0], found[1], found[2]);
            y -= residual / slope;
            let bound = TOLERANCE * f64::EPSILON * rounding;
            if residual.abs() <= bound && bound < f64::INFINITY || y.is_nan() {
                return y;
            }
        }
        f64::NAN
    }
}
