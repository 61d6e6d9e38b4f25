//! Powers of everything that changes the energy, as outputs, and the energy balance.
//!
//! Along a motion, the energy function h = v·∂L/∂v − L changes at the rate
//!
//! > ḣ = v·Q + λ·A v + r·D v − v·∂R/∂v − ∂L/∂t − ∂L/∂s·ṡ
//!
//! with the generalised forces Q of loads, the Rayleigh function R and first-order states s. The
//! constraint forces are λ, and r are the forces of contacts and friction. The equation without
//! forces and states is in Goldstein, Poole and Safko, *Classical Mechanics*, 3rd ed., §2.7. Only
//! the part of a velocity that is linear in v counts: a force at a point that moves only with time
//! leaves h unchanged.

use super::conserved::add;
use super::energy_function::energy_function;
use crate::model::{Constraint, Model, Product};
use lagrange_algebra::calculus::{AccelerationTerms, Rates, adjoint, gradient, homogeneity, partial};
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;
use lagrange_expr::units::{NamedUnit, momentum_name};

/// Adds an output for each power, and one for the balance, if the model requests them.
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
    let has_units = has_units(model);
    for Power { name, description, value } in powers {
        add(model, name, value, description);
        if let (true, Some(output)) = (has_units, model.outputs.last()) {
            model.units.insert(&output.name, NamedUnit::of("W"));
        }
    }
}

/// True if momenta have known units, so that energies are in joules.
fn has_units(model: &Model) -> bool {
    let mut momenta = model.coordinates.iter().map(|coordinate| momentum_name(&coordinate.name));
    momenta.any(|momentum| model.units.get(&momentum).is_some())
}

/// A power and its description.
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

/// Forces of one source, as pairs of a velocity u and the force along it.
struct Acting {
    name: String,
    description: String,
    pairs: Vec<(ExprId, ExprId)>,
}

/// Returns the powers of loads, of contacts and friction, and of constraints.
fn of_forces(model: &mut Model) -> Vec<Power> {
    let mut acting = loads(model);
    acting.extend(model.reactions.iter().map(|reaction| Acting {
        name: reaction.name.clone(),
        description: format!("Power of the force of `{}`", reaction.name),
        pairs: vec![(reaction.velocity, reaction.symbol)],
    }));
    acting.extend(constraints(model));
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let power = |Acting { name, description, pairs }| {
        Power::new(&name, description, along(graph, &pairs, &velocities))
    };
    acting.into_iter().map(power).collect()
}

/// Groups loads by statement. Parts of an expanded load are consecutive, as components are.
fn loads(model: &Model) -> Vec<Acting> {
    let statements = model.loads.chunk_by(|load, next| load.name == next.name);
    let acting = statements.map(|loads| Acting {
        name: loads[0].name.clone(),
        description: format!("Power of the load `{}`", loads[0].name),
        pairs: loads.iter().map(|load| (load.velocity, load.force)).collect(),
    });
    acting.collect()
}

/// Returns the forces of constraints. Constraints that do not move share one power, which is zero
/// where they hold.
fn constraints(model: &Model) -> Vec<Acting> {
    let (resting, moving): (Vec<_>, Vec<_>) = model
        .constraints
        .iter()
        .partition(|constraint| homogeneity(&model.graph, constraint.velocity) == Some(1));
    let pair = |constraint: &&Constraint| (constraint.velocity, constraint.multiplier);
    let moving = moving.iter().map(|constraint| Acting {
        name: constraint.name.clone(),
        description: format!("Power of the force of the constraint `{}`", constraint.name),
        pairs: vec![pair(constraint)],
    });
    let at_rest = (!resting.is_empty()).then(|| Acting {
        name: "constraints".to_owned(),
        description: "Power of the constraints that do not move, zero where they hold".to_owned(),
        pairs: resting.iter().map(pair).collect(),
    });
    moving.chain(at_rest).collect()
}

/// Returns the power of the forces in pairs `(u, force)`, along the parts of u that are linear in
/// v.
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

/// Returns the nonzero powers of dissipation, time and states.
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
