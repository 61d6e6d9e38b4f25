//! State and common operations of the pass that copies expressions with expanded arrays.

use super::complaints::Complaints;
use super::counting::Counting;
use super::elements::ElementNames;
use super::indices::{PlacedIndex, counted_indices, indices_of};
use super::messages;
use super::paths::Segment;
use super::scopes::{BUILT_IN, PlacedId, ScopeId, Scopes};
use crate::syntax::ast::{AstId, Expression, Expressions, ExternalFunction, Fold, Name};
use lagrange_expr::collections::{HashMap, HashSet};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_WRITTEN_OUT;
use lagrange_expr::number::Number;

/// State for copying expressions with expanded arrays, loops and parts.
pub(super) struct Copier<'a> {
    pub(super) expressions: &'a mut Expressions,
    pub(super) scopes: Scopes,
    pub(super) elements: &'a ElementNames,
    pub(super) complaints: Complaints<'a>,
    pub(super) constants: &'a HashMap<String, Number>,
    /// For each expression in the text, the places where it may have to be copied.
    pub(super) changes: HashMap<AstId, Change>,
    /// Functions of the user's crate that parts declare.
    external: HashSet<String>,
    /// Terms so far.
    pub(super) terms: u64,
    is_too_long: bool,
}

/// The places where a copy of an expression can differ from the original.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Change {
    Nowhere,
    /// In parts, where its names have other meanings.
    InParts,
    Anywhere,
}

/// A pending step of the copy.
pub(super) enum Task {
    /// Copy an expression.
    Copy(AstId, ScopeId),
    /// Make an expression like this one from the copies of its operands.
    Make(AstId),
    /// Make a call like this one, but of the function with this name.
    Call(AstId, String),
    /// Apply a function to this number of copies.
    Fold(Fold, usize, Origin),
    /// Take the entry of a copy at these indices.
    Entry(Vec<PlacedIndex>, Origin),
}

impl<'a> Copier<'a> {
    pub(super) fn new(
        expressions: &'a mut Expressions,
        scopes: Scopes,
        constants: &'a HashMap<String, Number>,
        elements: &'a ElementNames,
        complaints: Complaints<'a>,
    ) -> Copier<'a> {
        let changes = changes(expressions, &scopes, elements, &complaints);
        let external = HashSet::default();
        Copier {
            expressions,
            scopes,
            elements,
            complaints,
            constants,
            changes,
            external,
            terms: 0,
            is_too_long: false,
        }
    }

    pub(super) fn counting(&self) -> Counting<'_> {
        Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants }
    }

    /// True for a function of the user's crate that no part has declared before.
    pub(super) fn is_first_of(&mut self, function: &ExternalFunction) -> bool {
        let key = format!("{} {}", function.name.text, function.parameters.len());
        self.external.insert(key) || function.derivatives.is_some()
    }

    /// Reports an expression and replaces it by an invalid one.
    pub(super) fn invalid(&mut self, id: AstId, message: String, help: &str) -> AstId {
        let origin = self.expressions.origin(id);
        if let Some(error) = self.complaints.once(id, origin, message) {
            error.help(help);
        }
        self.expressions.add(Expression::Invalid, origin)
    }

    /// Returns the message for a part where a value is needed, and the help.
    pub(super) fn part_as_value(&self, part: PlacedId) -> (String, String) {
        let part = self.scopes.placed(part);
        let name = part.written.trim_end_matches('.');
        let members = messages::members_are(&part.interior.name.text, part.interior.names());
        (messages::part_as_value(name), members)
    }

    /// Returns the name of an element. An element that does not exist is reported.
    pub(super) fn element(&mut self, array: &Segment, scope: ScopeId) -> Option<String> {
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        let ((first, _), (last, _)) = (array.indices.first()?, array.indices.last()?);
        let origin = self.expressions.origin(*first).to(self.expressions.origin(*last));
        if !self.elements.is_indexed(&array.text) {
            if !self.elements.is_declared(&array.text, self.complaints.names) {
                self.complaints.unknown_array(
                    &array.text,
                    (*first, array.span.into()),
                    (&self.scopes, scope),
                );
            } else if let Some(error) = self.complaints.once(*first, origin, messages::no_array(&array.text))
            {
                error.help(messages::no_array_help(&array.text));
            }
            return None;
        }
        let indices = counted_indices(&array.indices, counting, &mut self.complaints)?;
        if let Some(text) = self.elements.text(&array.text, &indices) {
            return Some(text.to_owned());
        }
        let (message, help) = self.elements.objection(&array.text, &indices)?;
        let message = format!("{message}{}", self.scopes.place_of(scope));
        if let Some(error) = self.complaints.once(*first, origin, message) {
            error.help(help);
        }
        None
    }

    /// Evaluates the sizes after the name of an array that is declared as a whole.
    pub(super) fn sizes(&mut self, name: &Name, scope: ScopeId) -> Option<Vec<i64>> {
        if !self.elements.is_indexed(&self.scopes.prefixed(scope, &name.text)) {
            return None;
        }
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        indices_of(name, scope, counting, &mut self.complaints)
    }

    /// Explains why a name without an index is unknown, with the help. Names of the expanded
    /// declaration do not exist in the text.
    pub(super) fn objection(&self, name: &str, is_as_written: bool) -> Option<(String, String)> {
        if self.elements.is_array(name) {
            return Some((messages::no_index(name), messages::written_help(self.elements.example(name))));
        }
        if self.complaints.names.contains(name) {
            return None;
        }
        if self.scopes.is_local(ScopeId::default(), name) {
            return Some((messages::unknown_name(name), messages::known_in_loop(name)));
        }
        let local = self.elements.local(name).filter(|_| is_as_written);
        let written = local.or_else(|| self.elements.as_written(name))?;
        Some((messages::unknown_name(name), messages::write(written)))
    }

    /// Reports that the expansion is too long, once.
    pub(super) fn too_long(&mut self, origin: Origin) -> AstId {
        if !std::mem::replace(&mut self.is_too_long, true) {
            let error = self.complaints.report.error(origin, messages::too_many_terms(MAX_WRITTEN_OUT));
            error.help(messages::TOO_LONG_HELP);
        }
        self.expressions.add(Expression::Invalid, origin)
    }
}

/// Determines for each expression in the text where it may have to be copied.
fn changes(
    expressions: &Expressions,
    scopes: &Scopes,
    elements: &ElementNames,
    complaints: &Complaints<'_>,
) -> HashMap<AstId, Change> {
    let mut changes = HashMap::default();
    for (id, expression) in expressions.iter() {
        let of_operands = || expression.operands().iter().filter_map(|id| changes.get(id)).max().copied();
        let change = match expression {
            Expression::Name(name) => {
                // A variable, a parameter of a function, an array or something in a part.
                let is_known = complaints.names.contains(name) && !elements.is_array(name);
                match (is_known && !scopes.is_scoped(name), BUILT_IN.contains(&name.as_str())) {
                    (true, true) => Change::Nowhere,
                    (true, false) => Change::InParts,
                    (false, _) => Change::Anywhere,
                }
            }
            Expression::Array(_) | Expression::Entry { .. } => Change::Anywhere,
            Expression::Component(_, name) | Expression::Call(name, _) if !name.indices.is_empty() => {
                Change::Anywhere
            }
            Expression::Call(function, _)
                if scopes.is_scoped(&function.text) || elements.is_array(&function.text) =>
            {
                Change::Anywhere
            }
            Expression::Call(..) => of_operands().max(Some(Change::InParts)).unwrap_or(Change::InParts),
            _ => of_operands().unwrap_or(Change::Nowhere),
        };
        changes.insert(id, change);
    }
    changes
}
