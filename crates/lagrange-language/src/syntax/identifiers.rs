//! Identifiers, and the rules for names.

use lagrange_expr::keywords::is_rust_keyword;
use proc_macro2::{Ident, TokenTree};

use super::ast::{Comparison, Name};
use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::messages::habits;
use super::parser::{Parsed, Parser, Reported};

impl Parser<'_> {
    /// Reads a name that is being declared. An invalid name is reported and omitted from the syntax
    /// tree. Every declared name in it is therefore a valid identifier of Rust and of the language.
    pub(super) fn free_name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        if cursor.ident().is_none() {
            return Err(self.no_name(habits::name_help(cursor.peek()), cursor));
        }
        let name = self.name(cursor)?;
        match objection(&name.text) {
            None => Ok(name),
            Some(message) => Err(self.fail_with_help(name.span, message, messages::OTHER_NAME_HELP)),
        }
    }

    /// Reports a declaration without a name. Its intended name may be used elsewhere.
    pub(super) fn no_name(&mut self, help: &str, cursor: &Cursor) -> Reported {
        self.lacks_names = true;
        let message = messages::expected("a name", cursor.peek());
        self.fail_with_help(cursor.here(), message, help)
    }

    /// Reads any identifier that is not raw.
    pub(super) fn name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        match cursor.eat_ident() {
            Some(ident) => self.plain(&ident),
            None => {
                let message = messages::expected("a name", cursor.peek());
                Err(self.fail_with_help(cursor.here(), message, habits::name_help(cursor.peek())))
            }
        }
    }

    /// Returns the name spelt by an identifier, if it is not raw.
    pub(super) fn plain(&mut self, ident: &Ident) -> Parsed<Name> {
        let (text, span) = (ident.to_string(), ident.span());
        match text.strip_prefix("r#") {
            None => Ok(Name::new(text, span)),
            Some(_) => Err(self.fail_with_help(span, messages::raw_name(&text), messages::OTHER_NAME_HELP)),
        }
    }
}

/// True if a declaration can introduce this identifier wherever names are allowed. Keywords,
/// functions and names with a predefined meaning cannot be declared. The same is true of words that
/// begin a statement, or continue one in some places.
pub fn can_be_declared(identifier: &str) -> bool {
    objection(identifier).is_none()
        && keywords::soft_statement(identifier).is_none()
        && !keywords::is_connective(identifier)
}

/// Explains why a declaration cannot introduce this name, if this is the case.
fn objection(name: &str) -> Option<String> {
    if keywords::begins_statement(name) {
        Some(messages::statement_keyword_as_name(name))
    } else if is_rust_keyword(name) {
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

/// True if an `=`, or a similar sign of other languages, follows the next `count` tokens.
pub(super) fn at_equals_past(count: usize, cursor: &Cursor) -> bool {
    let is = |ahead: usize, characters: &str| matches!(cursor.peek_past(ahead), Some(TokenTree::Punct(punct)) if characters.contains(punct.as_char()));
    let is_assignment = is(count, ":+") && is(count + 1, "=");
    cursor.equals_past(count) || is_assignment || is(count, "=") && is(count + 1, "=")
}

/// True if an equality or an inequality follows.
pub(super) fn at_relation(cursor: &Cursor) -> bool {
    cursor.at('=') || cursor.at('<') || cursor.at('>') || cursor.at_pair('!', '=')
}

/// Consumes a comparison, if there is one.
pub(super) fn eat_comparison(cursor: &mut Cursor) -> Option<Comparison> {
    let is_here = |sign: &str| match sign.as_bytes() {
        [first, second] => cursor.at_pair(char::from(*first), char::from(*second)),
        [only] => cursor.at(char::from(*only)),
        _ => false,
    };
    let (sign, comparison) = Comparison::ALL.into_iter().find(|(sign, _)| is_here(sign))?;
    for _ in sign.chars() {
        cursor.skip_one();
    }
    Some(comparison)
}
