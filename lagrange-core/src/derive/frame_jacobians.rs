//! Derivatives of frames: the coefficients of the generalised velocities in the angular velocity
//! and in the velocity of the origin. Their rates without accelerations follow.
//!
//! Both are affine in the velocities: ω = J_ω v + ω₀ and ṙ = J_r v + r₀. The offsets appear if
//! frames move explicitly in time. The rows are reverse-mode gradients, one for each component, so
//! expressions that joints share stay shared.
//!
//! Accelerations are then J v̇ + b, with the bias b = J̇ v, or J̇_ω v + ω̇₀ and J̇_r v + r̈₀ with
//! the offsets.
//!
//! Source: Siciliano, Sciavicco, Villani, Oriolo, *Robotics: Modelling, Planning and Control*,
//! §3.1.

use crate::model::Model;
use lagrange_algebra::calculus::{AccelerationTerms, Rates, gradient};
use lagrange_expr::expr::ExprId;

/// Returns the Jacobians of all frames of a model, row by row.
pub(super) fn frame_jacobians(model: &mut Model) -> Vec<Vec<ExprId>> {
    let velocities = model.velocities();
    let (graph, twists) = (&mut model.graph, &model.scene.twists);
    let rows_of = |values: &[ExprId]| {
        values.iter().flat_map(|&component| gradient(graph, component, &velocities)).collect()
    };
    twists.iter().map(|twist| &twist.values[..]).map(rows_of).collect()
}

/// Returns the angular acceleration and the acceleration of the origin of all frames of a model,
/// for constant velocities.
pub(super) fn frame_biases(model: &mut Model) -> Vec<[ExprId; 6]> {
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let (graph, twists) = (&mut model.graph, &model.scene.twists);
    twists.iter().map(|twist| twist.values.map(|component| rates.of(graph, component))).collect()
}
