//! Declarations in strings.

use proc_macro2::TokenStream;

use super::ast::Name;
use super::messages;
use lagrange_expr::diagnostics::Report;

/// Splits a text into tokens; invalid characters are reported.
pub(super) fn tokens(text: &str, report: &mut Report) -> Option<TokenStream> {
    match text.parse::<TokenStream>() {
        Ok(tokens) => Some(tokens),
        Err(error) => {
            let culprit = text.get(error.span().byte_range().start..).and_then(|rest| rest.chars().next());
            let help = culprit.map_or(messages::UNREADABLE_END_HELP, character_help);
            report.error(error.span(), complaint(culprit)).help(help);
            None
        }
    }
}

/// Reports invalid characters in a file at the place where the file is named.
pub(super) fn report_at(path: &Name, text: &str, mistakes: &Report, report: &mut Report) {
    for mistake in mistakes.diagnostics() {
        let before = text.get(..mistake.origin.start.byte_range().start).unwrap_or(text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().map_or(0, |last| last.chars().count()) + 1;
        let message = format!("{}:{line}:{column}: {}", path.text, mistake.message);
        report.error(path.span, message).help(mistake.help.clone().unwrap_or_default());
    }
}

fn complaint(culprit: Option<char>) -> String {
    match culprit {
        None => messages::UNREADABLE_END.to_owned(),
        Some(bracket @ ('(' | '[' | '{' | ')' | ']' | '}')) => messages::unbalanced(bracket),
        Some('"' | '\'') => messages::UNCLOSED_QUOTE.to_owned(),
        Some(other) => messages::meaningless_character(other),
    }
}

/// Returns the spelling that replaces a character.
fn character_help(culprit: char) -> &'static str {
    match culprit {
        '(' | '[' | '{' => "close it where it should end",
        ')' | ']' | '}' => "remove it, or open it where it should begin",
        '\'' | '’' | '′' => {
            "the rate of `x` is `dot(x)`, not x′; the transpose of a matrix `A` is `transpose(A)`"
        }
        '"' | '“' | '”' => "remove the quotation marks",
        '·' | '×' | '⋅' | '∙' | '•' => "write `*` for products",
        '÷' | '∕' => "write `/` for quotients",
        '−' | '–' | '—' => "write `-` for the minus sign",
        '²' => "write `^2`",
        '³' => "write `^3`",
        '√' => "write `sqrt(x)`",
        '½' => "write `1/2`",
        '¼' => "write `1/4`",
        '°' => "write `30 deg` for an angle and `20 degC` for a temperature",
        '∂' | '∇' => {
            "derivatives with respect to coordinates are computed automatically; `dot(x)` is the rate of x"
        }
        '∫' | '∑' => "write a sum as `sum(i in 0..n, e)`; there are no integrals",
        '≤' => "write `<=`",
        '≥' => "write `>=`",
        '≠' | '≈' => "compare with `<`, `<=`, `>` or `>=`",
        '\\' => "write names without a backslash, fractions as `a/b`, and `dot(x)` for a dot",
        _ => "remove it",
    }
}
