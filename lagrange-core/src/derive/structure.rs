//! Structure detected in the equations of a system: the shape of the mass matrix, cyclic
//! coordinates, conserved quantities.

use crate::model::{Action, Model};
use lagrange_algebra::calculus::{adjoint, gradient};
use lagrange_algebra::simplify::{ROUNDING, somewhere, vanishing};
use lagrange_expr::collections::{HashSet, coupled_blocks};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId, Graph};
use lagrange_expr::symbol::Role;

/// The shape of the mass matrix.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MassStructure {
    /// True if entries depend only on parameters.
    pub is_constant: bool,
    /// True if an entry depends on velocities.
    pub depends_on_velocities: bool,
    /// Groups of coupled coordinates; uncoupled ones form separate blocks.
    pub blocks: Vec<Vec<usize>>,
}

impl MassStructure {
    /// Determines the structure of a matrix that is given by its rows.
    pub(super) fn of_matrix(graph: &Graph, matrix: &[Vec<ExprId>]) -> MassStructure {
        let mut dependencies = Dependencies::NONE;
        for entry in matrix.iter().flatten() {
            dependencies = dependencies | graph.dependencies(*entry);
        }
        MassStructure {
            is_constant: dependencies.is_constant_in_motion(),
            depends_on_velocities: dependencies.intersects(Dependencies::VELOCITY),
            blocks: coupled_blocks(matrix.len(), |i, j| !graph.is_zero(matrix[i][j])),
        }
    }

    /// Determines the structure of the velocity-independent matrix M in the residual M a − f from
    /// its values at two points. Returns `None` unless the values prove that M couples all
    /// coordinates and depends on them. Entries that are equal at both points need not be constant.
    pub(super) fn seen_at_points(graph: &Graph, residual: &[ExprId]) -> Option<MassStructure> {
        let everything = vec![true; residual.len()];
        // The points differ by a factor, since many systems are invariant under a common shift.
        let [here, there] =
            [1.0, 1.25].map(|stretch| InertialForces::at(graph, residual, &everything, stretch));
        let mut reached = vec![false; residual.len()];
        *reached.first_mut()? = true;
        // Adds the coordinates coupled to those reached so far, until all are reached or none is
        // new.
        while reached != everything {
            let inertial = InertialForces::at(graph, residual, &reached, 1.0);
            let before = reached.clone();
            reached
                .iter_mut()
                .zip(&inertial.forces)
                .for_each(|(known, force)| *known |= inertial.exceeds_rounding(*force));
            if reached == before {
                return None;
            }
        }
        let is_moving = here.forces.iter().zip(&there.forces).any(|(a, b)| here.exceeds_rounding(a - b));
        let blocks = vec![(0..residual.len()).collect()];
        is_moving.then_some(MassStructure { is_constant: false, depends_on_velocities: false, blocks })
    }

    /// True if no two coordinates are coupled.
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

/// Structure of a system, as far as its equations reveal it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Structure {
    /// The shape of the mass matrix.
    pub mass: MassStructure,
    /// Coordinates that the Lagrangian does not depend on.
    pub cyclic: Vec<usize>,
    /// Conserved quantities that result.
    pub conserved: Vec<Conserved>,
}

impl Structure {
    pub(super) fn find(model: &mut Model, mass: MassStructure) -> Structure {
        let cyclic = cyclic_coordinates(model);
        let conserved = conserved_quantities(model, &cyclic);
        Structure { mass, cyclic, conserved }
    }
}

/// Values of the inertial forces M a.
struct InertialForces {
    forces: Vec<f64>,
    /// Largest magnitude that a zero may have after rounding.
    rounding: f64,
}

impl InertialForces {
    /// Evaluates M a with nonzero accelerations of the coordinates marked in `is_accelerated`,
    /// where every coordinate is `stretch` times that of a fixed point.
    fn at(graph: &Graph, residual: &[ExprId], is_accelerated: &[bool], stretch: f64) -> InertialForces {
        let [moving, resting] = [1.0, 0.0].map(|scale| {
            evaluate(graph, residual, |role| match role {
                Role::Acceleration(i) if is_accelerated[i as usize] => scale * somewhere(role),
                Role::Acceleration(_) => 0.0,
                Role::Coordinate(_) => stretch * somewhere(role),
                role => somewhere(role),
            })
        });
        let largest = moving.iter().chain(&resting).fold(0.0, |a: f64, b| a.max(b.abs()));
        let forces = moving.iter().zip(&resting).map(|(moving, resting)| moving - resting).collect();
        InertialForces { forces, rounding: ROUNDING * largest }
    }

    /// True if a force exceeds the rounding error.
    fn exceeds_rounding(&self, force: f64) -> bool {
        force.abs() > self.rounding
    }
}

fn cyclic_coordinates(model: &mut Model) -> Vec<usize> {
    let positions = model.positions();
    let slopes = gradient(&mut model.graph, model.lagrangian, &positions);
    let vanishing = vanishing(&mut model.graph, &slopes);
    // Components of a quaternion have no generalised momentum.
    let has_momentum = |i: usize| model.speeds.iter().any(|speed| speed.coordinate == Some(i));
    (0..slopes.len()).filter(|&i| vanishing[i] && has_momentum(i)).collect()
}

fn conserved_quantities(model: &mut Model, cyclic: &[usize]) -> Vec<Conserved> {
    let assigns = model.events.iter().any(|event| matches!(event.action, Action::Assign(_)));
    if assigns || !model.clocks.is_empty() || !model.noises.is_empty() {
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
        .filter_map(|&i| Some((i, model.speeds.iter().position(|speed| speed.coordinate == Some(i))?)))
        .filter(|&(_, v)| is_free(v) && !constrained.contains(&velocities[v]))
        .map(|(i, _)| Conserved::Momentum(i))
        .collect::<Vec<_>>();
    let states = Dependencies::STATE | Dependencies::DISCRETE;
    let changing = Dependencies::TIME | Dependencies::INPUT | states;
    let has_energy = !velocities.is_empty();
    let is_steady = has_energy && !model.graph.dependencies(model.lagrangian).intersects(changing);
    let is_unforced = (0..velocities.len()).all(is_free) && model.reactions.is_empty();
    if is_steady && is_unforced && constraints_do_no_work(model) {
        conserved.push(Conserved::Energy);
    }
    conserved
}

/// Collects the velocities that forces of constraints, contacts and friction can change.
fn constrained_velocities(model: &Model) -> HashSet<ExprId> {
    let constrained = model.constraints.iter().map(|constraint| constraint.velocity);
    let touched = model.reactions.iter().map(|reaction| reaction.velocity);
    let reached = model.graph.reachable(&constrained.chain(touched).collect::<Vec<_>>());
    reached.into_iter().collect()
}

/// True if the power of the multipliers, λᵀA v, is zero, which holds if all velocity constraints
/// are homogeneous, A v = 0.
fn constraints_do_no_work(model: &mut Model) -> bool {
    let velocities = model.velocities();
    let is_velocity = velocities.into_iter().collect::<HashSet<_>>();
    let residuals = model.constraints.iter().map(|constraint| constraint.velocity).collect::<Vec<_>>();
    let drifts = residuals.into_iter().map(|residual| {
        // Most constraints contain only few of the velocities.
        let mut constrained = model.graph.reachable_until(&[residual], |id| is_velocity.contains(&id));
        constrained.retain(|id| is_velocity.contains(id));
        let row = gradient(&mut model.graph, residual, &constrained);
        let products = row.iter().zip(&constrained).map(|(&a, &v)| model.graph.multiply(a, v));
        let products = products.collect::<Vec<_>>();
        let linear = model.graph.total(products);
        let opposite = model.graph.negate(linear);
        model.graph.add(residual, opposite)
    });
    let drifts = drifts.collect::<Vec<_>>();
    vanishing(&mut model.graph, &drifts).into_iter().all(|vanishes| vanishes)
}
