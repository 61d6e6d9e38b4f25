//! Names for the shared parts of expressions that are too long to be written out.

use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::elementary::row;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Maximum length of shared parts that are repeated rather than named.
const LONGEST_REPEATED: usize = 24;
/// Assumed length of a name.
const NAME_LENGTH: usize = 4;

/// Returns names with their expressions, each before its first use, and the texts of `roots`.
/// `write` writes all of them with the names that it receives.
pub(super) fn define(
    graph: &Graph,
    roots: &[ExprId],
    max_length: usize,
    write: impl for<'n> Fn(ExprId, &dyn Fn(ExprId) -> Option<&'n str>) -> String,
) -> (Vec<(String, String)>, Vec<String>) {
    let names = common_parts(graph, roots, max_length);
    let name_of = |id: ExprId| names.get(&id).map(String::as_str);
    let root = |&id: &ExprId| name_of(id).map_or_else(|| write(id, &name_of), str::to_owned);
    let definitions = names.iter().map(|(&id, name)| (name.clone(), write(id, &name_of))).collect();
    (definitions, roots.iter().map(root).collect())
}

/// Names parts of `roots`, in an order in which no part contains a later one. There are no names if
/// the roots written out have at most about `max_length` characters.
fn common_parts(graph: &Graph, roots: &[ExprId], max_length: usize) -> OrderedMap<ExprId, String> {
    let parts = graph.reachable(roots);
    let mut names = OrderedMap::default();
    let mut lengths: HashMap<ExprId, usize> = HashMap::default();
    for &id in &parts {
        lengths.insert(id, length(graph, id, &lengths));
    }
    let length_of = |root: &ExprId| lengths.get(root).copied().unwrap_or(0);
    if roots.iter().map(length_of).fold(0, usize::saturating_add) <= max_length {
        return names;
    }
    let prefix = free_prefix(graph, &parts);
    let uses = count_uses(graph, &parts, roots);
    for &id in &parts {
        let mut length = length(graph, id, &lengths);
        if length > LONGEST_REPEATED && uses.get(&id).is_some_and(|&uses| uses > 1) {
            names.insert(id, format!("{prefix}{}", names.len() + 1));
            length = NAME_LENGTH;
        }
        lengths.insert(id, length);
    }
    names
}

fn count_uses(graph: &Graph, parts: &[ExprId], roots: &[ExprId]) -> HashMap<ExprId, usize> {
    let mut uses: HashMap<ExprId, usize> = HashMap::default();
    let mut count = |id| *uses.get_or_insert_with(id, || 0) += 1;
    roots.iter().copied().for_each(&mut count);
    for &id in parts {
        graph.node(id).for_each_child(&mut count);
    }
    uses
}

/// Finds a prefix such that no symbol's name is this prefix followed by a number.
fn free_prefix(graph: &Graph, parts: &[ExprId]) -> String {
    let is_taken = |prefix: &str| {
        parts.iter().any(|&id| match graph.node(id) {
            Node::Symbol(symbol) => {
                let rest = graph.symbols().get(*symbol).name.strip_prefix(prefix);
                rest.is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
            }
            _ => false,
        })
    };
    let mut prefix = String::from("c");
    while is_taken(&prefix) {
        prefix.push('c');
    }
    prefix
}

/// Estimates the number of characters of an expression from those of its operands.
fn length(graph: &Graph, id: ExprId, known: &HashMap<ExprId, usize>) -> usize {
    let node = graph.node(id);
    let shown = |weighted: &[(ExprId, Number)]| weighted.iter().filter(|(_, w)| !w.abs().is_one()).count();
    let own = match node {
        Node::Number(_) | Node::Pi => 3,
        Node::Symbol(symbol) => {
            let symbol = graph.symbols().get(*symbol);
            symbol.name.len() + if symbol.dots > 0 { 5 } else { 0 }
        }
        Node::Sum { terms, .. } => 3 * terms.len() + 2 * shown(terms),
        Node::Product(factors) => factors.len() + 2 * shown(factors),
        Node::Call(function, _) => row(*function).name.len() + 2,
        Node::Opaque(function, _) => function.text().len() + 2,
        Node::Choose { .. } => 20,
    };
    let mut length = own;
    node.for_each_child(|child| {
        length = length.saturating_add(known.get(&child).copied().unwrap_or(NAME_LENGTH));
    });
    length
}
