//! Kinetic energies that are negative whatever the parameters are.
//!
//! Only what shows is judged: a velocity all of whose terms are its square times numbers.
//! Definiteness in general is a matter of parameters, and of run time.

use super::elaborator::Elaborator;
use super::messages;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Reports coordinates whose kinetic energy falls with their velocity.
pub(super) fn check_signs(elaborator: &mut Elaborator<'_>) {
    let values = elaborator.kinetic.iter().map(|term| term.value).collect::<Vec<_>>();
    let total = weights(&elaborator.evaluator.graph, &values);
    for (speed, _) in &elaborator.speeds {
        if !falls_with(&total, speed.velocity) {
            continue;
        }
        let graph = &elaborator.evaluator.graph;
        let falls = |value: ExprId| falls_with(&weights(graph, &[value]), speed.velocity);
        let Some(term) = elaborator.kinetic.iter().find(|term| falls(term.value)) else { continue };
        let origin = elaborator.evaluator.origin(term.syntax);
        let message = messages::negative_kinetic_energy(elaborator.name_of_freedom(speed));
        elaborator.evaluator.report.error(origin, message).help(messages::NEGATIVE_INERTIA_HELP);
    }
}

fn falls_with(weights: &HashMap<ExprId, Option<f64>>, velocity: ExprId) -> bool {
    weights.get(&velocity).copied().flatten().is_some_and(|weight| weight < 0.0)
}

/// Factor of the square of each velocity in a sum; `None` where the velocity stands in other terms,
/// too.
fn weights(graph: &Graph, values: &[ExprId]) -> HashMap<ExprId, Option<f64>> {
    let mut weights: HashMap<ExprId, Option<f64>> = HashMap::default();
    let mut others = Vec::new();
    let mut pending = values.iter().map(|&value| (1.0, value)).collect::<Vec<_>>();
    while let Some((scale, id)) = pending.pop() {
        if let Node::Sum { terms, .. } = graph.node(id) {
            pending.extend(terms.iter().map(|(term, coefficient)| (scale * coefficient.to_f64(), *term)));
        } else if let Some((weight, velocity)) = numeric_square(graph, id) {
            let entry = weights.get_or_insert_with(velocity, || Some(0.0));
            *entry = entry.map(|sum| sum + scale * weight);
        } else {
            others.push(id);
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

/// `(w, v)` of w v² with a number w and the velocity v of a coordinate.
fn numeric_square(graph: &Graph, id: ExprId) -> Option<(f64, ExprId)> {
    let Node::Product(factors) = graph.node(id) else { return None };
    let (moving, fixed) = factors.iter().partition::<Vec<_>, _>(|(base, _)| is_moving(graph, *base));
    let &[(velocity, exponent)] = moving.as_slice() else { return None };
    let is_square = *exponent == Number::TWO && matches!(graph.node(*velocity), Node::Symbol(_));
    let is_numeric = fixed.iter().all(|(base, _)| graph.dependencies(*base) == Dependencies::NONE);
    if !is_square || !is_numeric {
        return None;
    }
    let powers =
        fixed.iter().map(|(base, power)| evaluate(graph, &[*base], |_| f64::NAN)[0].powf(power.to_f64()));
    Some((powers.product(), *velocity))
}
