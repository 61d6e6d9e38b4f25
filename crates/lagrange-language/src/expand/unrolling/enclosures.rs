//! Loops, conditions and local names around lines of events, clocks and reductions.

use super::{Instance, Unroller, origin_of, values};
use crate::expand::complaints::Complaints;
use crate::expand::counting::Counting;
use crate::expand::messages;
use crate::expand::scopes::ScopeId;
use crate::syntax::ast::{AstId, Enclosure, Name, Range, Statement, StatementKind};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;

/// Scopes of loops and local names, by the surrounding scope and one of their expressions. Lines in
/// the same enclosure share them.
type SharedScopes = HashMap<(ScopeId, AstId), Vec<ScopeId>>;

impl<'d> Unroller<'_, '_, 'd> {
    /// Returns the scopes of each line between the braces of a statement. There is one for each
    /// iteration in which the conditions around the line hold. Errors in loops and conditions are
    /// reported.
    pub(in crate::expand) fn lines(&mut self, kind: &'d StatementKind, scope: ScopeId) -> Vec<Vec<ScopeId>> {
        let mut shared = SharedScopes::default();
        kind.enclosures().into_iter().map(|around| self.iterations(around, scope, &mut shared)).collect()
    }

    fn iterations(
        &mut self,
        around: &'d [Enclosure],
        scope: ScopeId,
        shared: &mut SharedScopes,
    ) -> Vec<ScopeId> {
        around.iter().fold(vec![scope], |scopes, enclosure| {
            let within = scopes.into_iter().flat_map(|scope| self.within(enclosure, scope, shared));
            within.collect()
        })
    }

    /// Returns the scopes within an enclosure.
    fn within(
        &mut self,
        enclosure: &'d Enclosure,
        scope: ScopeId,
        shared: &mut SharedScopes,
    ) -> Vec<ScopeId> {
        let key = match enclosure {
            Enclosure::Condition(condition) => {
                return match self.counting().holds(condition, scope) {
                    Ok(holds) => Vec::from_iter(holds.then_some(scope)),
                    Err(fault) => {
                        self.complaints.undecided(self.expressions, &fault, (self.scopes, scope));
                        Vec::new()
                    }
                };
            }
            Enclosure::Loop(_, range) => (scope, range.from),
            Enclosure::Local(_, value) => (scope, *value),
        };
        if let Some(known) = shared.get(&key) {
            return known.clone();
        }
        let scopes = match enclosure {
            Enclosure::Loop(variable, range) => self.each_of(variable, range, scope),
            Enclosure::Local(statement, _) => Vec::from_iter(self.behind(statement, scope)),
            Enclosure::Condition(_) => Vec::new(),
        };
        shared.insert(key, scopes.clone());
        scopes
    }

    fn each_of(&mut self, variable: &Name, range: &Range, scope: ScopeId) -> Vec<ScopeId> {
        let counting = Counting {
            expressions: self.expressions,
            scopes: self.scopes,
            constants: &self.unrolled.constants,
        };
        let Some(values) = values(variable, range, (counting, scope), self.complaints) else {
            return Vec::new();
        };
        let count = values.end.saturating_sub(values.start).max(0);
        if !self.has_room(usize::try_from(count).unwrap_or(usize::MAX)) {
            self.report_too_long(origin_of(self.expressions, range));
            return Vec::new();
        }
        values.map(|value| self.scopes.within(scope, &variable.text, value)).collect()
    }

    /// Returns the scope of the lines after a `let`, which is expanded before the statement.
    fn behind(&mut self, statement: &'d Statement, scope: ScopeId) -> Option<ScopeId> {
        let inside = self.scopes.inside(scope);
        self.localise(&statement.kind, inside).then(|| {
            self.unrolled.instances.push(Instance { statement, scope: inside, lines: Vec::new() });
            inside
        })
    }
}

/// Reports lines between braces that loops and conditions eliminate entirely.
pub(in crate::expand) fn report_nothing_left(complaints: &mut Complaints<'_>, origin: Origin) {
    if !complaints.report.has_errors() {
        complaints.report.error(origin, messages::NOTHING_LEFT).help(messages::NOTHING_LEFT_HELP);
    }
}
