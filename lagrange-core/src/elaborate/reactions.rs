//! Contacts, which are events with an impact, and `friction` statements.
//!
//! Each acts along the gradient of a velocity that is affine in q̇: of the rate of its gap, or of its slip velocity.

use super::elaborator::{Elaborator, UNKNOWNS};
use super::messages::events as messages;
use super::operand::Operand;
use super::scope::Kind;
use crate::calculus::{Degree, Degrees, evaluate};
use crate::expr::{Dependencies, ExprId};
use crate::model::{Action, Reaction, ReactionKind};
use crate::symbol::Role;
use crate::syntax::ast::{self, AstId, Direction, Name};

impl Elaborator<'_> {
    /// `event name = gap, falling => impact(e);`
    pub(super) fn contact(&mut self, event: &ast::Event, restitution: AstId) {
        let gap = self.gap(event);
        let restitution = self.restitution(restitution, &event.name);
        let parts = gap.and_then(|(gap, velocity)| {
            Some((velocity, ReactionKind::Contact { gap, restitution: restitution? }))
        });
        let index = self.reactions.len() as u32;
        if self.add_reaction(&event.name, Kind::Contact, parts)
            && let Some(Operand::Scalar(value)) = self.evaluator.value(event.value)
        {
            self.add_event(event, value, Action::Impact(index));
        }
    }

    /// `friction name = slip, limit;`
    pub(super) fn friction(&mut self, friction: &ast::Friction) {
        let name = &friction.name;
        let velocity = self.slip_velocity(friction);
        let kinetic = self.limit(name, friction.kinetic);
        let fixed = match friction.fixed {
            Some(fixed) => self.limit(name, fixed),
            None => kinetic,
        };
        let width = friction.width.map(|width| self.width(width));
        let kind = match width {
            Some(width) => kinetic.zip(width).map(|(limit, width)| ReactionKind::Smooth { limit, width }),
            None => kinetic.zip(fixed).map(|(kinetic, fixed)| ReactionKind::Friction { kinetic, fixed }),
        };
        if let (Some(ReactionKind::Friction { kinetic, fixed }), Some(syntax)) = (kind, friction.fixed) {
            self.check_order(kinetic, fixed, syntax);
        }
        self.add_reaction(name, Kind::Friction, velocity.zip(kind));
    }

    /// Declares its name, which stands for its force; whether there is nothing wrong with it.
    fn add_reaction(&mut self, name: &Name, kind: Kind, parts: Option<(ExprId, ReactionKind)>) -> bool {
        let Some((velocity, reaction)) = parts else {
            self.declare(name, kind, None);
            return false;
        };
        let symbol = self.evaluator.graph.symbol(&name.text, Role::Reaction(self.reactions.len() as u32));
        self.declare(name, kind, Some(Operand::Scalar(symbol)));
        let reaction = Reaction { name: name.text.clone(), symbol, velocity, kind: reaction };
        self.reactions.push((reaction, name.span));
        true
    }

    /// A function that is positive where bodies are apart, and its rate.
    fn gap(&mut self, event: &ast::Event) -> Option<(ExprId, ExprId)> {
        if event.direction == Direction::Crossing {
            let error = self.evaluator.report.error(event.direction_span, messages::CROSSING_IMPACT);
            error.help(messages::CROSSING_IMPACT_HELP);
        }
        let syntax = event.value;
        self.evaluator.evaluate(syntax)?;
        let value = self.evaluator.scalar(syntax, messages::GAP)?;
        let kinds = [&[Dependencies::VELOCITY], UNKNOWNS].concat();
        self.forbid(&kinds, (syntax, value), messages::GAP, messages::GAP_HELP)?;
        if !self.evaluator.graph.dependencies(value).intersects(Dependencies::COORDINATE) {
            let message = messages::gap_without_coordinate(&event.name.text);
            self.evaluator.report.error(self.evaluator.origin(syntax), message).help(messages::GAP_HELP);
            return None;
        }
        let gap = match event.direction {
            Direction::Rising => self.evaluator.graph.negate(value),
            Direction::Falling => value,
            Direction::Crossing => return None,
        };
        match self.evaluator.rate(&Operand::Scalar(gap), syntax)? {
            Operand::Scalar(velocity) => Some((gap, velocity)),
            Operand::Vector(_) => None,
        }
    }

    fn restitution(&mut self, syntax: AstId, event: &Name) -> Option<ExprId> {
        let value = self.term(syntax, event.span, messages::RESTITUTION)?.value;
        match self.numeric(value).filter(|number| !(0.0..=1.0).contains(number)) {
            None => Some(value),
            Some(number) => {
                self.refuse(syntax, &messages::restitution_out_of_range(number), messages::RESTITUTION_HELP)
            }
        }
    }

    fn slip_velocity(&mut self, friction: &ast::Friction) -> Option<ExprId> {
        let (name, syntax) = (&friction.name.text, friction.slip);
        let velocity = self.term(syntax, friction.name.span, messages::SLIP)?.value;
        if !self.evaluator.graph.dependencies(velocity).intersects(Dependencies::VELOCITY) {
            return self.refuse(syntax, &messages::slip_without_velocity(name), messages::SLIP_HELP);
        }
        if self.degree(velocity, Dependencies::VELOCITY) == Degree::Nonlinear {
            return self.refuse(syntax, &messages::nonlinear_slip(name), messages::SLIP_HELP);
        }
        // To stick is to keep the slip velocity, whose rate must then be known.
        if friction.width.is_none() {
            self.evaluator.rate(&Operand::Scalar(velocity), syntax)?;
        }
        Some(velocity)
    }

    fn limit(&mut self, name: &Name, syntax: AstId) -> Option<ExprId> {
        self.evaluator.evaluate(syntax)?;
        let limit = self.evaluator.scalar(syntax, messages::LIMIT)?;
        let kinds = &[Dependencies::ACCELERATION];
        self.forbid(kinds, (syntax, limit), messages::LIMIT, messages::LIMIT_HELP)?;
        let forces = Dependencies::MULTIPLIER | Dependencies::REACTION;
        if self.degree(limit, forces) == Degree::Nonlinear {
            let message = messages::nonlinear_limit(&name.text);
            return self.refuse(syntax, &message, messages::NONLINEAR_LIMIT_HELP);
        }
        match self.numeric(limit).filter(|&number| number < 0.0) {
            None => Some(limit),
            Some(number) => {
                self.refuse(syntax, &messages::negative_limit(number), messages::NEGATIVE_LIMIT_HELP)
            }
        }
    }

    fn check_order(&mut self, kinetic: ExprId, fixed: ExprId, syntax: AstId) {
        let margin = self.evaluator.graph.subtract(fixed, kinetic);
        if self.numeric(margin).is_some_and(|margin| margin < 0.0) {
            let origin = self.evaluator.origin(syntax);
            let error = self.evaluator.report.error(origin, messages::STATIC_BELOW_KINETIC);
            error.help(messages::STATIC_BELOW_KINETIC_HELP);
        }
    }

    fn width(&mut self, syntax: AstId) -> Option<ExprId> {
        let width = self.constant_in_motion(syntax, messages::WIDTH)?;
        match self.numeric(width).filter(|&number| number <= 0.0) {
            None => Some(width),
            Some(number) => self.refuse(syntax, &messages::width_not_positive(number), messages::WIDTH_HELP),
        }
    }

    fn degree(&self, value: ExprId, kinds: Dependencies) -> Degree {
        let graph = &self.evaluator.graph;
        let mut degrees = Degrees::in_terms_of(kinds);
        degrees.classify(graph, &[value]);
        degrees.of(graph, value)
    }

    /// The number that an expression is in every motion of every system, if it is one.
    pub(super) fn numeric(&self, value: ExprId) -> Option<f64> {
        let graph = &self.evaluator.graph;
        let is_number = graph.dependencies(value) == Dependencies::NONE;
        is_number.then(|| evaluate(graph, &[value], |_| f64::NAN)[0])
    }

    /// Reports an expression.
    pub(super) fn refuse<T>(&mut self, syntax: AstId, message: &str, help: &str) -> Option<T> {
        self.evaluator.report.error(self.evaluator.origin(syntax), message).help(help);
        None
    }
}
