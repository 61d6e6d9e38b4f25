//! Members for inputs and outputs: a struct of the inputs, and the traits with which runs set and
//! record them.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::switches::kept_switches;
use crate::emit::base::members::Members;
use crate::emit::base::method::{Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, doc, identifier, length, local};
use crate::emit::base::state::{array_conversions, named_values};
use lagrange_algebra::code::Names;
use lagrange_expr::collections::HashMap;
use lagrange_language::syntax::ast::Name;

/// Names of the first components of a vector; further ones have their index.
const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// Writes the struct of the inputs, if there are any.
pub(in crate::emit) fn inputs_struct(shape: &Shape<'_>) -> Option<TokenStream> {
    let inputs = inputs(shape);
    let title = doc(&format!("Inputs of [`{}`].", shape.declaration.name.text));
    let fields = shape.declared_fields(&inputs, &shape.scalar_path());
    (!inputs.is_empty()).then(|| named_values(shape, &title, &inputs_name(shape), &fields))
}

/// Writes conversions between inputs and arrays, and `ControlledSystem`.
pub(in crate::emit) fn inputs_impls(shape: &Shape<'_>) -> Option<TokenStream> {
    let inputs = inputs(shape);
    let (system, name, krate) = (shape.name(), inputs_name(shape), shape.krate);
    let (generics, bounds, scalar) = (shape.generics(), shape.bounds(), shape.scalar());
    let k = length(inputs.len());
    let texts = inputs.iter().map(|input| shape.written(input));
    let of_inputs = shape.fields_of(&inputs);
    let fields = of_inputs.iter().map(|field| &field.identifier).collect::<Vec<_>>();
    let mut names = Names::default();
    let variables = inputs.iter().map(|input| names.fresh(&input.text)).collect::<Vec<_>>();
    let values = local("inputs");
    let conversions = array_conversions(shape, (&name, &values), &of_inputs, &variables);
    let (others, switches) = (shape.kept_fields(|field| !shape.is_input(field)), kept_switches(shape));
    let impls = quote! {
        #conversions
        #[automatically_derived]
        impl #bounds #krate::system::ControlledSystem for #system #generics {
            type Inputs = #name #generics;
            type InputVector = [#scalar; #k];
            const INPUTS: &'static [&'static ::core::primitive::str] = &[#(#texts),*];
            #[inline]
            fn inputs(&self) -> #name #generics {
                #name { #(#fields: self.#fields),* }
            }
            #[inline]
            fn with_inputs(&self, #values: #name #generics) -> Self {
                Self { #(#fields: #values.#fields,)* #others #switches }
            }
        }
    };
    (!inputs.is_empty()).then_some(impls)
}

/// Returns the inputs in the order of declaration.
fn inputs<'a>(shape: &Shape<'a>) -> Vec<&'a Name> {
    shape.fields.iter().copied().filter(|name| shape.is_input(name)).collect()
}

/// Returns the name of the struct of inputs.
pub(in crate::emit) fn inputs_name(shape: &Shape<'_>) -> Ident {
    let name = &shape.declaration.name;
    format_ident!("{}Inputs", name.text, span = name.span)
}

/// Returns the outputs with methods.
fn outputs<'s>(shape: &'s Shape<'_>, members: &Members) -> Vec<(&'s Name, Returns)> {
    // In a declaration with errors, another item may have the name of an output.
    let is_output = |method: &Method| {
        method.arguments == Arguments::State && !matches!(method.returns, Returns::Matrix(..))
    };
    let methods = members.methods.iter().filter(|method| is_output(method));
    // The first of two methods with the same name is used.
    let written = methods.rev().map(|method| (method.name.to_string(), method.returns));
    let written = written.collect::<HashMap<_, _>>();
    let of_output = |name: &'s Name| Some((name, *written.get(&name.text)?));
    shape.outputs.iter().filter_map(|(name, _)| of_output(name)).collect()
}

/// True if there is an implementation of `OutputSystem`.
pub(in crate::emit) fn has_outputs(shape: &Shape<'_>, members: &Members) -> bool {
    outputs(shape, members).iter().any(|(_, returns)| returns.count() > 0)
}

/// Writes `OutputSystem`, if there are outputs.
pub(in crate::emit) fn outputs_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, [parameters, passed]) = (shape.krate, Arguments::State.written(shape, &members.names));
    let (mut texts, mut statements, mut all) = (Vec::new(), TokenStream::new(), Vec::new());
    for (output, returns) in outputs(shape, members) {
        let (first, count) = (all.len(), returns.count());
        let values = (first..first + count).map(|index| format_ident!("output_{index}")).collect::<Vec<_>>();
        let pattern = match returns {
            Returns::Scalar => quote!(#(#values)*),
            _ => quote!([#(#values),*]),
        };
        let method = identifier(output);
        statements.extend(quote!(let #pattern = self.#method(#passed);));
        texts.extend(column_names(shape, output, count));
        all.extend(values);
    }
    let k = length(all.len());
    let item = quote! {
        #[automatically_derived]
        impl #bounds #krate::system::OutputSystem for #name #generics {
            type Outputs = [#scalar; #k];
            const OUTPUTS: &'static [&'static ::core::primitive::str] = &[#(#texts),*];
            #[inline]
            fn outputs(&self, #parameters) -> [#scalar; #k] {
                #statements
                [#(#all),*]
            }
        }
    };
    (!all.is_empty()).then_some(item)
}

/// Returns the known units of the columns of outputs.
pub(in crate::emit) fn units_of_outputs<'s>(
    shape: &'s Shape<'_>,
    members: &Members,
) -> Vec<(String, &'s str)> {
    let columns = outputs(shape, members).into_iter().flat_map(|(output, returns)| {
        let names = column_names(shape, output, returns.count()).enumerate();
        names.filter_map(|(index, column)| Some((column, shape.unit_of_component(&output.text, index)?)))
    });
    columns.collect()
}

/// Returns the names of the columns of an output.
pub(in crate::emit) fn column_names(
    shape: &Shape<'_>,
    output: &Name,
    count: usize,
) -> impl Iterator<Item = String> {
    (0..count).map(move |index| column_name(shape.written(output), index, count))
}

/// Returns the name of the column of a component of an output, such as `tip.x`.
fn column_name(output: &str, index: usize, count: usize) -> String {
    match (count, COMPONENTS.get(index)) {
        (1, _) => output.to_owned(),
        (2..=3, Some(component)) => format!("{output}.{component}"),
        _ => format!("{output}.{index}"),
    }
}
