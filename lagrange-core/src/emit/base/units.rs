//! Units of emitted members, in documentation.

use proc_macro2::TokenStream;
use quote::quote;

use super::shape::{Shape, doc};
use lagrange_expr::units::{NamedUnit, component_name};
use lagrange_language::syntax::ast::Name;

/// The unit of plain numbers, which documentation omits.
pub(in crate::emit) const PLAIN: &str = "1";

impl Shape<'_> {
    /// Returns the unit of a declared name or of a velocity, if it is known.
    pub(in crate::emit) fn unit(&self, name: &str) -> Option<&str> {
        self.units.get(name).map(|named| named.unit.as_str())
    }

    /// Writes ` in m` after a name, with its default if this is written in another unit. Empty for
    /// plain numbers and unknown units.
    pub(in crate::emit) fn in_unit(&self, name: &str) -> String {
        match self.units.get(name) {
            Some(NamedUnit { unit, default: Some(default), .. }) if self.is_alike(name) => {
                format!(" in {unit}, {default} by default")
            }
            Some(NamedUnit { unit, .. }) if unit != PLAIN => format!(" in {unit}"),
            _ => String::new(),
        }
    }

    /// True if all elements of the array that a name belongs to have the same unit and default.
    fn is_alike(&self, name: &str) -> bool {
        let mut arrays = self.declaration.arrays.iter().map(|array| &array.elements);
        let array = arrays.find(|elements| elements.iter().any(|element| element.name == name));
        let own = self.units.get(name);
        array.is_none_or(|elements| elements.iter().all(|element| self.units.get(&element.name) == own))
    }

    /// Returns the unit of a component of an output: that of the whole, or its own.
    pub(in crate::emit) fn unit_of_component(&self, output: &str, index: usize) -> Option<&str> {
        self.unit(output).or_else(|| self.unit(&component_name(output, index)))
    }

    /// Returns the user's documentation of a declared name, with its unit, or else `line`.
    pub(in crate::emit) fn docs(&self, name: &Name, line: &str) -> TokenStream {
        match self.users_docs(name) {
            Some(docs) => self.with_unit(docs, name),
            None => doc(line),
        }
    }

    /// Appends the unit of a name to the user's documentation.
    fn with_unit(&self, docs: &TokenStream, name: &Name) -> TokenStream {
        let unit = self.in_unit(&name.text);
        if unit.is_empty() {
            return docs.clone();
        }
        let (blank, unit) = (doc(""), doc(&format!("{}.", unit.trim_start().replacen("in", "In", 1))));
        quote!(#docs #blank #unit)
    }
}
