//! Jacobi's elliptic functions by the arithmetic–geometric mean.
//!
//! Source: Abramowitz, Stegun, *Handbook of Mathematical Functions*, 16.4 and 17.6.

use core::f64::consts::FRAC_PI_2;

/// Functions of one modulus k, given by k² and 1 − k², so that small values of either keep their
/// digits.
pub(crate) struct Elliptic {
    square: f64,
    complement: f64,
    /// The means aₙ with cₙ = ½ (aₙ₋₁ − bₙ₋₁), where c₀ = k.
    means: Vec<(f64, f64)>,
}

impl Elliptic {
    pub(crate) fn new(square: f64, complement: f64) -> Elliptic {
        let (mut a, mut b) = (1.0, complement.sqrt());
        let mut means = vec![(a, square.sqrt())];
        let mut difference = 1.0;
        // The next difference would be its square.
        while difference > 1e-9 * a {
            difference = 0.5 * (a - b);
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            means.push((a, difference));
        }
        Elliptic { square, complement, means }
    }

    /// Returns the quarter period, K = π / 2a.
    pub(crate) fn quarter(&self) -> f64 {
        FRAC_PI_2 / self.means[self.means.len() - 1].0
    }

    /// Returns sn u, cn u, dn u.
    pub(crate) fn functions(&self, u: f64) -> [f64; 3] {
        let steps = self.means.len() - 1;
        let last = f64::from(1 << steps) * self.means[steps].0 * u;
        let amplitude = self.means[1..]
            .iter()
            .rev()
            .fold(last, |phase: f64, (a, c)| 0.5 * (phase + (c / a * phase.sin()).asin()));
        let (sn, cn) = amplitude.sin_cos();
        [sn, cn, (self.complement + self.square * cn * cn).sqrt()]
    }
}

/// Values by mpmath, `ellipk` and `ellipfun` with m = 0.81 at u = 7/4.
const QUARTER: f64 = 2.280_549_138_422_770_2;
const KNOWN: [f64; 3] = [0.971_325_976_186_824_7, 0.237_751_651_907_430_47, 0.485_577_941_084_247_26];

#[test]
fn elliptic_functions_are_those_of_a_table() {
    let functions = Elliptic::new(0.81, 0.19);
    assert!((functions.quarter() - QUARTER).abs() < 1e-15 * QUARTER);
    for (found, known) in functions.functions(1.75).into_iter().zip(KNOWN) {
        assert!((found - known).abs() < 2e-15, "{found}, not {known}");
    }
}
