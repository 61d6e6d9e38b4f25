//! Loops and choices between statements.

use proc_macro2::{Delimiter, Group, TokenTree};

use crate::syntax::ast::{
    Block, CombinedCondition, ConditionTest, Enclosed, Enclosure, Name, Range, Repetition, Selection,
    Statement, StatementKind, TestKind,
};
use crate::syntax::cursor::{Cursor, group_origin};
use crate::syntax::identifiers::eat_comparison;
use crate::syntax::messages;
use crate::syntax::messages::arrays;
use crate::syntax::parser::{Parsed, Parser, Reported};
use crate::syntax::recovery::Turn;
use lagrange_expr::limits::MAX_BRANCHES;

/// The lines of a choice: those of each condition, and those without a condition.
type Branches<T> = (Vec<(CombinedCondition, Vec<T>)>, Vec<T>);

impl Parser<'_> {
    /// Reads `i in 0..n { … }` after the word `for`.
    pub(super) fn repetition(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let (variable, range, body) = self.in_each(cursor, Self::statements)?;
        Ok(StatementKind::Block(Block::Repeat(Box::new(Repetition { variable, range, body }))))
    }

    /// Reads `i > 0 { … } else if … { … } else { … }` after the word `if`.
    pub(super) fn selection(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let (branches, otherwise) = self.in_branches(cursor, Self::statements)?;
        Ok(StatementKind::Block(Block::Select(Selection { branches, otherwise })))
    }

    /// Reads the lines in braces, including those in loops and choices; there must be at least one.
    /// An error between the braces does not affect the end of the statement.
    pub(in crate::syntax) fn some_lines<T: Enclosed>(
        &mut self,
        group: &Group,
        (nothing, help): (&str, &str),
        read: fn(&mut Self, &mut Cursor) -> Parsed<Vec<T>>,
    ) -> Vec<T> {
        let mistakes = self.report.diagnostics().len();
        let lines = self.inside(group, |parser, cursor| Ok(parser.enclosed_lines(cursor, read)));
        let lines = lines.unwrap_or_default();
        let is_reported = self.report.diagnostics().len() > mistakes || self.is_unreadable(group);
        if lines.is_empty() && !is_reported {
            self.report.error(group_origin(group), nothing).help(help);
        }
        lines
    }

    /// True if a group mentions what could not be read where it is declared. Its lines are omitted.
    fn is_unreadable(&self, group: &Group) -> bool {
        let mut pending = group.stream().into_iter().collect::<Vec<_>>();
        while let Some(token) = pending.pop() {
            match token {
                TokenTree::Ident(word) if self.unreadable_words.contains(&word.to_string()) => return true,
                TokenTree::Group(inner) => pending.extend(inner.stream()),
                TokenTree::Ident(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
        }
        false
    }

    /// Reads lines up to the last token. Unreadable lines are reported and omitted.
    fn enclosed_lines<T: Enclosed>(
        &mut self,
        cursor: &mut Cursor,
        read: fn(&mut Self, &mut Cursor) -> Parsed<Vec<T>>,
    ) -> Vec<T> {
        let (mut lines, mut locals, mut last_local) = (Vec::new(), Vec::new(), None);
        self.each(cursor, |parser, cursor| {
            if cursor.eat(';').is_some() {
                return;
            }
            if cursor.at_word("let") {
                let (here, mistakes) = (cursor.here(), parser.report.diagnostics().len());
                locals.extend(parser.local_name(cursor));
                last_local = (parser.report.diagnostics().len() == mistakes).then_some(here);
                return;
            }
            last_local = None;
            parser.begin_statement();
            let is_block = cursor.at_word("for") || cursor.at_word("if");
            let line = if is_block { parser.block_of_lines(cursor, read) } else { read(parser, cursor) };
            match line {
                Ok(line) => lines.extend(enclosed(line, &locals)),
                Err(Reported) => parser.skip_statement(cursor),
            }
            if cursor.eat(';').is_none() && !parser.skipped && !is_block {
                parser.missing_semicolon(cursor);
            }
        });
        if let Some(origin) = last_local {
            self.fail_once(origin, messages::NOTHING_BEHIND_LOCAL, messages::NOTHING_BEHIND_LOCAL_HELP);
        }
        lines
    }

    /// Reads `let dv = e;` between the braces of an event, a clock or a reduction.
    fn local_name(&mut self, cursor: &mut Cursor) -> Option<Enclosure> {
        let start = cursor.position();
        let mut statement = self.documented_statement(cursor)?;
        let value = statement.kind.expressions().last().copied()?;
        if let Some(name) = statement.kind.names_mut().into_iter().find(|name| !name.indices.is_empty()) {
            self.fail_with_help(name.span, messages::LOCAL_ELEMENT, messages::LOCAL_ELEMENT_HELP);
            self.leave_out(cursor, start);
            return None;
        }
        Some(Enclosure::Local(Box::new(statement), value))
    }

    /// Reads the lines of a loop or a choice, each with its enclosures.
    fn block_of_lines<T: Enclosed>(
        &mut self,
        cursor: &mut Cursor,
        read: fn(&mut Self, &mut Cursor) -> Parsed<Vec<T>>,
    ) -> Parsed<Vec<T>> {
        let within = |parser: &mut Self, cursor: &mut Cursor| parser.enclosed_lines(cursor, read);
        if cursor.eat_word("for").is_some() {
            let (variable, range, lines) = self.in_each(cursor, within)?;
            return Ok(enclosed(lines, &[Enclosure::Loop(variable, range)]));
        }
        let start = cursor.skip_one();
        let (branches, otherwise) = self.in_branches(cursor, within)?;
        if branches.len() as u64 > MAX_BRANCHES {
            let message = messages::long_condition(MAX_BRANCHES);
            return Err(self.fail_with_help(start, message, messages::LONG_CONDITION_HELP));
        }
        let (conditions, bodies): (Vec<_>, Vec<_>) = branches.into_iter().unzip();
        let mut all = Vec::new();
        for (number, lines) in bodies.into_iter().chain([otherwise]).enumerate() {
            let condition = CombinedCondition::of_branch(&conditions[..number], conditions.get(number));
            all.extend(enclosed(lines, &[Enclosure::Condition(condition)]));
        }
        Ok(all)
    }

    /// Reads `i in 0..n { … }` after the word `for`.
    fn in_each<T>(
        &mut self,
        cursor: &mut Cursor,
        read: impl FnOnce(&mut Self, &mut Cursor) -> Vec<T>,
    ) -> Parsed<(Name, Range, Vec<T>)> {
        let head = self.variable(arrays::LOOP_HELP, cursor);
        if head.is_err() {
            self.skip_braces(cursor);
        }
        let (variable, range) = head?;
        let body = self.within(&variable, |parser| parser.between_braces(arrays::LOOP_HELP, cursor, read))?;
        Ok((variable, range, body))
    }

    /// Reads `i > 0 { … } else if … { … } else { … }` after the word `if`.
    fn in_branches<T>(
        &mut self,
        cursor: &mut Cursor,
        mut read: impl FnMut(&mut Self, &mut Cursor) -> Vec<T>,
    ) -> Parsed<Branches<T>> {
        let (mut branches, mut otherwise) = (Vec::new(), Vec::new());
        let whole = self.turns(cursor, |parser, cursor| {
            let condition = parser.counting(cursor, Self::index_condition)?;
            let body = parser.between_braces(arrays::SELECTION_HELP, cursor, &mut read)?;
            branches.push((condition, body));
            if cursor.eat_word("else").is_none() {
                return Ok(Turn::Last);
            }
            if cursor.eat_word("if").is_some() {
                return Ok(Turn::Next);
            }
            otherwise = parser.between_braces(arrays::SELECTION_HELP, cursor, &mut read)?;
            Ok(Turn::Last)
        });
        if whole.is_err() {
            self.skip_braces(cursor);
        }
        whole.map(|()| (branches, otherwise))
    }

    /// Reads statements in braces.
    pub(in crate::syntax) fn statements_between_braces(
        &mut self,
        help: &str,
        cursor: &mut Cursor,
    ) -> Parsed<Vec<Statement>> {
        self.between_braces(help, cursor, Self::statements)
    }

    /// Reads lines or statements in braces.
    fn between_braces<T>(
        &mut self,
        help: &str,
        cursor: &mut Cursor,
        read: impl FnOnce(&mut Self, &mut Cursor) -> Vec<T>,
    ) -> Parsed<Vec<T>> {
        let group = self.braces(help, cursor)?;
        let counts = std::mem::replace(&mut self.counts, false);
        let lines = self.inside(&group, |parser, cursor| Ok(read(parser, cursor)));
        (self.counts, self.skipped) = (counts, false);
        lines
    }

    /// Reads `i > 0 && i < n || …`.
    pub(in crate::syntax) fn index_condition(&mut self, cursor: &mut Cursor) -> Parsed<CombinedCondition> {
        self.combined_condition(cursor, |parser, cursor| {
            parser.misplaced(arrays::COMPARISON, arrays::SELECTION_HELP, cursor)
        })
    }

    /// Reads comparisons with `&&`, `||` and `!`; `missing` reports a comparison without its sign.
    pub(in crate::syntax) fn combined_condition(
        &mut self,
        cursor: &mut Cursor,
        missing: fn(&mut Self, &mut Cursor) -> Reported,
    ) -> Parsed<CombinedCondition> {
        let mut alternatives = vec![Vec::new()];
        self.turns(cursor, |parser, cursor| {
            let test = parser.test(cursor, missing)?;
            if let Some(tests) = alternatives.last_mut() {
                tests.push(test);
            }
            let is_or = cursor.at_pair('|', '|');
            if is_or {
                alternatives.push(Vec::new());
            }
            let goes_on = is_or || cursor.at_pair('&', '&');
            if goes_on {
                cursor.skip_one();
                cursor.skip_one();
            }
            Ok(Turn::next_if(goes_on))
        })?;
        Ok(CombinedCondition { alternatives })
    }

    /// Reads `!(…)`, `(…)` or `i < n`.
    fn test(
        &mut self,
        cursor: &mut Cursor,
        missing: fn(&mut Self, &mut Cursor) -> Reported,
    ) -> Parsed<ConditionTest> {
        let is_negated = cursor.eat_all('!').count() % 2 == 1;
        let group = cursor.group(Delimiter::Parenthesis).filter(|group| is_condition(group)).cloned();
        if let Some(group) = group.filter(|_| ends_test(cursor.peek_past(1))) {
            cursor.skip_one();
            let condition = self.inside(&group, |parser, cursor| {
                let condition = parser.combined_condition(cursor, missing)?;
                match cursor.at_end() {
                    true => Ok(condition),
                    false => Err(parser.no_operator(cursor, "`)`")),
                }
            })?;
            return Ok(ConditionTest { is_negated, kind: TestKind::Nested(condition) });
        }
        let left = self.expression(cursor)?;
        let Some(comparison) = eat_comparison(cursor) else { return Err(missing(self, cursor)) };
        let right = self.expression(cursor)?;
        Ok(ConditionTest { is_negated, kind: TestKind::Comparison(left, comparison, right) })
    }
}

/// Returns lines with additional enclosures.
fn enclosed<T: Enclosed>(mut lines: Vec<T>, around: &[Enclosure]) -> Vec<T> {
    for line in &mut lines {
        line.enclosures_mut().splice(0..0, around.iter().cloned());
    }
    lines
}

/// True for tokens that may follow a condition in parentheses, but not a part of a sum.
fn ends_test(token: Option<&TokenTree>) -> bool {
    match token {
        Some(TokenTree::Punct(punct)) => "&|,;".contains(punct.as_char()),
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Brace,
        Some(_) => false,
        None => true,
    }
}

/// True for parentheses around a condition rather than a part of an index.
fn is_condition(group: &Group) -> bool {
    let mut pending = group.stream().into_iter().collect::<Vec<_>>();
    while let Some(token) = pending.pop() {
        match token {
            TokenTree::Punct(punct) if "<>=!&|".contains(punct.as_char()) => return true,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => {
                pending.extend(group.stream());
            }
            _ => {}
        }
    }
    false
}
