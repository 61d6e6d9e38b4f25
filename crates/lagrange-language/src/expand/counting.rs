//! Evaluation of indices.

use super::messages;
use super::scopes::{Meaning, ScopeId, Scopes};
use crate::syntax::ast::{
    ArrayExpression, AstId, BinaryOperator, CombinedCondition, Condition, Expression, Expressions, TestKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::number::Number;

/// The data needed to evaluate indices.
#[derive(Clone, Copy)]
pub(super) struct Counting<'a> {
    pub(super) expressions: &'a Expressions,
    pub(super) scopes: &'a Scopes,
    /// Values of constants and of elements of constant arrays.
    pub(super) constants: &'a HashMap<String, Number>,
}

/// Reason why an expression is not a valid index, and its place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct IndexFault {
    pub(super) place: AstId,
    pub(super) reason: Reason,
}

/// The error in an index.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Reason {
    /// An error that has already been reported.
    Unreadable,
    /// A name that is neither a constant nor a variable of a loop.
    Name(String),
    /// A call, a vector or something else that is invalid in indices.
    Form,
    NoInteger(Number),
    DivisionByZero,
    TooLarge,
}

impl Counting<'_> {
    /// Returns the exact value.
    pub(super) fn number(self, root: AstId, scope: ScopeId) -> Result<Number, IndexFault> {
        let mut values: HashMap<AstId, Number> = HashMap::default();
        for id in self.expressions.parts(root) {
            let value = self.value(id, scope, &values).map_err(|reason| IndexFault { place: id, reason })?;
            values.insert(id, value);
        }
        let fault = IndexFault { place: root, reason: Reason::Unreadable };
        values.remove(&root).ok_or(fault)
    }

    /// Returns the value, if it is an integer.
    pub(super) fn integer(self, root: AstId, scope: ScopeId) -> Result<i64, IndexFault> {
        let number = self.number(root, scope)?;
        let fault = |reason| IndexFault { place: root, reason };
        match number.to_integer() {
            Some(integer) => Ok(integer),
            None if number.is_integer() => Err(fault(Reason::TooLarge)),
            None => Err(fault(Reason::NoInteger(number))),
        }
    }

    /// Returns the value of a condition.
    pub(super) fn holds(self, condition: &CombinedCondition, scope: ScopeId) -> Result<bool, IndexFault> {
        for tests in &condition.alternatives {
            let mut all = true;
            for test in tests {
                let holds = match &test.kind {
                    TestKind::Comparison(left, comparison, right) => {
                        let (left, right) = (self.number(*left, scope)?, self.number(*right, scope)?);
                        comparison.holds(left.cmp(&right))
                    }
                    TestKind::Nested(condition) => self.holds(condition, scope)?,
                };
                all = holds != test.is_negated;
                if !all {
                    break;
                }
            }
            if all {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Returns the value of a condition on variables and other known numbers; `None` for one on the
    /// motion.
    pub(super) fn decided(self, condition: &Condition, scope: ScopeId) -> Option<bool> {
        let sides = [condition.left, condition.right];
        let is_variable = |id: &AstId| match self.expressions.get(*id) {
            Expression::Name(name) => matches!(self.scopes.find(scope, name), Some(Some(_))),
            _ => false,
        };
        if !sides.iter().any(|side| self.expressions.parts(*side).iter().any(is_variable)) {
            return None;
        }
        let [left, right] = sides.map(|side| self.number(side, scope).ok());
        Some(condition.relation.holds(left?.cmp(&right?)))
    }

    fn value(self, id: AstId, scope: ScopeId, values: &HashMap<AstId, Number>) -> Result<Number, Reason> {
        let of = |operand: &AstId| values.get(operand).ok_or(Reason::Unreadable);
        let value = match self.expressions.get(id) {
            Expression::Number(number) => number.clone(),
            Expression::Name(name) => self.named(name, scope)?,
            Expression::Negate(operand) => -of(operand)?,
            Expression::Binary(operator, _, left, right) => applied(*operator, of(left)?, of(right)?)?,
            Expression::Array(ArrayExpression::Element(name)) => {
                let indices = name.indices.iter().map(|index| of(index)?.to_integer().ok_or(Reason::Form));
                let indices = indices.collect::<Result<Vec<_>, _>>()?;
                let array = self.array(&name.text, scope).ok_or(Reason::Name(name.text.clone()))?;
                let element = messages::element(&array, &indices);
                self.constants.get(&element).cloned().ok_or(Reason::Name(name.text.clone()))?
            }
            Expression::Invalid => return Err(Reason::Unreadable),
            Expression::Array(_)
            | Expression::Quantity(..)
            | Expression::Tuple(_)
            | Expression::Call(..)
            | Expression::Component(..)
            | Expression::Entry { .. }
            | Expression::If { .. } => return Err(Reason::Form),
        };
        if value.is_short() { Ok(value) } else { Err(Reason::TooLarge) }
    }

    fn named(self, name: &str, scope: ScopeId) -> Result<Number, Reason> {
        match self.scopes.meaning(scope, name) {
            Meaning::Value(value) => Some(Number::from(value)),
            Meaning::Declared(text) => self.constants.get(&text).cloned(),
            Meaning::Argument(..) => self.scopes.number(scope, name).cloned(),
            Meaning::Hidden | Meaning::Placed | Meaning::Outside => None,
        }
        .ok_or_else(|| Reason::Name(name.to_owned()))
    }

    /// Returns the name of an array in the expanded declaration, also if an argument refers to it.
    fn array(self, name: &str, scope: ScopeId) -> Option<String> {
        let (mut name, mut scope) = (name.to_owned(), scope);
        loop {
            match self.scopes.meaning(scope, &name) {
                Meaning::Declared(text) => return Some(text),
                Meaning::Argument(value, outer) => match self.expressions.get(value) {
                    Expression::Name(other) => (name, scope) = (other.clone(), outer),
                    _ => return None,
                },
                Meaning::Value(_) | Meaning::Hidden | Meaning::Placed | Meaning::Outside => return None,
            }
        }
    }
}

fn applied(operator: BinaryOperator, left: &Number, right: &Number) -> Result<Number, Reason> {
    match operator {
        BinaryOperator::Add => Ok(left + right),
        BinaryOperator::Subtract => Ok(left - right),
        BinaryOperator::Multiply => Ok(left * right),
        BinaryOperator::Divide => Ok(left * &right.reciprocal().ok_or(Reason::DivisionByZero)?),
        BinaryOperator::Power => {
            right.to_i32().and_then(|exponent| left.power(exponent)).ok_or(Reason::TooLarge)
        }
        BinaryOperator::Remainder => {
            let integer = |number: &Number| number.to_integer().ok_or(Reason::NoInteger(number.clone()));
            let remainder = integer(left)?.checked_rem_euclid(integer(right)?);
            remainder.map(Number::from).ok_or(Reason::DivisionByZero)
        }
    }
}
