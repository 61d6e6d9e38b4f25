//! The state of an emitted system as a struct with named fields, and tables of states with named
//! columns.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::fields::{Field, entries, places};
use super::lints::{name_exception, type_name_exception};
use super::method::ArgumentNames;
use super::shape::{Shape, doc, length, local};
use lagrange_algebra::code::Names;

pub(in crate::emit) fn state_struct(shape: &Shape<'_>) -> TokenStream {
    let scalar = shape.scalar_path();
    let positions = if shape.states > 0 { "positions, first-order states" } else { "positions" };
    let title = doc(&format!("State of [`{}`]: {positions}, then velocities.", shape.declaration.name.text));
    let entries = shape.coordinates.iter().copied().chain(shape.velocities.iter().map(|v| &v.name));
    let mut entries = entries.zip(lines(shape));
    let fields = shape.state_fields().into_iter().filter_map(|field| {
        let (name, line) = entries.by_ref().take(field.names.len()).collect::<Vec<_>>().into_iter().next()?;
        let Line { text, is_component } = line.of(&field);
        let (users, blank, own) = (shape.docs(name, &text), doc(""), doc(&text));
        // The documentation of an orientation does not distinguish its components.
        let docs = if is_component && shape.is_documented(name) { quote!(#users #blank #own) } else { users };
        let (identifier, of_type) = (&field.identifier, field.type_of(&scalar));
        Some(quote!(#docs pub #identifier: #of_type,))
    });
    named_values(shape, &title, &shape.state_name(), &fields.collect())
}

/// Returns a struct of numbers under their names.
pub(in crate::emit) fn named_values(
    shape: &Shape<'_>,
    title: &TokenStream,
    name: &Ident,
    fields: &TokenStream,
) -> TokenStream {
    let (generics, visibility) = (shape.generics(), &shape.declaration.visibility);
    let (names, type_name) = (name_exception(shape), type_name_exception(shape));
    let allow = (!generics.is_empty()).then(
        || quote!(#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]),
    );
    quote! {
        #title
        #names
        #type_name
        #allow
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #name #generics {
            #fields
        }
    }
}

/// Returns the conversions of such a struct from and to an array, given a variable for each number.
pub(in crate::emit) fn array_conversions(
    shape: &Shape<'_>,
    (name, value): (&Ident, &Ident),
    fields: &[Field],
    variables: &[Ident],
) -> TokenStream {
    let (generics, scalar, count) = (shape.generics(), shape.scalar(), length(variables.len()));
    let (copied, places) = (shape.copied_generics(fields), places(fields));
    let values = variables.iter().map(|variable| quote!(#variable)).collect::<Vec<_>>();
    let entries = entries(fields, &values);
    quote! {
        #[automatically_derived]
        impl #generics ::core::convert::From<[#scalar; #count]> for #name #generics {
            #[inline]
            fn from([#(#variables),*]: [#scalar; #count]) -> Self {
                Self { #(#entries),* }
            }
        }
        #[automatically_derived]
        impl #copied ::core::convert::From<#name #generics> for [#scalar; #count] {
            #[inline]
            fn from(#value: #name #generics) -> Self {
                [#(#value.#places),*]
            }
        }
    }
}

pub(in crate::emit) fn state_conversions(shape: &Shape<'_>) -> TokenStream {
    let (state, generics, scalar) = (shape.state_name(), shape.generics(), shape.scalar());
    // No `Scalar` bound: a state can be converted for any number type.
    let fields = shape.state_fields();
    let (places, copied) = (places(&fields), shape.copied_generics(&fields));
    let (positions, velocities) = places.split_at(shape.coordinates.len());
    let (nq, nv) = (shape.positions_length(), shape.velocities_length());
    let conversions =
        array_conversions(shape, (&state, &format_ident!("state")), &fields, &state_variables(shape));
    let positions_docs = match shape.states {
        0 => doc("The coordinates in their order."),
        _ => doc("The coordinates in their order, then the states."),
    };
    quote! {
        impl #copied #state #generics {
            #positions_docs
            #[must_use]
            #[inline]
            pub fn coordinates(self) -> [#scalar; #nq] {
                [#(self.#positions),*]
            }

            /// The velocities in their order.
            #[must_use]
            #[inline]
            pub fn velocities(self) -> [#scalar; #nv] {
                [#(self.#velocities),*]
            }
        }
        #conversions
    }
}

/// The documentation of an entry of the state.
struct Line {
    text: String,
    /// True for components of quaternions and of angular velocities.
    is_component: bool,
}

impl Line {
    /// Documents a whole field by its first entry.
    fn of(self, field: &Field) -> Line {
        let Some(first) = field.names.first().filter(|_| field.is_array()) else { return self };
        let (of_one, of_all) = (first.text.as_str(), field.identifier.to_string());
        let coordinate = |name: &str| name.strip_suffix("_dot").unwrap_or(name).to_owned();
        let text =
            self.text.replace(&format!("`{}`", coordinate(of_one)), &format!("`{}`", coordinate(&of_all)));
        let text = text.replace("Coordinate ", "Coordinates ").replace("State ", "States ");
        let text = text.replace("Velocity of", "Velocities of");
        Line { text, ..self }
    }
}

/// Returns a line about each entry of the state.
fn lines(shape: &Shape<'_>) -> Vec<Line> {
    let positions = shape.coordinates.iter().enumerate().map(|(index, name)| {
        let first = shape.quaternions.iter().find(|first| (**first..**first + 4).contains(&index));
        let text = match first {
            None if shape.is_state(index) => format!("State `{}`{}.", name.text, shape.in_unit(&name.text)),
            None => format!("Coordinate `{}`{}.", name.text, shape.in_unit(&name.text)),
            Some(&first) if first == index => "Scalar part of a unit quaternion.".to_owned(),
            Some(_) => "Component of the vector part of a unit quaternion.".to_owned(),
        };
        Line { text, is_component: first.is_some() }
    });
    let velocities = shape.velocities.iter().map(|velocity| match velocity.coordinate {
        Some(coordinate) => {
            let unit = shape.in_unit(&velocity.name.text);
            Line { text: format!("Velocity of `{}`{unit}.", coordinate.text), is_component: false }
        }
        None => {
            let text = "Component of an angular velocity along the turned axes, in rad/s.".to_owned();
            Line { text, is_component: true }
        }
    });
    positions.chain(velocities).collect()
}

/// Returns local variables for the entries of a state.
pub(in crate::emit) fn state_variables(shape: &Shape<'_>) -> Vec<Ident> {
    let mut names = Names::default();
    shape.state_names().iter().map(|name| names.fresh(&name.text)).collect()
}

/// Writes a struct around a table, so that its columns can be methods.
pub(in crate::emit) fn columns_struct(shape: &Shape<'_>) -> TokenStream {
    let (name, visibility) = (shape.columns_name(), &shape.declaration.visibility);
    let title = doc(&format!("Columns of a table of states of [`{}`].", shape.declaration.name.text));
    let type_name = type_name_exception(shape);
    quote! {
        #title
        #type_name
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        #visibility struct #name<C>(C);
    }
}

pub(in crate::emit) fn columns_impls(shape: &Shape<'_>) -> TokenStream {
    let (name, krate, columns) = (shape.columns_name(), shape.krate, columns(shape));
    quote! {
        impl<C: #krate::system::Columns> #name<C> {
            #(#columns)*
        }
        #[automatically_derived]
        impl<C> ::core::convert::From<C> for #name<C> {
            #[inline]
            fn from(columns: C) -> Self {
                Self(columns)
            }
        }
        #[automatically_derived]
        impl<C> ::core::convert::AsRef<C> for #name<C> {
            #[inline]
            fn as_ref(&self) -> &C {
                &self.0
            }
        }
    }
}

/// Writes a method for each field of the state; for an array it takes indices.
fn columns(shape: &Shape<'_>) -> Vec<TokenStream> {
    let (mut lines, mut first) = (lines(shape).into_iter(), 0);
    let columns = shape.state_fields().into_iter().filter_map(|field| {
        let line = lines.by_ref().take(field.names.len()).collect::<Vec<_>>().into_iter().next()?.of(&field);
        let number = first;
        first += field.names.len();
        // The location is the user's but the hygiene is the macro's, so that unused columns cause
        // no warnings.
        let name =
            Ident::new(&field.identifier.to_string(), Span::mixed_site().located_at(field.identifier.span()));
        let docs = doc(&line.text);
        let (docs, (arguments, index)) = match field.is_array() {
            true => {
                let panics = ["", "# Panics", "", "If an index is out of range."].map(doc);
                (quote!(#docs #(#panics)*), indexed(&field, number))
            }
            false => (docs, (TokenStream::new(), length(number).into_token_stream())),
        };
        Some(quote! {
            #docs
            #[must_use]
            #[inline]
            pub fn #name(&self #arguments) -> &[C::Scalar] {
                self.0.column(#index)
            }
        })
    });
    columns.collect()
}

/// Returns arguments for the indices of an array, and the number of the element's column. The
/// emitted code panics if an index is out of range.
fn indexed(field: &Field, first: usize) -> (TokenStream, TokenStream) {
    let mut names = Names::default();
    let indices = field.sizes.iter().map(|_| names.fresh("index")).collect::<Vec<_>>();
    let mut index = TokenStream::new();
    for (size, name) in field.sizes.iter().zip(&indices) {
        let size = length(*size);
        index = match index.is_empty() {
            true => quote!(#name),
            false => quote!((#index) * #size + #name),
        };
    }
    let (first, sizes) = (length(first), field.sizes.iter().map(|size| length(*size)));
    let message = "an index is out of range";
    let arguments = quote!(#(, #indices: ::core::primitive::usize)*);
    (arguments, quote!({ ::core::assert!(#(#indices < #sizes)&&*, #message); #first + #index }))
}

/// Writes ẏ = [v, a], where `system` gives the rates of the positions.
pub(in crate::emit) fn rhs(shape: &Shape<'_>, names: &ArgumentNames, system: &TokenStream) -> TokenStream {
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
        quote!(let #rates = #system.position_rates(#time, &[#(#positions),*], &[#(#velocities),*]);)
    });
    let docs = shape.rates_docs(line);
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
