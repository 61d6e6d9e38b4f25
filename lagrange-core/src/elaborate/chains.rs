//! Chains of `+` and `-` and of `*` and `/`, each of which becomes one n-ary node.

use super::expression::{Evaluator, rebuild};
use super::messages;
use super::operand::Operand;
use crate::expr::ExprId;
use crate::number::Number;
use crate::syntax::ast::{AstId, BinaryOperator, Expression};

/// A leaf of a chain, negated in a sum or divided by in a product.
pub(super) struct Link {
    pub(super) operand: AstId,
    inverted: bool,
}

impl Evaluator<'_> {
    /// The leaves of a chain of sums or of products, in source order.
    pub(super) fn chain(&self, root: AstId) -> Vec<Link> {
        let additive = match self.syntax(root) {
            Expression::Binary(operator, ..) => is_additive(*operator),
            _ => true,
        };
        let mut leaves = Vec::new();
        let mut pending = vec![Link { operand: root, inverted: false }];
        while let Some(Link { operand, inverted }) = pending.pop() {
            match self.syntax(operand) {
                Expression::Negate(inner) if additive => {
                    pending.push(Link { operand: *inner, inverted: !inverted });
                }
                Expression::Binary(operator, _, left, right)
                    if *operator != BinaryOperator::Power && is_additive(*operator) == additive =>
                {
                    let flips = matches!(operator, BinaryOperator::Subtract | BinaryOperator::Divide);
                    pending.push(Link { operand: *right, inverted: inverted != flips });
                    pending.push(Link { operand: *left, inverted });
                }
                _ => leaves.push(Link { operand, inverted }),
            }
        }
        leaves
    }

    pub(super) fn evaluate_sum(&mut self, id: AstId) -> Option<Operand> {
        let links = self.chain(id);
        let first = self.first_value(&links)?;
        let mut terms: Vec<Vec<(ExprId, Number)>> = vec![Vec::new(); first.components().len()];
        let mut sound = true;
        for link in &links {
            let Some(value) = self.value(link.operand) else {
                sound = false;
                continue;
            };
            if !value.same_kind(&first) {
                let message = messages::kinds_differ("add", &first.kind(), &value.kind());
                let help = messages::KINDS_HELP;
                self.report.error(self.origin(link.operand), message).help(help);
                sound = false;
                continue;
            }
            let sign = if link.inverted { Number::MINUS_ONE } else { Number::ONE };
            for (terms, &component) in terms.iter_mut().zip(value.components()) {
                terms.push((component, sign.clone()));
            }
        }
        let sums = terms.into_iter().map(|terms| self.graph.sum(Number::ZERO, terms)).collect::<Vec<_>>();
        sound.then(|| rebuild(&first, sums))
    }

    fn first_value(&self, links: &[Link]) -> Option<Operand> {
        links.iter().find_map(|link| self.value(link.operand))
    }

    pub(super) fn evaluate_product(&mut self, id: AstId) -> Option<Operand> {
        let mut factors = Vec::new();
        let mut vector: Option<Operand> = None;
        let mut sound = true;
        for Link { operand, inverted } in self.chain(id) {
            match (self.value(operand), inverted) {
                (None, _) => sound = false,
                (Some(Operand::Scalar(divisor)), true) if self.graph.is_zero(divisor) => {
                    let error = self.report.error(self.origin(operand), messages::DIVISION_BY_ZERO);
                    error.help(messages::DIVISION_HELP);
                    sound = false;
                }
                (Some(Operand::Scalar(factor)), _) => {
                    factors.push((factor, if inverted { Number::MINUS_ONE } else { Number::ONE }));
                }
                (Some(_), true) => {
                    let error = self.report.error(self.origin(operand), messages::DIVISION_BY_VECTOR);
                    error.help(messages::HOW_TO_GET_A_SCALAR);
                    sound = false;
                }
                (Some(_), false) if vector.is_some() => {
                    let error = self.report.error(self.origin(operand), messages::PRODUCT_OF_VECTORS);
                    error.help(messages::INNER_OR_CROSS);
                    sound = false;
                }
                (Some(value), false) => vector = Some(value),
            }
        }
        if !sound {
            return None;
        }
        let product = self.graph.product(factors);
        Some(match vector {
            None => Operand::Scalar(product),
            Some(vector) => vector.map(|component| self.graph.multiply(product, component)),
        })
    }
}

fn is_additive(operator: BinaryOperator) -> bool {
    matches!(operator, BinaryOperator::Add | BinaryOperator::Subtract)
}
