//! Loops and conditions around lines of events, clocks and reductions.

use super::copier::Copier;
use super::counting::Counting;
use super::messages;
use super::scopes::ScopeId;
use super::unrolling::{origin_of, values};
use crate::syntax::ast::{Enclosure, Name, Range};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_WRITTEN_OUT;

impl Copier<'_> {
    /// Returns the scopes in which a line is meant: one for each iteration in which the conditions
    /// around it hold. What is wrong with loops and conditions is reported.
    pub(super) fn iterations(&mut self, around: &[Enclosure], scope: ScopeId) -> Vec<ScopeId> {
        around.iter().fold(vec![scope], |scopes, enclosure| match enclosure {
            Enclosure::Loop(variable, range) => {
                scopes.into_iter().flat_map(|scope| self.each_of(variable, range, scope)).collect()
            }
            Enclosure::Condition(condition) => {
                let holds = |scope: &ScopeId| match self.counting().holds(condition, *scope) {
                    Ok(holds) => holds,
                    Err(fault) => {
                        self.complaints.undecided(self.expressions, &fault, (&self.scopes, *scope));
                        false
                    }
                };
                scopes.into_iter().filter(holds).collect()
            }
        })
    }

    /// Reports lines between braces of which loops and conditions leave none.
    pub(super) fn nothing_left(&mut self, origin: Origin) {
        if !self.complaints.report.has_errors() {
            let error = self.complaints.report.error(origin, messages::NOTHING_LEFT);
            error.help(messages::NOTHING_LEFT_HELP);
        }
    }

    fn each_of(&mut self, variable: &Name, range: &Range, scope: ScopeId) -> Vec<ScopeId> {
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        let Some(values) = values(variable, range, (counting, scope), &mut self.complaints) else {
            return Vec::new();
        };
        let count = values.end.saturating_sub(values.start).max(0).unsigned_abs();
        self.terms = self.terms.saturating_add(count);
        if self.terms > MAX_WRITTEN_OUT {
            self.too_long(origin_of(self.expressions, range));
            return Vec::new();
        }
        values.map(|value| self.scopes.within(scope, &variable.text, value)).collect()
    }
}
