//! Functions that solve equations for algebraic unknowns by Newton's method.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use crate::emit::base::method::Arguments;
use crate::emit::base::shape::{doc, length, local};
use crate::emit::base::writer::MethodWriter;
use lagrange_algebra::code::{Names, Scalar};
use lagrange_algebra::formula::text;
use lagrange_algebra::program::NewtonProgram;
use lagrange_expr::expr::Node;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Equations that take more names, numbers and signs than this are not written out in
/// documentation.
const LONGEST_EQUATION: u64 = 60;

/// Writes the unknowns that accelerations and rates of states are made of, so that errors name the
/// one without a value.
pub(in crate::emit) fn write_unknowns(writer: &mut MethodWriter<'_>) {
    let rates = [&writer.equations.accelerations[..], &writer.model.position_rates()].concat();
    let graph = &writer.model.graph;
    let (mut roots, mut names) = (Vec::new(), Vec::new());
    for id in graph.reachable(&rates) {
        if let Node::Opaque(function, _) = graph.node(id)
            && function.is_solution()
        {
            roots.push(id);
            names.push(function.function().name.clone());
        }
    }
    if roots.is_empty() {
        return;
    }
    let (body, _) = writer.lowered(&roots, Arguments::State, |values| quote!([#((#names, #values)),*]));
    writer.members.unknowns = Some(body);
}

/// Writes a function for each unknown that methods mention.
pub(in crate::emit) fn write_solvers(writer: &mut MethodWriter<'_>) {
    let called = writer.members.callees.iter().filter(|function| function.is_solution());
    for function in called.cloned().collect::<Vec<_>>() {
        let solver = solver(writer, &function).unwrap_or_default();
        writer.members.solvers.extend(solver);
    }
}

fn solver(writer: &mut MethodWriter<'_>, function: &Opaque) -> Option<TokenStream> {
    let docs = documentation(writer, function);
    let unknown = writer.model.graph.unknown(function).cloned()?;
    let program = NewtonProgram::new(&mut writer.model.graph, &unknown, writer.model.accuracy);
    let (generics, number, scalar) = number_type(writer);
    let mut names = Names::default();
    let mut name_of = |role: Role| names.role(writer.model.graph.symbols(), role);
    let arguments = program.arguments.iter().map(|role| name_of(*role)).collect::<Vec<_>>();
    let value = name_of(program.value);
    let start = writer.lowered_apart(&program.start, &scalar, &mut names)?;
    let equation = writer.lowered_apart(&program.equation, &scalar, &mut names)?;
    let (name, krate) = (local(&function.rust_name()), writer.shape.krate);
    let (before, from) = (start.statements, start.outputs);
    let (statements, results) = (equation.statements, equation.outputs);
    let iterations = length(program.iterations as usize);
    // Numbers side by side are computed in functions for what the processor has, and only what is
    // inlined there is.
    let inline = match scalar {
        Scalar::SideBySide { .. } => quote!(#[inline(always)]),
        _ => quote!(#[inline]),
    };
    Some(quote! {
        #docs
        #inline
        fn #name #generics(#(#arguments: #number),*) -> #number {
            #before
            #krate::root::newton(#(#from)*, #iterations, |#value| {
                #statements
                [#(#results),*]
            })
        }
    })
}

/// Type parameters of a function, the numbers that it takes, and what its body computes with.
fn number_type(writer: &MethodWriter<'_>) -> (TokenStream, TokenStream, Scalar) {
    let (shape, krate) = (writer.shape, writer.shape.krate);
    if writer.members.lanes.is_some() {
        let number = shape.lanes_number();
        return (quote!(<#number: #krate::Number>), number.to_token_stream(), shape.lanes_computed_with());
    }
    (shape.bounds(), shape.scalar(), shape.computed_with())
}

fn documentation(writer: &MethodWriter<'_>, function: &Opaque) -> TokenStream {
    let (graph, name) = (&writer.model.graph, &function.function().name);
    let equation = graph.unknown(function).map(|unknown| unknown.residual);
    let short = equation.filter(|&residual| graph.written_size(residual) <= LONGEST_EQUATION);
    let of = short.map_or(String::new(), |residual| format!(" of `0 = {}`", text::text(graph, residual)));
    doc(&format!("Solution `{name}`{of} by Newton's method; NaN if it finds none."))
}
