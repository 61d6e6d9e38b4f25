//! Associated constants: the equations, the order of the fields, the plain statements.

use proc_macro2::TokenStream;
use quote::quote;

use super::units::units_of_parameters;
use crate::emit::base::shape::{Shape, length};

/// Writes the constant with the equations.
pub(in crate::emit) fn equations_latex(equations: &str) -> TokenStream {
    quote! {
        /// The equations of motion in LaTeX, one line for each coordinate after the definitions of
        /// abbreviations, if they need any.
        pub const EQUATIONS_LATEX: &'static ::core::primitive::str = #equations;
    }
}

/// Writes the constant with the order of the fields in derivatives.
pub(in crate::emit) fn parameter_names(shape: &Shape<'_>) -> TokenStream {
    let (names, count) = (shape.fields.iter().map(|name| shape.written(name)), length(shape.fields.len()));
    let units = units_of_parameters(shape);
    quote! {
        /// Parameters, then inputs: the columns of `parameter_jacobian`.
        #units
        pub const PARAMETERS: [&'static ::core::primitive::str; #count] = [#(#names),*];
    }
}

/// Writes the constant with the plain statements.
pub(in crate::emit) fn statements_constant(statements: &str) -> TokenStream {
    quote! {
        /// The declaration in plain statements: without parts, arrays and rigid bodies.
        pub const STATEMENTS: &'static ::core::primitive::str = #statements;
    }
}
