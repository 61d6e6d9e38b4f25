//! The beginnings and ends of statements.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use super::{Cursor, as_group, is_punct, keywords};
use crate::syntax::ast::Soft;

/// Ways of computing contacts: what follows `contacts:`.
pub(in crate::syntax) const WAYS: [&str; 3] = ["rigid", "compliant", "stepped"];

/// True at a word, a colon and a way of computing contacts, or another word without braces. With
/// braces, it is the name of a part.
fn at_way(cursor: &Cursor) -> bool {
    let Some(TokenTree::Ident(way)) = cursor.peek_past(2) else { return false };
    let is_part = as_group(cursor.peek_past(3), Delimiter::Brace).is_some();
    is_punct(cursor.peek_past(1), ':') && (!is_part || WAYS.contains(&way.to_string().as_str()))
}

impl Cursor {
    /// Returns the keyword that begins a statement here, if the next token is one.
    pub(in crate::syntax) fn statement_keyword(&self) -> Option<String> {
        let begins = |word: &String| match keywords::soft_statement(word) {
            Some(form) => self.at_soft_statement(form),
            None => keywords::begins_statement(word),
        };
        self.ident().map(Ident::to_string).filter(begins)
    }

    /// True if the tokens after the next one make it the beginning of a statement.
    fn at_soft_statement(&self, form: Soft) -> bool {
        let name = match self.peek_past(1) {
            Some(TokenTree::Ident(name)) => Some(name.to_string()),
            _ => None,
        };
        match form {
            Soft::Definition => name.is_some() && self.equals_past(2),
            Soft::Assignment => match as_group(self.peek_past(2), Delimiter::Parenthesis) {
                Some(_) => name.is_some_and(|name| name == "dot") && self.equals_past(3),
                None => name.is_some() && self.equals_past(2),
            },
            Soft::Braces if name.is_some() => as_group(self.peek_past(2), Delimiter::Brace).is_some(),
            Soft::Braces => as_group(self.peek_past(1), Delimiter::Brace).is_some_and(is_labelled),
            Soft::Joint => name.is_some_and(|name| !keywords::is_connective(&name)),
            Soft::Loop => {
                name.is_some() && matches!(self.peek_past(2), Some(TokenTree::Ident(word)) if word == "in")
            }
            Soft::List => name.is_some_and(|name| !keywords::is_connective(&name)) && self.goes_on_as_list(2),
            Soft::Equation => name.is_some() && is_punct(self.peek_past(2), ':'),
            Soft::Alone => name.is_some() && is_punct(self.peek_past(2), ';'),
            Soft::Function => name.is_some() && as_group(self.peek_past(2), Delimiter::Parenthesis).is_some(),
            Soft::Part => {
                let braces = 2 + usize::from(as_group(self.peek_past(2), Delimiter::Parenthesis).is_some());
                name.is_some() && as_group(self.peek_past(braces), Delimiter::Brace).is_some()
            }
            Soft::Way => at_way(self),
            Soft::Path => {
                let next = self.peek_past(1).map(ToString::to_string);
                next.is_some_and(|next| next.starts_with('"'))
            }
            Soft::Coordinates => {
                let is_list = as_group(self.peek_past(1), Delimiter::Parenthesis).is_some();
                (name.is_some() || is_list) && self.equals_past(2)
            }
        }
    }

    /// True if the token after this many may follow a name in a list: a comma, the end, a number of
    /// elements, a colon.
    fn goes_on_as_list(&self, count: usize) -> bool {
        match self.peek_past(count) {
            None => true,
            Some(TokenTree::Punct(punct)) => ",;:=".contains(punct.as_char()),
            next => as_group(next, Delimiter::Bracket).is_some(),
        }
    }

    /// True if a statement begins here, judging by its keyword and the following token.
    pub(in crate::syntax) fn at_statement(&self) -> bool {
        let follows = match self.peek_past(1) {
            Some(TokenTree::Ident(_) | TokenTree::Group(_)) => true,
            _ => self.equals_past(1),
        };
        follows && self.statement_keyword().is_some()
    }

    /// True if a statement ends here, even if its semicolon is missing.
    pub(in crate::syntax) fn at_statement_end(&self) -> bool {
        self.at(';') || self.at_end() || self.statement_keyword().is_some()
    }

    /// Skips to the end of the current statement: its `;`, the next statement or the last token.
    pub(in crate::syntax) fn skip_statement(&mut self) {
        self.skip_to(|cursor| cursor.at(';') || cursor.at_statement());
    }

    /// Skips to the end of the head of a declaration.
    pub(in crate::syntax) fn skip_head(&mut self) {
        self.skip_to(|cursor| {
            cursor.at(';') || cursor.group(Delimiter::Brace).is_some() || cursor.at_statement()
        });
    }

    /// Skips to the next `,`, but not beyond the current statement.
    pub(in crate::syntax) fn skip_item(&mut self) {
        self.skip_to(|cursor| cursor.at(',') || cursor.at(';') || cursor.at_statement());
    }
}

/// True if a group begins with a word and a colon, unlike any block of an `if`.
fn is_labelled(group: &Group) -> bool {
    let mut tokens = group.stream().into_iter();
    matches!(tokens.next(), Some(TokenTree::Ident(_))) && is_punct(tokens.next().as_ref(), ':')
}
