//! Lists of items separated by commas.

use proc_macro2::{Ident, TokenTree};

use super::cursor::Cursor;
use super::keywords;
use super::messages::{self, habits, ranges};
use super::parser::{Parsed, Parser, Reported};
use super::recovery::Turn;
use lagrange_expr::diagnostics::nearest;

impl Parser<'_> {
    /// Reads items separated by commas, with an optional trailing comma, up to the end of the
    /// statement. Unreadable items are omitted, and their words count as declared.
    pub(super) fn items<T>(
        &mut self,
        help: &'static str,
        cursor: &mut Cursor,
        read: impl FnMut(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Vec<T> {
        self.list(help, cursor, read, Self::leave_out)
    }

    /// Reads items as [`Parser::items`] does, of a statement that declares nothing: words of
    /// unreadable items remain unknown.
    pub(super) fn settings<T>(
        &mut self,
        help: &'static str,
        cursor: &mut Cursor,
        read: impl FnMut(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Vec<T> {
        self.list(help, cursor, read, |_, _, _| {})
    }

    fn list<T>(
        &mut self,
        help: &'static str,
        cursor: &mut Cursor,
        mut read: impl FnMut(&mut Self, &mut Cursor) -> Parsed<T>,
        omit: fn(&mut Self, &Cursor, usize),
    ) -> Vec<T> {
        let mut items = Vec::new();
        let _ = self.turns(cursor, |parser, cursor| {
            parser.skipped = false;
            let start = cursor.position();
            match parser.item(help, cursor, &mut read) {
                Ok(item) => items.push(item),
                Err(Reported) => {
                    parser.skip_item(cursor);
                    omit(parser, cursor, start);
                }
            }
            if !parser.skipped && !at_item_end(cursor) {
                let is_separated = parser.no_comma(help, start, cursor);
                if is_separated {
                    return Ok(Turn::Next);
                }
            }
            Ok(Turn::next_if(cursor.eat(',').is_some() && !at_list_end(cursor)))
        });
        items
    }

    /// Reports a token other than a comma after an item. Returns true if the next item follows
    /// nevertheless.
    fn no_comma(&mut self, help: &str, start: usize, cursor: &mut Cursor) -> bool {
        let is_next = at_next_item(cursor) && cursor.position() > start;
        if ["start", "init", "initial"].into_iter().any(|word| cursor.at_word(word)) {
            self.fail_with_help(cursor.here(), habits::VALUE_BEHIND_WORD, help);
            self.skip_item(cursor);
            return false;
        }
        if is_next && !cursor.at_same_word() {
            self.fail_once(cursor.here(), messages::MISSING_COMMA, help);
            return true;
        }
        if is_next {
            let help = messages::REPEATED_ATTRIBUTE_HELP;
            self.fail_with_help(cursor.skip_one(), habits::TWICE_IN_A_ROW, help);
            self.skip_item(cursor);
        } else if is_misspelt_statement(cursor) {
            let help = messages::MISSING_SEMICOLON_HELP;
            self.fail_with_help(cursor.before().end, messages::MISSING_SEMICOLON, help);
            self.skipped = true;
        } else {
            self.no_operator(cursor, "`,` or `;`");
            self.skip_item(cursor);
        }
        false
    }

    fn item<T>(
        &mut self,
        help: &str,
        cursor: &mut Cursor,
        read: &mut impl FnMut(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Parsed<T> {
        if let Some((origin, number)) = cursor.decimal_comma(-1) {
            return Err(self.fail_with_help(origin, habits::DECIMAL_COMMA, habits::decimal_point(&number)));
        }
        if cursor.ident().is_none() {
            let is_compared =
                matches!(cursor.peek_past(1), Some(TokenTree::Punct(sign)) if "<>".contains(sign.as_char()));
            return Err(self.no_name(if is_compared { ranges::BOUND_FIRST_HELP } else { help }, cursor));
        }
        read(self, cursor)
    }
}

/// True if an item ends here, even if its semicolon is missing.
pub(super) fn at_item_end(cursor: &Cursor) -> bool {
    cursor.at(',') || cursor.at_statement_end()
}

/// True if the next item follows without a comma: another name after one, or a name with its `=`.
fn at_next_item(cursor: &Cursor) -> bool {
    let are_names = cursor.ident().is_some() && matches!(cursor.previous(), Some(TokenTree::Ident(_)));
    are_names || is_definition(cursor) && !is_misspelt_statement(cursor)
}

/// True if a line begins with `=` after a word similar to one that begins a statement.
fn is_misspelt_statement(cursor: &Cursor) -> bool {
    let is_on_new_line = cursor.here().start.start().line > cursor.before().end.end().line;
    let is_like = |word: &Ident| nearest(&word.to_string(), keywords::STATEMENTS).is_some();
    is_definition(cursor) && is_on_new_line && cursor.ident().is_some_and(is_like)
}

/// True if a name and its `=` follow.
pub(super) fn is_definition(cursor: &Cursor) -> bool {
    cursor.ident().is_some() && cursor.equals_past(1)
}

/// True if no item follows a comma. A keyword before `=` is an item with a wrong name.
fn at_list_end(cursor: &Cursor) -> bool {
    cursor.at(';') || cursor.at_end() || (cursor.at_statement() && !cursor.equals_past(1))
}
