//! Overview of all phases: text or tokens → declaration → plain statements → model → equations →
//! items. On the way to plain statements, tables are read from files, loops expanded, functions
//! inlined and bodies translated.
//!
//! Text and tokens are processed identically. Errors are collected in a report. After an error, the
//! skeleton replaces the requested items, so that only the error is reported.

mod callables;
mod drawn;
mod included;
mod layout;
mod lowering;
mod numeric;
mod orthogonal;
mod phases;
mod programs;
mod routines;
mod second_way;
mod series;
mod system;

use proc_macro2::TokenStream;
use quote::quote;

use crate::derive::StrategyChoice;
use crate::emit;
use included::name_included;
use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::{Declaration, IncludedFile, PlacedInstance};
use lagrange_language::syntax::parse_tokens;
use lagrange_language::tables::{Reader, no_files, read_files};
use phases::{equations_of, items_of, model_of};

pub use drawn::{DrawnScene, PlacedHeight, PlacedItem, PlacedPart};
pub use layout::{Layout, Place};
pub use numeric::NumericSystem;
pub use phases::DerivedPart;
pub use programs::{BoundedQuantity, Programs, Range, Reaction, TickingClock, TouchingPrograms};
pub use routines::{Backend, Call, Code, LISTS, Numbers};
pub use series::{MotionSeries, ResultPlaces, SlotPlaces};
pub use system::{Derived, System, parse, parse_adding, parse_with};

/// Expands the macro: writes all items emitted for a declaration, including errors.
pub fn expand(tokens: TokenStream, krate: &TokenStream) -> TokenStream {
    expand_with(tokens, krate, &no_files)
}

/// Expands a declaration that may refer to files of tables and of parts.
pub fn expand_with(tokens: TokenStream, krate: &TokenStream, read: Reader<'_>) -> TokenStream {
    let mut report = Report::default();
    let expanded = expanded(tokens.clone(), krate, read, &mut report);
    if !expanded.included.is_empty() && !report.diagnostics().is_empty() {
        name_included((&tokens.to_string(), &krate.to_string()), read, &expanded, &mut report);
    }
    drop(tokens);
    let Expanded { items, attributes, .. } = expanded;
    let diagnostics = emit::diagnostics(report.diagnostics(), &attributes);
    quote!(#diagnostics #items)
}

/// The items of a declaration, with data for messages about it.
struct Expanded {
    items: Option<TokenStream>,
    attributes: TokenStream,
    included: Vec<IncludedFile>,
    placed: Vec<PlacedInstance>,
}

fn expanded(tokens: TokenStream, krate: &TokenStream, read: Reader<'_>, report: &mut Report) -> Expanded {
    let mut declaration = parse_tokens(tokens, report);
    if let Some(declaration) = &mut declaration {
        read_files(declaration, read, report);
    }
    let attributes = declaration.as_ref().map(|declaration| declaration.attributes.clone());
    let included = declaration.as_ref().map(|declaration| declaration.included.clone());
    let (items, placed) = declaration.map(|declaration| items(declaration, krate, report)).unzip();
    Expanded {
        items,
        attributes: attributes.unwrap_or_default(),
        included: included.unwrap_or_default(),
        placed: placed.unwrap_or_default(),
    }
}

/// Returns the items of a declaration, and the parts that it places.
fn items(
    declaration: Declaration,
    krate: &TokenStream,
    report: &mut Report,
) -> (TokenStream, Vec<PlacedInstance>) {
    let (mut declaration, model) = model_of(declaration, report);
    let items = model.and_then(|mut model| {
        let (equations, parts) = equations_of(&declaration, &mut model, StrategyChoice::Cheapest, report)?;
        items_of((&declaration, &mut model, &equations), parts, krate, report)
    });
    let items = items.unwrap_or_else(|| emit::skeleton(&mut declaration, krate));
    (items, declaration.placed)
}

#[cfg(test)]
mod tests;
