//! From expressions to a program.
//!
//! A walk over ascending ids, children before parents, that gives each expression a value. What makes
//! good code is decided per sum ([`sum`]) and per product ([`product`]); which expressions get no value
//! of their own because their only user takes them apart, and which reciprocals are worth sharing, is
//! found beforehand ([`sharing`]). The cost is proportional to what the outputs are made of.

mod product;
mod sharing;
mod sum;

use std::f64::consts::PI;

use super::builder::Builder;
use super::ir::{Float, Op, Program, ValueId};
use super::labels::Labels;
use crate::collections::HashMap;
use crate::expr::{ExprId, Function, Graph, Node};
use crate::number::Number;
use sharing::Sharing;

/// The program that computes `outputs`, its values named after the labels of their expressions.
pub fn lower(graph: &Graph, outputs: &[ExprId], labels: &Labels) -> Program {
    let reachable = graph.reachable(outputs);
    let sharing = Sharing::of(graph, &reachable, outputs, labels);
    let opposites = opposite_labels(graph, labels);
    let (builder, values) = (Builder::new(), HashMap::default());
    let mut lowering = Lowering { graph, labels, opposites, sharing, builder, values };
    for id in reachable {
        if !lowering.sharing.is_merged(id) {
            let value = lowering.named_node(id);
            lowering.values.insert(id, value);
        }
    }
    let outputs = outputs.iter().map(|&output| lowering.plain(output)).collect::<Vec<_>>();
    lowering.builder.finish(&outputs)
}

/// Names of the opposites of sums, so that a sum can be computed with the sign that has a name.
fn opposite_labels<'a>(graph: &Graph, labels: &'a Labels) -> HashMap<ExprId, &'a str> {
    let opposite = |(id, name): (ExprId, &'a str)| match graph.split_coefficient(id) {
        (sign, sum) if sign == Number::MINUS_ONE && labels.get(sum).is_none() => Some((sum, name)),
        _ => None,
    };
    labels.iter().filter_map(opposite).collect()
}

/// A value that stands for an expression or for its opposite: signs are carried along until something
/// absorbs them.
#[derive(Clone, Copy)]
struct Signed {
    value: ValueId,
    negative: bool,
}

impl Signed {
    fn positive(value: ValueId) -> Signed {
        Signed { value, negative: false }
    }
}

struct Lowering<'a> {
    graph: &'a Graph,
    labels: &'a Labels,
    opposites: HashMap<ExprId, &'a str>,
    sharing: Sharing,
    builder: Builder,
    values: HashMap<ExprId, Signed>,
}

impl Lowering<'_> {
    /// What an expression met before was lowered to.
    fn signed(&self, id: ExprId) -> Signed {
        *self.values.get(&id).expect("children come before parents and are merged only where expected")
    }

    /// The value of an expression met before.
    fn plain(&mut self, id: ExprId) -> ValueId {
        let signed = self.signed(id);
        self.with_sign(signed)
    }

    fn with_sign(&mut self, Signed { value, negative }: Signed) -> ValueId {
        if negative { self.builder.negate(value) } else { value }
    }

    /// Lowers a node and names its value.
    fn named_node(&mut self, id: ExprId) -> Signed {
        let signed = self.node(id);
        if let Some(name) = self.labels.get(id) {
            let value = self.with_sign(signed);
            self.builder.propose_name(value, name);
            return Signed::positive(value);
        }
        if let (true, Some(name)) = (signed.negative, self.opposites.get(&id)) {
            self.builder.propose_name(signed.value, name);
        }
        signed
    }

    fn node(&mut self, id: ExprId) -> Signed {
        let graph = self.graph;
        Signed::positive(match graph.node(id) {
            Node::Number(value) => self.builder.constant(value.clone()),
            Node::Pi => self.builder.push(Op::Float(Float::new(PI))),
            Node::Symbol(symbol) => self.builder.push(Op::Input(graph.symbols().get(*symbol).role)),
            Node::Sum { constant, terms } => {
                let prefers_opposite = self.opposites.contains(&id);
                return self.sum(constant, terms, prefers_opposite);
            }
            Node::Product(_) => return self.product(&Number::ONE, id),
            Node::Call(function, arguments) => {
                let arguments = arguments.iter().map(|&argument| self.plain(argument)).collect();
                let function = match function {
                    Function::MagnitudeSlope => Function::Sign,
                    function => *function,
                };
                self.builder.push(Op::Call(function, arguments))
            }
            Node::Choose { relation, left, right, then, otherwise } => {
                let [left, right] = [self.plain(*left), self.plain(*right)];
                let [then, otherwise] = [self.plain(*then), self.plain(*otherwise)];
                self.builder.push(Op::Select { relation: *relation, left, right, then, otherwise })
            }
        })
    }
}
