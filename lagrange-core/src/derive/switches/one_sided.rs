//! Expressions on fixed sides of switches.

use super::domains::Domains;
use super::{Side, Switch, surface};
use lagrange_algebra::calculus::rebuild;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node, Relation};

/// Maps the parts of the roots, including themselves, to expressions with the sides of the switches
/// as symbols. Parts without switches stay unchanged.
pub fn one_sided(graph: &mut Graph, switches: &[Switch], roots: &[ExprId]) -> HashMap<ExprId, ExprId> {
    let ids = graph.reachable(roots);
    let sides = sides(graph, switches, &ids);
    let domains = Domains::new(graph, &ids, &sides);
    let mut image: HashMap<ExprId, ExprId> = HashMap::default();
    for id in ids {
        let map = |child: ExprId| image.get(&child).copied().unwrap_or(child);
        let new = match sides.get(&id) {
            Some(side) => on_side(graph, id, *side, map),
            None => domains.keep(graph, id, map).unwrap_or_else(|| rebuild(graph, id, map)),
        };
        image.insert(id, new);
    }
    image
}

/// Returns the side of each node that is not smooth at one of the switches.
fn sides(graph: &mut Graph, switches: &[Switch], ids: &[ExprId]) -> HashMap<ExprId, Side> {
    let signs = switches.iter().map(|switch| (switch.value, switch.side)).collect::<HashMap<_, _>>();
    let mut sides = HashMap::default();
    for &id in ids {
        if let Some(surface) = surface(graph, id, &[])
            && let Some(&sign) = signs.get(&surface.value)
        {
            sides.insert(id, Side { value: surface.value, sign, is_opposite: surface.is_opposite });
        }
    }
    sides
}

/// Writes a node that is not smooth on this side of its surface.
fn on_side(graph: &mut Graph, id: ExprId, side: Side, map: impl Fn(ExprId) -> ExprId) -> ExprId {
    let zero = graph.number(0);
    let (left, right) = if side.is_opposite { (zero, side.sign) } else { (side.sign, zero) };
    let (relation, then, otherwise) = match graph.node(id).clone() {
        Node::Call(Function::Min, arguments) => (Relation::Less, arguments[0], arguments[1]),
        Node::Call(Function::Max, arguments) => (Relation::Less, arguments[1], arguments[0]),
        Node::Choose { relation, then, otherwise, .. } => (relation, then, otherwise),
        node => {
            let sign = side.slope(graph);
            return match node {
                Node::Call(Function::Abs, arguments) => graph.multiply(sign, map(arguments[0])),
                _ => sign,
            };
        }
    };
    graph.choose(relation, left, right, map(then), map(otherwise))
}
