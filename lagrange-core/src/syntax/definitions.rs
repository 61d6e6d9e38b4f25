//! Statements that declare names or list products.

use proc_macro2::{Delimiter, Group, Span, TokenTree};

use super::ast::{AstId, Definition, EmitItem, Name, StatementKind};
use super::cursor::{Cursor, group_origin};
use super::keywords::is_rust_keyword;
use super::messages;
use super::parser::{Parsed, Parser, Reported};
use super::recovery::Turn;

impl Parser<'_> {
    /// `a, b = 1.0`.
    pub(super) fn definitions(&mut self, cursor: &mut Cursor) -> Vec<Definition> {
        self.items(cursor, |parser, cursor| {
            let name = parser.declared_name(cursor);
            let value = cursor.eat_equals().map(|_| parser.item_value(cursor));
            Ok(Definition { name: name?, value })
        })
    }

    /// `a = 1, b = 2`.
    pub(super) fn constants(&mut self, cursor: &mut Cursor) -> Vec<Definition> {
        let definitions = self.definitions(cursor);
        for Definition { name, .. } in definitions.iter().filter(|definition| definition.value.is_none()) {
            let message = messages::constant_without_value(&name.text);
            self.report.error(name.span, message).help(messages::CONSTANT_WITHOUT_VALUE_HELP);
        }
        definitions
    }

    /// `x, theta`. A word that cannot be a name counts all the same, so that vectors have the length that the
    /// user expects; where it cannot be a field either, a name stands for it that nobody can write.
    pub(super) fn coordinates(&mut self, cursor: &mut Cursor) -> Vec<Name> {
        self.items(cursor, |parser, cursor| {
            let start = cursor.position();
            let word = cursor.ident().filter(|word| can_be_field(&word.to_string())).cloned();
            let name = parser.declared_name(cursor).unwrap_or_else(|Reported| {
                parser.skip_item(cursor);
                parser.leave_out(cursor, start);
                match word {
                    Some(word) => Name { text: word.to_string(), span: word.span() },
                    None => Name { text: format!("__coordinate_{start}"), span: Span::call_site() },
                }
            });
            if let Some(equals) = cursor.eat_equals() {
                let help = messages::COORDINATE_WITH_VALUE_HELP;
                parser.report.error(equals, messages::COORDINATE_WITH_VALUE).help(help);
                parser.item_value(cursor);
            }
            Ok(name)
        })
    }

    /// Reads items between commas, with or without a comma behind the last one, up to what ends the
    /// statement. Those that cannot be read are left out.
    pub(super) fn items<T>(
        &mut self,
        cursor: &mut Cursor,
        mut read: impl FnMut(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Vec<T> {
        let mut items = Vec::new();
        let _ = self.turns(cursor, |parser, cursor| {
            parser.skipped = false;
            let start = cursor.position();
            match read(parser, cursor) {
                Ok(item) => items.push(item),
                Err(Reported) => {
                    parser.skip_item(cursor);
                    parser.leave_out(cursor, start);
                }
            }
            if !parser.skipped && !at_item_end(cursor) {
                parser.no_operator(cursor, "`,` or `;`");
                parser.skip_item(cursor);
            }
            Ok(Turn::next_if(cursor.eat(',').is_some() && !at_list_end(cursor)))
        });
        items
    }

    /// Reads an expression up to the next comma or the end of the statement.
    pub(super) fn item_value(&mut self, cursor: &mut Cursor) -> AstId {
        let start = cursor.position();
        match self.expression(cursor) {
            Ok(id) if at_item_end(cursor) => return id,
            Ok(_) => self.no_operator(cursor, "`,` or `;`"),
            Err(reported) => reported,
        };
        self.skip_item(cursor);
        self.unreadable(cursor, start)
    }

    /// `n = e` or `(a, b) = e`.
    pub(super) fn binding(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        match cursor.eat_group(Delimiter::Parenthesis) {
            None => Ok(StatementKind::Let(self.declared_name(cursor)?, self.assigned(cursor)?)),
            Some(group) => {
                let names = self.inside(&group, Self::component_names);
                let value = self.assigned(cursor)?;
                Ok(StatementKind::LetTuple(self.two_or_three(names?, &group)?, value))
            }
        }
    }

    fn component_names(&mut self, cursor: &mut Cursor) -> Parsed<Vec<Name>> {
        let mut names = Vec::new();
        self.turns(cursor, |parser, cursor| {
            names.push(parser.declared_name(cursor)?);
            Ok(Turn::next_if(cursor.eat(',').is_some() && !cursor.at_end()))
        })?;
        if cursor.at_end() {
            return Ok(names);
        }
        Err(self.fail(cursor.here(), messages::expected("`,` or `)`", cursor.peek())))
    }

    fn two_or_three(&mut self, names: Vec<Name>, group: &Group) -> Parsed<Vec<Name>> {
        match names.len() {
            2 | 3 => Ok(names),
            count => Err(self.fail(group_origin(group), messages::component_count(count))),
        }
    }

    /// `{ a, no b }`.
    pub(super) fn emit(&mut self, cursor: &mut Cursor) -> Parsed<Vec<EmitItem>> {
        let Some(group) = cursor.eat_group(Delimiter::Brace) else {
            let message = messages::expected("`{`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, messages::EMIT_HELP));
        };
        // A mistake between the braces leaves the end of the statement in place.
        Ok(self.inside(&group, Self::emit_items).unwrap_or_default())
    }

    fn emit_items(&mut self, cursor: &mut Cursor) -> Parsed<Vec<EmitItem>> {
        let mut items = Vec::new();
        self.turns(cursor, |parser, cursor| {
            items.extend(parser.emit_item(cursor)?);
            Ok(Turn::next_if(!cursor.at_end()))
        })?;
        Ok(items)
    }

    /// `a,` or `no b,`, the last one with or without a comma; `None` at the end.
    fn emit_item(&mut self, cursor: &mut Cursor) -> Parsed<Option<EmitItem>> {
        if cursor.at_end() {
            return Ok(None);
        }
        // Without a name behind it, `no` is the name.
        let wanted =
            !matches!(cursor.peek_past(1), Some(TokenTree::Ident(_))) || cursor.eat_word("no").is_none();
        let item = EmitItem { product: self.name(cursor)?, wanted };
        if cursor.eat(',').is_none() && !cursor.at_end() {
            let message = messages::expected("`,` or `}`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, messages::EMIT_HELP));
        }
        Ok(Some(item))
    }
}

/// Whether an item ends here, be it that the semicolon behind it was forgotten.
fn at_item_end(cursor: &Cursor) -> bool {
    cursor.at(',') || cursor.at_statement_end()
}

/// Whether no item follows a comma. A keyword before `=` is an item with a wrong name.
fn at_list_end(cursor: &Cursor) -> bool {
    cursor.at(';') || cursor.at_end() || (cursor.at_statement() && !cursor.equals_past(1))
}

/// Whether Rust accepts the word as the name of a field, whatever the language makes of it.
fn can_be_field(word: &str) -> bool {
    word != "_" && !word.starts_with("r#") && !is_rust_keyword(word)
}
