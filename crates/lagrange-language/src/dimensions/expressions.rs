//! Dimensions of expressions.

use super::calls::{call, matrix_product};
use super::checker::Checker;
use super::exponents::Exponents;
use super::kinds::TIME;
use super::measure::Measure;
use super::messages;
use super::solver::Grounds;
use crate::syntax::ast::{ArrayShape, AstId, BinaryOperator, Expression};
use lagrange_expr::units::Dimension;

impl Checker<'_> {
    /// Returns the dimension of an expression. Contradictions in it are recorded.
    pub(super) fn value(&mut self, root: AstId) -> Measure {
        let mut pending = vec![root];
        while let Some(&id) = pending.last() {
            let before = pending.len();
            if !self.values.contains(&id) {
                let operands = self.expressions.get(id).operands().into_iter().rev();
                pending.extend(operands.filter(|operand| !self.values.contains(operand)));
            }
            if pending.len() == before {
                pending.pop();
                if !self.values.contains(&id) {
                    let value = self.node(id);
                    self.values.insert(id, value);
                }
            }
        }
        self.known_value(root)
    }

    fn node(&mut self, id: AstId) -> Measure {
        let expressions = self.expressions;
        match expressions.get(id) {
            Expression::Number(number) if number.is_zero() => Measure::any(),
            Expression::Number(_) => Measure::known(Exponents::plain()),
            Expression::Quantity(_, unit) => Measure::known(unit.dimension.clone().into()),
            Expression::Name(name) => self.named(name),
            Expression::Tuple(parts) => {
                let parts = parts.iter().map(|part| self.known_value(*part)).collect::<Vec<_>>();
                let has_rates = parts.iter().any(|part| part.has_rates);
                let shapes = parts.iter().map(|part| part.shape).collect::<Vec<_>>();
                let stacked = match ArrayShape::stacked(&shapes) {
                    Some(shape) => {
                        Measure::of(shape, parts.into_iter().flat_map(|part| part.components).collect())
                    }
                    None => Measure::any(),
                };
                stacked.with_rates(has_rates)
            }
            Expression::Negate(of) => self.known_value(*of),
            Expression::Binary(operator, _, left, right) => self.binary(id, *operator, *left, *right),
            Expression::Call(function, arguments) => call(self, id, &function.text, arguments),
            Expression::Component(of, name) => {
                let value = self.known_value(*of);
                let index = ["x", "y", "z"].iter().position(|axis| *axis == name.text);
                let component =
                    index.filter(|_| !value.is_scalar()).and_then(|i| value.components.get(i).cloned());
                Measure::scalar(component.flatten()).with_rates(value.has_rates)
            }
            Expression::Entry { of, indices, .. } => {
                self.known_value(*of).entry(&expressions.places(indices).unwrap_or_default())
            }
            Expression::If { condition, then, otherwise } => {
                self.same(condition.left, condition.right, messages::COMPARED);
                self.same(*then, *otherwise, messages::CHOSEN)
            }
            Expression::Array(_) | Expression::Invalid => Measure::any(),
        }
    }

    fn named(&self, name: &str) -> Measure {
        match name {
            "t" => Measure::known(Dimension::of(TIME).into()),
            "pi" => Measure::known(Exponents::plain()),
            name => self.scope.get(&name.to_owned()).cloned().unwrap_or_else(Measure::any),
        }
    }

    fn binary(&mut self, id: AstId, operator: BinaryOperator, left: AstId, right: AstId) -> Measure {
        let (a, b) = (self.known_value(left), self.known_value(right));
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => self.same(left, right, messages::ADDED),
            BinaryOperator::Multiply if a.is_scalar() || b.is_scalar() => a.times(&b),
            BinaryOperator::Multiply => matrix_product(self, id, &a, &b),
            BinaryOperator::Divide => a.times(&b.map(|form| Exponents::plain().over(form))),
            BinaryOperator::Power => self.power(left, right),
            BinaryOperator::Remainder => Measure::any(),
        }
    }

    /// Requires an expression to have a dimension; in sums, this applies to each term.
    pub(super) fn require(&mut self, root: AstId, expected: &Measure, reason: &Grounds) -> Measure {
        let mut pending = vec![root];
        let mut all = expected.clone();
        while let Some(id) = pending.pop() {
            match self.expressions.get(id) {
                Expression::Binary(BinaryOperator::Add | BinaryOperator::Subtract, _, left, right) => {
                    pending.extend([*right, *left]);
                }
                Expression::Negate(of) => pending.push(*of),
                Expression::If { condition, then, otherwise } => {
                    self.value(condition.left);
                    self.value(condition.right);
                    self.same(condition.left, condition.right, messages::COMPARED);
                    pending.extend([*otherwise, *then]);
                }
                _ => {
                    let found = self.value(id);
                    all.has_rates |= found.has_rates;
                    self.equate_values(id, &found, expected, reason);
                }
            }
        }
        // The whole expression is assigned its expected dimension.
        if !self.values.contains(&root) {
            self.values.insert(root, all.clone());
        }
        all
    }

    pub(super) fn require_dimension(
        &mut self,
        root: AstId,
        dimension: &Dimension,
        reason: &Grounds,
    ) -> Measure {
        self.require(root, &Measure::known(dimension.clone().into()), reason)
    }
}
