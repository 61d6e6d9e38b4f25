//! Elimination: from the quadratic form to mass matrix, forcing and accelerations.

use super::form::QuadraticForm;
use super::sweep::{Multiples, Sweep};
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId, Graph};
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
    /// The accelerations in the order of the velocities, then the multipliers.
    pub(super) values: Vec<ExprId>,
    /// Names for pivots, factors and biases.
    pub(super) labels: Vec<(ExprId, String)>,
}

/// Eliminates all unknowns from a form that has been pushed down: a left-looking LDLᵀ factorisation of
/// the mass matrix, bordered by the constraints, since every coefficient is summed only when its row is taken.
/// Multipliers follow the velocities: their squares, −A M⁻¹ Aᵀ, are complete then. `None` if the matrix is structurally
/// singular.
pub(super) fn solve_dense(
    graph: &mut Graph,
    mut form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    let (multipliers, mut velocities): (Vec<_>, Vec<_>) =
        unknowns.iter().partition(|&&id| is_multiplier(graph, id));
    let mut remaining = multipliers;
    let mut eliminated = eliminate_massless(graph, &mut form, &mut velocities, &mut remaining)?;
    eliminated.extend(eliminate_all(graph, &mut form, velocities)?);
    eliminated.extend(eliminate_all(graph, &mut form, remaining)?);
    Some(substitute_back(graph, &eliminated, &Parts::None, unknowns))
}

fn is_multiplier(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::MULTIPLIER)
}

/// Eliminates velocities without any inertia, each together with a multiplier whose constraint determines it.
fn eliminate_massless(
    graph: &mut Graph,
    form: &mut QuadraticForm,
    velocities: &mut Vec<ExprId>,
    multipliers: &mut Vec<ExprId>,
) -> Option<Vec<Eliminated>> {
    let mut eliminated = Vec::new();
    while let Some(position) = velocities.iter().position(|&v| !form.has_square(v)) {
        let partner = |&id: &ExprId| form.has_pair(velocities[position], id) && !form.has_square(id);
        let Some(multiplier) = multipliers.iter().position(partner) else { break };
        let (velocity, multiplier) = (velocities.remove(position), multipliers.remove(multiplier));
        eliminated.extend(eliminate_pair(graph, form, velocity, multiplier)?);
    }
    Some(eliminated)
}

/// Eliminates these unknowns; rows with the fewest neighbours go first.
fn eliminate_all(
    graph: &mut Graph,
    form: &mut QuadraticForm,
    mut remaining: Vec<ExprId>,
) -> Option<Vec<Eliminated>> {
    let mut eliminated = Vec::new();
    while !remaining.is_empty() {
        let candidates = remaining.iter().enumerate().filter(|(_, v)| form.has_square(**v));
        match candidates.min_by_key(|(_, v)| form.degree(**v)) {
            // What was left of the square may have cancelled; another row, or a pair, goes first then.
            Some((_, &v)) if form.drop_vanished_square(graph, v) => {}
            Some((position, _)) => eliminated.push(eliminate(graph, form, remaining.remove(position))?),
            None => {
                let first = remaining.remove(0);
                let position = remaining.iter().position(|&v| form.has_pair(first, v))?;
                eliminated.extend(eliminate_pair(graph, form, first, remaining.remove(position))?);
            }
        }
    }
    Some(eliminated)
}

/// Eliminates each velocity as soon as nothing unprocessed depends on it, while the rest of the form is
/// still written in velocities of bodies. On chains and trees the fill-in stays within one body: this is
/// the articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, §7) found by ordering.
/// `None` if a pivot is missing.
pub(super) fn solve_recursive(
    graph: &mut Graph,
    mut form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    let (multipliers, velocities): (Vec<_>, Vec<_>) =
        unknowns.iter().partition(|&&id| is_multiplier(graph, id));
    let mut sweep = Sweep::new(graph, &form.variables(), &velocities, Multiples::Merged);
    let mut eliminated = Vec::new();
    loop {
        if let Some(velocity) = sweep.next_leaf() {
            eliminated.push(eliminate(graph, &mut form, velocity)?);
        } else if let Some(step) = sweep.next_step() {
            form.apply(graph, &step);
        } else {
            break;
        }
    }
    if eliminated.len() < velocities.len() {
        return None;
    }
    eliminated.extend(eliminate_all(graph, &mut form, multipliers)?);
    Some(substitute_back(graph, &eliminated, &Parts::Of(&sweep), unknowns))
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

/// How the variables that remained at an elimination are made of velocities.
enum Parts<'a> {
    None,
    Of(&'a Sweep),
}

fn substitute_back(
    graph: &mut Graph,
    eliminated: &[Eliminated],
    parts: &Parts<'_>,
    unknowns: &[ExprId],
) -> Solution {
    let mut known: HashMap<ExprId, ExprId> = HashMap::default();
    for step in eliminated.iter().rev() {
        let mut terms = vec![(step.free, Number::ONE)];
        for &(j, factor) in &step.factors {
            let value = acceleration_of(graph, &mut known, parts, j);
            terms.push((graph.multiply(factor, value), Number::MINUS_ONE));
        }
        let acceleration = graph.sum(Number::ZERO, terms);
        known.insert(step.velocity, acceleration);
    }
    let values = unknowns.iter().map(|id| known.get(id).copied().unwrap_or(*id)).collect();
    let labels = labels(graph, eliminated, unknowns);
    Solution { values, labels }
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
    parts: &Parts<'_>,
    variable: ExprId,
) -> ExprId {
    let parts_of = |id: ExprId| match parts {
        Parts::None => &[],
        Parts::Of(sweep) => sweep.parts(id),
    };
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
