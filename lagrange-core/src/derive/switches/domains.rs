//! Domains of what is written on fixed sides of switches.
//!
//! A step looks at states beyond a surface before the surface is located in it. |x|^(3/2) written as (s x)^(3/2) would have no value
//! there, nor would the first branch of `if x > 0 { sqrt(x) } else { 0 }`. So an argument that a function restricts is brought
//! back into the domain beyond the surfaces that it depends on or is chosen by, and nowhere else:
//!
//! | argument | beyond one of its surfaces |
//! |---|---|
//! | of fractional powers, roots and logarithms | its magnitude |
//! | of `asin` and `acos` | the nearest number from −1 to 1 |
//!
//! On the sides themselves the values are those of the declaration, NaN included, and they are continuous across the surfaces.
//! What is singular at its surface, as |x|^(−1/2) is, has no value beyond: no step leads across. x |x|^(−1/2) is
//! not singular, as s |x|^(1/2) shows.

use super::Side;
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::{Domain, row};
use lagrange_expr::expr::{ExprId, Function, Graph, Node, Relation};
use lagrange_expr::functions::{apply, is_restricted};
use lagrange_expr::number::Number;

/// Surfaces beyond which arguments are brought back into domains.
pub(super) struct Domains<'a> {
    sides: &'a HashMap<ExprId, Side>,
    /// Surfaces by which restricted nodes are chosen.
    chosen_by: HashMap<ExprId, Vec<Side>>,
}

impl<'a> Domains<'a> {
    /// Finds the surfaces by which nodes are chosen. `sides` are those of the nodes that switch.
    pub(super) fn new(graph: &Graph, ids: &[ExprId], sides: &'a HashMap<ExprId, Side>) -> Self {
        let mut chosen_by: HashMap<ExprId, Vec<Side>> = HashMap::default();
        if ids.iter().any(|&id| is_restricted(graph, id)) {
            for &id in ids {
                let Some(&side) = sides.get(&id) else { continue };
                let chosen = graph.reachable(&branches(graph, id));
                for inner in chosen.into_iter().filter(|&inner| is_restricted(graph, inner)) {
                    include(chosen_by.get_or_insert_with(inner, Vec::new), side);
                }
            }
        }
        Domains { sides, chosen_by }
    }

    /// Rebuilds a node with its argument kept in the domain; `None` if the node has no restricted argument.
    pub(super) fn keep(
        &self,
        graph: &mut Graph,
        id: ExprId,
        map: impl Fn(ExprId) -> ExprId,
    ) -> Option<ExprId> {
        match graph.node(id).clone() {
            Node::Product(factors) if is_restricted(graph, id) => {
                let factors = self.without_removable_poles(graph, &factors);
                let kept = factors.into_iter().map(|(base, exponent)| match is_root(&exponent) {
                    true => (self.kept(graph, id, base, Domain::FromZero, &map), exponent),
                    false => (map(base), exponent),
                });
                let kept = kept.collect::<Vec<_>>();
                Some(graph.product(kept))
            }
            Node::Call(function, arguments) if is_restricted(graph, id) => {
                let mut mapped = arguments.iter().map(|&argument| map(argument)).collect::<Vec<_>>();
                let domain = row(function).domain;
                let kept = self.kept(graph, id, arguments[0], domain, &map);
                mapped[0] = match domain {
                    // Negative powers are singular on the surface.
                    Domain::BaseAboveZero => {
                        let zero = graph.number(0);
                        graph.choose(Relation::Less, zero, mapped[1], kept, mapped[0])
                    }
                    _ => kept,
                };
                Some(apply(graph, function, &mapped))
            }
            _ => None,
        }
    }

    /// Returns an argument of a node on its sides, and beyond them within the domain.
    fn kept(
        &self,
        graph: &mut Graph,
        id: ExprId,
        argument: ExprId,
        domain: Domain,
        map: &impl Fn(ExprId) -> ExprId,
    ) -> ExprId {
        let mapped = map(argument);
        let is_magnitude = domain != Domain::WithinOne && graph.is_nonnegative(argument);
        match graph.node(argument) {
            _ if is_magnitude && mapped == argument => return mapped,
            Node::Call(Function::Abs, inner) if is_magnitude => {
                let inner = map(inner[0]);
                return graph.magnitude(inner);
            }
            _ if is_magnitude => return graph.call(Function::Abs, &[mapped]),
            _ => {}
        }
        let surfaces = self.surfaces(graph, id, argument);
        if surfaces.is_empty() {
            return mapped;
        }
        let inside = within(graph, mapped, domain);
        let zero = graph.number(0);
        surfaces.into_iter().fold(mapped, |rest, side| {
            let distance = graph.multiply(side.sign, side.value);
            graph.choose(Relation::Less, distance, zero, inside, rest)
        })
    }

    /// Returns the surfaces that an argument of a node is made of, and those that choose the node.
    fn surfaces(&self, graph: &Graph, id: ExprId, argument: ExprId) -> Vec<Side> {
        let mut surfaces = self.chosen_by.get(&id).cloned().unwrap_or_default();
        for part in graph.reachable(&[argument]) {
            if let Some(&side) = self.sides.get(&part) {
                include(&mut surfaces, side);
            }
        }
        surfaces
    }

    /// Writes (c |x|)ᵖ as cᵖ |x|ᵖ where p is negative.
    fn with_magnitudes_apart(
        &self,
        graph: &mut Graph,
        factors: &[(ExprId, Number)],
    ) -> Vec<(ExprId, Number)> {
        let mut apart = Vec::with_capacity(factors.len());
        for (base, power) in factors {
            let (coefficient, core) = graph.split_coefficient(*base);
            let inner = match graph.node(core).clone() {
                Node::Product(inner) if power.is_negative() && !power.is_integer() => inner,
                _ => {
                    apart.push((*base, power.clone()));
                    continue;
                }
            };
            let is_apart = |(part, exponent): &(ExprId, Number)| {
                exponent.is_one()
                    && matches!(graph.node(*part), Node::Call(Function::Abs, _))
                    && self.sides.contains(part)
            };
            let (magnitudes, rest): (Vec<_>, Vec<_>) = inner.iter().cloned().partition(is_apart);
            let rest = graph.product(rest);
            apart.push((graph.scale(coefficient, rest), power.clone()));
            apart.extend(magnitudes.into_iter().map(|(magnitude, _)| (magnitude, power.clone())));
        }
        apart
    }

    /// Writes xᵐ |x|ᵖ as sᵐ |x|ᵐ⁺ᵖ where m + p is positive and p is not.
    fn without_removable_poles(
        &self,
        graph: &mut Graph,
        factors: &[(ExprId, Number)],
    ) -> Vec<(ExprId, Number)> {
        let mut factors = self.with_magnitudes_apart(graph, factors);
        for at in 0..factors.len() {
            let (base, power) = factors[at].clone();
            let Node::Call(Function::Abs, arguments) = graph.node(base) else { continue };
            let Some(&side) = self.sides.get(&base).filter(|_| power.is_negative()) else { continue };
            let is_inner =
                |(other, exponent): &(ExprId, Number)| *other == arguments[0] && exponent.is_integer();
            let Some(inner) = factors.iter().position(is_inner) else { continue };
            let whole = factors[inner].1.clone();
            let total = &power + &whole;
            if !total.is_integer() && !total.is_negative() {
                factors[at].1 = total;
                factors[inner] = (side.slope(graph), whole);
            }
        }
        factors
    }
}

/// True if a power with this exponent is a root without a pole.
fn is_root(exponent: &Number) -> bool {
    !exponent.is_integer() && !exponent.is_negative()
}

/// Returns the expressions of which a node chooses one.
fn branches(graph: &Graph, id: ExprId) -> Vec<ExprId> {
    match graph.node(id) {
        Node::Choose { then, otherwise, .. } => vec![*then, *otherwise],
        Node::Call(Function::Min | Function::Max, arguments) => arguments.to_vec(),
        _ => Vec::new(),
    }
}

/// Brings an argument into a domain.
fn within(graph: &mut Graph, argument: ExprId, domain: Domain) -> ExprId {
    match domain {
        Domain::WithinOne => {
            let [below, above] = [-1, 1].map(|bound| graph.number(bound));
            let bounded = graph.call(Function::Max, &[below, argument]);
            graph.call(Function::Min, &[above, bounded])
        }
        _ => graph.call(Function::Abs, &[argument]),
    }
}

/// Adds a surface that is not there yet.
fn include(surfaces: &mut Vec<Side>, side: Side) {
    if surfaces.iter().all(|known| known.value != side.value) {
        surfaces.push(side);
    }
}
