//! Residual of the equations of motion: the forces that must act in addition to the declared ones
//! to produce given accelerations.

use super::elimination::solution::push_down;
use super::least_constraint::{SplitLagrangian, Terms, linear_form};
use crate::model::Model;
use lagrange_algebra::calculus::AccelerationTerms;
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
