//! Forces and torques as loads along velocities, by virtual work.
//!
//! A force F at a point p does work at the rate F·ṗ; its generalised force is ∂(F·ṗ)/∂v, so it acts on the
//! node ṗ itself and no Jacobian is formed.

use proc_macro2::Span;

use super::elaborator::Elaborator;
use super::expression::Evaluator;
use super::messages;
use super::operand::Operand;
use super::scope::Kind;
use crate::expr::Dependencies;
use crate::model::Load;
use crate::syntax::ast::{AstId, Name};

impl Elaborator<'_> {
    pub(super) fn force_on(&mut self, name: &Name, syntax: AstId) {
        let force = self.term(syntax, name.span, "a force");
        self.evaluator.scope.resolve(&name.text);
        let known = self.coordinates.iter().find(|(coordinate, _)| coordinate.name == name.text);
        match known {
            Some((coordinate, _)) => {
                let velocity = coordinate.velocity;
                self.loads.extend(force.map(|force| Load { velocity, force: force.value }));
            }
            None => self.report_no_coordinate(name, messages::FORCE_HELP),
        }
    }

    /// Reports a name that should be that of a coordinate; `usage` is the help if it is that of something else.
    pub(super) fn report_no_coordinate(&mut self, name: &Name, usage: &str) {
        let (text, origin) = (&name.text, name.span.into());
        let is_unknown = self.evaluator.scope.find(text).is_none();
        let is_told = |evaluator: &mut Evaluator| {
            evaluator.is_known_unresolved(text, origin) || evaluator.is_declared_elsewhere(text, origin)
        };
        if is_unknown && is_told(&mut self.evaluator) {
            return;
        }
        let scope = &self.evaluator.scope;
        let coordinates = self.coordinates.iter().map(|(coordinate, _)| coordinate.name.as_str());
        let help = match scope.nearest(&name.text, |kind| kind == Kind::Coordinate) {
            Some(nearest) => messages::names::did_you_mean(nearest),
            None if scope.find(&name.text).is_some() => usage.to_owned(),
            None => messages::coordinates_are(&coordinates.collect::<Vec<_>>(), usage),
        };
        match is_unknown {
            true => self.evaluator.report_unknown(text, origin, help),
            false => {
                self.evaluator.report.error(name.span, messages::not_a_coordinate(text)).help(help);
            }
        }
    }

    pub(super) fn force_at(&mut self, force: AstId, point: AstId) {
        let values = (self.evaluator.evaluate(force), self.evaluator.evaluate(point));
        let components = self.evaluator.vector(force, "a force at a point");
        let place = self.evaluator.vector(point, "the point of a force");
        let (Some(force_value), Some(point_value)) = values else { return };
        let (Some(components), Some(_)) = (components, place) else { return };
        if !force_value.same_kind(&point_value) {
            let message = messages::kinds_differ("pair", &force_value.kind(), &point_value.kind());
            let error = self.evaluator.report.error(self.evaluator.origin(point), message);
            error.help(messages::KINDS_HELP);
            return;
        }
        let sound = components.iter().all(|&c| self.forbid_accelerations(force, c, "a force").is_some());
        let velocity = self.velocity_of(point, &point_value, "the point of a force");
        if let (true, Some(velocity)) = (sound, velocity) {
            let pairs = velocity.components().iter().zip(components);
            self.loads.extend(pairs.map(|(&velocity, force)| Load { velocity, force }));
        }
    }

    pub(super) fn torque(&mut self, moment: AstId, angle: AstId, keyword: Span) {
        let moment = self.term(moment, keyword, "a torque");
        self.evaluator.evaluate(angle);
        let Some(value) = self.evaluator.scalar(angle, "the angle of a torque") else { return };
        let velocity = self.velocity_of(angle, &Operand::Scalar(value), "the angle of a torque");
        if let (Some(moment), Some(Operand::Scalar(velocity))) = (moment, velocity) {
            self.loads.push(Load { velocity, force: moment.value });
        }
    }

    /// The rate of a point or angle, which must be a function of coordinates and time.
    fn velocity_of(&mut self, syntax: AstId, value: &Operand, what: &str) -> Option<Operand> {
        for &component in value.components() {
            let moving = &[Dependencies::VELOCITY, Dependencies::ACCELERATION];
            self.forbid(moving, (syntax, component), what, messages::PLACE_HELP)?;
        }
        self.evaluator.rate(value, syntax)
    }
}
