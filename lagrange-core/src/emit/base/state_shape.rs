//! Shape of the state of an emitted system: the numbers and names of its positions and velocities.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::fields::{Field, fields};
use super::shape::{Shape, identifier, length};
use lagrange_expr::collections::HashSet;
use lagrange_language::syntax::ast::{ArrayElement, DeclaredArray, Name, ScalarType, StateVelocity};

impl Shape<'_> {
    /// Returns the number of positions as an array length.
    pub(in crate::emit) fn positions_length(&self) -> Literal {
        length(self.coordinates.len())
    }

    /// Returns the number of velocities as an array length.
    pub(in crate::emit) fn velocities_length(&self) -> Literal {
        length(self.velocities.len())
    }

    /// Returns the number of entries of the state as an array length.
    pub(in crate::emit) fn state_length(&self) -> Literal {
        length(self.coordinates.len() + self.velocities.len())
    }

    /// True if velocities are the rates of the positions.
    pub(in crate::emit) fn velocities_are_rates(&self) -> bool {
        self.quaternions.is_empty() && self.states == 0
    }

    /// True if a position is a first-order state.
    pub(in crate::emit) fn is_state(&self, position: usize) -> bool {
        position + self.states >= self.coordinates.len()
    }

    /// True if velocities need explicit names, since these do not follow from those of the
    /// positions.
    pub(in crate::emit) fn names_velocities(&self) -> bool {
        let has_states = self.states > 0;
        has_states
            || self.velocities.iter().any(|velocity| match velocity.coordinate {
                Some(coordinate) => velocity.name.text != format!("{}_dot", coordinate.text),
                None => true,
            })
    }

    /// Returns the index of the coordinate that a velocity is the rate of.
    pub(in crate::emit) fn position_of(&self, velocity: &StateVelocity<'_>) -> Option<usize> {
        let coordinate = velocity.coordinate?;
        self.coordinates.iter().position(|name| std::ptr::eq(*name, coordinate))
    }

    /// Returns the names of the entries of the state: positions, then velocities.
    pub(in crate::emit) fn state_names(&self) -> Vec<Name> {
        let positions = self.coordinates.iter().map(|name| (*name).clone());
        let taken = self.coordinates.iter().map(|name| name.text.as_str()).collect::<HashSet<_>>();
        let velocities = self.velocities.iter().map(|velocity| {
            let mut name = velocity.name.clone();
            // If it is also the name of a coordinate, which is an error, the skeleton has a
            // different field.
            while taken.contains(name.text.as_str()) {
                name.text.push('_');
            }
            name
        });
        positions.chain(velocities).collect()
    }

    /// Returns the fields of the state.
    pub(in crate::emit) fn state_fields(&self) -> Vec<Field> {
        let names = self.state_names();
        let arrays = &self.declaration.arrays;
        let arrays = arrays.iter().cloned().chain(arrays.iter().map(rates)).collect::<Vec<_>>();
        fields(&names.iter().collect::<Vec<_>>(), &arrays)
    }

    /// Returns `<S: Copy>` or nothing, for conversions of states and inputs: numbers in arrays are
    /// copied.
    pub(in crate::emit) fn copied_generics(&self, fields: &[Field]) -> TokenStream {
        match &self.declaration.scalar {
            ScalarType::Generic(name) if fields.iter().any(Field::is_array) => {
                let name = identifier(name);
                quote!(<#name: ::core::marker::Copy>)
            }
            _ => self.generics(),
        }
    }
}

/// Returns the array of the rates of another one.
fn rates(array: &DeclaredArray) -> DeclaredArray {
    let rate =
        |element: &ArrayElement| ArrayElement { name: format!("{}_dot", element.name), ..element.clone() };
    DeclaredArray {
        name: Name::new(format!("{}_dot", array.name.text), array.name.span),
        sizes: array.sizes.clone(),
        elements: array.elements.iter().map(rate).collect(),
        member_of: array.member_of.clone(),
    }
}
