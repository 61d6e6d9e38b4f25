//! Reference evaluation in double precision: slow and simple, to check everything else.

use crate::collections::HashMap;
use crate::elementary::row;
use crate::expr::{ExprId, Graph, Node};
use crate::number::Number;
use crate::symbol::Role;

/// Returns the values of `roots` for the values of symbols that `value_of` returns.
///
/// A condition that compares with NaN makes the whole choice NaN. Functions of the user's crate
/// have generic values.
pub fn evaluate(graph: &Graph, roots: &[ExprId], value_of: impl Fn(Role) -> f64) -> Vec<f64> {
    let mut values: HashMap<ExprId, f64> = HashMap::default();
    for id in graph.reachable(roots) {
        let at = |child: &ExprId| values.get(child).copied().unwrap_or(f64::NAN);
        let value = node_value(graph, id, at, &value_of);
        values.insert(id, value);
    }
    roots.iter().map(|root| values.get(root).copied().unwrap_or(f64::NAN)).collect()
}

/// Returns the value of one node, for the values of operands from `at` and of symbols from
/// `value_of`.
pub fn node_value(
    graph: &Graph,
    id: ExprId,
    at: impl Fn(&ExprId) -> f64,
    value_of: impl Fn(Role) -> f64,
) -> f64 {
    match graph.node(id) {
        Node::Number(number) => number.to_f64(),
        Node::Pi => std::f64::consts::PI,
        Node::Symbol(symbol) => value_of(graph.symbols().get(*symbol).role),
        Node::Sum { constant, terms } => {
            terms.iter().fold(constant.to_f64(), |sum, (term, c)| sum + c.to_f64() * at(term))
        }
        Node::Product(factors) => {
            factors.iter().fold(1.0, |product, (base, e)| product * numeric_power(at(base), e))
        }
        Node::Call(function, arguments) => {
            (row(*function).value)(&arguments.iter().map(at).collect::<Vec<_>>())
        }
        Node::Opaque(function, arguments) => {
            let arguments = arguments.iter().map(at).collect::<Vec<_>>();
            function.known_value(&arguments).unwrap_or_else(|| function.stand_in(&arguments))
        }
        Node::Choose { relation, left, right, then, otherwise } => {
            let (left, right) = (at(left), at(right));
            match left.partial_cmp(&right) {
                None => f64::NAN,
                Some(_) if relation.holds(left, right) => at(then),
                Some(_) => at(otherwise),
            }
        }
    }
}

fn numeric_power(base: f64, exponent: &Number) -> f64 {
    match exponent.to_i32() {
        Some(integer) => base.powi(integer),
        None if (exponent * &Number::TWO).is_integer() => base.sqrt().powf(2.0 * exponent.to_f64()),
        None => base.powf(exponent.to_f64()),
    }
}
