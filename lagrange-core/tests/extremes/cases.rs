//! Sizes of sweeps.

use std::env;

/// Returns the number of cases: `usual`, times `LAGRANGE_EXTREMES` if that is set.
pub(crate) fn cases(usual: usize) -> usize {
    let factor = env::var("LAGRANGE_EXTREMES").ok();
    usual * factor.map_or(1, |factor| factor.parse().expect("LAGRANGE_EXTREMES is a whole number"))
}
