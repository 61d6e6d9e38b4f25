//! Sums: chains of additions and subtractions that start with a positive term.

use super::{Lowering, Signed};
use crate::collections::OrderedMap;
use crate::expr::ExprId;
use crate::number::Number;
use crate::program::{Op, ValueId};

impl Lowering<'_> {
    /// `constant + Σ coefficient · term`, or its opposite if that is wanted; terms whose coefficients have the same magnitude are added before they are multiplied by it.
    pub(super) fn sum(&mut self, constant: &Number, terms: &[(ExprId, Number)], opposite: bool) -> Signed {
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
        let value = self.builder.constant(constant.abs());
        chain.push(Signed { value, negative: constant.is_negative() });
        if opposite {
            chain.iter_mut().for_each(|term| term.negative = !term.negative);
        }
        let total = self.chain(&chain);
        // An opposite that has a name is computed even if no term is positive.
        let total = if opposite { Signed::positive(self.with_sign(total)) } else { total };
        Signed { negative: total.negative != opposite, ..total }
    }

    fn push_group(&mut self, chain: &mut Vec<Signed>, magnitude: &Number, members: &[(ExprId, bool)]) {
        if let [(term, negative)] = *members {
            let scaled = self.scaled(magnitude, term);
            chain.push(Signed { negative: scaled.negative != negative, ..scaled });
            return;
        }
        let signed = |&(term, negative): &(ExprId, bool)| {
            let scaled = self.scaled(&Number::ONE, term);
            Signed { negative: scaled.negative != negative, ..scaled }
        };
        let terms = members.iter().map(signed).collect::<Vec<_>>();
        if magnitude.is_one() {
            chain.extend(terms);
            return;
        }
        let Signed { value, negative } = self.chain(&terms);
        let magnitude = self.builder.constant(magnitude.clone());
        chain.push(Signed { value: self.builder.multiply(magnitude, value), negative });
    }

    /// `coefficient · term`
    fn scaled(&mut self, coefficient: &Number, term: ExprId) -> Signed {
        if self.sharing.is_merged(term) {
            return self.product(coefficient, term);
        }
        let Signed { value, negative } = self.signed(term);
        if coefficient.abs().is_one() {
            return Signed { value, negative: negative != coefficient.is_negative() };
        }
        let coefficient = self.builder.constant(if negative { -coefficient } else { coefficient.clone() });
        Signed::positive(self.builder.multiply(coefficient, value))
    }

    /// The sum of the terms. Known numbers are added up and come last; if no term is positive, neither is
    /// the result.
    fn chain(&mut self, terms: &[Signed]) -> Signed {
        let (constants, mut chain): (Vec<Signed>, Vec<Signed>) =
            terms.iter().partition(|term| self.builder.op(term.value).is_constant());
        chain.extend(self.constant_term(&constants));
        let Some(first) = chain.iter().position(|term| !term.negative) else {
            chain.iter_mut().for_each(|term| term.negative = false);
            let negative = !chain.is_empty();
            return Signed { value: self.total(chain, 0), negative };
        };
        Signed::positive(self.total(chain, first))
    }

    /// The sum of known numbers as a term, unless it is zero.
    fn constant_term(&mut self, constants: &[Signed]) -> Option<Signed> {
        let zero = self.builder.constant(Number::ZERO);
        let sum = constants.iter().fold(zero, |sum, term| self.append(sum, *term));
        let opposite = self.builder.negate(sum);
        let negative = match self.builder.op(sum) {
            Op::Constant(value) => value.is_negative(),
            Op::Float(value) => value.value() < 0.0,
            _ => false,
        };
        (sum != zero).then_some(Signed { value: if negative { opposite } else { sum }, negative })
    }

    /// The first term with the others added to it, or zero if there is none.
    fn total(&mut self, mut terms: Vec<Signed>, first: usize) -> ValueId {
        if terms.is_empty() {
            return self.builder.constant(Number::ZERO);
        }
        let first = terms.remove(first).value;
        terms.into_iter().fold(first, |sum, term| self.append(sum, term))
    }

    fn append(&mut self, sum: ValueId, term: Signed) -> ValueId {
        if term.negative { self.builder.subtract(sum, term.value) } else { self.builder.add(sum, term.value) }
    }
}
