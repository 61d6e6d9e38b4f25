//! Rates of functions.

use crate::calculus::{AccelerationTerms, Rates};
use crate::program::{Builder, Op, Program, ValueId, ValueTable, is_written_out};
use crate::series::kinds::has_series;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{Dependencies, ExprId, Function, Graph, Node, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

/// Returns the values of changing functions within `roots` or the rates of such functions, each
/// with its rate.
pub fn function_rates(graph: &mut Graph, roots: &[ExprId]) -> Vec<(ExprId, ExprId)> {
    let mut rates = Rates::new(AccelerationTerms::Kept);
    let mut found: OrderedMap<ExprId, ExprId> = OrderedMap::default();
    let mut roots = roots.to_vec();
    while !roots.is_empty() {
        let reachable = graph.reachable(&roots);
        roots.clear();
        for value in reachable.into_iter().flat_map(|id| values_within(graph, id)).collect::<Vec<_>>() {
            if !found.contains(&value) {
                let rate = rate(graph, &mut rates, value);
                rates.learn(value, rate);
                found.insert(value, rate);
                roots.push(rate);
            }
        }
    }
    found.iter().map(|(value, rate)| (*value, *rate)).collect()
}

/// Returns the values of functions from which a node is computed by only sums, products, quotients
/// and roots.
fn values_within(graph: &mut Graph, id: ExprId) -> Vec<ExprId> {
    let moving = Dependencies::TIME | Dependencies::COORDINATE | Dependencies::STATE | Dependencies::VELOCITY;
    if !graph.dependencies(id).intersects(moving) {
        return Vec::new();
    }
    match graph.node(id).clone() {
        Node::Call(Function::Sign | Function::MagnitudeSlope, _) => Vec::new(),
        Node::Call(..) => vec![id],
        Node::Opaque(function, _) if has_series(&function) => vec![id],
        Node::Product(factors) => {
            let is_moving = |base: ExprId| graph.dependencies(base).intersects(moving);
            let is_call = |(base, exponent): &(ExprId, Number)| !is_written_out(exponent) && is_moving(*base);
            let calls = factors.into_iter().filter(is_call).collect::<Vec<_>>();
            let call = |(base, exponent)| {
                let exponent = graph.number(exponent);
                graph.call(Function::Power, &[base, exponent])
            };
            calls.into_iter().map(call).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns the rate of a function. The rates of powers and lengths are computed from their values.
/// They are zero where these values vanish, since rates nearby have a pole.
fn rate(graph: &mut Graph, rates: &mut Rates, value: ExprId) -> ExprId {
    match graph.node(value).clone() {
        Node::Call(Function::Power, arguments) => {
            rate_of_power(graph, rates, value, [arguments[0], arguments[1]])
        }
        Node::Call(Function::Hypot, _) => {
            let rate = rates.of(graph, value);
            unless_zero(graph, value, rate)
        }
        _ => rates.of(graph, value),
    }
}

/// Returns (e ẋ/x + ė ln x) xᵉ.
fn rate_of_power(
    graph: &mut Graph,
    rates: &mut Rates,
    value: ExprId,
    [base, exponent]: [ExprId; 2],
) -> ExprId {
    let [of_base, of_exponent] = [base, exponent].map(|argument| rates.of(graph, argument));
    let grown =
        [(exponent, Number::ONE), (value, Number::ONE), (of_base, Number::ONE), (base, Number::MINUS_ONE)];
    let grown = graph.product(grown.to_vec());
    let of_base = unless_zero(graph, base, grown);
    let logarithm = apply(graph, Function::Ln, &[base]);
    let of_exponent = [value, logarithm, of_exponent].map(|factor| (factor, Number::ONE));
    let of_exponent = graph.product(of_exponent.to_vec());
    graph.add(of_base, of_exponent)
}

/// Returns a rate, or zero where a value is zero.
fn unless_zero(graph: &mut Graph, value: ExprId, rate: ExprId) -> ExprId {
    let (magnitude, zero) = (graph.magnitude(value), graph.number(0));
    graph.choose(Relation::LessEqual, magnitude, zero, zero, rate)
}

/// Returns the program with products instead of high integer powers: products of series exist even
/// if the base vanishes.
pub fn without_long_powers(program: &Program) -> Program {
    let (mut builder, mut image) = (Builder::new(), ValueTable::with_capacity(program.len()));
    for (id, op) in program.values() {
        let value = match op.map_operands(|operand| image[operand]) {
            Op::Power(base, exponent) => power(&mut builder, base, exponent),
            op => builder.push(op),
        };
        if let Some(name) = program.hint(id) {
            builder.propose_name(value, name);
        }
        image.push(value);
    }
    let outputs = program.outputs().iter().map(|&output| image[output]).collect::<Vec<_>>();
    builder.finish(&outputs)
}

/// Computes an integer power by repeated squaring.
fn power(builder: &mut Builder, base: ValueId, exponent: i32) -> ValueId {
    let (mut power, mut square, mut remaining) =
        (builder.constant(Number::ONE), base, exponent.unsigned_abs());
    while remaining > 0 {
        if remaining % 2 != 0 {
            power = builder.multiply(power, square);
        }
        remaining /= 2;
        if remaining > 0 {
            square = builder.multiply(square, square);
        }
    }
    let one = builder.constant(Number::ONE);
    if exponent < 0 { builder.divide(one, power) } else { power }
}
