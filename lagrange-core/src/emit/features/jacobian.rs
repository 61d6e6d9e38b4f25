//! Jacobians of the right-hand side ẏ = [q̇, a], as methods.
//!
//! Positions q are displaced to q + N(q) δ, and with them velocities to v + ε. Where velocities are
//! rates of coordinates, δ̇ = ε. For a unit quaternion, δ is a small turn along the turned axes,
//! which turn with ω: δ̇ = ε − ω × δ. Accelerations follow by the chain rule, ε̇ = ∂a/∂q N δ +
//! ∂a/∂z z + ∂a/∂v ε, and so do the rates of first-order states z.
//!
//! Source: Sola, Deray, Atchuthan, "A micro Lie theory for state estimation in robotics", 2018,
//! §IV.

use crate::derive::along_displacements;
use crate::model::Model;
use lagrange_algebra::calculus::jacobian;
use lagrange_expr::expr::ExprId;

/// Returns ∂ẏ/∂y from the rows of the accelerations.
pub fn by_state(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    let rates = model.position_rates();
    let state = [model.positions(), model.velocities()].concat();
    let mut entries = jacobian(&mut model.graph, &rates, &state).concat();
    entries.extend(accelerations);
    entries
}

/// Returns the system matrix for [δ, z, ε], from the rows ∂a/∂y of the accelerations.
pub(in crate::emit) fn by_displacements(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    linearised(model, accelerations, &[])
}

/// Returns the same matrix with a column for each input, from the derivatives of the accelerations
/// with respect to the state and the inputs.
pub(super) fn linearised(model: &mut Model, accelerations: &[ExprId], inputs: &[ExprId]) -> Vec<ExprId> {
    let zeros = vec![model.graph.number(0); inputs.len()];
    let mut entries = Vec::new();
    for row in rates_of_displacements(model) {
        entries.extend(row);
        entries.extend(&zeros);
    }
    let rates = model.states().map(|state| state.rate).collect::<Vec<_>>();
    let arguments = [model.positions(), model.velocities(), inputs.to_vec()].concat();
    let mut rows = jacobian(&mut model.graph, &rates, &arguments).concat();
    rows.extend(accelerations);
    entries.extend(along_displacements(model, &rows, arguments.len()));
    entries
}

/// Returns the rows of δ̇.
fn rates_of_displacements(model: &mut Model) -> Vec<Vec<ExprId>> {
    let (velocities, n, states) = (model.velocities(), model.speeds.len(), model.states().count());
    let graph = &mut model.graph;
    let mut rows = vec![vec![graph.number(0); 2 * n + states]; n];
    rows.iter_mut().enumerate().for_each(|(i, row)| row[n + states + i] = graph.number(1));
    for first in model.orientations.iter().map(|orientation| orientation.velocity) {
        for axis in 0..3 {
            let [next, last] = [first + (axis + 1) % 3, first + (axis + 2) % 3];
            rows[first + axis][next] = velocities[last];
            rows[first + axis][last] = graph.negate(velocities[next]);
        }
    }
    rows
}

/// Returns the derivatives of ẏ with respect to parameters and inputs, from the rows of the
/// accelerations.
pub fn by_fields(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    let fields = model.parameters.iter().chain(&model.inputs).map(|field| field.symbol);
    let (rates, fields) = (model.position_rates(), fields.collect::<Vec<_>>());
    let mut entries = jacobian(&mut model.graph, &rates, &fields).concat();
    entries.extend(accelerations);
    entries
}
