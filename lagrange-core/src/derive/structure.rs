//! Structure of a system as its equations show it: the shape of the mass matrix, cyclic coordinates,
//! conserved quantities.

use crate::calculus::{adjoint, gradient};
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId};
use crate::model::{Action, Model};
use crate::simplify::vanishing;

/// The shape of the mass matrix.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MassStructure {
    /// No entry depends on anything but parameters.
    pub is_constant: bool,
    /// An entry depends on velocities.
    pub depends_on_velocities: bool,
    /// Coordinates that are coupled with each other; single ones form blocks of their own.
    pub blocks: Vec<Vec<usize>>,
}

impl MassStructure {
    /// Whether no two coordinates are coupled.
    pub fn is_diagonal(&self) -> bool {
        self.blocks.iter().all(|block| block.len() == 1)
    }
}

/// A quantity that stays constant during the motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Conserved {
    /// The momentum of the coordinate with this index.
    Momentum(usize),
    /// The energy function.
    Energy,
}

/// Structure of a system, as far as its equations show it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Structure {
    /// The shape of the mass matrix.
    pub mass: MassStructure,
    /// Coordinates that the Lagrangian does not depend on.
    pub cyclic: Vec<usize>,
    /// Conserved quantities that follow.
    pub conserved: Vec<Conserved>,
}

impl Structure {
    pub(super) fn find(model: &mut Model, mass_matrix: &[Vec<ExprId>]) -> Structure {
        let cyclic = cyclic_coordinates(model);
        let conserved = conserved_quantities(model, &cyclic);
        Structure { mass: mass_structure(model, mass_matrix), cyclic, conserved }
    }
}

fn mass_structure(model: &Model, matrix: &[Vec<ExprId>]) -> MassStructure {
    let mut dependencies = Dependencies::NONE;
    for entry in matrix.iter().flatten() {
        dependencies = dependencies | model.graph.dependencies(*entry);
    }
    MassStructure {
        is_constant: dependencies.is_constant_in_motion(),
        depends_on_velocities: dependencies.intersects(Dependencies::VELOCITY),
        blocks: blocks(model, matrix),
    }
}

/// Connected components of the coupling, each in ascending order.
fn blocks(model: &Model, matrix: &[Vec<ExprId>]) -> Vec<Vec<usize>> {
    let is_coupled = |entry: &ExprId| !model.graph.is_zero(*entry);
    let near = matrix.iter().map(|row| (0..row.len()).filter(|&j| is_coupled(&row[j])).collect::<Vec<_>>());
    let near = near.collect::<Vec<_>>();
    let mut block_of = vec![None; matrix.len()];
    let mut blocks = Vec::new();
    for start in 0..matrix.len() {
        if block_of[start].is_some() {
            continue;
        }
        let mut members = Vec::new();
        let mut pending = vec![start];
        while let Some(i) = pending.pop() {
            if block_of[i].replace(blocks.len()).is_none() {
                members.push(i);
                pending.extend(&near[i]);
            }
        }
        members.sort_unstable();
        blocks.push(members);
    }
    blocks
}

fn cyclic_coordinates(model: &mut Model) -> Vec<usize> {
    let positions = model.positions();
    let slopes = gradient(&mut model.graph, model.lagrangian, &positions);
    let vanishing = vanishing(&mut model.graph, &slopes);
    (0..slopes.len()).filter(|&i| vanishing[i]).collect()
}

fn conserved_quantities(model: &mut Model, cyclic: &[usize]) -> Vec<Conserved> {
    if model.events.iter().any(|event| matches!(event.action, Action::Assign(_))) {
        return Vec::new();
    }
    let velocities = model.velocities();
    let seeds = model.loads.iter().map(|load| (load.velocity, load.force)).collect::<Vec<_>>();
    let forces = adjoint(&mut model.graph, &seeds, &velocities);
    let resistances = gradient(&mut model.graph, model.dissipation, &velocities);
    let constrained = constrained_velocities(model);
    let is_free = |i: usize| model.graph.is_zero(forces[i]) && model.graph.is_zero(resistances[i]);
    let mut conserved = cyclic
        .iter()
        .filter(|&&i| is_free(i) && !constrained.contains(&velocities[i]))
        .map(|&i| Conserved::Momentum(i))
        .collect::<Vec<_>>();
    let changing = Dependencies::TIME | Dependencies::INPUT;
    let is_steady = !model.graph.dependencies(model.lagrangian).intersects(changing);
    let is_unforced = (0..velocities.len()).all(is_free) && model.reactions.is_empty();
    if is_steady && is_unforced && constraints_do_no_work(model) {
        conserved.push(Conserved::Energy);
    }
    conserved
}

/// The velocities that forces of constraints, contacts and friction change.
fn constrained_velocities(model: &Model) -> HashMap<ExprId, ()> {
    let constrained = model.constraints.iter().map(|constraint| constraint.velocity);
    let touched = model.reactions.iter().map(|reaction| reaction.velocity);
    let reached = model.graph.reachable(&constrained.chain(touched).collect::<Vec<_>>());
    reached.into_iter().map(|id| (id, ())).collect()
}

/// Whether the power of multipliers, λᵀA v, is zero: whether what constraints demand of velocities is linear in them, A v = 0.
fn constraints_do_no_work(model: &mut Model) -> bool {
    let velocities = model.velocities();
    let is_velocity = velocities.into_iter().map(|velocity| (velocity, ())).collect::<HashMap<_, _>>();
    let demands = model.constraints.iter().map(|constraint| constraint.velocity).collect::<Vec<_>>();
    let drifts = demands.into_iter().map(|demand| {
        // A constraint usually holds few of all velocities.
        let mut constrained = model.graph.reachable_until(&[demand], |id| is_velocity.contains(&id));
        constrained.retain(|id| is_velocity.contains(id));
        let row = gradient(&mut model.graph, demand, &constrained);
        let products = row.iter().zip(&constrained).map(|(&a, &v)| model.graph.multiply(a, v));
        let products = products.collect::<Vec<_>>();
        let linear = model.graph.total(products);
        let opposite = model.graph.negate(linear);
        model.graph.add(demand, opposite)
    });
    let drifts = drifts.collect::<Vec<_>>();
    vanishing(&mut model.graph, &drifts).into_iter().all(|vanishes| vanishes)
}
