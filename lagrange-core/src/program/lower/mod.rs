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
use crate::expr::{ExprId, Graph, Node};
use crate::number::Number;
use sharing::Sharing;

/// The program that computes `outputs`, its values named after the labels of their expressions.
pub fn lower(graph: &Graph, outputs: &[ExprId], labels: &Labels) -> Program {
    let reachable = graph.reachable(outputs);
    let sharing = Sharing::of(graph, &reachable, outputs, labels);
    let mut lowering = Lowering { graph, sharing, builder: Builder::new(), values: HashMap::default() };
    for &id in reachable.iter().filter(|id| !lowering.sharing.is_merged(**id)).collect::<Vec<_>>() {
        let value = lowering.node(id);
        lowering.values.insert(id, value);
        if let Some(name) = labels.get(id) {
            lowering.builder.propose_name(value, name);
        }
    }
    let outputs = outputs.iter().map(|&output| lowering.value(output)).collect::<Vec<_>>();
    lowering.builder.finish(&outputs)
}

struct Lowering<'a> {
    graph: &'a Graph,
    sharing: Sharing,
    builder: Builder,
    values: HashMap<ExprId, ValueId>,
}

impl Lowering<'_> {
    /// The value of an expression met before.
    fn value(&self, id: ExprId) -> ValueId {
        *self.values.get(&id).expect("children come before parents and are merged only where expected")
    }

    fn node(&mut self, id: ExprId) -> ValueId {
        let graph = self.graph;
        match graph.node(id) {
            Node::Number(value) => self.builder.constant(value.clone()),
            Node::Pi => self.builder.push(Op::Float(Float::new(PI))),
            Node::Symbol(symbol) => self.builder.push(Op::Input(graph.symbols().get(*symbol).role)),
            Node::Sum { constant, terms } => self.sum(constant, terms),
            Node::Product(_) => self.product(&Number::ONE, id),
            Node::Call(function, arguments) => {
                let arguments = arguments.iter().map(|&argument| self.value(argument)).collect();
                self.builder.push(Op::Call(*function, arguments))
            }
            Node::Choose { relation, left, right, then, otherwise } => {
                let [left, right] = [self.value(*left), self.value(*right)];
                let [then, otherwise] = [self.value(*then), self.value(*otherwise)];
                self.builder.push(Op::Select { relation: *relation, left, right, then, otherwise })
            }
        }
    }
}
