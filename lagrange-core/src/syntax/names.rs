//! Names that a declaration introduces.

use proc_macro2::Ident;

use super::ast::Name;
use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::parser::{Parsed, Parser};

impl Parser<'_> {
    /// Reads a name that is being declared. One that cannot be a name is reported and left out of the
    /// syntax tree, so every declared name there is an identifier of Rust and of the language.
    pub(super) fn declared_name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        let name = self.name(cursor)?;
        match objection(&name.text) {
            None => Ok(name),
            Some(message) => Err(self.fail_with_help(name.span, message, messages::OTHER_NAME_HELP)),
        }
    }

    /// Reads any identifier that is not raw.
    pub(super) fn name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        match cursor.eat_ident() {
            Some(ident) => self.plain(&ident),
            None => Err(self.fail(cursor.here(), messages::expected("a name", cursor.peek()))),
        }
    }

    /// The name that an identifier spells, if it is not raw.
    pub(super) fn plain(&mut self, ident: &Ident) -> Parsed<Name> {
        let (text, span) = (ident.to_string(), ident.span());
        match text.strip_prefix("r#") {
            None => Ok(Name { text, span }),
            Some(_) => Err(self.fail_with_help(span, messages::raw_name(&text), messages::OTHER_NAME_HELP)),
        }
    }
}

/// Why a declaration cannot introduce this name, if it cannot.
fn objection(name: &str) -> Option<String> {
    if keywords::begins_statement(name) {
        Some(messages::statement_keyword_as_name(name))
    } else if keywords::is_rust_keyword(name) {
        Some(messages::rust_keyword_as_name(name))
    } else if keywords::is_function(name) {
        Some(messages::function_as_name(name))
    } else if let Some(meaning) = keywords::built_in(name) {
        Some(messages::built_in_as_name(name, meaning))
    } else if name == "_" {
        Some(messages::UNDERSCORE_AS_NAME.to_owned())
    } else if name.starts_with("__") {
        Some(messages::reserved_name(name))
    } else {
        None
    }
}
