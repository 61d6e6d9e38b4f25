//! Jacobians of the right-hand side ẏ = [q̇, a], as methods.
//!
//! Positions q are displaced to q + N(q) δ, and with them velocities to v + ε. Where velocities are
//! rates of coordinates, δ̇ = ε. Of a unit quaternion δ is a small turn along the turned axes,
//! which turn with ω: δ̇ = ε − ω × δ. Accelerations follow by the chain rule, ε̇ = ∂a/∂q N δ +
//! ∂a/∂v ε.
//!
//! Source: Sola, Deray, Atchuthan, "A micro Lie theory for state estimation in robotics", 2018,
//! §IV.

use crate::model::Model;
use lagrange_algebra::calculus::jacobian;
use lagrange_expr::expr::ExprId;

/// ∂ẏ/∂y from the rows of the accelerations.
pub(in crate::emit) fn by_state(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    let rates = model.position_rates();
    let state = [model.positions(), model.velocities()].concat();
    let mut entries = jacobian(&mut model.graph, &rates, &state).concat();
    entries.extend(accelerations);
    entries
}

/// The matrix that [δ, ε] changes with, from the rows ∂a/∂y of the accelerations.
pub(in crate::emit) fn by_displacements(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    let (positions, n) = (model.coordinates.len(), model.speeds.len());
    let mut entries = rates_of_displacements(model);
    let rates = model.position_rates();
    let velocities = model.velocities();
    // N
    let directions = jacobian(&mut model.graph, &rates, &velocities);
    for row in accelerations.chunks_exact(positions + n) {
        let (by_positions, by_velocities) = row.split_at(positions);
        for column in 0..n {
            let products = by_positions.iter().zip(&directions);
            let products = products.map(|(&slope, direction)| model.graph.multiply(slope, direction[column]));
            let products = products.collect::<Vec<_>>();
            entries.push(model.graph.total(products));
        }
        entries.extend(by_velocities);
    }
    entries
}

/// The rows of δ̇.
fn rates_of_displacements(model: &mut Model) -> Vec<ExprId> {
    let (velocities, n) = (model.velocities(), model.speeds.len());
    let graph = &mut model.graph;
    let mut rows = vec![vec![graph.number(0); 2 * n]; n];
    rows.iter_mut().enumerate().for_each(|(i, row)| row[n + i] = graph.number(1));
    for first in model.orientations.iter().map(|orientation| orientation.velocity) {
        for axis in 0..3 {
            let [next, last] = [first + (axis + 1) % 3, first + (axis + 2) % 3];
            rows[first + axis][next] = velocities[last];
            rows[first + axis][last] = graph.negate(velocities[next]);
        }
    }
    rows.concat()
}

/// The derivatives of ẏ by parameters and inputs from the rows of the accelerations.
pub(in crate::emit) fn by_fields(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    let fields = model.parameters.iter().chain(&model.inputs).map(|field| field.symbol);
    let (rates, fields) = (model.position_rates(), fields.collect::<Vec<_>>());
    let mut entries = jacobian(&mut model.graph, &rates, &fields).concat();
    entries.extend(accelerations);
    entries
}
