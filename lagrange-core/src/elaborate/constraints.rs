//! Constraints as statements: what is zero, and what that demands of the velocities.

use super::elaborator::Elaborator;
use super::messages;
use super::operand::Operand;
use super::scope::Kind;
use crate::calculus::{Degree, Degrees};
use crate::diagnostics::Origin;
use crate::expr::{Dependencies, ExprId};
use crate::model::Constraint;
use crate::simplify::vanishing;
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
