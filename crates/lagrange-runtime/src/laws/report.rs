//! The deviations found by a check.

use core::fmt::{self, Display, Formatter, LowerExp};
use std::string::String;
use std::vec::Vec;

use crate::scalar::Scalar;

/// Part of the terms, as a power of ε, below which a deviation counts as rounding and truncation.
const TOLERANCE: f64 = 3.0 / 8.0;

/// A law in one state.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding<S> {
    /// Its name.
    pub name: String,
    /// Magnitude of the quantity that should be zero.
    pub deviation: S,
    /// Sum of the magnitudes of its terms.
    pub scale: S,
    /// Largest deviation that counts as zero.
    pub tolerance: S,
    /// False if differences with two steps disagree, as next to a corner, or are not finite.
    pub is_judged: bool,
}

impl<S: Scalar> Finding<S> {
    /// Creates the law that the sum of these terms, each accurate to `noise`, is zero.
    pub(super) fn new(name: String, terms: &[S], noise: S) -> Finding<S> {
        let sum = terms.iter().fold(S::ZERO, |sum, &term| sum + term);
        Finding::of(name, sum.abs(), terms, noise)
    }

    /// Creates the law that a deviation is zero relative to these terms.
    pub(super) fn of(name: String, deviation: S, terms: &[S], noise: S) -> Finding<S> {
        let scale = terms.iter().fold(S::ZERO, |sum, term| sum + term.abs());
        let room = S::from_f64(64.0) * noise;
        let tolerance = S::epsilon().powf(S::from_f64(TOLERANCE)).multiply_add(scale, room);
        Finding { name, deviation, scale, tolerance, is_judged: (deviation + scale).is_finite() }
    }

    /// Returns the law with half the step, judged if the full step agrees.
    pub(super) fn compared(self, fine: Finding<S>) -> Finding<S> {
        let room = self.tolerance.max(fine.tolerance);
        let differ = (self.deviation - fine.deviation).abs().max((self.scale - fine.scale).abs());
        let agree = differ <= room;
        let is_judged = self.is_judged && fine.is_judged && agree;
        Finding { is_judged, ..fine }
    }

    /// True unless it is judged and its deviation exceeds the tolerance.
    pub fn holds(&self) -> bool {
        !self.is_judged || self.deviation <= self.tolerance
    }
}

impl<S: LowerExp> Display for Finding<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Finding { name, deviation, scale, is_judged, .. } = self;
        match is_judged {
            true => write!(f, "{name}: {deviation:.1e} beside terms of {scale:.1e}"),
            false => write!(f, "{name}: not judged, its derivatives jump nearby"),
        }
    }
}

/// The laws of a system in one state.
#[derive(Clone, PartialEq, Debug)]
pub struct Report<S> {
    /// Lagrange's equations, the energy, its balance and the rows of the Jacobian.
    pub laws: Vec<Finding<S>>,
}

impl<S: Scalar> Report<S> {
    /// True if no law is broken.
    pub fn holds(&self) -> bool {
        self.laws.iter().all(Finding::holds)
    }

    /// True if every law is judged.
    pub fn is_judged(&self) -> bool {
        self.laws.iter().all(|law| law.is_judged)
    }
}

impl<S: Scalar + LowerExp> Display for Report<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.laws.iter().try_for_each(|law| {
            let mark = if law.holds() { "" } else { "BROKEN " };
            writeln!(f, "{mark}{law}")
        })
    }
}
