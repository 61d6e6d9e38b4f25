//! The graph of expressions in the dot language of Graphviz.

use std::fmt::Write;

use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::row;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Graph of what the roots are made of, operands below; edges carry coefficients and exponents other than one.
/// Nodes are numbered from the leaves, so that equal systems give equal text.
pub fn graph(graph: &Graph, roots: &[ExprId]) -> String {
    let parts = graph.reachable(roots);
    let numbers = parts.iter().enumerate().map(|(number, &id)| (id, number)).collect::<HashMap<_, _>>();
    let number_of = |id: ExprId| numbers.get(&id).copied().unwrap_or_default();
    let mut text = String::from("digraph expressions {\n    node [shape=box];\n");
    for &id in &parts {
        let (node, number) = (graph.node(id), number_of(id));
        let style = if roots.contains(&id) { ", peripheries=2" } else { "" };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "    n{number} [label=\"{}\"{style}];", escaped(&label(graph, node)));
        for (child, label) in edges(node) {
            let _ = writeln!(text, "    n{number} -> n{}{};", number_of(child), attribute(&label));
        }
    }
    text.push_str("}\n");
    text
}

fn label(graph: &Graph, node: &Node) -> String {
    match node {
        Node::Number(value) => value.to_string(),
        Node::Pi => "pi".to_owned(),
        Node::Symbol(symbol) => graph.symbols().get(*symbol).text(),
        Node::Sum { constant, .. } if constant.is_zero() => "+".to_owned(),
        Node::Sum { constant, .. } => format!("{constant} +"),
        Node::Product(_) => "*".to_owned(),
        Node::Call(function, _) => row(*function).name.to_owned(),
        Node::Opaque(function, _) => function.text(),
        Node::Choose { relation, .. } => format!("if {}", relation.symbol()),
    }
}

/// Operands, each with what is written at its edge.
fn edges(node: &Node) -> Vec<(ExprId, String)> {
    let weighted = |operands: &[(ExprId, Number)], prefix: &str| {
        let mark = |w: &Number| if w.is_one() { String::new() } else { format!("{prefix}{w}") };
        operands.iter().map(|(id, weight)| (*id, mark(weight))).collect()
    };
    match node {
        Node::Number(_) | Node::Pi | Node::Symbol(_) => Vec::new(),
        Node::Sum { terms, .. } => weighted(terms, ""),
        Node::Product(factors) => weighted(factors, "^"),
        Node::Call(_, arguments) | Node::Opaque(_, arguments) => {
            arguments.iter().map(|id| (*id, String::new())).collect()
        }
        Node::Choose { left, right, then, otherwise, .. } => {
            let operands = [(*left, "left"), (*right, "right"), (*then, "then"), (*otherwise, "else")];
            operands.map(|(id, label)| (id, label.to_owned())).to_vec()
        }
    }
}

fn attribute(label: &str) -> String {
    if label.is_empty() { String::new() } else { format!(" [label=\"{}\"]", escaped(label)) }
}

fn escaped(label: &str) -> String {
    label.replace('\\', "\\\\").replace('"', "\\\"")
}
