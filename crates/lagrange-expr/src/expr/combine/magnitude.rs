//! Powers of magnitudes in products: |x|, √x², hypot, and the slope of |x|.
//!
//! Even powers of a magnitude are polynomials: |x|² = x², (√x²)⁴ = x⁴, hypot(x, y)² = x² + y². In
//! terms of the magnitude, they would have the wrong second derivative where it vanishes, because
//! the sign of zero is zero. The general remainder f(|x|) is differentiated by
//! [`Function::MagnitudeSlope`], s = d|x|/dx, whose square is one: f″ s² is f″ at zero, too.

use std::collections::BinaryHeap;

use crate::collections::HashMap;
use crate::expr::weighted::{LONGEST_OPENED, Weighted};
use crate::expr::{ExprId, Function, Graph, Node};
use crate::number::Number;

impl Graph {
    /// Returns every x for which the slope of |x| is a factor of the expression with an odd
    /// exponent.
    pub(in crate::expr) fn slope_factors(&self, id: ExprId) -> &[ExprId] {
        &self.facts[id.index()].slopes
    }

    fn has_slope_factor(&self, id: ExprId, of: ExprId) -> bool {
        self.slope_factors(id).contains(&of)
    }

    /// Removes factors that are equivalent to magnitudes; returns their replacements.
    pub(in crate::expr) fn opened_magnitude(&mut self, factors: &mut Vec<Weighted>) -> Option<Vec<Weighted>> {
        self.opened_root(factors)
            .or_else(|| self.opened_power(factors))
            .or_else(|| self.opened_hypotenuse(factors))
            .or_else(|| self.paired_slopes(factors))
    }

    /// Applies (c Π xᵖ)ᵉ = cᵉ Π |x|ᵖᵉ for even p and positive c.
    fn opened_root(&mut self, factors: &mut Vec<Weighted>) -> Option<Vec<Weighted>> {
        let is_root_of_even = |(base, exponent): &Weighted| {
            if exponent.is_integer() {
                return false;
            }
            let (coefficient, core) = self.split_coefficient(*base);
            let Node::Product(inner) = self.node(core) else { return false };
            !coefficient.is_negative() && inner.iter().all(|(_, power)| power.is_even())
        };
        let (base, exponent) = factors.swap_remove(factors.iter().position(is_root_of_even)?);
        let (coefficient, core) = self.split_coefficient(base);
        let Node::Product(inner) = self.node(core).clone() else { return None };
        let mut opened = vec![(self.number(coefficient), exponent.clone())];
        for (base, power) in &inner {
            opened.push((self.magnitude(*base), power * &exponent));
        }
        Some(opened)
    }

    /// Applies (Π b)ᵉ = Π bᵉ if this removes a root of a nonnegative expression, a hypotenuse or a
    /// division.
    fn opened_power(&mut self, factors: &mut Vec<Weighted>) -> Option<Vec<Weighted>> {
        let hides_root = |(base, exponent): &Weighted| {
            let Node::Product(inner) = self.node(*base) else { return false };
            let vanishes = |(part, power): &Weighted| match self.node(*part) {
                Node::Call(Function::Hypot, _) => (power * exponent).is_even(),
                _ if power.is_negative() => exponent.is_negative(),
                _ => {
                    let is_root = !power.is_integer() && self.is_nonnegative(*part);
                    is_root && (power * exponent).is_integer()
                }
            };
            exponent.is_integer() && !exponent.is_one() && inner.iter().any(vanishes)
        };
        let (base, exponent) = factors.swap_remove(factors.iter().position(hides_root)?);
        let Node::Product(inner) = self.node(base) else { return None };
        Some(inner.iter().map(|(part, power)| (*part, power * &exponent)).collect())
    }

    /// Returns |x|, factor by factor: |−2 k (2 x + 4 y) z²| = 4 |k| |x + 2 y| z². Every magnitude
    /// of x is therefore the same expression.
    pub fn magnitude(&mut self, id: ExprId) -> ExprId {
        if self.is_nonnegative(id) {
            return id;
        }
        if let Some(value) = self.as_number(id) {
            let value = value.abs();
            return self.number(value);
        }
        let (coefficient, core) = self.split_coefficient(id);
        let mut parts = vec![(self.number(coefficient.abs()), Number::ONE)];
        for (base, power) in self.whole_powers(core, usize::MAX) {
            if !power.is_odd() || self.is_nonnegative(base) {
                parts.push((base, power));
                continue;
            }
            let (content, primitive) = self.primitive(base);
            let magnitude = match primitive == base && self.is_without_coefficient(base) {
                true => self.call(Function::Abs, &[base]),
                false => self.magnitude(primitive),
            };
            parts.extend([(self.number(content.abs()), power.clone()), (magnitude, power)]);
        }
        self.product(parts)
    }

    fn is_without_coefficient(&self, id: ExprId) -> bool {
        self.as_number(id).is_none() && self.split_coefficient(id).1 == id
    }

    /// Returns a sum whose first coefficient is positive. Its coefficients, if they are integers,
    /// have no common divisor: −2 x + 4 y = −2 (x − 2 y). Other coefficients keep their magnitudes.
    fn primitive(&mut self, id: ExprId) -> (Number, ExprId) {
        let Node::Sum { constant, terms } = self.node(id).clone() else { return (Number::ONE, id) };
        let Some((_, first)) = terms.first() else { return (Number::ONE, id) };
        let sign = if first.is_negative() { Number::MINUS_ONE } else { Number::ONE };
        let weights = || terms.iter().map(|(_, weight)| weight).chain([&constant]);
        let common = match weights().all(Number::is_integer) {
            true => weights().fold(first.clone(), |common, weight| common.common_divisor(weight)),
            false => sign,
        };
        let Some(inverse) = common.reciprocal() else { return (Number::ONE, id) };
        let terms = terms.iter().map(|(term, weight)| (*term, weight * &inverse)).collect::<Vec<_>>();
        (common, self.sum(&constant * &inverse, terms))
    }

    /// Applies hypot(a, b)ᵉ = (a² + b²)^(e/2) for even e.
    fn opened_hypotenuse(&mut self, factors: &mut Vec<Weighted>) -> Option<Vec<Weighted>> {
        let is_even_power = |(base, exponent): &Weighted| {
            exponent.is_even() && matches!(self.node(*base), Node::Call(Function::Hypot, _))
        };
        let (base, exponent) = factors.swap_remove(factors.iter().position(is_even_power)?);
        let Node::Call(_, sides) = self.node(base).clone() else { return None };
        let squares = [self.square(sides[0]), self.square(sides[1])];
        Some(vec![(self.total(squares), exponent * Number::HALF)])
    }

    /// True if an odd power of `of` is a factor.
    pub(in crate::expr) fn has_odd_power(&self, id: ExprId, of: ExprId) -> bool {
        self.whole_powers(id, LONGEST_OPENED).iter().any(|(base, exponent)| *base == of && exponent.is_odd())
    }

    /// True if the slope of |x| itself is a factor with an odd exponent, without an odd power of x.
    pub(in crate::expr) fn has_bare_slope(&self, id: ExprId, of: ExprId) -> bool {
        let is_slope = |base: ExprId| match self.node(base) {
            Node::Call(Function::MagnitudeSlope, arguments) => arguments[0] == of,
            _ => false,
        };
        let factors = self.whole_powers(id, LONGEST_OPENED);
        factors.iter().any(|(base, exponent)| is_slope(*base) && exponent.is_odd())
            && !self.has_odd_power(id, of)
    }

    /// Returns the factors of an expression and of nested products, without its coefficient.
    /// Products are expanded as long as there are fewer factors than `longest`.
    ///
    /// Factors have smaller identifiers than their product. The greatest is therefore expanded
    /// first, after all its occurrences have been found: a product in many others is expanded only
    /// once.
    fn whole_powers(&self, id: ExprId, longest: usize) -> Vec<Weighted> {
        let (mut found, mut pending) = (Vec::new(), BinaryHeap::new());
        pending.push((self.split_coefficient(id).1, Number::ONE));
        while let Some((base, mut exponent)) = pending.pop() {
            while exponent.is_integer()
                && let Some((_, other)) = pending.peek().filter(|(same, _)| *same == base)
                && other.is_integer()
            {
                exponent = &exponent + other;
                pending.pop();
            }
            match self.node(base) {
                Node::Product(inner) if exponent.is_integer() && pending.len() + found.len() < longest => {
                    pending.extend(inner.iter().map(|(part, power)| (*part, power * &exponent)));
                }
                _ if exponent.is_zero() => {}
                _ => found.push((base, exponent)),
            }
        }
        found
    }

    /// Removes slopes of |x| that occur in several factors, or in a factor with an even exponent:
    /// s² = 1.
    fn paired_slopes(&mut self, factors: &mut Vec<Weighted>) -> Option<Vec<Weighted>> {
        let mut odd: Vec<ExprId> = Vec::new();
        let whole = factors.iter().filter(|(_, exponent)| exponent.is_integer());
        let paired = whole.filter_map(|(base, exponent)| {
            let slopes = self.slope_factors(*base);
            let paired = slopes.iter().find(|of| exponent.is_even() || odd.contains(of));
            odd.extend(slopes);
            paired.copied()
        });
        let of = paired.collect::<Vec<_>>().first().copied()?;
        let has_slope =
            |(base, exponent): &Weighted| exponent.is_integer() && self.has_slope_factor(*base, of);
        let (with, without) = factors.drain(..).partition::<Vec<_>, _>(has_slope);
        *factors = without;
        let count = with.iter().filter(|(_, exponent)| exponent.is_odd()).count();
        let mut replacement = Vec::with_capacity(with.len() + 1);
        for (base, exponent) in with {
            let rest = self.without_slope(base, of);
            // Expanded, so that equal factors are combined.
            match self.node(rest) {
                Node::Product(_) => {
                    let inner = self.whole_powers(rest, LONGEST_OPENED).into_iter();
                    replacement.extend(inner.map(|(part, power)| (part, &power * &exponent)));
                }
                _ => replacement.push((rest, exponent)),
            }
        }
        if count % 2 == 1 {
            replacement.push((self.call(Function::MagnitudeSlope, &[of]), Number::ONE));
        }
        Some(replacement)
    }

    /// Divides an expression by the slope of |x|, which is one of its factors.
    fn without_slope(&mut self, root: ExprId, of: ExprId) -> ExprId {
        let mut image: HashMap<ExprId, ExprId> = HashMap::default();
        for id in self.reachable_until(&[root], |id| !self.has_slope_factor(id, of)) {
            if self.has_slope_factor(id, of) {
                let quotient = self.node_without_slope(id, of, &image);
                image.insert(id, quotient);
            }
        }
        image.get(&root).copied().unwrap_or(root)
    }

    fn node_without_slope(&mut self, id: ExprId, of: ExprId, image: &HashMap<ExprId, ExprId>) -> ExprId {
        match self.node(id).clone() {
            Node::Product(mut factors) => {
                let has_slope = |(base, exponent): &&mut Weighted| exponent.is_odd() && image.contains(base);
                if let Some((base, _)) = factors.iter_mut().find(has_slope) {
                    *base = image.get(base).copied().unwrap_or(*base);
                }
                self.product(factors)
            }
            Node::Sum { terms, .. } => {
                let mut divided = Vec::with_capacity(terms.len());
                for (term, coefficient) in terms {
                    let term = image.get(&term).copied().unwrap_or_else(|| self.with_magnitude(term, of));
                    divided.push((term, coefficient));
                }
                self.sum(Number::ZERO, divided)
            }
            Node::Call(Function::Abs, _) => of,
            _ => self.number(1),
        }
    }

    /// Replaces a factor x of a product by |x|.
    fn with_magnitude(&mut self, term: ExprId, of: ExprId) -> ExprId {
        let mut factors = self.whole_powers(term, LONGEST_OPENED);
        factors.extend([(of, Number::MINUS_ONE), (self.magnitude(of), Number::ONE)]);
        self.product(factors)
    }
}
