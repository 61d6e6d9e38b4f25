//! Shape of the type for numbers in lanes: its name and its type parameter.

use proc_macro2::Ident;
use quote::format_ident;

use super::shape::{Shape, identifier, local};
use lagrange_algebra::code::Scalar;
use lagrange_language::syntax::ast::ScalarType;

impl Shape<'_> {
    /// Returns the name of the type for numbers in lanes.
    pub(in crate::emit) fn lanes_name(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{}Lanes", name.text, span = name.span)
    }

    /// Returns its type parameter: that of the system, if it has one.
    pub(in crate::emit) fn lanes_number(&self) -> Ident {
        match &self.declaration.scalar {
            ScalarType::Generic(name) => identifier(name),
            ScalarType::F64 | ScalarType::F32 => local("S"),
        }
    }

    /// Returns the number type in the bodies of its methods.
    pub(in crate::emit) fn lanes_computed_with(&self) -> Scalar {
        let is_single = matches!(self.declaration.scalar, ScalarType::F32);
        let is_generic = matches!(self.declaration.scalar, ScalarType::Generic(_));
        Scalar::SideBySide { number: self.lanes_number(), is_single, is_generic }
    }

    /// Returns a type parameter that differs from that of the system.
    pub(in crate::emit) fn other_type_parameter(&self, wish: &str) -> Ident {
        match &self.declaration.scalar {
            ScalarType::Generic(name) if name.text == wish => local(&format!("{wish}_")),
            _ => local(wish),
        }
    }
}
