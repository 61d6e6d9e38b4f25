//! Loads: the linear terms of the form, which move with its variables.

use std::collections::BTreeSet;

use super::SquareElimination;
use super::composition::AffineExpansion;
use crate::derive::algebra::LinearForm;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::Sweep;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Rewrites loads along other variables as loads along the variables of squares and generalised
/// velocities.
pub(super) fn push_loads(
    graph: &mut Graph,
    sweep: &Sweep,
    squares: &OrderedMap<ExprId, Vec<(ExprId, Number)>>,
    mut loads: QuadraticForm,
) -> QuadraticForm {
    let mut pending = loads.variables().into_iter().collect::<BTreeSet<_>>();
    // Wholes have larger ids than their parts.
    while let Some(id) = pending.pop_last() {
        let parts = sweep.parts(id);
        if !squares.contains(&id) && !parts.is_empty() {
            loads.push(graph, id, parts);
            pending.extend(parts.iter().map(|(part, _)| *part));
        }
    }
    loads
}

impl SquareElimination<'_> {
    /// Passes on the part of a load that acts on the remaining variables.
    pub(super) fn pass_on(&mut self, factors: &LinearForm, load: ExprId) {
        let graph = &mut *self.algebra.graph;
        for &(id, factor) in factors {
            let value = graph.multiply(factor, load);
            let value = graph.negate(value);
            self.loads.add_linear(graph, id, value);
        }
    }

    /// Writes a load along a part as loads along the whole and its other parts.
    pub(super) fn move_load(&mut self, part: ExprId, whole: ExprId, inverse: &Number) {
        let graph = &mut *self.algebra.graph;
        let load = self.loads.take(graph, part).linear;
        let load = graph.scale(inverse.clone(), load);
        self.loads.add_linear(graph, whole, load);
        for &(other, slope) in self.composition.parts(whole) {
            if other != part {
                let value = graph.multiply(slope, load);
                let value = graph.negate(value);
                self.loads.add_linear(graph, other, value);
            }
        }
    }

    /// Returns the load along the unknown, and moves the other effects of loads along its carriers
    /// to the remaining variables.
    pub(super) fn applied_load(&mut self, expansions: &OrderedMap<ExprId, AffineExpansion>) -> ExprId {
        let mut along = Vec::new();
        for (&id, expansion) in expansions.iter() {
            let load = self.loads.take(self.algebra.graph, id).linear;
            along.push((load, expansion.slope, Number::ONE));
            for &(part, slope) in &expansion.rest {
                let value = self.algebra.graph.multiply(slope, load);
                self.loads.add_linear(self.algebra.graph, part, value);
            }
        }
        self.algebra.products(&along)
    }
}
