//! Construction of syntax from syntax.
//!
//! Zeros and ones from omitted parts are not written, so that plain statements read as if written
//! by hand. There is no other algebra here.

use proc_macro2::Span;

use crate::syntax::ast::{AstId, BinaryOperator, Comparison, Condition, Expression, Expressions, Name};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;

/// A vector in the plane.
pub(super) type Pair = [AstId; 2];

/// Writer of expressions that are located at a place in the source.
pub(super) struct TermWriter<'e> {
    expressions: &'e mut Expressions,
    origin: Origin,
}

impl<'e> TermWriter<'e> {
    /// Creates a writer of terms located at `origin`.
    pub(super) fn new(expressions: &'e mut Expressions, origin: Origin) -> TermWriter<'e> {
        TermWriter { expressions, origin }
    }

    pub(super) fn add_node(&mut self, expression: Expression) -> AstId {
        self.expressions.add(expression, self.origin)
    }

    pub(super) fn number(&mut self, value: impl Into<Number>) -> AstId {
        self.add_node(Expression::Number(value.into()))
    }

    pub(super) fn half(&mut self) -> AstId {
        let (one, two) = (self.number(1), self.number(2));
        self.divide(one, two)
    }

    pub(super) fn name(&mut self, name: &str) -> AstId {
        self.add_node(Expression::Name(name.to_owned()))
    }

    /// Copies terms that were constructed before, with the current location; calls and numbers stay
    /// as they are.
    pub(super) fn repeated(&mut self, id: AstId) -> AstId {
        let expression = match self.expressions.get(id).clone() {
            Expression::Tuple(parts) => {
                Expression::Tuple(parts.into_iter().map(|part| self.repeated(part)).collect())
            }
            Expression::Negate(of) => Expression::Negate(self.repeated(of)),
            Expression::Binary(operator, span, a, b) => {
                Expression::Binary(operator, span, self.repeated(a), self.repeated(b))
            }
            name @ Expression::Name(_) => name,
            _ => return id,
        };
        self.add_node(expression)
    }

    /// Copies an expression with values in place of names.
    pub(super) fn with_values(&mut self, root: AstId, names: &[String], values: &[AstId]) -> AstId {
        let mut copies: HashMap<AstId, AstId> = HashMap::default();
        for id in self.expressions.parts(root) {
            let expression = self.expressions.get(id).clone();
            let place = match &expression {
                Expression::Name(name) => names.iter().position(|known| known == name),
                _ => None,
            };
            let operands = expression.operands();
            let copied = operands.iter().map(|id| copies.get(id).copied().unwrap_or(*id)).collect::<Vec<_>>();
            if let Some(place) = place {
                copies.insert(id, values[place]);
            } else if copied != operands {
                let origin = self.expressions.origin(id);
                copies.insert(id, self.expressions.add(expression.with_operands(&copied), origin));
            }
        }
        copies.get(&root).copied().unwrap_or(root)
    }

    pub(super) fn zero_pair(&mut self) -> Pair {
        [self.number(0), self.number(0)]
    }

    /// Returns a placeholder for an expression with a reported error.
    pub(super) fn invalid(&mut self) -> AstId {
        self.add_node(Expression::Invalid)
    }

    pub(super) fn call(&mut self, function: &str, arguments: &[AstId]) -> AstId {
        let name = Name::new(function, self.span());
        self.add_node(Expression::Call(name, arguments.to_vec()))
    }

    pub(super) fn tuple(&mut self, pair: Pair) -> AstId {
        self.add_node(Expression::Tuple(pair.to_vec()))
    }

    /// Returns the vector with these components. All components of an existing vector, in order,
    /// yield this vector.
    pub(super) fn vector(&mut self, components: &[AstId]) -> AstId {
        match self.whole(components) {
            Some(vector) => vector,
            None => self.add_node(Expression::Tuple(components.to_vec())),
        }
    }

    /// Returns the existing vector in space with these components.
    fn whole(&self, components: &[AstId]) -> Option<AstId> {
        let of = |id: AstId, axis: &str| match self.expressions.get(id) {
            Expression::Component(vector, name) if name.text == axis => Some(*vector),
            _ => None,
        };
        let &[x, y, z] = components else { return None };
        let vector = of(x, "x")?;
        (of(y, "y") == Some(vector) && of(z, "z") == Some(vector)).then_some(vector)
    }

    /// Returns the components of a vector in the plane.
    pub(super) fn pair(&mut self, vector: AstId) -> Pair {
        self.components(vector, ["x", "y"])
    }

    /// Returns the components of a vector in space.
    pub(super) fn triple(&mut self, vector: AstId) -> [AstId; 3] {
        self.components(vector, ["x", "y", "z"])
    }

    /// Returns the components of the difference of two vectors.
    pub(super) fn difference(&mut self, dimension: usize, [a, b]: [AstId; 2]) -> Vec<AstId> {
        let (a, b) = (self.components_of(dimension, a), self.components_of(dimension, b));
        a.into_iter().zip(b).map(|(a, b)| self.minus(a, b)).collect()
    }

    /// Returns the components of a vector, three in space.
    pub(super) fn components_of(&mut self, dimension: usize, vector: AstId) -> Vec<AstId> {
        match dimension {
            3 => self.triple(vector).to_vec(),
            _ => self.pair(vector).to_vec(),
        }
    }

    fn components<const N: usize>(&mut self, vector: AstId, axes: [&str; N]) -> [AstId; N] {
        let written = match self.expressions.get(vector) {
            Expression::Tuple(components) => components.clone().try_into().ok(),
            Expression::Invalid => Some([vector; N]),
            _ => None,
        };
        written.unwrap_or_else(|| {
            axes.map(|axis| {
                let axis = Name::new(axis, self.expressions.origin(vector).start);
                self.add_node(Expression::Component(vector, axis))
            })
        })
    }

    pub(super) fn plus(&mut self, a: AstId, b: AstId) -> AstId {
        match (self.as_number(a).is_some_and(Number::is_zero), self.as_number(b).is_some_and(Number::is_zero))
        {
            (true, _) => b,
            (_, true) => a,
            _ => match self.negated(b) {
                Some(b) => self.binary(BinaryOperator::Subtract, a, b),
                None => self.binary(BinaryOperator::Add, a, b),
            },
        }
    }

    pub(super) fn minus(&mut self, a: AstId, b: AstId) -> AstId {
        if self.as_number(b).is_some_and(Number::is_zero) {
            return a;
        }
        if self.as_number(a).is_some_and(Number::is_zero) {
            return self.negative(b);
        }
        match self.negated(b) {
            Some(b) => self.binary(BinaryOperator::Add, a, b),
            None => self.binary(BinaryOperator::Subtract, a, b),
        }
    }

    pub(super) fn negative(&mut self, a: AstId) -> AstId {
        match self.as_number(a) {
            Some(number) if number.is_zero() => a,
            _ => self.negated(a).unwrap_or_else(|| self.add_node(Expression::Negate(a))),
        }
    }

    pub(super) fn times(&mut self, a: AstId, b: AstId) -> AstId {
        let is = |id: AstId, test: fn(&Number) -> bool| self.as_number(id).is_some_and(test);
        if is(a, Number::is_zero) || is(b, Number::is_one) {
            return a;
        }
        if is(b, Number::is_zero) || is(a, Number::is_one) {
            return b;
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => self.times(a, b),
            (Some(a), None) => {
                let product = self.times(a, b);
                self.negative(product)
            }
            (None, Some(b)) => {
                let product = self.times(a, b);
                self.negative(product)
            }
            (None, None) => self.binary(BinaryOperator::Multiply, a, b),
        }
    }

    pub(super) fn divide(&mut self, a: AstId, b: AstId) -> AstId {
        if self.is_zero(a) {
            return a;
        }
        match self.negated(a) {
            Some(a) => {
                let quotient = self.binary(BinaryOperator::Divide, a, b);
                self.negative(quotient)
            }
            None => self.binary(BinaryOperator::Divide, a, b),
        }
    }

    pub(super) fn square(&mut self, a: AstId) -> AstId {
        let two = self.number(2);
        self.binary(BinaryOperator::Power, a, two)
    }

    pub(super) fn plus_pair(&mut self, a: Pair, b: Pair) -> Pair {
        [self.plus(a[0], b[0]), self.plus(a[1], b[1])]
    }

    pub(super) fn minus_pair(&mut self, a: Pair, b: Pair) -> Pair {
        [self.minus(a[0], b[0]), self.minus(a[1], b[1])]
    }

    pub(super) fn scale(&mut self, factor: AstId, a: Pair) -> Pair {
        [self.times(factor, a[0]), self.times(factor, a[1])]
    }

    /// Returns Σ aᵢ bᵢ.
    pub(super) fn inner(&mut self, a: Pair, b: Pair) -> AstId {
        let (x, y) = (self.times(a[0], b[0]), self.times(a[1], b[1]));
        self.plus(x, y)
    }

    /// Returns x² + y².
    pub(super) fn squared_length(&mut self, a: Pair) -> AstId {
        let [x, y] = a.map(|component| match self.is_zero(component) {
            true => component,
            false => self.square(component),
        });
        self.plus(x, y)
    }

    /// Returns a × b, perpendicular to the plane.
    pub(super) fn cross(&mut self, a: Pair, b: Pair) -> AstId {
        let (forward, backward) = (self.times(a[0], b[1]), self.times(a[1], b[0]));
        self.minus(forward, backward)
    }

    /// Returns e_z × a.
    pub(super) fn quarter_turn(&mut self, a: Pair) -> Pair {
        [self.negative(a[1]), a[0]]
    }

    /// Returns a vector turned by an angle.
    pub(super) fn turned(&mut self, a: Pair, angle: AstId) -> Pair {
        if self.is_zero(angle) || a.iter().all(|&component| self.is_zero(component)) {
            return a;
        }
        let [along, across] = self.axes(angle);
        let (x, y) = (self.scale(a[0], along), self.scale(a[1], across));
        self.plus_pair(x, y)
    }

    /// Returns (cos, sin) of an angle.
    pub(super) fn direction(&mut self, angle: AstId) -> Pair {
        match self.is_zero(angle) {
            true => [self.number(1), self.number(0)],
            false => [self.call("cos", &[angle]), self.call("sin", &[angle])],
        }
    }

    /// Returns the directions of axes that are turned by an angle.
    pub(super) fn axes(&mut self, angle: AstId) -> [Pair; 2] {
        let along = self.direction(angle);
        [along, self.quarter_turn(along)]
    }

    /// Returns one value where a scalar is positive, and another one elsewhere.
    pub(super) fn if_positive(&mut self, scalar: AstId, then: AstId, otherwise: AstId) -> AstId {
        let zero = self.number(0);
        let condition = Condition { left: zero, relation: Comparison::Less, right: scalar };
        self.add_node(Expression::If { condition, then, otherwise })
    }

    /// Returns the distance of one point from another in a direction.
    pub(super) fn projection(&mut self, direction: Pair, to: Pair, from: Pair) -> AstId {
        let arm = self.minus_pair(to, from);
        self.inner(direction, arm)
    }

    /// Returns the rate of a scalar.
    pub(super) fn rate(&mut self, of: AstId) -> AstId {
        match self.as_number(of) {
            Some(_) => self.number(0),
            None => self.call("dot", &[of]),
        }
    }

    /// Returns the second rate of a scalar.
    pub(super) fn second_rate(&mut self, of: AstId) -> AstId {
        match self.as_number(of) {
            Some(_) => self.number(0),
            None => self.call("ddot", &[of]),
        }
    }

    /// Returns the components of the rate of a vector.
    pub(super) fn rate_pair(&mut self, of: Pair) -> Pair {
        of.map(|component| self.rate(component))
    }

    pub(super) fn is_zero(&self, id: AstId) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }

    pub(super) fn is_number(&self, id: AstId) -> bool {
        self.as_number(id).is_some()
    }

    fn as_number(&self, id: AstId) -> Option<&Number> {
        match self.expressions.get(id) {
            Expression::Number(number) => Some(number),
            _ => None,
        }
    }

    /// Returns a if the expression is −a, even if the sign is that of its first factor.
    fn negated(&mut self, id: AstId) -> Option<AstId> {
        use BinaryOperator::{Divide, Multiply};
        match *self.expressions.get(id) {
            Expression::Negate(inner) => Some(inner),
            Expression::Binary(operator @ (Multiply | Divide), _, a, b) => {
                let Expression::Negate(a) = *self.expressions.get(a) else { return None };
                Some(self.binary(operator, a, b))
            }
            _ => None,
        }
    }

    fn binary(&mut self, operator: BinaryOperator, a: AstId, b: AstId) -> AstId {
        let span = self.span();
        self.add_node(Expression::Binary(operator, span, a, b))
    }

    fn span(&self) -> Span {
        self.origin.start
    }
}
