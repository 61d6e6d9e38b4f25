//! Polynomials for readers: factors that change during the motion are separated from constant ones.
//!
//! Terms over the same denominator are grouped, then terms that differ only in parameters:
//! `m1·l1²·a + m2·l1²·a` becomes `(m1 + m2)·l1²·a`.

use super::monomial::{Monomial, Term};
use super::polynomial::Polynomial;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// Maximum number of terms of a coefficient that is searched for common factors: after each group,
/// the rest is searched again.
const MAX_TERMS: usize = 64;

/// Returns an expression with the value of the polynomial.
pub(super) fn group(graph: &mut Graph, polynomial: &Polynomial) -> ExprId {
    let by_denominator = classify(polynomial.terms(), |base, exponent| {
        exponent.is_negative() && !graph.dependencies(base).is_constant_in_motion()
    });
    let mut parts = Vec::new();
    for (denominator, terms) in by_denominator {
        // The denominator of a single term stays with it, since there is nothing to group.
        if terms.len() == 1 || denominator.is_one() {
            let whole = terms.into_iter().map(|term| term.times(&denominator)).collect();
            parts.extend(by_motion(graph, whole));
        } else {
            let numerator = by_motion(graph, terms);
            let numerator = graph.sum(Number::ZERO, numerator);
            parts.push((multiply(graph, numerator, &denominator), Number::ONE));
        }
    }
    graph.sum(Number::ZERO, parts)
}

/// Returns the polynomial with terms combined that differ only in sines and cosines. The sum in
/// parentheses, such as sin a cos b − cos a sin b, is often reused.
pub(super) fn gather_waves(graph: &mut Graph, polynomial: &Polynomial) -> Polynomial {
    let is_wave = |graph: &Graph, base: ExprId| {
        matches!(graph.node(base), Node::Call(Function::Sin | Function::Cos, _))
    };
    let classes = classify(polynomial.terms(), |base, _| !is_wave(graph, base));
    let gathered = classes.into_iter().flat_map(|(key, waves)| {
        if waves.len() == 1 {
            return waves.iter().map(|wave| wave.times(&key)).collect::<Vec<_>>();
        }
        let sum = waves.iter().map(|wave| wave.build(graph)).collect::<Vec<_>>();
        let sum = graph.sum(Number::ZERO, sum);
        let (coefficient, core) = graph.split_coefficient(sum);
        vec![Term { coefficient, monomial: key.times_power(core, 1) }]
    });
    Polynomial::of_terms(gathered.collect::<Vec<_>>())
}

impl Term {
    fn times(&self, monomial: &Monomial) -> Term {
        Term { coefficient: self.coefficient.clone(), monomial: self.monomial.times(monomial) }
    }

    fn build(&self, graph: &mut Graph) -> (ExprId, Number) {
        (self.monomial.build(graph), self.coefficient.clone())
    }
}

/// Classifies terms by the product of their factors that satisfy `is_key`; the values are the
/// remaining factors.
fn classify(terms: Vec<Term>, is_key: impl Fn(ExprId, &Number) -> bool) -> Vec<(Monomial, Vec<Term>)> {
    let mut classes: OrderedMap<Monomial, Vec<Term>> = OrderedMap::default();
    for term in terms {
        let (key, rest) = term.monomial.split(&is_key);
        let rest = Term { coefficient: term.coefficient, monomial: rest };
        classes.get_or_insert_with(key, Vec::new).push(rest);
    }
    classes.iter().map(|(key, terms)| (key.clone(), terms.clone())).collect()
}

/// Returns the product, with the factors of `factor` at the same level as those of the expression.
fn multiply(graph: &mut Graph, id: ExprId, factor: &Monomial) -> ExprId {
    let (coefficient, core) = graph.split_coefficient(id);
    let inner = match graph.node(core) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![(core, Number::ONE)],
    };
    let product = graph.product(inner.into_iter().chain(factor.factors().iter().cloned()));
    graph.scale(coefficient, product)
}

/// Returns one part for each product of factors that change during the motion.
fn by_motion(graph: &mut Graph, terms: Vec<Term>) -> Vec<(ExprId, Number)> {
    let classes = classify(terms, |base, _| !graph.dependencies(base).is_constant_in_motion());
    let mut parts = Vec::new();
    for (motion, coefficients) in classes {
        if coefficients.len() == 1 {
            parts.extend(coefficients.iter().map(|term| term.times(&motion).build(graph)));
        } else if motion.is_one() {
            parts.extend(by_common_factor(graph, coefficients));
        } else {
            parts.push((factored(graph, &coefficients, &motion), Number::ONE));
        }
    }
    parts
}

/// Returns the sum of the terms times `factor`, with the common factor of all terms factored out.
fn factored(graph: &mut Graph, terms: &[Term], factor: &Monomial) -> ExprId {
    let common = common_factor(terms);
    let inverse = common.power(&Number::MINUS_ONE);
    let rest = terms.iter().map(|term| term.times(&inverse)).collect();
    let parts = by_common_factor(graph, rest);
    let sum = graph.sum(Number::ZERO, parts);
    multiply(graph, sum, &common.times(factor))
}

/// Returns the largest monomial that divides every term without a change of sign in an exponent.
fn common_factor(terms: &[Term]) -> Monomial {
    let [first, others @ ..] = terms else { return Monomial::default() };
    let common = first.monomial.factors().iter().filter_map(|(base, exponent)| {
        let mut least = exponent.clone();
        for other in others {
            let exponent = other.monomial.exponent(*base)?;
            if exponent.is_negative() != least.is_negative() {
                return None;
            }
            least = least.min(exponent.clone());
        }
        Some((*base, least))
    });
    Monomial::new(common.collect())
}

/// Factors out the common part of groups of terms that differ in a single factor, largest groups
/// first.
fn by_common_factor(graph: &mut Graph, mut terms: Vec<Term>) -> Vec<(ExprId, Number)> {
    let mut parts = Vec::new();
    while terms.len() <= MAX_TERMS
        && let Some((shared, members)) = largest_group(&terms)
    {
        let inverse = shared.power(&Number::MINUS_ONE);
        let sum = members.iter().map(|&i| terms[i].times(&inverse).build(graph)).collect::<Vec<_>>();
        let sum = graph.sum(Number::ZERO, sum);
        parts.push((multiply(graph, sum, &shared), Number::ONE));
        let mut index = 0..;
        terms.retain(|_| !index.next().is_some_and(|i| members.contains(&i)));
    }
    parts.extend(terms.iter().map(|term| term.build(graph)));
    parts
}

/// Returns the monomial that the most terms share when one factor is removed, preferably the
/// longest one, with the indices of these terms.
fn largest_group(terms: &[Term]) -> Option<(Monomial, Vec<usize>)> {
    let mut groups: OrderedMap<Monomial, Vec<usize>> = OrderedMap::default();
    for (index, term) in terms.iter().enumerate() {
        for (base, exponent) in term.monomial.factors() {
            let shared = term.monomial.over(&Monomial::new(vec![(*base, exponent.clone())]));
            if !shared.is_one() {
                groups.get_or_insert_with(shared, Vec::new).push(index);
            }
        }
    }
    let candidates = groups.iter().filter(|(_, members)| members.len() > 1);
    // Among equally good groups, `max_by_key` returns the last one, which is the first one in
    // reverse order.
    let best = candidates.rev().max_by_key(|(shared, members)| (members.len(), shared.degree()));
    best.map(|(shared, members)| (shared.clone(), members.clone()))
}
