//! Columns in addition to the state.

use std::boxed::Box;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::system::{
    ControlledSystem, Description, EnergyFunction, MechanicalSystem, ScalarOf, State, WithSuffix, split,
};

/// A function that adds one value for each column of an observer to a row.
pub(crate) type Extend<'a, M> = Box<dyn FnMut(&M, ScalarOf<M>, &State<M>, &mut Vec<ScalarOf<M>>) + 'a>;

/// Returns a function that adds values at positions and velocities to a row.
pub(crate) fn columns_of<M: MechanicalSystem, T: AsRef<[ScalarOf<M>]>>(
    values: impl Fn(&M, ScalarOf<M>, &M::Coordinates, &M::Velocities) -> T,
) -> impl Fn(&M, ScalarOf<M>, &State<M>, &mut Vec<ScalarOf<M>>) {
    move |system, t, y, row| {
        let (q, v) = split::<M>(y);
        row.extend_from_slice(values(system, t, &q, &v).as_ref());
    }
}

/// Returns the energy as a column.
pub(crate) fn energy<M: EnergyFunction>(
    system: &M,
    t: ScalarOf<M>,
    q: &M::Coordinates,
    v: &M::Velocities,
) -> [ScalarOf<M>; 1] {
    [system.energy(t, q, v)]
}

/// Returns the inputs as columns.
pub(crate) fn inputs<M: ControlledSystem>(
    system: &M,
    _t: ScalarOf<M>,
    _q: &M::Coordinates,
    _v: &M::Velocities,
) -> M::InputVector {
    system.inputs().into()
}

/// Returns the names of the state: positions, then velocities.
pub(crate) fn state_names(system: &Description) -> impl Iterator<Item = String> + use<> {
    system.coordinates.iter().map(ToString::to_string).chain(velocity_names(system))
}

/// Returns the names of the velocities.
fn velocity_names(system: &Description) -> Vec<String> {
    if system.velocities_are_rates() {
        return system.coordinates.iter().map(|name| WithSuffix::velocity(name).to_string()).collect();
    }
    system.velocities.iter().map(ToString::to_string).collect()
}

/// Returns the names of the accelerations.
pub(super) fn acceleration_names(system: &Description) -> Vec<String> {
    velocity_names(system).iter().map(|velocity| WithSuffix::rate_of(velocity).to_string()).collect()
}
