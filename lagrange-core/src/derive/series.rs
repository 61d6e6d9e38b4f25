//! Equations of motion in the cheapest form for Taylor series.
//!
//! Accelerations as functions of the state contain every product of the solution process. The
//! residual contains fewer, especially if the rates u̇ of the velocities in T = ½ Σ w u² are not
//! expanded. A series yields them from u. For a chain, the residual Σ w u̇ (∂u/∂v) + … has four
//! products of series per joint. Its accelerations have many times more.
//!
//! The multipliers λ of constraints are additional unknowns. The residual then contains −Aᵀλ and is
//! followed by the rate of each constraint's velocity, which is not expanded either.

use super::constraints::{ConstraintEquations, stabilised};
use super::elimination::solution::push_down;
use super::least_constraint::{SplitLagrangian, Terms, loads_beside_squares};
use crate::model::Model;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

/// The residual of the equations of motion, linear in accelerations, multipliers and unexpanded
/// rates.
#[derive(Clone, Debug)]
pub struct SeriesEquations {
    /// One residual for each acceleration, then one for each multiplier.
    pub residuals: Vec<ExprId>,
    /// Symbols for rates, each with the velocity that it is the rate of.
    pub unexpanded: Vec<(ExprId, ExprId)>,
}

/// Symbols for rates, by velocity.
#[derive(Default)]
struct UnexpandedRates(OrderedMap<ExprId, ExprId>);

impl UnexpandedRates {
    fn of(&mut self, graph: &mut Graph, velocity: ExprId) -> ExprId {
        let index = u32::try_from(self.0.len()).expect("fewer than 2^32 velocities fit in memory");
        *self.0.get_or_insert_with(velocity, || graph.symbol("rate", Role::Placeholder(index)))
    }
}

impl SeriesEquations {
    /// Computes the residual d/dt ∂L/∂v − ∂L/∂q − Q − Aᵀλ and the rates of the constraints'
    /// velocities.
    pub(super) fn new(
        model: &mut Model,
        split: &SplitLagrangian,
        constraints: &ConstraintEquations,
    ) -> SeriesEquations {
        let mut form = loads_beside_squares(model, split, AccelerationTerms::Kept, Terms::All);
        let mut rates = UnexpandedRates::default();
        for &(weight, u) in &split.squares {
            let rate = rates.of(&mut model.graph, u);
            let inertial = model.graph.multiply(weight, rate);
            form.add_linear(&model.graph, u, inertial);
        }
        let velocities = model.velocities();
        let pushed = push_down(&mut model.graph, form, &velocities);
        let mut residuals =
            velocities.iter().map(|&v| pushed.linear(&mut model.graph, v)).collect::<Vec<_>>();
        for (residual, &force) in residuals.iter_mut().zip(&constraints.forces) {
            *residual = model.graph.subtract(*residual, force);
        }
        for constraint in &model.constraints {
            let rate = rates.of(&mut model.graph, constraint.velocity);
            residuals.push(stabilised(&mut model.graph, model.stabilisation, constraint, rate));
        }
        SeriesEquations { residuals, unexpanded: rates.0.iter().map(|(&u, &rate)| (rate, u)).collect() }
    }
}
