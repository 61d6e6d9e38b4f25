//! Clocks: times at equal distances at which a declaration assigns new values to its state.
//!
//! The clock of the period T ticks at the integer multiples of T. A run that starts on one begins
//! with that tick; a run that ends on one leaves it to the next run. For T = 0.1, a run from 0 to
//! 0.3 ticks at 0, 0.1 and 0.2, and the next run at 0.3.

use crate::scalar::Scalar;

/// Returns the shortest of these periods; NaN if any of them is NaN.
pub fn shortest_period<S: Scalar>(periods: impl IntoIterator<Item = S>) -> Option<S> {
    let is_nan = |number: S| number.partial_cmp(&number).is_none();
    periods.into_iter().reduce(|one, other| if is_nan(one) || one < other { one } else { other })
}

/// Returns the first tick after `t` and before `end` of clocks with these periods.
pub fn next_tick<S: Scalar>(t: S, end: S, periods: impl IntoIterator<Item = S>) -> Option<S> {
    let next = periods.into_iter().filter_map(|period| tick_after(t, period));
    next.filter(|tick| *tick < end).reduce(S::min)
}

/// Returns the earlier of two times, if there is one.
pub fn earlier<S: Scalar>(one: Option<S>, other: Option<S>) -> Option<S> {
    [one, other].into_iter().flatten().reduce(S::min)
}

/// True if the clock with this period ticks at `t`.
pub fn ticks<S: Scalar>(t: S, period: S) -> bool {
    let nearest = count(t.abs() / period + S::from_f64(0.5));
    nearest.is_some_and(|count| count * period == t.abs())
}

/// Returns the first multiple of a period after `t`. Quotients are rounded, so neighbouring
/// multiples are tried.
fn tick_after<S: Scalar>(t: S, period: S) -> Option<S> {
    let passed = count(t.abs() / period)? * t.sign();
    let tick = |offset| (passed + S::from_f64(offset)) * period;
    [-1.0, 0.0, 1.0, 2.0].map(tick).into_iter().find(|tick| *tick > t)
}

/// Returns the integer below a nonnegative number.
fn count<S: Scalar>(number: S) -> Option<S> {
    number.floor_below(usize::MAX).map(|count| S::from_f64(count as f64))
}

#[cfg(test)]
mod tests {
    use super::{next_tick, shortest_period, ticks};

    #[test]
    fn ticks_are_multiples_of_the_period() {
        for period in [0.1, 1.0 / 3.0, 1e-3, 7.0, 1e9] {
            let mut t = -3.0 * period;
            for k in -2..1000 {
                let next = next_tick(t, f64::INFINITY, [period]).expect("a tick");
                assert_eq!(next, f64::from(k) * period);
                assert!(ticks(next, period) && ticks(next, 2.0 * period) == (k % 2 == 0));
                assert!(!ticks(next + 0.3 * period, period));
                assert_eq!(next_tick(t + 0.7 * period, f64::INFINITY, [period]), Some(next));
                t = next;
            }
        }
    }

    #[test]
    fn the_earliest_of_several_clocks_is_next() {
        assert_eq!(next_tick(0.0, 1.0, [0.3, 0.2]), Some(0.2));
        assert_eq!(next_tick(0.2, 1.0, [0.3, 0.2]), Some(0.3));
        assert_eq!(next_tick(0.0_f32, 0.2, [0.3, 0.2]), None);
        assert_eq!(shortest_period([0.3, 0.2]), Some(0.2));
        assert!(shortest_period([0.3, f64::NAN, 0.2]).is_some_and(f64::is_nan));
    }
}
