//! Numbers of all types as sums of two doubles, and errors in them.

use std::vec::Vec;

use crate::scalar::Scalar;

/// A number as the sum of two doubles, the second of which is at most a rounding error of the
/// first.
pub(super) type Digits = [f64; 2];

/// Returns a number of any type, exactly up to 106 bits.
pub(super) fn split<S: Scalar + Into<f64>>(number: S) -> Digits {
    let upper = number.into();
    [upper, (number - S::from_f64(upper)).into()]
}

/// Computes the largest error of a component, in units of its size; NaN stays NaN. Components of
/// the state beyond the reference do not count, sizes that are missing are one.
pub(super) fn error(state: &[Digits], reference: &[Digits], sizes: &[f64]) -> f64 {
    let sizes = sizes.iter().copied().chain(core::iter::repeat(1.0));
    let errors = state.iter().zip(reference).zip(sizes).map(|((found, exact), size)| {
        let [upper, lower] = [0, 1].map(|part| found[part] - exact[part]);
        ((upper + lower) / size).abs()
    });
    errors.fold(0.0, |largest, error| if error <= largest { largest } else { error })
}

/// Returns the numbers of a state.
pub(super) fn split_all<S: Scalar + Into<f64>>(state: &[S]) -> Vec<Digits> {
    state.iter().copied().map(split).collect()
}
