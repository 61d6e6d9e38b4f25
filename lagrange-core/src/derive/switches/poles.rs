//! Negative powers on fixed sides of switches: poles that another factor removes, and poles that
//! are not on a surface.

use super::Side;
use lagrange_algebra::calculus::substitute;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

/// Writes xᵐ |x|ᵖ as sᵐ |x|ᵐ⁺ᵖ where m + p is positive and p is not.
pub(super) fn without_removable_poles(
    graph: &mut Graph,
    sides: &HashMap<ExprId, Side>,
    factors: &[(ExprId, Number)],
    map: &impl Fn(ExprId) -> ExprId,
) -> Vec<(ExprId, Number)> {
    let mut factors = with_magnitudes_apart(graph, sides, factors);
    for at in 0..factors.len() {
        join_power(graph, sides, &mut factors, at, map);
        let (base, power) = factors[at].clone();
        let Node::Call(Function::Abs, arguments) = graph.node(base) else { continue };
        let Some(&side) = sides.get(&base).filter(|_| power.is_negative()) else { continue };
        let argument = arguments[0];
        let inner = factors.iter().enumerate().find_map(|(place, (other, exponent))| {
            let ratio = multiple(graph, *other, argument).filter(|_| exponent.is_integer())?;
            Some((place, ratio))
        });
        let Some((inner, ratio)) = inner else { continue };
        let whole = factors[inner].1.clone();
        let total = &power + &whole;
        if !total.is_integer() && !total.is_negative() {
            factors[at].1 = total;
            let slope = side.slope(graph);
            factors[inner] = (graph.scale(ratio, slope), whole);
        }
    }
    factors
}

/// Writes (c |x|)ᵖ as cᵖ |x|ᵖ where p is negative.
fn with_magnitudes_apart(
    graph: &mut Graph,
    sides: &HashMap<ExprId, Side>,
    factors: &[(ExprId, Number)],
) -> Vec<(ExprId, Number)> {
    let mut apart = Vec::with_capacity(factors.len());
    for (base, power) in factors {
        let (coefficient, core) = graph.split_coefficient(*base);
        let inner = match graph.node(core).clone() {
            Node::Product(inner) if power.is_negative() && !power.is_integer() => inner,
            _ => {
                apart.push((*base, power.clone()));
                continue;
            }
        };
        let is_apart = |(part, exponent): &(ExprId, Number)| {
            exponent.is_one()
                && matches!(graph.node(*part), Node::Call(Function::Abs, _))
                && sides.contains(part)
        };
        let (magnitudes, rest): (Vec<_>, Vec<_>) = inner.iter().cloned().partition(is_apart);
        let rest = graph.product(rest);
        apart.push((graph.scale(coefficient, rest), power.clone()));
        apart.extend(magnitudes.into_iter().map(|(magnitude, _)| (magnitude, power.clone())));
    }
    apart
}

/// Writes xᵐ |c x|ᵖ at this place as sᵐ c⁻ᵐ |c x|ᵐ⁺ᵖ, and |x|ᵐ |c x|ᵖ without the sign, where p
/// is not a number.
fn join_power(
    graph: &mut Graph,
    sides: &HashMap<ExprId, Side>,
    factors: &mut [(ExprId, Number)],
    at: usize,
    map: &impl Fn(ExprId) -> ExprId,
) {
    let (call, times) = factors[at].clone();
    let Node::Call(Function::Power, arguments) = graph.node(call).clone() else { return };
    let [base, exponent] = arguments[..] else { return };
    let (_, core) = graph.split_coefficient(base);
    let parts = match graph.node(core).clone() {
        Node::Product(parts) => parts.into_vec(),
        _ => vec![(core, Number::ONE)],
    };
    for (magnitude, power) in parts {
        let Node::Call(Function::Abs, inner) = graph.node(magnitude).clone() else { continue };
        let Some(&side) = sides.get(&magnitude).filter(|_| power.is_one()) else { continue };
        let joined =
            factors.iter().enumerate().find_map(|(place, (other, power))| match *other == magnitude {
                true => Some((place, None)),
                false if power.is_integer() => Some((place, Some(multiple(graph, *other, inner[0])?))),
                false => None,
            });
        let Some((place, ratio)) = joined else { continue };
        let power = factors[place].1.clone();
        let sign = match ratio {
            Some(ratio) => {
                let slope = side.slope(graph);
                graph.scale(ratio, slope)
            }
            None => graph.number(1),
        };
        let scale = graph.divide(magnitude, base);
        let factor = graph.multiply(sign, scale);
        let exponents = graph.scale(times.clone(), exponent);
        let gain = graph.number(power.clone());
        let total = graph.add(exponents, gain);
        let (zero, mapped) = (graph.number(0), map(base));
        // Negative powers are singular on the surface.
        let kept = graph.choose(Relation::Less, zero, total, base, mapped);
        factors[place] = (factor, power);
        factors[at] = (apply(graph, Function::Power, &[kept, total]), Number::ONE);
        return;
    }
}

/// True if an expression is recognised as zero on a surface, such as |x| where x is zero.
pub(super) fn vanishes(graph: &mut Graph, sides: &HashMap<ExprId, Side>, id: ExprId, side: Side) -> bool {
    let zero = graph.number(0);
    let mut values = HashMap::default();
    values.insert(side.value, zero);
    for part in graph.reachable(&[id]) {
        if sides.get(&part).is_none_or(|own| own.value != side.value) {
            continue;
        }
        match graph.node(part) {
            // Both arguments are equal there.
            Node::Call(Function::Min | Function::Max, arguments) => {
                let is_constant = |argument: &&ExprId| graph.dependencies(**argument).is_constant_in_motion();
                values.insert(part, *arguments.iter().find(is_constant).unwrap_or(&arguments[0]));
            }
            Node::Choose { .. } => {}
            _ => drop(values.insert(part, zero)),
        }
    }
    let there = substitute(graph, id, &values);
    graph.is_zero(there) || multiple(graph, id, side.value).is_some()
}

/// Returns the number r with e = r f; `None` if it does not exist.
fn multiple(graph: &Graph, e: ExprId, f: ExprId) -> Option<Number> {
    if e == f {
        return Some(Number::ONE);
    }
    let (Node::Sum { constant: a, terms: e }, Node::Sum { constant: b, terms: f }) =
        (graph.node(e), graph.node(f))
    else {
        return None;
    };
    let ratio = &e.first()?.1 * &f.first()?.1.reciprocal()?;
    let is_multiple = |((e, a), (f, b)): (&(ExprId, Number), &(ExprId, Number))| e == f && *a == &ratio * b;
    (e.len() == f.len() && *a == &ratio * b && e.iter().zip(f).all(is_multiple)).then_some(ratio)
}
