//! Function values that are indistinguishable from rounding of the state.

use crate::scalar::Scalar;
use crate::system::StateVector;
use crate::tolerance::{SAME_EVENT, SURFACE};

/// Step of the factors, from one half to one, by which changes of state entries differ, so that
/// equal changes do not cancel.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Returns the state with each entry changed by a few roundings, each by a different amount.
pub(crate) fn rounded<S: Scalar, Y: StateVector<S>>(y: &Y) -> Y {
    let (mut rounded, mut part) = (*y, 0.5);
    for entry in rounded.as_mut() {
        part = (part + GOLDEN) % 1.0;
        *entry = *entry + S::from_f64(0.5 + 0.5 * part) * SURFACE.part::<S>() * entry.abs();
    }
    rounded
}

/// True if a function is as small at this state as it changes by when entries are rounded. Hops end
/// there where places are rounded more coarsely than times: 3.7 m below the origin those that are
/// lower than 10⁻¹³ m.
pub(super) fn is_rounding<S: Scalar, Y: StateVector<S>>(state: &Y, value: &mut dyn FnMut(&Y) -> S) -> bool {
    let here = value(state);
    let change = |entry: usize| {
        let mut rounded = *state;
        let size = state.as_ref()[entry].abs();
        rounded.as_mut()[entry] = state.as_ref()[entry] + SAME_EVENT.part::<S>() * size;
        (value(&rounded) - here).abs()
    };
    here.abs() <= (0..state.as_ref().len()).map(change).fold(S::ZERO, |sum, change| sum + change)
}
