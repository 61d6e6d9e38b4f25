//! Directions of slipping.

use core::fmt::{self, Debug, Formatter};

use crate::linalg::vector::dot;
use crate::scalar::Scalar;

/// Number of binary digits of a component.
const DIGITS: u32 = 53;

/// A direction in the plane of two slip velocities. It distinguishes a slip velocity that reaches
/// zero from one that turns.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Heading {
    /// The bits of both components, which allow modes to be compared and hashed.
    bits: [u64; 2],
}

impl Heading {
    /// Returns the direction of this vector, whose length is about one.
    pub fn new<S: Scalar>(components: [S; 2]) -> Self {
        Heading { bits: components.map(|component| rounded(component).to_bits()) }
    }

    /// Returns components from which [`new`](Self::new) creates the same bits.
    pub(super) fn numbers<S: Scalar>(self) -> [S; 2] {
        self.bits.map(|bits| S::from_f64(f64::from_bits(bits)))
    }

    /// Returns a vector of length one.
    pub fn components<S: Scalar>(self) -> [S; 2] {
        let components = self.numbers::<S>();
        let length = dot(&components, &components).sqrt();
        components.map(|component| component / length)
    }
}

impl Debug for Heading {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.bits.map(f64::from_bits)).finish()
    }
}

/// Truncates a number between −1 and 1 after this many binary digits. It needs only comparisons, as
/// not every number type can be converted.
fn rounded<S: Scalar>(value: S) -> f64 {
    let is_negative = value < S::ZERO;
    let mut left = if is_negative { -value } else { value };
    let (mut found, mut digit) = (0.0, 1.0);
    for _ in 0..DIGITS {
        if S::from_f64(digit) <= left {
            (found, left) = (found + digit, left - S::from_f64(digit));
        }
        digit *= 0.5;
    }
    // Zero has only one sign.
    if is_negative { 0.0 - found } else { found }
}
