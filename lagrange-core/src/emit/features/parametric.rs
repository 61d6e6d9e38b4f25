//! `ParametricSystem`: parameters and inputs by index, and derivatives with respect to them.

use proc_macro2::TokenStream;
use quote::quote;

use super::constrained::is_projected;
use super::switches::kept_switches;
use crate::emit::base::fields::places;
use crate::emit::base::members::Members;
use crate::emit::base::method::ArgumentNames;
use crate::emit::base::shape::{Shape, length, local};
use crate::model::Product;

/// Writes the implementation of `ParametricSystem`.
pub(in crate::emit) fn parametric_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let krate = shape.krate;
    let (index, value, other) = (local("index"), local("value"), local("other"));
    let names = shape.fields.iter().map(|name| shape.written(name));
    let places = places(&shape.number_fields());
    let arms = places.iter().enumerate().map(|(place, field)| {
        let place = length(place);
        quote!(#place => #other.#field = #value,)
    });
    let (kept, switches) = (shape.kept_fields(|_| true), kept_switches(shape));
    let with_number = match places.is_empty() {
        true => quote! {
            fn with_number(&self, _: ::core::primitive::usize, _: #scalar) -> Self {
                Self { #kept #switches }
            }
        },
        false => quote! {
            fn with_number(&self, #index: ::core::primitive::usize, #value: #scalar) -> Self {
                let mut #other = Self { #kept #switches };
                match #index {
                    #(#arms)*
                    _ => {}
                }
                #other
            }
        },
    };
    let derivatives = derivatives(shape, members);
    let adjoint = correct_adjoint(shape, members);
    let kinks = members.has_kinks.then(|| {
        quote! {
            fn has_kinks(&self) -> ::core::primitive::bool {
                true
            }
        }
    });
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::ParametricSystem for #name #generics {
            const NUMBERS: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            fn number(&self, #index: ::core::primitive::usize) -> ::core::option::Option<#scalar> {
                <[#scalar]>::get(&[#(self.#places),*], #index).copied()
            }
            #with_number
            #derivatives
            #adjoint
            #kinks
        }
    }
}

/// Writes the member that differentiates projections onto constraints, if there are any.
fn correct_adjoint(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let (slope, indices, by) = (local("slope"), local("indices"), local("by"));
    (is_projected(shape, members) && shape.touching.is_empty()).then(|| {
        quote! {
            fn correct_adjoint(
                &self,
                #time: #scalar,
                #state: &[#scalar; #all],
                #slope: &mut [#scalar; #all],
                #indices: &[::core::primitive::usize],
                #by: &mut [#scalar],
            ) -> ::core::primitive::bool {
                #krate::constraint::correct_adjoint(self, #time, #state, #slope, #indices, #by)
            }
        }
    })
}

/// Writes the member that returns columns of `parameter_jacobian`, if this method is emitted.
fn derivatives(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let (indices, columns) = (local("indices"), local("columns"));
    let is_emitted = |method: &crate::emit::base::method::Method| {
        method.name == Product::ParameterJacobian.name() && !shape.fields.is_empty()
    };
    members.methods.iter().any(is_emitted).then(|| {
        quote! {
            fn derivatives(
                &self,
                #time: #scalar,
                #state: &[#scalar; #all],
                #indices: &[::core::primitive::usize],
                #columns: &mut [[#scalar; #all]],
            ) -> ::core::primitive::bool {
                #krate::system::pick_columns(&self.parameter_jacobian(#time, #state), #indices, #columns);
                true
            }
        }
    })
}
