//! The power of everything that changes the energy, as outputs, and the balance of both.
//!
//! Along a motion, the energy function h = v·∂L/∂v − L changes at the rate
//!
//! > ḣ = v·Q + λ·A v + r·D v − v·∂R/∂v − ∂L/∂t − ∂L/∂s·ṡ
//!
//! with the generalised forces Q of loads, the Rayleigh function R and first-order states s. The
//! forces of constraints are λ, those of contacts and friction r. Without forces and states this is
//! in Goldstein, Poole and Safko, *Classical Mechanics*, 3rd ed., §2.7. Only the part of a velocity
//! that is linear in v counts: a force at a point that only time moves leaves h alone.

use super::conserved::add;
use super::energy_function::energy_function;
use crate::model::{Model, Product};
use lagrange_algebra::calculus::{AccelerationTerms, Rates, adjoint, gradient, homogeneity, partial};
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;
use lagrange_expr::units::{NamedUnit, momentum_name};

/// Adds an output for each power, and one for the balance, to a model that asks for them.
pub(super) fn add_power(model: &mut Model) {
    if !model.products.contains(&Product::Power) {
        return;
    }
    let mut powers = of_forces(model);
    powers.extend(of_functions(model));
    let energy = energy_function(model);
    let graph = &mut model.graph;
    let rate = Rates::new(AccelerationTerms::Kept).of(graph, energy);
    let sum = graph.total(powers.iter().map(|power| power.value).collect::<Vec<_>>());
    let value = graph.subtract(rate, sum);
    powers.push(Power::new("balance", "Rate of the energy minus the sum of all powers".to_owned(), value));
    let momenta = model.coordinates.iter().map(|coordinate| momentum_name(&coordinate.name));
    let has_units = momenta.into_iter().any(|momentum| model.units.get(&momentum).is_some());
    for Power { name, description, value } in powers {
        add(model, name, value, description);
        if let (true, Some(output)) = (has_units, model.outputs.last()) {
            model.units.insert(&output.name, NamedUnit { unit: "W".to_owned(), default: None });
        }
    }
}

/// A power, with its meaning.
struct Power {
    name: String,
    description: String,
    value: ExprId,
}

impl Power {
    fn new(name: &str, description: String, value: ExprId) -> Power {
        Power { name: format!("power_{}", name.to_lowercase()), description, value }
    }
}

/// What does work, with its name and meaning: forces along velocities, `(u, force)`.
struct Acting<'a> {
    name: &'a str,
    description: String,
    pairs: Vec<(ExprId, ExprId)>,
}

/// The powers of loads, of contacts and friction, and of constraints. Constraints that do not move
/// have one in common, since it is zero where they hold.
fn of_forces(model: &mut Model) -> Vec<Power> {
    let mut acting: Vec<Acting<'_>> = Vec::new();
    for load in &model.loads {
        let pair = (load.velocity, load.force);
        match acting.last_mut().filter(|acting| acting.name == load.name) {
            Some(acting) => acting.pairs.push(pair),
            None => {
                let description = format!("Power of the load `{}`", load.name);
                acting.push(Acting { name: &load.name, description, pairs: vec![pair] });
            }
        }
    }
    for reaction in &model.reactions {
        let description = format!("Power of the force of `{}`", reaction.name);
        let pairs = vec![(reaction.velocity, reaction.symbol)];
        acting.push(Acting { name: &reaction.name, description, pairs });
    }
    let mut resting = Vec::new();
    for constraint in &model.constraints {
        let pair = (constraint.velocity, constraint.multiplier);
        if homogeneity(&model.graph, constraint.velocity) == Some(1) {
            resting.push(pair);
            continue;
        }
        let description = format!("Power of the force of the constraint `{}`", constraint.name);
        acting.push(Acting { name: &constraint.name, description, pairs: vec![pair] });
    }
    if !resting.is_empty() {
        let description = "Power of the constraints at rest, zero where they hold".to_owned();
        acting.push(Acting { name: "constraints", description, pairs: resting });
    }
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let power = |acting: Acting<'_>| {
        Power::new(acting.name, acting.description, along(graph, &acting.pairs, &velocities))
    };
    acting.into_iter().map(power).collect()
}

/// The power of forces along the parts of their velocities, `(u, force)`, that are linear in v.
fn along(graph: &mut Graph, pairs: &[(ExprId, ExprId)], velocities: &[ExprId]) -> ExprId {
    if pairs.iter().all(|(along, _)| homogeneity(graph, *along) == Some(1)) {
        let products = pairs.iter().map(|&(along, force)| graph.multiply(force, along));
        let products = products.collect::<Vec<_>>();
        return graph.total(products);
    }
    let forces = adjoint(graph, pairs, velocities);
    inner(graph, velocities, &forces)
}

fn inner(graph: &mut Graph, a: &[ExprId], b: &[ExprId]) -> ExprId {
    let products = a.iter().zip(b).map(|(&a, &b)| graph.multiply(a, b)).collect::<Vec<_>>();
    graph.total(products)
}

/// The powers of dissipation, time and states, as far as they are not zero.
fn of_functions(model: &mut Model) -> Vec<Power> {
    let (velocities, lagrangian) = (model.velocities(), model.lagrangian);
    let (states, rates): (Vec<_>, Vec<_>) = model.states().map(|state| (state.position, state.rate)).unzip();
    let graph = &mut model.graph;
    let resistances = gradient(graph, model.dissipation, &velocities);
    let dissipated = inner(graph, &velocities, &resistances);
    let time = graph.symbol("t", Role::Time);
    let explicit = partial(graph, lagrangian, time);
    let slopes = gradient(graph, lagrangian, &states);
    let of_states = inner(graph, &slopes, &rates);
    let lost = [
        ("dissipation", "Power −v·∂R/∂v of the dissipation", dissipated),
        ("time", "Power −∂L/∂t of the explicit time dependence of L", explicit),
        ("states", "Power −∂L/∂s·ṡ of the states that L depends on", of_states),
    ];
    let vanish = vanishing(graph, &lost.map(|(.., value)| value));
    let changing = lost.into_iter().zip(vanish).filter(|(_, vanishes)| !vanishes);
    let power = |((name, description, value), _): ((&str, &str, _), _)| {
        Power::new(name, description.to_owned(), graph.negate(value))
    };
    changing.map(power).collect()
}
