//! Statements that are not what they should be: what to report, and where to read on.

use proc_macro2::{Delimiter, Ident};

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

    /// Skips a statement of a kind that does not exist yet, if one begins here.
    pub(super) fn future_statement(&mut self, cursor: &mut Cursor) -> bool {
        let word = cursor.statement_keyword();
        let Some(keyword) = word.filter(|word| keywords::FUTURE_STATEMENTS.contains(&word.as_str())) else {
            return false;
        };
        let error = self.report.error(cursor.skip_one(), messages::future_statement(&keyword));
        error.help(messages::future_statement_help(&keyword));
        // Only the braces of a body end it; those of an `if` do not.
        while keyword == "body" && !cursor.at_end() && !cursor.at(';') && !cursor.at_statement() {
            let last = cursor.group(Delimiter::Brace).is_some();
            cursor.skip_one();
            if last {
                cursor.eat(';');
                return true;
            }
        }
        cursor.skip_statement();
        cursor.eat(';');
        true
    }

    pub(super) fn unknown_statement(&mut self, word: &Ident, cursor: &Cursor) -> Reported {
        let text = word.to_string();
        let known = keywords::STATEMENTS.iter().chain(keywords::FUTURE_STATEMENTS).copied();
        let help = match nearest(&text, known) {
            Some(keyword) => messages::meant(keyword),
            None if cursor.equals_past(0) => messages::meant_let(&text),
            None => messages::statements_are(keywords::STATEMENTS),
        };
        self.fail_with_help(word.span(), messages::unknown_statement(&text), help)
    }
}
