//! Known dimensions during a pass over a declaration.

use super::exponents::Exponents;
use super::measure::Measure;
use super::messages;
use super::solver::{DimensionEquation, Grounds, Solver};
use crate::syntax::ast::{AstId, BinaryOperator, Expression, Expressions};
use lagrange_expr::collections::HashMap;
use lagrange_expr::number::Number;

/// The known dimensions of names and expressions.
pub(super) struct Checker<'a> {
    pub(super) expressions: &'a Expressions,
    pub(super) scope: HashMap<String, Measure>,
    /// Functions of the user's crate and tables: dimensions of arguments, then of the value.
    pub(super) callables: HashMap<String, Vec<Exponents>>,
    /// Constants that are rational numbers.
    pub(super) constants: HashMap<String, Number>,
    /// Dimensions of expressions so far.
    pub(super) values: HashMap<AstId, Measure>,
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

    /// Returns the known dimension of an expression.
    pub(super) fn known_value(&self, id: AstId) -> Measure {
        self.values.get(&id).cloned().unwrap_or_else(Measure::any)
    }

    /// Returns the dimension of a power. If the exponent may change, only plain numbers are valid.
    pub(super) fn power(&mut self, base: AstId, exponent: AstId) -> Measure {
        let value = self.known_value(base);
        if let Some(exponent) = self.number(exponent) {
            return value.map(|form| form.power(&exponent));
        }
        self.require_plain(exponent, messages::EXPONENT);
        self.require_plain(base, messages::BASE);
        Measure::known(Exponents::plain()).with_rates(value.has_rates)
    }

    /// Returns the value of an expression that is a rational number.
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

    /// Records the value of a constant, if it can be used in exponents.
    pub(super) fn define_constant(&mut self, name: &str, value: AstId) {
        if let Some(number) = self.number(value) {
            self.constants.insert(name.to_owned(), number);
        }
    }

    /// Requires two expressions to have the same dimension; the second is wrong if they differ.
    pub(super) fn same(&mut self, first: AstId, second: AstId, words: &str) -> Measure {
        let (a, b) = (self.known_value(first), self.known_value(second));
        let reason = Grounds { words: words.to_owned(), place: self.expressions.origin(first) };
        self.equate_values(second, &b, &a, &reason);
        let has_rates = a.has_rates || b.has_rates;
        let longer = if a.components.len() >= b.components.len() { &a } else { &b };
        let either = |i: usize| {
            let of = |value: &Measure| value.components.get(i).cloned().flatten();
            of(&a).or_else(|| of(&b))
        };
        let components = (0..longer.components.len()).map(either).collect();
        Measure::of(longer.shape, components).with_rates(has_rates)
    }

    /// Equates found and expected dimensions, component by component.
    pub(super) fn equate_values(
        &mut self,
        expression: AstId,
        found: &Measure,
        expected: &Measure,
        reason: &Grounds,
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

    pub(super) fn equate(
        &mut self,
        expression: AstId,
        found: &Exponents,
        expected: &Exponents,
        reason: &Grounds,
    ) {
        let (found, expected, reason) = (found.clone(), expected.clone(), reason.clone());
        self.solver.equate(DimensionEquation { found, expected, expression: Some(expression), reason });
    }

    /// Requires an operand to be a plain number or an angle.
    pub(super) fn require_plain(&mut self, operand: AstId, words: &str) {
        let reason = Grounds { words: words.to_owned(), place: self.expressions.origin(operand) };
        if let Some(found) = self.known_value(operand).form() {
            self.equate(operand, &found, &Exponents::plain(), &reason);
        }
    }
}
