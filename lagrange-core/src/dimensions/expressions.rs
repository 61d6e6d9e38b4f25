//! Dimensions of expressions.

use super::calls::call;
use super::form::Form;
use super::messages;
use super::solver::{Equation, Reason, Solver};
use super::value::Value;
use crate::collections::HashMap;
use crate::number::Number;
use crate::syntax::ast::{AstId, BinaryOperator, Expression, Expressions};
use crate::units::Dimension;

/// What is known of names and expressions.
pub(super) struct Checker<'a> {
    pub(super) expressions: &'a Expressions,
    pub(super) scope: HashMap<String, Value>,
    /// Functions of the crate and tables: dimensions of arguments, then that of the value.
    pub(super) callables: HashMap<String, Vec<Form>>,
    /// Constants that are rational numbers.
    pub(super) constants: HashMap<String, Number>,
    values: HashMap<AstId, Value>,
    pub(super) solver: Solver,
    /// Arguments of trigonometric functions that look like degrees.
    pub(super) degrees: Vec<AstId>,
}

impl<'a> Checker<'a> {
    pub(super) fn new(expressions: &'a Expressions) -> Checker<'a> {
        Checker {
            expressions,
            scope: HashMap::default(),
            callables: HashMap::default(),
            constants: HashMap::default(),
            values: HashMap::default(),
            solver: Solver::default(),
            degrees: Vec::new(),
        }
    }

    /// The dimension of an expression. What is wrong in it is remembered.
    pub(super) fn value(&mut self, root: AstId) -> Value {
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

    /// The dimension of an expression that has one already.
    pub(super) fn known_value(&self, id: AstId) -> Value {
        self.values.get(&id).cloned().unwrap_or_else(Value::any)
    }

    fn node(&mut self, id: AstId) -> Value {
        let expressions = self.expressions;
        match expressions.get(id) {
            Expression::Number(number) if number.is_zero() => Value::any(),
            Expression::Number(_) => Value::known(Form::plain()),
            Expression::Quantity(_, unit) => Value::known(unit.dimension.clone().into()),
            Expression::Name(name) => self.named(name),
            Expression::Tuple(parts) => {
                let parts = parts.iter().map(|part| self.known_value(*part)).collect::<Vec<_>>();
                let has_rates = parts.iter().any(|part| part.has_rates);
                Value::vector(parts.iter().map(Value::form).collect()).with_rates(has_rates)
            }
            Expression::Negate(of) => self.known_value(*of),
            Expression::Binary(operator, _, left, right) => self.binary(*operator, *left, *right),
            Expression::Call(function, arguments) => call(self, id, &function.text, arguments),
            Expression::Component(of, name) => {
                let value = self.known_value(*of);
                let index = ["x", "y", "z"].iter().position(|axis| *axis == name.text);
                let component =
                    index.filter(|_| value.is_vector).and_then(|i| value.components.get(i).cloned());
                Value::scalar(component.flatten()).with_rates(value.has_rates)
            }
            Expression::If { condition, then, otherwise } => {
                self.same(condition.left, condition.right, messages::COMPARED);
                self.same(*then, *otherwise, messages::CHOSEN)
            }
            Expression::Array(_) | Expression::Invalid => Value::any(),
        }
    }

    fn named(&self, name: &str) -> Value {
        match name {
            "t" => Value::known(Dimension::of([0, 0, 1, 0, 0, 0, 0]).into()),
            "pi" => Value::known(Form::plain()),
            name => self.scope.get(&name.to_owned()).cloned().unwrap_or_else(Value::any),
        }
    }

    fn binary(&mut self, operator: BinaryOperator, left: AstId, right: AstId) -> Value {
        let (a, b) = (self.known_value(left), self.known_value(right));
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => self.same(left, right, messages::ADDED),
            BinaryOperator::Multiply => a.times(&b),
            BinaryOperator::Divide => a.times(&b.map(|form| Form::plain().over(form))),
            BinaryOperator::Power => self.power(left, right),
            BinaryOperator::Remainder => Value::any(),
        }
    }

    /// A power. Where the exponent may change, nothing but plain numbers has one.
    pub(super) fn power(&mut self, base: AstId, exponent: AstId) -> Value {
        let value = self.known_value(base);
        if let Some(exponent) = self.number(exponent) {
            return value.map(|form| form.power(&exponent));
        }
        self.expect_plain(exponent, messages::EXPONENT);
        self.expect_plain(base, messages::BASE);
        Value::known(Form::plain()).with_rates(value.has_rates)
    }

    /// The rational number that an expression is.
    fn number(&self, root: AstId) -> Option<Number> {
        let mut numbers: HashMap<AstId, Number> = HashMap::default();
        for id in self.expressions.parts(root) {
            let of = |operand: &AstId| numbers.get(operand);
            let number = match self.expressions.get(id) {
                Expression::Number(number) => number.clone(),
                Expression::Name(name) => self.constants.get(name)?.clone(),
                Expression::Negate(operand) => -of(operand)?,
                Expression::Binary(operator, _, left, right) => {
                    let (left, right) = (of(left)?, of(right)?);
                    match operator {
                        BinaryOperator::Add => left + right,
                        BinaryOperator::Subtract => left - right,
                        BinaryOperator::Multiply => left * right,
                        BinaryOperator::Divide => left * &right.reciprocal()?,
                        _ => return None,
                    }
                }
                _ => return None,
            };
            numbers.insert(id, number);
        }
        numbers.get(&root).cloned()
    }

    /// Remembers what a constant is, if exponents can be made of it.
    pub(super) fn define_constant(&mut self, name: &str, value: AstId) {
        if let Some(number) = self.number(value) {
            self.constants.insert(name.to_owned(), number);
        }
    }

    /// Two expressions of one dimension; the second is wrong if they differ.
    pub(super) fn same(&mut self, first: AstId, second: AstId, words: &str) -> Value {
        let (a, b) = (self.known_value(first), self.known_value(second));
        let reason = Reason { words: words.to_owned(), place: self.expressions.origin(first) };
        self.equate_values(second, &b, &a, &reason);
        let has_rates = a.has_rates || b.has_rates;
        let longer = if a.components.len() >= b.components.len() { &a } else { &b };
        let either = |i: usize| {
            let of = |value: &Value| value.components.get(i).cloned().flatten();
            of(&a).or_else(|| of(&b))
        };
        let components = (0..longer.components.len()).map(either).collect();
        Value { components, is_vector: longer.is_vector, has_rates }
    }

    /// Equal dimensions of what is found and what is expected, component by component.
    pub(super) fn equate_values(
        &mut self,
        expression: AstId,
        found: &Value,
        expected: &Value,
        reason: &Reason,
    ) {
        let parts = match self.expressions.get(expression) {
            Expression::Tuple(parts) => parts.clone(),
            _ => Vec::new(),
        };
        for (i, (found, expected)) in found.components.iter().zip(&expected.components).enumerate() {
            if let (Some(found), Some(expected)) = (found, expected) {
                let expression = parts.get(i).copied().unwrap_or(expression);
                self.equate(expression, found, expected, reason);
            }
        }
    }

    pub(super) fn equate(&mut self, expression: AstId, found: &Form, expected: &Form, reason: &Reason) {
        let (found, expected, reason) = (found.clone(), expected.clone(), reason.clone());
        self.solver.equate(Equation { found, expected, expression: Some(expression), reason });
    }

    /// An expression that is to have a dimension, whatever it is made of; of sums each term is.
    pub(super) fn expect(&mut self, root: AstId, expected: &Value, reason: &Reason) -> Value {
        let mut pending = vec![root];
        let mut all = Value { components: expected.components.clone(), ..*expected };
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
        // Whoever asks for the whole of it gets what it should be.
        if !self.values.contains(&root) {
            self.values.insert(root, all.clone());
        }
        all
    }

    pub(super) fn expect_dimension(&mut self, root: AstId, dimension: &Dimension, reason: &Reason) -> Value {
        self.expect(root, &Value::known(dimension.clone().into()), reason)
    }

    /// An operand that is a plain number or an angle.
    pub(super) fn expect_plain(&mut self, operand: AstId, words: &str) {
        let reason = Reason { words: words.to_owned(), place: self.expressions.origin(operand) };
        if let Some(found) = self.known_value(operand).form() {
            self.equate(operand, &found, &Form::plain(), &reason);
        }
    }
}
