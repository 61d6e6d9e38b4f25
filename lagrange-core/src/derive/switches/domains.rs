//! Domains of expressions on fixed sides of switches.
//!
//! A step evaluates states beyond a surface before the surface is located within it. |x|^(3/2)
//! written as (s x)^(3/2) would be undefined there, and so would the first branch of
//! `if x > 0 { sqrt(x) } else { 0 }`. An argument with a restricted domain is therefore brought
//! back into it. This is only done beyond the surfaces that the argument depends on or that choose
//! its branch:
//!
//! | argument | beyond one of its surfaces |
//! |---|---|
//! | of fractional powers, roots and logarithms | its magnitude |
//! | of `asin` and `acos` | the nearest number from −1 to 1 |
//! | of tables with `outside: error` | the nearest number between their ends |
//! | of functions of the user's crate | as much before the surface as it would be beyond |
//!
//! On the sides themselves the values are those of the declaration, including NaN, and they are
//! continuous across the surfaces. An expression that is singular at its surface, such as
//! |x|^(−1/2), has no value beyond: no step crosses it. Where max(a, x)^(−1/2) becomes a^(−1/2),
//! nothing is singular, and the base is treated like that of a root. x |x|^(−1/2) is not singular,
//! as s |x|^(1/2) shows, and neither is x |x|^(p − 1) for positive p.

use super::Side;
use super::poles::{vanishes, without_removable_poles};
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::{Domain, row};
use lagrange_expr::expr::{ExprId, Function, Graph, Node, Relation};
use lagrange_expr::functions::{apply, is_restricted};
use lagrange_expr::number::Number;
use lagrange_expr::opaque::{Opaque, Outside};

/// Surfaces beyond which arguments are brought back into domains.
pub(super) struct Domains<'a> {
    sides: &'a HashMap<ExprId, Side>,
    /// Surfaces that choose between restricted nodes.
    chosen_by: HashMap<ExprId, Vec<Side>>,
}

impl<'a> Domains<'a> {
    /// Finds the surfaces that choose between nodes. `sides` are the sides of the nodes that
    /// switch.
    pub(super) fn new(graph: &Graph, ids: &[ExprId], sides: &'a HashMap<ExprId, Side>) -> Self {
        let mut chosen_by: HashMap<ExprId, Vec<Side>> = HashMap::default();
        if ids.iter().any(|&id| has_domain(graph, id)) {
            for &id in ids {
                let Some(&side) = sides.get(&id) else { continue };
                let chosen = graph.reachable(&branches(graph, id));
                for inner in chosen.into_iter().filter(|&inner| has_domain(graph, inner)) {
                    include(chosen_by.get_or_insert_with(inner, Vec::new), side);
                }
            }
        }
        Domains { sides, chosen_by }
    }

    /// Rebuilds a node with its argument kept in the domain; `None` if the node has no restricted
    /// argument.
    pub(super) fn keep(
        &self,
        graph: &mut Graph,
        id: ExprId,
        map: impl Fn(ExprId) -> ExprId,
    ) -> Option<ExprId> {
        match graph.node(id).clone() {
            Node::Product(factors) if is_restricted(graph, id) || has_power(graph, &factors) => {
                let factors = without_removable_poles(graph, self.sides, &factors, &map);
                let kept = factors.into_iter().map(|(base, exponent)| {
                    let kept = match (exponent.is_integer(), exponent.is_negative()) {
                        (true, _) => map(base),
                        (false, false) => self.kept(graph, id, base, Domain::FromZero, &map),
                        (false, true) => self.kept_off_poles(graph, id, base, &map),
                    };
                    (kept, exponent)
                });
                let kept = kept.collect::<Vec<_>>();
                Some(graph.product(kept))
            }
            Node::Call(function, arguments) if is_restricted(graph, id) => {
                let mut mapped = arguments.iter().map(|&argument| map(argument)).collect::<Vec<_>>();
                let domain = row(function).domain;
                let kept = self.kept(graph, id, arguments[0], domain, &map);
                mapped[0] = match domain {
                    Domain::BaseAboveZero => {
                        let (zero, off_poles) =
                            (graph.number(0), self.kept_off_poles(graph, id, arguments[0], &map));
                        graph.choose(Relation::Less, zero, mapped[1], kept, off_poles)
                    }
                    _ => kept,
                };
                Some(apply(graph, function, &mapped))
            }
            Node::Opaque(function, arguments) if function.table().is_some() => {
                self.within_table(graph, id, (&function, &arguments), &map)
            }
            Node::Opaque(function, arguments) if has_domain(graph, id) => {
                let kept = arguments.iter().map(|&argument| self.kept_on_side(graph, id, argument, &map));
                let kept = kept.collect::<Vec<_>>();
                Some(graph.opaque(function, &kept))
            }
            _ => None,
        }
    }

    /// Returns an argument of a function without a formula, whose domain is unknown. Beyond a
    /// surface the argument retains values of its side. It is reflected if it is affine in the
    /// distance. It is as declared if it turns back at the surface, as |x| does.
    fn kept_on_side(
        &self,
        graph: &mut Graph,
        id: ExprId,
        argument: ExprId,
        map: &impl Fn(ExprId) -> ExprId,
    ) -> ExprId {
        let mut kept = map(argument);
        for side in self.surfaces(graph, id, argument) {
            let inside = match slope_along(graph, argument, side.value) {
                Some(slope) => {
                    let change = graph.scale(&slope * &Number::from(-2), side.value);
                    graph.add(kept, change)
                }
                None if self.turns_back(graph, argument, side) => argument,
                None => continue,
            };
            kept = beyond(graph, side, inside, kept);
        }
        kept
    }

    /// True if an expression depends on a surface only through magnitudes, minima and maxima.
    fn turns_back(&self, graph: &Graph, id: ExprId, side: Side) -> bool {
        let of_side = |part: &ExprId| self.sides.get(part).is_some_and(|own| own.value == side.value);
        let mut parts = graph.reachable(&[id]).into_iter().filter(of_side).peekable();
        parts.peek().is_some()
            && parts.all(|part| {
                matches!(graph.node(part), Node::Call(Function::Abs | Function::Min | Function::Max, _))
            })
    }

    /// Rebuilds a call of a table with `outside: error`; `None` for other tables.
    fn within_table(
        &self,
        graph: &mut Graph,
        id: ExprId,
        (function, arguments): (&Opaque, &[ExprId]),
        map: &impl Fn(ExprId) -> ExprId,
    ) -> Option<ExprId> {
        let table = function.table().filter(|table| table.outside == Outside::Error)?;
        let mut inside = Vec::with_capacity(arguments.len());
        for (&argument, axis) in arguments.iter().zip(&table.axes) {
            let (mapped, surfaces) = (map(argument), self.surfaces(graph, id, argument));
            if surfaces.is_empty() {
                inside.push(mapped);
                continue;
            }
            let (first, last) = (exact(graph, *axis.knots.first()?)?, exact(graph, *axis.knots.last()?)?);
            let bounded = graph.call(Function::Max, &[first, mapped]);
            let bounded = graph.call(Function::Min, &[last, bounded]);
            inside.push(surfaces.into_iter().fold(mapped, |rest, side| beyond(graph, side, bounded, rest)));
        }
        Some(graph.opaque(function.clone(), &inside))
    }

    /// Returns an argument of a node as declared on its sides, and within the domain beyond them.
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
        surfaces.into_iter().fold(mapped, |rest, side| beyond(graph, side, inside, rest))
    }

    /// Returns the base of a negative power, made positive beyond surfaces where it does not
    /// vanish. There it is as declared if that is never negative, else its magnitude.
    fn kept_off_poles(
        &self,
        graph: &mut Graph,
        id: ExprId,
        base: ExprId,
        map: &impl Fn(ExprId) -> ExprId,
    ) -> ExprId {
        let mapped = map(base);
        let mut surfaces = self.surfaces(graph, id, base);
        surfaces.retain(|side| !vanishes(graph, self.sides, base, *side));
        if surfaces.is_empty() {
            return mapped;
        }
        let inside = match graph.is_nonnegative(base) {
            true => base,
            false => graph.call(Function::Abs, &[mapped]),
        };
        surfaces.into_iter().fold(mapped, |rest, side| beyond(graph, side, inside, rest))
    }

    /// Returns the surfaces that an argument of a node depends on, and those that choose the node.
    fn surfaces(&self, graph: &Graph, id: ExprId, argument: ExprId) -> Vec<Side> {
        let mut surfaces = self.chosen_by.get(&id).cloned().unwrap_or_default();
        for part in graph.reachable(&[argument]) {
            if let Some(&side) = self.sides.get(&part) {
                include(&mut surfaces, side);
            }
        }
        surfaces
    }
}

/// Returns the number r for which e − r f does not change in motion.
fn slope_along(graph: &mut Graph, e: ExprId, f: ExprId) -> Option<Number> {
    let moving = |graph: &Graph, id: ExprId| {
        let terms = match graph.node(id) {
            Node::Sum { terms, .. } => terms.to_vec(),
            _ => vec![(id, Number::ONE)],
        };
        terms.into_iter().find(|(term, _)| !graph.dependencies(*term).is_constant_in_motion())
    };
    let ((term, a), (other, b)) = (moving(graph, e)?, moving(graph, f)?);
    let slope = &a * &b.reciprocal()?;
    let multiple = graph.scale(-&slope, f);
    let rest = graph.add(e, multiple);
    (term == other && graph.dependencies(rest).is_constant_in_motion()).then_some(slope)
}

/// True if a factor is a power whose exponent is not a number.
fn has_power(graph: &Graph, factors: &[(ExprId, Number)]) -> bool {
    factors.iter().any(|(base, _)| matches!(graph.node(*base), Node::Call(Function::Power, _)))
}

/// True if a node has an argument that must lie in a domain.
fn has_domain(graph: &Graph, id: ExprId) -> bool {
    is_restricted(graph, id) || matches!(graph.node(id), Node::Opaque(function, _) if !function.is_solution())
}

/// Chooses `inside` beyond a surface and `rest` elsewhere.
fn beyond(graph: &mut Graph, side: Side, inside: ExprId, rest: ExprId) -> ExprId {
    let (zero, distance) = (graph.number(0), graph.multiply(side.sign, side.value));
    graph.choose(Relation::Less, distance, zero, inside, rest)
}

/// Returns a finite number as an expression.
fn exact(graph: &mut Graph, number: f64) -> Option<ExprId> {
    let magnitude = Number::parse_decimal(&format!("{}", number.abs()))?;
    Some(graph.number(if number < 0.0 { -&magnitude } else { magnitude }))
}

/// Returns the expressions that a node chooses from.
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

/// Adds a surface unless it is already included.
fn include(surfaces: &mut Vec<Side>, side: Side) {
    if surfaces.iter().all(|known| known.value != side.value) {
        surfaces.push(side);
    }
}
