//! Quotients without products of inertias.
//!
//! Eliminations expand pivots. A numerator over D is then a sum of products of two masses. It may
//! leave the range of floating-point numbers even if its quotient does not. This module divides
//! such sums term by term, so that every sum has at most the [grade](Grades) of one mass. Lowering
//! chooses the order of factors in a product, which also keeps partial products in range.

use super::monomial::Monomial;
use crate::calculus::{Grades, rebuild};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Maximum number of nested parts of a product that is split.
const MAX_FACTORS: usize = 64;
/// Maximum depth of nested quotients that are split: one level for each elimination.
const MAX_DEPTH: usize = 12;

/// Returns replacements of the parts of `roots`, where they differ. `unit` is an expression that
/// never vanishes and has the grade of a mass. Both sides of a quotient of two products of masses
/// are divided by it.
pub fn balanced(graph: &mut Graph, roots: &[ExprId], unit: Option<ExprId>) -> HashMap<ExprId, ExprId> {
    let mut grades = Grades::of(graph, roots);
    grades.extend(graph, unit.as_slice());
    let unit = unit.filter(|id| grades.grade(*id).is_one());
    let mut balance = Balance { grades, unit, divided: HashMap::default() };
    let mut image: HashMap<ExprId, ExprId> = HashMap::default();
    for id in graph.reachable(roots) {
        let image_of = |child: ExprId| image.get(&child).copied().unwrap_or(child);
        let mut is_changed = false;
        graph.node(id).for_each_child(|child| is_changed |= image.contains(&child));
        let same = if is_changed { rebuild(graph, id, image_of) } else { id };
        let found = balance.product(graph, same, MAX_DEPTH);
        if found != id {
            image.insert(id, found);
        }
    }
    image
}

struct Balance {
    grades: Grades,
    unit: Option<ExprId>,
    divided: HashMap<(ExprId, Monomial), ExprId>,
}

impl Balance {
    /// Rewrites a product, or a multiple of one, so that its sums have at most the grade of one
    /// mass, if their divisors allow this.
    fn product(&mut self, graph: &mut Graph, id: ExprId, depth: usize) -> ExprId {
        let (coefficient, core) = graph.split_coefficient(id);
        let Node::Product(factors) = graph.node(core).clone() else { return id };
        if depth == 0 {
            return id;
        }
        // A nested product may become a separate value.
        let mut is_changed = factors.iter().any(|(base, _)| {
            matches!(graph.node(*base), Node::Product(_)) && self.grade(graph, *base).abs() > Number::ONE
        });
        let Some(mut rest) = Monomial::of(graph, core, MAX_FACTORS) else { return id };
        let mut done = Monomial::default();
        while let Some((sum, exponent)) = self.largest_sum(graph, &rest) {
            let (_, others) = rest.split(|base, _| base == sum);
            let Some(divisor) = self.divisor(graph, sum, &exponent, &others) else {
                let power = Monomial::new(vec![(sum, exponent)]);
                (rest, done) = (others, done.times(&power));
                continue;
            };
            let quotient = self.quotient(graph, sum, &divisor, depth);
            let unit = if exponent.is_negative() { Number::MINUS_ONE } else { Number::ONE };
            let left = Monomial::new(vec![(sum, &exponent + &-&unit)]);
            let is_done = self.grade(graph, quotient).abs() > Number::ONE;
            let quotient = Monomial::new(vec![(quotient, unit.clone())]);
            rest = others.times(&left).times(&divisor.power(&unit));
            let place = if is_done { &mut done } else { &mut rest };
            *place = place.times(&quotient);
            is_changed = true;
        }
        if !is_changed {
            return id;
        }
        let product = rest.times(&done).build(graph);
        graph.scale(coefficient, product)
    }

    /// Returns the first sum among the factors with the grade of a product of masses.
    fn largest_sum(&mut self, graph: &Graph, factors: &Monomial) -> Option<(ExprId, Number)> {
        let mut factors = factors.factors().iter();
        factors
            .find(|(base, exponent)| {
                let is_sum = matches!(graph.node(*base), Node::Sum { .. });
                is_sum && exponent.is_integer() && self.grade(graph, *base).abs() > Number::ONE
            })
            .cloned()
    }

    /// Returns a divisor of a sum from the other factors; `None` if the quotient would still be a
    /// product of masses.
    fn divisor(
        &mut self,
        graph: &Graph,
        sum: ExprId,
        exponent: &Number,
        others: &Monomial,
    ) -> Option<Monomial> {
        let mut grade = self.grade(graph, sum);
        let mut found = Vec::new();
        for (base, power) in others.factors() {
            // The direction in which a factor changes the grade of the sum.
            let step =
                if power.is_negative() != exponent.is_negative() { Number::MINUS_ONE } else { Number::ONE };
            let own = self.grade(graph, *base);
            let change = &own * &step;
            let mut left = power.abs();
            // Parameters may be zero, but pivots are divisors anyway.
            let is_possible = !exponent.is_negative() || matches!(graph.node(*base), Node::Sum { .. });
            while is_possible
                && power.is_integer()
                && !left.is_zero()
                && grade.abs() > Number::ONE
                && (&grade + &change).abs() < grade.abs()
                && own.abs() <= Number::ONE
            {
                grade = &grade + &change;
                found.push((*base, step.clone()));
                left = &left + &Number::MINUS_ONE;
            }
        }
        if let Some(unit) = self.unit.filter(|_| self.needs_unit(graph, exponent, others)) {
            while grade > Number::ONE {
                grade = &grade + &Number::MINUS_ONE;
                found.push((unit, Number::MINUS_ONE));
            }
        }
        let divisor = Monomial::new(found).power(&Number::MINUS_ONE);
        (grade.abs() <= Number::ONE && !divisor.is_one()).then_some(divisor)
    }

    /// True if the sum has a divisor without further factors: it is divided by itself, or a product
    /// of masses is divided by it.
    fn needs_unit(&mut self, graph: &Graph, exponent: &Number, others: &Monomial) -> bool {
        let (below, _) = others.split(|_, power| power.is_negative());
        exponent.is_negative() || self.largest_sum(graph, &below).is_some()
    }

    /// Divides a sum term by term.
    fn quotient(&mut self, graph: &mut Graph, sum: ExprId, divisor: &Monomial, depth: usize) -> ExprId {
        let key = (sum, divisor.clone());
        if let Some(&known) = self.divided.get(&key) {
            return known;
        }
        let inverse = divisor.power(&Number::MINUS_ONE);
        let Node::Sum { constant, terms } = graph.node(sum).clone() else { return sum };
        let one = graph.number(1);
        let constant = (!constant.is_zero()).then_some((one, constant));
        let terms = terms.iter().cloned().chain(constant).collect::<Vec<_>>();
        let mut quotients = Vec::with_capacity(terms.len());
        for (term, coefficient) in terms {
            let factors = Monomial::of(graph, term, MAX_FACTORS);
            let factors = factors.unwrap_or_else(|| Monomial::new(vec![(term, Number::ONE)]));
            let product = factors.times(&inverse).build(graph);
            quotients.push((self.product(graph, product, depth - 1), coefficient));
        }
        let found = graph.sum(Number::ZERO, quotients);
        self.divided.insert(key, found);
        found
    }

    fn grade(&mut self, graph: &Graph, id: ExprId) -> Number {
        self.grades.extend(graph, &[id]);
        self.grades.grade(id)
    }
}
