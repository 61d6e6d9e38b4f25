//! Record of an elimination, for back substitution and for further right-hand sides.

use super::pivot::{Eliminated, Rest, freed};
use crate::derive::sweep::{Step, Sweep};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{Dependencies, ExprId, Function, Graph};
use lagrange_expr::functions;
use lagrange_expr::number::Number;

/// Step of an elimination and its effect on the linear part of a form, in chronological order.
pub(in crate::derive) enum Move {
    /// The step with this index.
    Eliminate(usize),
    /// The step with this index and the next one, together.
    EliminatePair(usize),
    Substitute(Step),
}

/// Unknowns that have been eliminated from a form.
#[derive(Default)]
pub(in crate::derive) struct Elimination {
    pub(in crate::derive) eliminated: Vec<Eliminated>,
    pub(in crate::derive) moves: Vec<Move>,
    /// Composition of the variables that remained at an elimination, unless they were generalised
    /// velocities.
    pub(in crate::derive) sweep: Option<Sweep>,
    /// Multipliers of constraints that follow from others wherever they hold.
    pub(in crate::derive) redundant: Vec<ExprId>,
    /// Contributions of eliminated velocities to the squares of multipliers, up to sign.
    gained: HashMap<ExprId, Vec<ExprId>>,
    /// Ratios of a multiplier's square, or of the row of a constraint, to the divisor.
    pub(in crate::derive) ratios: Vec<ExprId>,
}

impl Elimination {
    /// Returns the stationary point of the form.
    pub(in crate::derive) fn values(&self, graph: &mut Graph, unknowns: &[ExprId]) -> Vec<ExprId> {
        let free = self.eliminated.iter().map(|step| step.free).collect::<Vec<_>>();
        self.substitute_back(graph, &free, unknowns)
    }

    /// Returns the largest factor by which rounding errors grow where constraints are nearly
    /// dependent; infinite where they are dependent. `None` if it is one everywhere.
    pub(in crate::derive) fn condition(&self, graph: &mut Graph) -> Option<ExprId> {
        let mut ratios =
            self.ratios.iter().copied().filter(|&ratio| !graph.is_one(ratio)).collect::<Vec<_>>();
        ratios.dedup();
        ratios.into_iter().reduce(|a, b| functions::apply(graph, Function::Max, &[a, b]))
    }

    /// True if a constraint follows from others wherever they hold.
    pub(in crate::derive) fn is_redundant(&self) -> bool {
        !self.redundant.is_empty()
    }

    /// Returns the stationary point of the form with another linear part, given by its coefficients
    /// at the unknowns. Without constraints it is M⁻¹ times their opposites, by the existing
    /// factors.
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
                    // Each of the two accelerations follows from the row of the other, and so do
                    // the factors.
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

    /// Records a step, and its evidence of the independence of constraints. All contributions of
    /// velocities to the square of a multiplier have one sign, and other multipliers reduce it.
    pub(in crate::derive) fn push(&mut self, graph: &mut Graph, step: Eliminated) {
        if is_multiplier(graph, step.velocity) {
            let gained = self.gained.remove(&step.velocity).unwrap_or_default();
            let square = graph.total(gained);
            self.ratios.push(ratio(graph, square, step.pivot));
        } else {
            for &(id, factor) in &step.factors {
                if !is_multiplier(graph, id) {
                    continue;
                }
                let weight = graph.multiply(factor, step.pivot);
                let part = graph.multiply(factor, weight);
                self.gained.get_or_insert_with(id, Vec::new).push(part);
            }
        }
        self.moves.push(Move::Eliminate(self.eliminated.len()));
        self.eliminated.push(step);
    }

    pub(in crate::derive) fn push_pair(&mut self, pair: [Eliminated; 2]) {
        self.moves.push(Move::EliminatePair(self.eliminated.len()));
        self.eliminated.extend(pair);
    }
}

pub(in crate::derive) fn is_multiplier(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::MULTIPLIER)
}

/// Returns |whole/part| as one magnitude, since no expression that contains it is differentiated.
pub(in crate::derive) fn ratio(graph: &mut Graph, whole: ExprId, part: ExprId) -> ExprId {
    let inverse = graph.reciprocal(part);
    let ratio = graph.multiply(whole, inverse);
    match graph.as_number(ratio) {
        Some(_) => functions::apply(graph, Function::Abs, &[ratio]),
        None => graph.call(Function::Abs, &[ratio]),
    }
}

/// Returns Σ slope · acceleration over the parts of a variable, without recursion.
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
