//! Constraints as statements, and as cross terms of the quadratic form.
//!
//! A constraint c(q, t) = 0, or one that is linear in the velocities, restricts the accelerations by A a + b = 0 with A = ∂ċ/∂v
//! or ∂c/∂v. Gauss's principle then asks for the stationary point of ½ aᵀM a − fᵀa − λᵀ(A a + b): each multiplier λ is one
//! more unknown, whose only terms are −λ times the rate of the constraint, and M a = f + Aᵀλ.
//! Source: Udwadia, Kalaba, *Analytical Dynamics*, §3; Lanczos, *The Variational Principles of Mechanics*, §II.5.

use super::elaborate::Elaborator;
use super::elimination::Elimination;
use super::form::QuadraticForm;
use super::messages;
use super::model::{Constraint, Model};
use super::operand::Operand;
use super::scope::Kind;
use super::structure::vanishing;
use crate::calculus::{AccelerationTerms, Degree, Degrees, Rates};
use crate::diagnostics::Origin;
use crate::expr::{Dependencies, ExprId};
use crate::number::Number;
use crate::symbol::Role;
use crate::syntax::ast::{AstId, Name};

impl Elaborator<'_> {
    pub(super) fn constraint(&mut self, name: &Name, syntax: AstId) {
        let term = self.term(syntax, name.span, "a constraint");
        if self.evaluator.scope.find(&name.text).is_some() {
            // What is meant by the name decides what is wrong with the rest.
            self.declare(name, Kind::Constraint, None);
            return;
        }
        if let Some(term) = &term
            && self.is_implied(name, term.value)
        {
            self.implied.push(name.text.clone());
            self.declare(name, Kind::Implied, None);
            return;
        }
        let index = self.constraints.len() as u32;
        let multiplier = self.evaluator.graph.symbol(&name.text, Role::Multiplier(index));
        let velocity =
            term.and_then(|term| Some((term.value, self.constrained_velocity(name, syntax, term.value)?)));
        self.declare(name, Kind::Constraint, Some(Operand::Scalar(multiplier)));
        let Some((value, velocity)) = velocity else { return };
        self.report_repeated(name, velocity);
        let is_holonomic = !self.evaluator.graph.dependencies(value).intersects(Dependencies::VELOCITY);
        let constraint = Constraint { name: name.text.clone(), value, velocity, is_holonomic, multiplier };
        self.constraints.push((constraint, name.span));
    }

    /// Whether this is the constraint of a joint that the coordinates fulfil by themselves.
    fn is_implied(&mut self, name: &Name, value: ExprId) -> bool {
        let is_of_joint = self.joints.iter().any(|joint| joint.text == name.text);
        is_of_joint && vanishing(&mut self.evaluator.graph, &[value]) == [true]
    }

    /// What a constraint demands of the velocities; `None` if that makes no sense, which has been reported.
    fn constrained_velocity(&mut self, name: &Name, syntax: AstId, value: ExprId) -> Option<ExprId> {
        let dependencies = self.evaluator.graph.dependencies(value);
        let origin = self.evaluator.origin(syntax);
        if !dependencies.intersects(Dependencies::COORDINATE | Dependencies::VELOCITY) {
            let number = self.evaluator.graph.as_number(value).filter(|number| !number.is_zero());
            let message = match number {
                Some(number) => messages::impossible_constraint(&name.text, &number.to_string()),
                None => messages::constrains_nothing(&name.text),
            };
            let error = self.evaluator.report.error(origin, message);
            error.help(messages::CONSTRAINS_NOTHING_HELP);
            return None;
        }
        // The rate, and for accelerations also its rate, must be known.
        let Operand::Scalar(rate) = self.evaluator.rate(&Operand::Scalar(value), syntax)? else {
            return None;
        };
        if !dependencies.intersects(Dependencies::VELOCITY) {
            return Some(rate);
        }
        let mut degrees = Degrees::default();
        degrees.classify(&self.evaluator.graph, &[value]);
        if degrees.of(&self.evaluator.graph, value) == Degree::Nonlinear {
            let (place, _) = self.evaluator.blame(syntax, Dependencies::VELOCITY);
            let error = self.evaluator.report.error(place, messages::nonlinear_constraint(&name.text));
            error.help(messages::NONLINEAR_CONSTRAINT_HELP);
            return None;
        }
        Some(value)
    }

    fn report_repeated(&mut self, name: &Name, velocity: ExprId) {
        let graph = &mut self.evaluator.graph;
        let (_, core) = graph.split_coefficient(velocity);
        let same =
            self.constraints.iter().find(|(other, _)| graph.split_coefficient(other.velocity).1 == core);
        if let Some((other, span)) = same {
            let message = match self.joints.iter().any(|joint| joint.text == name.text) {
                true => messages::REPEATED_JOINT.to_owned(),
                false => messages::repeated_constraint(&name.text, &other.name),
            };
            let error =
                self.evaluator.report.error(name.span, message).help(messages::REPEATED_CONSTRAINT_HELP);
            error.related(Origin::from(*span), messages::OTHER_CONSTRAINT_IS_HERE);
        }
    }

    /// A reduced system would have to keep to constraints of its own.
    pub(super) fn check_reduced_constraints(&mut self) {
        if let (Some((_, span)), Some(reduction)) = (self.constraints.first(), self.reductions.first()) {
            let error = self.evaluator.report.error(reduction.name.span, messages::REDUCED_CONSTRAINTS);
            error.related(Origin::from(*span), messages::CONSTRAINT_IS_HERE);
            error.help(messages::REDUCED_CONSTRAINTS_HELP);
        }
    }

    /// Nothing can move, and no multiplier is determined, under more constraints than coordinates.
    pub(super) fn check_constraint_count(&mut self) {
        if self.evaluator.report.has_errors() {
            // One constraint too many may be one that was reported.
            return;
        }
        let (count, most) = (self.constraints.len(), self.coordinates.len());
        if let Some((_, span)) = self.constraints.get(most).filter(|_| most > 0) {
            let error = self.evaluator.report.error(*span, messages::too_many_constraints(count, most));
            error.help(messages::TOO_MANY_CONSTRAINTS_HELP);
        }
    }

    /// Whether a constraint holds this velocity.
    pub(super) fn is_constrained(&self, velocity: ExprId) -> bool {
        let rates = self.constraints.iter().map(|(constraint, _)| constraint.velocity).collect::<Vec<_>>();
        self.evaluator.graph.reachable(&rates).contains(&velocity)
    }
}

/// What follows from the constraints of a model.
#[derive(Clone, Default, Debug)]
pub struct ConstraintEquations {
    /// The multipliers λ in M q̈ = f + Aᵀλ as functions of t, q, v.
    pub multipliers: Vec<ExprId>,
    /// A in rows: what each constraint demands of the velocities is A v + …
    pub jacobian: Vec<Vec<ExprId>>,
    /// b in A q̈ + b = 0
    pub drifts: Vec<ExprId>,
    /// Aᵀλ, in which symbols stand for the multipliers: what is found for them at run time is more than the expressions above where
    /// constraints depend on each other or contacts act.
    pub forces: Vec<ExprId>,
    /// δ with M δ = Aᵀμ and A δ = −r, where the symbol of each multiplier stands for the residual r of its constraint.
    pub correction: Vec<ExprId>,
    /// By how much rounding grows because constraints are nearly dependent; infinite where they are. `None` where that cannot be.
    pub condition: Option<ExprId>,
    /// Whether a constraint follows from the others wherever they hold.
    pub is_redundant: bool,
}

impl ConstraintEquations {
    /// From the multipliers with their condition, the form over the velocities, and the elimination that led to them.
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

/// What brings the constraints back from the residuals that their multipliers' symbols stand for.
fn correction(model: &mut Model, elimination: &Elimination) -> Vec<ExprId> {
    let (unknowns, residuals) = (model.unknowns(), model.multipliers());
    let count = model.coordinates.len();
    let graph = &mut model.graph;
    let mut linear = vec![graph.number(0); count];
    linear.extend(residuals.into_iter().map(|residual| graph.negate(residual)));
    let mut values = elimination.solve_again(graph, &linear, &unknowns);
    values.truncate(count);
    values
}

/// b in A a + b = 0. With a rate κ of stabilisation this is c̈ + 2 κ ċ + κ² c = 0, and ċ + κ c = 0 for constraints on
/// velocities (Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972) 1–16).
fn drifts(model: &mut Model) -> Vec<ExprId> {
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let graph = &mut model.graph;
    let drift = |constraint: &Constraint| {
        let drift = rates.of(graph, constraint.velocity);
        let Some(rate) = model.stabilisation else { return drift };
        let slow = graph.multiply(rate, constraint.velocity);
        if !constraint.is_holonomic {
            return graph.add(drift, slow);
        }
        let slower = graph.multiply(rate, constraint.value);
        let square = graph.multiply(rate, slower);
        graph.sum(Number::ZERO, [(drift, Number::ONE), (slow, Number::TWO), (square, Number::ONE)])
    };
    model.constraints.iter().map(drift).collect()
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

/// A in rows: ∂ċ/∂v of each constraint, from the form that was pushed down to the velocities.
fn constraint_jacobian(model: &mut Model, pushed: &QuadraticForm) -> Vec<Vec<ExprId>> {
    let (velocities, multipliers) = (model.velocities(), model.multipliers());
    pushed.matrix(&mut model.graph, &Number::MINUS_ONE, &multipliers, &velocities)
}

/// Aᵀλ
fn constraint_forces(model: &mut Model, jacobian: &[Vec<ExprId>], multipliers: &[ExprId]) -> Vec<ExprId> {
    let (count, graph) = (model.coordinates.len(), &mut model.graph);
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
