//! A position in a sequence of tokens.
//!
//! Square brackets after a word that can be a name belong to the word instead of being tokens.
//! Lookahead is therefore the same for `q = …` and `q[i] = …`.

mod boundaries;
mod brackets;

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser as _};

use super::keywords;
use brackets::SquareBrackets;
use lagrange_expr::diagnostics::Origin;

/// Operators of two characters, of this language and of others.
const PAIRS: [&str; 17] =
    [":=", "==", "+=", "-=", "*=", "/=", "^=", "->", "=>", "<-", "!=", "<=", ">=", "&&", "||", "**", "::"];

/// Maximum number of tokens of type parameters and their bounds; longer lists are rejected.
const MAX_TOKENS_OF_RUST: usize = 32;

/// A cursor over the tokens of one bracket group, or of the whole input. Inner groups count as one
/// token each and have separate cursors, so every token is copied only once.
pub(super) struct Cursor {
    tokens: Vec<TokenTree>,
    next: usize,
    /// Square brackets that belong to words.
    brackets: SquareBrackets,
    /// Place after the last token: the closing bracket, or the last token itself.
    end: Span,
}

impl Cursor {
    /// Creates a cursor at the start of the whole input.
    pub(super) fn new(tokens: TokenStream) -> Cursor {
        let mut cursor = Cursor::over(tokens, Span::call_site());
        if let Some(last) = cursor.tokens.len().checked_sub(1) {
            cursor.end = cursor.origin(last).end;
        }
        cursor
    }

    /// Creates a cursor after the opening bracket of a group.
    pub(super) fn inside(group: &Group) -> Cursor {
        Cursor::over(group.stream(), group.span_close())
    }

    fn over(stream: TokenStream, end: Span) -> Cursor {
        let (tokens, brackets) = SquareBrackets::taken_out(stream);
        Cursor { tokens, next: 0, brackets, end }
    }

    /// Returns the place of the token with this index, including its square brackets.
    fn origin(&self, number: usize) -> Origin {
        let word = self.tokens.get(number).map_or(Origin::from(self.end), origin);
        self.brackets.last(number).map_or(word, |last| word.to(group_origin(last)))
    }

    /// Returns the square brackets after the last token, and marks them as read.
    pub(super) fn read_brackets(&mut self) -> Vec<Group> {
        self.next.checked_sub(1).map_or_else(Vec::new, |last| self.brackets.read(last))
    }

    /// Returns the first unread square brackets among the consumed tokens, and marks all of them as
    /// read.
    pub(super) fn forget_brackets(&mut self) -> Option<Group> {
        self.brackets.forget(self.next)
    }

    /// Returns the next token.
    pub(super) fn peek(&self) -> Option<&TokenTree> {
        self.peek_past(0)
    }

    /// Returns the token after the next `count` ones.
    pub(super) fn peek_past(&self, count: usize) -> Option<&TokenTree> {
        self.tokens.get(self.next + count)
    }

    /// Returns all remaining tokens without consuming them.
    pub(super) fn rest(&self) -> &[TokenTree] {
        self.tokens.get(self.next..).unwrap_or_default()
    }

    /// Returns the remaining tokens before the next semicolon.
    pub(super) fn rest_of_statement(&self) -> &[TokenTree] {
        self.rest().split(|token| is_punct(Some(token), ';')).next().unwrap_or_default()
    }

    /// Returns the last consumed token.
    pub(super) fn previous(&self) -> Option<&TokenTree> {
        self.tokens.get(self.next.checked_sub(1)?)
    }

    /// True if no token is left.
    pub(super) fn at_end(&self) -> bool {
        self.next == self.tokens.len()
    }

    /// Returns the place of the next token, or of the end.
    pub(super) fn here(&self) -> Origin {
        self.origin(self.next)
    }

    /// Returns the place of the last consumed token; at the start, the same as [`Cursor::here`].
    pub(super) fn before(&self) -> Origin {
        match self.next.checked_sub(1) {
            Some(last) => self.origin(last),
            None => self.here(),
        }
    }

    /// Returns the place of the next `count` tokens.
    pub(super) fn reaching(&self, count: usize) -> Origin {
        self.here().to(self.origin(self.next + count.saturating_sub(1)))
    }

    /// Returns the number of consumed tokens; see [`Cursor::since`].
    pub(super) fn position(&self) -> usize {
        self.next
    }

    /// Returns the place of the tokens consumed since a position; if there are none, the same as
    /// [`Cursor::here`].
    pub(super) fn since(&self, position: usize) -> Origin {
        if position < self.next { self.origin(position).to(self.before()) } else { self.here() }
    }

    /// Returns the tokens consumed since a position.
    pub(super) fn taken_since(&self, position: usize) -> &[TokenTree] {
        self.tokens.get(position..self.next).unwrap_or_default()
    }

    /// True if the next token is this punctuation character.
    pub(super) fn at(&self, punctuation: char) -> bool {
        is_punct(self.peek(), punctuation)
    }

    /// True if the next tokens are these two characters without a space between them.
    pub(super) fn at_pair(&self, first: char, second: char) -> bool {
        is_joint(self.peek(), first) && is_punct(self.peek_past(1), second)
    }

    /// Returns the two-character operator at the cursor, and its place.
    pub(super) fn pair(&self) -> Option<(&'static str, Origin)> {
        let is_here = |pair: &&str| {
            let mut characters = pair.chars();
            characters
                .next()
                .zip(characters.next())
                .is_some_and(|(first, second)| self.at_pair(first, second))
        };
        let pair = PAIRS.into_iter().find(is_here)?;
        let end = self.peek_past(1).map_or(self.here(), origin);
        Some((pair, self.here().to(end)))
    }

    /// Returns the place of the next token, including the following one if both form an operator.
    pub(super) fn here_to_pair(&self) -> Origin {
        self.pair().map_or(self.here(), |(_, origin)| origin)
    }

    /// Consumes what a parser of Rust reads; nothing if it fails. The parser only receives few
    /// tokens, since it may be recursive.
    pub(super) fn read<T>(&mut self, read: impl Fn(ParseStream) -> syn::Result<T>) -> syn::Result<T> {
        let mut left = MAX_TOKENS_OF_RUST;
        let is_seen = |token: &&TokenTree| {
            left = left.saturating_sub(token_count(token));
            left > 0 && !is_punct(Some(token), ';')
        };
        let seen = self.rest().iter().take_while(is_seen).cloned().collect::<Vec<_>>();
        let count = seen.len();
        let parser = |input: ParseStream| Ok((read(input)?, input.parse::<TokenStream>()?));
        let (result, rest) = parser.parse2(seen.into_iter().collect())?;
        self.next += count.saturating_sub(rest.into_iter().count());
        Ok(result)
    }

    /// Skips the rest of the line of the last token.
    pub(super) fn skip_line_of_text(&mut self) {
        let line = self.before().start.start().line;
        self.skip_to(|cursor| cursor.here().start.start().line != line);
    }

    /// Detects a decimal comma: the token at this offset is a comma between the digits of two
    /// numbers. Returns their place, and the spelling of the number.
    pub(super) fn decimal_comma(&self, ahead: isize) -> Option<(Origin, String)> {
        let at = self.next.checked_add_signed(ahead)?;
        let (before, behind) = (self.tokens.get(at.checked_sub(1)?)?, self.tokens.get(at + 1)?);
        let comma = self.tokens.get(at);
        // The items of a list are separated by a space.
        let is_adjacent = comma.is_some_and(|comma| comma.span().end() == behind.span().start());
        let is_comma = is_punct(comma, ',') && is_adjacent;
        let (whole, fraction) = (digits(before)?, digits(behind)?);
        is_comma.then(|| (origin(before).to(origin(behind)), format!("{whole}.{fraction}")))
    }

    /// Consumes the next token if it is this punctuation character.
    pub(super) fn eat(&mut self, punctuation: char) -> Option<Span> {
        let found = self.at(punctuation);
        found.then(|| self.skip_one().end)
    }

    /// Consumes a sequence of this punctuation character; returns their places.
    pub(super) fn eat_all(&mut self, punctuation: char) -> impl Iterator<Item = Span> {
        std::iter::from_fn(move || self.eat(punctuation))
    }

    /// Consumes an `=` that is not the beginning of `==` or `=>`.
    pub(super) fn eat_equals(&mut self) -> Option<Span> {
        let found = self.equals_past(0);
        found.then(|| self.skip_one().end)
    }

    /// True if the next `count` tokens are followed by an `=` that is not the beginning of `==` or
    /// `=>`.
    pub(super) fn equals_past(&self, count: usize) -> bool {
        let follower = self.peek_past(count + 1);
        let joint = is_joint(self.peek_past(count), '=');
        let longer = joint && (is_punct(follower, '=') || is_punct(follower, '>'));
        is_punct(self.peek_past(count), '=') && !longer
    }

    /// Returns the next token, if it is an identifier.
    pub(super) fn ident(&self) -> Option<&Ident> {
        match self.peek() {
            Some(TokenTree::Ident(ident)) => Some(ident),
            _ => None,
        }
    }

    /// True if the next token is the same word as the last consumed one.
    pub(super) fn at_same_word(&self) -> bool {
        let last = self.previous().map(ToString::to_string);
        self.ident().is_some_and(|word| last.as_deref() == Some(word.to_string().as_str()))
    }

    /// True if the next token ends a name whose index is before its end, as in `case[i]_z`.
    pub(super) fn at_suffix(&self) -> bool {
        let brackets = self.next.checked_sub(1).and_then(|last| self.brackets.last(last));
        brackets.is_some() && self.ident().is_some_and(|word| word.to_string().starts_with('_'))
    }

    /// Consumes the next token if it is an identifier.
    pub(super) fn eat_ident(&mut self) -> Option<Ident> {
        let ident = self.ident().cloned()?;
        self.next += 1;
        Some(ident)
    }

    /// True if the next token is this word.
    pub(super) fn at_word(&self, word: &str) -> bool {
        self.ident().is_some_and(|ident| ident == word)
    }

    /// Consumes the next token if it is this word.
    pub(super) fn eat_word(&mut self, word: &str) -> Option<Span> {
        let found = self.at_word(word);
        found.then(|| self.skip_one().end)
    }

    /// Returns the next token, if it is a group in these brackets.
    pub(super) fn group(&self, delimiter: Delimiter) -> Option<&Group> {
        as_group(self.peek(), delimiter)
    }

    /// Consumes the next token if it is a group in these brackets.
    pub(super) fn eat_group(&mut self, delimiter: Delimiter) -> Option<Group> {
        let group = self.group(delimiter).cloned()?;
        self.next += 1;
        Some(group)
    }

    /// Consumes the next token and returns its place.
    pub(super) fn skip_one(&mut self) -> Origin {
        let origin = self.here();
        self.next = (self.next + 1).min(self.tokens.len());
        origin
    }

    /// Skips to the first place that fits, or to the end.
    pub(super) fn skip_to(&mut self, fits: impl Fn(&Cursor) -> bool) {
        while !self.at_end() && !fits(self) {
            self.next += 1;
        }
        // Skipped tokens have been reported.
        self.forget_brackets();
    }
}

/// Returns the number of tokens in a token tree, which is one except for a group.
fn token_count(token: &TokenTree) -> usize {
    let (mut pending, mut count) = (vec![token.clone()], 0);
    while let Some(token) = pending.pop() {
        count += 1;
        if let TokenTree::Group(group) = token {
            pending.extend(group.stream());
        }
    }
    count
}

/// Returns the place of a token; for a group, from bracket to bracket.
fn origin(token: &TokenTree) -> Origin {
    match token {
        TokenTree::Group(group) => group_origin(group),
        other => Origin::from(other.span()),
    }
}

/// Returns the place of a group, from bracket to bracket.
pub(super) fn group_origin(group: &Group) -> Origin {
    Origin { start: group.span_open(), end: group.span_close() }
}

/// Returns the token, if it is a group in these brackets.
pub(super) fn as_group(token: Option<&TokenTree>, delimiter: Delimiter) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
        _ => None,
    }
}

/// Returns a number that consists of only digits.
fn digits(token: &TokenTree) -> Option<String> {
    let TokenTree::Literal(literal) = token else { return None };
    let text = literal.to_string();
    text.bytes().all(|byte| byte.is_ascii_digit()).then_some(text)
}

fn as_punct(token: Option<&TokenTree>) -> Option<&Punct> {
    match token {
        Some(TokenTree::Punct(punct)) => Some(punct),
        _ => None,
    }
}

fn is_punct(token: Option<&TokenTree>, character: char) -> bool {
    as_punct(token).is_some_and(|punct| punct.as_char() == character)
}

fn is_joint(token: Option<&TokenTree>, character: char) -> bool {
    as_punct(token).is_some_and(|punct| punct.as_char() == character && punct.spacing() == Spacing::Joint)
}
