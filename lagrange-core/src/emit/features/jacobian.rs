//! Jacobians of the right-hand side ẏ = [q̇, a], as methods.

use crate::calculus::jacobian;
use crate::expr::ExprId;
use crate::model::Model;

/// ∂ẏ/∂y from the rows of the accelerations.
pub(in crate::emit) fn by_state(model: &mut Model, accelerations: &[ExprId]) -> Vec<ExprId> {
    let rates = model.coordinates.iter().map(|coordinate| coordinate.rate).collect::<Vec<_>>();
    let state = [model.positions(), model.velocities()].concat();
    let mut entries = jacobian(&mut model.graph, &rates, &state).concat();
    entries.extend(accelerations);
    entries
}

/// The derivatives of ẏ by fields from the rows of the accelerations; those of the positions' rates are `zeros` zeros.
pub(in crate::emit) fn by_fields(model: &mut Model, zeros: usize, accelerations: &[ExprId]) -> Vec<ExprId> {
    let mut entries = vec![model.graph.number(0); zeros];
    entries.extend(accelerations);
    entries
}
