//! The items of an emitted system: the struct, its state, implementations and traits.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

use super::base::attributes::{conditions, deprecated_exception, split_attributes};
use super::base::lints::{name_exception, rounded_exception, unused_exception};
use super::base::members::Members;
use super::base::shape::{Shape, doc, local};
use super::base::state::{columns_impls, columns_struct, rhs, state_conversions, state_struct};
use super::features::constrained::projections;
use super::features::contacts::mode_fields;
use super::features::lanes::{lanes_items, lanes_struct};
use super::features::laws::laws_module;
use super::features::ports::{inputs_impls, inputs_struct, outputs_impl};
use super::features::prepared::{prepared_items, prepared_method, prepared_struct};
use super::features::ranges::check_method;
use super::features::regressor::regressor_members;
use super::features::start::start_method;
use super::features::switches::switches_declaration;
use super::features::tables::tables;
use super::traits::trait_impls;

/// Writes all items. The implementations are in an anonymous constant, so that their imports and
/// helpers remain private.
pub(super) fn items(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let system = system_struct(shape, members);
    let (state, columns) = (state_struct(shape), columns_struct(shape));
    let implementations = [inherent_impl(shape, members), default_impl(shape, members)];
    let conversions = [state_conversions(shape), columns_impls(shape)];
    let traits = trait_impls(shape, members);
    let ports = [inputs_impls(shape), outputs_impl(shape, members)].into_iter().flatten();
    let scalar = shape.scalar_path();
    let import = shape.generics().is_empty().then(|| quote!(use #scalar;));
    let (krate, functions) = (shape.krate, members.functions.iter().map(|name| local(name)));
    let functions = (!members.functions.is_empty()).then(|| quote!(use #krate::private::{#(#functions),*};));
    let (tables, solvers) = (tables(shape, members), &members.solvers);
    let names = name_exception(shape);
    let rounded = rounded_exception(members.has_rounded_constants);
    let attributes = &shape.declaration.attributes;
    let (conditions, deprecated) = (conditions(attributes), deprecated_exception(attributes));
    let is_derived = shape.declaration.derives.iter().any(|name| name.text == "Default");
    let default = (members.default.is_none() && !is_derived)
        .then(|| quote!(#conditions #krate::private::bring_hints! { default }));
    let inputs = inputs_struct(shape).map(|inputs| quote!(#conditions #inputs));
    let prepared = prepared_struct(shape, members).map(|prepared| quote!(#conditions #prepared));
    let lanes = lanes_struct(shape, members).map(|lanes| quote!(#conditions #lanes));
    let laws = laws_module(shape, members);
    let (of_prepared, of_lanes) = (prepared_items(shape, members), lanes_items(shape, members));
    quote! {
        #system
        #conditions
        #state
        #conditions
        #columns
        #inputs
        #prepared
        #lanes
        #laws
        #conditions
        #krate::private::bring_hints! {}
        #default
        #conditions
        #names
        #rounded
        #deprecated
        const _: () = {
            #import
            #functions
            #tables
            #solvers
            #(#implementations)*
            #(#conversions)*
            #traits
            #(#ports)*
            #of_prepared
            #of_lanes
        };
    }
}

/// Returns a span at the user's place that still counts as emitted code, so that the user's lints
/// do not apply.
fn emitted_at(place: Span) -> Span {
    place.resolved_at(Span::mixed_site())
}

fn system_struct(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let declaration = shape.declaration;
    let (mut docs, attributes) = split_attributes(&declaration.attributes);
    let (name, generics, scalar) = (shape.name(), shape.generics(), shape.scalar_path());
    let visibility = declaration.visibility.clone().into_iter().map(|mut token| {
        token.set_span(emitted_at(token.span()));
        token
    });
    let (visibility, keyword) =
        (visibility.collect::<TokenStream>(), Ident::new("struct", emitted_at(declaration.keyword)));
    if docs.is_empty() {
        let kind = if shape.velocities.is_empty() { "system of first order" } else { "mechanical system" };
        docs.push(doc(&format!("A {kind} with the {}.", coordinate_list(shape))));
    }
    if !members.docs.is_empty() {
        docs.push(doc(""));
        docs.extend(members.docs.iter().map(|line| doc(line)));
    }
    let fields = shape.declared_fields(&shape.fields, &scalar);
    let marker = shape.needs_marker().then(|| {
        quote! {
            /// The number type.
            pub scalar: ::core::marker::PhantomData<#scalar>,
        }
    });
    let fields =
        [fields, mode_fields(shape)].into_iter().chain(switches_declaration(shape)).collect::<TokenStream>();
    // It begins and ends in the user's code, so that the compiler suggests attributes there instead
    // of in the macro.
    let body = match fields.is_empty() && marker.is_none() {
        true => quote_spanned!(emitted_at(declaration.name.span)=> ;),
        false => {
            let mut body = Group::new(Delimiter::Brace, quote!(#fields #marker));
            body.set_span(emitted_at(declaration.name.span));
            body.into_token_stream()
        }
    };
    let (names, unused) = (name_exception(shape), unused_exception(shape));
    quote! {
        #(#docs)*
        #(#attributes)*
        #names
        #unused
        #visibility #keyword #name #generics #body
    }
}

fn coordinate_list(shape: &Shape<'_>) -> String {
    let names = shape.coordinates.iter().map(|name| format!("`{}`", name.text)).collect::<Vec<_>>();
    let word = if shape.velocities.is_empty() { "state" } else { "coordinate" };
    match names.as_slice() {
        [single] => format!("{word} {single}"),
        names => format!("{word}s {}", names.join(", ")),
    }
}

fn inherent_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let methods = members.methods.iter().map(|method| method.tokens(shape, &members.names));
    let (constants, kernel, rhs) =
        (&members.constants, &members.kernel, rhs(shape, &members.names, &quote!(self)));
    let (hidden, motions) = (&members.hidden, &members.motions);
    let projections = projections(shape, members);
    let (start, check) = (start_method(shape, members), check_method(shape, members));
    let (prepared, regressor) = (prepared_method(shape, members), regressor_members(shape, members));
    quote! {
        impl #bounds #name #generics {
            #constants
            #kernel
            #regressor
            #start
            #check
            #(#methods)*
            #rhs
            #motions
            #projections
            #prepared
            #hidden
        }
    }
}

fn default_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let Some(default) = &members.default else { return TokenStream::new() };
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    quote! {
        #[automatically_derived]
        impl #bounds ::core::default::Default for #name #generics {
            fn default() -> Self {
                #default
            }
        }
    }
}
