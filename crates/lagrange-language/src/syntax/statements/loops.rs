//! Loops and choices between statements.

use proc_macro2::{Delimiter, Group, TokenTree};

use crate::syntax::ast::{
    Block, CombinedCondition, ConditionTest, Repetition, Selection, Statement, StatementKind, TestKind,
};
use crate::syntax::cursor::Cursor;
use crate::syntax::identifiers::eat_comparison;
use crate::syntax::messages::arrays;
use crate::syntax::parser::{Parsed, Parser, Reported};
use crate::syntax::recovery::Turn;

impl Parser<'_> {
    /// `i in 0..n { … }` behind the word `for`.
    pub(super) fn repetition(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let head = self.variable(arrays::LOOP_HELP, cursor);
        if head.is_err() {
            self.skip_braces(cursor);
        }
        let (variable, range) = head?;
        let body =
            self.within(&variable, |parser| parser.statements_between_braces(arrays::LOOP_HELP, cursor))?;
        Ok(StatementKind::Block(Block::Repeat(Box::new(Repetition { variable, range, body }))))
    }

    /// `i > 0 { … } else if … { … } else { … }` behind the word `if`.
    pub(super) fn selection(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let mut selection = Selection { branches: Vec::new(), otherwise: Vec::new() };
        let whole = self.turns(cursor, |parser, cursor| {
            let condition = parser.counting(cursor, Self::index_condition)?;
            let body = parser.statements_between_braces(arrays::SELECTION_HELP, cursor)?;
            selection.branches.push((condition, body));
            if cursor.eat_word("else").is_none() {
                return Ok(Turn::Last);
            }
            if cursor.eat_word("if").is_some() {
                return Ok(Turn::Next);
            }
            selection.otherwise = parser.statements_between_braces(arrays::SELECTION_HELP, cursor)?;
            Ok(Turn::Last)
        });
        if whole.is_err() {
            self.skip_braces(cursor);
        }
        whole.map(|()| StatementKind::Block(Block::Select(selection)))
    }

    /// Reads statements in braces.
    pub(in crate::syntax) fn statements_between_braces(
        &mut self,
        help: &str,
        cursor: &mut Cursor,
    ) -> Parsed<Vec<Statement>> {
        let group = self.braces(help, cursor)?;
        let counts = std::mem::replace(&mut self.counts, false);
        let statements = self.inside(&group, |parser, cursor| Ok(parser.statements(cursor)));
        (self.counts, self.skipped) = (counts, false);
        statements
    }

    /// `i > 0 && i < n || …`
    pub(in crate::syntax) fn index_condition(&mut self, cursor: &mut Cursor) -> Parsed<CombinedCondition> {
        self.combined_condition(cursor, |parser, cursor| {
            parser.misplaced(arrays::COMPARISON, arrays::SELECTION_HELP, cursor)
        })
    }

    /// Comparisons with `&&`, `||` and `!`; `missing` reports one without its sign.
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

    /// `!(…)`, `(…)` or `i < n`
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

/// True of what may stand behind a condition in parentheses, and not behind a part of a sum.
fn ends_test(token: Option<&TokenTree>) -> bool {
    match token {
        Some(TokenTree::Punct(punct)) => "&|,;".contains(punct.as_char()),
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Brace,
        Some(_) => false,
        None => true,
    }
}

/// True of parentheses around a condition rather than around a part of an index.
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
