//! Sums in which equal products and squares of sine and cosine meet.

use super::monomial::{Monomial, Term};
use super::pairs::join;
use super::rules::squares;
use crate::collections::{HashMap, OrderedMap};
use crate::expr::{ExprId, Function, Graph, Node};
use crate::number::Number;

/// Products with more nested parts than this are not looked into.
const MOST_FACTORS: usize = 16;

/// `Σ coefficient · term`, with equal products added up however they are nested, `a·cos²x + a·sin²x`
/// replaced by `a`, and `a·cosh²x - a·sinh²x` by `a`.
///
/// Products are compared, and the factors of `a` may be spread, over up to 16 nested parts. What is not
/// replaced stays as it is; if nothing is replaced, the result is that of [`Graph::sum`].
pub fn collect(graph: &mut Graph, terms: Vec<(ExprId, Number)>) -> ExprId {
    if terms.len() < 2 {
        return graph.sum(Number::ZERO, terms);
    }
    let mut terms = add_equal_products(graph, &terms);
    // What squares leave behind may equal another product, and so on; each round has fewer terms.
    while let Some(fewer) = join_squares(graph, &terms) {
        terms = add_equal_products(graph, &fewer);
    }
    graph.sum(Number::ZERO, terms)
}

/// The terms after the rules for squares, if any of these applies.
fn join_squares(graph: &mut Graph, terms: &[(ExprId, Number)]) -> Option<Vec<(ExprId, Number)>> {
    let candidates = candidates(graph, terms);
    if candidates.len() < 2 {
        return None;
    }
    let flat = candidates.iter().map(|(_, term)| term.clone()).collect();
    let joined = join(graph, squares(), flat);
    if joined.len() == candidates.len() {
        return None;
    }
    let is_candidate = candidates.iter().map(|(id, _)| (*id, ())).collect::<HashMap<_, _>>();
    let mut result = terms.to_vec();
    result.retain(|(id, _)| !is_candidate.contains(id));
    for left in joined {
        let (origin, before) = &candidates[left.source];
        let removed = before.monomial.over(&left.term.monomial);
        result.push((remove_all(graph, *origin, &removed), left.term.coefficient));
    }
    Some(result)
}

/// The terms without coefficients of their own, products of the same factors added up under the first of
/// them, and those that cancel left out.
fn add_equal_products(graph: &Graph, terms: &[(ExprId, Number)]) -> Vec<(ExprId, Number)> {
    let mut sums: OrderedMap<Monomial, (ExprId, Number)> = OrderedMap::default();
    for (id, coefficient) in terms {
        let (core, coefficient) = split(graph, *id, coefficient);
        let flat = Monomial::of(graph, core, MOST_FACTORS);
        let key = flat.unwrap_or_else(|| Monomial::new(vec![(core, Number::ONE)]));
        let sum = sums.get_or_insert_with(key, || (core, Number::ZERO));
        sum.1 = &sum.1 + &coefficient;
    }
    sums.iter().map(|(_, sum)| sum.clone()).filter(|(_, coefficient)| !coefficient.is_zero()).collect()
}

fn split(graph: &Graph, id: ExprId, coefficient: &Number) -> (ExprId, Number) {
    let (inner, core) = graph.split_coefficient(id);
    (core, &inner * coefficient)
}

/// The terms that hold a square of a function the rules know.
fn candidates(graph: &Graph, terms: &[(ExprId, Number)]) -> Vec<(ExprId, Term)> {
    let candidate = |(id, coefficient): &(ExprId, Number)| {
        let monomial = with_square(graph, *id)?;
        Some((*id, Term { coefficient: coefficient.clone(), monomial }))
    };
    terms.iter().filter_map(candidate).collect()
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
