//! Elimination: from the quadratic form to mass matrix, forcing and accelerations.

use super::form::QuadraticForm;
use super::sweep::{Multiples, Step, Sweep};
use crate::collections::HashMap;
use crate::expr::{ExprId, Graph};
use crate::number::Number;
use crate::simplify;

/// Pushes everything down to the generalised velocities.
pub(super) fn push_down(graph: &mut Graph, mut form: QuadraticForm, velocities: &[ExprId]) -> QuadraticForm {
    let mut sweep = Sweep::new(graph, &form.variables(), velocities, Multiples::Kept);
    while let Some(step) = sweep.next_step() {
        form.apply(graph, &step);
    }
    form
}

/// One eliminated velocity: a = free − Σ factor·x over the remaining variables.
struct Eliminated {
    velocity: ExprId,
    free: ExprId,
    factors: Vec<(ExprId, ExprId)>,
    pivot: ExprId,
    /// Minus the right-hand side that is left when this velocity is eliminated.
    bias: ExprId,
}

/// The stationary point of a form, and names for what was computed on the way.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    /// The accelerations in the order of the velocities.
    pub(super) accelerations: Vec<ExprId>,
    /// Names for pivots, factors and biases.
    pub(super) labels: Vec<(ExprId, String)>,
}

/// Solves a form that has been pushed down; `None` if the mass matrix is structurally singular.
pub(super) fn solve_dense(graph: &mut Graph, form: QuadraticForm, velocities: &[ExprId]) -> Option<Solution> {
    Some(Elimination::dense(graph, form, velocities)?.solution(graph, velocities))
}

/// Solves a form body by body; `None` if a pivot is missing.
pub(super) fn solve_recursive(
    graph: &mut Graph,
    form: QuadraticForm,
    velocities: &[ExprId],
) -> Option<Solution> {
    Some(Elimination::recursive(graph, form, velocities)?.solution(graph, velocities))
}

/// What happens to the linear part of a form when its velocities are eliminated, in the order in which it happens.
enum Move {
    /// The step with this index.
    Eliminate(usize),
    /// Two steps, this one and the next.
    EliminatePair(usize),
    Substitute(Step),
}

/// Velocities that have been eliminated from a form.
pub(super) struct Elimination {
    eliminated: Vec<Eliminated>,
    moves: Vec<Move>,
    /// How the variables that remained at an elimination are made of velocities, if they were not themselves.
    sweep: Option<Sweep>,
}

impl Elimination {
    /// Eliminates all velocities from a form that has been pushed down: a left-looking LDLᵀ factorisation of
    /// the mass matrix, since every coefficient is summed only when its row is taken. Rows with the fewest
    /// neighbours go first. `None` if the mass matrix is structurally singular.
    pub(super) fn dense(
        graph: &mut Graph,
        mut form: QuadraticForm,
        velocities: &[ExprId],
    ) -> Option<Elimination> {
        let mut remaining = velocities.to_vec();
        let mut elimination = Elimination { eliminated: Vec::new(), moves: Vec::new(), sweep: None };
        while !remaining.is_empty() {
            let candidates = remaining.iter().enumerate().filter(|(_, v)| form.has_square(**v));
            match candidates.min_by_key(|(_, v)| form.degree(**v)) {
                // What was left of the square may have cancelled; another row, or a pair, goes first then.
                Some((_, &v)) if form.drop_vanished_square(graph, v) => {}
                Some((position, _)) => {
                    elimination.push(eliminate(graph, &mut form, remaining.remove(position))?);
                }
                None => {
                    let first = remaining.remove(0);
                    let position = remaining.iter().position(|&v| form.has_pair(first, v))?;
                    let pair = eliminate_pair(graph, &mut form, first, remaining.remove(position))?;
                    elimination.moves.push(Move::EliminatePair(elimination.eliminated.len()));
                    elimination.eliminated.extend(pair);
                }
            }
        }
        Some(elimination)
    }

    /// Eliminates each velocity as soon as nothing unprocessed depends on it, while the rest of the form is
    /// still written in velocities of bodies. On chains and trees the fill-in stays within one body: this is
    /// the articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, §7) found by ordering.
    /// `None` if a pivot is missing.
    pub(super) fn recursive(
        graph: &mut Graph,
        mut form: QuadraticForm,
        velocities: &[ExprId],
    ) -> Option<Elimination> {
        let mut sweep = Sweep::new(graph, &form.variables(), velocities, Multiples::Merged);
        let mut elimination = Elimination { eliminated: Vec::new(), moves: Vec::new(), sweep: None };
        loop {
            if let Some(velocity) = sweep.next_leaf() {
                elimination.push(eliminate(graph, &mut form, velocity)?);
            } else if let Some(step) = sweep.next_step() {
                form.apply(graph, &step);
                elimination.moves.push(Move::Substitute(step));
            } else {
                break;
            }
        }
        elimination.sweep = Some(sweep);
        (elimination.eliminated.len() == velocities.len()).then_some(elimination)
    }

    fn push(&mut self, step: Eliminated) {
        self.moves.push(Move::Eliminate(self.eliminated.len()));
        self.eliminated.push(step);
    }

    /// The stationary point of the form.
    pub(super) fn solution(&self, graph: &mut Graph, velocities: &[ExprId]) -> Solution {
        let free = self.eliminated.iter().map(|step| step.free).collect::<Vec<_>>();
        let accelerations = self.substitute_back(graph, &free, velocities);
        Solution { accelerations, labels: labels(graph, &self.eliminated, velocities) }
    }

    /// The stationary point of the form with another linear part, given by its coefficients at the velocities: M⁻¹ times
    /// their opposites, by the factors that are already there.
    pub(super) fn solve_again(
        &self,
        graph: &mut Graph,
        linear: &[ExprId],
        velocities: &[ExprId],
    ) -> Vec<ExprId> {
        let mut rest = Rest::default();
        velocities.iter().zip(linear).for_each(|(&v, &value)| rest.add(v, value));
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
        self.substitute_back(graph, &free, velocities)
    }

    fn substitute_back(&self, graph: &mut Graph, free: &[ExprId], velocities: &[ExprId]) -> Vec<ExprId> {
        let mut known: HashMap<ExprId, ExprId> = HashMap::default();
        for (step, &free) in self.eliminated.iter().zip(free).rev() {
            let mut terms = vec![(free, Number::ONE)];
            for &(j, factor) in &step.factors {
                let value = acceleration_of(graph, &mut known, self.sweep.as_ref(), j);
                terms.push((graph.multiply(factor, value), Number::MINUS_ONE));
            }
            let acceleration = graph.sum(Number::ZERO, terms);
            known.insert(step.velocity, acceleration);
        }
        velocities.iter().map(|v| known.get(v).copied().unwrap_or(*v)).collect()
    }
}

/// −value/pivot
fn freed(graph: &mut Graph, step: &Eliminated, value: ExprId) -> ExprId {
    let inverse = graph.reciprocal(step.pivot);
    let quotient = graph.multiply(value, inverse);
    graph.negate(quotient)
}

/// A linear part while velocities are eliminated.
#[derive(Default)]
struct Rest(HashMap<ExprId, Vec<ExprId>>);

impl Rest {
    fn add(&mut self, variable: ExprId, value: ExprId) {
        self.0.get_or_insert_with(variable, Vec::new).push(value);
    }

    fn take(&mut self, graph: &mut Graph, variable: ExprId) -> ExprId {
        graph.total(self.0.remove(&variable).unwrap_or_default())
    }

    fn subtract(&mut self, graph: &mut Graph, factors: &[(ExprId, ExprId)], value: ExprId) {
        for &(j, factor) in factors {
            let product = graph.multiply(factor, value);
            self.add(j, graph.negate(product));
        }
    }

    fn substitute(&mut self, graph: &mut Graph, step: &Step) {
        match step {
            Step::Replace(id, parts) => {
                let value = self.take(graph, *id);
                for &(part, slope) in parts {
                    self.add(part, graph.multiply(slope, value));
                }
            }
            Step::Collapse(target, multiples) => {
                for &(id, slope) in multiples {
                    let value = self.take(graph, id);
                    self.add(*target, graph.multiply(slope, value));
                }
            }
        }
    }
}

fn eliminate(graph: &mut Graph, form: &mut QuadraticForm, velocity: ExprId) -> Option<Eliminated> {
    let row = form.take(graph, velocity);
    if graph.is_zero(row.own) {
        return None;
    }
    let inverse = graph.reciprocal(row.own);
    let mut factors = Vec::with_capacity(row.pairs.len());
    for &(j, weight) in &row.pairs {
        factors.push((j, graph.multiply(weight, inverse)));
    }
    for (n, &(j, factor)) in factors.iter().enumerate() {
        let linear = graph.multiply(factor, row.linear);
        let opposite = graph.negate(linear);
        form.add_linear(graph, j, opposite);
        for &(k, weight) in &row.pairs[n..] {
            let fill = graph.multiply(factor, weight);
            let opposite = graph.negate(fill);
            form.add_pair(graph, j, k, opposite);
        }
    }
    let free = match row.pairs.is_empty() {
        true => simplify::quotient(graph, row.linear, row.own),
        // What is divided by the pivot is shared with other rows.
        false => graph.multiply(row.linear, inverse),
    };
    Some(Eliminated { velocity, free: graph.negate(free), factors, pivot: row.own, bias: row.linear })
}

/// Eliminates two velocities without squares, whose product is their only term: of a form like ẋ·ẏ, which is no
/// kinetic energy but may stand in a Lagrangian. Each acceleration follows from the row of the other.
fn eliminate_pair(
    graph: &mut Graph,
    form: &mut QuadraticForm,
    first: ExprId,
    second: ExprId,
) -> Option<[Eliminated; 2]> {
    let mut row = form.take(graph, first);
    let position = row.pairs.iter().position(|(j, _)| *j == second)?;
    let (_, coupling) = row.pairs.remove(position);
    let other = form.take(graph, second);
    let inverse = graph.reciprocal(coupling);
    let steps = [(first, &other), (second, &row)].map(|(velocity, row)| {
        let factors = row.pairs.iter().map(|&(j, weight)| (j, graph.multiply(weight, inverse))).collect();
        let free = graph.multiply(row.linear, inverse);
        Eliminated { velocity, free: graph.negate(free), factors, pivot: coupling, bias: row.linear }
    });
    for (row, step) in [(&row, &steps[0]), (&other, &steps[1])] {
        for &(k, weight) in &row.pairs {
            let linear = graph.multiply(weight, step.free);
            form.add_linear(graph, k, linear);
        }
    }
    for &(j, weight) in &row.pairs {
        for &(k, factor) in &steps[0].factors {
            let fill = graph.multiply(weight, factor);
            let fill = if j == k { graph.scale(-&Number::TWO, fill) } else { graph.negate(fill) };
            form.add_pair(graph, j, k, fill);
        }
    }
    Some(steps)
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
