//! Location of a change of sign of a function.
//!
//! Regula falsi with halved weights (Illinois), and bisection whenever three rounds do not halve
//! the bracket. Source: Dowell, Jarratt, "A modified regula falsi method", *BIT* 11 (1971) 168–174.

use crate::scalar::Scalar;

/// Accuracy of a zero relative to the length of its step, limited by the spacing of times.
pub(super) const ACCURACY: f64 = 1e-13;
/// Maximum number of evaluations.
pub(super) const MOST_ROUNDS: u32 = 200;

/// An argument and the value of the function.
pub(super) type Sample<S> = (S, S);

/// Returns an argument in the bracket at which the function has the sign of `after`, at most
/// `accuracy` beyond a change of sign.
///
/// `None` if it is not found in [`MOST_ROUNDS`] evaluations, or a value is NaN.
pub(crate) fn locate<S: Scalar>(
    mut before: Sample<S>,
    mut after: Sample<S>,
    accuracy: S,
    value: &mut dyn FnMut(S) -> S,
) -> Option<S> {
    let half = S::from_f64(0.5);
    let mut width = (after.0 - before.0).abs();
    for round in 0..MOST_ROUNDS {
        if (after.0 - before.0).abs() <= accuracy {
            return Some(after.0);
        }
        let middle = before.0 + half * (after.0 - before.0);
        if middle == before.0 || middle == after.0 {
            return Some(after.0);
        }
        let mut at = middle;
        if round % 3 != 0 || (after.0 - before.0).abs() <= half * width {
            let chord = after.0 - after.1 * (after.0 - before.0) / (after.1 - before.1);
            at = if is_inside(chord, before.0, after.0) { chord } else { middle };
        }
        if round % 3 == 0 {
            width = (after.0 - before.0).abs();
        }
        let found = value(at);
        if found * after.1 > S::ZERO {
            after = (at, found);
            before.1 = half * before.1;
        } else if found * before.1 > S::ZERO {
            before = (at, found);
            after.1 = half * after.1;
        } else if found == S::ZERO {
            return Some(at);
        } else {
            return None;
        }
    }
    None
}

fn is_inside<S: Scalar>(x: S, a: S, b: S) -> bool {
    (a < x && x < b) || (b < x && x < a)
}
