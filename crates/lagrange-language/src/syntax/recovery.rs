//! Invalid statements: the error to report, and the place from which to continue.

use proc_macro2::{Delimiter, Ident, TokenTree};

use super::cursor::{Cursor, as_group};
use super::foreign;
use super::identifiers::at_equals_past;
use super::keywords;
use super::messages;
use super::messages::forms;
use super::messages::forms::form;
use super::messages::habits;
use super::messages::parts;
use super::parser::{Declared, Parsed, Parser, Reported};
use lagrange_expr::diagnostics::nearest;

/// Continuation after a turn of [`Parser::turns`].
pub(super) enum Turn {
    Next,
    Last,
}

impl Turn {
    pub(super) fn next_if(goes_on: bool) -> Turn {
        if goes_on { Turn::Next } else { Turn::Last }
    }
}

impl Parser<'_> {
    /// Reads turn by turn up to the last one. This is the only loop over tokens that does not skip
    /// them, and it terminates for any turns. A token that no turn consumes is skipped, with a
    /// report unless the turn has reported an error.
    pub(super) fn turns(
        &mut self,
        cursor: &mut Cursor,
        mut turn: impl FnMut(&mut Self, &mut Cursor) -> Parsed<Turn>,
    ) -> Parsed<()> {
        loop {
            let (start, mistakes) = (cursor.position(), self.report.diagnostics().len());
            if matches!(turn(self, cursor)?, Turn::Last) {
                return Ok(());
            }
            if cursor.position() == start {
                if cursor.at_end() {
                    return Ok(());
                }
                if self.report.diagnostics().len() == mistakes {
                    let message = messages::misplaced(cursor.peek());
                    self.fail_with_help(cursor.here(), message, messages::MISPLACED_HELP);
                }
                cursor.skip_one();
            }
        }
    }

    /// Reads turn by turn up to the last token.
    pub(super) fn each(&mut self, cursor: &mut Cursor, mut turn: impl FnMut(&mut Self, &mut Cursor)) {
        let _ = self.turns(cursor, |parser, cursor| {
            if cursor.at_end() {
                return Ok(Turn::Last);
            }
            turn(parser, cursor);
            Ok(Turn::Next)
        });
    }

    /// Reads turn by turn as long as the next token is this punctuation character.
    pub(super) fn each_at(
        &mut self,
        punctuation: char,
        cursor: &mut Cursor,
        mut turn: impl FnMut(&mut Self, &mut Cursor),
    ) {
        let _ = self.turns(cursor, |parser, cursor| {
            if !cursor.at(punctuation) {
                return Ok(Turn::Last);
            }
            turn(parser, cursor);
            Ok(Turn::Next)
        });
    }

    /// Skips unreadable tokens, up to the end of the statement.
    pub(super) fn skip_statement(&mut self, cursor: &mut Cursor) {
        self.skipped = true;
        cursor.skip_statement();
    }

    /// Skips unreadable tokens, up to the next comma or the end of the statement.
    pub(super) fn skip_item(&mut self, cursor: &mut Cursor) {
        self.skipped = true;
        cursor.skip_item();
    }

    /// Reports a statement that continues where it should end.
    pub(super) fn missing_semicolon(&mut self, cursor: &mut Cursor) {
        let before = cursor.before().end;
        if cursor.at_end() {
            self.fail_with_help(before, messages::MISSING_SEMICOLON, messages::MISSING_SEMICOLON_HELP);
        } else if cursor.statement_keyword().is_some() {
            let error = self.report.error(before, messages::MISSING_SEMICOLON);
            error.related(cursor.here(), messages::NEXT_STATEMENT).help(messages::MISSING_SEMICOLON_HELP);
        } else {
            self.no_operator(cursor, "`;`");
            self.skip_statement(cursor);
            cursor.eat(';');
        }
    }

    /// Reports the comment sign of other languages, and skips the comment.
    pub(super) fn comment(&mut self, cursor: &mut Cursor) {
        self.fail_with_help(cursor.here(), habits::COMMENT, messages::COMMENT_HELP);
        let start = cursor.position();
        cursor.skip_one();
        cursor.skip_line_of_text();
        self.leave_out(cursor, start);
    }

    /// Reports a statement that does not begin with a word.
    pub(super) fn no_statement(&mut self, cursor: &Cursor) -> Reported {
        let is_assigned = at_equals_past(1, cursor) && cursor.group(Delimiter::Parenthesis).is_some();
        let help = match is_assigned {
            true => form("let").to_owned(),
            false if is_equation(cursor) => habits::equations_are_derived(),
            false => messages::statements_are(&keywords::STATEMENTS),
        };
        let message = messages::expected(messages::STATEMENT, cursor.peek());
        self.fail_with_help(cursor.here(), message, help)
    }

    /// Reports a second system and skips it with all that follows.
    pub(super) fn second_system(&mut self, cursor: &mut Cursor) {
        let start = cursor.position();
        cursor.skip_to(|cursor| cursor.at_word("struct"));
        cursor.skip_one();
        if cursor.ident().is_some() {
            cursor.skip_one();
        }
        let origin = cursor.since(start);
        self.fail_with_help(origin, habits::SECOND_SYSTEM, habits::SECOND_SYSTEM_HELP);
        cursor.skip_to(|_| false);
        self.leave_out(cursor, start);
    }

    pub(super) fn unknown_statement(&mut self, word: &Ident, cursor: &Cursor) -> Reported {
        let text = word.to_string();
        if let Some(part) = placed_part(cursor) {
            let help = parts::placed_as(&text, &part);
            return self.fail_with_help(word.span(), messages::unknown_statement(&text), help);
        }
        if let Some((message, help)) = self.strange_statement(&text, cursor) {
            return self.fail_with_help(word.span(), message, help);
        }
        // No equals sign follows `every`.
        let is_possible = |keyword: &&str| !(*keyword == "every" && cursor.equals_past(0));
        let help = match nearest(&text, keywords::STATEMENTS.into_iter().filter(is_possible)) {
            _ if self.declared(&text).is_some() => habits::equations_are_derived(),
            Some(keyword) => messages::meant(keyword),
            None if cursor.equals_past(0) => messages::meant_let(&text),
            None => messages::statements_are(&keywords::STATEMENTS),
        };
        self.fail_with_help(word.span(), messages::unknown_statement(&text), help)
    }

    /// Returns the message for a word that begins no statement but is defined in this declaration
    /// or in other languages.
    fn strange_statement(&self, word: &str, cursor: &Cursor) -> Option<(String, String)> {
        let is_assigned = at_equals_past(0, cursor);
        match self.declared(word) {
            Some(Declared::Coordinate) if is_assigned => {
                return Some((messages::unknown_statement(word), habits::start_of(word)));
            }
            Some(Declared::Parameter) if is_assigned => {
                return Some((habits::declared_already(word), habits::value_where_declared(word)));
            }
            Some(_) if is_assigned => {
                return Some((habits::declared_already(word), messages::OTHER_NAME_HELP.to_owned()));
            }
            Some(_) => return None,
            None => {}
        }
        if word == "ddot"
            && let Some(of) = cursor.group(Delimiter::Parenthesis)
            && self.declared(&of.stream().to_string()) == Some(Declared::State)
        {
            let rate = format!("dot({})", of.stream());
            return Some((messages::unknown_statement(word), habits::rate_of_state(&rate)));
        }
        if ["dot", "ddot"].contains(&word) {
            return Some((messages::unknown_statement(word), habits::rate_as_statement(word)));
        }
        if let Some(rate) = self.stated_rate(word, cursor) {
            return Some((messages::unknown_statement(word), habits::rate_of_state(&rate)));
        }
        if let Some((message, help)) = foreign::stranger(word) {
            return Some((message.to_owned(), help.to_owned()));
        }
        let keyword = match foreign::statement(word)? {
            // A hinge between bodies creates a coordinate; a pin holds points together.
            "pin" if between_bodies(cursor) => "revolute",
            keyword => keyword,
        };
        Some((messages::unknown_statement(word), forms::meant_form(keyword)))
    }

    /// Returns the declared form of a rate written in foreign notation, `der(a) =` or `a_dot =`:
    /// `dot(a)`.
    fn stated_rate(&self, word: &str, cursor: &Cursor) -> Option<String> {
        match cursor.group(Delimiter::Parenthesis) {
            Some(of) if foreign::derives(word) && at_equals_past(1, cursor) => {
                Some(format!("dot({})", of.stream()))
            }
            _ if at_equals_past(0, cursor) => {
                let is_state = |name: &str| matches!(self.declared(name), Some(Declared::State));
                foreign::rate(word, is_state).filter(|rate| rate.order == 1).map(foreign::Rate::written)
            }
            _ => None,
        }
    }

    /// Reports an equation or an inequality in a constraint.
    pub(super) fn relation_in_constraint(&mut self, name: &str, cursor: &Cursor) -> Reported {
        let origin = cursor.here_to_pair();
        match cursor.at('=') && !cursor.at_pair('=', '<') {
            true => self.fail_with_help(origin, habits::EQUATION, habits::difference(name)),
            false => self.fail_with_help(origin, habits::INEQUALITY, habits::contact(name)),
        }
    }
}

/// Returns the word in `= Leg { … }`.
fn placed_part(cursor: &Cursor) -> Option<String> {
    let part = cursor.peek_past(1).filter(|_| cursor.equals_past(0))?;
    let is_braced = as_group(cursor.peek_past(2), Delimiter::Brace).is_some();
    matches!(part, TokenTree::Ident(_)).then(|| part.to_string()).filter(|_| is_braced)
}

/// True at an equation for rates or accelerations.
fn is_equation(cursor: &Cursor) -> bool {
    let is_rate = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if ["dot", "ddot"].contains(&word.to_string().as_str()));
    let statement = cursor.rest_of_statement();
    statement.iter().any(is_rate) && (0..statement.len()).any(|count| cursor.equals_past(count))
}

/// True if `a to b`, possibly after a name and `=`, is the rest of the statement or precedes
/// braces.
fn between_bodies(cursor: &Cursor) -> bool {
    let first = if cursor.equals_past(1) { 2 } else { 0 };
    let is_word = |count: usize| matches!(cursor.peek_past(first + count), Some(TokenTree::Ident(_)));
    let ends = match cursor.peek_past(first + 3) {
        None => true,
        Some(TokenTree::Punct(punct)) => punct.as_char() == ';',
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Brace,
        Some(_) => false,
    };
    (0..3).all(is_word) && ends
}
