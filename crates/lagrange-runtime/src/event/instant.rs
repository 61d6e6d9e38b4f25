//! Times in a step that cannot be distinguished.

use super::locate::ACCURACY;
use crate::scalar::Scalar;

/// The accuracy of numbers wider than `f64`, in roundings of the length of a step.
const ROUNDINGS: f64 = 512.0;
/// Roundings of time below this fraction of a step are fine enough for any event.
const FINE: f64 = 1.0 / 1024.0;
/// Coarser ones are fine enough if the function changes per rounding by at most this fraction of
/// its largest magnitude.
const LARGEST_CHANGE: f64 = 1.0 / 64.0;

/// Returns the accuracy to which zeros within a step are located.
pub(super) fn accuracy<S: Scalar>(from: S, to: S) -> S {
    S::from_f64(ACCURACY).min(S::from_f64(ROUNDINGS) * S::epsilon()) * (to - from).abs()
}

/// True if two times in a step cannot be distinguished.
pub(crate) fn is_at_once<S: Scalar>(one: S, other: S, from: S, to: S) -> bool {
    (one - other).abs() <= instant(one, from, to)
}

/// Returns the last time in a step that cannot be distinguished from this one.
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

/// Returns the distance up to which times in a step cannot be distinguished.
fn instant<S: Scalar>(time: S, from: S, to: S) -> S {
    let rounding = S::from_f64(4.0) * S::epsilon() * time.abs();
    accuracy(from, to) + accuracy(from, to) + rounding
}

/// Returns the rounding of time if it is too coarse to locate the event of a function in a step.
/// The function had magnitudes up to `range` before.
///
/// A function that jumps does so between two times; only the change before them counts.
pub(super) fn unresolved<S: Scalar>(
    (from, to): (S, S),
    time: S,
    range: S,
    value: &mut dyn FnMut(S) -> S,
) -> Option<S> {
    let rounding = (to - from).sign() * S::epsilon() * time.abs();
    if rounding.abs() <= S::from_f64(FINE) * (to - from).abs() || range == S::ZERO {
        return None;
    }
    let before = time - (rounding + rounding);
    let earlier = if (before - from) * rounding > S::ZERO { before } else { from };
    let later = earlier + rounding;
    let change = (value(later) - value(earlier)).abs();
    (change > S::from_f64(LARGEST_CHANGE) * range).then(|| (later - earlier).abs())
}
