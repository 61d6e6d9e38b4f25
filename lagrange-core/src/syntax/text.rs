//! Declarations in strings.

use proc_macro2::{LexError, TokenStream};

use super::messages;
use crate::diagnostics::Report;

/// Splits a text into tokens; what is no token is reported.
pub(super) fn tokens(text: &str, report: &mut Report) -> Option<TokenStream> {
    match text.parse::<TokenStream>() {
        Ok(tokens) => Some(tokens),
        Err(error) => {
            report.error(error.span(), complaint(text, &error));
            None
        }
    }
}

fn complaint(text: &str, error: &LexError) -> String {
    let culprit = text.get(error.span().byte_range().start..).and_then(|rest| rest.chars().next());
    match culprit {
        None => messages::UNREADABLE_END.to_owned(),
        Some(bracket @ ('(' | '[' | '{' | ')' | ']' | '}')) => messages::unbalanced(bracket),
        Some('"' | '\'') => messages::UNCLOSED_QUOTE.to_owned(),
        Some(other) => messages::meaningless_character(other),
    }
}
