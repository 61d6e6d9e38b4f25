//! Derivatives of functions by differences of order four.
//!
//! Events have no emitted derivatives, and their outcomes may be closures. The step is the fifth
//! root of the rounding error. Errors are then about the rounding error divided by the step:
//! 3·10⁻¹³ in double precision. Source: Fornberg, "Generation of finite difference formulas on
//! arbitrarily spaced grids", 1988.

use crate::linalg::vector::{StateVector, add, difference};
use crate::scalar::Scalar;

/// Rules with entries (w, [a, b]): the derivative is the sum of w (f(a h) − f(b h)), divided by 12
/// h. For constants it is exactly zero.
type Differences = &'static [(f64, [f64; 2])];

const AROUND: Differences = &[(8.0, [1.0, -1.0]), (-1.0, [2.0, -2.0])];
const ASIDE: Differences = &[(48.0, [1.0, 0.0]), (-36.0, [2.0, 0.0]), (16.0, [3.0, 0.0]), (-3.0, [4.0, 0.0])];

/// Divisor of the step, applied until two successive results agree.
const REFINEMENT: f64 = 8.0;
/// Maximum number of refinements.
const MAX_REFINEMENTS: usize = 4;

/// Returns the derivative at zero of a function of one number. The function is assumed to change
/// noticeably when its argument changes by 1/`rate`. The step is reduced if it changes faster.
/// Differences are one-sided if the function is undefined on the other side; `None` if it is
/// undefined on both.
pub(crate) fn slope<S: Scalar, V: StateVector<S>>(
    rate: S,
    mut function: impl FnMut(S) -> Option<V>,
) -> Option<V> {
    if rate == S::ZERO {
        return Some(V::ZERO);
    }
    let mut step = S::epsilon().powf(S::from_f64(0.2)) / rate;
    let mut best = differences(step, rate, &mut function)?;
    let (agreement, mut least) = (S::epsilon().powf(S::from_f64(0.7)), S::ONE / S::ZERO);
    let mut last = best;
    for _ in 0..MAX_REFINEMENTS {
        step = step / S::from_f64(REFINEMENT);
        let finer = differences(step, rate, &mut function)?;
        let change = distance(&last, &finer);
        if change < least {
            (least, best) = (change, last);
        }
        if change <= agreement * distance(&last, &last.zeros()) {
            break;
        }
        last = finer;
    }
    Some(best)
}

/// Rounding of the argument moves a function by this many roundings times its change over a step,
/// per step in units of 1/rate. A difference below that is zero: its digits would be arbitrary, and
/// so would be a quotient with it. That of x³ at 10⁻¹⁶, for instance, is 10⁻¹³ of its change.
const ROUNDINGS: f64 = 4.0;

/// Computes the differences with this step.
fn differences<S: Scalar, V: StateVector<S>>(
    step: S,
    rate: S,
    function: &mut impl FnMut(S) -> Option<V>,
) -> Option<V> {
    let least = S::from_f64(ROUNDINGS) * S::epsilon() / (rate * step);
    let mut slopes = |rule: Differences, step: S| {
        let mut sums: Option<[V; 2]> = None;
        for &(weight, places) in rule {
            let [ahead, behind] = places.map(|place| function(S::from_f64(place) * step));
            let change = difference(&ahead?, &behind?);
            let [sum, largest] = sums.get_or_insert([change.zeros(); 2]);
            add(sum, S::from_f64(weight), &change);
            for (largest, change) in largest.as_mut().iter_mut().zip(change.as_ref()) {
                *largest = largest.max(change.abs());
            }
        }
        let [mut slopes, largest] = sums?;
        for (slope, largest) in slopes.as_mut().iter_mut().zip(largest.as_ref()) {
            let difference = *slope / S::from_f64(12.0);
            *slope = if difference.abs() <= least * *largest { S::ZERO } else { difference / step };
        }
        Some(slopes)
    };
    { slopes(AROUND, step) }.or_else(|| slopes(ASIDE, step)).or_else(|| slopes(ASIDE, -step))
}

/// Returns the largest distance between two corresponding entries.
fn distance<S: Scalar, V: StateVector<S>>(one: &V, other: &V) -> S {
    difference(one, other).as_ref().iter().fold(S::ZERO, |most, entry| most.max(entry.abs()))
}

#[cfg(test)]
mod tests {
    use super::slope;

    #[test]
    fn a_fast_function_is_looked_at_more_closely() {
        let [fast] = slope(1.0, |x: f64| Some([(3.0 + 100.0 * x).sin()])).unwrap();
        assert!((fast / (100.0 * 3.0_f64.cos()) - 1.0).abs() < 1e-10, "{fast}");
    }

    #[test]
    fn a_flat_function_has_no_slope() {
        assert_eq!(slope(1.0, |x: f64| Some([(1.0 + 2e-16 + x - 1.0).powi(3)])), Some([0.0]));
        let [steep] = slope(1.0, |x: f64| Some([x.powi(3) + 1e-9 * x])).unwrap();
        assert!((steep / 1e-9 - 1.0).abs() < 1e-9, "{steep}");
    }

    #[test]
    fn slopes_are_accurate_around_a_point_and_at_the_end_of_a_domain() {
        let exact = 1.0_f64.cos();
        let [around] = slope(1.0, |x: f64| Some([(1.0 + x).sin()])).unwrap();
        assert!((around - exact).abs() < 3e-12, "{around}");
        let [before] = slope(1.0, |x: f64| (x <= 0.0).then(|| [(1.0 + x).sin()])).unwrap();
        assert!((before - exact).abs() < 3e-11, "{before}");
        assert_eq!(slope(1.0, |x: f64| (x == 0.0).then_some([x])), None);
    }
}
