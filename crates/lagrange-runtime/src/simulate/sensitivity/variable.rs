//! Variables by which motions are differentiated.

use crate::scalar::{Number, Scalar};
use crate::system::ParametricSystem;

/// A parameter, input or initial value by which a motion is differentiated.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Varied<S> {
    /// Name of the variable.
    pub(super) name: &'static str,
    pub(super) place: VariedPlace,
    /// Derivatives are stored as changes of the state per change of the variable by this amount.
    pub(super) scale: S,
    /// The scale as a relative change of the variable.
    pub(super) weight: S,
}

/// The place of a variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum VariedPlace {
    /// A parameter or an input, by its index.
    Number(usize),
    /// An entry of the initial state, by its index.
    Initial(usize),
}

impl<S: Scalar> Varied<S> {
    /// Returns the entry of the state with this index and name.
    pub(in crate::simulate) fn initial<M: ParametricSystem<Scalar = S>>(
        name: &'static str,
        index: usize,
        system: &M,
        state: &M::State,
    ) -> Self {
        Varied { name, place: VariedPlace::Initial(index), scale: S::ONE, weight: S::ONE }
            .scaled(system, state)
    }

    /// Returns the change of the variable that counts as one.
    pub(in crate::simulate) fn scale(&self) -> S {
        self.scale
    }

    /// Returns the index of a parameter or input; `None` for an entry of the state.
    pub(in crate::simulate) fn number(&self) -> Option<usize> {
        match self.place {
            VariedPlace::Number(index) => Some(index),
            VariedPlace::Initial(_) => None,
        }
    }

    /// Returns the relative change of the variable, which is one, or of the state.
    pub(super) fn part<const N: usize>(&self, change: &[S; N], state: &[S; N]) -> S {
        let largest = |x: &[S; N]| x.iter().fold(S::ZERO, |most, entry| most.max(entry.abs()));
        match self.place {
            VariedPlace::Number(_) => S::ONE,
            VariedPlace::Initial(_) => largest(change) / largest(state).max(S::epsilon().powi(4)),
        }
    }

    /// Returns the variable scaled by its value in a motion, or by one if that is zero.
    pub(super) fn scaled<M: ParametricSystem<Scalar = S>>(self, system: &M, start: &M::State) -> Self {
        let value = match self.place {
            VariedPlace::Number(index) => system.number(index),
            VariedPlace::Initial(index) => start.as_ref().get(index).copied(),
        };
        let size = value.map_or(S::ONE, Number::abs);
        let size = if size > S::ZERO && size.is_finite() { size } else { S::ONE };
        Varied { scale: self.weight * size, ..self }
    }
}
