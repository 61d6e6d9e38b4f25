//! Names of displacements, first-order states and velocities.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::linalg::dense::DenseMatrix;
use crate::system::{Component, Description, LinearisedSystem, MatrixLayout, WithSuffix};

/// All displacements, first-order states and velocities, as combinations of the states of a linear
/// model.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Components {
    pub(super) names: Vec<String>,
    /// Number of displacements, which come first.
    pub(super) displacements: usize,
    /// A row for each component, and a column for each state.
    pub(super) basis: DenseMatrix,
}

/// Names of all rows and columns of a system matrix.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Names {
    /// Names of the state.
    pub(super) state: &'static Description,
    /// Names of inputs, outputs and constraints.
    pub(super) beyond: MatrixLayout,
}

impl Names {
    pub(super) fn of<M: LinearisedSystem>(system: &M) -> Names {
        Names { state: system.description(), beyond: system.layout() }
    }

    /// Returns the number of velocities.
    pub(super) fn freedoms(&self) -> usize {
        if self.state.velocities_are_rates() {
            self.state.coordinates.len()
        } else {
            self.state.velocities.len()
        }
    }

    /// Returns the index of the first of the first-order states among the positions.
    pub(super) fn first_state(&self) -> usize {
        self.state.coordinates.len() - self.state.first_order_states
    }

    /// Returns the names of displacements, first-order states and velocities, in this order.
    pub(super) fn tangent(&self) -> Vec<String> {
        let displacements = (0..self.freedoms()).map(|index| self.displacement(index));
        let states = &self.state.coordinates[self.first_state()..];
        let velocities = (0..self.freedoms()).map(|index| self.velocity(index));
        displacements.chain(states.iter().map(ToString::to_string)).chain(velocities).collect()
    }

    /// Returns the name of the coordinate that a displacement changes, or of the rotation.
    fn displacement(&self, index: usize) -> String {
        if self.state.velocities_are_rates() {
            return self.state.coordinates[index].to_string();
        }
        match self.state.rates_of[index] {
            "" => format!("rotation({})", self.state.velocities[index]),
            coordinate => coordinate.to_string(),
        }
    }

    fn velocity(&self, index: usize) -> String {
        match Component::of_velocity(self.state, index) {
            Some(Component::Velocity(coordinate)) => WithSuffix::velocity(coordinate).to_string(),
            _ => self.state.velocities[index].to_string(),
        }
    }

    /// Returns the names and the indices of the constraints that contain positions.
    pub(super) fn holonomic(&self) -> impl Iterator<Item = (usize, &'static str)> {
        let constraints = self.beyond.constraints.iter().zip(self.beyond.are_holonomic).enumerate();
        constraints.filter(|(_, (_, is_holonomic))| **is_holonomic).map(|(index, (name, _))| (index, *name))
    }
}
