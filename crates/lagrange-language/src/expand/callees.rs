//! Resolution of called functions: those of an iteration, elements of arrays, and arguments of
//! parts.

use super::copier::Copier;
use super::messages;
use super::paths::Segment;
use super::scopes::{Meaning, ScopeId};
use crate::syntax::ast::{ArrayExpression, AstId, Expression, Name};
use crate::syntax::is_function;

impl Copier<'_> {
    /// Returns the name of the function called in a scope. An unknown one is reported.
    pub(super) fn function(&mut self, call: AstId, function: &Name, scope: ScopeId) -> String {
        let mut place = scope;
        let mut named = Segment::of(function, scope);
        loop {
            if let Some(local) = self.scopes.local(place, &named.text) {
                return local.text.clone();
            }
            match self.scopes.member(self.scopes.part_of(place), &named.text) {
                Meaning::Declared(text) => {
                    let name = named.text.clone();
                    if self.scopes.is_local(place, &name) && !is_function(&name) {
                        self.complaints.unknown(&name, (call, function.span.into()), (&self.scopes, place));
                    }
                    return self.element_called(call, Segment { text, ..named }, scope);
                }
                Meaning::Argument(value, outer) => match self.expressions.get(value) {
                    Expression::Name(other) => (named.text, place) = (other.clone(), outer),
                    Expression::Array(ArrayExpression::Element(other)) => {
                        let further = std::mem::take(&mut named.indices);
                        (named, place) = (Segment::of(other, outer), outer);
                        named.indices.extend(further);
                    }
                    _ => return named.text,
                },
                Meaning::Outside => {
                    let name = named.text;
                    let is_external =
                        self.scopes.around(place).is_some_and(|part| part.interior.external.contains(&name));
                    if is_external || is_function(&name) || !self.complaints.names.contains(&name) {
                        return name;
                    }
                    self.complaints.unknown(&name, (call, function.span.into()), (&self.scopes, place));
                    return name;
                }
                Meaning::Placed | Meaning::Value(_) | Meaning::Hidden => return named.text,
            }
        }
    }

    /// Returns the function at indices. Calls of a whole array of functions, and of values, are
    /// reported. A name without an index may be a method, as in `box.corner(0)`.
    fn element_called(&mut self, call: AstId, callee: Segment, scope: ScopeId) -> String {
        let has_values = self.elements.rank_of_values(&callee.text).is_some();
        let (message, help) = match callee.indices.is_empty() {
            true if !self.elements.is_callable(&callee.text) => return callee.text,
            true => (
                messages::no_index(&callee.text),
                messages::written_help(self.elements.example(&callee.text)),
            ),
            false if has_values => {
                (messages::values_called(&callee.text), messages::VALUES_CALLED_HELP.to_owned())
            }
            false => return self.element(&callee, scope).unwrap_or(callee.text),
        };
        if let Some(error) = self.complaints.once(call, callee.span.into(), message) {
            error.help(help);
        }
        callee.text
    }
}
