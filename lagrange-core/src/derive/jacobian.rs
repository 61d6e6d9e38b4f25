//! Derivatives of the accelerations by coordinates, velocities and parameters.
//!
//! There are two ways, and the one that counts cheaper is kept. The accelerations can be
//! differentiated as they are computed, one sweep for each variable. Alternatively, the inverse
//! dynamics r(q, v, a) = 0 defines them, so M ∂a/∂x = −∂r/∂x at fixed accelerations. Then r needs
//! no elimination, and that of M, which exists already, serves all the variables. See Carpentier
//! and Mansard, *Analytical Derivatives of Rigid Body Dynamics Algorithms*, 2018, eq. 3.

use super::cost::cost;
use super::elimination::order::{eliminate_dense, eliminate_recursive};
use super::elimination::record::Elimination;
use super::forms::Forms;
use super::inverse_dynamics::residual;
use super::least_constraint::{SplitLagrangian, Terms};
use super::strategies::Strategy;
use super::sweep::Rotations;
use crate::model::Model;
use lagrange_algebra::calculus::{AccelerationTerms, gradient, jacobian, substitute_all};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Graph};

/// Above this many coordinates only the way is tried that is known to be cheaper there. A
/// factorised full matrix of n rows takes n³ operations, and differentiating it n⁴.
const LARGEST_TRIAL: usize = 20;

/// ∂²L/∂y² for the state y = [q, v], in rows.
pub(super) fn lagrangian_hessian(model: &mut Model) -> Vec<ExprId> {
    let state = [model.positions(), model.velocities()].concat();
    let slopes = gradient(&mut model.graph, model.lagrangian, &state);
    let rows = jacobian(&mut model.graph, &slopes, &state);
    // Either side of the diagonal may be written in another way.
    let entry = |row: usize, column: usize| rows[row.min(column)][row.max(column)];
    (0..state.len()).flat_map(|row| (0..state.len()).map(move |column| entry(row, column))).collect()
}

/// Functions that the derivatives are found from.
pub(super) struct Derivatives {
    /// The accelerations as they are computed, if they are to be differentiated.
    explicit: Option<Vec<ExprId>>,
    /// r(q, v, a), with symbols for the accelerations.
    residual: Vec<ExprId>,
    /// Eliminations of M, each to be tried with r.
    eliminations: Vec<Elimination>,
}

impl Derivatives {
    /// Prepares the ways to try. Under `strict` that is the first way, since nothing cancels in it
    /// that does not cancel in the accelerations. Under constraints it is, too, since r has no
    /// multipliers.
    pub(super) fn new(
        model: &mut Model,
        split: &SplitLagrangian,
        forms: &mut Forms,
        (accelerations, strategy): (&[ExprId], Strategy),
    ) -> Derivatives {
        let velocities = model.velocities();
        let count = velocities.len();
        let is_only_explicit = model.accuracy == Accuracy::Strict || !model.constraints.is_empty();
        let is_factorised = strategy == Strategy::MassMatrix && forms.pushed(model).is_mostly_full(count);
        let (is_small, mut eliminations) = (count <= LARGEST_TRIAL, Vec::new());
        // Where the factorised matrix is the best strategy for the accelerations, recursion is no
        // better for their slopes.
        if is_small && strategy != Strategy::MassMatrix && !is_only_explicit {
            eliminations.extend(eliminate_recursive(
                &mut model.graph,
                forms.form.clone(),
                &velocities,
                Rotations::Last,
            ));
        }
        if (is_small || is_factorised) && !is_only_explicit {
            let pushed = forms.pushed(model).clone();
            eliminations.extend(eliminate_dense(&mut model.graph, pushed, &velocities));
        }
        // A large full matrix is the one case in which the explicit way is known to lose.
        let is_explicit = is_small || !is_factorised || eliminations.is_empty();
        let residual = match eliminations.is_empty() {
            true => Vec::new(),
            false => residual(model, split, AccelerationTerms::Kept, Terms::All),
        };
        Derivatives { explicit: is_explicit.then(|| accelerations.to_vec()), residual, eliminations }
    }

    /// ∂a/∂x in rows, with an entry for each of `variables`.
    pub(super) fn by(&self, model: &mut Model, variables: &[ExprId]) -> Vec<Vec<ExprId>> {
        let explicit = self.explicit.as_ref();
        let explicit = explicit.map(|accelerations| jacobian(&mut model.graph, accelerations, variables));
        let mut found = explicit.into_iter().collect::<Vec<_>>();
        found
            .extend(self.eliminations.iter().map(|elimination| self.implicit(model, elimination, variables)));
        // One that counts as much as another is kept if it comes first.
        let costs = found.iter().map(|rows| cost(&model.graph, &rows.concat())).collect::<Vec<_>>();
        let least = (0..found.len()).min_by(|&i, &j| costs[i].total_cmp(&costs[j])).unwrap_or_default();
        found.swap_remove(least)
    }

    /// −M⁻¹ ∂r/∂x
    fn implicit(
        &self,
        model: &mut Model,
        elimination: &Elimination,
        variables: &[ExprId],
    ) -> Vec<Vec<ExprId>> {
        let velocities = model.velocities();
        let accelerations = elimination.values(&mut model.graph, &velocities);
        let slopes = jacobian(&mut model.graph, &self.residual, variables);
        let symbols = model.speeds.iter().map(|speed| speed.acceleration);
        let values = symbols.zip(accelerations).collect();
        let slopes = substitute_all(&mut model.graph, &slopes.concat(), &values);
        let column = |graph: &mut Graph, j: usize| {
            let linear = slopes.iter().skip(j).step_by(variables.len()).copied().collect::<Vec<_>>();
            elimination.solve_again(graph, &linear, &velocities)
        };
        let columns = (0..variables.len()).map(|j| column(&mut model.graph, j)).collect::<Vec<_>>();
        (0..velocities.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
    }
}
