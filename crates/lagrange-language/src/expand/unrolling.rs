//! Expansion of loops and choices between statements.

mod enclosures;

pub(super) use enclosures::report_nothing_left;

use super::complaints::Complaints;
use super::counting::Counting;
use super::defaults::{element_of, positions};
use super::messages;
use super::parts::Parts;
use super::placements::{Placer, Site};
use super::scopes::{Meaning, ScopeId, Scopes};
use crate::syntax::ast::{
    Block, Definition, Expressions, Name, PlacedInstance, Placement, Range, Repetition, Selection, Statement,
    StatementKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::{MAX_EXPANDED_NESTING, MAX_WRITTEN_OUT};
use lagrange_expr::number::Number;

/// Number of values for which loops that are too long are expanded.
const FIRST_VALUES: i64 = 100;

/// One instance of a statement.
pub(super) struct Instance<'d> {
    pub(super) statement: &'d Statement,
    pub(super) scope: ScopeId,
    /// Scopes of each line between its braces, one for each iteration of the loops around the line.
    pub(super) lines: Vec<Vec<ScopeId>>,
}

/// The result of expanding loops.
pub(super) struct Unrolled<'d> {
    pub(super) instances: Vec<Instance<'d>>,
    /// Values of constants and of elements of constant arrays.
    pub(super) constants: HashMap<String, Number>,
    /// Placed parts.
    pub(super) placed: Vec<PlacedInstance>,
    /// Names of parts that should have been placed.
    pub(super) unplaced: Vec<Name>,
}

/// Expands loops.
pub(super) fn unroll<'d>(
    statements: &'d [Statement],
    expressions: &Expressions,
    scopes: &mut Scopes,
    complaints: &mut Complaints<'_>,
) -> Unrolled<'d> {
    let unrolled = Unrolled {
        instances: Vec::new(),
        constants: HashMap::default(),
        placed: Vec::new(),
        unplaced: Vec::new(),
    };
    let placer = Placer::new(Parts::of(statements, expressions, complaints));
    let mut unroller = Unroller {
        unrolled,
        placer,
        expressions,
        scopes,
        complaints,
        turns: 0,
        is_too_long: false,
        depth: 0,
    };
    unroller.statements(statements, ScopeId::default());
    let Unroller { unrolled, placer, complaints, .. } = unroller;
    placer.report_gaps(complaints);
    Unrolled { unplaced: placer.unplaced(), placed: placer.placed, ..unrolled }
}

/// State of the expansion of loops, choices and placements.
pub(super) struct Unroller<'a, 'c, 'd> {
    pub(super) unrolled: Unrolled<'d>,
    placer: Placer<'d>,
    pub(super) expressions: &'a Expressions,
    pub(super) scopes: &'a mut Scopes,
    pub(super) complaints: &'a mut Complaints<'c>,
    /// Number of iterations so far.
    turns: u64,
    is_too_long: bool,
    /// Nesting depth of loops, conditions and parts around the current statement.
    depth: usize,
}

impl<'d> Unroller<'_, '_, 'd> {
    fn statements(&mut self, statements: &'d [Statement], scope: ScopeId) {
        if self.depth == MAX_EXPANDED_NESTING {
            return self.report_too_deep(statements);
        }
        self.depth += 1;
        for statement in statements {
            match &statement.kind {
                StatementKind::Block(Block::Repeat(repetition)) => self.repetition(repetition, scope),
                StatementKind::Block(Block::Select(selection)) => self.selection(selection, scope),
                StatementKind::Block(Block::Place(placement)) => {
                    self.placement((statement, placement), scope);
                }
                StatementKind::Block(Block::Part(_) | Block::Include(_)) => {}
                kind => {
                    let is_local = self.scopes.is_in_loop(scope) && kind.is_local_in_loops();
                    if is_local && !self.localise(kind, scope) {
                        continue;
                    }
                    if let StatementKind::Constants(list) = kind {
                        list.iter().for_each(|definition| self.constant(definition, scope));
                    }
                    let lines = self.lines(kind, scope);
                    self.unrolled.instances.push(Instance { statement, scope, lines });
                }
            }
        }
        self.depth -= 1;
    }

    fn repetition(&mut self, repetition: &'d Repetition, scope: ScopeId) {
        let Repetition { variable, range, body } = repetition;
        let Unrolled { constants, .. } = &self.unrolled;
        let counting = Counting { expressions: self.expressions, scopes: self.scopes, constants };
        let values = values(variable, range, (counting, scope), self.complaints);
        let Some(values) = values else { return };
        let origin = origin_of(self.expressions, range);
        for value in self.admitted(values, body.len(), origin) {
            // Loops may be nested.
            if !self.has_room(body.len()) {
                return self.report_too_long(origin);
            }
            let scope = self.scopes.within(scope, &variable.text, value);
            self.statements(body, scope);
        }
    }

    /// Returns the values for which a body of this many statements is expanded. If that would be
    /// too many statements, it reports them and returns the first values, whose names other
    /// statements may use.
    fn admitted(
        &mut self,
        values: std::ops::Range<i64>,
        statements: usize,
        origin: Origin,
    ) -> std::ops::Range<i64> {
        let count = u64::try_from(values.end.saturating_sub(values.start)).unwrap_or(0);
        let all = (statements as u64).saturating_add(1).saturating_mul(count);
        if self.turns.saturating_add(all) <= MAX_WRITTEN_OUT {
            return values;
        }
        self.report_too_long(origin);
        first_of(values)
    }

    /// Counts statements before they are expanded; false if there are too many.
    pub(super) fn has_room(&mut self, statements: usize) -> bool {
        self.turns = self.turns.saturating_add(statements as u64).saturating_add(1);
        self.turns <= MAX_WRITTEN_OUT
    }

    fn placement(&mut self, (statement, placement): (&'d Statement, &'d Placement), scope: ScopeId) {
        let Some((variable, range)) = &placement.count else {
            return self.placed((statement, placement), None, scope);
        };
        let Unrolled { constants, .. } = &self.unrolled;
        let counting = Counting { expressions: self.expressions, scopes: self.scopes, constants };
        let Some(values) = values(variable, range, (counting, scope), self.complaints) else { return };
        let count = values.end.saturating_sub(values.start);
        if count <= 0 {
            let (name, origin) = (&placement.name.text, origin_of(self.expressions, range));
            if let Some(error) =
                self.complaints.once(range.from, origin, messages::no_parts(name, count.max(0)))
            {
                error.help(messages::ARRAY_OF_PARTS_HELP);
            }
        }
        let body = self.placer.parts.find(&placement.part.text).map(|part| part.definition.body.len());
        let values = match body {
            Some(body) if self.placer.has_room(count.max(0) as usize, statement, self.complaints) => {
                self.admitted(values, body, origin_of(self.expressions, range))
            }
            _ => first_of(values),
        };
        for (number, value) in (0..count).zip(values) {
            let scope = self.scopes.within(scope, &variable.text, value);
            self.placed((statement, placement), Some((value, [number, count])), scope);
        }
    }

    fn placed(
        &mut self,
        (statement, placement): (&'d Statement, &'d Placement),
        turn: Option<(i64, [i64; 2])>,
        scope: ScopeId,
    ) {
        let part = self.placer.parts.find(&placement.part.text);
        let body = part.map_or(0, |part| part.definition.body.len());
        if !self.has_room(body) {
            return self.report_too_long(statement.origin);
        }
        let Unroller { unrolled, placer, expressions, scopes, complaints, .. } = self;
        let mut site = Site { expressions, constants: &unrolled.constants, scopes, complaints };
        if let Some((part, inside)) = placer.place((statement, placement), turn, scope, &mut site) {
            self.statements(&part.body, inside);
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

    /// Makes names without indices local to this scope; false if one is already known, which is
    /// reported.
    pub(super) fn localise(&mut self, kind: &StatementKind, scope: ScopeId) -> bool {
        let names = kind.written_names().into_iter().map(|(name, _)| name);
        let mut names = names.filter(|name| name.indices.is_empty());
        names.all(|name| {
            let Some(message) = self.objection(name, scope) else {
                self.scopes.localise(scope, name);
                return true;
            };
            if self.complaints.once_of(std::ptr::from_ref(name).addr()) {
                let error = self.complaints.report.error(name.span, message);
                if let Some(local) = self.scopes.local(scope, &name.text) {
                    error.related(Origin::from(local.span), messages::FIRST_DECLARED);
                }
                error.help(messages::OTHER_NAME_HELP);
            }
            false
        })
    }

    /// Returns the objection to a local name, if there is one.
    fn objection(&self, name: &Name, scope: ScopeId) -> Option<String> {
        if self.scopes.find(scope, &name.text).is_some() {
            return Some(messages::shadowed_variable(&name.text));
        }
        let is_known = self.scopes.local(scope, &name.text).is_some()
            || self.complaints.knows(&name.text, (self.scopes, scope))
            || matches!(self.scopes.member(self.scopes.part_of(scope), &name.text), Meaning::Placed);
        is_known.then(|| messages::local_is_declared(&name.text))
    }

    /// Records a constant, if it is a number that can be used in indices.
    fn constant(&mut self, definition: &Definition, scope: ScopeId) {
        let name = &definition.name;
        // A length cannot be used in indices.
        let is_plain = name.unit.as_ref().is_none_or(|unit| unit.is_coherent() && unit.dimension.is_none());
        let Some(value) = definition.value.filter(|_| is_plain) else { return };
        let sizes = name.indices.iter().map(|size| self.counting().integer(*size, scope));
        let Ok(sizes) = sizes.collect::<Result<Vec<_>, _>>() else { return };
        let positions = positions(&sizes);
        self.turns += positions.len() as u64;
        if self.turns > MAX_WRITTEN_OUT {
            // An excessive number of elements is reported where they are collected.
            return;
        }
        for position in positions {
            let Some(value) = element_of(self.expressions, value, &position) else { continue };
            if let Ok(number) = self.counting().number(value, scope) {
                let name = messages::element(&self.scopes.prefixed(scope, &name.text), &position);
                self.unrolled.constants.insert(name, number);
            }
        }
    }

    pub(super) fn counting(&self) -> Counting<'_> {
        Counting { expressions: self.expressions, scopes: self.scopes, constants: &self.unrolled.constants }
    }

    /// Reports the first statement that is nested too deeply, only once.
    fn report_too_deep(&mut self, statements: &[Statement]) {
        if let Some(first) = statements.first()
            && !std::mem::replace(&mut self.is_too_long, true)
        {
            let message = messages::expanded_too_deep(MAX_EXPANDED_NESTING);
            self.complaints.report.error(first.origin, message).help(messages::RECURSION_HELP);
        }
    }

    /// Reports that the expansion is too long, only once.
    pub(super) fn report_too_long(&mut self, origin: Origin) {
        if !std::mem::replace(&mut self.is_too_long, true) {
            self.complaints
                .report
                .error(origin, messages::too_many_statements(MAX_WRITTEN_OUT))
                .help(messages::TOO_LONG_HELP);
        }
    }
}

/// Returns the values for which a loop that is too long is expanded.
fn first_of(values: std::ops::Range<i64>) -> std::ops::Range<i64> {
    values.start..values.end.min(values.start.saturating_add(FIRST_VALUES))
}

/// Returns the values of a variable; errors in them, or in its name, are reported.
pub(super) fn values(
    variable: &Name,
    range: &Range,
    (counting, scope): (Counting<'_>, ScopeId),
    complaints: &mut Complaints<'_>,
) -> Option<std::ops::Range<i64>> {
    let message = match counting.scopes.find(scope, &variable.text) {
        Some(Some(_)) => Some(messages::shadowed_variable(&variable.text)),
        Some(None) => Some(messages::variable_is_parameter(variable.text.trim_end())),
        None if counting.scopes.local(scope, &variable.text).is_some()
            || complaints.knows(&variable.text, (counting.scopes, scope)) =>
        {
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

/// Returns the place of a range.
pub(super) fn origin_of(expressions: &Expressions, range: &Range) -> Origin {
    expressions.origin(range.from).to(expressions.origin(range.to))
}
