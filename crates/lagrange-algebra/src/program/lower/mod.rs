//! Lowering of expressions to a program.
//!
//! A traversal in ascending order of ids, children before parents, assigns a value to each
//! expression. The form of the code is chosen for each sum ([`sum`]) and each product
//! ([`product`]). Before the traversal, [`sharing`] finds the reciprocals worth sharing. It also
//! finds expressions without a separate value, because their only user splits them. The cost is
//! proportional to the size of the outputs.

mod interleaved;
mod lowering;
mod power;
mod product;
mod sharing;
mod sum;

use std::f64::consts::PI;

use super::builder::Builder;
use super::ir::{Float, Op, Program};
use super::labels::Labels;
use crate::calculus::Grades;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;
use lowering::{Lowering, Signed};
pub use power::is_written_out;
use product::lower_product;
use sharing::Sharing;
use sum::lower_sum;

/// π less the nearest `f64`.
const PI_REMAINDER: f64 = 1.224_646_799_147_353_2e-16;

/// Lowers `outputs` to a program, whose values are named after the labels of their expressions.
pub fn lower(graph: &Graph, outputs: &[ExprId], labels: &Labels) -> Program {
    let reachable = graph.reachable(outputs);
    let sharing = Sharing::of(graph, &reachable, outputs, labels);
    let opposites = opposite_labels(graph, labels);
    let (builder, values) = (Builder::new(), HashMap::default());
    let grades = Grades::of(graph, outputs);
    let mut lowering = Lowering { graph, labels, opposites, sharing, grades, builder, values };
    for id in reachable {
        if !lowering.sharing.is_merged(id) {
            let value = lower_named(&mut lowering, id);
            lowering.values.insert(id, value);
        }
    }
    let outputs = outputs.iter().map(|&output| lowering.plain(output)).collect::<Vec<_>>();
    lowering.builder.finish(&outputs)
}

/// Returns the names of opposites of sums, so that a sum can be computed with the sign that has a
/// name.
fn opposite_labels<'a>(graph: &Graph, labels: &'a Labels) -> HashMap<ExprId, &'a str> {
    let opposite = |(id, name): (ExprId, &'a str)| match graph.split_coefficient(id) {
        (sign, sum) if sign == Number::MINUS_ONE && labels.get(sum).is_none() => Some((sum, name)),
        _ => None,
    };
    labels.iter().filter_map(opposite).collect()
}

/// Lowers a node and names its value.
fn lower_named(lowering: &mut Lowering<'_>, id: ExprId) -> Signed {
    let signed = lower_node(lowering, id);
    if let Some(name) = lowering.labels.get(id) {
        let value = lowering.with_sign(signed);
        lowering.builder.propose_name(value, name);
        return Signed::positive(value);
    }
    if let (true, Some(name)) = (signed.negative, lowering.opposites.get(&id)) {
        lowering.builder.propose_name(signed.value, name);
    }
    signed
}

fn lower_node(lowering: &mut Lowering<'_>, id: ExprId) -> Signed {
    let graph = lowering.graph;
    Signed::positive(match graph.node(id) {
        Node::Number(value) => lowering.builder.constant(value.clone()),
        Node::Pi => lowering.builder.push(Op::Float(Float::with_remainder(PI, PI_REMAINDER))),
        Node::Symbol(symbol) => lowering.builder.push(Op::Input(graph.symbols().get(*symbol).role)),
        Node::Sum { constant, terms } => {
            let prefers_opposite = lowering.opposites.contains(&id);
            return lower_sum(lowering, constant, terms, prefers_opposite);
        }
        Node::Product(_) => return lower_product(lowering, &Number::ONE, id),
        Node::Call(function, arguments) => {
            let arguments = arguments.iter().map(|&argument| lowering.plain(argument)).collect();
            let function = match function {
                Function::MagnitudeSlope => Function::Sign,
                function => *function,
            };
            lowering.builder.push(Op::Call(function, arguments))
        }
        Node::Opaque(function, arguments) => {
            let arguments = arguments.iter().map(|&argument| lowering.plain(argument)).collect();
            lowering.builder.push(Op::Opaque(function.clone(), arguments))
        }
        Node::Choose { relation, left, right, then, otherwise } => {
            let [left, right] = [lowering.plain(*left), lowering.plain(*right)];
            let [then, otherwise] = [lowering.plain(*then), lowering.plain(*otherwise)];
            lowering.builder.push(Op::Select { relation: *relation, left, right, then, otherwise })
        }
    })
}
