//! Kinetic energies and dissipations that are negative, with numbers or with the defaults of
//! parameters.
//!
//! Only what shows is judged: a velocity all of whose terms are its square times numbers.
//! Definiteness in general is a matter of parameters, and of run time.

use super::elaborator::{Elaborator, SourceTerm};
use super::messages;
use super::obligations::Defaults;
use lagrange_expr::collections::{HashMap, HashSet};
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::AstId;

/// Reports coordinates whose kinetic energy falls with their velocity, and whose dissipation does:
/// errors where numbers say so, warnings where defaults do.
pub(super) fn check_signs(elaborator: &mut Elaborator<'_>) {
    let defaults = Defaults::of(elaborator);
    for (syntax, value, name) in falling(elaborator, &elaborator.kinetic, &defaults) {
        let origin = elaborator.evaluator.origin(syntax);
        let is_certain = elaborator.evaluator.graph.dependencies(value) == Dependencies::VELOCITY;
        let report = &mut *elaborator.evaluator.report;
        let wrong = match is_certain {
            true => report.error(origin, messages::negative_kinetic_energy(&name)),
            false => report.doubtful(origin, messages::negative_by_default(&name)),
        };
        wrong.help(messages::NEGATIVE_INERTIA_HELP);
    }
    for (syntax, _, name) in falling(elaborator, &elaborator.dissipation, &defaults) {
        let origin = elaborator.evaluator.origin(syntax);
        let warning = elaborator.evaluator.report.doubtful(origin, messages::negative_dissipation(&name));
        warning.help(messages::NEGATIVE_DISSIPATION_HELP);
    }
}

/// Terms that fall with a velocity with which their sum falls, and its name.
fn falling(
    elaborator: &Elaborator<'_>,
    terms: &[SourceTerm],
    defaults: &Defaults,
) -> Vec<(AstId, ExprId, String)> {
    let graph = &elaborator.evaluator.graph;
    let values = terms.iter().map(|term| term.value).collect::<Vec<_>>();
    let total = weights(graph, defaults, &values);
    let mut found = Vec::new();
    for (speed, _) in elaborator.speeds.iter().filter(|(speed, _)| falls_with(&total, speed.velocity)) {
        let falls = |term: &&SourceTerm| falls_with(&weights(graph, defaults, &[term.value]), speed.velocity);
        let name = elaborator.name_of_freedom(speed).to_owned();
        found.extend(terms.iter().find(falls).map(|term| (term.syntax, term.value, name)));
    }
    found
}

fn falls_with(weights: &HashMap<ExprId, Option<f64>>, velocity: ExprId) -> bool {
    weights.get(&velocity).copied().flatten().is_some_and(|weight| weight < 0.0)
}

/// Factor of the square of each velocity in a sum; `None` where the velocity stands in other terms,
/// too.
fn weights(graph: &Graph, defaults: &Defaults, values: &[ExprId]) -> HashMap<ExprId, Option<f64>> {
    let mut weights: HashMap<ExprId, Option<f64>> = HashMap::default();
    // A sum is opened once: declarations may share sums to any depth.
    let (mut others, mut opened) = (Vec::new(), HashSet::default());
    let mut pending = values.iter().map(|&value| (1.0, value)).collect::<Vec<_>>();
    while let Some((scale, id)) = pending.pop() {
        if let Node::Sum { terms, .. } = graph.node(id) {
            pending.extend(terms.iter().map(|(term, coefficient)| (scale * coefficient.to_f64(), *term)));
            continue;
        }
        match times_number(graph, defaults, id) {
            Some((weight, velocity, power)) if power == Number::TWO && is_symbol(graph, velocity) => {
                let entry = weights.get_or_insert_with(velocity, || Some(0.0));
                *entry = entry.map(|sum| sum + scale * weight);
            }
            Some((weight, sum, power)) if power == Number::ONE && opened.insert(sum) => {
                pending.push((scale * weight, sum));
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

fn is_moving(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::VELOCITY)
}

fn is_symbol(graph: &Graph, id: ExprId) -> bool {
    matches!(graph.node(id), Node::Symbol(_))
}

/// `(w, e, n)` of w eⁿ with a number w, and e the only factor with velocities.
fn times_number(graph: &Graph, defaults: &Defaults, id: ExprId) -> Option<(f64, ExprId, Number)> {
    let Node::Product(factors) = graph.node(id) else { return None };
    let (moving, fixed) = factors.iter().partition::<Vec<_>, _>(|(base, _)| is_moving(graph, *base));
    let [(base, power)] = moving.as_slice() else { return None };
    let mut weight = 1.0;
    for (base, power) in fixed {
        if !graph.dependencies(*base).is_constant_in_motion() {
            return None;
        }
        weight *= defaults.evaluate(graph, *base)?.powf(power.to_f64());
    }
    Some((weight, *base, power.clone()))
}

#[cfg(test)]
mod tests;
