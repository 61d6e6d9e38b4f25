//! Statements that are not what they should be: what to report, and where to read on.

use proc_macro2::Ident;

use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::parser::{Parser, Reported};
use crate::diagnostics::nearest;

impl Parser<'_> {
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
