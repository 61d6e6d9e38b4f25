//! Columns beside the state.

use std::boxed::Box;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::system::{MechanicalSystem, OdeSystem, WithSuffix};

/// Columns that are computed from time and state.
pub(super) struct Observer<'a, M: MechanicalSystem> {
    pub(super) names: Vec<String>,
    pub(super) extend: Extend<'a, M>,
}

/// Adds one value for each column of an observer to a row.
pub(super) type Extend<'a, M> = Box<
    dyn FnMut(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State, &mut Vec<<M as OdeSystem>::Scalar>)
        + 'a,
>;

/// The names of the state: positions, then velocities.
pub(crate) fn state_names<M: MechanicalSystem>() -> Vec<String> {
    M::COORDINATES.iter().map(ToString::to_string).chain(velocity_names::<M>()).collect()
}

/// The names of the velocities.
fn velocity_names<M: MechanicalSystem>() -> Vec<String> {
    if M::VELOCITIES.is_empty() {
        return M::COORDINATES.iter().map(|name| WithSuffix::velocity(name).to_string()).collect();
    }
    M::VELOCITIES.iter().map(ToString::to_string).collect()
}

/// The names of the accelerations.
pub(super) fn acceleration_names<M: MechanicalSystem>() -> Vec<String> {
    velocity_names::<M>().iter().map(|velocity| WithSuffix::rate_of(velocity).to_string()).collect()
}
