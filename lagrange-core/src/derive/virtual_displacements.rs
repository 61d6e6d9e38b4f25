//! The contribution of a Lagrangian L(q, v) along virtual displacements of positions whose rates
//! are not velocities.
//!
//! With q̇ = N(q) v, displacements are δq = N δπ, where the δπ belong to the velocities. The
//! equations of motion along them are d/dt ∂L/∂v − Nᵀ ∂L/∂q + … = Q. The omitted terms vanish where
//! velocities are rates. For an angular velocity ω in turning axes with the momentum p = ∂L/∂ω,
//! they are ω × p: in these axes δω = dδπ/dt + ω × δπ. These are Euler's equations, a case of the
//! Boltzmann–Hamel equations (Lurie, *Analytical Mechanics*, §10.1).
//!
//! In numbers, take the moments of inertia 1, 2, 3 and ω = (0, 1, 1). Then p = (0, 2, 3) and ω × p =
//! (1, 0, 0), so ω̇ = (−1, 0, 0).

use super::quadratic_form::QuadraticForm;
use crate::model::Model;
use lagrange_algebra::calculus::{adjoint, gradient, jacobian};
use lagrange_expr::expr::ExprId;

/// Adds −∂L/∂q at the rates of the positions. First-order states are not displaced.
pub(super) fn add_slopes(model: &mut Model, form: &mut QuadraticForm, slopes: &[ExprId]) {
    let graph = &mut model.graph;
    let displaced = model.coordinates.iter().zip(slopes).filter(|(coordinate, _)| !coordinate.is_state);
    for (coordinate, &slope) in displaced {
        let (factor, rate) = graph.split_coefficient(coordinate.rate);
        let opposite = graph.scale(-&factor, slope);
        form.add_linear(graph, rate, opposite);
    }
}

/// Adds ω × p at the angular velocities.
pub(super) fn add_turning(model: &mut Model, form: &mut QuadraticForm, momenta: &[ExprId]) {
    let (velocities, graph) = (model.velocities(), &mut model.graph);
    for orientation in &model.orientations {
        let first = orientation.velocity;
        for axis in 0..3 {
            let [next, last] = [first + (axis + 1) % 3, first + (axis + 2) % 3];
            let products = [
                graph.multiply(velocities[next], momenta[last]),
                graph.multiply(velocities[last], momenta[next]),
            ];
            let moment = graph.subtract(products[0], products[1]);
            form.add_linear(graph, velocities[first + axis], moment);
        }
    }
}

/// Returns Q of applied forces and of dissipation.
pub(super) fn applied_forces(model: &mut Model) -> Vec<ExprId> {
    let velocities = model.velocities();
    let loads = model.loads.iter().map(|load| (load.velocity, load.force)).collect::<Vec<_>>();
    let graph = &mut model.graph;
    let forces = adjoint(graph, &loads, &velocities);
    let resistances = gradient(graph, model.dissipation, &velocities);
    forces.into_iter().zip(resistances).map(|(force, resistance)| graph.subtract(force, resistance)).collect()
}

/// Converts derivatives with respect to positions to those with respect to displacements: ∂f/∂q N
/// replaces ∂f/∂q in each row, and the other entries stay.
pub(crate) fn along_displacements(model: &mut Model, rows: &[ExprId], columns: usize) -> Vec<ExprId> {
    let n = model.speeds.len();
    let positions = model.coordinates.iter().filter(|coordinate| !coordinate.is_state);
    let rates = positions.map(|position| position.rate).collect::<Vec<_>>();
    let velocities = model.velocities();
    // N
    let directions = jacobian(&mut model.graph, &rates, &velocities);
    let mut entries = Vec::new();
    for row in rows.chunks_exact(columns) {
        let (by_positions, others) = row.split_at(rates.len());
        for column in 0..n {
            let products = by_positions.iter().zip(&directions);
            let products = products.map(|(&slope, direction)| model.graph.multiply(slope, direction[column]));
            let products = products.collect::<Vec<_>>();
            entries.push(model.graph.total(products));
        }
        entries.extend(others);
    }
    entries
}
