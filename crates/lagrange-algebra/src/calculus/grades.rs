//! Grades: exponents that state how expressions scale with a unit.
//!
//! If all parameters of grade d are multiplied by sᵈ, an expression of grade e becomes sᵉ times
//! itself. If s changes the unit of mass, masses, stiffnesses and forces have the grade one, and
//! lengths and times have the grade zero. `derive::grading` finds the grades of symbols from the
//! energies; this module computes the grades of expressions from those.

use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// Grades of expressions, each computed once.
#[derive(Clone, Default, Debug)]
pub struct Grades(HashMap<ExprId, Number>);

impl Grades {
    /// Computes the grades of all parts of `roots`. The result is empty if all symbols have the
    /// grade zero.
    pub fn of(graph: &Graph, roots: &[ExprId]) -> Grades {
        let mut grades = Grades::default();
        if graph.is_graded() {
            grades.extend(graph, roots);
        }
        grades
    }

    /// Returns the grade of an expression that has been visited; zero for others.
    pub fn grade(&self, id: ExprId) -> Number {
        self.0.get(&id).cloned().unwrap_or(Number::ZERO)
    }

    /// Adds the grades of all parts of other expressions.
    pub fn extend(&mut self, graph: &Graph, roots: &[ExprId]) {
        for id in graph.reachable_until(roots, |id| self.0.contains(&id)) {
            if !self.0.contains(&id) {
                let grade = self.derive(graph, id);
                self.0.insert(id, grade);
            }
        }
    }

    fn derive(&self, graph: &Graph, id: ExprId) -> Number {
        match graph.node(id) {
            Node::Number(_) | Node::Pi | Node::Opaque(..) => Number::ZERO,
            Node::Symbol(_) => graph.grade_of_symbol(id),
            // In a sum that respects the unit, all terms have the same grade; others have no
            // meaningful grade.
            Node::Sum { terms, .. } => self.grade(terms[0].0),
            Node::Product(factors) => factors
                .iter()
                .fold(Number::ZERO, |sum, (base, exponent)| &sum + &(&self.grade(*base) * exponent)),
            Node::Call(function, arguments) if keeps_units(*function) => self.grade(arguments[0]),
            Node::Call(..) => Number::ZERO,
            Node::Choose { then, otherwise, .. } => match graph.is_zero(*then) {
                true => self.grade(*otherwise),
                false => self.grade(*then),
            },
        }
    }
}

/// True if the value of a function has the same unit as its arguments.
pub fn keeps_units(function: Function) -> bool {
    matches!(function, Function::Abs | Function::Min | Function::Max | Function::Hypot)
}
