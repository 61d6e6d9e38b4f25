//! Elimination: from the quadratic form to mass matrix, forcing and accelerations.

use super::order::{Elimination, Move};
use super::pivot::{Eliminated, Rest, freed};
use crate::collections::HashMap;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::{Multiples, Sweep};
use crate::expr::{ExprId, Function, Graph};
use crate::functions;
use crate::number::Number;

/// Pushes everything down to the generalised velocities.
pub(in crate::derive) fn push_down(
    graph: &mut Graph,
    mut form: QuadraticForm,
    velocities: &[ExprId],
) -> QuadraticForm {
    let mut sweep = Sweep::new(graph, [&form.variables(), &[]], velocities, Multiples::Kept);
    while let Some(step) = sweep.next_step() {
        form.apply(graph, &step);
    }
    form
}

/// The stationary point of a form, and names for what was computed on the way.
pub(in crate::derive) struct Solution {
    /// The accelerations in the order of the velocities, then the multipliers.
    pub(in crate::derive) values: Vec<ExprId>,
    /// Names for pivots, factors and biases.
    pub(in crate::derive) labels: Vec<(ExprId, String)>,
    /// Pivots at whose zeros the accelerations are computed another way, to the same values.
    pub(in crate::derive) guards: Vec<ExprId>,
    /// How much of the constraints the others leave, as [`Elimination::condition`] says; `None` if they are always independent.
    pub(in crate::derive) condition: Option<ExprId>,
    /// The steps that led there, for other right-hand sides; `None` if the strategy takes none.
    pub(in crate::derive) elimination: Option<Elimination>,
}

/// Solves a form that has been pushed down; `None` if the equations are structurally singular.
pub(in crate::derive) fn solve_dense(
    graph: &mut Graph,
    form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    Some(Elimination::dense(graph, form, unknowns)?.into_solution(graph, unknowns))
}

/// Solves a form body by body; `None` if a pivot is missing.
pub(in crate::derive) fn solve_recursive(
    graph: &mut Graph,
    form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    Some(Elimination::recursive(graph, form, unknowns)?.into_solution(graph, unknowns))
}

impl Elimination {
    fn into_solution(self, graph: &mut Graph, unknowns: &[ExprId]) -> Solution {
        let (values, condition) = (self.values(graph, unknowns), self.condition(graph));
        let labels = labels(graph, &self.eliminated, unknowns);
        Solution { values, labels, guards: Vec::new(), condition, elimination: Some(self) }
    }

    /// The stationary point of the form.
    pub(in crate::derive) fn values(&self, graph: &mut Graph, unknowns: &[ExprId]) -> Vec<ExprId> {
        let free = self.eliminated.iter().map(|step| step.free).collect::<Vec<_>>();
        self.substitute_back(graph, &free, unknowns)
    }

    /// The largest of the factors by which rounding grows where constraints are nearly dependent; infinite where they are. `None`
    /// if it is one everywhere.
    fn condition(&self, graph: &mut Graph) -> Option<ExprId> {
        let mut ratios =
            self.ratios.iter().copied().filter(|&ratio| !graph.is_one(ratio)).collect::<Vec<_>>();
        ratios.dedup();
        ratios.into_iter().reduce(|a, b| functions::apply(graph, Function::Max, &[a, b]))
    }

    /// Whether a constraint follows from others wherever they hold.
    pub(in crate::derive) fn is_redundant(&self) -> bool {
        !self.redundant.is_empty()
    }

    /// The stationary point of the form with another linear part, given by its coefficients at the unknowns: without
    /// constraints M⁻¹ times their opposites, by the factors that are already there.
    pub(in crate::derive) fn solve_again(
        &self,
        graph: &mut Graph,
        linear: &[ExprId],
        unknowns: &[ExprId],
    ) -> Vec<ExprId> {
        let mut rest = Rest::default();
        unknowns.iter().zip(linear).for_each(|(&v, &value)| rest.add(v, value));
        let mut free = vec![graph.number(0); self.eliminated.len()];
        for step in &self.moves {
            match *step {
                Move::Eliminate(i) => {
                    let step = &self.eliminated[i];
                    let value = rest.take(graph, step.velocity);
                    free[i] = freed(graph, step, value);
                    rest.subtract(graph, &step.factors, value);
                }
                Move::EliminatePair(i) => {
                    // Each of the two accelerations follows from the row of the other, and so do the factors.
                    let (first, second) = (&self.eliminated[i], &self.eliminated[i + 1]);
                    let values = [first, second].map(|step| rest.take(graph, step.velocity));
                    free[i] = freed(graph, first, values[1]);
                    free[i + 1] = freed(graph, second, values[0]);
                    rest.subtract(graph, &second.factors, values[1]);
                    rest.subtract(graph, &first.factors, values[0]);
                }
                Move::Substitute(ref step) => rest.substitute(graph, step),
            }
        }
        self.substitute_back(graph, &free, unknowns)
    }

    fn substitute_back(&self, graph: &mut Graph, free: &[ExprId], unknowns: &[ExprId]) -> Vec<ExprId> {
        let zero = graph.number(0);
        let mut known = self.redundant.iter().map(|&id| (id, zero)).collect::<HashMap<_, _>>();
        for (step, &free) in self.eliminated.iter().zip(free).rev() {
            let mut terms = vec![(free, Number::ONE)];
            for &(j, factor) in &step.factors {
                let value = acceleration_of(graph, &mut known, self.sweep.as_ref(), j);
                terms.push((graph.multiply(factor, value), Number::MINUS_ONE));
            }
            let acceleration = graph.sum(Number::ZERO, terms);
            known.insert(step.velocity, acceleration);
        }
        unknowns.iter().map(|v| known.get(v).copied().unwrap_or(*v)).collect()
    }
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

/// Σ slope · acceleration over the parts of a variable, without recursion.
fn acceleration_of(
    graph: &mut Graph,
    known: &mut HashMap<ExprId, ExprId>,
    sweep: Option<&Sweep>,
    variable: ExprId,
) -> ExprId {
    let parts_of = |id: ExprId| sweep.map_or(&[][..], |sweep| sweep.parts(id));
    let mut pending = vec![variable];
    while let Some(&id) = pending.last() {
        let before = pending.len();
        if !known.contains(&id) {
            pending.extend(parts_of(id).iter().map(|(part, _)| *part).filter(|part| !known.contains(part)));
        }
        if pending.len() > before {
            continue;
        }
        pending.pop();
        if !known.contains(&id) {
            let mut terms = Vec::new();
            for &(part, slope) in parts_of(id) {
                let value = known.get(&part).copied().unwrap_or(part);
                terms.push((graph.multiply(slope, value), Number::ONE));
            }
            let value = graph.sum(Number::ZERO, terms);
            known.insert(id, value);
        }
    }
    known.get(&variable).copied().unwrap_or(variable)
}
