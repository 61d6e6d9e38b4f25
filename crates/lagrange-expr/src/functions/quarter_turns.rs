//! Sines and cosines of angles that are turned by right angles.

use super::apply;
use crate::expr::{ExprId, Function, Graph, Node};
use crate::number::Number;

/// Rewrites sin(x + k π/2) and cos(x + k π/2) as ± sin x or ± cos x, if the argument has such a
/// term.
///
/// Angles measured from another axis are then the same angles, and no rounded π is subtracted.
pub(super) fn without_quarter_turns(
    graph: &mut Graph,
    function: Function,
    argument: ExprId,
) -> Option<ExprId> {
    let from_sine = match function {
        Function::Sin => 0,
        Function::Cos => 1,
        _ => return None,
    };
    let Node::Sum { terms, .. } = graph.node(argument) else { return None };
    let half_turns = terms.iter().find(|(term, _)| *graph.node(*term) == Node::Pi)?.1.clone();
    let quarters = (&half_turns * &Number::TWO).to_i32()?;
    let pi = graph.pi();
    let turned = graph.scale(half_turns, pi);
    let rest = graph.subtract(argument, turned);
    let position = (i64::from(quarters) + from_sine).rem_euclid(4);
    let function = if position % 2 == 0 { Function::Sin } else { Function::Cos };
    let value = apply(graph, function, &[rest]);
    Some(if position < 2 { value } else { graph.negate(value) })
}
