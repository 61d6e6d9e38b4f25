//! Equations of motion in the form in which Taylor series cost least.
//!
//! Accelerations as functions of the state hold every product that solving the equations takes. The residual that they make zero holds
//! fewer, above all if the rates u̇ of the velocities in T = ½ Σ w u² stay as they are: a series knows them once it knows u. So the
//! residual Σ w u̇ (∂u/∂v) + … of a chain has four products of series a joint, and its accelerations have many times as many.

use super::elimination::solution::push_down;
use super::least_constraint::{SplitLagrangian, Terms, loads_beside_squares};
use crate::model::Model;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::ExprId;
use lagrange_expr::symbol::Role;

/// The residual of the equations of motion, linear in accelerations and in rates that are not written out.
#[derive(Clone, Debug)]
pub struct SeriesEquations {
    /// One residual for each acceleration.
    pub residuals: Vec<ExprId>,
    /// Symbols that stand for rates, each with the velocity that it is the rate of.
    pub unexpanded: Vec<(ExprId, ExprId)>,
}

impl SeriesEquations {
    /// The residual d/dt ∂L/∂v − ∂L/∂q − Q.
    pub(super) fn new(model: &mut Model, split: &SplitLagrangian) -> SeriesEquations {
        let mut form = loads_beside_squares(model, split, AccelerationTerms::Kept, Terms::All);
        let mut rates: OrderedMap<ExprId, ExprId> = OrderedMap::default();
        for &(weight, u) in &split.squares {
            let index = u32::try_from(rates.len()).expect("fewer than 2^32 velocities fit in memory");
            let graph = &mut model.graph;
            let rate = *rates.get_or_insert_with(u, || graph.symbol("rate", Role::Placeholder(index)));
            let inertial = graph.multiply(weight, rate);
            form.add_linear(graph, u, inertial);
        }
        let velocities = model.velocities();
        let pushed = push_down(&mut model.graph, form, &velocities);
        let residuals = velocities.iter().map(|&v| pushed.linear(&mut model.graph, v)).collect();
        SeriesEquations { residuals, unexpanded: rates.iter().map(|(&u, &rate)| (rate, u)).collect() }
    }
}
