//! Fields of emitted structs: numbers, and arrays of them for declared arrays.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::shape::{Shape, identifier, length};
use lagrange_expr::collections::HashMap;
use lagrange_language::syntax::ast::{DeclaredArray, Name};
use lagrange_language::syntax::print;

/// A field for several names, or for one.
#[derive(Clone)]
pub(in crate::emit) struct Field {
    pub(in crate::emit) identifier: Ident,
    /// Numbers of elements in each dimension; empty for a number.
    pub(in crate::emit) sizes: Vec<usize>,
    /// Its names, the last index changing fastest.
    pub(in crate::emit) names: Vec<Name>,
}

impl Field {
    fn of_number(name: &Name) -> Field {
        Field { identifier: identifier(name), sizes: Vec::new(), names: vec![name.clone()] }
    }

    /// True for an array.
    pub(in crate::emit) fn is_array(&self) -> bool {
        !self.sizes.is_empty()
    }

    /// Returns the type of the field.
    pub(in crate::emit) fn type_of(&self, scalar: &TokenStream) -> TokenStream {
        let arrays = self.sizes.iter().rev();
        arrays.fold(scalar.clone(), |element, size| {
            let size = length(*size);
            quote!([#element; #size])
        })
    }

    /// Writes the field in a literal or a pattern of the struct, with values or patterns for its
    /// names.
    pub(in crate::emit) fn with(&self, values: &[TokenStream]) -> TokenStream {
        let field = &self.identifier;
        let value = self.nested(values);
        if *field == value.to_string() { quote!(#value) } else { quote!(#field: #value) }
    }

    fn nested(&self, values: &[TokenStream]) -> TokenStream {
        let mut level = values.to_vec();
        for size in self.sizes.iter().rev() {
            level = level.chunks(*size).map(|row| quote!([#(#row),*])).collect();
        }
        quote!(#(#level)*)
    }

    /// Returns the names as they are written, such as `theta[2]` for an element of an array.
    pub(in crate::emit) fn written(&self) -> Vec<String> {
        self.places().iter().map(|place| place.to_string().replace(' ', "")).collect()
    }

    /// Returns the place of each name in the struct: `theta[2]` after a dot.
    pub(in crate::emit) fn places(&self) -> Vec<TokenStream> {
        let field = &self.identifier;
        let place = |number: usize| {
            let mut rest = number;
            let mut indices = self.sizes.iter().rev().map(|size| {
                let index = length(rest % size);
                rest /= size;
                quote!([#index])
            });
            let mut indices = indices.by_ref().collect::<Vec<_>>();
            indices.reverse();
            quote!(#field #(#indices)*)
        };
        (0..self.names.len()).map(place).collect()
    }
}

/// Splits the indices at the end from the written name of an element: `leg[0].foot` and `[2]`.
pub(in crate::emit) fn split_indices(written: &str) -> (&str, &str) {
    let member = written.rfind('.').unwrap_or(0);
    written.split_at(written[member..].find('[').map_or(written.len(), |bracket| member + bracket))
}

/// Returns fields for names in this order: arrays if all names of an array are consecutive, numbers
/// otherwise. No two fields have the same name.
pub(in crate::emit) fn fields(names: &[&Name], arrays: &[DeclaredArray]) -> Vec<Field> {
    let firsts = arrays.iter().filter_map(|array| Some((array.elements.first()?.name.clone(), array)));
    let firsts = firsts.collect::<HashMap<_, _>>();
    let mut fields = Vec::new();
    let mut rest = names;
    while let [first, ..] = rest {
        let array = firsts.get(&first.text).and_then(|array| as_field(array, rest));
        let field = array.unwrap_or_else(|| Field::of_number(first));
        rest = rest.get(field.names.len()..).unwrap_or_default();
        fields.push(field);
    }
    without_clashes(fields)
}

/// Returns the field for an array, if its elements come first among these names.
fn as_field(array: &DeclaredArray, names: &[&Name]) -> Option<Field> {
    let sizes = array.sizes.clone()?;
    let own = names.get(..array.elements.len())?;
    let are_elements = own.iter().zip(&array.elements).all(|(name, element)| name.text == element.name);
    let names = || own.iter().map(|name| (*name).clone()).collect();
    are_elements.then(|| Field { identifier: identifier(&array.name), sizes, names: names() })
}

/// Splits arrays whose name clashes with another field.
fn without_clashes(fields: Vec<Field>) -> Vec<Field> {
    let mut counts: HashMap<String, usize> = HashMap::default();
    for field in &fields {
        *counts.get_or_insert_with(field.identifier.to_string(), || 0) += 1;
    }
    let is_alone = |field: &Field| counts.get(&field.identifier.to_string()) == Some(&1);
    let apart = |field: Field| match field.is_array() && !is_alone(&field) {
        true => field.names.iter().map(Field::of_number).collect(),
        false => vec![field],
    };
    fields.into_iter().flat_map(apart).collect()
}

/// Writes the entries of a literal or a pattern of a struct with these fields, from values or
/// patterns for all names in order.
pub(in crate::emit) fn entries(fields: &[Field], values: &[TokenStream]) -> Vec<TokenStream> {
    let mut rest = values;
    let entries = fields.iter().map(|field| {
        let (own, others) = rest.split_at(field.names.len().min(rest.len()));
        rest = others;
        field.with(own)
    });
    entries.collect()
}

/// Returns the place of each name in a struct with these fields.
pub(in crate::emit) fn places(fields: &[Field]) -> Vec<TokenStream> {
    fields.iter().flat_map(Field::places).collect()
}

impl Shape<'_> {
    /// Returns the fields for these parameters and inputs.
    pub(in crate::emit) fn fields_of(&self, names: &[&Name]) -> Vec<Field> {
        fields(names, &self.declaration.arrays)
    }

    /// Returns the fields of all parameters and inputs.
    pub(in crate::emit) fn number_fields(&self) -> Vec<Field> {
        self.fields_of(&self.fields)
    }

    /// Writes the declarations of the fields for these parameters and inputs, with documentation.
    pub(in crate::emit) fn declared_fields(&self, names: &[&Name], number: &TokenStream) -> TokenStream {
        let declared = self.fields_of(names).into_iter().filter_map(|field| {
            let (name, first) = (&field.identifier, field.names.first()?);
            let plural = if field.is_array() { "s" } else { "" };
            let (kind, unit) = (self.kind_of_field(first), self.in_unit(&first.text));
            let range = self.in_range(first);
            let docs = self.docs(first, &format!("{kind}{plural} `{name}`{unit}{range}."));
            let of_type = field.type_of(number);
            Some(quote!(#docs pub #name: #of_type,))
        });
        declared.collect()
    }

    /// Returns the range of a parameter for documentation; empty if it has none.
    fn in_range(&self, name: &Name) -> String {
        let range = self.ranges.get(&name.text.as_str());
        let printed = range.map(|range| print::range(&self.declaration.expressions, range));
        printed.map_or_else(String::new, |range| format!(", `{range}`"))
    }

    /// Returns the identifiers of the fields of parameters and inputs.
    pub(in crate::emit) fn number_identifiers(&self) -> Vec<Ident> {
        self.number_fields().into_iter().map(|field| field.identifier).collect()
    }

    /// Writes the selected fields in a literal of the struct with their values in `self`. This
    /// includes fields of modes, and the marker if there is one.
    pub(in crate::emit) fn kept_fields(&self, keeps: impl Fn(&Name) -> bool) -> TokenStream {
        let kept = self.fields.iter().copied().filter(|name| keeps(name)).collect::<Vec<_>>();
        let modes = self.fields_of_modes().filter(|name| keeps(name)).map(identifier);
        let fields = self.fields_of(&kept).into_iter().map(|field| field.identifier).chain(modes);
        let marker = self.needs_marker().then(|| quote!(scalar: ::core::marker::PhantomData,));
        let fields = fields.map(|field| quote!(#field: self.#field,)).collect::<TokenStream>();
        quote!(#fields #marker)
    }
}
