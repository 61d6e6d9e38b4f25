//! Shape of the state of an emitted system: the number of its positions and velocities, and their
//! names.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::fields::{Field, fields};
use super::shape::{Shape, identifier, length};
use lagrange_expr::collections::HashSet;
use lagrange_language::syntax::ast::{ArrayElement, DeclaredArray, Name, ScalarType, StateVelocity};

impl Shape<'_> {
    /// Number of positions, as the length of an array.
    pub(in crate::emit) fn positions_length(&self) -> Literal {
        length(self.coordinates.len())
    }

    /// Number of velocities, as the length of an array.
    pub(in crate::emit) fn velocities_length(&self) -> Literal {
        length(self.velocities.len())
    }

    /// Number of entries of the state, as the length of an array.
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

    /// True if names of velocities must be said, since they do not follow from those of the
    /// positions.
    pub(in crate::emit) fn names_velocities(&self) -> bool {
        let has_states = self.states > 0;
        has_states
            || self.velocities.iter().any(|velocity| match velocity.coordinate {
                Some(coordinate) => velocity.name.text != format!("{}_dot", coordinate.text),
                None => true,
            })
    }

    /// Index of the coordinate that a velocity is the rate of.
    pub(in crate::emit) fn position_of(&self, velocity: &StateVelocity<'_>) -> Option<usize> {
        let coordinate = velocity.coordinate?;
        self.coordinates.iter().position(|name| std::ptr::eq(*name, coordinate))
    }

    /// Names of the entries of the state: positions, then velocities.
    pub(in crate::emit) fn state_names(&self) -> Vec<Name> {
        let positions = self.coordinates.iter().map(|name| (*name).clone());
        let taken = self.coordinates.iter().map(|name| name.text.as_str()).collect::<HashSet<_>>();
        let velocities = self.velocities.iter().map(|velocity| {
            let mut name = velocity.name.clone();
            // Where that is a coordinate, which is a mistake, the skeleton has another field.
            while taken.contains(name.text.as_str()) {
                name.text.push('_');
            }
            name
        });
        positions.chain(velocities).collect()
    }

    /// Fields of the state.
    pub(in crate::emit) fn state_fields(&self) -> Vec<Field> {
        let names = self.state_names();
        let arrays = &self.declaration.arrays;
        let arrays = arrays.iter().cloned().chain(arrays.iter().map(rates)).collect::<Vec<_>>();
        fields(&names.iter().collect::<Vec<_>>(), &arrays)
    }

    /// `<S: Copy>` or nothing, for conversions of states and inputs: what is in an array is copied
    /// out of it.
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

/// The array of the rates of another one.
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
