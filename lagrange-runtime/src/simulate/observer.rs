//! Columns beside the state.

use std::boxed::Box;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::system::{MechanicalSystem, OdeSystem};

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

impl<M: MechanicalSystem> Observer<'_, M> {
    /// The names of the state: coordinates, then velocities.
    pub(super) fn state_names() -> Vec<String> {
        let names = M::COORDINATES.iter().map(ToString::to_string);
        let rates = M::COORDINATES.iter().map(|name| format!("{name}_dot"));
        names.chain(rates).collect()
    }
}
