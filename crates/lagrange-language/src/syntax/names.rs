//! Names that a declaration introduces.

use proc_macro2::{Delimiter, TokenTree};

use super::ast::Name;
use super::cursor::Cursor;
use super::identifiers::at_equals_past;
use super::messages;
use super::messages::forms::form;
use super::messages::habits;
use super::parser::{Parsed, Parser};
use super::recovery::Turn;
use super::units::at_unit;

impl Parser<'_> {
    /// Reads a name that is being declared, with the square brackets after it.
    pub(super) fn declared_name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        let name = self.free_name(cursor)?;
        self.indexed(name, cursor)
    }

    /// Reads the members after a name, `.hip[1]`.
    pub(super) fn with_members(&mut self, name: Name, cursor: &mut Cursor) -> Parsed<Name> {
        let mut whole = name;
        self.turns(cursor, |parser, cursor| {
            if !at_member(cursor) {
                return Ok(Turn::Last);
            }
            cursor.skip_one();
            let member = parser.name(cursor)?;
            whole.members.push(parser.indexed(member, cursor)?);
            Ok(Turn::Next)
        })?;
        Ok(whole)
    }

    /// Reads the name that a statement declares before its `=`.
    pub(super) fn leading_name(&mut self, keyword: &str, cursor: &mut Cursor) -> Parsed<Name> {
        let is_named = cursor.ident().is_some() && can_follow_name(cursor);
        let is_end = cursor.ident().is_none() && cursor.at_statement_end();
        if !is_named && !is_end {
            let start = cursor.position();
            cursor.skip_to(|cursor| cursor.at(',') || cursor.at_statement_end());
            let origin = cursor.since(start);
            self.lacks_names = true;
            return Err(self.fail_with_help(origin, habits::nameless(keyword), form(keyword)));
        }
        if is_end {
            return Err(self.no_name(form(keyword), cursor));
        }
        let mut name = self.declared_name(cursor)?;
        self.annotation(&mut name, keyword, cursor);
        Ok(name)
    }

    /// Reads the unit between a declared name and its value. Content from other languages, such as
    /// a type or an argument, is reported and skipped.
    pub(super) fn annotation(&mut self, name: &mut Name, keyword: &str, cursor: &mut Cursor) {
        let start = cursor.position();
        let (message, help) = match cursor.peek() {
            Some(TokenTree::Punct(punct)) if punct.as_char() == ':' && cursor.pair().is_none() => {
                let is_equals = match keyword {
                    "param" | "coord" | "state" | "discrete" => false,
                    "constraint" | "event" => true,
                    _ => !value_follows(cursor),
                };
                if is_equals {
                    // The colon is used in place of the equals sign.
                    return;
                }
                if at_unit(cursor) {
                    name.unit = self.unit_behind_colon(cursor);
                    return;
                }
                let ends = |cursor: &Cursor| {
                    cursor.equals_past(0) || cursor.at(',') || cursor.at(';') || cursor.at_statement()
                };
                cursor.skip_to(ends);
                (habits::TYPED, messages::TYPE_HELP)
            }
            Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace => {
                cursor.skip_one();
                habits::behind_name(keyword)
            }
            _ => return,
        };
        self.fail_once(cursor.since(start), message, help);
    }

    /// Consumes the `=` after a declared name. A similar operator from other languages is reported
    /// and treated like it.
    pub(super) fn equals(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<()> {
        if cursor.eat_equals().is_some() {
            return Ok(());
        }
        let Some((pair, origin)) = cursor.pair() else {
            let message = messages::expected("`=`", cursor.peek());
            let help = if cursor.at_suffix() { messages::INDEX_LAST_HELP } else { help };
            let reported = self.fail_with_help(cursor.here(), message, help);
            return cursor.eat(':').map(|_| ()).ok_or(reported);
        };
        let help = if pair == "+=" { habits::ADDS_UP } else { help };
        let reported = self.fail_with_help(origin, messages::expected_instead("`=`", pair), help);
        if pair == "->" || !pair.ends_with('=') {
            return Err(reported);
        }
        cursor.skip_one();
        cursor.skip_one();
        Ok(())
    }
}

/// True if an `=` follows before the statement ends.
fn value_follows(cursor: &Cursor) -> bool {
    let sign = |token: &TokenTree| match token {
        TokenTree::Punct(punct) if "=;,".contains(punct.as_char()) => Some(punct.as_char()),
        _ => None,
    };
    cursor.rest().iter().find_map(sign) == Some('=')
}

/// True if the tokens after a word make it a declared name.
fn can_follow_name(cursor: &Cursor) -> bool {
    let is_annotated = || match cursor.peek_past(1) {
        Some(TokenTree::Group(_)) => at_equals_past(2, cursor),
        Some(TokenTree::Ident(_)) => false,
        next => next
            .is_none_or(|token| matches!(token, TokenTree::Punct(punct) if ":;".contains(punct.as_char()))),
    };
    at_equals_past(1, cursor) || is_annotated()
}

/// True at a dot and a name.
fn at_member(cursor: &Cursor) -> bool {
    cursor.at('.') && matches!(cursor.peek_past(1), Some(TokenTree::Ident(_)))
}
