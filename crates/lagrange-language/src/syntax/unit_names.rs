//! Names of units among other names.

use proc_macro2::TokenTree;

use super::cursor::Cursor;
use super::messages::units as words;
use super::parser::Parser;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::units::{meaning, meant};

/// Names of units that also have a meaning in expressions.
const BUILT_IN: [&str; 1] = ["t"];

impl Parser<'_> {
    /// True if a word is the name of a unit and not of anything declared.
    pub(super) fn is_free_unit(&self, word: &str) -> bool {
        let is_unit = meaning(word).is_some() || meant(word).is_some();
        is_unit && self.declared(word).is_none() && !BUILT_IN.contains(&word)
    }

    /// Returns the place of a unit with several factors after a number, and its spelling in
    /// brackets. Its factors may include names of the declaration: in `9.81 kg*m/s^2`, a parameter
    /// `m` would isolate the second.
    pub(super) fn several_factors(&self, cursor: &Cursor) -> Option<(Origin, String)> {
        let text = |from: usize, to: usize| {
            (from..to).filter_map(|at| cursor.peek_past(at)).map(ToString::to_string)
        };
        // Each factor ends at a token, and is free or not.
        let next = |&(end, _): &(usize, bool)| {
            let is_free = self.following_unit(cursor, end)?;
            Some((end + 1 + factor_length(cursor, end + 1)?, is_free))
        };
        let first = (factor_length(cursor, 0)?, false);
        let factors = std::iter::successors(Some(first), next);
        let (end, _) = factors.filter(|&(_, is_free)| is_free).last()?;
        let (number, unit) = (cursor.previous()?.to_string(), text(0, end).collect::<String>());
        let rest = match at_product(cursor, end) {
            true => text(end, end + 2).map(|token| format!(" {token}")).collect::<String>(),
            false => String::new(),
        };
        Some((cursor.reaching(end), words::in_brackets(&number, &unit, &rest)))
    }

    /// Returns true if the unit that follows the next tokens after `*` or `/` is not a name of the
    /// declaration, and `None` if no unit follows.
    fn following_unit(&self, cursor: &Cursor, count: usize) -> Option<bool> {
        let Some(TokenTree::Ident(word)) = cursor.peek_past(count + 1) else { return None };
        let word = word.to_string();
        let is_unit = at_product(cursor, count) && meaning(&word).is_some();
        is_unit.then(|| self.is_free_unit(&word))
    }
}

/// Returns the number of tokens of the unit and its exponent after the next ones.
fn factor_length(cursor: &Cursor, count: usize) -> Option<usize> {
    let is_here = |at: usize, character: char| matches!(cursor.peek_past(count + at), Some(TokenTree::Punct(punct)) if punct.as_char() == character);
    let exponent = if is_here(2, '-') { 3 } else { 2 };
    let is_number =
        matches!(cursor.peek_past(count + exponent), Some(TokenTree::Literal(_) | TokenTree::Group(_)));
    match cursor.peek_past(count)? {
        TokenTree::Ident(_) if is_here(1, '^') && is_number => Some(exponent + 1),
        TokenTree::Ident(_) => Some(1),
        _ => None,
    }
}

/// True if `*` or `/` and a word or a number follow the next tokens.
fn at_product(cursor: &Cursor, count: usize) -> bool {
    let is_sign =
        matches!(cursor.peek_past(count), Some(TokenTree::Punct(sign)) if "*/".contains(sign.as_char()));
    is_sign && matches!(cursor.peek_past(count + 1), Some(TokenTree::Ident(_) | TokenTree::Literal(_)))
}
