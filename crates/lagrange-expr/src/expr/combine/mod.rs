//! The constructors of sums and products.
//!
//! Both combine a list of operands with numeric weights: coefficients in a sum, exponents in a
//! product. Equal operands are collected. A nested operand of the same kind is only expanded if a
//! term then vanishes: `(x + y) - x = y` or `(x·y)/x = y`. Otherwise it is more useful as a shared
//! part.

mod arithmetic;
mod branch;
mod magnitude;

use crate::expr::weighted::{LONGEST_OPENED, Weighted};
use crate::expr::{ExprId, Function, Graph, Node};
use crate::number::Number;

/// Maximum number of factors of a product; longer products are nested, so that their derivatives
/// stay short.
const LONGEST_PRODUCT: usize = 16;

impl Graph {
    /// Returns `constant + Σ coefficient · term`.
    ///
    /// Numbers are folded, equal terms collected, and nested sums expanded if terms cancel. A sum
    /// whose coefficients all have the same magnitude is written as that magnitude times a sum with
    /// coefficients ±1. The first coefficient of a sum is positive, so `a - b`, `b - a` and
    /// `2·a - 2·b` share one node.
    pub fn sum(&mut self, constant: Number, terms: impl IntoIterator<Item = Weighted>) -> ExprId {
        let mut constant = constant;
        let mut collected = Vec::new();
        for (term, coefficient) in terms {
            self.push_term(&mut constant, &mut collected, term, &coefficient);
        }
        self.sum_of(constant, collected)
    }

    /// Returns the sum of terms that are not numbers. This function is compiled only once for all
    /// iterator types.
    fn sum_of(&mut self, mut constant: Number, mut collected: Vec<Weighted>) -> ExprId {
        merge(&mut collected, |_, _, _| true);
        while let Some(position) = self.cancelling_sum(&constant, &collected) {
            let (nested, coefficient) = collected.swap_remove(position);
            let Node::Sum { constant: inner, terms } = self.node(nested).clone() else { break };
            constant = &constant + &(&inner * &coefficient);
            for (term, weight) in &terms {
                self.push_term(&mut constant, &mut collected, *term, &(weight * &coefficient));
            }
            merge(&mut collected, |_, _, _| true);
        }
        self.finish_sum(constant, collected)
    }

    fn push_term(
        &self,
        constant: &mut Number,
        terms: &mut Vec<Weighted>,
        term: ExprId,
        coefficient: &Number,
    ) {
        if let Some(value) = self.as_number(term) {
            *constant = &*constant + &(value * coefficient);
        } else {
            let (inner, term) = self.split_coefficient(term);
            terms.push((term, &inner * coefficient));
        }
    }

    /// Finds a nested sum with a term that cancels against the rest.
    fn cancelling_sum(&self, constant: &Number, terms: &[Weighted]) -> Option<usize> {
        let opened = |id: ExprId| match self.node(id) {
            Node::Sum { constant, terms } if terms.len() <= LONGEST_OPENED => Some((constant, &**terms)),
            _ => None,
        };
        let cancels_constant = |&(id, ref c): &Weighted| {
            opened(id).is_some_and(|(inner, _)| !inner.is_zero() && (&(inner * c) + constant).is_zero())
        };
        terms
            .iter()
            .position(cancels_constant)
            .or_else(|| vanishing(terms, |id| opened(id).map(|(_, terms)| terms)))
    }

    fn finish_sum(&mut self, constant: Number, terms: Vec<Weighted>) -> ExprId {
        match terms.as_slice() {
            [] => return self.number(constant),
            [(term, coefficient)] if constant.is_zero() => {
                let (term, coefficient) = (*term, coefficient.clone());
                return self.scaled(coefficient, term);
            }
            _ => {}
        }
        let magnitude = terms[0].1.abs();
        let uniform = terms.iter().all(|(_, c)| c.abs() == magnitude)
            && (constant.is_zero() || constant.abs() == magnitude);
        let sign = if terms[0].1.is_negative() { Number::MINUS_ONE } else { Number::ONE };
        let content = if uniform { &magnitude * &sign } else { sign };
        if content.is_one() {
            return self.intern(Node::Sum { constant, terms: terms.into() });
        }
        let inverse = content.reciprocal().unwrap_or(Number::ONE);
        let terms = terms.into_iter().map(|(term, c)| (term, &c * &inverse)).collect();
        let primitive = self.intern(Node::Sum { constant: &constant * &inverse, terms });
        self.scaled(content, primitive)
    }

    /// Returns `coefficient · term` for a term that is not a number and has no coefficient.
    fn scaled(&mut self, coefficient: Number, term: ExprId) -> ExprId {
        if coefficient.is_one() {
            return term;
        }
        self.intern(Node::Sum { constant: Number::ZERO, terms: Box::new([(term, coefficient)]) })
    }

    /// Returns `Π base ^ exponent`.
    ///
    /// Numbers are folded, equal bases collected, and nested products expanded if factors cancel.
    /// Powers of powers are combined if both sides have the same domain. `(x³)^⅓` is kept, and so
    /// is `x^½ · x^½` unless `x` is known to be nonnegative. Magnitudes only have odd powers:
    /// `(x²)^½` is `|x|` and `|x|²` is `x²`, which has a second derivative at 0.
    pub fn product(&mut self, factors: impl IntoIterator<Item = Weighted>) -> ExprId {
        let mut coefficient = Number::ONE;
        let mut collected = Vec::new();
        for (base, exponent) in factors {
            self.push_factor(&mut coefficient, &mut collected, base, exponent);
        }
        self.product_of(coefficient, collected)
    }

    /// Returns the product of factors that are not numbers. This function is compiled only once for
    /// all iterator types.
    fn product_of(&mut self, mut coefficient: Number, mut collected: Vec<Weighted>) -> ExprId {
        if coefficient.is_zero() {
            return self.number(Number::ZERO);
        }
        self.merge_factors(&mut coefficient, &mut collected);
        while let Some(replacement) =
            self.opened_product(&mut collected).or_else(|| self.opened_magnitude(&mut collected))
        {
            for (base, exponent) in replacement {
                self.push_factor(&mut coefficient, &mut collected, base, exponent);
            }
            self.merge_factors(&mut coefficient, &mut collected);
        }
        self.move_into_branch(&mut collected);
        let product = self.finish_product(collected);
        self.scale(coefficient, product)
    }

    fn push_factor(
        &self,
        coefficient: &mut Number,
        factors: &mut Vec<Weighted>,
        base: ExprId,
        exponent: Number,
    ) {
        let mut factor = (base, exponent);
        while let Some((number, rest)) = self.reduce_factor(&factor) {
            *coefficient = &*coefficient * &number;
            match rest {
                Some(rest) => factor = rest,
                None => return,
            }
        }
        factors.push(factor);
    }

    /// Splits a factor into a number and the rest, if a number can be extracted or a power
    /// flattened.
    fn reduce_factor(&self, (base, exponent): &Weighted) -> Option<(Number, Option<Weighted>)> {
        if let Some(value) = self.as_number(*base) {
            return Some((fold_power(value, exponent)?, None));
        }
        let (inner, core) = self.split_coefficient(*base);
        let number = fold_power(&inner, exponent)?;
        let rest = self.flatten_power(core, exponent.clone());
        (rest.0 != *base).then_some((number, Some(rest)))
    }

    /// Applies `(base^p)^e = base^(p·e)` if both have the same domain, and `|base|^e = base^e` for
    /// even e.
    fn flatten_power(&self, base: ExprId, exponent: Number) -> Weighted {
        if let Node::Product(factors) = self.node(base)
            && let [(inner, power)] = &**factors
            && (exponent.is_integer()
                || !(power * &exponent).is_integer() && !power.is_even()
                || self.is_nonnegative(*inner))
        {
            return (*inner, power * &exponent);
        }
        if let Node::Call(Function::Abs, arguments) = self.node(base)
            && exponent.is_even()
        {
            return (arguments[0], exponent);
        }
        (base, exponent)
    }

    /// Adds up exponents of equal bases, until no number can be extracted from a factor.
    fn merge_factors(&self, coefficient: &mut Number, factors: &mut Vec<Weighted>) {
        loop {
            merge(factors, |base, equal, total| {
                let same_domain = !total.is_integer() || equal.iter().all(|(_, e)| e.is_integer());
                same_domain || self.is_nonnegative(base)
            });
            let reducible = |factor: &Weighted| self.reduce_factor(factor).is_some();
            let Some(position) = factors.iter().position(reducible) else { return };
            let (base, exponent) = factors.swap_remove(position);
            self.push_factor(coefficient, factors, base, exponent);
        }
    }

    /// Removes a nested product with a factor that cancels against the rest; returns its factors.
    fn opened_product(&self, factors: &mut Vec<Weighted>) -> Option<Vec<Weighted>> {
        let (nested, exponent) = factors.swap_remove(self.cancelling_product(factors)?);
        let Node::Product(inner) = self.node(nested) else { return None };
        Some(inner.iter().map(|(base, power)| (*base, power * &exponent)).collect())
    }

    fn cancelling_product(&self, factors: &[Weighted]) -> Option<usize> {
        vanishing(factors, |id| match self.node(id) {
            Node::Product(inner) if inner.len() <= LONGEST_OPENED => Some(&**inner),
            _ => None,
        })
        .filter(|&position| factors[position].1.is_integer())
    }

    fn finish_product(&mut self, mut factors: Vec<Weighted>) -> ExprId {
        while factors.len() > LONGEST_PRODUCT {
            let groups = factors.chunks(LONGEST_PRODUCT).map(<[Weighted]>::to_vec).collect::<Vec<_>>();
            factors = groups.into_iter().map(|group| (self.finish_product(group), Number::ONE)).collect();
        }
        match factors.as_slice() {
            [] => self.number(Number::ONE),
            [(base, exponent)] if exponent.is_one() => *base,
            _ => self.intern(Node::Product(factors.into())),
        }
    }
}

/// Returns `value ^ exponent`, if it is a number with an exact representation.
fn fold_power(value: &Number, exponent: &Number) -> Option<Number> {
    if value.is_one() {
        return Some(Number::ONE);
    }
    match exponent.to_i32() {
        Some(integer) => value.power(integer),
        None => value.exact_sqrt()?.power((exponent * &Number::TWO).to_i32()?),
    }
}

/// Sorts by operand and adds up the weights of equal ones. Operands of weight zero are dropped.
///
/// If `adds_up` rejects a total, one half is split off: `x^¼ · x^¾` becomes `x^½ · x^½`. The result
/// thus does not depend on the order of operands.
fn merge(operands: &mut Vec<Weighted>, adds_up: impl Fn(ExprId, &[Weighted], &Number) -> bool) {
    operands.sort_unstable_by(|(a, m), (b, n)| (a, m).cmp(&(b, n)));
    let mut merged: Vec<Weighted> = Vec::with_capacity(operands.len());
    for equal in operands.chunk_by(|a, b| a.0 == b.0) {
        let operand = equal[0].0;
        let total = equal[1..].iter().fold(equal[0].1.clone(), |total, (_, weight)| &total + weight);
        if equal.len() > 1 && !adds_up(operand, equal, &total) {
            let mut pair = [(operand, Number::HALF), (operand, &total - &Number::HALF)];
            pair.sort_unstable();
            merged.extend(pair);
        } else if !total.is_zero() {
            merged.push((operand, total));
        }
    }
    *operands = merged;
}

/// Returns the position of an operand whose `parts` include one with total weight zero when all
/// operands with parts are expanded.
fn vanishing<'a>(
    operands: &'a [Weighted],
    parts: impl Fn(ExprId) -> Option<&'a [Weighted]>,
) -> Option<usize> {
    if !operands.iter().any(|(id, _)| parts(*id).is_some()) {
        return None;
    }
    let mut opened: Vec<(ExprId, Number, Option<usize>)> = Vec::new();
    for (position, (id, weight)) in operands.iter().enumerate() {
        match parts(*id) {
            Some(inner) => {
                opened.extend(inner.iter().map(|(part, w)| (*part, w * weight, Some(position))));
            }
            None => opened.push((*id, weight.clone(), None)),
        }
        // A part may itself be an operand with parts, next to the operand that contains it.
        if parts(*id).is_some() {
            opened.push((*id, weight.clone(), None));
        }
    }
    opened.sort_unstable_by_key(|(id, _, position)| (*id, *position));
    opened.chunk_by(|a, b| a.0 == b.0).find_map(|same| {
        let total = same.iter().fold(Number::ZERO, |total, (_, weight, _)| &total + weight);
        if same.len() > 1 && total.is_zero() {
            same.iter().find_map(|(_, _, position)| *position)
        } else {
            None
        }
    })
}
