//! Loops and choices between statements: which statements they stand for.

use super::complaints::Complaints;
use super::counting::Counting;
use super::defaults::{element_of, positions};
use super::messages;
use super::scopes::{ScopeId, Scopes};
use crate::syntax::ast::{
    Block, Definition, Expressions, Name, Range, Repetition, Selection, Statement, StatementKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_WRITTEN_OUT;
use lagrange_expr::number::Number;

/// A statement as it is meant once.
#[derive(Clone, Copy)]
pub(super) struct Instance<'d> {
    pub(super) statement: &'d Statement,
    pub(super) scope: ScopeId,
}

/// All that loops stand for.
pub(super) struct Unrolled<'d> {
    pub(super) instances: Vec<Instance<'d>>,
    /// Values of constants and of elements of arrays of them.
    pub(super) constants: HashMap<String, Number>,
}

/// Writes loops out.
pub(super) fn unroll<'d>(
    statements: &'d [Statement],
    expressions: &Expressions,
    scopes: &mut Scopes,
    complaints: &mut Complaints<'_>,
) -> Unrolled<'d> {
    let unrolled = Unrolled { instances: Vec::new(), constants: HashMap::default() };
    let mut unroller = Unroller { unrolled, expressions, scopes, complaints, turns: 0, is_too_long: false };
    unroller.statements(statements, ScopeId::default());
    unroller.unrolled
}

struct Unroller<'a, 'c, 'd> {
    unrolled: Unrolled<'d>,
    expressions: &'a Expressions,
    scopes: &'a mut Scopes,
    complaints: &'a mut Complaints<'c>,
    /// Turns of loops so far.
    turns: u64,
    is_too_long: bool,
}

impl<'d> Unroller<'_, '_, 'd> {
    fn statements(&mut self, statements: &'d [Statement], scope: ScopeId) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Block(Block::Repeat(repetition)) => self.repetition(repetition, scope),
                StatementKind::Block(Block::Select(selection)) => self.selection(selection, scope),
                kind => {
                    if let (StatementKind::Constants(list), true) = (kind, scope.is_outermost()) {
                        list.iter().for_each(|definition| self.constant(definition));
                    }
                    self.unrolled.instances.push(Instance { statement, scope });
                }
            }
        }
    }

    fn repetition(&mut self, repetition: &'d Repetition, scope: ScopeId) {
        let Repetition { variable, range, body } = repetition;
        let Unrolled { constants, .. } = &self.unrolled;
        let counting = Counting { expressions: self.expressions, scopes: self.scopes, constants };
        let values = values(variable, range, (counting, scope), self.complaints);
        let Some(values) = values else { return };
        for value in values {
            // Loops may stand in loops.
            self.turns += 1 + body.len() as u64;
            if self.turns > MAX_WRITTEN_OUT {
                return self.report_too_long(range);
            }
            let scope = self.scopes.within(scope, &variable.text, value);
            self.statements(body, scope);
        }
    }

    fn selection(&mut self, selection: &'d Selection, scope: ScopeId) {
        for (condition, body) in &selection.branches {
            match self.counting().holds(condition, scope) {
                Ok(true) => return self.statements(body, scope),
                Ok(false) => {}
                Err(fault) => {
                    return self.complaints.undecided(self.expressions, &fault, (self.scopes, scope));
                }
            }
        }
        self.statements(&selection.otherwise, scope);
    }

    /// Remembers a constant, if it is a number that indices can be made of.
    fn constant(&mut self, definition: &Definition) {
        let (name, outermost) = (&definition.name, ScopeId::default());
        // A length is no number that indices can be made of.
        let is_plain = name.unit.as_ref().is_none_or(|unit| unit.is_coherent() && unit.dimension.is_none());
        let Some(value) = definition.value.filter(|_| is_plain) else { return };
        let sizes = name.indices.iter().map(|size| self.counting().integer(*size, outermost));
        let Ok(sizes) = sizes.collect::<Result<Vec<_>, _>>() else { return };
        let positions = positions(&sizes);
        self.turns += positions.len() as u64;
        if self.turns > MAX_WRITTEN_OUT {
            // That there are too many elements is reported where they are collected.
            return;
        }
        for position in positions {
            let Some(value) = element_of(self.expressions, value, &position) else { continue };
            if let Ok(number) = self.counting().number(value, outermost) {
                self.unrolled.constants.insert(messages::element(&name.text, &position), number);
            }
        }
    }

    fn counting(&self) -> Counting<'_> {
        Counting { expressions: self.expressions, scopes: self.scopes, constants: &self.unrolled.constants }
    }

    /// Once is enough.
    fn report_too_long(&mut self, range: &Range) {
        if !std::mem::replace(&mut self.is_too_long, true) {
            let origin = origin_of(self.expressions, range);
            self.complaints
                .report
                .error(origin, messages::too_many_statements(MAX_WRITTEN_OUT))
                .help(messages::TOO_LONG_HELP);
        }
    }
}

/// The values of a variable; what is wrong about them, or about its name, is reported.
pub(super) fn values(
    variable: &Name,
    range: &Range,
    (counting, scope): (Counting<'_>, ScopeId),
    complaints: &mut Complaints<'_>,
) -> Option<std::ops::Range<i64>> {
    let message = match counting.scopes.find(scope, &variable.text) {
        Some(Some(_)) => Some(messages::shadowed_variable(&variable.text)),
        Some(None) => Some(messages::variable_is_parameter(&variable.text)),
        None if complaints.names.contains(&variable.text) => {
            Some(messages::variable_is_declared(&variable.text))
        }
        None => None,
    };
    if let Some(message) = message {
        let error = complaints.once(range.from, variable.span.into(), message)?;
        error.help(messages::OTHER_VARIABLE_HELP);
        return None;
    }
    let ends =
        counting.integer(range.from, scope).and_then(|from| Ok((from, counting.integer(range.to, scope)?)));
    match ends {
        Ok((from, to)) => Some(from..to.saturating_add(i64::from(range.is_inclusive))),
        Err(fault) => {
            complaints.fault(counting.expressions, &fault, (counting.scopes, scope));
            None
        }
    }
}

/// Place of a range.
pub(super) fn origin_of(expressions: &Expressions, range: &Range) -> Origin {
    expressions.origin(range.from).to(expressions.origin(range.to))
}
