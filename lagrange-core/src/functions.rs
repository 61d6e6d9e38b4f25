//! The elementary functions, one row each.
//!
//! A row holds everything the other modules know of a function; adding one is adding a variant to
//! [`Function`] and a row here. Derivatives are those of Abramowitz and Stegun, *Handbook of Mathematical
//! Functions*, chapter 4; derivatives of piecewise functions are taken branch by branch.

mod quarter_turns;

use crate::expr::{ExprId, Function, Graph, Node, Relation};
use crate::number::Number;
use quarter_turns::without_quarter_turns;

/// How a function of one argument behaves when the argument changes sign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Parity {
    /// f(−x) = f(x)
    Even,
    /// f(−x) = −f(x)
    Odd,
    /// Neither of the two, or more than one argument.
    Neither,
}

/// What is known of one function.
#[derive(Debug)]
pub struct Row {
    /// The function.
    pub function: Function,
    /// Its name in the language.
    pub name: &'static str,
    /// The number of arguments.
    pub arity: usize,
    /// Behaviour under a change of sign.
    pub parity: Parity,
    /// Where it is defined, in words for error messages and docs.
    pub domain: &'static str,
    /// The exact value at zero, if that is a rational number.
    pub at_zero: Option<i64>,
    /// LaTeX in which `#1` and `#2` stand for the arguments.
    pub latex: &'static str,
    /// The function of `lagrange::Scalar` that computes it.
    pub rust: &'static str,
    /// The value in double precision.
    pub value: fn(&[f64]) -> f64,
    /// Partial derivatives with respect to each argument, given the arguments and the value itself.
    pub partials: fn(&mut Graph, &[ExprId], ExprId) -> Vec<ExprId>,
}

impl Row {
    /// Whether it is defined everywhere.
    pub fn is_total(&self) -> bool {
        self.domain == "everywhere"
    }
}

/// Every function, in the order of [`Function`].
pub const ROWS: [Row; 20] = [
    Row {
        function: Function::Sin,
        name: "sin",
        arity: 1,
        parity: Parity::Odd,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\sin\left(#1\right)",
        rust: "sin",
        value: |x| x[0].sin(),
        partials: |g, x, _| vec![apply(g, Function::Cos, x)],
    },
    Row {
        function: Function::Cos,
        name: "cos",
        arity: 1,
        parity: Parity::Even,
        domain: "everywhere",
        at_zero: Some(1),
        latex: r"\cos\left(#1\right)",
        rust: "cos",
        value: |x| x[0].cos(),
        partials: |g, x, _| {
            let sin = apply(g, Function::Sin, x);
            vec![g.negate(sin)]
        },
    },
    Row {
        function: Function::Tan,
        name: "tan",
        arity: 1,
        parity: Parity::Odd,
        domain: "away from odd multiples of π/2",
        at_zero: Some(0),
        latex: r"\tan\left(#1\right)",
        rust: "tan",
        value: |x| x[0].tan(),
        partials: |g, _, f| vec![one_plus(g, Number::ONE, f)],
    },
    Row {
        function: Function::Asin,
        name: "asin",
        arity: 1,
        parity: Parity::Odd,
        domain: "between -1 and 1",
        at_zero: Some(0),
        latex: r"\arcsin\left(#1\right)",
        rust: "asin",
        value: |x| x[0].asin(),
        partials: |g, x, _| vec![inverse_root(g, Number::ONE, Number::MINUS_ONE, x[0])],
    },
    Row {
        function: Function::Acos,
        name: "acos",
        arity: 1,
        parity: Parity::Neither,
        domain: "between -1 and 1",
        at_zero: None,
        latex: r"\arccos\left(#1\right)",
        rust: "acos",
        value: |x| x[0].acos(),
        partials: |g, x, _| {
            let root = inverse_root(g, Number::ONE, Number::MINUS_ONE, x[0]);
            vec![g.negate(root)]
        },
    },
    Row {
        function: Function::Atan,
        name: "atan",
        arity: 1,
        parity: Parity::Odd,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\arctan\left(#1\right)",
        rust: "atan",
        value: |x| x[0].atan(),
        partials: |g, x, _| {
            let denominator = one_plus(g, Number::ONE, x[0]);
            vec![g.reciprocal(denominator)]
        },
    },
    Row {
        function: Function::Atan2,
        name: "atan2",
        arity: 2,
        parity: Parity::Neither,
        domain: "away from the origin",
        at_zero: None,
        latex: r"\operatorname{atan2}\left(#1, #2\right)",
        rust: "atan2",
        value: |x| x[0].atan2(x[1]),
        partials: |g, x, _| {
            let (y2, x2) = (g.square(x[0]), g.square(x[1]));
            let r2 = g.add(y2, x2);
            let (dy, dx) = (g.divide(x[1], r2), g.divide(x[0], r2));
            vec![dy, g.negate(dx)]
        },
    },
    Row {
        function: Function::Sinh,
        name: "sinh",
        arity: 1,
        parity: Parity::Odd,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\sinh\left(#1\right)",
        rust: "sinh",
        value: |x| x[0].sinh(),
        partials: |g, x, _| vec![apply(g, Function::Cosh, x)],
    },
    Row {
        function: Function::Cosh,
        name: "cosh",
        arity: 1,
        parity: Parity::Even,
        domain: "everywhere",
        at_zero: Some(1),
        latex: r"\cosh\left(#1\right)",
        rust: "cosh",
        value: |x| x[0].cosh(),
        partials: |g, x, _| vec![apply(g, Function::Sinh, x)],
    },
    Row {
        function: Function::Tanh,
        name: "tanh",
        arity: 1,
        parity: Parity::Odd,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\tanh\left(#1\right)",
        rust: "tanh",
        value: |x| x[0].tanh(),
        partials: |g, _, f| vec![one_plus(g, Number::MINUS_ONE, f)],
    },
    Row {
        function: Function::Exp,
        name: "exp",
        arity: 1,
        parity: Parity::Neither,
        domain: "everywhere",
        at_zero: Some(1),
        latex: r"\exp\left(#1\right)",
        rust: "exp",
        value: |x| x[0].exp(),
        partials: |_, _, f| vec![f],
    },
    Row {
        function: Function::Ln,
        name: "ln",
        arity: 1,
        parity: Parity::Neither,
        domain: "above 0",
        at_zero: None,
        latex: r"\ln\left(#1\right)",
        rust: "ln",
        value: |x| x[0].ln(),
        partials: |g, x, _| vec![g.reciprocal(x[0])],
    },
    Row {
        function: Function::Sqrt,
        name: "sqrt",
        arity: 1,
        parity: Parity::Neither,
        domain: "from 0 upwards",
        at_zero: Some(0),
        latex: r"\sqrt{#1}",
        rust: "sqrt",
        value: |x| x[0].sqrt(),
        partials: |g, x, _| {
            let root = g.power(x[0], half_of(Number::MINUS_ONE));
            vec![g.scale(half_of(Number::ONE), root)]
        },
    },
    Row {
        function: Function::Abs,
        name: "abs",
        arity: 1,
        parity: Parity::Even,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\left|#1\right|",
        rust: "abs",
        value: |x| x[0].abs(),
        partials: |g, x, _| vec![apply(g, Function::MagnitudeSlope, x)],
    },
    Row {
        function: Function::Sign,
        name: "sign",
        arity: 1,
        parity: Parity::Odd,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\operatorname{sign}\left(#1\right)",
        rust: "sign",
        value: |x| sign(x[0]),
        partials: |g, _, _| vec![g.number(0)],
    },
    Row {
        function: Function::Min,
        name: "min",
        arity: 2,
        parity: Parity::Neither,
        domain: "everywhere",
        at_zero: None,
        latex: r"\min\left(#1, #2\right)",
        rust: "min",
        // The comparisons are arranged so that NaN in either argument comes through.
        value: |x| if x[0] < x[1] || x[0].is_nan() { x[0] } else { x[1] },
        partials: |g, x, _| indicators(g, x[0], x[1]),
    },
    Row {
        function: Function::Max,
        name: "max",
        arity: 2,
        parity: Parity::Neither,
        domain: "everywhere",
        at_zero: None,
        latex: r"\max\left(#1, #2\right)",
        rust: "max",
        value: |x| if x[0] > x[1] || x[0].is_nan() { x[0] } else { x[1] },
        partials: |g, x, _| indicators(g, x[1], x[0]),
    },
    Row {
        function: Function::Power,
        name: "pow",
        arity: 2,
        parity: Parity::Neither,
        domain: "bases above 0",
        at_zero: None,
        latex: r"{#1}^{#2}",
        rust: "powf",
        // Unlike `powf` of the platform, which makes 1^NaN and NaN^0 one.
        value: |x| if x[0].is_nan() || x[1].is_nan() { f64::NAN } else { x[0].powf(x[1]) },
        partials: |g, x, f| {
            let one = g.number(1);
            let lower = g.subtract(x[1], one);
            let power = apply(g, Function::Power, &[x[0], lower]);
            let logarithm = apply(g, Function::Ln, &x[..1]);
            vec![g.multiply(x[1], power), g.multiply(f, logarithm)]
        },
    },
    Row {
        function: Function::Hypot,
        name: "hypot",
        arity: 2,
        parity: Parity::Neither,
        domain: "everywhere",
        at_zero: None,
        latex: r"\sqrt{\left(#1\right)^{2} + \left(#2\right)^{2}}",
        rust: "hypot",
        value: |x| x[0].hypot(x[1]),
        partials: |g, x, f| vec![g.divide(x[0], f), g.divide(x[1], f)],
    },
    // Written as the sign, which has its value; only products tell them apart.
    Row {
        function: Function::MagnitudeSlope,
        name: "sign",
        arity: 1,
        parity: Parity::Odd,
        domain: "everywhere",
        at_zero: Some(0),
        latex: r"\operatorname{sign}\left(#1\right)",
        rust: "sign",
        value: |x| sign(x[0]),
        partials: |g, _, _| vec![g.number(0)],
    },
];

/// ±1; zero and NaN are their own signs.
fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// What is known of `function`.
pub fn row(function: Function) -> &'static Row {
    &ROWS[function as usize]
}

/// The function of that name in the language.
pub fn by_name(name: &str) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.name == name)
}

/// The constructor of function values: uses parity and known values, and writes roots and powers with
/// numeric exponents as products.
///
/// `arguments` must be as many as the function's arity.
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
            let value = graph.call(function, &[opposite]);
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

/// The value of a function of one argument where it is a rational number.
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

/// sin(π·x) for multiples of one sixth, where it is rational.
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

fn half_of(x: Number) -> Number {
    x * Number::ratio(1, 2).unwrap_or(Number::ZERO)
}

/// 1 + sign·x²
fn one_plus(graph: &mut Graph, sign: Number, x: ExprId) -> ExprId {
    let square = graph.square(x);
    graph.sum(Number::ONE, [(square, sign)])
}

/// 1/√(constant + sign·x²)
fn inverse_root(graph: &mut Graph, constant: Number, sign: Number, x: ExprId) -> ExprId {
    let square = graph.square(x);
    let radicand = graph.sum(constant, [(square, sign)]);
    graph.power(radicand, half_of(Number::MINUS_ONE))
}

/// 1 and 0 where a < b; 0 and 1 elsewhere.
fn indicators(graph: &mut Graph, a: ExprId, b: ExprId) -> Vec<ExprId> {
    let (zero, one) = (graph.number(0), graph.number(1));
    vec![graph.choose(Relation::Less, a, b, one, zero), graph.choose(Relation::Less, a, b, zero, one)]
}

#[cfg(test)]
mod tests;
