//! Statements that are not what they should be: what to report, and where to read on.

use proc_macro2::Ident;

use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::parser::{Parsed, Parser, Reported};
use crate::diagnostics::nearest;

/// Whether reading goes on behind a turn of [`Parser::turns`].
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
    /// Reads turn by turn up to the last one. This is the only loop over tokens that does not skip them, and
    /// it comes to an end whatever the turns do: a token that none of them takes is skipped, with a
    /// complaint unless the turn complained.
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
                    self.fail(cursor.here(), messages::misplaced(cursor.peek()));
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

    /// Skips what cannot be read, up to what ends the statement.
    pub(super) fn skip_statement(&mut self, cursor: &mut Cursor) {
        self.skipped = true;
        cursor.skip_statement();
    }

    /// Skips what cannot be read, up to the next comma or what ends the statement.
    pub(super) fn skip_item(&mut self, cursor: &mut Cursor) {
        self.skipped = true;
        cursor.skip_item();
    }

    /// Reports that a statement goes on where it should end.
    pub(super) fn missing_semicolon(&mut self, cursor: &mut Cursor) {
        if cursor.at_end() {
            self.report.error(cursor.before().end, messages::MISSING_SEMICOLON);
        } else if cursor.statement_keyword().is_some() {
            let error = self.report.error(cursor.before().end, messages::MISSING_SEMICOLON);
            error.related(cursor.here(), messages::NEXT_STATEMENT);
        } else {
            self.no_operator(cursor, "`;`");
            self.skip_statement(cursor);
            cursor.eat(';');
        }
    }

    pub(super) fn unknown_statement(&mut self, word: &Ident, cursor: &Cursor) -> Reported {
        let text = word.to_string();
        let help = match nearest(&text, keywords::STATEMENTS.iter().copied()) {
            Some(keyword) => messages::meant(keyword),
            None if cursor.equals_past(0) => messages::meant_let(&text),
            None => messages::statements_are(keywords::STATEMENTS),
        };
        self.fail_with_help(word.span(), messages::unknown_statement(&text), help)
    }
}
