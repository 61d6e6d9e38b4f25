//! Inertial forces of terms in quasi-velocities.
//!
//! Components along moving axes, such as those of an angular velocity, are affine in the
//! velocities, but they are not rates. Let R(u, q) be a term of the Lagrangian in such nodes u,
//! with the momenta p = ∂R/∂u. Then d/dt ∂R/∂q̇ − ∂R/∂q consists of three parts: ṗ at the nodes u,
//! −∂R/∂q at constant u, and d/dt ∂u/∂q̇ − ∂u/∂q weighted with p. The last part is a sum of local
//! terms. For u = Σ s x + f with coefficients s and a remainder f free of velocities, they are
//!
//! - p ṡ at each part x, which passes p s on to its own parts unless x is a rate,
//! - −p ∂u/∂s at the rate of every factor s and −p at that of f.
//!
//! These are the brackets of Hamel's equations, one at each edge of the graph. No rates of
//! generalised momenta are needed. Sources: Hamel, "Die Lagrange-Eulerschen Gleichungen der
//! Mechanik", Z. Math. Phys. 50 (1904) 1–57; Lurie, *Analytical Mechanics*, §10.1. For a pair that
//! is turned by q, u₁ = c x₁ + s x₂ and u₂ = c x₂ − s x₁, the brackets are ω × p. They are −q̇ p₂
//! at u₁, q̇ p₁ at u₂, and u₁ p₂ − u₂ p₁ at q̇.
//!
//! # A rotating frame in numbers
//!
//! A unit mass at (3, 4) is at rest in axes that turn with q̇ = 2. There u = (−8, 6) is its
//! velocity and, since T is ½ u², its momentum. Both are constant, ṗ = 0, and (−q̇ p₂, q̇ p₁) =
//! (−12, −16) is its acceleration −q̇² (3, 4) towards the axis.

use std::collections::BTreeMap;

use super::gibbs_appell::affine_operands;
use super::plane_rotation::{TurnedPair, turned_back, turned_pairs};
use super::quadratic_form::QuadraticForm;
use super::virtual_displacements::{add_slopes, add_turning};
use crate::model::Model;
use lagrange_algebra::calculus::{AccelerationTerms, Degree, Degrees, Rates, adjoint, partials};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};

/// Terms of a Lagrangian in components that joints turn.
#[derive(Debug)]
pub(super) struct QuasiVelocities {
    terms: ExprId,
    /// Affine nodes that the terms are made of.
    nodes: Vec<ExprId>,
    degrees: Degrees,
    /// Turned pairs, each after the pairs that it depends on.
    pairs: Vec<TurnedPair>,
    /// Velocities that are rates, with the quantities that they are rates of.
    known_rates: HashMap<ExprId, ExprId>,
}

impl QuasiVelocities {
    /// Finds turned pairs. `None` without any, since generalised momenta and their rates are then
    /// as short.
    pub(super) fn find(
        graph: &mut Graph,
        terms: ExprId,
        known_rates: HashMap<ExprId, ExprId>,
    ) -> Option<QuasiVelocities> {
        let mut degrees = Degrees::default();
        degrees.classify(graph, &[terms]);
        let nodes = affine_operands(graph, &degrees, terms);
        let pairs = pairs_among(graph, &degrees, &nodes, &known_rates);
        let is_turned = !pairs.is_empty();
        is_turned.then_some(QuasiVelocities { terms, nodes, degrees, pairs, known_rates })
    }

    /// Adds d/dt ∂R/∂q̇ − ∂R/∂q for the terms R to the linear part of a form.
    pub(super) fn add_terms(
        &self,
        model: &mut Model,
        form: &mut QuadraticForm,
        accelerations: AccelerationTerms,
    ) {
        let (positions, velocities) = (model.positions(), model.velocities());
        let one = model.graph.number(1);
        let variables = [&self.nodes[..], &positions].concat();
        let mut momenta = adjoint(&mut model.graph, &[(self.terms, one)], &variables);
        let forces = momenta.split_off(self.nodes.len());
        add_slopes(model, form, &forces);
        if !model.orientations.is_empty() {
            let momenta = adjoint(&mut model.graph, &[(self.terms, one)], &velocities);
            add_turning(model, form, &momenta);
        }
        let graph = &mut model.graph;
        let mut rates = Rates::new(accelerations);
        self.pairs.iter().for_each(|pair| learn_rates(graph, &mut rates, pair));
        let mut brackets = Brackets::new(self);
        for (&node, &momentum) in self.nodes.iter().zip(&momenta) {
            let rate = rates.of(graph, momentum);
            add_load(graph, form, node, rate);
            brackets.pass(node, momentum);
        }
        brackets.add(graph, form);
    }
}

/// Records u̇₁ = c ẋ₁ + s ẋ₂ + q̇ u₂ and u̇₂ = c ẋ₂ − s ẋ₁ − q̇ u₁.
fn learn_rates(graph: &mut Graph, rates: &mut Rates, pair: &TurnedPair) {
    let [first, second] = pair.turned.each_ref().map(|(id, sign)| graph.scale(sign.clone(), *id));
    let [x, y] = pair.parts.each_ref().map(|(id, sign)| {
        let rate = rates.of(graph, *id);
        graph.scale(sign.clone(), rate)
    });
    let angle_rate = rates.of(graph, pair.angle(graph));
    let opposite = graph.negate(angle_rate);
    for ((id, sign), [f, a, g, b, turning, beside]) in pair.turned.iter().zip([
        [pair.cosine, x, pair.sine, y, angle_rate, second],
        [pair.cosine, y, graph.negate(pair.sine), x, opposite, first],
    ]) {
        let terms = [graph.multiply(f, a), graph.multiply(g, b), graph.multiply(turning, beside)];
        let rate = graph.total(terms);
        rates.learn(*id, graph.scale(sign.clone(), rate));
    }
}

/// Adds a load along an affine node, which may be a multiple of another.
fn add_load(graph: &mut Graph, form: &mut QuadraticForm, node: ExprId, load: ExprId) {
    let (factor, node) = graph.split_coefficient(node);
    let load = graph.scale(factor, load);
    form.add_linear(graph, node, load);
}

/// Momenta during the sweep from quasi-velocities down to rates.
struct Brackets<'a> {
    of: &'a QuasiVelocities,
    /// The pair of each turned variable.
    pair_of: HashMap<ExprId, usize>,
    slopes: Rates,
    momenta: BTreeMap<ExprId, Vec<ExprId>>,
    /// Momenta of turned variables whose partners' momenta are not known yet.
    kept: HashMap<ExprId, ExprId>,
}

impl<'a> Brackets<'a> {
    fn new(of: &'a QuasiVelocities) -> Brackets<'a> {
        let ids = of.pairs.iter().enumerate();
        let pair_of = ids.flat_map(|(n, pair)| pair.turned.iter().map(move |(id, _)| (*id, n))).collect();
        let slopes = Rates::new(AccelerationTerms::Dropped);
        Brackets { of, pair_of, slopes, momenta: BTreeMap::new(), kept: HashMap::default() }
    }

    fn pass(&mut self, node: ExprId, momentum: ExprId) {
        self.momenta.entry(node).or_default().push(momentum);
    }

    /// Adds the contributions of all nodes. Parts have smaller ids, so their momenta are complete
    /// when they are processed.
    fn add(mut self, graph: &mut Graph, form: &mut QuadraticForm) {
        while let Some((node, momenta)) = self.momenta.pop_last() {
            if self.of.known_rates.contains(&node) {
                continue;
            }
            let momentum = graph.total(momenta);
            let Some(&pair) = self.pair_of.get(&node) else {
                self.add_node(graph, form, node, momentum);
                continue;
            };
            let pair = &self.of.pairs[pair];
            let [first, second] = pair.turned.each_ref().map(|(id, _)| *id);
            self.kept.insert(node, momentum);
            // Both momenta are complete only when the smaller of the two ids is processed.
            match node == first.min(second) {
                true => self.add_pair(graph, form, pair),
                false => drop(self.momenta.entry(first.min(second)).or_default()),
            }
        }
    }

    fn add_node(&mut self, graph: &mut Graph, form: &mut QuadraticForm, node: ExprId, momentum: ExprId) {
        for (part, slope) in partials(graph, node) {
            let passed = graph.multiply(momentum, slope);
            if self.of.degrees.of(graph, part) == Degree::Free {
                let rate = self.slopes.of(graph, part);
                let opposite = graph.negate(passed);
                add_load(graph, form, rate, opposite);
                continue;
            }
            let slope_rate = self.slopes.of(graph, slope);
            let load = graph.multiply(momentum, slope_rate);
            add_load(graph, form, part, load);
            self.pass(part, passed);
        }
    }

    fn add_pair(&mut self, graph: &mut Graph, form: &mut QuadraticForm, pair: &TurnedPair) {
        let zero = graph.number(0);
        let [first, second] = pair.turned.each_ref().map(|(id, sign)| {
            let momentum = self.kept.get(id).copied().unwrap_or(zero);
            (graph.scale(sign.clone(), *id), graph.scale(sign.clone(), momentum))
        });
        let angle_rate = self.slopes.of(graph, pair.angle(graph));
        let opposite = graph.negate(angle_rate);
        for (node, rate, momentum) in [(first.0, opposite, second.1), (second.0, angle_rate, first.1)] {
            let load = graph.multiply(rate, momentum);
            add_load(graph, form, node, load);
        }
        let products = [graph.multiply(first.0, second.1), graph.multiply(second.0, first.1)];
        let moment = graph.subtract(products[0], products[1]);
        add_load(graph, form, angle_rate, moment);
        let passed = turned_back(graph, [pair.cosine, pair.sine], [first.1, second.1]);
        for ((part, sign), momentum) in pair.parts.iter().zip(passed) {
            self.pass(*part, graph.scale(sign.clone(), momentum));
        }
    }
}

/// Finds turned pairs among the nodes and their operands.
fn pairs_among(
    graph: &mut Graph,
    degrees: &Degrees,
    nodes: &[ExprId],
    known_rates: &HashMap<ExprId, ExprId>,
) -> Vec<TurnedPair> {
    let mut parts: HashMap<ExprId, Vec<(ExprId, ExprId)>> = HashMap::default();
    // The terms also count as users.
    let mut users: HashMap<ExprId, usize> = nodes.iter().map(|&node| (node, 1)).collect();
    let is_end = |id: ExprId| known_rates.contains(&id) || degrees.of(graph, id) == Degree::Free;
    let found = graph.reachable_until(nodes, is_end);
    let affine = found.into_iter().filter(|&id| degrees.of(graph, id) == Degree::Affine).collect::<Vec<_>>();
    for &id in &affine {
        if known_rates.contains(&id) {
            continue;
        }
        let mut found = partials(graph, id);
        found.retain(|(part, _)| degrees.of(graph, *part) == Degree::Affine);
        found.iter().for_each(|(part, _)| *users.get_or_insert_with(*part, || 0) += 1);
        parts.insert(id, found);
    }
    let mut pairs = turned_pairs(
        graph,
        &affine,
        |id| parts.get(&id).cloned().unwrap_or_default(),
        |id| users.get(&id) == Some(&1),
    );
    // Pairs come after the pairs that they depend on.
    pairs.sort_by_key(|pair| pair.turned[0].0);
    pairs
}

#[cfg(test)]
mod tests;
