//! Tokens that cannot stand where they do in an expression: what to call the mistake.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::parser::{Parser, Reported};

/// A message and, where there is something to do, a help.
type Mistake = (String, Option<&'static str>);

impl Parser<'_> {
    /// Reports the next token, which should begin an operand and does not.
    pub(super) fn no_operand(&mut self, cursor: &Cursor) -> Reported {
        let (message, help) = operand_mistake(cursor)
            .unwrap_or_else(|| (messages::expected(messages::OPERAND, cursor.peek()), operand_help(cursor)));
        self.mistake(cursor, message, help)
    }

    /// Reports the next token, which should continue the expression before it or be what is wanted there.
    pub(super) fn no_operator(&mut self, cursor: &Cursor, wanted: &str) -> Reported {
        let (message, help) = operator_mistake(cursor).unwrap_or_else(|| {
            (messages::expected_operator_or(wanted, cursor.peek()), operator_help(cursor))
        });
        self.mistake(cursor, message, help)
    }

    fn mistake(&mut self, cursor: &Cursor, message: String, help: Option<&str>) -> Reported {
        match help {
            Some(help) => self.fail_with_help(cursor.here(), message, help),
            None => self.fail(cursor.here(), message),
        }
    }
}

fn operand_mistake(cursor: &Cursor) -> Option<Mistake> {
    let (message, help) = match character(cursor)? {
        '+' => (messages::UNARY_PLUS, messages::UNARY_PLUS_HELP),
        '&' => (messages::REFERENCE, messages::REFERENCE_HELP),
        ':' if cursor.at_pair(':', ':') => (messages::PATH, messages::PATH_HELP),
        _ => return None,
    };
    Some((message.to_owned(), Some(help)))
}

fn operand_help(cursor: &Cursor) -> Option<&'static str> {
    match cursor.peek()? {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => Some(messages::VECTOR_HELP),
        TokenTree::Group(_) => Some(messages::PARENTHESES_HELP),
        TokenTree::Punct(punct) => match punct.as_char() {
            '|' => Some(messages::MAGNITUDE_HELP),
            '#' => Some(messages::COMMENT_HELP),
            '.' if matches!(cursor.peek_past(1), Some(TokenTree::Literal(_))) => {
                Some(messages::LEADING_ZERO_HELP)
            }
            _ => None,
        },
        _ => None,
    }
}

fn operator_mistake(cursor: &Cursor) -> Option<Mistake> {
    if cursor.at_word("as") {
        return Some((messages::CONVERSION.to_owned(), Some(messages::CONVERSION_HELP)));
    }
    if cursor.group(Delimiter::Bracket).is_some() {
        return Some((messages::INDEX.to_owned(), Some(messages::INDEX_HELP)));
    }
    let (message, help) = match character(cursor)? {
        ':' if cursor.at_pair(':', ':') => (messages::PATH, Some(messages::PATH_HELP)),
        '<' | '>' => (messages::COMPARISON_PLACE, Some(messages::COMPARISON_PLACE_HELP)),
        '=' if !cursor.equals_past(0) => (messages::COMPARISON_PLACE, Some(messages::COMPARISON_PLACE_HELP)),
        '!' if cursor.at_pair('!', '=') => {
            (messages::COMPARISON_PLACE, Some(messages::COMPARISON_PLACE_HELP))
        }
        '!' => (messages::MACRO, None),
        '%' => (messages::REMAINDER, None),
        _ => return None,
    };
    Some((message.to_owned(), help))
}

fn operator_help(cursor: &Cursor) -> Option<&'static str> {
    if let Some(TokenTree::Ident(word)) = cursor.previous()
        && keywords::is_function(&word.to_string())
    {
        return Some(messages::ARGUMENT_HELP);
    }
    match cursor.peek()? {
        TokenTree::Ident(_) | TokenTree::Literal(_) => Some(messages::PRODUCT_HELP),
        TokenTree::Group(group) if group.delimiter() != Delimiter::Brace => Some(messages::PRODUCT_HELP),
        TokenTree::Punct(punct) if punct.as_char() == '#' => Some(messages::COMMENT_HELP),
        TokenTree::Punct(punct) if punct.as_char() == ':' => Some(messages::TYPE_HELP),
        _ => None,
    }
}

fn character(cursor: &Cursor) -> Option<char> {
    match cursor.peek()? {
        TokenTree::Punct(punct) => Some(punct.as_char()),
        _ => None,
    }
}
