//! The Lagrangian as a quadratic form in velocities, with its linear part.
//!
//! Let T = ½ Σ w u² with u = dx(q, t)/dt. The accelerations a minimise ½ Σ w (u·a)² + Σ (w u̇ + ẇ
//! u)(u·a) − ½ Σ u² (ẇ·a) + (V̇·a) − Σ F (ṗ·a). Here u·a is the part of u that is linear in the
//! velocities, evaluated at a, and rates are evaluated at zero acceleration. This is Gauss's
//! principle (Udwadia and Kalaba, *Analytical Dynamics*, §3). Terms of the Lagrangian of any other
//! form contribute d/dt ∂L/∂v − ∂L/∂q by reverse-mode differentiation. Their second derivatives
//! come from the second-order reverse sweep of Gower and Mello, continued through the nonlinear
//! nodes.
//!
//! # A pendulum in numbers
//!
//! Take m = 1 on a rod of length 5 under g = 10, at sin θ = 3/5 with θ̇ = 1. From x = 5 sin θ and
//! y = −5 cos θ follow ẋ = 4 θ̇ and ẏ = 3 θ̇. At zero acceleration ẍ = −3 and ÿ = 4. The potential
//! has the rate V̇ = 30 θ̇.
//!
//! | node | square | linear part | because |
//! |---|---|---|---|
//! | ẋ | 1 | −3 | w u̇ |
//! | ẏ | 1 | 4 | w u̇ |
//! | V̇ | | 1 | V̇·a |
//! | θ̇ | 4² + 3² = 25 | 4 · (−3) + 3 · 4 + 30 · 1 = 30 | pushed down |
//!
//! Hence θ̈ = −30/25 = −6/5, which is −(g/l) sin θ. The contributions of centripetal acceleration,
//! −12 + 12, cancel along the path.
//!
//! # Polar coordinates in numbers
//!
//! This is an example of changing weights: ½ m (ṙ² + r² φ̇²) with m = 1 at r = 2, ṙ = 3, φ̇ = 5.
//! The weight of φ̇ is w = r² = 4 with ẇ = 2 r ṙ. The linear part at φ̇ is ẇ u = 60, the Coriolis
//! force. At the node ẇ it is −½ u² = −25/2. Pushed down to ṙ, this becomes −25/2 · 2 r = −50, the
//! centrifugal force.

use super::curvature::Curvature;
use super::gibbs_appell::{GibbsForm, remainder};
use super::quadratic_form::QuadraticForm;
use super::quasi_velocities::QuasiVelocities;
use super::virtual_displacements::{add_slopes, add_turning};
use crate::model::{GibbsFunction, Model};
use lagrange_algebra::calculus::{AccelerationTerms, Degree, Degrees, Rates, gradient};
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// The Lagrangian, split into groups of terms that are treated alike.
#[derive(Debug)]
pub(super) struct SplitLagrangian {
    /// `(w, u)` for the terms ½ w u² with u = dx/dt.
    pub(super) squares: Vec<(ExprId, ExprId)>,
    /// Minus the velocity-free terms.
    pub(super) potential: ExprId,
    /// All other terms.
    pub(super) rest: ExprId,
    /// True if `rest` is nonlinear in the velocities.
    pub(super) has_other_inertia: bool,
    /// Quasi-velocities, if the Lagrangian has terms in components that joints turn.
    quasi_velocities: Option<QuasiVelocities>,
    /// Part given by a Gibbs function, which the terms above exclude.
    gibbs: Option<GibbsForm>,
    /// Second derivatives with respect to affine nodes, including the squares and the Gibbs
    /// function.
    quadratic: QuadraticForm,
}

impl SplitLagrangian {
    pub(super) fn new(model: &mut Model) -> SplitLagrangian {
        let Some(GibbsFunction { function, stated }) = model.gibbs else {
            let lagrangian = model.lagrangian;
            return Splitter::new(model, lagrangian).split(lagrangian);
        };
        let gibbs = GibbsForm::new(&mut model.graph, function);
        let lagrangian = remainder(&mut model.graph, model.lagrangian, stated);
        let mut split = Splitter::new(model, lagrangian).split(lagrangian);
        split.quadratic.add(&gibbs.quadratic);
        split.has_other_inertia = true;
        split.gibbs = Some(gibbs);
        split
    }
}

impl SplitLagrangian {
    /// True if part of the equations is given by a Gibbs function.
    pub(super) fn has_gibbs_function(&self) -> bool {
        self.gibbs.is_some()
    }
}

/// The requested terms of d/dt ∂L/∂v − ∂L/∂q − Q.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Terms {
    /// Only terms of the Lagrangian.
    Inertial,
    /// Also loads and dissipation.
    All,
}

/// Returns the quadratic form with the linear part that `terms` and `accelerations` select.
pub(super) fn least_constraint_form(
    model: &mut Model,
    split: &SplitLagrangian,
    accelerations: AccelerationTerms,
    terms: Terms,
) -> QuadraticForm {
    let mut form = linear_form(model, split, accelerations, terms);
    form.add(&split.quadratic);
    form
}

/// Returns the linear part alone: its coefficients at the generalised velocities are d/dt ∂L/∂v −
/// ∂L/∂q − Q.
pub(super) fn linear_form(
    model: &mut Model,
    split: &SplitLagrangian,
    accelerations: AccelerationTerms,
    terms: Terms,
) -> QuadraticForm {
    let mut form = loads_beside_squares(model, split, accelerations, terms);
    let mut rates = Rates::new(accelerations);
    for &(weight, u) in &split.squares {
        let u_rate = rates.of(&mut model.graph, u);
        let inertial = model.graph.multiply(weight, u_rate);
        form.add_linear(&model.graph, u, inertial);
    }
    form
}

/// Returns the linear part without the terms w u̇ of the squares.
pub(super) fn loads_beside_squares(
    model: &mut Model,
    split: &SplitLagrangian,
    accelerations: AccelerationTerms,
    terms: Terms,
) -> QuadraticForm {
    let mut form = QuadraticForm::default();
    let mut rates = Rates::new(accelerations);
    let mut slopes = displaced_rates(model);
    for &(weight, u) in &split.squares {
        add_convection(&mut model.graph, &mut form, [&mut rates, &mut slopes], (weight, u));
    }
    let power = slopes.of(&mut model.graph, split.potential);
    let one = model.graph.number(1);
    form.add_linear(&model.graph, power, one);
    match &split.quasi_velocities {
        Some(quasi_velocities) => quasi_velocities.add_terms(model, &mut form, accelerations),
        None => add_rest(model, &mut form, &mut rates, split.rest),
    }
    if let Some(gibbs) = &split.gibbs {
        gibbs.add_linear(&mut model.graph, &mut form, accelerations);
    }
    if terms == Terms::All {
        add_loads(model, &mut form);
    }
    form
}

/// Returns rates along displacements, which leave first-order states unchanged.
fn displaced_rates(model: &mut Model) -> Rates {
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let states = model.states().map(|state| state.position).collect::<Vec<_>>();
    states.into_iter().for_each(|state| rates.learn(state, model.graph.number(0)));
    rates
}

/// Adds the contribution of a changing weight to the linear part of ½ w u². It is ẇ u along u, and
/// −½ u² along the rate of w due to displacements.
fn add_convection(
    graph: &mut Graph,
    form: &mut QuadraticForm,
    [rates, slopes]: [&mut Rates; 2],
    (weight, u): (ExprId, ExprId),
) {
    let rate = rates.of(graph, weight);
    let convective = graph.multiply(rate, u);
    form.add_linear(graph, u, convective);
    let slope = slopes.of(graph, weight);
    if graph.dependencies(slope).intersects(Dependencies::VELOCITY) {
        let square = graph.square(u);
        let half = graph.scale(-&Number::HALF, square);
        form.add_linear(graph, slope, half);
    }
}

fn add_rest(model: &mut Model, form: &mut QuadraticForm, rates: &mut Rates, rest: ExprId) {
    let (positions, velocities) = (model.positions(), model.velocities());
    let graph = &mut model.graph;
    let momenta = gradient(graph, rest, &velocities);
    let forces = gradient(graph, rest, &positions);
    for (&velocity, &momentum) in velocities.iter().zip(&momenta) {
        let rate = rates.of(graph, momentum);
        form.add_linear(graph, velocity, rate);
    }
    add_slopes(model, form, &forces);
    add_turning(model, form, &momenta);
}

fn add_loads(model: &mut Model, form: &mut QuadraticForm) {
    let velocities = model.velocities();
    let graph = &mut model.graph;
    for load in &model.loads {
        let (coefficient, velocity) = graph.split_coefficient(load.velocity);
        let opposite = graph.scale(-&coefficient, load.force);
        form.add_linear(graph, velocity, opposite);
    }
    let resistances = gradient(graph, model.dissipation, &velocities);
    for (&velocity, resistance) in velocities.iter().zip(&resistances) {
        form.add_linear(graph, velocity, *resistance);
    }
}

/// Returns the positions whose rates are affine nodes of the Lagrangian. In addition to `dot(…)` in
/// the declaration, multiples and sums of rates count as rates.
fn known_positions(model: &mut Model, lagrangian: ExprId, degrees: &Degrees) -> HashMap<ExprId, ExprId> {
    let rates =
        model.speeds.iter().filter_map(|s| Some((s.velocity, model.coordinates[s.coordinate?].position)));
    let mut positions = model.rates.iter().copied().chain(rates).collect::<HashMap<_, _>>();
    let graph = &mut model.graph;
    for id in graph.reachable(&[lagrangian]) {
        if degrees.of(graph, id) == Degree::Affine && !positions.contains(&id) {
            let position = position_of_combination(graph, &positions, id);
            position.map(|position| positions.insert(id, position));
        }
    }
    positions
}

fn position_of_combination(
    graph: &mut Graph,
    positions: &HashMap<ExprId, ExprId>,
    id: ExprId,
) -> Option<ExprId> {
    match graph.node(id).clone() {
        Node::Sum { constant, terms } if constant.is_zero() => {
            let known = terms.iter().map(|(term, c)| Some((*positions.get(term)?, c.clone())));
            let known = known.collect::<Option<Vec<_>>>()?;
            Some(graph.sum(Number::ZERO, known))
        }
        Node::Product(factors) => {
            let fixed = |id: ExprId| graph.dependencies(id).is_constant_in_motion();
            let known = factors.iter().map(|(base, exponent)| match fixed(*base) {
                true => Some((*base, exponent.clone())),
                false => Some((*positions.get(base)?, exponent.clone())),
            });
            let known = known.collect::<Option<Vec<_>>>()?;
            Some(graph.product(known))
        }
        _ => None,
    }
}

/// Traversal of the Lagrangian from the root through its velocity-dependent nodes.
struct Splitter<'a> {
    graph: &'a mut Graph,
    positions: HashMap<ExprId, ExprId>,
    curvature: Curvature,
    /// Weights with which nodes enter the Lagrangian additively.
    weights: OrderedMap<ExprId, Vec<ExprId>>,
    squares: Vec<(ExprId, ExprId)>,
    free: Vec<ExprId>,
    rest: Vec<ExprId>,
}

impl<'a> Splitter<'a> {
    fn new(model: &'a mut Model, lagrangian: ExprId) -> Splitter<'a> {
        let mut degrees = Degrees::default();
        degrees.classify(&model.graph, &[lagrangian]);
        let positions = known_positions(model, lagrangian, &degrees);
        Splitter {
            graph: &mut model.graph,
            positions,
            curvature: Curvature::new(degrees),
            weights: OrderedMap::default(),
            squares: Vec::new(),
            free: Vec::new(),
            rest: Vec::new(),
        }
    }

    fn split(mut self, lagrangian: ExprId) -> SplitLagrangian {
        let one = self.graph.number(1);
        self.enter(lagrangian, one);
        for id in self.graph.reachable(&[lagrangian]).into_iter().rev() {
            if self.curvature.degrees.of(self.graph, id) == Degree::Nonlinear {
                self.visit(id);
            }
        }
        let lagrangian_free = self.graph.total(self.free);
        let potential = self.graph.negate(lagrangian_free);
        let rest = self.graph.total(self.rest);
        let mut degrees = Degrees::default();
        degrees.classify(self.graph, &[rest]);
        SplitLagrangian {
            squares: self.squares,
            potential,
            rest,
            has_other_inertia: degrees.of(self.graph, rest) == Degree::Nonlinear,
            gibbs: None,
            quasi_velocities: QuasiVelocities::find(self.graph, rest, self.positions),
            quadratic: self.curvature.quadratic,
        }
    }

    /// Records `weight · id` as a term of the Lagrangian.
    fn enter(&mut self, id: ExprId, weight: ExprId) {
        match self.curvature.degrees.of(self.graph, id) {
            Degree::Free => self.free.push(self.graph.multiply(weight, id)),
            Degree::Affine => self.rest.push(self.graph.multiply(weight, id)),
            Degree::Nonlinear => self.weights.get_or_insert_with(id, Vec::new).push(weight),
        }
    }

    fn visit(&mut self, id: ExprId) {
        let additive = self.take_weight(id);
        let indirect = self.curvature.take_adjoint(self.graph, id);
        let Some(weight) = additive else { return self.curvature.sweep(self.graph, id, indirect) };
        if let Some(parts) = self.linear_parts(id) {
            for (part, slope) in parts {
                let weight = self.graph.multiply(weight, slope);
                self.enter(part, weight);
            }
            return self.curvature.sweep(self.graph, id, indirect);
        }
        match self.weighted_square(id) {
            Some((slope, u)) => {
                let weight = self.graph.multiply(weight, slope);
                let weight = self.graph.scale(Number::TWO, weight);
                self.squares.push((weight, u));
            }
            None => self.rest.push(self.graph.multiply(weight, id)),
        }
        let total = self.graph.total([Some(weight), indirect].into_iter().flatten());
        self.curvature.sweep(self.graph, id, Some(total));
    }

    fn take_weight(&mut self, id: ExprId) -> Option<ExprId> {
        let terms = std::mem::take(self.weights.get_mut(&id)?);
        Some(self.graph.total(terms))
    }

    /// Returns the terms of a sum, or the only moving factor of a product; `None` for every other
    /// node.
    fn linear_parts(&mut self, id: ExprId) -> Option<Vec<(ExprId, ExprId)>> {
        if let Node::Sum { constant, terms } = self.graph.node(id).clone() {
            let one = self.graph.number(1);
            let mut parts = vec![(one, self.graph.number(constant))];
            parts.extend(terms.iter().map(|(term, c)| (*term, self.graph.number(c.clone()))));
            return Some(parts);
        }
        let (slope, base, exponent) = self.only_moving_factor(id)?;
        exponent.is_one().then(|| vec![(base, slope)])
    }

    /// Returns `(slope, base, exponent)` for a product of the velocity-free `slope` and one moving
    /// factor.
    fn only_moving_factor(&mut self, id: ExprId) -> Option<(ExprId, ExprId, Number)> {
        let Node::Product(factors) = self.graph.node(id).clone() else { return None };
        let is_free =
            |(base, _): &(ExprId, Number)| self.curvature.degrees.of(self.graph, *base) == Degree::Free;
        let (free, moving): (Vec<_>, Vec<_>) = factors.iter().cloned().partition(is_free);
        match moving.as_slice() {
            [(base, exponent)] => Some((self.graph.product(free), *base, exponent.clone())),
            _ => None,
        }
    }

    /// Returns `(slope, u)` if the node is slope·u² with u = dx/dt.
    fn weighted_square(&mut self, id: ExprId) -> Option<(ExprId, ExprId)> {
        let (slope, u, exponent) = self.only_moving_factor(id)?;
        (self.positions.contains(&u) && exponent == Number::TWO).then_some((slope, u))
    }
}

#[cfg(test)]
mod tests;
