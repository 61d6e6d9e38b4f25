//! Sums with equal products combined, and squares of sine and cosine.

use super::monomial::{MAX_FACTORS, Monomial, Term};
use super::pairs::join;
use super::rules::squares;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// Returns `Σ coefficient · term`, with equal products combined, `a·cos²x + a·sin²x` replaced by
/// `a`, and `a·cosh²x - a·sinh²x` by `a`.
///
/// Products are compared across up to 16 nested parts, and the factors of `a` may be spread over
/// them. Other terms stay as they are; if nothing is replaced, the result is that of
/// [`Graph::sum`].
pub fn collect(graph: &mut Graph, terms: Vec<(ExprId, Number)>) -> ExprId {
    if terms.len() < 2 {
        return graph.sum(Number::ZERO, terms);
    }
    let mut terms = add_equal_products(graph, &terms);
    // The remainder of joined squares may equal another product, and so on; each round has fewer
    // terms.
    while let Some(fewer) = join_squares(graph, &terms) {
        terms = add_equal_products(graph, &fewer);
    }
    graph.sum(Number::ZERO, terms)
}

/// Applies the rules for squares, and returns the resulting terms if any rule applies.
fn join_squares(graph: &mut Graph, terms: &[(ExprId, Number)]) -> Option<Vec<(ExprId, Number)>> {
    let candidates = candidates(graph, terms);
    if candidates.len() < 2 {
        return None;
    }
    let flat = candidates.iter().map(|(_, term)| term.clone()).collect();
    let joined = join(graph, squares(), flat, |_| Some(()))?;
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

/// Returns the terms without their own coefficients. Products of the same factors are added up
/// under the first of them, and terms that cancel are omitted.
fn add_equal_products(graph: &Graph, terms: &[(ExprId, Number)]) -> Vec<(ExprId, Number)> {
    let mut sums: OrderedMap<Monomial, (ExprId, Number)> = OrderedMap::default();
    for (id, coefficient) in terms {
        let (core, coefficient) = split(graph, *id, coefficient);
        let flat = Monomial::of(graph, core, MAX_FACTORS);
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

/// Returns the terms with a square of a function to which rules apply.
fn candidates(graph: &Graph, terms: &[(ExprId, Number)]) -> Vec<(ExprId, Term)> {
    let candidate = |(id, coefficient): &(ExprId, Number)| {
        let monomial = with_square(graph, *id)?;
        Some((*id, Term { coefficient: coefficient.clone(), monomial }))
    };
    terms.iter().filter_map(candidate).collect()
}

/// Returns a term as a flat monomial, if its factors include a square of a function to which rules
/// apply.
fn with_square(graph: &Graph, id: ExprId) -> Option<Monomial> {
    let Node::Product(_) = graph.node(id) else { return None };
    let monomial = Monomial::of(graph, id, MAX_FACTORS)?;
    let is_square = |(base, exponent): &(ExprId, Number)| {
        exponent.to_i32().is_some_and(|exponent| exponent > 1) && is_known(graph, *base)
    };
    monomial.factors().iter().any(is_square).then_some(monomial)
}

fn is_known(graph: &Graph, id: ExprId) -> bool {
    use Function::{Cos, Cosh, Sin, Sinh};
    matches!(graph.node(id), Node::Call(Sin | Cos | Sinh | Cosh, _))
}

/// Returns `product / removed`, keeping the nesting.
fn remove_all(graph: &mut Graph, product: ExprId, removed: &Monomial) -> ExprId {
    let mut rest = product;
    for (base, exponent) in removed.factors() {
        match exponent.to_i32().map(|exponent| (exponent, take_out(graph, rest, *base, exponent))) {
            Some((exponent, (without, taken))) if taken == exponent => rest = without,
            _ => return divide_flat(graph, product, removed),
        }
    }
    rest
}

/// Returns the product without up to `wanted` powers of `base` at any place in it, and the number
/// of removed powers.
fn take_out(graph: &mut Graph, product: ExprId, base: ExprId, wanted: i32) -> (ExprId, i32) {
    let Node::Product(factors) = graph.node(product).clone() else { return (product, 0) };
    let mut factors = factors.into_vec();
    let mut taken = 0;
    for (factor, exponent) in &mut factors {
        let Some(power) = exponent.to_i32().filter(|&power| power > 0) else { continue };
        let missing = wanted - taken;
        if *factor == base {
            let found = power.min(missing);
            *exponent = Number::from(i64::from(power - found));
            taken += found;
        } else if missing >= power {
            let (without, found) = take_out(graph, *factor, base, missing / power);
            *factor = without;
            taken += found * power;
        }
    }
    (graph.product(factors), taken)
}

fn divide_flat(graph: &mut Graph, product: ExprId, removed: &Monomial) -> ExprId {
    match Monomial::of(graph, product, MAX_FACTORS) {
        Some(flat) => flat.over(removed).build(graph),
        None => graph.product(
            [(product, Number::ONE)]
                .into_iter()
                .chain(removed.power(&Number::MINUS_ONE).factors().iter().cloned()),
        ),
    }
}
