//! The items of an emitted system: the struct, its state, implementations and traits.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::method::{ArgumentNames, Arguments, Method};
use super::rust_body::Names;
use super::shape::{Shape, doc, identifier, length, local};

/// Everything that differs between a derived system and a skeleton.
pub(super) struct Parts {
    /// Documentation of the struct, after the user's own.
    pub(super) docs: Vec<String>,
    /// The body of `Default::default`, if all defaults are known.
    pub(super) default: Option<TokenStream>,
    pub(super) methods: Vec<Method>,
    /// Associated constants.
    pub(super) constants: TokenStream,
    pub(super) names: ArgumentNames,
    /// Functions of `lagrange::private` that the methods call.
    pub(super) functions: BTreeSet<&'static str>,
    /// Whether the methods hold rounded values of irrational constants.
    pub(super) has_rounded_constants: bool,
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
    let names = name_exception(shape);
    let rounded = parts.has_rounded_constants.then(
        || quote!(#[allow(clippy::approx_constant, reason = "constants are rounded to the scalar once")]),
    );
    quote! {
        #system
        #state
        #names
        #rounded
        const _: () = {
            #import
            #functions
            #(#implementations)*
            #conversions
            #traits
        };
    }
}

/// Lets names keep the letters that they have in formulas.
fn name_exception(shape: &Shape<'_>) -> Option<TokenStream> {
    let names =
        shape.fields.iter().chain(&shape.coordinates).chain(shape.outputs.iter().map(|(name, _)| name));
    let is_snake_case = |name: &str| !name.contains(char::is_uppercase) && !name.contains("__");
    let exception =
        quote!(#[allow(non_snake_case, reason = "symbols keep the letters they have in formulas")]);
    (!{ names }.all(|name| is_snake_case(&name.text))).then_some(exception)
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
    let names = name_exception(shape);
    let unused = shape.fields.iter().any(|name| name.text.starts_with('_'));
    let unused = unused.then(|| {
        quote!(#[allow(clippy::pub_underscore_fields, reason = "the user marked the parameter as unused")])
    });
    quote! {
        #(#docs)*
        #(#attributes)*
        #names
        #unused
        #visibility struct #name #generics #body
    }
}

/// The lines of documentation and the other attributes.
pub(super) fn split_attributes(attributes: &TokenStream) -> (Vec<TokenStream>, Vec<TokenStream>) {
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
    let (fields, names) = (shape.state_fields(), name_exception(shape));
    let allow = (!generics.is_empty()).then(
        || quote!(#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]),
    );
    quote! {
        #title
        #names
        #allow
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #name #generics {
            #(#docs pub #fields: #scalar,)*
        }
    }
}

fn inherent_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let methods = parts.methods.iter().map(|method| method.tokens(shape, &parts.names));
    let (constants, rhs) = (&parts.constants, rhs(shape, &parts.names));
    quote! {
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
    let (twice, variables) = (length(2 * n), state_variables(shape));
    let (positions, velocities) = variables.split_at(n);
    let ArgumentNames { time, state, accelerations, .. } = names;
    let indices = (0..n).map(length);
    quote! {
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, #time: #scalar, #state: &[#scalar; #twice]) -> [#scalar; #twice] {
            let [#(#variables),*] = *#state;
            let #accelerations = self.acceleration(#time, &[#(#positions),*], &[#(#velocities),*]);
            [#(#velocities,)* #(#accelerations[#indices]),*]
        }
    }
}

fn default_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let Some(default) = &parts.default else { return TokenStream::new() };
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

fn state_conversions(shape: &Shape<'_>) -> TokenStream {
    let (state, generics, scalar) = (shape.state_name(), shape.generics(), shape.scalar());
    // Not `Scalar`: a state can be converted whatever its numbers can do.
    let (fields, n) = (shape.state_fields(), shape.coordinates.len());
    let (positions, velocities) = fields.split_at(n);
    let (n, twice) = (length(n), length(2 * n));
    let variables = state_variables(shape);
    let entries = fields.iter().zip(&variables).map(|(field, variable)| match field == variable {
        true => quote!(#variable),
        false => quote!(#field: #variable),
    });
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
            fn from([#(#variables),*]: [#scalar; #twice]) -> Self {
                Self { #(#entries),* }
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

/// Local variables for the entries of a state.
fn state_variables(shape: &Shape<'_>) -> Vec<Ident> {
    let mut names = Names::default();
    shape.state_fields().iter().map(|field| names.fresh(&field.to_string())).collect()
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
