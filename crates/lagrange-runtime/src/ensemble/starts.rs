//! The number of motions and their starts.

use std::vec::Vec;

use crate::simulate::InitialState;
use crate::system::MechanicalSystem;

/// The source of an ensemble: a number of motions, whose starts
/// [`start`](crate::ensemble::Motions::start) defines, or a list of starts as a vector, slice or
/// array. Collect an iterator into a vector.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is neither a number of motions nor a list of starts",
    note = "for example `system.ensemble(1000)`, or `system.ensemble(starts)` with a vector of states; collect an iterator into one"
)]
pub trait Starts<M: MechanicalSystem> {
    /// Returns the number of motions, and their starts if these are specified.
    fn into_starts(self) -> (usize, Option<Vec<M::State>>);
}

impl<M: MechanicalSystem> Starts<M> for usize {
    fn into_starts(self) -> (usize, Option<Vec<M::State>>) {
        (self, None)
    }
}

impl<M: MechanicalSystem, Y: InitialState<M::State>> Starts<M> for Vec<Y> {
    fn into_starts(self) -> (usize, Option<Vec<M::State>>) {
        (self.len(), Some(self.into_iter().map(InitialState::into_state).collect()))
    }
}

impl<M: MechanicalSystem, Y: InitialState<M::State>, const N: usize> Starts<M> for [Y; N] {
    fn into_starts(self) -> (usize, Option<Vec<M::State>>) {
        (N, Some(self.into_iter().map(InitialState::into_state).collect()))
    }
}

impl<M: MechanicalSystem, Y: InitialState<M::State> + Clone> Starts<M> for &[Y] {
    fn into_starts(self) -> (usize, Option<Vec<M::State>>) {
        Starts::<M>::into_starts(self.to_vec())
    }
}

impl<M: MechanicalSystem, Y: InitialState<M::State> + Clone> Starts<M> for &Vec<Y> {
    fn into_starts(self) -> (usize, Option<Vec<M::State>>) {
        Starts::<M>::into_starts(self.to_vec())
    }
}
