//! Jacobians of frames: what multiplies the generalised velocities in angular velocity and velocity
//! of the origin.
//!
//! Both are affine in the velocities, ω = J_ω v + ω₀ and ṙ = J_r v + r₀, with ω₀ and r₀ where
//! places depend on time. The rows are gradients in reverse mode, one for each component, so that
//! what the joints share stays shared.
//!
//! Source: Siciliano, Sciavicco, Villani, Oriolo, *Robotics: Modelling, Planning and Control*,
//! §3.1.

use crate::model::Model;
use lagrange_algebra::calculus::gradient;
use lagrange_expr::expr::ExprId;

/// The Jacobians of all frames of a model, row by row.
pub(super) fn frame_jacobians(model: &mut Model) -> Vec<Vec<ExprId>> {
    let velocities = model.velocities();
    let (graph, twists) = (&mut model.graph, &model.scene.twists);
    let rows_of = |values: &[ExprId]| {
        values.iter().flat_map(|&component| gradient(graph, component, &velocities)).collect()
    };
    twists.iter().map(|twist| &twist.values[..]).map(rows_of).collect()
}
