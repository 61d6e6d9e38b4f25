//! Names and types of a shape, as emitted code spells them.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::Shape;
use crate::model::BodyMethod;
use lagrange_algebra::code::Scalar;
use lagrange_language::syntax::ast::{Name, ScalarType};

impl Shape<'_> {
    /// Returns the name of the struct.
    pub(in crate::emit) fn name(&self) -> Ident {
        identifier(&self.declaration.name)
    }

    /// Returns the name of the struct of states.
    pub(in crate::emit) fn state_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}State", name.text, span = name.span)
    }

    /// Returns the name of the struct of columns.
    pub(in crate::emit) fn columns_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}Columns", name.text, span = name.span)
    }

    /// Returns the name of the prepared type.
    pub(in crate::emit) fn prepared_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}Prepared", name.text, span = name.span)
    }

    /// Returns the path of the number type, for code in which the user's scope resolves bare names.
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

    /// Returns the number type inside the block with the implementations.
    pub(in crate::emit) fn scalar(&self) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::F64 => quote!(f64),
            ScalarType::F32 => quote!(f32),
            ScalarType::Generic(_) => self.scalar_path(),
        }
    }

    /// Returns the number type in the bodies of methods.
    pub(in crate::emit) fn computed_with(&self) -> Scalar {
        match &self.declaration.scalar {
            ScalarType::F64 => Scalar::F64,
            ScalarType::F32 => Scalar::F32,
            ScalarType::Generic(name) => Scalar::Generic(identifier(name)),
        }
    }

    /// Returns `<S>` or nothing.
    pub(in crate::emit) fn generics(&self) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::Generic(name) => {
                let name = identifier(name);
                quote!(<#name>)
            }
            _ => TokenStream::new(),
        }
    }

    /// Returns `<S: Scalar>` or nothing.
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

/// Returns the user's identifier with the user's span.
pub(in crate::emit) fn identifier(name: &Name) -> Ident {
    Ident::new(&name.text, name.span)
}

/// Returns an identifier that is only visible to generated code.
pub(in crate::emit) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// Returns a line of documentation, spaced as if it followed three slashes.
pub(in crate::emit) fn doc(line: &str) -> TokenStream {
    let line = if line.is_empty() { String::new() } else { format!(" {line}") };
    quote!(#[doc = #line])
}

/// Returns the length of an array as a literal without a suffix.
pub(in crate::emit) fn length(length: usize) -> Literal {
    Literal::usize_unsuffixed(length)
}

/// Returns the name of the method for the motion of a body.
pub(in crate::emit) fn motion_name(body: &Name) -> Ident {
    method_of(body, BodyMethod::Motion)
}

/// Returns the name of a method for a body or frame.
pub(in crate::emit) fn method_of(body: &Name, method: BodyMethod) -> Ident {
    Ident::new(&method.name(&body.text), body.span)
}
