//! Grades: the power of a unit in which expressions are measured.
//!
//! If all parameters of grade d are multiplied by sᵈ, an expression of grade e becomes sᵉ times
//! itself. With the unit of mass as s, masses, stiffnesses and forces have the grade one, lengths
//! and times none. So much is found from the energies (`derive::grading`); here grades of
//! expressions follow from those of their symbols.

use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// Grades of expressions, each found once.
#[derive(Clone, Default, Debug)]
pub struct Grades(HashMap<ExprId, Number>);

impl Grades {
    /// Computes the grades of all parts of `roots`; there are none if all symbols have the grade
    /// zero.
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
            // Terms have the same grade; where that is not so, no unit is behind it.
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

/// True if a function of numbers in some unit is a number in that unit.
pub fn keeps_units(function: Function) -> bool {
    matches!(function, Function::Abs | Function::Min | Function::Max | Function::Hypot)
}
