//! Names and types of a shape as they stand in emitted code.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::Shape;
use crate::model::Product;
use lagrange_algebra::code::Scalar;
use lagrange_language::syntax::ast::{Name, ScalarType};

impl Shape<'_> {
    /// The struct's name.
    pub(in crate::emit) fn name(&self) -> Ident {
        identifier(&self.declaration.name)
    }

    /// The name of the struct of states.
    pub(in crate::emit) fn state_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}State", name.text, span = name.span)
    }

    /// The name of the struct of columns.
    pub(in crate::emit) fn columns_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}Columns", name.text, span = name.span)
    }

    /// The name of the prepared type.
    pub(in crate::emit) fn prepared_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}Prepared", name.text, span = name.span)
    }

    /// The number type where the user's scope decides what a bare name means.
    pub(in crate::emit) fn scalar_path(&self) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::F64 => quote!(::core::primitive::f64),
            ScalarType::F32 => quote!(::core::primitive::f32),
            ScalarType::Generic(name) => {
                let name = identifier(name);
                quote!(#name)
            }
        }
    }

    /// The number type inside the block that holds the implementations.
    pub(in crate::emit) fn scalar(&self) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::F64 => quote!(f64),
            ScalarType::F32 => quote!(f32),
            ScalarType::Generic(_) => self.scalar_path(),
        }
    }

    /// The number type that bodies of methods compute with.
    pub(in crate::emit) fn computed_with(&self) -> Scalar {
        match &self.declaration.scalar {
            ScalarType::F64 => Scalar::F64,
            ScalarType::F32 => Scalar::F32,
            ScalarType::Generic(name) => Scalar::Generic(identifier(name)),
        }
    }

    /// `<S>` or nothing.
    pub(in crate::emit) fn generics(&self) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::Generic(name) => {
                let name = identifier(name);
                quote!(<#name>)
            }
            _ => TokenStream::new(),
        }
    }

    /// `<S: Scalar>` or nothing.
    pub(in crate::emit) fn bounds(&self) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::Generic(name) => {
                let (name, krate) = (identifier(name), self.krate);
                quote!(<#name: #krate::Scalar>)
            }
            _ => TokenStream::new(),
        }
    }
}

/// The user's identifier, at the user's place.
pub(in crate::emit) fn identifier(name: &Name) -> Ident {
    Ident::new(&name.text, name.span)
}

/// An identifier that only generated code sees.
pub(in crate::emit) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// A line of documentation, spaced as if it followed three slashes.
pub(in crate::emit) fn doc(line: &str) -> TokenStream {
    let line = if line.is_empty() { String::new() } else { format!(" {line}") };
    quote!(#[doc = #line])
}

/// The length of an array, as people write it.
pub(in crate::emit) fn length(length: usize) -> Literal {
    Literal::usize_unsuffixed(length)
}

/// The name of the method that says how a body moves.
pub(in crate::emit) fn motion_name(body: &Name) -> Ident {
    method_of(body, Product::Motion)
}

/// The name of a method that a product has for each body or frame.
pub(in crate::emit) fn method_of(body: &Name, product: Product) -> Ident {
    let suffix = product.method_suffix().unwrap_or_default();
    Ident::new(&format!("{}{suffix}", body.text), body.span)
}
