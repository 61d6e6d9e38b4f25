//! Shape of the state of an emitted system: how many positions and velocities it has, and what they are called.

use proc_macro2::{Ident, Literal};

use super::shape::{Shape, identifier, length};
use crate::syntax::ast::StateVelocity;

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
        self.quaternions.is_empty()
    }

    /// True if velocities have names of their own.
    pub(in crate::emit) fn names_velocities(&self) -> bool {
        self.velocities.iter().any(|velocity| match velocity.coordinate {
            Some(coordinate) => velocity.name.text != format!("{}_dot", coordinate.text),
            None => true,
        })
    }

    /// Index of the coordinate that a velocity is the rate of.
    pub(in crate::emit) fn position_of(&self, velocity: &StateVelocity<'_>) -> Option<usize> {
        let coordinate = velocity.coordinate?;
        self.coordinates.iter().position(|name| std::ptr::eq(*name, coordinate))
    }

    /// Fields of the state: positions, then velocities.
    pub(in crate::emit) fn state_fields(&self) -> Vec<Ident> {
        let positions = self.coordinates.iter().map(|name| identifier(name));
        let velocities = self.velocities.iter().map(|velocity| {
            let mut name = velocity.name.clone();
            // Where that is a coordinate, which is a mistake, the skeleton has another field.
            while self.coordinates.iter().any(|other| other.text == name.text) {
                name.text.push('_');
            }
            identifier(&name)
        });
        positions.chain(velocities).collect()
    }
}
