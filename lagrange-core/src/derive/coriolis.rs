//! The Coriolis matrix C(t, q, v).
//!
//! Without potential forces, the bias of a Lagrangian that is quadratic in the velocities is
//! c = Γ(v, v) + G v. Its Christoffel symbols Γ_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i) are
//! symmetric in j and k, and G has gyroscopic terms. Hence ∂c/∂v = 2 Γ(v, ·) + G, and
//!
//! > C = Γ(v, ·) + G = ½ (∂c/∂v at v + ∂c/∂v at rest).
//!
//! The bias comes from a sweep, so a chain of n bodies needs n sweeps instead of the n³ symbols.
//! With C v = c, the matrix Ṁ − 2C is skew: −G is, and Ṁ = Γ(v, ·) + Γ(v, ·)ᵀ. If M depends
//! explicitly on time or on states, G also contains that part of Ṁ, so that C v = c still holds.
//!
//! For an angular velocity ω in rotating axes, Γ is the metric connection in a frame whose fields
//! do not commute. Its antisymmetric part, which c does not show, is ½ M of the brackets ω × · of
//! these fields (do Carmo, *Riemannian Geometry*, §2.3). It is added to C.
//!
//! In numbers, take the moments of inertia 1, 2, 3 and ω = (0, 0, 1). The bias ω × J ω has the
//! slopes w × J ω + ω × J w, which are (w₂, −2 w₁, 0) for w. Half of them and ½ J (ω × w) = ½ (−w₂,
//! 2 w₁, 0) sum to zero. For ω = (0, 1, 0) in their place, C w is (w₃, 0, −w₁), which is skew, too.

use super::inverse_dynamics::residual;
use super::least_constraint::{SplitLagrangian, Terms};
use crate::model::Model;
use lagrange_algebra::calculus::{AccelerationTerms, gradient, jacobian, substitute_all};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Returns C in rows.
pub(super) fn coriolis_matrix(model: &mut Model, split: &SplitLagrangian) -> Vec<ExprId> {
    let velocities = model.velocities();
    let bias = residual(model, split, AccelerationTerms::Dropped, Terms::Inertial);
    let brackets = brackets(model);
    let graph = &mut model.graph;
    let slopes = jacobian(graph, &bias, &velocities).concat();
    let zero = graph.number(0);
    let rest = velocities.iter().map(|&velocity| (velocity, zero)).collect();
    let at_rest = substitute_all(graph, &slopes, &rest);
    let half = |graph: &mut Graph, terms: &[ExprId]| {
        graph.sum(Number::ZERO, terms.iter().map(|&term| (term, Number::HALF)))
    };
    let entries = slopes.iter().zip(&at_rest).zip(&brackets);
    entries.map(|((&slope, &rest), &bracket)| half(graph, &[slope, rest, bracket])).collect()
}

/// Returns M Ω in rows, where Ω v is ω × v for each angular velocity ω and zero for rates.
fn brackets(model: &mut Model) -> Vec<ExprId> {
    let (velocities, graph) = (model.velocities(), &mut model.graph);
    let count = velocities.len();
    let mut entries = vec![graph.number(0); count * count];
    let momenta = gradient(graph, model.lagrangian, &velocities);
    for orientation in &model.orientations {
        let first = orientation.velocity;
        let columns = [0, 1, 2].map(|axis| gradient(graph, momenta[first + axis], &velocities));
        for axis in 0..3 {
            let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
            for row in 0..count {
                let gained = graph.multiply(velocities[first + last], columns[next][row]);
                let lost = graph.multiply(velocities[first + next], columns[last][row]);
                entries[row * count + first + axis] = graph.subtract(gained, lost);
            }
        }
    }
    entries
}
