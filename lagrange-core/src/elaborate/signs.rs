//! Kinetic energies and dissipations that are negative, with numbers or with the defaults of
//! parameters.
//!
//! Only obvious cases are detected: velocities that occur solely as squares times numbers.
//! Definiteness in general depends on parameters, which are only known at run time.

use super::elaborator::{Elaborator, SourceTerm};
use super::messages;
use super::obligations::Defaults;
use lagrange_expr::collections::{HashMap, HashSet};
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::AstId;

/// Reports coordinates whose kinetic energy or dissipation decreases with their velocity. They are
/// errors if this follows from numbers, and warnings if it follows from defaults.
pub(super) fn check_signs(elaborator: &mut Elaborator<'_>) {
    let defaults = Defaults::of(elaborator);
    for Falling { syntax, name, by_default } in falling(elaborator, &elaborator.kinetic, &defaults) {
        let origin = elaborator.evaluator.origin(syntax);
        let report = &mut *elaborator.evaluator.report;
        let wrong = match by_default {
            true => report.doubtful(origin, messages::negative_by_default(&name)),
            false => report.error(origin, messages::negative_kinetic_energy(&name)),
        };
        wrong.help(messages::NEGATIVE_INERTIA_HELP);
    }
    for Falling { syntax, name, .. } in falling(elaborator, &elaborator.dissipation, &defaults) {
        let origin = elaborator.evaluator.origin(syntax);
        let warning = elaborator.evaluator.report.doubtful(origin, messages::negative_dissipation(&name));
        warning.help(messages::NEGATIVE_DISSIPATION_HELP);
    }
}

/// A term that decreases with a velocity, where the sum of all terms also decreases.
struct Falling {
    syntax: AstId,
    /// The name of the velocity.
    name: String,
    /// True if the sign of the sum depends on defaults of parameters.
    by_default: bool,
}

/// The factor of the square of a velocity.
#[derive(Clone, Copy)]
struct Weight {
    value: f64,
    /// True if the default of a parameter is part of it.
    by_default: bool,
}

/// Returns the first decreasing term for each velocity with which the sum decreases.
fn falling(elaborator: &Elaborator<'_>, terms: &[SourceTerm], defaults: &Defaults) -> Vec<Falling> {
    let graph = &elaborator.evaluator.graph;
    let values = terms.iter().map(|term| term.value).collect::<Vec<_>>();
    let total = weights(graph, defaults, &values);
    let mut found = Vec::new();
    for (speed, _) in &elaborator.speeds {
        let Some(Weight { by_default, .. }) = negative(&total, speed.velocity) else { continue };
        let falls =
            |term: &&SourceTerm| negative(&weights(graph, defaults, &[term.value]), speed.velocity).is_some();
        let name = elaborator.name_of_freedom(speed).to_owned();
        let first = terms.iter().find(falls);
        found.extend(first.map(|term| Falling { syntax: term.syntax, name, by_default }));
    }
    found
}

/// Returns the weight of a velocity, if it is negative.
fn negative(weights: &HashMap<ExprId, Option<Weight>>, velocity: ExprId) -> Option<Weight> {
    weights.get(&velocity).copied().flatten().filter(|weight| weight.value < 0.0)
}

/// Returns the factor of the square of each velocity in a sum; `None` if the velocity also occurs
/// in other terms.
fn weights(graph: &Graph, defaults: &Defaults, values: &[ExprId]) -> HashMap<ExprId, Option<Weight>> {
    let mut weights: HashMap<ExprId, Option<Weight>> = HashMap::default();
    // Each sum is expanded only once, since declarations may share sums to any depth.
    let (mut others, mut opened) = (Vec::new(), HashSet::default());
    let one = Weight { value: 1.0, by_default: false };
    let mut pending = values.iter().map(|&value| (one, value)).collect::<Vec<_>>();
    while let Some((scale, id)) = pending.pop() {
        if let Node::Sum { terms, .. } = graph.node(id) {
            let part = |coefficient: &Number| Weight { value: scale.value * coefficient.to_f64(), ..scale };
            pending.extend(terms.iter().map(|(term, coefficient)| (part(coefficient), *term)));
            continue;
        }
        match times_number(graph, defaults, id) {
            Some((weight, velocity, power)) if power == Number::TWO && is_symbol(graph, velocity) => {
                let zero = Weight { value: 0.0, by_default: false };
                let entry = weights.get_or_insert_with(velocity, || Some(zero));
                *entry = entry.map(|sum| sum.plus(scale.times(weight)));
            }
            Some((weight, sum, power)) if power == Number::ONE && opened.insert(sum) => {
                pending.push((scale.times(weight), sum));
            }
            _ => others.push(id),
        }
    }
    for part in graph.reachable_until(&others, |id| !is_moving(graph, id)) {
        if is_moving(graph, part) && matches!(graph.node(part), Node::Symbol(_)) {
            weights.insert(part, None);
        }
    }
    weights
}

impl Weight {
    fn plus(self, other: Weight) -> Weight {
        Weight { value: self.value + other.value, by_default: self.by_default || other.by_default }
    }

    fn times(self, other: Weight) -> Weight {
        Weight { value: self.value * other.value, by_default: self.by_default || other.by_default }
    }
}

fn is_moving(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::VELOCITY)
}

fn is_symbol(graph: &Graph, id: ExprId) -> bool {
    matches!(graph.node(id), Node::Symbol(_))
}

/// Returns `(w, e, n)` for w eⁿ, where w is a number and e the only factor with velocities.
fn times_number(graph: &Graph, defaults: &Defaults, id: ExprId) -> Option<(Weight, ExprId, Number)> {
    let Node::Product(factors) = graph.node(id) else { return None };
    let (moving, fixed) = factors.iter().partition::<Vec<_>, _>(|(base, _)| is_moving(graph, *base));
    let [(base, power)] = moving.as_slice() else { return None };
    let mut weight = Weight { value: 1.0, by_default: false };
    for (base, power) in fixed {
        if !graph.dependencies(*base).is_constant_in_motion() {
            return None;
        }
        let value = defaults.evaluate(graph, *base)?.powf(power.to_f64());
        let by_default = graph.dependencies(*base) != Dependencies::NONE;
        weight = weight.times(Weight { value, by_default });
    }
    Some((weight, *base, power.clone()))
}

#[cfg(test)]
mod tests;
