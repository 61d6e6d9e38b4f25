//! Values of elementary functions as expressions, and their derivatives.
//!
//! The row of each function in [`elementary`](crate::elementary) holds its properties.

mod quarter_turns;

use crate::elementary::{Domain, Parity, Partial, Row, row};
use crate::expr::{ExprId, Function, Graph, Node, Relation};
use crate::number::Number;
use quarter_turns::without_quarter_turns;

/// Creates a function value. Uses parity and known values, and writes roots and powers with numeric
/// exponents as products.
///
/// The number of `arguments` must be the function's arity.
pub fn apply(graph: &mut Graph, function: Function, arguments: &[ExprId]) -> ExprId {
    match function {
        Function::Sqrt => return graph.power(arguments[0], half_of(Number::ONE)),
        Function::Power => return power(graph, arguments[0], arguments[1]),
        Function::Min | Function::Max => {
            if let Some(known) = known_extremum(graph, function, arguments[0], arguments[1]) {
                return known;
            }
        }
        Function::Hypot => {
            if let Some(zero) = arguments.iter().position(|&side| graph.is_zero(side)) {
                return apply(graph, Function::Abs, &[arguments[1 - zero]]);
            }
        }
        _ => {}
    }
    let row = row(function);
    if row.arity > 1 {
        return graph.call(function, arguments);
    }
    let argument = arguments[0];
    if let Some(value) = known_value(graph, row, argument) {
        return graph.number(value);
    }
    if function == Function::Abs {
        return graph.magnitude(argument);
    }
    if let Some(value) = without_quarter_turns(graph, function, argument) {
        return value;
    }
    let (coefficient, _) = graph.split_coefficient(argument);
    match row.parity {
        Parity::Even if coefficient.is_negative() => {
            let opposite = graph.negate(argument);
            apply(graph, function, &[opposite])
        }
        Parity::Odd if coefficient.is_negative() => {
            let opposite = graph.negate(argument);
            // The argument may be turned by a right angle.
            let value = apply(graph, function, &[opposite]);
            graph.negate(value)
        }
        _ => graph.call(function, &[argument]),
    }
}

fn power(graph: &mut Graph, base: ExprId, exponent: ExprId) -> ExprId {
    match graph.as_number(exponent) {
        Some(value) => {
            let value = value.clone();
            graph.power(base, value)
        }
        None => graph.call(Function::Power, &[base, exponent]),
    }
}

fn known_extremum(graph: &Graph, function: Function, a: ExprId, b: ExprId) -> Option<ExprId> {
    if a == b {
        return Some(a);
    }
    let a_is_less = graph.as_number(a)? < graph.as_number(b)?;
    Some(if a_is_less == (function == Function::Min) { a } else { b })
}

/// Returns the value of a function of one argument if it is a rational number.
fn known_value(graph: &Graph, row: &Row, argument: ExprId) -> Option<Number> {
    if let Some(number) = graph.as_number(argument) {
        return match row.function {
            Function::Abs => Some(number.abs()),
            Function::Sign | Function::MagnitudeSlope => {
                Some(number.abs().reciprocal().map_or(Number::ZERO, |r| &r * number))
            }
            _ if number.is_zero() => row.at_zero.map(Number::from),
            _ => None,
        };
    }
    let (turns, unit) = graph.split_coefficient(argument);
    if *graph.node(unit) != Node::Pi {
        return None;
    }
    match row.function {
        Function::Sin => sine_of_pi_times(&turns),
        Function::Cos => sine_of_pi_times(&(&turns + &half_of(Number::ONE))),
        _ => None,
    }
}

/// Returns sin(π·x) for multiples of one sixth, if it is rational.
fn sine_of_pi_times(x: &Number) -> Option<Number> {
    let sixths = (x * &Number::from(6)).to_i32()?.rem_euclid(12);
    let (position, sign) = if sixths < 6 { (sixths, Number::ONE) } else { (sixths - 6, Number::MINUS_ONE) };
    match position {
        0 => Some(Number::ZERO),
        1 | 5 => Some(half_of(sign)),
        3 => Some(sign),
        _ => None,
    }
}

/// Returns the partial derivatives of a function value with respect to each argument.
pub fn partials(graph: &mut Graph, function: Function, arguments: &[ExprId], value: ExprId) -> Vec<ExprId> {
    let call = FunctionValue { arguments, value };
    row(function).partials.iter().map(|partial| call.build(graph, partial)).collect()
}

/// True if a node has an argument that must lie in a domain.
pub fn is_restricted(graph: &Graph, id: ExprId) -> bool {
    match graph.node(id) {
        Node::Product(factors) => factors.iter().any(|(_, exponent)| !exponent.is_integer()),
        // A sign that never changes has no surface.
        Node::Call(Function::Sign | Function::MagnitudeSlope, arguments) => {
            graph.is_nonnegative(arguments[0])
        }
        Node::Call(function, _) => match row(*function).domain {
            Domain::FromZero | Domain::AboveZero | Domain::BaseAboveZero | Domain::WithinOne => true,
            Domain::Everywhere | Domain::AwayFrom(_) => false,
        },
        _ => false,
    }
}

/// A function value with its arguments.
struct FunctionValue<'a> {
    arguments: &'a [ExprId],
    value: ExprId,
}

impl FunctionValue<'_> {
    fn build(&self, graph: &mut Graph, partial: &Partial) -> ExprId {
        match *partial {
            Partial::Argument(position) => self.arguments[position],
            Partial::Value => self.value,
            Partial::Constant(number) => graph.number(number),
            Partial::Call(function, inner) => {
                let inner = inner.iter().map(|inner| self.build(graph, inner)).collect::<Vec<_>>();
                apply(graph, function, &inner)
            }
            Partial::Negate(a) => self.scaled(graph, Number::MINUS_ONE, a),
            Partial::Half(a) => self.scaled(graph, half_of(Number::ONE), a),
            Partial::Square(a) => self.power(graph, a, Number::TWO),
            Partial::Reciprocal(a) => self.power(graph, a, Number::MINUS_ONE),
            Partial::ReciprocalRoot(a) => self.power(graph, a, half_of(Number::MINUS_ONE)),
            Partial::Add(a, b) => self.of_two(graph, a, b, Graph::add),
            Partial::Multiply(a, b) => self.of_two(graph, a, b, Graph::multiply),
            Partial::Divide(a, b) => self.of_two(graph, a, b, Graph::divide),
            Partial::Linear(constant, coefficient, a) => {
                let a = self.build(graph, a);
                graph.sum(Number::from(constant), [(a, Number::from(coefficient))])
            }
            Partial::Less(a, b) => self.indicator(graph, a, b, [1, 0]),
            Partial::NotLess(a, b) => self.indicator(graph, a, b, [0, 1]),
        }
    }

    fn scaled(&self, graph: &mut Graph, factor: Number, a: &Partial) -> ExprId {
        let a = self.build(graph, a);
        graph.scale(factor, a)
    }

    fn power(&self, graph: &mut Graph, a: &Partial, exponent: Number) -> ExprId {
        let a = self.build(graph, a);
        graph.power(a, exponent)
    }

    fn of_two(
        &self,
        graph: &mut Graph,
        a: &Partial,
        b: &Partial,
        operation: fn(&mut Graph, ExprId, ExprId) -> ExprId,
    ) -> ExprId {
        let (a, b) = (self.build(graph, a), self.build(graph, b));
        operation(graph, a, b)
    }

    /// Returns the first number where a < b, and the second elsewhere.
    fn indicator(&self, graph: &mut Graph, a: &Partial, b: &Partial, numbers: [i64; 2]) -> ExprId {
        let (a, b) = (self.build(graph, a), self.build(graph, b));
        let [then, otherwise] = numbers.map(|number| graph.number(number));
        graph.choose(Relation::Less, a, b, then, otherwise)
    }
}

fn half_of(x: Number) -> Number {
    x * Number::HALF
}

#[cfg(test)]
mod tests;
