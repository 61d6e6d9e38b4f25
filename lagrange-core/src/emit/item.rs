//! The items of an emitted system: the struct, its state, implementations and traits.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::method::{ArgumentNames, Arguments, Method};
use super::shape::{Shape, identifier, local};

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
    let (attributes, visibility) = (&declaration.attributes, &declaration.visibility);
    let (name, generics, scalar) = (shape.name(), shape.generics(), shape.scalar_path());
    let docs = &parts.docs;
    let field_docs = shape.fields.iter().map(|name| shape.docs(name, &format!("Parameter `{}`.", name.text)));
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
        #attributes
        #(#[doc = #docs])*
        #visibility struct #name #generics #body
    }
}

fn state_struct(shape: &Shape<'_>) -> TokenStream {
    let (name, generics, scalar) = (shape.state_name(), shape.generics(), shape.scalar_path());
    let visibility = &shape.declaration.visibility;
    let title = format!("State of [`{}`]: coordinates, then velocities.", shape.declaration.name.text);
    let docs =
        shape.coordinates.iter().map(|name| shape.docs(name, &format!("Coordinate `{}`.", name.text))).chain(
            shape.coordinates.iter().map(|name| {
                let line = format!("Velocity of `{}`.", name.text);
                quote!(#[doc = #line])
            }),
        );
    let fields = shape.state_fields();
    quote! {
        #[doc = #title]
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
            clippy::approx_constant,
            clippy::excessive_precision,
            clippy::many_single_char_names,
            clippy::similar_names,
            clippy::suboptimal_flops,
            clippy::too_many_lines,
            clippy::trivially_copy_pass_by_ref,
            clippy::unused_self,
            reason = "generated: every method has the arguments that its kind of quantity can depend on, \
                      and the names and numbers of the formulas"
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
    let (twice, fields) = (2 * n, shape.state_fields());
    let (positions, velocities) = fields.split_at(n);
    let ArgumentNames { time, state, accelerations, .. } = names;
    let indices = 0..n;
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
    let (twice, (positions, velocities)) = (2 * n, fields.split_at(n));
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
    let (krate, n) = (shape.krate, shape.coordinates.len());
    let twice = 2 * n;
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
    ArgumentNames {
        time: allocate("t"),
        positions: allocate("q"),
        velocities: allocate("v"),
        accelerations: allocate("a"),
        state: allocate("y"),
    }
}
