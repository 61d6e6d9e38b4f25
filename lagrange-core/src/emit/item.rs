//! The items of an emitted system: the struct, its state, implementations and traits.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::method::{ArgumentNames, Arguments, Method};
use super::shape::{Shape, doc, identifier, length, local};

/// Everything that differs between a derived system and a skeleton.
pub(super) struct Parts {
    /// Documentation of the struct, after the user's own.
    pub(super) docs: Vec<String>,
    /// Values of the fields for `Default`, if all are known.
    pub(super) defaults: Option<Vec<TokenStream>>,
    pub(super) methods: Vec<Method>,
    /// Associated constants.
    pub(super) constants: TokenStream,
    pub(super) names: ArgumentNames,
    /// Functions of `lagrange::private` that the methods call.
    pub(super) functions: BTreeSet<&'static str>,
}

/// All items. The implementations stand in an anonymous constant, so that the names they import and the
/// helpers they need are nobody else's.
pub(super) fn items(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let system = system_struct(shape, parts);
    let state = state_struct(shape);
    let implementations = [inherent_impl(shape, parts), default_impl(shape, parts)];
    let (conversions, traits) = (state_conversions(shape), trait_impls(shape, parts));
    let scalar = shape.scalar_path();
    let import = shape.generics().is_empty().then(|| quote!(use #scalar;));
    let (krate, functions) = (shape.krate, parts.functions.iter().map(|name| local(name)));
    let functions = (!parts.functions.is_empty()).then(|| quote!(use #krate::private::{#(#functions),*};));
    quote! {
        #system
        #state
        const _: () = {
            #import
            #functions
            #(#implementations)*
            #conversions
            #traits
        };
    }
}

fn system_struct(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let declaration = shape.declaration;
    let (mut docs, attributes) = split_attributes(&declaration.attributes);
    let (name, generics, scalar) = (shape.name(), shape.generics(), shape.scalar_path());
    let visibility = &declaration.visibility;
    if docs.is_empty() {
        docs.push(doc(&format!("A mechanical system with the {}.", coordinate_list(shape))));
    }
    if !parts.docs.is_empty() {
        docs.push(doc(""));
        docs.extend(parts.docs.iter().map(|line| doc(line)));
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
    let body = match shape.fields.is_empty() && marker.is_none() {
        true => quote!(;),
        false => quote!({ #fields #marker }),
    };
    quote! {
        #(#docs)*
        #(#attributes)*
        #visibility struct #name #generics #body
    }
}

/// The lines of documentation and the other attributes.
fn split_attributes(attributes: &TokenStream) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    // An attribute is a number sign and a group in brackets.
    let attributes = tokens.chunks(2).map(|attribute| attribute.iter().cloned().collect::<TokenStream>());
    attributes
        .partition(|attribute| attribute.to_string().trim_start_matches(['#', '[', ' ']).starts_with("doc"))
}

fn coordinate_list(shape: &Shape<'_>) -> String {
    let names = shape.coordinates.iter().map(|name| format!("`{}`", name.text)).collect::<Vec<_>>();
    match names.as_slice() {
        [single] => format!("coordinate {single}"),
        names => format!("coordinates {}", names.join(", ")),
    }
}

fn state_struct(shape: &Shape<'_>) -> TokenStream {
    let (name, generics, scalar) = (shape.state_name(), shape.generics(), shape.scalar_path());
    let visibility = &shape.declaration.visibility;
    let title = doc(&format!("State of [`{}`]: coordinates, then velocities.", shape.declaration.name.text));
    let docs = shape
        .coordinates
        .iter()
        .map(|name| shape.docs(name, &format!("Coordinate `{}`.", name.text)))
        .chain(shape.coordinates.iter().map(|name| doc(&format!("Velocity of `{}`.", name.text))));
    let fields = shape.state_fields();
    let allow = (!generics.is_empty()).then(
        || quote!(#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]),
    );
    quote! {
        #title
        #allow
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #name #generics {
            #(#docs pub #fields: #scalar,)*
        }
    }
}

/// Why lints of the user's crate do not apply to generated methods.
fn lint_exceptions() -> TokenStream {
    quote! {
        #[allow(
            unused_variables,
            clippy::excessive_precision,
            clippy::many_single_char_names,
            clippy::similar_names,
            clippy::suboptimal_flops,
            clippy::too_many_lines,
            clippy::trivially_copy_pass_by_ref,
            clippy::unused_self,
            reason = "generated: every method has the arguments that its kind of quantity can depend on, \
                      and the names of the formulas"
        )]
    }
}

fn inherent_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let methods = parts.methods.iter().map(|method| method.tokens(shape, &parts.names));
    let (constants, rhs, allow) = (&parts.constants, rhs(shape, &parts.names), lint_exceptions());
    quote! {
        #allow
        impl #bounds #name #generics {
            #constants
            #(#methods)*
            #rhs
        }
    }
}

/// ẏ = [v, a]
fn rhs(shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
    let (scalar, n) = (shape.scalar(), shape.coordinates.len());
    let (twice, fields) = (length(2 * n), shape.state_fields());
    let (positions, velocities) = fields.split_at(n);
    let ArgumentNames { time, state, accelerations, .. } = names;
    let indices = (0..n).map(length);
    quote! {
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, #time: #scalar, #state: &[#scalar; #twice]) -> [#scalar; #twice] {
            let [#(#fields),*] = *#state;
            let #accelerations = self.acceleration(#time, &[#(#positions),*], &[#(#velocities),*]);
            [#(#velocities,)* #(#accelerations[#indices]),*]
        }
    }
}

fn default_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let Some(defaults) = &parts.defaults else { return TokenStream::new() };
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let fields = shape.fields.iter().map(|name| identifier(name));
    let marker = shape.needs_marker().then(|| quote!(scalar: ::core::marker::PhantomData));
    quote! {
        #[automatically_derived]
        impl #bounds ::core::default::Default for #name #generics {
            fn default() -> Self {
                Self { #(#fields: #defaults,)* #marker }
            }
        }
    }
}

fn state_conversions(shape: &Shape<'_>) -> TokenStream {
    let (state, generics, scalar) = (shape.state_name(), shape.generics(), shape.scalar());
    // Not `Scalar`: a state can be converted whatever its numbers can do.
    let (fields, n) = (shape.state_fields(), shape.coordinates.len());
    let (positions, velocities) = fields.split_at(n);
    let (n, twice) = (length(n), length(2 * n));
    quote! {
        impl #generics #state #generics {
            /// The coordinates in their order.
            #[must_use]
            #[inline]
            pub fn coordinates(self) -> [#scalar; #n] {
                [#(self.#positions),*]
            }

            /// The velocities in the order of the coordinates.
            #[must_use]
            #[inline]
            pub fn velocities(self) -> [#scalar; #n] {
                [#(self.#velocities),*]
            }
        }
        #[automatically_derived]
        impl #generics ::core::convert::From<[#scalar; #twice]> for #state #generics {
            #[inline]
            fn from([#(#fields),*]: [#scalar; #twice]) -> Self {
                Self { #(#fields),* }
            }
        }
        #[automatically_derived]
        impl #generics ::core::convert::From<#state #generics> for [#scalar; #twice] {
            #[inline]
            fn from(state: #state #generics) -> Self {
                [#(state.#fields),*]
            }
        }
    }
}

fn trait_impls(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, n) = (shape.krate, length(shape.coordinates.len()));
    let twice = length(2 * shape.coordinates.len());
    let ArgumentNames { time, positions, velocities, state, .. } = &parts.names;
    let coordinates = shape.coordinates.iter().map(|name| &name.text);
    let has_energy = parts.methods.iter().any(|m| m.name == "energy" && m.arguments == Arguments::State);
    let energy = has_energy.then(|| {
        quote! {
            #[automatically_derived]
            impl #bounds #krate::system::EnergyFunction for #name #generics {
                #[inline]
                fn energy(&self, #time: #scalar, #positions: &[#scalar; #n], #velocities: &[#scalar; #n]) -> #scalar {
                    self.energy(#time, #positions, #velocities)
                }
            }
        }
    });
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::OdeSystem for #name #generics {
            type Scalar = #scalar;
            type State = [#scalar; #twice];
            #[inline]
            fn rhs(&self, #time: #scalar, #state: &[#scalar; #twice]) -> [#scalar; #twice] {
                self.rhs(#time, #state)
            }
        }
        #[automatically_derived]
        impl #bounds #krate::system::MechanicalSystem for #name #generics {
            type Coordinates = [#scalar; #n];
            const COORDINATES: &'static [&'static ::core::primitive::str] = &[#(#coordinates),*];
            #[inline]
            fn acceleration(
                &self,
                #time: #scalar,
                #positions: &[#scalar; #n],
                #velocities: &[#scalar; #n],
            ) -> [#scalar; #n] {
                self.acceleration(#time, #positions, #velocities)
            }
        }
        #energy
    }
}

/// Distinct names for the arguments; the user's names come first.
pub(super) fn argument_names(mut allocate: impl FnMut(&str) -> Ident) -> ArgumentNames {
    let mut either = |short: &str, long: &str| {
        let name = allocate(short);
        if name == short { name } else { allocate(long) }
    };
    ArgumentNames {
        time: either("t", "time"),
        positions: either("q", "positions"),
        velocities: either("v", "velocities"),
        accelerations: either("a", "accelerations"),
        state: either("y", "state"),
    }
}
