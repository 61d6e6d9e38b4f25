//! Expressions with a separate value, and shared reciprocals.

use crate::program::Labels;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Uses of expressions, counted before any is lowered.
#[derive(Default)]
pub(super) struct Sharing {
    merged: HashMap<ExprId, Host>,
    /// Number of products that contain a square or a higher power of an expression.
    squares: HashMap<ExprId, usize>,
    reciprocals: HashMap<Reciprocal, usize>,
}

/// Kind of node into which an expression with a single use is merged.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Host {
    Sum,
    Product,
}

/// `1 / base`, or `1 / √base`.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Reciprocal {
    pub(super) base: ExprId,
    pub(super) of_root: bool,
}

impl Sharing {
    /// Counts the uses of expressions; `reachable` contains all parts of `outputs`.
    pub(super) fn of(graph: &Graph, reachable: &[ExprId], outputs: &[ExprId], labels: &Labels) -> Sharing {
        let mut uses: HashMap<ExprId, usize> = HashMap::default();
        let mut count = |id| *uses.get_or_insert_with(id, || 0) += 1;
        outputs.iter().copied().for_each(&mut count);
        reachable.iter().for_each(|&id| graph.node(id).for_each_child(&mut count));
        let alone = |id: ExprId| uses.get(&id) == Some(&1) && labels.get(id).is_none();
        let mut sharing = Sharing::default();
        reachable.iter().for_each(|&id| sharing.merge_children(graph, id, alone));
        let is_whole = |id: &&ExprId| matches!(graph.node(**id), Node::Product(_));
        let whole = reachable.iter().filter(is_whole).copied();
        let whole = whole.filter(|id| sharing.merged.get(id) != Some(&Host::Product)).collect::<Vec<_>>();
        whole.iter().for_each(|&id| sharing.count_squares(graph, id));
        whole.iter().for_each(|&id| sharing.count_reciprocals(graph, id));
        sharing
    }

    /// Merges children: a sum absorbs products with any coefficient, and other sums only without
    /// expanding them.
    fn merge_children(&mut self, graph: &Graph, id: ExprId, alone: impl Fn(ExprId) -> bool) {
        let is_product = |child| matches!(graph.node(child), Node::Product(_));
        let is_sum = |child| matches!(graph.node(child), Node::Sum { .. });
        match graph.node(id) {
            Node::Sum { terms, .. } => {
                for (child, coefficient) in terms.iter().filter(|(child, _)| alone(*child)) {
                    if is_product(*child) || is_sum(*child) && is_sign(coefficient) {
                        self.merged.insert(*child, Host::Sum);
                    }
                }
            }
            Node::Product(factors) => {
                for (child, exponent) in factors.iter().filter(|(child, _)| alone(*child)) {
                    if is_product(*child) && is_sign(exponent) {
                        self.merged.insert(*child, Host::Product);
                    }
                }
            }
            _ => {}
        }
    }

    fn count_squares(&mut self, graph: &Graph, id: ExprId) {
        let mut total: OrderedMap<ExprId, Number> = OrderedMap::default();
        for (base, exponent) in self.flat_factors(graph, id) {
            let total = total.get_or_insert_with(base, || Number::ZERO);
            *total = &*total + &exponent;
        }
        for (&base, _) in total.iter().filter(|(_, exponent)| **exponent >= Number::TWO) {
            *self.squares.get_or_insert_with(base, || 0) += 1;
        }
    }

    fn count_reciprocals(&mut self, graph: &Graph, id: ExprId) {
        for (base, exponent) in self.factors(graph, id) {
            if exponent.is_negative() {
                let of_root = !exponent.is_integer();
                *self.reciprocals.get_or_insert_with(Reciprocal { base, of_root }, || 0) += 1;
            }
        }
    }

    /// True if an expression has no separate value.
    pub(super) fn is_merged(&self, id: ExprId) -> bool {
        self.merged.contains(&id)
    }

    /// True if several products have this divisor. One division and several multiplications are
    /// then cheaper than several divisions.
    pub(super) fn shares_reciprocal(&self, reciprocal: Reciprocal) -> bool {
        self.reciprocals.get(&reciprocal).is_some_and(|&count| count > 1)
    }

    /// Returns the factors of a product and of the products merged into it, in their order. Factors
    /// whose square is also needed elsewhere are grouped.
    pub(super) fn factors(&self, graph: &Graph, product: ExprId) -> Vec<(ExprId, Number)> {
        let mut factors: Vec<(ExprId, Number)> = Vec::new();
        for (base, exponent) in self.flat_factors(graph, product) {
            let is_shared = exponent.is_one() && self.squares.get(&base).is_some_and(|&count| count > 1);
            let same =
                |(known, power): &&mut (ExprId, Number)| is_shared && *known == base && power.is_integer();
            match factors.iter_mut().find(same) {
                Some((_, power)) => *power = &*power + &exponent,
                None => factors.push((base, exponent)),
            }
        }
        factors.retain(|(_, exponent)| !exponent.is_zero());
        factors
    }

    fn flat_factors(&self, graph: &Graph, product: ExprId) -> Vec<(ExprId, Number)> {
        let mut pending = vec![(product, Number::ONE)];
        let mut found = Vec::new();
        while let Some((base, exponent)) = pending.pop() {
            match graph.node(base) {
                Node::Product(factors) if base == product || self.merged.contains(&base) => {
                    pending.extend(factors.iter().rev().map(|(inner, power)| (*inner, power * &exponent)));
                }
                _ => found.push((base, exponent)),
            }
        }
        found
    }

    /// Returns the constant and the terms of a sum and of the sums merged into it, in their order.
    pub(super) fn terms(
        &self,
        graph: &Graph,
        constant: &Number,
        terms: &[(ExprId, Number)],
    ) -> (Number, Vec<(ExprId, Number)>) {
        let mut constant = constant.clone();
        let mut pending = terms.iter().rev().cloned().collect::<Vec<_>>();
        let mut found = Vec::new();
        while let Some((term, coefficient)) = pending.pop() {
            match graph.node(term) {
                Node::Sum { constant: inner, terms } if self.merged.contains(&term) => {
                    constant = &constant + &(inner * &coefficient);
                    pending.extend(terms.iter().rev().map(|(inner, c)| (*inner, c * &coefficient)));
                }
                _ => found.push((term, coefficient)),
            }
        }
        (constant, found)
    }
}

fn is_sign(number: &Number) -> bool {
    number.abs().is_one()
}
