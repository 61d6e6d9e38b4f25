//! The names of one declaration.

use proc_macro2::Span;

use super::messages;
use super::operand::Operand;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::diagnostics::{Report, nearest};
use lagrange_language::syntax::ast::Name;

/// Meaning of a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum NameKind {
    Parameter,
    Input,
    Noise,
    Constant,
    Coordinate,
    State,
    /// A state that only changes at events.
    Discrete,
    /// A named value of a mode.
    ModeValue,
    Velocity,
    Abbreviation,
    /// A name defined by an equation.
    Unknown,
    Constraint,
    /// A constraint of a joint that the coordinates satisfy inherently.
    Implied,
    /// An event without a force.
    Event,
    /// An event that is an impact; its name also denotes the force of the contact.
    Contact,
    Friction,
    Output,
}

impl NameKind {
    /// Describes it in the user's words.
    pub(super) fn describe(self) -> &'static str {
        match self {
            NameKind::Parameter => "parameter",
            NameKind::Input => "input",
            NameKind::Noise => "noise",
            NameKind::Constant => "constant",
            NameKind::Coordinate => "coordinate",
            NameKind::State => "state",
            NameKind::Discrete => "discrete state",
            NameKind::ModeValue => "value of a mode",
            NameKind::Velocity => "velocity",
            NameKind::Abbreviation => "`let`",
            NameKind::Unknown => "unknown of an equation",
            NameKind::Constraint | NameKind::Implied => "constraint",
            NameKind::Event => "event",
            NameKind::Contact => "contact",
            NameKind::Friction => "friction",
            NameKind::Output => "output",
        }
    }

    /// True if expressions may mention a name of this kind.
    pub(super) fn has_value(self) -> bool {
        !matches!(self, NameKind::Implied | NameKind::Event | NameKind::Output)
    }

    /// True if an unused name of this kind is likely a mistake.
    fn should_be_used(self) -> bool {
        use NameKind::{Abbreviation, Constant, Input, Noise, Parameter, Unknown};
        matches!(self, Parameter | Input | Noise | Constant | Abbreviation | Unknown)
    }
}

/// A declared name.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) kind: NameKind,
    /// Value of the name; `None` if the declaration had an error, which was reported, or the kind
    /// has no value.
    pub(super) value: Option<Operand>,
    pub(super) span: Span,
    used: bool,
    /// True if it was declared twice, so that its meaning is ambiguous.
    pub(super) is_ambiguous: bool,
}

/// All names declared so far.
#[derive(Default, Debug)]
pub(super) struct Scope {
    entries: OrderedMap<String, Entry>,
    /// Groups of unknowns of coupled equations: the use of one counts as a use of all.
    coupled: Vec<Vec<String>>,
}

impl Scope {
    /// Adds a name; reports it if it is already declared.
    pub(super) fn declare(
        &mut self,
        name: &Name,
        kind: NameKind,
        value: Option<Operand>,
        report: &mut Report,
    ) {
        if let Some(first) = self.entries.get_mut(&name.text) {
            first.is_ambiguous = true;
            let help = match kind {
                NameKind::Constraint => messages::names::NAMELESS_CONSTRAINT_HELP,
                NameKind::Event => messages::names::OTHER_EVENT_HELP,
                NameKind::Contact => messages::names::OTHER_CONTACT_HELP,
                NameKind::Output => messages::names::OTHER_OUTPUT_HELP,
                _ => messages::OTHER_NAME_HELP,
            };
            let error = report.error(name.span, messages::names::declared_twice(&name.text)).help(help);
            error.related(
                first.span.into(),
                messages::names::first_declared(&name.text, first.kind.describe()),
            );
            return;
        }
        self.entries.insert(
            name.text.clone(),
            Entry { kind, value, span: name.span, used: false, is_ambiguous: false },
        );
    }

    /// Sets the value of a previously declared name after its statement. Nothing has used it so
    /// far.
    pub(super) fn define(&mut self, name: &str, value: Option<Operand>) {
        if let Some(entry) = self.entries.get_mut(&name.to_owned()) {
            (entry.value, entry.used) = (value, false);
        }
    }

    /// Replaces the value of a name temporarily, and returns the previous value.
    pub(super) fn replace(&mut self, name: &str, value: Option<Operand>) -> Option<Operand> {
        let entry = self.entries.get_mut(&name.to_owned())?;
        std::mem::replace(&mut entry.value, value)
    }

    /// Couples names: none is reported as unused if one of them is used.
    pub(super) fn couple(&mut self, names: &[Name]) {
        self.coupled.push(names.iter().map(|name| name.text.clone()).collect());
    }

    /// Returns the entry of a name, without counting as a use.
    pub(super) fn find(&self, name: &str) -> Option<&Entry> {
        self.entries.get(&name.to_owned())
    }

    /// True for the name of a velocity.
    pub(super) fn is_velocity(&self, name: &str) -> bool {
        self.find(name).is_some_and(|entry| entry.kind == NameKind::Velocity)
    }

    /// Returns the entry of a name used in an expression.
    pub(super) fn resolve(&mut self, name: &str) -> Option<&Entry> {
        let entry = self.entries.get_mut(&name.to_owned())?;
        entry.used = true;
        Some(entry)
    }

    /// Returns the most similar known name among those that pass the filter.
    pub(super) fn nearest(&self, name: &str, accept: impl Fn(NameKind) -> bool) -> Option<&str> {
        let known = self.entries.iter().filter(|(_, entry)| accept(entry.kind));
        nearest(name, known.map(|(name, _)| name.as_str()))
    }

    /// Warns of unused names.
    pub(super) fn report_unused(&self, report: &mut Report) {
        let is_used = |name: &String| self.entries.get(name).is_some_and(|entry| entry.used);
        let serves = |name| self.coupled.iter().any(|all| all.contains(name) && all.iter().any(is_used));
        for (name, entry) in self.entries.iter() {
            if !entry.used && entry.kind.should_be_used() && !name.starts_with('_') && !serves(name) {
                report
                    .unused(name, entry.span, messages::names::unused(entry.kind.describe(), name))
                    .help(messages::names::unused_help(name));
            }
        }
    }
}
