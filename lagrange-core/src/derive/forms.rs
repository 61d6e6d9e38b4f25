//! The quadratic form from which all equations follow. It exists over the variables of the
//! declaration, and over the generalised velocities. There its coefficients are the mass matrix M
//! and its linear part is −f.
//!
//! A chain of n links has n² such coefficients, although its accelerations take a time in
//! proportion to n. A large form is therefore pushed down only when its coefficients are requested.

use super::constraints::join_multipliers;
use super::cost::cost;
use super::elimination::contracted::contracted;
use super::elimination::solution::{push_down, solve_dense};
use super::inverse_dynamics::residual;
use super::least_constraint::{SplitLagrangian, Terms, least_constraint_form};
use super::quadratic_form::QuadraticForm;
use crate::model::Model;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_algebra::simplify::{self, vanishing};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Most unknowns for which coefficients are multiplied out as a trial. The effects of a coordinate
/// on itself cancel. However, the number of coefficients grows as its square, and so does the
/// number of parts that they share when they stay closed.
const MAX_MULTIPLIED_OUT: usize = 4;
/// Number of expressions up to which they are: the trial multiplies out everything and factorises
/// two matrices.
const LARGEST_MULTIPLIED_OUT: usize = 300;
/// Monomials up to which a coefficient is multiplied out; a longer one hardly costs less than the
/// closed one.
const MULTIPLYING_BUDGET: usize = 60;

/// A matrix in rows.
pub(super) type Rows = Vec<Vec<ExprId>>;

/// The quadratic form, pushed down or not.
pub(super) struct Forms {
    /// The form with its multipliers over the variables that it was declared in.
    pub(super) form: QuadraticForm,
    velocity_form: Option<VelocityForm>,
}

/// The form over the generalised velocities, and the two sides of M q̈ = f.
struct VelocityForm {
    pushed: QuadraticForm,
    mass_matrix: Rows,
    forcing: Vec<ExprId>,
}

impl Forms {
    /// The form of a model, not pushed down.
    pub(super) fn new(model: &mut Model, split: &SplitLagrangian) -> Forms {
        let mut form = least_constraint_form(model, split, AccelerationTerms::Dropped, Terms::All);
        join_multipliers(model, &mut form);
        Forms { form, velocity_form: None }
    }

    /// True if it has been pushed down.
    pub(super) fn is_pushed(&self) -> bool {
        self.velocity_form.is_some()
    }

    /// Pushes it down.
    pub(super) fn push_down(&mut self, model: &mut Model) {
        self.pushed(model);
    }

    /// The form over the generalised velocities, simplified as the level of accuracy asks.
    pub(super) fn pushed(&mut self, model: &mut Model) -> &QuadraticForm {
        &self.velocity_form.get_or_insert_with(|| VelocityForm::new(model, self.form.clone())).pushed
    }

    /// M in rows; none if the form has not been pushed down.
    pub(super) fn mass_matrix(&self) -> &[Vec<ExprId>] {
        self.velocity_form.as_ref().map_or(&[], |form| &form.mass_matrix)
    }

    /// M in rows, none if the form has not been pushed down, and f.
    pub(super) fn into_sides(self, model: &mut Model, split: &SplitLagrangian) -> (Rows, Vec<ExprId>) {
        if let Some(VelocityForm { mass_matrix, forcing, .. }) = self.velocity_form {
            return (mass_matrix, forcing);
        }
        let opposite = residual(model, split, AccelerationTerms::Dropped, Terms::All);
        (Rows::new(), opposite.into_iter().map(|value| model.graph.negate(value)).collect())
    }
}

impl VelocityForm {
    fn new(model: &mut Model, form: QuadraticForm) -> VelocityForm {
        let (velocities, unknowns) = (model.velocities(), model.unknowns());
        let graph = &mut model.graph;
        let mut pushed = push_down(graph, form, &velocities);
        separate_uncoupled(graph, &mut pushed, &velocities);
        let pushed = match model.accuracy {
            Accuracy::Strict => contracted(graph, pushed, &unknowns),
            _ => cheaper_coefficients(graph, pushed, &unknowns),
        };
        let mass_matrix = pushed.matrix(graph, &Number::ONE, &velocities, &velocities);
        let forcing = forcing(graph, &pushed, &velocities);
        VelocityForm { pushed, mass_matrix, forcing }
    }
}

/// Removes couplings that vanish without showing it: r sin θ cos θ − r cos θ sin θ. They occur
/// between polar coordinates that were defined by Cartesian ones.
fn separate_uncoupled(graph: &mut Graph, pushed: &mut QuadraticForm, velocities: &[ExprId]) {
    let places = velocities.iter().enumerate().map(|(n, &v)| (v, n)).collect::<HashMap<_, _>>();
    let above_diagonal = |(n, &i): (usize, &ExprId)| {
        let near = pushed.near(i).filter_map(|j| Some((*places.get(&j)?, j)));
        let mut near = near.filter(|(place, _)| *place > n).collect::<Vec<_>>();
        near.sort_unstable();
        near.into_iter().map(move |(_, j)| (i, j))
    };
    let pairs = velocities.iter().enumerate().flat_map(above_diagonal).collect::<Vec<_>>();
    let couplings = pairs.iter().map(|&(i, j)| pushed.coefficient(graph, i, j)).collect::<Vec<_>>();
    let vanishing = vanishing(graph, &couplings);
    let uncoupled = pairs.iter().zip(vanishing).filter(|(_, vanishes)| *vanishes);
    uncoupled.for_each(|(&(i, j), _)| pushed.separate(i, j));
}

/// The form as it is or, for a small system, with its coefficients multiplied out, whichever leads
/// to the accelerations at less cost. What a coordinate does to itself often cancels when
/// multiplied out, but sharing beats that from a few coordinates on. It turns 28 operations of a
/// cart-pole into 23, and without it a spherical pendulum loses four digits near the pole
/// (`tests/extremes`).
fn cheaper_coefficients(graph: &mut Graph, pushed: QuadraticForm, unknowns: &[ExprId]) -> QuadraticForm {
    let Some(expanded) = multiplied_out(graph, &pushed, unknowns) else { return pushed };
    let costs = [&pushed, &expanded].map(|form| {
        let solution = solve_dense(graph, form.clone(), unknowns)?;
        Some(cost(graph, &solution.values))
    });
    match costs {
        // Equal costs leave the form as it was declared.
        [Some(as_it_is), Some(multiplied_out)] if multiplied_out < as_it_is => expanded,
        _ => pushed,
    }
}

fn multiplied_out(graph: &mut Graph, pushed: &QuadraticForm, unknowns: &[ExprId]) -> Option<QuadraticForm> {
    if unknowns.len() > MAX_MULTIPLIED_OUT {
        return None;
    }
    let pairs = unknowns.iter().enumerate().flat_map(|(n, &i)| unknowns[n..].iter().map(move |&j| (i, j)));
    let pairs = pairs.collect::<Vec<_>>();
    let mut coefficients = pairs.iter().map(|&(i, j)| pushed.coefficient(graph, i, j)).collect::<Vec<_>>();
    coefficients.extend(unknowns.iter().map(|&id| pushed.linear(graph, id)).collect::<Vec<_>>());
    if graph.reachable(&coefficients).len() > LARGEST_MULTIPLIED_OUT {
        return None;
    }
    let expanded = simplify::multiply_out(graph, &coefficients, MULTIPLYING_BUDGET);
    let (quadratic, linear) = expanded.split_at(pairs.len());
    let mut form = QuadraticForm::default();
    pairs.iter().zip(quadratic).for_each(|(&(i, j), &value)| form.add_pair(graph, i, j, value));
    unknowns.iter().zip(linear).for_each(|(&id, &value)| form.add_linear(graph, id, value));
    Some(form)
}

fn forcing(graph: &mut Graph, pushed: &QuadraticForm, velocities: &[ExprId]) -> Vec<ExprId> {
    let opposite = |&v: &ExprId| {
        let value = pushed.linear(graph, v);
        graph.negate(value)
    };
    velocities.iter().map(opposite).collect()
}
