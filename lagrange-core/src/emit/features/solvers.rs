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

/// Maximum number of names, numbers and signs of an equation that documentation writes out.
const LONGEST_EQUATION: u64 = 60;

/// Writes the unknowns on which accelerations and rates of states depend, so that errors name the
/// one without a value.
pub(in crate::emit) fn write_unknowns(writer: &mut MethodWriter<'_>) {
    write_distances(writer);
    let rates = [&writer.equations.accelerations[..], &writer.model.position_rates()].concat();
    let graph = &writer.model.graph;
    let (mut roots, mut names) = (Vec::new(), Vec::new());
    for id in graph.reachable(&rates) {
        if let Node::Opaque(function, _) = graph.node(id)
            && function.is_solution()
        {
            roots.push(id);
            names.push(writer.shape.declaration.written(&function.function().name).to_owned());
        }
    }
    if roots.is_empty() {
        return;
    }
    let (body, _) = writer.lowered(&roots, Arguments::State, |values| quote!([#((#names, #values)),*]));
    writer.members.unknowns = Some(body);
}

/// Writes the distances of the centres of compliant contacts, so that errors name one that is zero.
fn write_distances(writer: &mut MethodWriter<'_>) {
    let (names, roots): (Vec<_>, Vec<_>) = writer.model.distances.iter().cloned().unzip();
    if roots.is_empty() {
        return;
    }
    let names = names.iter().map(|name| writer.shape.written(name)).collect::<Vec<_>>();
    let (body, _) = writer.lowered(&roots, Arguments::State, |values| quote!([#((#names, #values)),*]));
    writer.members.distances = Some(body);
}

/// Writes a function for each unknown that methods mention, or for those that are solved for
/// together, and for contact points of blocks.
pub(in crate::emit) fn write_solvers(writer: &mut MethodWriter<'_>) {
    let mut written = Vec::new();
    let is_written = |function: &&Opaque| function.is_solution() || function.is_contact_point();
    for function in writer.members.callees.clone().iter().filter(is_written) {
        if !written.contains(&function.unknowns()) {
            let solver = match function.is_contact_point() {
                true => contact_points(writer, function),
                false => solver(writer, function).unwrap_or_default(),
            };
            writer.members.solvers.extend(solver);
            written.push(function.unknowns());
        }
    }
}

/// The function of contact points, from the numbers of both blocks.
fn contact_points(writer: &MethodWriter<'_>, function: &Opaque) -> TokenStream {
    let docs = doc("Numbers of the contact points of two blocks.");
    let (generics, number, _) = number_type(writer);
    let (name, krate) = (local(&function.rust_name()), writer.shape.krate);
    let blocks = (0..function.arity()).map(|number| local(&format!("block_{number}"))).collect::<Vec<_>>();
    let found = array(&number, function.unknowns().len());
    quote! {
        #docs
        #[allow(clippy::too_many_arguments, reason = "they are the numbers of two blocks")]
        fn #name #generics(#(#blocks: #number),*) -> #found {
            #krate::manifold::touches([#(#blocks),*])
        }
    }
}

fn solver(writer: &mut MethodWriter<'_>, function: &Opaque) -> Option<TokenStream> {
    let docs = documentation(writer, function);
    let unknowns = writer.model.graph.equations_of(function).cloned()?;
    let program = NewtonProgram::new(&mut writer.model.graph, &unknowns, writer.model.accuracy);
    let (generics, number, scalar) = number_type(writer);
    let mut names = Names::default();
    let mut name_of = |role: Role| names.role(writer.model.graph.symbols(), role);
    let arguments = program.arguments.iter().map(|role| name_of(*role)).collect::<Vec<_>>();
    let values = program.values.iter().map(|role| name_of(*role)).collect::<Vec<_>>();
    let start = writer.lowered_apart(&program.start, &scalar, &mut names)?;
    let equation = writer.lowered_apart(&program.equation, &scalar, &mut names)?;
    let (name, krate) = (local(&function.rust_name()), writer.shape.krate);
    let (before, statements) = (start.statements, equation.statements);
    let from = together(&start.outputs);
    let results = results(&equation.outputs, values.len());
    let pattern = together(&values);
    let (method, found) = match values.len() {
        1 => (local("newton"), number.clone()),
        count => (local("coupled"), array(&number, count)),
    };
    let iterations = length(program.iterations as usize);
    // Numbers in lanes are computed in functions that are compiled for the processor's features;
    // this only extends to inlined code.
    let inline = match scalar {
        Scalar::SideBySide { .. } => quote!(#[inline(always)]),
        _ => quote!(#[inline]),
    };
    Some(quote! {
        #docs
        #inline
        fn #name #generics(#(#arguments: #number),*) -> #found {
            #before
            #krate::root::#method(#from, #iterations, |#pattern| {
                #statements
                #results
            })
        }
    })
}

fn array(number: &TokenStream, count: usize) -> TokenStream {
    let count = length(count);
    quote!([#number; #count])
}

/// Writes a value, or an array of several.
fn together(items: &[impl ToTokens]) -> TokenStream {
    match items {
        [single] => single.to_token_stream(),
        _ => quote!([#(#items),*]),
    }
}

/// Writes residuals, their Jacobian and their rounding errors.
fn results(outputs: &[TokenStream], unknowns: usize) -> TokenStream {
    if unknowns == 1 {
        return quote!([#(#outputs),*]);
    }
    let (residuals, rest) = outputs.split_at(unknowns);
    let (jacobian, rounding) = rest.split_at(unknowns * unknowns);
    let rows = jacobian.chunks(unknowns).map(|row| quote!([#(#row),*]));
    quote!(([#(#residuals),*], [#(#rows),*], [#(#rounding),*]))
}

/// Returns the type parameters of a function, the type of its arguments, and the number type of its
/// body.
fn number_type(writer: &MethodWriter<'_>) -> (TokenStream, TokenStream, Scalar) {
    let (shape, krate) = (writer.shape, writer.shape.krate);
    if writer.members.lanes.is_some() {
        let number = shape.lanes_number();
        return (quote!(<#number: #krate::Number>), number.to_token_stream(), shape.lanes_computed_with());
    }
    (shape.bounds(), shape.scalar(), shape.computed_with())
}

fn documentation(writer: &MethodWriter<'_>, function: &Opaque) -> TokenStream {
    let graph = &writer.model.graph;
    let names = function.unknowns().iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let residuals = graph.equations_of(function).map(|unknowns| unknowns.residuals.clone());
    let residuals = residuals.unwrap_or_default();
    let size = residuals.iter().map(|&residual| graph.written_size(residual)).sum::<u64>();
    let equations = residuals.iter().map(|&residual| format!("`0 = {}`", text::text(graph, residual)));
    let of = match size <= LONGEST_EQUATION {
        true => format!(" of {}", equations.collect::<Vec<_>>().join(", ")),
        false => String::new(),
    };
    doc(&format!("Solution {names}{of} by Newton's method; NaN if it finds none."))
}
