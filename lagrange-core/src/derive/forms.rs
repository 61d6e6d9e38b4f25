//! The quadratic form from which all equations follow. It is written over the variables of the
//! declaration or over the generalised velocities. In the latter its coefficients are the mass
//! matrix M and its linear part is −f.
//!
//! A chain of n links has n² such coefficients, although its accelerations can be computed in O(n)
//! time. A large form is therefore pushed down only if its coefficients are requested.

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

/// Maximum number of unknowns for which coefficients are expanded on trial. The effects of a
/// coordinate on itself cancel. However, the number of coefficients grows quadratically, and so
/// does the number of parts that unexpanded coefficients share.
const MAX_MULTIPLIED_OUT: usize = 4;
/// Maximum number of expressions in such a form: the trial expands everything and factorises two
/// matrices.
const LARGEST_MULTIPLIED_OUT: usize = 300;
/// Maximum number of monomials in an expanded coefficient. A longer one is hardly cheaper than the
/// unexpanded coefficient.
const MULTIPLYING_BUDGET: usize = 60;

/// A matrix in rows.
pub(super) type Rows = Vec<Vec<ExprId>>;

/// The quadratic form, pushed down or not.
pub(super) struct Forms {
    /// The form with its multipliers, over the variables of the declaration.
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
    /// Creates the form of a model without pushing it down.
    pub(super) fn new(model: &mut Model, split: &SplitLagrangian) -> Forms {
        let mut forms = Forms::without_constraints(model, split);
        join_multipliers(model, &mut forms.form);
        forms
    }

    /// Creates the form of a model without its constraints, and without pushing it down.
    pub(super) fn without_constraints(model: &mut Model, split: &SplitLagrangian) -> Forms {
        let form = least_constraint_form(model, split, AccelerationTerms::Dropped, Terms::All);
        Forms { form, velocity_form: None }
    }

    /// True if the form has been pushed down.
    pub(super) fn is_pushed(&self) -> bool {
        self.velocity_form.is_some()
    }

    /// Pushes the form down to the generalised velocities.
    pub(super) fn push_down(&mut self, model: &mut Model) {
        self.pushed(model);
    }

    /// Returns the form over the generalised velocities, simplified as the accuracy level requires.
    pub(super) fn pushed(&mut self, model: &mut Model) -> &QuadraticForm {
        &self.velocity_form.get_or_insert_with(|| VelocityForm::new(model, self.form.clone())).pushed
    }

    /// Returns M in rows, or none if the form has not been pushed down.
    pub(super) fn mass_matrix(&self) -> &[Vec<ExprId>] {
        self.velocity_form.as_ref().map_or(&[], |form| &form.mass_matrix)
    }

    /// Returns M in rows, or none if the form has not been pushed down, and f.
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

/// Removes couplings that vanish identically but not formally, such as r sin θ cos θ − r cos θ sin
/// θ. They occur between polar coordinates that were introduced through Cartesian ones.
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

/// Returns the form as it is or, for a small system, with its coefficients expanded, whichever
/// leads to cheaper accelerations. The effects of a coordinate on itself often cancel in expanded
/// form, but with more than a few coordinates sharing saves more. Expansion reduces a cart-pole
/// from 28 operations to 23. Without it, a spherical pendulum loses four digits near the pole
/// (`tests/extremes`).
fn cheaper_coefficients(graph: &mut Graph, pushed: QuadraticForm, unknowns: &[ExprId]) -> QuadraticForm {
    let Some(expanded) = multiplied_out(graph, &pushed, unknowns) else { return pushed };
    let costs = [&pushed, &expanded].map(|form| {
        let solution = solve_dense(graph, form.clone(), unknowns)?;
        Some(cost(graph, &solution.values))
    });
    match costs {
        // In a tie, the form stays as declared.
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
