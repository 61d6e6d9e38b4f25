//! Errors in expanded text, each reported once, however often it is expanded.

use std::collections::BTreeSet;

use super::counting::{IndexFault, Reason};
use super::messages;
use super::paths::PathFault;
use super::scopes::{Interior, PlacedPart, ScopeId, Scopes};
use crate::syntax::ast::{AstId, Declaration, Expressions};
use crate::syntax::foreign::{self, Rate};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::{Diagnostic, Origin, Report, nearest};
use lagrange_expr::units::meaning;

/// The reports, and the names known for them.
pub(super) struct Complaints<'a> {
    pub(super) report: &'a mut Report,
    declaration: &'a Declaration,
    /// All declared names, including those of variables.
    pub(super) names: &'a BTreeSet<String>,
    /// Expressions with a report.
    said: HashSet<AstId>,
    /// Placements with a report.
    placements: HashSet<usize>,
    /// Names that have been reported as not constant.
    no_constants: HashSet<String>,
    /// True if a name may be declared in an unreadable part.
    is_partial: bool,
}

impl<'a> Complaints<'a> {
    pub(super) fn new(
        report: &'a mut Report,
        declaration: &'a Declaration,
        names: &'a BTreeSet<String>,
    ) -> Complaints<'a> {
        let is_partial = report.has_errors();
        let (said, no_constants) = (HashSet::default(), HashSet::default());
        let placements = HashSet::default();
        Complaints { report, declaration, names, said, placements, no_constants, is_partial }
    }

    /// True if unreadable parts may declare names.
    pub(super) fn is_partial(&self) -> bool {
        self.is_partial
    }

    /// True for the first report on a placement, identified by its address.
    pub(super) fn once_of(&mut self, placement: usize) -> bool {
        self.placements.insert(placement)
    }

    /// Reports an error in an expression, at most once.
    pub(super) fn once(&mut self, of: AstId, origin: Origin, message: String) -> Option<&mut Diagnostic> {
        self.said.insert(of).then(|| self.report.error(origin, message))
    }

    /// Reports an index that cannot be counted.
    pub(super) fn fault(
        &mut self,
        expressions: &Expressions,
        fault: &IndexFault,
        (scopes, scope): (&Scopes, ScopeId),
    ) {
        let origin = expressions.origin(fault.place);
        let place = scopes.place_of(scope);
        let (message, help) = match &fault.reason {
            Reason::Unreadable => return,
            Reason::Name(name) if self.is_partial && !self.knows(name, (scopes, scope)) => return,
            Reason::Name(name) if self.knows(name, (scopes, scope)) => {
                if !self.no_constants.insert(name.clone()) {
                    return;
                }
                let help = match meaning(name) {
                    Some(_) => messages::index_or_unit(name),
                    None => messages::constant_help(name),
                };
                (messages::no_constant(name), help)
            }
            Reason::Name(name) if scopes.is_variable(name) => {
                (messages::unknown_name(name), messages::in_its_loop(name))
            }
            Reason::Name(name) => return self.unknown(name, (fault.place, origin), (scopes, scope)),
            Reason::Form => (messages::NO_INDEX.to_owned(), messages::INDEX_HELP.to_owned()),
            Reason::NoInteger(number) => {
                (messages::no_integer(number, &place), messages::INDEX_HELP.to_owned())
            }
            Reason::DivisionByZero => (messages::division_by_zero(&place), messages::INDEX_HELP.to_owned()),
            Reason::TooLarge => (messages::TOO_LARGE.to_owned(), messages::INDEX_HELP.to_owned()),
        };
        if let Some(error) = self.once(fault.place, origin, message) {
            error.help(help);
        }
    }

    /// Reports a condition between statements that cannot be decided.
    pub(super) fn undecided(
        &mut self,
        expressions: &Expressions,
        fault: &IndexFault,
        scope: (&Scopes, ScopeId),
    ) {
        self.open(expressions, fault, scope, (|name| messages::condition(name), messages::CONDITION_HELP));
    }

    /// Reports a condition on indices in an expression that contains something else.
    pub(super) fn unequal(
        &mut self,
        expressions: &Expressions,
        fault: &IndexFault,
        scope: (&Scopes, ScopeId),
    ) {
        self.open(
            expressions,
            fault,
            scope,
            (|name| messages::condition_in_value(name), messages::CONDITION_IN_VALUE_HELP),
        );
    }

    fn open(
        &mut self,
        expressions: &Expressions,
        fault: &IndexFault,
        scope: (&Scopes, ScopeId),
        (message, help): (fn(&str) -> String, &str),
    ) {
        match &fault.reason {
            Reason::Name(name) if self.knows(name, scope) => {
                let origin = expressions.origin(fault.place);
                if let Some(error) = self.once(fault.place, origin, message(name)) {
                    error.help(help);
                }
            }
            _ => self.fault(expressions, fault, scope),
        }
    }

    /// True if a name is declared in the part around a scope, or outside of parts if there is no
    /// such part.
    pub(super) fn knows(&self, name: &str, (scopes, scope): (&Scopes, ScopeId)) -> bool {
        match scopes.around(scope) {
            Some(part) => part.interior.knows(name),
            None => self.names.contains(name),
        }
    }

    /// Reports an undefined name, unless it may be declared in an unreadable part of the text.
    pub(super) fn unknown(&mut self, name: &str, place: (AstId, Origin), scope: (&Scopes, ScopeId)) {
        self.unknown_as(name, messages::DECLARE_HELP.to_owned(), place, scope);
    }

    /// Reports an unknown name with an index.
    pub(super) fn unknown_array(&mut self, name: &str, place: (AstId, Origin), scope: (&Scopes, ScopeId)) {
        self.unknown_as(name, messages::declare_array(name), place, scope);
    }

    fn unknown_as(
        &mut self,
        name: &str,
        declare: String,
        (of, origin): (AstId, Origin),
        (scopes, scope): (&Scopes, ScopeId),
    ) {
        if self.may_be_unread(name) {
            return;
        }
        let (message, help) = match scopes.around(scope) {
            _ if scopes.is_local(scope, name) => {
                (messages::unknown_name(name), messages::known_in_loop(name))
            }
            Some(part) => self.unknown_in(&part.interior, name),
            None => {
                let nearest = nearest(name, self.names.iter().map(String::as_str));
                let help = nearest.map_or(declare, messages::did_you_mean);
                (messages::unknown_name(name), help)
            }
        };
        if let Some(error) = self.once(of, origin, message) {
            error.help(help);
        }
    }

    /// True if a name may be declared in an unreadable part of the text.
    pub(super) fn may_be_unread(&self, name: &str) -> bool {
        self.declaration.lacks_names || self.declaration.unreadable_words.contains(name)
    }

    /// Returns the message for a name that is unknown in a part, and the help.
    fn unknown_in(&self, part: &Interior, name: &str) -> (String, String) {
        if self.names.contains(name) {
            let help = messages::outside_help(name, &part.name.text);
            return (messages::outside(name, &part.name.text), help);
        }
        let help = match nearest(name, part.names()) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => messages::declare_in_part(name, &part.name.text),
        };
        (messages::unknown_in_part(name, &part.name.text), help)
    }

    /// Reports an undefined path. `of` is the expression, if it is one.
    pub(super) fn path(
        &mut self,
        fault: &PathFault,
        expressions: &Expressions,
        of: Option<AstId>,
        (scopes, scope): (&Scopes, ScopeId),
    ) {
        let (segment, message, help) = match fault {
            PathFault::Index(fault, scope) => return self.fault(expressions, fault, (scopes, *scope)),
            PathFault::Outside(segment) => match scopes.around(scope) {
                _ if scopes.is_local(scope, &segment.text) => {
                    let (name, help) = (&segment.text, messages::known_in_loop(&segment.text));
                    (segment, messages::unknown_name(name), help)
                }
                Some(part) => {
                    let (message, help) = self.unknown_in(&part.interior, &segment.text);
                    (segment, message, help)
                }
                None => (segment, messages::unknown_name(&segment.text), messages::DECLARE_PART.to_owned()),
            },
            PathFault::NoMember(part, segment) => {
                let part = scopes.placed(*part);
                let (message, help) = no_member(part, &segment.text);
                (segment, message, help)
            }
            PathFault::Unplaced(segment) => {
                (segment, messages::unplaced(&segment.text), messages::UNPLACED_HELP.to_owned())
            }
            PathFault::NoElement(outer, segment, indices) => {
                let elements = scopes.elements(*outer, &segment.text).into_iter().flat_map(|all| all.keys());
                let known = elements.map(|known| messages::written(&segment.text, known)).collect::<Vec<_>>();
                let message = messages::no_element(messages::written(&segment.text, indices));
                (segment, message + &scopes.place_of(scope), messages::placed_are(&known))
            }
        };
        if self.may_be_unread(&segment.text) {
            return;
        }
        let error = match of {
            Some(of) => self.once(of, segment.span.into(), message),
            None => Some(self.report.error(segment.span, message)),
        };
        if let Some(error) = error {
            error.help(help);
        }
    }
}

/// Returns the message for a member that a placed part does not have, and the help.
fn no_member(part: &PlacedPart, member: &str) -> (String, String) {
    let written = |name: &str| format!("{}{name}", part.written);
    let rate = foreign::rate(member, |of| part.interior.names().any(|known| known == of));
    let help = match (rate, nearest(member, part.interior.names())) {
        (Some(rate), _) => Rate { of: &written(rate.of), ..rate }.written(),
        (None, Some(nearest)) => written(nearest),
        (None, None) => {
            let members = messages::members_are(&part.interior.name.text, part.interior.names());
            return (messages::no_member(written(member), &part.interior.name.text), members);
        }
    };
    let help = messages::did_you_mean(help);
    (messages::no_member(written(member), &part.interior.name.text), help)
}
