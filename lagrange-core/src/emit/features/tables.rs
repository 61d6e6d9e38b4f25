//! Tables: their points as statics, and a function for each value or derivative that methods call.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::emit::base::members::Members;
use crate::emit::base::shape::{Shape, doc, length, local};
use lagrange_algebra::code::float;
use lagrange_expr::opaque::{Axis, Opaque, OpaqueFunction, Table};
use lagrange_language::syntax::ast::{StatementKind, TableSource};

/// Writes the items of all tables that methods call.
pub(in crate::emit) fn tables(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let called = members.callees.iter().filter_map(|function| Some((function, function.table()?)));
    let mut called = called.collect::<Vec<_>>();
    called.sort_by_key(|(function, _)| (function.function().name.clone(), function.orders().to_vec()));
    let mut items = watched_files(shape);
    let mut known: Vec<(String, Ident)> = Vec::new();
    for (function, table) in called {
        let name = &function.function().name;
        if !known.iter().any(|(known, _)| known == name) {
            let constant = constant_name(name, &known);
            items.extend(points(shape, &constant, table));
            known.push((name.clone(), constant));
        }
        let constant = known.iter().rfind(|(known, _)| known == name).map(|(_, constant)| constant);
        items.extend(constant.map(|constant| method(shape, function, constant)));
    }
    let mut pieces: Vec<Ident> = Vec::new();
    // Series of values and series of derivatives use the same pieces.
    for (function, argument) in members.taylor.iter().flat_map(|taylor| &taylor.followed) {
        let name = piece_name(function, *argument);
        let constant = known.iter().find(|(known, _)| *known == function.function().name);
        if let Some((_, constant)) = constant.filter(|_| !pieces.contains(&name)) {
            items.extend(piece(shape, function, *argument, constant));
            pieces.push(name);
        }
    }
    items
}

/// Returns the name of the function that finds the piece along an argument.
pub(in crate::emit) fn piece_name(table: &Opaque, argument: usize) -> Ident {
    let OpaqueFunction { name, parameters, .. } = table.function();
    local(&format!("{name}_piece_of_{}", parameters[argument]))
}

/// Writes a function that returns the ends of the piece that contains an argument.
fn piece(shape: &Shape<'_>, table: &Opaque, argument: usize, constant: &Ident) -> TokenStream {
    let (krate, name, parameter) =
        (shape.krate, piece_name(table, argument), local(&table.function().parameters[argument]));
    let docs = doc(&format!("Table: the ends of the piece of `{}`.", table.function().name));
    let argument = length(argument);
    quote! {
        #docs
        #[inline]
        fn #name<S: #krate::Number>(#parameter: S) -> [S; 2] {
            #constant.axes[#argument].piece(#parameter)
        }
    }
}

/// Returns the name of a table in capital letters, with trailing underscores if two names differ
/// only in case.
fn constant_name(name: &str, known: &[(String, Ident)]) -> Ident {
    let mut constant = name.to_uppercase();
    while known.iter().any(|(_, other)| *other == constant) {
        constant.push('_');
    }
    Ident::new(&constant, Span::mixed_site())
}

/// Writes the points in the form used for evaluation.
fn points(shape: &Shape<'_>, constant: &Ident, table: &Table) -> TokenStream {
    let krate = shape.krate;
    let size = length(table.interpolation.coefficients());
    let nowhere = float(f64::NAN);
    let row = |row: &[f64]| match row.iter().all(|number| number.is_nan()) {
        true => quote!([#nowhere; #size]),
        false => {
            let numbers = row.iter().map(|number| float(*number));
            quote!([#(#numbers),*])
        }
    };
    let axes = table.axes.iter().map(|axis| axis_tokens(shape, axis));
    let rows = table.coefficients.chunks(table.interpolation.coefficients()).map(row);
    let count = length(table.axes.len());
    quote! {
        static #constant: #krate::table::Table<#count, #size> =
            #krate::table::Table { axes: [#(#axes),*], rows: &[#(#rows),*] };
    }
}

fn axis_tokens(shape: &Shape<'_>, axis: &Axis) -> TokenStream {
    let (krate, density) = (shape.krate, float(axis.density));
    let knots = axis.knots.iter().map(|knot| float(*knot));
    quote!(#krate::table::Axis { knots: &[#(#knots),*], density: #density })
}

/// Writes a function for a value or a derivative.
fn method(shape: &Shape<'_>, function: &Opaque, constant: &Ident) -> TokenStream {
    let (krate, name) = (shape.krate, local(&function.rust_name()));
    let parameters =
        function.function().parameters.iter().map(|parameter| local(parameter)).collect::<Vec<_>>();
    let docs = doc(&format!("Table: {}.", function.describe()));
    let orders = function.orders().iter().map(|order| length(usize::from(*order))).collect::<Vec<_>>();
    let value = match function.order() {
        0 => quote!(#constant.value([#(#parameters),*])),
        _ => quote!(#constant.derivative([#(#orders),*], [#(#parameters),*])),
    };
    quote! {
        #docs
        #[inline]
        fn #name<S: #krate::Number>(#(#parameters: S),*) -> S {
            #value
        }
    }
}

/// Writes references to the files of tables and parts, so that the crate is recompiled when one of
/// them changes.
fn watched_files(shape: &Shape<'_>) -> TokenStream {
    let files = shape.declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Table(table) => match &table.source {
            TableSource::File { contents: Some(file), .. } if !file.path.is_empty() => Some(&file.path),
            _ => None,
        },
        _ => None,
    });
    let included = shape.declaration.included.iter().map(|file| &file.watched);
    files
        .chain(included.filter(|path| !path.is_empty()))
        .map(|path| {
            quote!(
                const _: &[u8] = ::core::include_bytes!(#path);
            )
        })
        .collect()
}
