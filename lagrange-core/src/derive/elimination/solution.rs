//! Accelerations and multipliers from the quadratic form, by elimination.

use super::order::{eliminate_dense, eliminate_recursive};
use super::pivot::Eliminated;
use super::record::Elimination;
use crate::derive::cost::cost;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::{Multiples, Rotations, Sweep};
use lagrange_algebra::simplify::balanced;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};

/// Pushes everything down to the generalised velocities.
pub(in crate::derive) fn push_down(
    graph: &mut Graph,
    mut form: QuadraticForm,
    velocities: &[ExprId],
) -> QuadraticForm {
    let mut sweep =
        Sweep::new(graph, [&form.variables(), &[]], velocities, Multiples::Kept, Rotations::InTurn);
    while let Some(step) = sweep.next_step() {
        form.apply(graph, &step);
    }
    form
}

/// The stationary point of a form, with names for the intermediate results.
pub(in crate::derive) struct Solution {
    /// The accelerations in the order of the velocities, then the multipliers.
    pub(in crate::derive) values: Vec<ExprId>,
    /// Names for pivots, factors and biases.
    pub(in crate::derive) labels: Vec<(ExprId, String)>,
    /// Pivots at whose zeros the accelerations are computed in another way, with the same values.
    pub(in crate::derive) guards: Vec<ExprId>,
    /// Growth of rounding errors through constraints, see [`Elimination::condition`]; `None` if
    /// they are always independent.
    pub(in crate::derive) condition: Option<ExprId>,
    /// The steps of the elimination, for other right-hand sides; `None` if the strategy does not
    /// eliminate.
    pub(in crate::derive) elimination: Option<Elimination>,
}

impl Solution {
    /// Removes products of inertias from the values where these are also divided by inertias.
    pub(in crate::derive) fn balance(&mut self, graph: &mut Graph) {
        let roots = [&self.values[..], &self.guards].concat();
        let image = balanced(graph, &roots, self.divisor());
        let ids =
            self.values.iter_mut().chain(&mut self.guards).chain(self.labels.iter_mut().map(|(id, _)| id));
        ids.for_each(|id| *id = image.get(id).copied().unwrap_or(*id));
    }

    /// Returns derivatives of the values without products of inertias where these are also divided
    /// by inertias.
    pub(in crate::derive) fn balanced(&self, graph: &mut Graph, slopes: &[ExprId]) -> Vec<ExprId> {
        let image = balanced(graph, slopes, self.divisor());
        slopes.iter().map(|id| image.get(id).copied().unwrap_or(*id)).collect()
    }

    /// Returns a pivot, which is a divisor anyway.
    fn divisor(&self) -> Option<ExprId> {
        self.labels.iter().find(|(_, label)| label.starts_with("pivot")).map(|(id, _)| *id)
    }
}

/// Solves a form that has been pushed down; `None` if the equations are structurally singular.
pub(in crate::derive) fn solve_dense(
    graph: &mut Graph,
    form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    Some(solution(eliminate_dense(graph, form, unknowns)?, graph, unknowns))
}

/// Solves a form body by body; `None` if a pivot is missing. Where joints turn bodies, velocities
/// are eliminated in the axes of their bodies. Alternatively they are eliminated later, after
/// rotations and the carrier of the body have been substituted as far as possible. The cheaper
/// alternative is kept; for parallel axes this is the latter.
pub(in crate::derive) fn solve_recursive(
    graph: &mut Graph,
    form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    let turned_last = eliminate_recursive(graph, form.clone(), unknowns, Rotations::Last)?;
    if !turned_last.sweep.as_ref().is_some_and(Sweep::has_rotations) {
        return Some(solution(turned_last, graph, unknowns));
    }
    let split = eliminate_recursive(graph, form, unknowns, Rotations::Split);
    let solutions =
        [Some(turned_last), split].map(|elimination| Some(solution(elimination?, graph, unknowns)));
    let solutions = solutions.into_iter().flatten().map(|solution| (cost(graph, &solution.values), solution));
    solutions.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, solution)| solution)
}

fn solution(elimination: Elimination, graph: &mut Graph, unknowns: &[ExprId]) -> Solution {
    let (values, condition) = (elimination.values(graph, unknowns), elimination.condition(graph));
    let labels = labels(graph, &elimination.eliminated, unknowns);
    Solution { values, labels, guards: Vec::new(), condition, elimination: Some(elimination) }
}

fn labels(graph: &mut Graph, eliminated: &[Eliminated], velocities: &[ExprId]) -> Vec<(ExprId, String)> {
    let index = velocities.iter().enumerate().map(|(i, &v)| (v, i)).collect::<HashMap<_, _>>();
    let mut labels = Vec::new();
    for step in eliminated {
        let Some(i) = index.get(&step.velocity) else { continue };
        labels.push((step.pivot, format!("pivot_{i}")));
        labels.push((graph.negate(step.bias), format!("forcing_{i}")));
        for (j, factor) in &step.factors {
            labels.extend(index.get(j).map(|j| (*factor, format!("factor_{j}_{i}"))));
        }
    }
    labels
}
