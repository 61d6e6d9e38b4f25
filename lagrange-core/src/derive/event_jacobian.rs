//! Derivatives of the functions of events, which show how near and how transversal their zeros are.

use crate::model::Model;
use lagrange_algebra::calculus::{jacobian, substitute_all};
use lagrange_expr::expr::ExprId;
use lagrange_expr::symbol::Role;

/// Returns the derivatives of the functions of all events with respect to the state and to time, in
/// rows. Accelerations and multipliers are functions of these.
pub(super) fn event_jacobian(
    model: &mut Model,
    accelerations: &[ExprId],
    multipliers: &[ExprId],
) -> Vec<ExprId> {
    let symbols = model.speeds.iter().map(|speed| speed.acceleration).zip(accelerations.iter().copied());
    let symbols = symbols.chain(model.multipliers().into_iter().zip(multipliers.iter().copied()));
    let known = symbols.collect();
    let values = model.events.iter().map(|event| event.value).collect::<Vec<_>>();
    let mut arguments = [model.positions(), model.velocities()].concat();
    let graph = &mut model.graph;
    arguments.push(graph.symbol("t", Role::Time));
    let values = substitute_all(graph, &values, &known);
    jacobian(graph, &values, &arguments).concat()
}
