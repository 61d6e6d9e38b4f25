//! The items of an emitted system: the struct, its state, implementations and traits.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

use super::base::attributes::{conditions, deprecated_exception, split_attributes};
use super::base::lints::{name_exception, rounded_exception};
use super::base::members::Members;
use super::base::method::ArgumentNames;
use super::base::shape::{Shape, doc, identifier, length, local};
use super::base::state::{columns_impls, columns_struct, state_conversions, state_struct, state_variables};
use super::features::constrained::projections;
use super::features::contacts::mode_fields;
use super::features::ports::{inputs_impls, inputs_struct, outputs_impl};
use super::features::switches::switches_declaration;
use super::traits::trait_impls;

/// All items. The implementations stand in an anonymous constant, so that the names they import and the
/// helpers they need are nobody else's.
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
    let names = name_exception(shape);
    let rounded = rounded_exception(members.has_rounded_constants);
    let attributes = &shape.declaration.attributes;
    let (conditions, deprecated) = (conditions(attributes), deprecated_exception(attributes));
    let is_derived = shape.declaration.derives.iter().any(|name| name.text == "Default");
    let default = (members.default.is_none() && !is_derived)
        .then(|| quote!(#conditions #krate::private::bring_hints! { default }));
    let inputs = inputs_struct(shape).map(|inputs| quote!(#conditions #inputs));
    quote! {
        #system
        #conditions
        #state
        #conditions
        #columns
        #inputs
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
            #(#implementations)*
            #(#conversions)*
            #traits
            #(#ports)*
        };
    }
}

/// A place of the user's for what is emitted nevertheless, and no matter of the user's lints.
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
        docs.push(doc(&format!("A mechanical system with the {}.", coordinate_list(shape))));
    }
    if !members.docs.is_empty() {
        docs.push(doc(""));
        docs.extend(members.docs.iter().map(|line| doc(line)));
    }
    let field_docs = shape
        .fields
        .iter()
        .map(|name| shape.docs(name, &format!("{} `{}`.", shape.kind_of_field(name), name.text)));
    let fields = shape.fields.iter().map(|name| identifier(name));
    let fields = quote!(#(#field_docs pub #fields: #scalar,)*);
    let marker = shape.needs_marker().then(|| {
        quote! {
            /// The number type.
            pub scalar: ::core::marker::PhantomData<#scalar>,
        }
    });
    let fields =
        [fields, mode_fields(shape)].into_iter().chain(switches_declaration(shape)).collect::<TokenStream>();
    // It begins and ends in what the user wrote, so that the compiler proposes attributes there and not in the macro.
    let body = match fields.is_empty() && marker.is_none() {
        true => quote_spanned!(emitted_at(declaration.name.span)=> ;),
        false => {
            let mut body = Group::new(Delimiter::Brace, quote!(#fields #marker));
            body.set_span(emitted_at(declaration.name.span));
            body.into_token_stream()
        }
    };
    let names = name_exception(shape);
    let touching = shape.touching.iter().map(|(name, _)| name);
    let unused = shape.fields.iter().chain(touching).any(|name| name.text.starts_with('_'));
    let unused = unused.then(|| {
        quote!(#[allow(clippy::pub_underscore_fields, reason = "the user marked the parameter as unused")])
    });
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
    match names.as_slice() {
        [single] => format!("coordinate {single}"),
        names => format!("coordinates {}", names.join(", ")),
    }
}

fn inherent_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let methods = members.methods.iter().map(|method| method.tokens(shape, &members.names));
    let (constants, rhs) = (&members.constants, rhs(shape, &members.names));
    let (hidden, motions) = (&members.hidden, &members.motions);
    let projections = projections(shape, members);
    quote! {
        impl #bounds #name #generics {
            #constants
            #(#methods)*
            #rhs
            #motions
            #projections
            #hidden
        }
    }
}

/// ẏ = [v, a]
fn rhs(shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
    let (scalar, n) = (shape.scalar(), shape.coordinates.len());
    let (all, variables) = (shape.state_length(), state_variables(shape));
    let (positions, velocities) = variables.split_at(n);
    let ArgumentNames { time, state, accelerations, .. } = names;
    let indices = (0..shape.velocities.len()).map(length);
    let (rates, line) = match shape.velocities_are_rates() {
        true => (quote!(#(#velocities,)*), "Rate of the state: velocities, then accelerations."),
        false => {
            let (rates, indices) = (local("rates"), (0..n).map(length));
            (quote!(#(#rates[#indices],)*), "Rate of the state: rates of the positions, then accelerations.")
        }
    };
    let found = (!shape.velocities_are_rates()).then(|| {
        let rates = local("rates");
        quote!(let #rates = self.position_rates(#time, &[#(#positions),*], &[#(#velocities),*]);)
    });
    let docs = doc(line);
    quote! {
        #docs
        #[must_use]
        #[inline]
        pub fn rhs(&self, #time: #scalar, #state: &[#scalar; #all]) -> [#scalar; #all] {
            let [#(#variables),*] = *#state;
            let #accelerations = self.acceleration(#time, &[#(#positions),*], &[#(#velocities),*]);
            #found
            [#rates #(#accelerations[#indices]),*]
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
