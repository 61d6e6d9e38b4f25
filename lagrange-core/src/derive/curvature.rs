//! Second-order reverse sweep: second derivatives with respect to nodes that are affine in the
//! unknowns.
//!
//! Source: Gower and Mello, "A new framework for the computation of Hessians", Optim. Methods
//! Softw. 27 (2012), 251–273, continued through the nonlinear nodes.

use super::quadratic_form::QuadraticForm;
use lagrange_algebra::calculus::{Degree, Degrees, partials, second_partials};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Graph};

/// Second derivatives on the way from a root down to affine nodes.
pub(super) struct Curvature {
    pub(super) degrees: Degrees,
    /// Weights with which nodes enter the root through another nonlinear node.
    adjoints: OrderedMap<ExprId, Vec<ExprId>>,
    pub(super) quadratic: QuadraticForm,
}

impl Curvature {
    /// Nothing swept yet; `degrees` are those of everything that will be.
    pub(super) fn new(degrees: Degrees) -> Curvature {
        Curvature { degrees, adjoints: OrderedMap::default(), quadratic: QuadraticForm::default() }
    }

    /// The weight with which a node enters through nodes that have been swept.
    pub(super) fn take_adjoint(&mut self, graph: &mut Graph, id: ExprId) -> Option<ExprId> {
        let terms = std::mem::take(self.adjoints.get_mut(&id)?);
        Some(graph.total(terms))
    }

    /// One step: second derivatives of the node itself, and those that have arrived at it, go to
    /// its operands.
    pub(super) fn sweep(&mut self, graph: &mut Graph, id: ExprId, adjoint: Option<ExprId>) {
        let mut parts = partials(graph, id);
        parts.retain(|(part, _)| self.degrees.of(graph, *part) != Degree::Free);
        if self.quadratic.contains(id) {
            self.quadratic.push(graph, id, &parts);
        }
        let Some(adjoint) = adjoint else { return };
        for (part, slope) in parts {
            if self.degrees.of(graph, part) == Degree::Nonlinear {
                let value = graph.multiply(adjoint, slope);
                self.adjoints.get_or_insert_with(part, Vec::new).push(value);
            }
        }
        for (i, j, second) in second_partials(graph, id) {
            let moving = |id| self.degrees.of(graph, id) != Degree::Free;
            if moving(i) && moving(j) {
                let value = graph.multiply(adjoint, second);
                self.quadratic.add_pair(graph, i, j, value);
            }
        }
    }
}
