//! Total time derivative.

use crate::calculus::partials;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Treatment of accelerations, the rates of velocities.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AccelerationTerms {
    /// The acceleration of the same coordinate.
    Kept,
    /// Zero: a derivative is its value at zero acceleration.
    Dropped,
}

/// Total time derivatives of expressions, each computed once.
///
/// Coordinates change with their velocities, other positions as defined in the graph, and time with
/// rate one. Parameters do not change. Inputs, whose rates are unknown, are treated as constant;
/// callers must check for them first if necessary.
#[derive(Debug)]
pub struct Rates {
    accelerations: AccelerationTerms,
    known: HashMap<ExprId, ExprId>,
}

impl Rates {
    /// Creates an empty set of rates.
    pub fn new(accelerations: AccelerationTerms) -> Rates {
        Rates { accelerations, known: HashMap::default() }
    }

    /// Sets the rate of an expression whose shorter form is known.
    pub fn learn(&mut self, id: ExprId, rate: ExprId) {
        self.known.insert(id, rate);
    }

    /// Returns d/dt of an expression.
    pub fn of(&mut self, graph: &mut Graph, root: ExprId) -> ExprId {
        let mut pending = vec![root];
        while let Some(&id) = pending.last() {
            if self.known.contains(&id) {
                pending.pop();
                continue;
            }
            let before = pending.len();
            if Self::changes(graph, id) {
                graph.node(id).for_each_child(|child| {
                    if !self.known.contains(&child) {
                        pending.push(child);
                    }
                });
            }
            if pending.len() == before {
                pending.pop();
                let rate = self.derive(graph, id);
                self.known.insert(id, rate);
            }
        }
        self.known.get(&root).copied().unwrap_or(root)
    }

    fn changes(graph: &Graph, id: ExprId) -> bool {
        let moving =
            Dependencies::TIME | Dependencies::COORDINATE | Dependencies::STATE | Dependencies::VELOCITY;
        graph.dependencies(id).intersects(moving)
    }

    /// Returns the rate of a node whose operands' rates are known.
    fn derive(&self, graph: &mut Graph, id: ExprId) -> ExprId {
        if !Self::changes(graph, id) {
            return graph.number(0);
        }
        let rate_of = |child: &ExprId| self.known.get(child).copied();
        match graph.node(id) {
            Node::Symbol(symbol) => {
                let symbol = graph.symbols().get(*symbol).clone();
                graph
                    .rate_of_position(id)
                    .unwrap_or_else(|| self.rate_of_symbol(graph, &symbol.name, symbol.role))
            }
            Node::Choose { relation, left, right, then, otherwise } => {
                let (relation, left, right) = (*relation, *left, *right);
                let branches = rate_of(then).zip(rate_of(otherwise));
                branches.map_or(id, |(then, otherwise)| graph.choose(relation, left, right, then, otherwise))
            }
            _ => {
                let mut terms = Vec::new();
                for (child, slope) in partials(graph, id) {
                    if let Some(rate) = rate_of(&child) {
                        terms.push((graph.multiply(slope, rate), Number::ONE));
                    }
                }
                graph.sum(Number::ZERO, terms)
            }
        }
    }

    fn rate_of_symbol(&self, graph: &mut Graph, name: &str, role: Role) -> ExprId {
        match (role, self.accelerations) {
            (Role::Time, _) => graph.number(1),
            (Role::Coordinate(i), _) => graph.symbol(name, Role::Velocity(i)),
            (Role::Velocity(i), AccelerationTerms::Kept) => graph.symbol(name, Role::Acceleration(i)),
            _ => graph.number(0),
        }
    }
}
