//! Times in a step that cannot be told apart.

use super::locate::ACCURACY;
use crate::scalar::Scalar;

/// To which part of a step, or of time, zeros within it are located.
pub(super) fn accuracy<S: Scalar>(from: S, to: S) -> S {
    S::from_f64(ACCURACY) * (to - from).abs()
}

/// True if two times in a step cannot be told apart.
pub(crate) fn is_at_once<S: Scalar>(one: S, other: S, from: S, to: S) -> bool {
    (one - other).abs() <= instant(one, from, to)
}

/// Returns the last time in a step that cannot be told from this one.
pub(crate) fn end_of_instant<S: Scalar>(time: S, from: S, to: S) -> S {
    let width = instant(time, from, to);
    if (to - time).abs() <= width {
        to
    } else if to < from {
        time - width
    } else {
        time + width
    }
}

/// Returns the distance up to which times in a step cannot be told apart.
fn instant<S: Scalar>(time: S, from: S, to: S) -> S {
    let rounding = S::from_f64(4.0) * S::epsilon() * time.abs();
    accuracy(from, to) + accuracy(from, to) + rounding
}
