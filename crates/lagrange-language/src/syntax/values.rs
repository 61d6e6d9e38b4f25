//! Values at the end of statements, and words between them.

use super::ast::AstId;
use super::cursor::Cursor;
use super::messages;
use super::parser::{Parsed, Parser};

impl Parser<'_> {
    /// Reads `= e`, up to the end of the statement.
    pub(super) fn assigned(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<AstId> {
        self.equals(help, cursor)?;
        Ok(self.value(cursor))
    }

    /// Reads the expression that ends the statement. An unreadable one still counts as a value, so
    /// that the name remains declared.
    pub(super) fn value(&mut self, cursor: &mut Cursor) -> AstId {
        let start = cursor.position();
        match self.expression(cursor) {
            Ok(id) if cursor.at_statement_end() => return id,
            Ok(_) => self.no_operator(cursor, "`;`"),
            Err(reported) => reported,
        };
        let behind = cursor.position();
        self.skip_statement(cursor);
        // It may be a second definition.
        self.leave_out(cursor, behind);
        self.unreadable(cursor, start)
    }

    pub(super) fn connective(&mut self, word: &str, help: &str, cursor: &mut Cursor) -> Parsed<()> {
        if cursor.eat_word(word).is_some() {
            return Ok(());
        }
        let message = messages::expected(&format!("`{word}`"), cursor.peek());
        Err(self.fail_with_help(cursor.here(), message, help))
    }
}
