//! Names that a declaration introduces.

use proc_macro2::{Delimiter, Ident, TokenTree};

use super::ast::Name;
use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::messages::forms::form;
use super::messages::habits;
use super::parser::{Parsed, Parser, Reported};

impl Parser<'_> {
    /// Reads a name that is being declared. One that cannot be a name is reported and left out of the
    /// syntax tree, so every declared name there is an identifier of Rust and of the language.
    pub(super) fn declared_name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        if cursor.ident().is_none() {
            return Err(self.no_name(habits::name_help(cursor.peek()), cursor));
        }
        let name = self.name(cursor)?;
        match objection(&name.text) {
            None => Ok(name),
            Some(message) => Err(self.fail_with_help(name.span, message, messages::OTHER_NAME_HELP)),
        }
    }

    /// Reads the name that a statement declares in front of its `=`.
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
        let name = self.declared_name(cursor)?;
        self.annotation(keyword, cursor);
        Ok(name)
    }

    /// Reports what stands elsewhere between a declared name and its value, a type, a unit or an argument, and skips it.
    pub(super) fn annotation(&mut self, keyword: &str, cursor: &mut Cursor) {
        let start = cursor.position();
        let (message, help) = match cursor.peek() {
            Some(TokenTree::Punct(punct)) if punct.as_char() == ':' && cursor.pair().is_none() => {
                let is_equals = match keyword {
                    "param" | "coord" => false,
                    "constraint" | "event" => true,
                    _ => !value_follows(cursor),
                };
                if is_equals {
                    // The colon stands for the equals sign.
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

    /// Takes the `=` behind what is declared. An operator that is like it elsewhere is reported and taken for it.
    pub(super) fn equals(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<()> {
        if cursor.eat_equals().is_some() {
            return Ok(());
        }
        let Some((pair, origin)) = cursor.pair() else {
            let message = messages::expected("`=`", cursor.peek());
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

    /// Reports that what is declared here has no name. It may be mentioned under the name that it was to have.
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

    /// The name that an identifier spells, if it is not raw.
    pub(super) fn plain(&mut self, ident: &Ident) -> Parsed<Name> {
        let (text, span) = (ident.to_string(), ident.span());
        match text.strip_prefix("r#") {
            None => Ok(Name { text, span }),
            Some(_) => Err(self.fail_with_help(span, messages::raw_name(&text), messages::OTHER_NAME_HELP)),
        }
    }
}

/// Whether a declaration can introduce this identifier wherever names stand. Keywords, functions and names with a meaning of their own it
/// cannot, nor words that begin a statement or go on with one in some places only.
pub fn can_be_declared(identifier: &str) -> bool {
    objection(identifier).is_none()
        && keywords::soft_statement(identifier).is_none()
        && !keywords::is_connective(identifier)
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

/// True if an `=` follows before the statement ends.
fn value_follows(cursor: &Cursor) -> bool {
    let sign = |token: &TokenTree| match token {
        TokenTree::Punct(punct) if "=;,".contains(punct.as_char()) => Some(punct.as_char()),
        _ => None,
    };
    cursor.rest().iter().find_map(sign) == Some('=')
}

/// True if what stands behind a word is such that the word is a name that is declared.
fn can_follow_name(cursor: &Cursor) -> bool {
    let is_annotated = || match cursor.peek_past(1) {
        Some(TokenTree::Group(_)) => at_equals_past(2, cursor),
        Some(TokenTree::Ident(_)) => false,
        next => next
            .is_none_or(|token| matches!(token, TokenTree::Punct(punct) if ":;".contains(punct.as_char()))),
    };
    at_equals_past(1, cursor) || is_annotated()
}

/// True if an `=`, or what is like it elsewhere, stands behind the next `count` tokens.
pub(super) fn at_equals_past(count: usize, cursor: &Cursor) -> bool {
    let is = |ahead: usize, characters: &str| matches!(cursor.peek_past(ahead), Some(TokenTree::Punct(punct)) if characters.contains(punct.as_char()));
    let is_assignment = is(count, ":+") && is(count + 1, "=");
    cursor.equals_past(count) || is_assignment || is(count, "=") && is(count + 1, "=")
}

/// True if an equality or an inequality follows.
pub(super) fn at_relation(cursor: &Cursor) -> bool {
    cursor.at('=') || cursor.at('<') || cursor.at('>') || cursor.at_pair('!', '=')
}
