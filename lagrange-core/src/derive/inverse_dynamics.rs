//! Residual of the equations of motion: the forces that must act in addition to the declared ones
//! to produce given accelerations.

use super::elimination::solution::push_down;
use super::least_constraint::{SplitLagrangian, Terms, linear_form};
use super::virtual_displacements::along_displacements;
use crate::model::Model;
use lagrange_algebra::calculus::{AccelerationTerms, jacobian};
use lagrange_expr::expr::ExprId;

/// Returns the linear part at the generalised velocities.
pub(super) fn residual(
    model: &mut Model,
    split: &SplitLagrangian,
    accelerations: AccelerationTerms,
    terms: Terms,
) -> Vec<ExprId> {
    let velocities = model.velocities();
    let form = linear_form(model, split, accelerations, terms);
    let pushed = push_down(&mut model.graph, form, &velocities);
    velocities.iter().map(|&v| pushed.linear(&mut model.graph, v)).collect()
}

/// Returns the derivatives of the residual by displacements of the positions, by states and by
/// velocities, in rows.
pub(super) fn inverse_dynamics_jacobian(model: &mut Model, split: &SplitLagrangian) -> Vec<ExprId> {
    let residual = residual(model, split, AccelerationTerms::Kept, Terms::All);
    let state = [model.positions(), model.velocities()].concat();
    let rows = jacobian(&mut model.graph, &residual, &state).concat();
    along_displacements(model, &rows, state.len())
}
