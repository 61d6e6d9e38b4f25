//! Constraints as cross terms of the quadratic form.
//!
//! A constraint c(q, t) = 0, or one that is linear in the velocities, restricts the accelerations
//! by A a + b = 0. Here A is ∂ċ/∂v or ∂c/∂v. Gauss's principle then requires the stationary point
//! of ½ aᵀM a − fᵀa − λᵀ(A a + b). Each multiplier λ is an additional unknown, whose only terms are
//! −λ times the rate of the constraint, and M a = f + Aᵀλ. Source: Udwadia, Kalaba, *Analytical
//! Dynamics*, §3; Lanczos, *The Variational Principles of Mechanics*, §II.5.

use super::elimination::record::Elimination;
use super::quadratic_form::QuadraticForm;
use crate::model::{Constraint, Model};
use lagrange_algebra::calculus::{AccelerationTerms, Rates};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Equations that follow from the constraints of a model.
#[derive(Clone, Default, Debug)]
pub struct ConstraintEquations {
    /// The multipliers λ in M q̈ = f + Aᵀλ as functions of t, q, v.
    pub multipliers: Vec<ExprId>,
    /// A in rows: each constraint restricts the velocities by A v + …
    pub jacobian: Vec<Vec<ExprId>>,
    /// b in A q̈ + b = 0
    pub drifts: Vec<ExprId>,
    /// Aᵀλ with symbols for the multipliers. Where constraints are dependent or contacts act, their
    /// values are computed at run time and differ from the expressions above.
    pub forces: Vec<ExprId>,
    /// δ with M δ = Aᵀμ and A δ = −r, where the symbol of each multiplier stands for the residual r
    /// of its constraint.
    pub correction: Vec<ExprId>,
    /// Growth of rounding errors through constraints that are nearly dependent; infinite where they
    /// are dependent. `None` if that is impossible.
    pub condition: Option<ExprId>,
    /// True if a constraint follows from the others wherever they hold.
    pub is_redundant: bool,
}

impl ConstraintEquations {
    /// Collects the equations from the multipliers with their condition, the form over the
    /// velocities, and the elimination that led to them.
    pub(super) fn new(
        model: &mut Model,
        pushed: &QuadraticForm,
        elimination: &Elimination,
        (multipliers, condition): (Vec<ExprId>, Option<ExprId>),
    ) -> ConstraintEquations {
        if model.constraints.is_empty() {
            return ConstraintEquations::default();
        }
        let jacobian = constraint_jacobian(model, pushed);
        let acting = model.multipliers();
        let forces = constraint_forces(model, &jacobian, &acting);
        let drifts = drifts(model);
        let correction = correction(model, elimination);
        let is_redundant = elimination.is_redundant();
        ConstraintEquations { multipliers, jacobian, drifts, forces, correction, condition, is_redundant }
    }
}

/// Returns the displacement that removes the residuals of the constraints; the symbols of their
/// multipliers stand for the residuals.
fn correction(model: &mut Model, elimination: &Elimination) -> Vec<ExprId> {
    let (unknowns, residuals) = (model.unknowns(), model.multipliers());
    let count = model.speeds.len();
    let graph = &mut model.graph;
    let mut linear = vec![graph.number(0); count];
    linear.extend(residuals.into_iter().map(|residual| graph.negate(residual)));
    let mut values = elimination.solve_again(graph, &linear, &unknowns);
    values.truncate(count);
    values
}

/// Returns b in A a + b = 0. With a rate κ of stabilisation this is c̈ + 2 κ ċ + κ² c = 0, and ċ +
/// κ c = 0 for constraints on velocities. Source: Baumgarte, Comput. Methods Appl. Mech. Eng. 1
/// (1972) 1–16.
fn drifts(model: &mut Model) -> Vec<ExprId> {
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let (graph, stabilisation) = (&mut model.graph, model.stabilisation);
    let drift = |constraint: &Constraint| {
        let drift = rates.of(graph, constraint.velocity);
        stabilised(graph, stabilisation, constraint, drift)
    };
    model.constraints.iter().map(drift).collect()
}

/// Returns the left side of the equation that enforces a constraint, from the rate of its velocity.
pub(super) fn stabilised(
    graph: &mut Graph,
    stabilisation: Option<ExprId>,
    constraint: &Constraint,
    rate: ExprId,
) -> ExprId {
    let Some(speed) = stabilisation else { return rate };
    let slow = graph.multiply(speed, constraint.velocity);
    if !constraint.is_holonomic {
        return graph.add(rate, slow);
    }
    let slower = graph.multiply(speed, constraint.value);
    let square = graph.multiply(speed, slower);
    graph.sum(Number::ZERO, [(rate, Number::ONE), (slow, Number::TWO), (square, Number::ONE)])
}

/// Adds −λ (A a + b) for every constraint.
pub(super) fn join_multipliers(model: &mut Model, form: &mut QuadraticForm) {
    let drifts = drifts(model);
    let graph = &mut model.graph;
    for (constraint, drift) in model.constraints.iter().zip(drifts) {
        let opposite = graph.negate(drift);
        form.add_linear(graph, constraint.multiplier, opposite);
        let (coefficient, velocity) = graph.split_coefficient(constraint.velocity);
        let weight = graph.number(-&coefficient);
        form.add_pair(graph, velocity, constraint.multiplier, weight);
    }
}

/// Returns A in rows: ∂ċ/∂v of each constraint, from the form that was pushed down to the
/// velocities.
fn constraint_jacobian(model: &mut Model, pushed: &QuadraticForm) -> Vec<Vec<ExprId>> {
    let (velocities, multipliers) = (model.velocities(), model.multipliers());
    pushed.matrix(&mut model.graph, &Number::MINUS_ONE, &multipliers, &velocities)
}

/// Returns Aᵀλ.
fn constraint_forces(model: &mut Model, jacobian: &[Vec<ExprId>], multipliers: &[ExprId]) -> Vec<ExprId> {
    let (count, graph) = (model.speeds.len(), &mut model.graph);
    let mut columns = vec![Vec::new(); count];
    for (row, &multiplier) in jacobian.iter().zip(multipliers) {
        let entries = columns.iter_mut().zip(row).filter(|(_, slope)| !graph.is_zero(**slope));
        entries.for_each(|(column, &slope)| column.push((slope, multiplier)));
    }
    let force = |column: Vec<(ExprId, ExprId)>| {
        let terms = column.into_iter().map(|(slope, multiplier)| graph.multiply(slope, multiplier));
        let terms = terms.collect::<Vec<_>>();
        graph.total(terms)
    };
    columns.into_iter().map(force).collect()
}
