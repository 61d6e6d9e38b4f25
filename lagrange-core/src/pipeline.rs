//! The whole of it on one screen: text or tokens → declaration → plain statements → model →
//! equations → items. On the way to plain statements, tables are read from files, loops written
//! out, functions inlined and bodies translated.
//!
//! Text and tokens go the same way. Mistakes are collected in a report. After an error the skeleton
//! replaces the requested items, so that only the mistake is reported.

mod callables;
mod numeric;
mod orthogonal;
mod phases;
mod second_way;
mod system;

use proc_macro2::TokenStream;
use quote::quote;

use crate::derive::StrategyChoice;
use crate::emit;
use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::Declaration;
use lagrange_language::syntax::parse_tokens;
use lagrange_language::tables::{Reader, no_files, read_files};
use phases::{equations_of, items_of, model_of};

pub use numeric::NumericSystem;
pub use phases::DerivedPart;
pub use system::{Derived, System, parse, parse_with};

/// Expands the macro: writes everything emitted for a declaration, including mistakes.
pub fn expand(tokens: TokenStream, krate: &TokenStream) -> TokenStream {
    expand_with(tokens, krate, &no_files)
}

/// Expands a declaration whose tables may be files.
pub fn expand_with(tokens: TokenStream, krate: &TokenStream, read: Reader<'_>) -> TokenStream {
    let mut report = Report::default();
    let mut declaration = parse_tokens(tokens, &mut report);
    if let Some(declaration) = &mut declaration {
        read_files(declaration, read, &mut report);
    }
    let attributes = declaration.as_ref().map(|declaration| declaration.attributes.clone());
    let items = declaration.map(|declaration| items(declaration, krate, &mut report));
    let diagnostics = emit::diagnostics(report.diagnostics(), &attributes.unwrap_or_default());
    quote!(#diagnostics #items)
}

fn items(declaration: Declaration, krate: &TokenStream, report: &mut Report) -> TokenStream {
    let (declaration, model) = model_of(declaration, report);
    let items = model.and_then(|mut model| {
        let (equations, parts) = equations_of(&declaration, &mut model, StrategyChoice::Cheapest, report)?;
        items_of((&declaration, &mut model, &equations), parts, krate, report)
    });
    items.unwrap_or_else(|| emit::skeleton(&declaration, krate))
}

#[cfg(test)]
mod tests;
