//! `if c { a } else { b }`.

use proc_macro2::{Delimiter, Ident, Spacing, TokenTree};

use super::ReadOperand;
use crate::syntax::ast::{ArrayExpression, AstId, CombinedCondition, Condition, Expression, TestKind};
use crate::syntax::cursor::{Cursor, as_group, group_origin};
use crate::syntax::messages;
use crate::syntax::messages::habits;
use crate::syntax::parser::{Declared, Parsed, Parser, Reported};
use crate::syntax::recovery::Turn;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_BRANCHES;

/// `if condition { then } else`, before the rest is read.
struct Branch {
    start: Origin,
    decision: Decision,
    then: AstId,
}

/// The condition that decides between the branches.
enum Decision {
    /// Comparisons during the motion, or a single one of indices.
    Moving(CombinedCondition),
    /// Only indices.
    Indices(CombinedCondition),
}

impl Parser<'_> {
    /// Reads a chain that begins with `if`.
    pub(in crate::syntax) fn conditional(&mut self, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let mut branches = Vec::new();
        self.turns(cursor, |parser, cursor| {
            branches.push(parser.branch(cursor)?);
            Ok(Turn::next_if(cursor.at_word("if")))
        })?;
        let last = self.block(cursor)?;
        let nest = |otherwise: ReadOperand, branch: Branch| {
            let Branch { start, decision, then } = branch;
            let ReadOperand { id: otherwise, origin } = otherwise;
            let origin = start.to(origin);
            match decision {
                Decision::Moving(condition) => {
                    ReadOperand { id: self.decided(&condition, [then, otherwise], origin), origin }
                }
                Decision::Indices(condition) => {
                    let select = ArrayExpression::Select { condition, then, otherwise };
                    self.add(Expression::Array(select), origin)
                }
            }
        };
        Ok(branches.into_iter().rev().fold(last, nest))
    }

    fn branch(&mut self, cursor: &mut Cursor) -> Parsed<Branch> {
        let start = cursor.skip_one();
        let decision = self.nested(start, |parser| parser.decision(cursor))?;
        let then = self.block(cursor)?;
        if cursor.eat_word("else").is_none() {
            let origin = start.to(then.origin);
            return Err(self.fail_with_help(origin, messages::MISSING_ELSE, messages::MISSING_ELSE_HELP));
        }
        Ok(Branch { start, decision, then: then.id })
    }

    fn decision(&mut self, cursor: &mut Cursor) -> Parsed<Decision> {
        if !self.are_indices_asked(cursor) {
            return self.condition(cursor).map(Decision::Moving);
        }
        let condition = self.counting(cursor, Self::index_condition)?;
        match cursor.group(Delimiter::Brace) {
            Some(_) => Ok(Decision::Indices(condition)),
            None => Err(self.no_block(cursor, "`{`")),
        }
    }

    /// True if a condition compares a variable of a loop in a way that is only valid for indices.
    fn are_indices_asked(&self, cursor: &Cursor) -> bool {
        if self.variables.is_empty() {
            return false;
        }
        let is_variable = |word: &str| self.variables.iter().any(|variable| variable == word);
        let (mut has_variable, mut has_sign) = (false, false);
        let is_before = |token: &&TokenTree| !matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        let mut pending = cursor.rest().iter().take_while(is_before).cloned().collect::<Vec<_>>();
        pending.reverse();
        while let Some(token) = pending.pop() {
            match token {
                TokenTree::Ident(word) => has_variable |= is_variable(&word.to_string()),
                TokenTree::Punct(punct) if punct.as_char() == ';' => break,
                TokenTree::Punct(punct) => {
                    let is_doubled = punct.spacing() == Spacing::Joint
                        && matches!(pending.last(), Some(TokenTree::Punct(next)) if next.as_char() == '=');
                    has_sign |= "!&|%".contains(punct.as_char()) || punct.as_char() == '=' && is_doubled;
                }
                TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => {
                    let content = group.stream().into_iter().collect::<Vec<_>>();
                    pending.extend(content.into_iter().rev());
                }
                // Square brackets contain an index, whatever is compared.
                TokenTree::Group(_) | TokenTree::Literal(_) => {}
            }
        }
        has_variable && has_sign
    }

    /// Reads a condition on moving quantities up to its block.
    fn condition(&mut self, cursor: &mut Cursor) -> Parsed<CombinedCondition> {
        let start = cursor.here();
        let is_alone = as_group(cursor.peek_past(1), Delimiter::Brace).is_some();
        let is_unreadable = |word: &Ident| {
            let word = word.to_string();
            let may_be_condition = self.declared(&word).is_none_or(|declared| declared == Declared::Other);
            may_be_condition && self.unreadable_words.contains(&word)
        };
        if is_alone && cursor.ident().is_some_and(is_unreadable) {
            // It stands for a condition, which has been reported where it was named.
            return Err(Reported);
        }
        let condition = self.combined_condition(cursor, |parser, cursor| parser.no_relation(cursor))?;
        if cursor.group(Delimiter::Brace).is_none() {
            return Err(self.no_block(cursor, "`{`"));
        }
        let [then, otherwise] = condition.copies();
        if then.saturating_add(otherwise) > MAX_BRANCHES {
            let message = messages::long_condition(MAX_BRANCHES);
            return Err(self.fail_with_help(
                start.to(cursor.before()),
                message,
                messages::LONG_CONDITION_HELP,
            ));
        }
        Ok(condition)
    }

    /// Writes a choice by several comparisons as choices by single comparisons with shared
    /// branches.
    fn decided(&mut self, condition: &CombinedCondition, branches: [AstId; 2], origin: Origin) -> AstId {
        let [then, mut otherwise] = branches;
        for tests in condition.alternatives.iter().rev() {
            otherwise = tests.iter().rev().fold(then, |then, test| {
                let branches = if test.is_negated { [otherwise, then] } else { [then, otherwise] };
                match &test.kind {
                    TestKind::Nested(condition) => self.decided(condition, branches, origin),
                    TestKind::Comparison(left, relation, right) => {
                        let condition = Condition { left: *left, relation: *relation, right: *right };
                        let [then, otherwise] = branches;
                        self.add(Expression::If { condition, then, otherwise }, origin).id
                    }
                }
            });
        }
        otherwise
    }

    fn no_relation(&mut self, cursor: &Cursor) -> Reported {
        if cursor.equals_past(0) && !cursor.at_pair('=', '<') {
            self.fail_with_help(cursor.here_to_pair(), messages::EQUALITY, messages::EQUALITY_HELP)
        } else if is_logical_word(cursor) {
            self.fail_with_help(cursor.here(), messages::LOGIC, messages::LOGIC_HELP)
        } else if cursor.group(Delimiter::Brace).is_some() {
            let message = messages::expected(messages::arrays::COMPARISON, cursor.peek());
            self.fail_with_help(cursor.here(), message, messages::COMPARISON_PLACE_HELP)
        } else {
            self.no_operator(cursor, messages::arrays::COMPARISON)
        }
    }

    /// Reports an unexpected token after a comparison.
    fn no_block(&mut self, cursor: &Cursor, wanted: &str) -> Reported {
        if is_logical_word(cursor) {
            self.fail_with_help(cursor.here(), messages::LOGIC, messages::LOGIC_HELP)
        } else if cursor.at('<') || cursor.at('>') || cursor.at_pair('=', '=') {
            self.fail_with_help(cursor.here(), messages::COMPARISON_CHAIN, messages::COMPARISON_CHAIN_HELP)
        } else {
            self.no_operator(cursor, wanted)
        }
    }

    /// Reads `{ e }`.
    fn block(&mut self, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let Some(group) = cursor.eat_group(Delimiter::Brace) else {
            let message = messages::expected("`{`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, messages::COMPARISON_PLACE_HELP));
        };
        let origin = group_origin(&group);
        match self.inside(&group, |parser, cursor| parser.block_content(cursor, origin)) {
            Ok(id) => Ok(ReadOperand { id, origin }),
            Err(Reported) => Ok(self.add(Expression::Invalid, origin)),
        }
    }

    fn block_content(&mut self, cursor: &mut Cursor, origin: Origin) -> Parsed<AstId> {
        if cursor.at_end() {
            let help = habits::MISSING_EXPRESSION;
            return Err(self.fail_with_help(origin, messages::EMPTY_BLOCK, help));
        }
        let value = if cursor.at_statement() { None } else { Some(self.expression(cursor)?) };
        match value {
            Some(value) if cursor.at_end() => Ok(value),
            Some(_) if !cursor.at(';') => Err(self.no_operator(cursor, "`}`")),
            _ => Err(self.fail_with_help(cursor.here(), messages::BLOCK_CONTENT, messages::LET_HELP)),
        }
    }
}

fn is_logical_word(cursor: &Cursor) -> bool {
    ["and", "or"].iter().any(|word| cursor.at_word(word))
}
