//! Parsing of declarations as written by the user: from tokens to the syntax tree.
//!
//! Parses notation without its meaning: names are not resolved, functions not looked up, vectors
//! not distinguished from numbers. Parsing continues after an error, at the next comma or
//! semicolon, so that all errors in a declaration are found at once.
//!
//! ```text
//! declaration = attribute* visibility "struct" NAME [ "<" NAME ">" ] ";" statement*
//! sum         = product { ( "+" | "-" ) product }
//! product     = signed { ( "*" | "/" | "%" ) signed }
//! signed      = { "-" } power
//! power       = operand [ "^" signed ]
//! operand     = atom { "." NAME [ "(" [ sum { "," sum } ] ")" ] }
//! atom        = NUMBER [ NAME [ "^" exponent ] | "[" unit "]" ] | NAME [ "(" [ sum { "," sum } ] ")" ] | NAME { "[" sum "]" } | "(" sum ")"
//!             | "sum" "(" NAME "in" sum ".." [ "=" ] sum "," sum [ "," ] ")"
//!             | "(" sum "," sum [ "," sum ] ")"
//!             | "if" sum ( "<" | "<=" | ">" | ">=" ) sum "{" sum "}" "else" ( "{" sum "}" | if )
//! unit        = factor { ( "*" | "/" ) factor }
//! factor      = ( NAME | "1" | "(" unit ")" ) [ "^" exponent ]
//! exponent    = [ "-" ] NUMBER | "(" [ "-" ] NUMBER [ "/" NUMBER ] ")"
//! ```
//!
//! `%` is only valid in indices. Statements are documented at
//! [`StatementKind`](ast::StatementKind).

pub mod ast;
mod attributes;
mod blocks;
mod bodies;
mod connectors;
mod contacts;
mod cursor;
mod definitions;
mod events;
mod expressions;
pub mod foreign;
mod friction;
mod functions;
mod habits;
mod header;
mod identifiers;
mod joints;
mod keywords;
mod lists;
mod literals;
mod messages;
mod mobilizers;
mod names;
mod noise;
mod options;
mod parser;
mod parts;
pub mod print;
mod ranges;
mod recovery;
mod reductions;
mod solve;
mod statements;
mod tables;
#[cfg(test)]
mod tests;
mod text;
mod unexpected;
mod unit_names;
mod units;
mod values;

use proc_macro2::TokenStream;

use ast::{Declaration, Name, Statement, declared_bodies};
use cursor::Cursor;
use header::{default_header, file_ahead, header_ahead};
pub use identifiers::can_be_declared;
pub use keywords::{NAMEABLE_FUNCTIONS, STRUCTURAL_FUNCTIONS, is_function};
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_expr::units::Unit;
use parser::Parser;

/// Reads the input of `system!`.
///
/// The result contains everything readable, regardless of errors elsewhere. It is `None` only if
/// neither a struct nor the file of a whole declaration is named, which is an error in the report.
pub fn parse_tokens(tokens: TokenStream, report: &mut Report) -> Option<Declaration> {
    declaration(tokens, file_ahead, report)
}

/// Reads a declaration from a string.
///
/// The text may also be a bare list of statements. The system is then public, has no attributes,
/// computes in `f64` and is named `System`. Text that is not a sequence of tokens, for example with
/// an unclosed bracket, gives an error and `None`.
pub fn parse_text(text: &str, report: &mut Report) -> Option<Declaration> {
    declaration(text::tokens(text, report)?, lacks_header, report)
}

fn lacks_header(cursor: &Cursor) -> bool {
    !header_ahead(cursor)
}

/// Reads a declaration from tokens. The header may be missing where the function returns true.
fn declaration(
    tokens: TokenStream,
    may_lack_header: fn(&Cursor) -> bool,
    report: &mut Report,
) -> Option<Declaration> {
    let cursor = &mut Cursor::new(tokens);
    let parser = &mut Parser::new(report);
    let header = if may_lack_header(cursor) { default_header() } else { parser.header(cursor).ok()? };
    Some(with_statements(header, parser, cursor))
}

/// Reads a unit, such as `kg*m^2/s`; `None` if the text is not a unit.
pub fn parse_unit(text: &str) -> Option<Unit> {
    let report = &mut Report::default();
    let cursor = &mut Cursor::new(text::tokens(text, report)?);
    Parser::new(report).unit(cursor).ok().map(|unit| *unit)
}

/// Reads the statements of a file that a declaration includes. Their expressions are added to those
/// of the declaration. Also returns the name of the file in the spans of its tokens, if these have
/// locations.
pub fn parse_included(
    (path, text): (&Name, &str),
    declaration: &mut Declaration,
    report: &mut Report,
) -> (Vec<Statement>, Option<String>) {
    let Some((tokens, file)) = file_tokens((path, text), report) else { return (Vec::new(), None) };
    let parser = &mut Parser::new(report);
    parser.expressions = std::mem::take(&mut declaration.expressions);
    parser.unreadable_words = std::mem::take(&mut declaration.unreadable_words);
    let statements = parser.statements(&mut Cursor::new(tokens));
    declaration.expressions = std::mem::take(&mut parser.expressions);
    declaration.expressions.end_of_text();
    declaration.unreadable_words = std::mem::take(&mut parser.unreadable_words);
    declaration.lacks_names |= parser.lacks_names;
    declaration.has_units |= parser.has_units;
    declaration.has_dimensions |= parser.has_dimensions;
    (statements, file)
}

/// Reads a file that contains a whole declaration, as [`parse_text`] does. Also returns the name of
/// the file in the spans of its tokens, if these have locations.
pub fn parse_file(file: (&Name, &str), report: &mut Report) -> (Option<Declaration>, Option<String>) {
    let Some((tokens, name)) = file_tokens(file, report) else { return (None, None) };
    (declaration(tokens, lacks_header, report), name)
}

/// Splits a file into tokens. Also returns the name of the file in their spans, if these have
/// locations.
fn file_tokens((path, text): (&Name, &str), report: &mut Report) -> Option<(TokenStream, Option<String>)> {
    let mut own = Report::default();
    let Some(tokens) = text::tokens(text, &mut own) else {
        text::report_at(path, text, &own, report);
        return None;
    };
    let first = tokens.clone().into_iter().next().map(|token| Origin::from(token.span()));
    let file = first.filter(|first| first.position().is_some()).map(|first| first.start.file());
    Some((tokens, file))
}

fn with_statements(header: Declaration, parser: &mut Parser<'_>, cursor: &mut Cursor) -> Declaration {
    let statements = parser.statements(cursor);
    let mut expressions = std::mem::take(&mut parser.expressions);
    expressions.end_of_text();
    let unreadable_words = std::mem::take(&mut parser.unreadable_words);
    let bodies = declared_bodies(&statements);
    Declaration {
        statements,
        bodies,
        expressions,
        unreadable_words,
        lacks_names: parser.lacks_names,
        has_units: parser.has_units,
        has_dimensions: parser.has_dimensions,
        ..header
    }
}
