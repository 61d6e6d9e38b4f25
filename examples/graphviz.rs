//! The graph of expressions behind an acceleration, in the dot language of Graphviz.
//!
//! Expressions are stored once, however often they are used. Look for shared operands, for
//! coefficients and exponents at the edges, and for the double frame around the root.
//!
//! `cargo run --features symbolic --example graphviz -- FILE | dot -Tsvg` draws all accelerations
//! of the declaration in a file.

use std::collections::HashMap;
use std::error::Error;
use std::fmt::Write;
use std::{env, fs};

use lagrange::symbolic::derive::StrategyChoice;
use lagrange::symbolic::elementary::row;
use lagrange::symbolic::expr::{ExprId, Graph, Node};
use lagrange::symbolic::number::Number;
use lagrange::symbolic::pipeline::parse;

const PENDULUM: &str = "
    pub struct Pendulum;
    param l = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * (l * dot(theta))^2;
    potential = -g * l * cos(theta);
";

/// θ̈ = −g/l sin θ.
const EXPECTED: &str = r#"digraph expressions {
    node [shape=box];
    n0 [label="l"];
    n1 [label="g"];
    n2 [label="theta"];
    n3 [label="sin"];
    n3 -> n2;
    n4 [label="*"];
    n4 -> n0 [label="^-1"];
    n4 -> n1;
    n4 -> n3;
    n5 [label="+", peripheries=2];
    n5 -> n4 [label="-1"];
}
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let file = env::args().nth(1);
    let text = file.as_ref().map_or_else(|| Ok(PENDULUM.to_owned()), fs::read_to_string)?;
    let derived = parse(&text)?.derive(StrategyChoice::Cheapest)?;
    let graph = graph(&derived.model.graph, &derived.equations.accelerations);
    print!("{graph}");
    assert!(file.is_some() || graph == EXPECTED, "the graph of the pendulum has changed");
    Ok(())
}

/// Writes the graph of the roots, operands below; edges carry coefficients and exponents other than
/// one.
///
/// Nodes are numbered from the leaves, so that equal systems give equal text.
fn graph(graph: &Graph, roots: &[ExprId]) -> String {
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

/// Returns the operands of a node, each with the label of its edge.
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
