//! Derivatives of the accelerations by coordinates, velocities and parameters.
//!
//! There are two ways, and the one that counts cheaper is kept. The accelerations can be differentiated as they are
//! computed, one sweep for each variable. Or, since the inverse dynamics r(q, v, a) = 0 defines them, M ∂a/∂x = −∂r/∂x
//! at fixed accelerations: r holds no elimination, and that of M, which is there already, is shared by all the
//! variables (Carpentier and Mansard, *Analytical Derivatives of Rigid Body Dynamics Algorithms*, 2018, eq. 3).

use super::cost::cost;
use super::equations::residual;
use super::form::QuadraticForm;
use super::gauss::{SplitLagrangian, Terms};
use super::model::Model;
use super::solve::Elimination;
use crate::calculus::{AccelerationTerms, jacobian, substitute_all};
use crate::expr::{ExprId, Graph};
use crate::syntax::ast::Accuracy;

/// Above this many coordinates only the way is taken that needs no factors of a full mass matrix.
const LARGEST_TRIAL: usize = 20;

/// The forms that the accelerations follow from.
pub(super) struct Forms {
    pub(super) form: QuadraticForm,
    /// The form over the generalised velocities.
    pub(super) pushed: QuadraticForm,
}

/// What the derivatives are found from.
pub(super) struct Derivatives {
    accelerations: Vec<ExprId>,
    /// r(q, v, a), with symbols for the accelerations.
    residual: Vec<ExprId>,
    eliminations: Vec<Elimination>,
}

impl Derivatives {
    /// Prepares both ways. Under `strict` only the first is taken, since nothing cancels in it that does not cancel in
    /// the accelerations.
    pub(super) fn new(
        model: &mut Model,
        split: &SplitLagrangian,
        forms: Forms,
        accelerations: &[ExprId],
    ) -> Derivatives {
        let accelerations = accelerations.to_vec();
        if model.accuracy == Accuracy::Strict {
            return Derivatives { accelerations, residual: Vec::new(), eliminations: Vec::new() };
        }
        let velocities = model.velocities();
        let residual = residual(model, split, AccelerationTerms::Kept, Terms::All);
        let recursive = Elimination::recursive(&mut model.graph, forms.form, &velocities);
        let dense = (velocities.len() <= LARGEST_TRIAL || recursive.is_none())
            .then(|| Elimination::dense(&mut model.graph, forms.pushed, &velocities));
        let eliminations = recursive.into_iter().chain(dense.flatten()).collect();
        Derivatives { accelerations, residual, eliminations }
    }

    /// ∂a/∂x in rows, with an entry for each of `variables`.
    pub(super) fn by(&self, model: &mut Model, variables: &[ExprId]) -> Vec<Vec<ExprId>> {
        let mut best = jacobian(&mut model.graph, &self.accelerations, variables);
        let mut least = cost(&model.graph, &best.concat());
        for elimination in &self.eliminations {
            let found = self.implicit(model, elimination, variables);
            let cost = cost(&model.graph, &found.concat());
            if cost < least {
                (best, least) = (found, cost);
            }
        }
        best
    }

    /// −M⁻¹ ∂r/∂x
    fn implicit(
        &self,
        model: &mut Model,
        elimination: &Elimination,
        variables: &[ExprId],
    ) -> Vec<Vec<ExprId>> {
        let velocities = model.velocities();
        let accelerations = elimination.solution(&mut model.graph, &velocities).accelerations;
        let slopes = jacobian(&mut model.graph, &self.residual, variables);
        let symbols = model.coordinates.iter().map(|coordinate| coordinate.acceleration);
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
