//! Second-order reverse sweep: second derivatives with respect to nodes that are affine in the
//! unknowns.
//!
//! Source: Gower and Mello, "A new framework for the computation of Hessians", Optim. Methods
//! Softw. 27 (2012), 251–273, continued through the nonlinear nodes.

use super::quadratic_form::QuadraticForm;
use lagrange_algebra::calculus::{Degree, Degrees, partials, second_partials};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Graph};

/// Second derivatives during the sweep from a root down to affine nodes.
pub(super) struct Curvature {
    pub(super) degrees: Degrees,
    /// Weights of nodes that enter the root through another nonlinear node.
    adjoints: OrderedMap<ExprId, Vec<ExprId>>,
    pub(super) quadratic: QuadraticForm,
}

impl Curvature {
    /// Creates a sweep without any steps; `degrees` must cover every node to be swept.
    pub(super) fn new(degrees: Degrees) -> Curvature {
        Curvature { degrees, adjoints: OrderedMap::default(), quadratic: QuadraticForm::default() }
    }

    /// Takes the weight with which a node enters through the nodes swept so far.
    pub(super) fn take_adjoint(&mut self, graph: &mut Graph, id: ExprId) -> Option<ExprId> {
        let terms = std::mem::take(self.adjoints.get_mut(&id)?);
        Some(graph.total(terms))
    }

    /// Performs one step: passes the second derivatives of the node itself, and those accumulated
    /// at it, to its operands.
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
