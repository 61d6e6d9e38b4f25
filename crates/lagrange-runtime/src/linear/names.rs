//! Names of displacements, first-order states and velocities.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::linalg::dense::DenseMatrix;
use crate::system::{Component, MechanicalSystem, StateVector, WithSuffix, description_of_type};

/// All displacements, first-order states and velocities, as combinations of the states of a linear
/// model.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Components {
    pub(super) names: Vec<String>,
    /// Number of displacements, which are the first.
    pub(super) displacements: usize,
    /// A row for each, and a column for each state.
    pub(super) basis: DenseMatrix,
}

/// Number of velocities of a system.
pub(super) fn freedoms<M: MechanicalSystem>() -> usize {
    M::Velocities::ZERO.as_ref().len()
}

/// Names of displacements, first-order states and velocities, in this order.
pub(super) fn tangent_names<M: MechanicalSystem>() -> Vec<String> {
    let displacements = (0..freedoms::<M>()).map(displacement_name::<M>);
    let states = &M::COORDINATES[M::COORDINATES.len() - M::FIRST_ORDER_STATES..];
    let velocities = (0..freedoms::<M>()).map(velocity_name::<M>);
    displacements.chain(states.iter().map(ToString::to_string)).chain(velocities).collect()
}

/// The name of the coordinate that a displacement changes, or of the rotation.
fn displacement_name<M: MechanicalSystem>(index: usize) -> String {
    if description_of_type::<M>().velocities_are_rates() {
        return M::COORDINATES[index].to_string();
    }
    match M::RATES_OF[index] {
        "" => format!("rotation({})", M::VELOCITIES[index]),
        coordinate => coordinate.to_string(),
    }
}

fn velocity_name<M: MechanicalSystem>(index: usize) -> String {
    match Component::of_velocity(description_of_type::<M>(), index) {
        Some(Component::Velocity(coordinate)) => WithSuffix::velocity(coordinate).to_string(),
        _ => M::VELOCITIES[index].to_string(),
    }
}
