//! Sums: chains of additions and subtractions that start with a positive term.

use super::Lowering;
use crate::collections::OrderedMap;
use crate::expr::ExprId;
use crate::number::Number;
use crate::program::{Op, ValueId};

/// A value to be added, or subtracted if negative.
#[derive(Clone, Copy)]
struct Term {
    value: ValueId,
    negative: bool,
}

impl Lowering<'_> {
    /// `constant + Σ coefficient · term`; terms whose coefficients have the same magnitude are added
    /// before they are multiplied by it.
    pub(super) fn sum(&mut self, constant: &Number, terms: &[(ExprId, Number)]) -> ValueId {
        let (constant, terms) = self.sharing.terms(self.graph, constant, terms);
        if let ([(term, coefficient)], true) = (terms.as_slice(), constant.is_zero()) {
            return self.scaled(coefficient, *term);
        }
        let mut groups: OrderedMap<Number, Vec<(ExprId, bool)>> = OrderedMap::default();
        for (term, coefficient) in terms {
            let negative = coefficient.is_negative();
            groups.get_or_insert_with(coefficient.abs(), Vec::new).push((term, negative));
        }
        let mut chain = Vec::new();
        for (magnitude, members) in groups.iter() {
            self.push_group(&mut chain, magnitude, members);
        }
        let negative = constant.is_negative();
        chain.push(Term { value: self.builder.constant(constant.abs()), negative });
        let total = self.chain(&chain);
        if total.negative { self.builder.negate(total.value) } else { total.value }
    }

    fn push_group(&mut self, chain: &mut Vec<Term>, magnitude: &Number, members: &[(ExprId, bool)]) {
        if let [(term, negative)] = *members {
            chain.push(Term { value: self.scaled(magnitude, term), negative });
            return;
        }
        let one = Number::ONE;
        let terms = members.iter().map(|&(term, negative)| Term { value: self.scaled(&one, term), negative });
        let terms = terms.collect::<Vec<_>>();
        if magnitude.is_one() {
            chain.extend(terms);
            return;
        }
        let Term { value, negative } = self.chain(&terms);
        let magnitude = self.builder.constant(magnitude.clone());
        chain.push(Term { value: self.builder.multiply(magnitude, value), negative });
    }

    /// `coefficient · term`
    fn scaled(&mut self, coefficient: &Number, term: ExprId) -> ValueId {
        if self.sharing.is_merged(term) {
            return self.product(coefficient, term);
        }
        let value = self.value(term);
        let coefficient = self.builder.constant(coefficient.clone());
        self.builder.multiply(coefficient, value)
    }

    /// The sum of the terms. Known numbers are added up and come last; if no term is positive, neither is
    /// the result.
    fn chain(&mut self, terms: &[Term]) -> Term {
        let (constants, mut chain): (Vec<Term>, Vec<Term>) =
            terms.iter().partition(|term| self.builder.op(term.value).is_constant());
        chain.extend(self.constant_term(&constants));
        let Some(first) = chain.iter().position(|term| !term.negative) else {
            chain.iter_mut().for_each(|term| term.negative = false);
            return Term { value: self.total(chain, 0), negative: true };
        };
        Term { value: self.total(chain, first), negative: false }
    }

    /// The sum of known numbers as a term, unless it is zero.
    fn constant_term(&mut self, constants: &[Term]) -> Option<Term> {
        let zero = self.builder.constant(Number::ZERO);
        let sum = constants.iter().fold(zero, |sum, term| self.append(sum, *term));
        let opposite = self.builder.negate(sum);
        let negative = match self.builder.op(sum) {
            Op::Constant(value) => value.is_negative(),
            Op::Float(value) => value.value() < 0.0,
            _ => false,
        };
        (sum != zero).then_some(Term { value: if negative { opposite } else { sum }, negative })
    }

    /// The first term with the others added to it, or zero if there is none.
    fn total(&mut self, mut terms: Vec<Term>, first: usize) -> ValueId {
        if terms.is_empty() {
            return self.builder.constant(Number::ZERO);
        }
        let first = terms.remove(first).value;
        terms.into_iter().fold(first, |sum, term| self.append(sum, term))
    }

    fn append(&mut self, sum: ValueId, term: Term) -> ValueId {
        if term.negative { self.builder.subtract(sum, term.value) } else { self.builder.add(sum, term.value) }
    }
}
