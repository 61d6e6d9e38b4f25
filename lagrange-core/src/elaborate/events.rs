//! `event` statements: zeros to be found during a motion, and what happens there.

#[cfg(test)]
mod tests;

use super::elaborator::Elaborator;
use super::messages::events as messages;
use super::scope::Kind;
use crate::diagnostics::Origin;
use crate::expr::{Dependencies, ExprId};
use crate::model::{Action, Assignment, Event};
use crate::syntax::ast::{self, AstId, Expression, Name, StatementKind};

/// The most events that run-time code can watch.
const MOST_EVENTS: usize = 32;

impl Elaborator<'_> {
    pub(super) fn event(&mut self, event: &ast::Event) {
        let (value, action) = match &event.action {
            ast::Action::Impact(restitution) => return self.contact(event, *restitution),
            ast::Action::Stop => (self.event_function(event), Some(Action::Stop)),
            ast::Action::Record => (self.event_function(event), Some(Action::Record)),
            ast::Action::Assign(assignments) => {
                (self.event_function(event), self.assignments(&event.name, assignments))
            }
        };
        self.declare(&event.name, Kind::Event, None);
        if let (Some(value), Some(action)) = (value, action) {
            self.add_event(event, value, action);
        }
    }

    pub(super) fn add_event(&mut self, event: &ast::Event, value: ExprId, action: Action) {
        let name = event.name.text.clone();
        self.events.push((Event { name, value, direction: event.direction, action }, event.name.span));
    }

    /// A scalar that can pass zero.
    fn event_function(&mut self, event: &ast::Event) -> Option<ExprId> {
        let syntax = event.value;
        self.evaluator.evaluate(syntax)?;
        let value = self.evaluator.scalar(syntax, messages::EVENT_FUNCTION)?;
        let kinds = &[Dependencies::REACTION];
        self.forbid(kinds, (syntax, value), messages::EVENT_FUNCTION, messages::EVENT_FUNCTION_HELP)?;
        let state = Dependencies::TIME | Dependencies::COORDINATE | Dependencies::VELOCITY;
        let changing = state | Dependencies::INPUT | Dependencies::ACCELERATION | Dependencies::MULTIPLIER;
        if self.evaluator.graph.dependencies(value).intersects(changing) {
            return Some(value);
        }
        let origin = self.evaluator.origin(syntax);
        let error = self.evaluator.report.error(origin, messages::constant_event(&event.name.text));
        error.help(messages::CONSTANT_EVENT_HELP);
        None
    }

    fn assignments(&mut self, event: &Name, assignments: &[ast::Assignment]) -> Option<Action> {
        let mut assigned: Vec<(usize, Origin)> = Vec::new();
        let mut sound = Vec::new();
        for assignment in assignments {
            let index = self.target(assignment.target);
            let value = self.term(assignment.value, event.span, messages::ASSIGNED_VALUE);
            let Some(index) = index else { continue };
            self.check_assigned_once(index, self.evaluator.origin(assignment.target), &mut assigned);
            sound.extend(value.map(|value| Assignment { index, value: value.value }));
        }
        (sound.len() == assignments.len()).then_some(Action::Assign(sound))
    }

    fn check_assigned_once(&mut self, index: usize, origin: Origin, assigned: &mut Vec<(usize, Origin)>) {
        if let Some((_, first)) = assigned.iter().find(|(other, _)| *other == index) {
            let count = self.declaration.coordinates().len();
            let name =
                |i: usize| self.coordinates.get(i).map_or("", |(coordinate, _)| coordinate.name.as_str());
            let target = match index.checked_sub(count) {
                Some(velocity) => format!("dot({})", name(velocity)),
                None => name(index).to_owned(),
            };
            let error = self.evaluator.report.error(origin, messages::assigned_twice(&target));
            error.related(*first, messages::ASSIGNED_HERE).help(messages::ASSIGNED_TWICE_HELP);
        }
        assigned.push((index, origin));
    }

    /// The index in [q…, v…] of what is assigned to.
    fn target(&mut self, syntax: AstId) -> Option<usize> {
        let (coordinate, is_velocity) = match self.evaluator.syntax(syntax) {
            Expression::Call(function, arguments) if function.text == "dot" && arguments.len() == 1 => {
                (arguments[0], true)
            }
            _ => (syntax, false),
        };
        let count = self.declaration.coordinates().len();
        let Expression::Name(text) = self.evaluator.syntax(coordinate) else {
            // What is wrong within it is said first.
            self.evaluator.evaluate(syntax)?;
            let error = self.evaluator.report.error(self.evaluator.origin(syntax), messages::NOT_ASSIGNABLE);
            error.help(messages::ASSIGNMENT_HELP);
            return None;
        };
        if self.evaluator.scope.resolve(text).is_none() {
            self.evaluator.evaluate(coordinate);
            return None;
        }
        let position = self.coordinates.iter().position(|(known, _)| known.name == *text);
        if position.is_none() {
            let name = Name { text: text.clone(), span: self.evaluator.origin(coordinate).start };
            self.report_no_coordinate(&name, messages::ASSIGNMENT_HELP);
        }
        position.map(|index| if is_velocity { count + index } else { index })
    }

    /// Friction that sticks and slips is an event, too.
    pub(super) fn check_event_count(&mut self) {
        let names = self.declaration.statements.iter().filter_map(|statement| match &statement.kind {
            StatementKind::Event(event) => Some(&event.name),
            StatementKind::Friction(friction) if friction.width.is_none() => Some(&friction.name),
            _ => None,
        });
        if let Some(name) = names.into_iter().nth(MOST_EVENTS) {
            let error = self.evaluator.report.error(name.span, messages::too_many_events(MOST_EVENTS));
            error.help(messages::TOO_MANY_EVENTS_HELP);
        }
    }

    /// A reduced system would need events and modes of its own.
    pub(super) fn check_reduced_events(&mut self) {
        let events = self.events.iter().map(|(_, span)| *span);
        let mut declared = events.chain(self.reactions.iter().map(|(_, span)| *span));
        if let (Some(span), Some(reduction)) = (declared.next(), self.reductions.first()) {
            let error = self.evaluator.report.error(reduction.name.span, messages::REDUCED_EVENTS);
            error.related(Origin::from(span), messages::EVENT_IS_HERE).help(messages::REDUCED_HELP);
        }
    }
}
