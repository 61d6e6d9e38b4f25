//! Mistakes in expanded text, each reported once however often it is expanded.

use std::collections::BTreeSet;

use super::counting::{IndexFault, Reason};
use super::messages;
use super::scopes::{ScopeId, Scopes};
use crate::syntax::ast::{AstId, Declaration, Expressions};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::{Diagnostic, Origin, Report, nearest};

/// The reports, and the names known for them.
pub(super) struct Complaints<'a> {
    pub(super) report: &'a mut Report,
    declaration: &'a Declaration,
    /// The names that are declared anywhere, with those of variables.
    pub(super) names: &'a BTreeSet<String>,
    /// Expressions of which something was said.
    said: HashSet<AstId>,
    /// Names of which was said that they are no constants.
    no_constants: HashSet<String>,
    /// True if what could not be read may be where a name is declared.
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
        Complaints { report, declaration, names, said, no_constants, is_partial }
    }

    /// True if what could not be read is not known of names.
    pub(super) fn is_partial(&self) -> bool {
        self.is_partial
    }

    /// Reports something of an expression; nothing the second time.
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
        let place = scopes.place(scope);
        let (message, help) = match &fault.reason {
            Reason::Unreadable => return,
            Reason::Name(name) if self.is_partial && !self.names.contains(name) => return,
            Reason::Name(name) if self.names.contains(name) => {
                if !self.no_constants.insert(name.clone()) {
                    return;
                }
                (messages::no_constant(name), messages::constant_help(name))
            }
            Reason::Name(name) if scopes.is_variable(name) => {
                (messages::unknown_name(name), messages::in_its_loop(name))
            }
            Reason::Name(name) => return self.unknown(name, fault.place, origin),
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

    /// Reports a condition on indices in an expression that holds something else.
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
            Reason::Name(name) if self.names.contains(name) => {
                let origin = expressions.origin(fault.place);
                if let Some(error) = self.once(fault.place, origin, message(name)) {
                    error.help(help);
                }
            }
            _ => self.fault(expressions, fault, scope),
        }
    }

    /// Reports a name that means nothing, unless it may be declared where the text could not be
    /// read.
    pub(super) fn unknown(&mut self, name: &str, of: AstId, origin: Origin) {
        self.unknown_as(name, messages::DECLARE_HELP.to_owned(), (of, origin));
    }

    /// Reports an unknown name with an index.
    pub(super) fn unknown_array(&mut self, name: &str, of: AstId, origin: Origin) {
        self.unknown_as(name, messages::declare_array(name), (of, origin));
    }

    fn unknown_as(&mut self, name: &str, declare: String, (of, origin): (AstId, Origin)) {
        if self.declaration.lacks_names || self.declaration.unreadable_words.contains(&name.to_owned()) {
            return;
        }
        let help = match nearest(name, self.names.iter().map(String::as_str)) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => declare,
        };
        if let Some(error) = self.once(of, origin, messages::unknown_name(name)) {
            error.help(help);
        }
    }
}
