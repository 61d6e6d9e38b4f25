//! Sums in which squares of sine and cosine meet.

use super::monomial::{Monomial, Term};
use super::pairs::join;
use super::rules::squares;
use crate::collections::{HashMap, OrderedMap};
use crate::expr::{ExprId, Function, Graph, Node};
use crate::number::Number;

/// Products with more nested parts than this are not looked into.
const MOST_FACTORS: usize = 16;

/// `Σ coefficient · term`, with `a·cos²x + a·sin²x` replaced by `a` and `a·cosh²x - a·sinh²x` by `a`.
///
/// The factors of `a` may be spread over nested products of up to 16 parts in all. What is not
/// replaced stays as it is; if nothing is replaced, the result is that of [`Graph::sum`].
pub fn collect(graph: &mut Graph, terms: Vec<(ExprId, Number)>) -> ExprId {
    let candidates = candidates(graph, &terms);
    if candidates.len() < 2 {
        return graph.sum(Number::ZERO, terms);
    }
    let flat = candidates.iter().map(|(_, term)| term.clone()).collect();
    let joined = join(graph, squares(), flat);
    if joined.len() == candidates.len() {
        return graph.sum(Number::ZERO, terms);
    }
    let mut result = terms.into_iter().map(|(id, c)| split(graph, id, &c)).collect::<Vec<_>>();
    let is_candidate = candidates.iter().map(|(id, _)| (*id, ())).collect::<HashMap<_, _>>();
    result.retain(|(id, _)| !is_candidate.contains(id));
    for left in joined {
        let (origin, before) = &candidates[left.source];
        let removed = before.monomial.over(&left.term.monomial);
        result.push((remove_all(graph, *origin, &removed), left.term.coefficient));
    }
    graph.sum(Number::ZERO, result)
}

fn split(graph: &Graph, id: ExprId, coefficient: &Number) -> (ExprId, Number) {
    let (inner, core) = graph.split_coefficient(id);
    (core, &inner * coefficient)
}

/// The terms that hold a square of a function the rules know, equal ones added up.
fn candidates(graph: &Graph, terms: &[(ExprId, Number)]) -> Vec<(ExprId, Term)> {
    let mut found: OrderedMap<ExprId, Term> = OrderedMap::default();
    for (id, coefficient) in terms {
        let (core, coefficient) = split(graph, *id, coefficient);
        if let Some(term) = found.get_mut(&core) {
            term.coefficient = &term.coefficient + &coefficient;
        } else if let Some(monomial) = with_square(graph, core) {
            found.insert(core, Term { coefficient, monomial });
        }
    }
    found.iter().map(|(id, term)| (*id, term.clone())).collect()
}

/// The term as a flat monomial, if a square of a function the rules know is among its factors.
fn with_square(graph: &Graph, id: ExprId) -> Option<Monomial> {
    let Node::Product(_) = graph.node(id) else { return None };
    let monomial = Monomial::of(graph, id, MOST_FACTORS)?;
    let is_square = |(base, exponent): &(ExprId, Number)| {
        exponent.to_i32().is_some_and(|exponent| exponent > 1) && is_known(graph, *base)
    };
    monomial.factors().iter().any(is_square).then_some(monomial)
}

fn is_known(graph: &Graph, id: ExprId) -> bool {
    use Function::{Cos, Cosh, Sin, Sinh};
    matches!(graph.node(id), Node::Call(Sin | Cos | Sinh | Cosh, _))
}

fn remove_all(graph: &mut Graph, origin: ExprId, removed: &Monomial) -> ExprId {
    removed.factors().iter().fold(origin, |id, (base, exponent)| remove(graph, id, *base, exponent))
}

/// `product / base ^ exponent`, keeping the nesting where the base stands in the product itself or in one
/// of its factors.
fn remove(graph: &mut Graph, product: ExprId, base: ExprId, exponent: &Number) -> ExprId {
    let Node::Product(factors) = graph.node(product).clone() else {
        return graph.product([(product, Number::ONE), (base, -exponent)]);
    };
    let mut factors = factors.into_vec();
    let direct = factors.iter().any(|(factor, _)| *factor == base);
    let nested_in = |(factor, outer): &(ExprId, Number)| outer.is_integer() && holds(graph, *factor, base);
    if !direct && let Some(position) = factors.iter().position(nested_in) {
        let (nested, outer) = factors[position].clone();
        let inner = exponent_of(graph, nested, base);
        factors[position].0 = graph.product([(nested, Number::ONE), (base, -&inner)]);
        factors.push((base, &inner * &outer));
    } else if !direct {
        let flat = Monomial::of(graph, product, MOST_FACTORS);
        factors = flat.map_or(factors, |flat| flat.factors().to_vec());
    }
    factors.push((base, -exponent));
    graph.product(factors)
}

fn holds(graph: &Graph, product: ExprId, base: ExprId) -> bool {
    !exponent_of(graph, product, base).is_zero()
}

/// The exponent with which `base` stands in a product.
fn exponent_of(graph: &Graph, product: ExprId, base: ExprId) -> Number {
    match graph.node(product) {
        Node::Product(factors) => factors
            .iter()
            .find(|(factor, _)| *factor == base)
            .map_or(Number::ZERO, |(_, exponent)| exponent.clone()),
        _ => Number::ZERO,
    }
}
