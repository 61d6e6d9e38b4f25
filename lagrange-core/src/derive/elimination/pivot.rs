//! One step of elimination: an unknown, or two, taken out of a quadratic form.

use crate::derive::plane_rotation::turned_back;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::Step;
use lagrange_algebra::simplify;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// One eliminated velocity: a = free − Σ factor·x over the remaining variables.
pub(in crate::derive) struct Eliminated {
    pub(in crate::derive) velocity: ExprId,
    pub(in crate::derive) free: ExprId,
    pub(in crate::derive) factors: Vec<(ExprId, ExprId)>,
    pub(in crate::derive) pivot: ExprId,
    /// Negative right-hand side that remains when this velocity is eliminated.
    pub(in crate::derive) bias: ExprId,
}

/// Returns −value/pivot.
pub(in crate::derive) fn freed(graph: &mut Graph, step: &Eliminated, value: ExprId) -> ExprId {
    let inverse = graph.reciprocal(step.pivot);
    let quotient = graph.multiply(value, inverse);
    graph.negate(quotient)
}

/// A linear part while velocities are eliminated.
#[derive(Default)]
pub(in crate::derive) struct Rest(HashMap<ExprId, Vec<ExprId>>);

impl Rest {
    pub(in crate::derive) fn add(&mut self, variable: ExprId, value: ExprId) {
        self.0.get_or_insert_with(variable, Vec::new).push(value);
    }

    pub(in crate::derive) fn take(&mut self, graph: &mut Graph, variable: ExprId) -> ExprId {
        graph.total(self.0.remove(&variable).unwrap_or_default())
    }

    pub(in crate::derive) fn subtract(
        &mut self,
        graph: &mut Graph,
        factors: &[(ExprId, ExprId)],
        value: ExprId,
    ) {
        for &(j, factor) in factors {
            let product = graph.multiply(factor, value);
            self.add(j, graph.negate(product));
        }
    }

    pub(in crate::derive) fn substitute(&mut self, graph: &mut Graph, step: &Step) {
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
            Step::Turn(pairs) => {
                for pair in pairs {
                    let values = pair.turned.each_ref().map(|(id, sign)| {
                        let value = self.take(graph, *id);
                        graph.scale(sign.clone(), value)
                    });
                    let values = turned_back(graph, [pair.cosine, pair.sine], values);
                    for ((part, sign), value) in pair.parts.iter().zip(values) {
                        self.add(*part, graph.scale(sign.clone(), value));
                    }
                }
            }
        }
    }
}

pub(in crate::derive) fn eliminate(
    graph: &mut Graph,
    form: &mut QuadraticForm,
    velocity: ExprId,
) -> Option<Eliminated> {
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
        // Other rows share the quotients by the pivot.
        false => graph.multiply(row.linear, inverse),
    };
    Some(Eliminated { velocity, free: graph.negate(free), factors, pivot: row.own, bias: row.linear })
}

/// Eliminates two velocities without squares, whose product is their only term. A form like ẋ·ẏ is
/// no kinetic energy but may occur in a Lagrangian. Each acceleration follows from the row of the
/// other velocity.
pub(in crate::derive) fn eliminate_pair(
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
