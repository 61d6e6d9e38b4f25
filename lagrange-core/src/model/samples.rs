//! Points at which formulas are sampled, and formulas for which samples are insufficient.

use super::Model;
use lagrange_algebra::simplify::somewhere;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node, evaluate};
use lagrange_expr::symbol::Role;

/// A value, and the sum of the magnitudes of its terms.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    pub(crate) value: f64,
    pub(crate) magnitude: f64,
}

/// Returns the values of expressions at a point.
pub(crate) fn sample_values(model: &Model, roots: &[ExprId], point: usize) -> Vec<f64> {
    evaluate(&model.graph, roots, |role| sample(model, role, point))
}

/// Returns the values of expressions at a point where parameters have their defaults, if these
/// exist.
pub(crate) fn default_values(model: &Model, roots: &[ExprId], point: usize) -> Vec<f64> {
    let defaults = model.parameters.iter().filter_map(|parameter| {
        let value = evaluate(&model.graph, &[parameter.default?], |_| f64::NAN)[0];
        Some((model.graph.symbol_of(parameter.symbol)?.role, value))
    });
    let defaults = defaults.collect::<HashMap<_, _>>();
    let value = |role: Role| defaults.get(&role).copied().unwrap_or_else(|| sample(model, role, point));
    evaluate(&model.graph, roots, value)
}

/// Returns the values of expressions at a point, with magnitudes in which no terms cancel.
pub(crate) fn entries(model: &Model, parts: &[ExprId], point: usize) -> HashMap<ExprId, Entry> {
    let values = sample_values(model, parts, point);
    let mut entries = HashMap::default();
    for (&id, value) in parts.iter().zip(values) {
        let known = |id: &ExprId| entries.get(id).map_or(f64::NAN, |entry: &Entry| entry.magnitude);
        let magnitude = match model.graph.node(id) {
            Node::Sum { constant, terms } => terms
                .iter()
                .fold(constant.to_f64().abs(), |sum, (term, c)| sum + c.to_f64().abs() * known(term)),
            Node::Product(factors) => factors.iter().fold(1.0, |product, (base, exponent)| {
                let exponent = exponent.to_f64();
                let base = if exponent > 0.0 {
                    known(base)
                } else {
                    entries.get(base).map_or(f64::NAN, |of| of.value.abs())
                };
                product * base.powf(exponent)
            }),
            _ => value.abs(),
        };
        entries.insert(id, Entry { value, magnitude });
    }
    entries
}

/// Returns a number between 1/2 and 3/2 for a symbol at a point; quaternions have length one.
fn sample(model: &Model, role: Role, point: usize) -> f64 {
    let Role::Coordinate(index) = role else { return spread(role, point) };
    let of = model.orientations.iter().find(|of| (of.position..of.position + 4).contains(&(index as usize)));
    let Some(of) = of else { return spread(role, point) };
    let parts = (0..4).map(|part| spread(Role::Coordinate((of.position + part) as u32), point) - 1.0);
    let length = parts.map(|part| part * part).sum::<f64>().sqrt();
    (spread(role, point) - 1.0) / length
}

/// Returns a number for a symbol at a point by Sebastiano Vigna's splitmix64, a hash with
/// independent values.
fn spread(role: Role, point: usize) -> f64 {
    let symbol = somewhere(role).to_bits();
    let mut hash = symbol.wrapping_add((point as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    hash = (hash ^ (hash >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    hash = (hash ^ (hash >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    0.5 + ((hash ^ (hash >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// True if a formula may be flat at some points but not elsewhere: it is piecewise, or too steep to
/// show in numbers.
pub(crate) fn may_be_flat(graph: &Graph, root: ExprId) -> bool {
    let may_be_flat = |id: ExprId| match graph.node(id) {
        Node::Choose { .. } | Node::Opaque(..) => true,
        Node::Call(function, _) => !matches!(function, Function::Sin | Function::Cos),
        _ => false,
    };
    graph.reachable(&[root]).into_iter().any(may_be_flat)
}
