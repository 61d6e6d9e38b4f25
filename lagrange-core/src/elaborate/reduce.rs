//! A model with coordinates frozen or small, from the model of the whole system.
//!
//! A frozen coordinate is replaced by its value, its rates by zero. In small coordinates and their
//! velocities together, the Lagrangian is expanded to second order, so their equations of motion
//! become linear. See Goldstein, Poole and Safko, *Classical Mechanics*, 3rd ed., §6.1, there about
//! an equilibrium; here the other coordinates move. Dissipation and the power F·ṗ of loads are
//! expanded in the same way, so forces on small coordinates are of first order. Expansion commutes
//! with the time derivative, so rates stay rates and sums of squares survive.
//!
//! The result is moved to a separate graph with coordinates numbered from zero, and is then handled
//! like any other model.

use super::ignored::Terms;
use super::messages;
use super::pinned::holding;
use super::renumbering::Renumbering;
use super::routh::routhian;
use crate::model::{
    Coordinate, Energies, Load, Model, Orientation, Output, Pinned, Product, Reduced, Reduction, Scene,
};
use lagrange_algebra::calculus::{Expansion, Series, gradient, transplant};
use lagrange_expr::diagnostics::Report;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};

/// The order to which Lagrangians are expanded.
const ORDER: usize = 2;

/// Reduces a model; parts without an expansion and coordinates that cannot be ignored are reported.
pub(super) fn reduce(
    model: &Model,
    reduction: &Reduction,
    terms: &Terms,
    report: &mut Report,
) -> Option<Reduced> {
    let numbers = Renumbering::new(model, reduction);
    let ignoring = match reduction.ignored.is_empty() {
        true => None,
        false => {
            let found = routhian(model, reduction);
            Some(found.map_err(|refusal| refusal.report(model, reduction, terms, report)).ok()?)
        }
    };
    let model = ignoring.as_ref().unwrap_or(model);
    let mut reduced = match Reducer::new(model, reduction).model(model) {
        Ok(model) => Reduced { reduction: reduction.clone(), model },
        Err(part) => {
            report_undefined(model, reduction, &part, report);
            return None;
        }
    };
    transplanted(&mut reduced, &numbers);
    check_inertia(&mut reduced, report)?;
    Some(reduced)
}

/// Part of a declaration that has no expansion, in the user's words.
type Undefined = String;

struct Reducer<'a> {
    graph: Graph,
    reduction: &'a Reduction,
    /// Expressions with frozen coordinates at their values.
    frozen: Expansion,
    /// Expressions in which small coordinates are also expanded.
    expanded: Expansion,
}

impl<'a> Reducer<'a> {
    fn new(model: &Model, reduction: &'a Reduction) -> Reducer<'a> {
        let mut graph = model.graph.clone();
        let zero = graph.number(0);
        let frozen = holding(model, &reduction.frozen, zero);
        let mut expanded = frozen.clone();
        for pinned in &reduction.small {
            let coordinate = &model.coordinates[pinned.coordinate];
            expanded.vary(&mut graph, coordinate.position, pinned.value);
            expanded.vary(&mut graph, coordinate.rate, zero);
        }
        Reducer { graph, reduction, frozen, expanded }
    }

    /// Returns the reduced model in the graph of the whole one.
    fn model(mut self, model: &Model) -> Result<Model, Undefined> {
        let mut energies = model.energies;
        for (part, name) in energies.parts_mut().zip(["the kinetic energy", "the potential energy"]) {
            *part = self.of(*part, name)?.closed;
        }
        let lagrangian = match energies {
            Energies::Separate { kinetic, potential } => self.graph.subtract(kinetic, potential),
            Energies::Lagrangian | Energies::Routhian { .. } => {
                self.of(model.lagrangian, "the Lagrangian")?.closed
            }
        };
        let dissipation = self.of(model.dissipation, "the dissipation function")?.closed;
        let mut loads = Vec::new();
        for load in &model.loads {
            loads.extend(self.load(load)?);
        }
        let (outputs, scene) = (self.outputs(model)?, self.scene(model)?);
        let (start, rates, labels) = (self.start(model), self.rates(model), self.labels(model));
        let (coordinates, products) = (self.coordinates(model)?, self.products(model));
        let speeds = model.speeds.iter().filter(|speed| !speed.coordinate.is_some_and(|i| self.is_frozen(i)));
        let speeds = speeds.cloned().collect();
        Ok(Model {
            graph: self.graph,
            parameters: model.parameters.clone(),
            inputs: model.inputs.clone(),
            delays: Vec::new(),
            coordinates,
            speeds,
            orientations: model.orientations.clone(),
            start,
            energies,
            lagrangian,
            // It would also have to be expanded, and the energies contain the same information.
            gibbs: None,
            dissipation,
            loads,
            // These are rejected in combination with a reduction.
            constraints: Vec::new(),
            implied: Vec::new(),
            stabilisation: None,
            events: Vec::new(),
            clocks: Vec::new(),
            noises: Vec::new(),
            reactions: Vec::new(),
            quantities: model.quantities.clone(),
            distances: Vec::new(),
            outputs,
            scene,
            rates,
            labels,
            units: model.units.clone(),
            accuracy: model.accuracy,
            products,
            reduced: Vec::new(),
        })
    }

    /// Returns the products of the reduced model. If it has small or ignored coordinates, its
    /// inverse dynamics is not linear in the inertial parameters.
    fn products(&self, model: &Model) -> Vec<Product> {
        let is_exact = self.reduction.small.is_empty() && self.reduction.ignored.is_empty();
        let is_kept = |product: &&Product| is_exact || **product != Product::Regressor;
        model.products.iter().filter(is_kept).copied().collect()
    }

    fn is_frozen(&self, coordinate: usize) -> bool {
        self.reduction.frozen.iter().any(|pinned| pinned.coordinate == coordinate)
    }

    fn of(&mut self, root: ExprId, part: &str) -> Result<Series, Undefined> {
        self.expanded.of(&mut self.graph, root, ORDER).ok_or_else(|| part.to_owned())
    }

    /// Returns the initial values of the coordinates and velocities that are not frozen.
    fn start(&self, model: &Model) -> Vec<ExprId> {
        let coordinates = 0..model.coordinates.len();
        let speeds = model.speeds.iter().map(|speed| speed.coordinate);
        let owners = coordinates.map(Some).chain(speeds);
        let kept =
            model.start.iter().zip(owners).filter(|(_, owner)| !owner.is_some_and(|i| self.is_frozen(i)));
        kept.map(|(value, _)| *value).collect()
    }

    /// Returns the coordinates that are not frozen. Rates of states stay exact in the remaining
    /// motion.
    fn coordinates(&mut self, model: &Model) -> Result<Vec<Coordinate>, Undefined> {
        let mut kept = Vec::new();
        for (index, coordinate) in model.coordinates.iter().enumerate() {
            if self.is_frozen(index) {
                continue;
            }
            let mut coordinate = coordinate.clone();
            if coordinate.is_state {
                let rate = self.frozen.of(&mut self.graph, coordinate.rate, 0);
                coordinate.rate = rate.ok_or_else(|| format!("the rate of `{}`", coordinate.name))?.closed;
            }
            kept.push(coordinate);
        }
        Ok(kept)
    }

    /// Returns the power of a load up to second order as loads: F₀₁₂ along ṗ₀, F₀₁ along ṗ₁ and F₀
    /// along ṗ₂.
    fn load(&mut self, load: &Load) -> Result<Vec<Load>, Undefined> {
        let velocity = self.of(load.velocity, "the point of a force")?;
        // Along a small velocity, first order suffices for the force.
        let order = ORDER.saturating_sub(velocity.valuation(&self.graph));
        let force = self.expanded.of(&mut self.graph, load.force, order).ok_or("a force")?;
        let graph = &mut self.graph;
        let mut loads = match velocity.degree(graph) + force.degree(graph) <= ORDER {
            true => vec![Load { name: load.name.clone(), velocity: velocity.closed, force: force.closed }],
            false => {
                let parts = velocity.parts.iter().enumerate();
                let along = |(degree, &velocity)| Load {
                    name: load.name.clone(),
                    velocity,
                    force: force.up_to(graph, ORDER - degree),
                };
                parts.map(along).collect()
            }
        };
        loads.retain(|load| !self.graph.is_zero(load.velocity) && !self.graph.is_zero(load.force));
        Ok(loads)
    }

    /// Returns the outputs, which stay exact in the remaining motion.
    fn outputs(&mut self, model: &Model) -> Result<Vec<Output>, Undefined> {
        let mut outputs = model.outputs.clone();
        for output in &mut outputs {
            for component in &mut output.components {
                let series = self.frozen.of(&mut self.graph, *component, 0);
                *component = series.ok_or_else(|| format!("output `{}`", output.name))?.closed;
            }
            let uses = |&c: &ExprId| self.graph.dependencies(c).intersects(Dependencies::ACCELERATION);
            output.uses_accelerations = output.components.iter().any(uses);
        }
        Ok(outputs)
    }

    /// Returns the scene with reduced bodies.
    fn scene(&mut self, model: &Model) -> Result<Scene, Undefined> {
        let mut scene = model.scene.clone();
        for place in scene.places() {
            let series = self.frozen.of(&mut self.graph, *place, 0);
            *place = series.ok_or("the motion of bodies")?.closed;
        }
        Ok(scene)
    }

    fn rates(&mut self, model: &Model) -> Vec<(ExprId, ExprId)> {
        let mut rates = Vec::new();
        for &(velocity, position) in &model.rates {
            let [velocity, position] =
                [velocity, position].map(|id| self.expanded.of(&mut self.graph, id, ORDER));
            let Some((velocity, position)) = velocity.zip(position) else { continue };
            let (coefficient, velocity) = self.graph.split_coefficient(velocity.closed);
            if self.graph.dependencies(velocity).intersects(Dependencies::VELOCITY)
                && let Some(inverse) = coefficient.reciprocal()
            {
                rates.push((velocity, self.graph.scale(inverse, position.closed)));
            }
        }
        rates
    }

    /// Returns the names of remaining expressions; symbols are self-explanatory.
    fn labels(&mut self, model: &Model) -> Vec<(ExprId, String)> {
        let mut labels = Vec::new();
        for (expression, name) in &model.labels {
            let Some(series) = self.expanded.of(&mut self.graph, *expression, ORDER) else { continue };
            let is_plain = matches!(self.graph.node(series.closed), Node::Symbol(_) | Node::Number(_));
            if !is_plain || series.closed == *expression {
                labels.push((series.closed, name.clone()));
            }
        }
        labels
    }
}

/// Moves a model to its own graph, in which its coordinates and velocities are numbered from zero.
fn transplanted(reduced: &mut Reduced, numbers: &Renumbering) {
    let Reduced { reduction, model } = reduced;
    let source = std::mem::take(&mut model.graph);
    let mut places = places(model);
    let pinned = reduction.frozen.iter_mut().chain(&mut reduction.small).chain(&mut reduction.ignored);
    places.extend(pinned.map(|pinned| &mut pinned.value));
    let roots = places.iter().map(|place| **place).collect::<Vec<_>>();
    let (graph, image) = transplant(&source, &roots, |role| numbers.role(role));
    places.into_iter().for_each(|place| *place = image.get(place).copied().unwrap_or(*place));
    model.graph = graph;
    numbers.sort(&mut model.coordinates);
    numbers.sort(&mut model.start);
    for Coordinate { position, rate, .. } in &model.coordinates {
        model.graph.set_rate(*position, *rate);
    }
    for speed in &mut model.speeds {
        speed.coordinate = speed.coordinate.map(|index| numbers.coordinate(index));
    }
    for Orientation { position, velocity } in &mut model.orientations {
        (*position, *velocity) = (numbers.coordinate(*position), numbers.velocity(*velocity));
    }
}

/// Returns the fields of a model that contain expressions.
fn places(model: &mut Model) -> Vec<&mut ExprId> {
    let mut places = vec![&mut model.lagrangian, &mut model.dissipation];
    places.extend(model.energies.parts_mut());
    for parameter in model.parameters.iter_mut().chain(&mut model.inputs) {
        places.push(&mut parameter.symbol);
        places.extend(&mut parameter.default);
        places.extend(parameter.range.iter_mut().flatten().map(|bound| &mut bound.value));
    }
    for quantity in &mut model.quantities {
        places.push(&mut quantity.value);
        places.extend(quantity.range.iter_mut().flatten().map(|bound| &mut bound.value));
    }
    places.extend(model.coordinates.iter_mut().flat_map(|c| [&mut c.position, &mut c.rate]));
    places.extend(model.speeds.iter_mut().flat_map(|s| [&mut s.velocity, &mut s.acceleration]));
    places.extend(&mut model.start);
    places.extend(model.loads.iter_mut().flat_map(|load| [&mut load.velocity, &mut load.force]));
    places.extend(model.outputs.iter_mut().flat_map(|output| &mut output.components));
    places.extend(model.scene.places());
    places.extend(model.rates.iter_mut().flat_map(|(velocity, position)| [velocity, position]));
    places.extend(model.labels.iter_mut().map(|(expression, _)| expression));
    places
}

/// Checks that every velocity still appears in the kinetic energy.
fn check_inertia(reduced: &mut Reduced, report: &mut Report) -> Option<()> {
    let model = &mut reduced.model;
    let velocities = model.velocities();
    let momenta = gradient(&mut model.graph, model.lagrangian, &velocities);
    let is_light = |momentum: ExprId| !model.graph.dependencies(momentum).intersects(Dependencies::VELOCITY);
    let Some(lost) = momenta.into_iter().position(is_light) else { return Some(()) };
    let message = messages::inertia_lost(model.name_of_freedom(lost));
    report.error(reduced.reduction.name.span, message).help(messages::INERTIA_LOST_HELP);
    None
}

/// Reports parts without an expansion, at the first coordinate that causes this by itself.
fn report_undefined(model: &Model, reduction: &Reduction, part: &Undefined, report: &mut Report) {
    let fails = |frozen: &[Pinned], small: &[Pinned]| {
        let (frozen, small) = (frozen.to_vec(), small.to_vec());
        let reduction = Reduction { name: reduction.name.clone(), frozen, small, ignored: Vec::new() };
        Reducer::new(model, &reduction).model(model).is_err()
    };
    let Reduction { name, frozen, small, .. } = reduction;
    if let Some(pinned) = frozen.iter().find(|pinned| fails(std::slice::from_ref(*pinned), &[])) {
        report.error(pinned.span, messages::undefined_when_frozen(part)).help(messages::UNDEFINED_HELP);
        return;
    }
    let guilty = small.iter().find(|pinned| fails(frozen, std::slice::from_ref(*pinned)));
    let span = guilty.map_or(name.span, |pinned| pinned.span);
    let coordinate = guilty.map(|pinned| model.coordinates[pinned.coordinate].name.as_str());
    report.error(span, messages::no_expansion(part, coordinate)).help(messages::NO_EXPANSION_HELP);
}
