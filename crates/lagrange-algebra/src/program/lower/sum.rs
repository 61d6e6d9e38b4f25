//! Sums: chains of additions and subtractions that start with a positive term.

use super::lowering::{Lowering, Signed};
use super::product::lower_product;
use crate::program::{Op, ValueId};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;

/// Lowers `constant + Σ coefficient · term`, or its negative if `opposite` is set. Terms whose
/// coefficients have the same magnitude are added before they are multiplied by it.
pub(super) fn lower_sum(
    lowering: &mut Lowering<'_>,
    constant: &Number,
    terms: &[(ExprId, Number)],
    opposite: bool,
) -> Signed {
    let (constant, terms) = lowering.sharing.terms(lowering.graph, constant, terms);
    if let ([(term, coefficient)], true) = (terms.as_slice(), constant.is_zero()) {
        return scaled(lowering, coefficient, *term);
    }
    let mut groups: OrderedMap<Number, Vec<(ExprId, bool)>> = OrderedMap::default();
    for (term, coefficient) in terms {
        let negative = coefficient.is_negative();
        groups.get_or_insert_with(coefficient.abs(), Vec::new).push((term, negative));
    }
    let mut chain = Vec::new();
    for (magnitude, members) in groups.iter() {
        push_group(lowering, &mut chain, magnitude, members);
    }
    let value = lowering.builder.constant(constant.abs());
    chain.push(Signed { value, negative: constant.is_negative() });
    if opposite {
        chain.iter_mut().for_each(|term| term.negative = !term.negative);
    }
    let total = chained(lowering, &chain);
    // A negative with a label is computed even if no term is positive, since the label needs a
    // value.
    let total = if opposite { Signed::positive(lowering.with_sign(total)) } else { total };
    Signed { negative: total.negative != opposite, ..total }
}

fn push_group(
    lowering: &mut Lowering<'_>,
    chain: &mut Vec<Signed>,
    magnitude: &Number,
    members: &[(ExprId, bool)],
) {
    if let [(term, negative)] = *members {
        let scaled = scaled(lowering, magnitude, term);
        chain.push(Signed { negative: scaled.negative != negative, ..scaled });
        return;
    }
    let signed = |&(term, negative): &(ExprId, bool)| {
        let scaled = scaled(lowering, &Number::ONE, term);
        Signed { negative: scaled.negative != negative, ..scaled }
    };
    let terms = members.iter().map(signed).collect::<Vec<_>>();
    if magnitude.is_one() {
        chain.extend(terms);
        return;
    }
    let Signed { value, negative } = chained(lowering, &terms);
    let magnitude = lowering.builder.constant(magnitude.clone());
    chain.push(Signed { value: lowering.builder.multiply(magnitude, value), negative });
}

/// Lowers `coefficient · term`.
fn scaled(lowering: &mut Lowering<'_>, coefficient: &Number, term: ExprId) -> Signed {
    if lowering.sharing.is_merged(term) {
        return lower_product(lowering, coefficient, term);
    }
    let Signed { value, negative } = lowering.signed(term);
    if coefficient.abs().is_one() {
        return Signed { value, negative: negative != coefficient.is_negative() };
    }
    let coefficient = lowering.builder.constant(if negative { -coefficient } else { coefficient.clone() });
    Signed::positive(lowering.builder.multiply(coefficient, value))
}

/// Adds the terms. Constants are folded and come last. If no term is positive, the result is marked
/// as negative.
fn chained(lowering: &mut Lowering<'_>, terms: &[Signed]) -> Signed {
    let (constants, mut chain): (Vec<Signed>, Vec<Signed>) =
        terms.iter().partition(|term| lowering.builder.op(term.value).is_constant());
    chain.extend(constant_term(lowering, &constants));
    let Some(first) = chain.iter().position(|term| !term.negative) else {
        chain.iter_mut().for_each(|term| term.negative = false);
        let negative = !chain.is_empty();
        return Signed { value: total(lowering, chain, 0), negative };
    };
    Signed::positive(total(lowering, chain, first))
}

/// Folds constants to one term, unless their sum is zero.
fn constant_term(lowering: &mut Lowering<'_>, constants: &[Signed]) -> Option<Signed> {
    let zero = lowering.builder.constant(Number::ZERO);
    let sum = constants.iter().fold(zero, |sum, term| append(lowering, sum, *term));
    let opposite = lowering.builder.negate(sum);
    let negative = match lowering.builder.op(sum) {
        Op::Constant(value) => value.is_negative(),
        Op::Float(value) => value.value() < 0.0,
        _ => false,
    };
    (sum != zero).then_some(Signed { value: if negative { opposite } else { sum }, negative })
}

/// Adds the other terms to the one at index `first`; zero if there are no terms.
fn total(lowering: &mut Lowering<'_>, mut terms: Vec<Signed>, first: usize) -> ValueId {
    if terms.is_empty() {
        return lowering.builder.constant(Number::ZERO);
    }
    let first = terms.remove(first).value;
    terms.into_iter().fold(first, |sum, term| append(lowering, sum, term))
}

fn append(lowering: &mut Lowering<'_>, sum: ValueId, term: Signed) -> ValueId {
    if term.negative {
        lowering.builder.subtract(sum, term.value)
    } else {
        lowering.builder.add(sum, term.value)
    }
}
