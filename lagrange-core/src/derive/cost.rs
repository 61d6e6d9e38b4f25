//! A rough estimate of evaluation time, used to choose between ways of computing the same
//! expressions.
//!
//! Processors overlap independent operations, but not dependent ones. The time therefore grows with
//! the number of operations and with their longest dependency chain. Weights are latencies and
//! costs on current processors, in cycles.

use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Latency of an addition or a multiplication: four cycles on Intel cores since Skylake, three to
/// four on Zen (Fog, *Instruction tables*).
const ARITHMETIC: u32 = 4;
/// Latency of a division: the lower end of the range in those tables. A square root takes slightly
/// longer.
const DIVISION: u32 = 13;
/// Number of operations that an elementary function counts for: argument reduction and a
/// polynomial.
const FUNCTION: u32 = 20;

/// Operations and latency of one node.
struct Weight {
    operations: u32,
    latency: u32,
}

/// Returns the number of operations, with functions weighted, plus the cycles of the longest chain.
pub(super) fn cost(graph: &Graph, roots: &[ExprId]) -> f64 {
    let mut ready_at: HashMap<ExprId, u32> = HashMap::default();
    let (mut operations, mut longest) = (0, 0);
    for id in graph.reachable(roots) {
        let weight = weight(graph.node(id));
        let mut start = 0;
        graph.node(id).for_each_child(|child| {
            start = start.max(ready_at.get(&child).copied().unwrap_or(0));
        });
        let end = start.saturating_add(weight.latency);
        ready_at.insert(id, end);
        operations += weight.operations;
        longest = longest.max(end);
    }
    f64::from(operations) + f64::from(longest)
}

fn weight(node: &Node) -> Weight {
    match node {
        Node::Number(_) | Node::Pi | Node::Symbol(_) => Weight { operations: 0, latency: 0 },
        Node::Sum { constant, terms } => {
            let scaled = terms.iter().filter(|(_, c)| !c.abs().is_one()).count();
            let additions = terms.len() - usize::from(constant.is_zero());
            // Only the last operand to become ready adds to the latency.
            let latency = ARITHMETIC * (u32::from(additions > 0) + u32::from(scaled > 0));
            Weight { operations: (additions + scaled) as u32, latency }
        }
        Node::Product(factors) => product(factors),
        Node::Call(..) | Node::Opaque(..) => Weight { operations: FUNCTION, latency: FUNCTION },
        Node::Choose { .. } => Weight { operations: 2, latency: ARITHMETIC },
    }
}

fn product(factors: &[(ExprId, Number)]) -> Weight {
    let mut operations = factors.len() as u32 - 1;
    let mut latency = if factors.len() > 1 { ARITHMETIC } else { 0 };
    for (_, exponent) in factors {
        match exponent.to_i32() {
            Some(1) => {}
            Some(2..) => operations += 1,
            _ => {
                // The throughput of divisions is lower than that of additions, even if nothing
                // depends on them.
                operations += 5;
                latency = latency.max(ARITHMETIC + DIVISION);
            }
        }
    }
    Weight { operations, latency }
}
