//! Speeds below which slipping has no direction yet.

use crate::scalar::Scalar;
use crate::tolerance::BOUND;

/// Slip velocities in a plane have a direction from this fraction of their terms on.
const SLOW: f64 = 1e-6;
/// They have none up to so many times their rounding error.
const ABOVE_NOISE: f64 = 8.0;
/// Roundings of its terms that a slip velocity may consist of.
const ROUNDINGS: f64 = 8.0;

/// A speed, rounded down to a power of two so that modes can be compared and hashed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Pace {
    /// None of zero.
    exponent: Option<i16>,
}

impl Pace {
    /// The speed zero.
    pub const ZERO: Self = Pace { exponent: None };

    /// Rounds this speed down. A speed that is not a positive number counts as zero.
    pub fn new<S: Scalar>(speed: S) -> Self {
        if !(speed > S::ZERO && speed.is_finite()) {
            return Pace::ZERO;
        }
        let (mut exponent, mut power) = (0, S::ONE);
        while power > speed {
            (exponent, power) = (exponent - 1, power * S::from_f64(0.5));
        }
        while power + power <= speed {
            (exponent, power) = (exponent + 1, power + power);
        }
        Pace { exponent: Some(exponent) }
    }

    /// The speed from which slip velocities of these terms, with this rounding error, have a
    /// direction.
    pub(super) fn of_slip<S: Scalar>(terms: S, noise: S) -> Self {
        Pace::new((S::from_f64(SLOW) * terms).max(S::from_f64(ABOVE_NOISE) * noise))
    }

    /// The size below which slip velocities with this pace are rounding.
    pub(super) fn rounding<S: Scalar>(self) -> S {
        let part = S::from_f64(SLOW).max(S::from_f64(ABOVE_NOISE) * BOUND.part::<S>());
        S::from_f64(ROUNDINGS) * S::epsilon() * self.value::<S>() / part
    }

    /// The speed.
    pub fn value<S: Scalar>(self) -> S {
        let base = |exponent: i16| S::from_f64(if exponent < 0 { 0.5 } else { 2.0 });
        self.exponent.map_or(S::ZERO, |exponent| base(exponent).powi(i32::from(exponent).abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::Pace;

    #[test]
    fn speeds_are_rounded_down_to_powers_of_two() {
        for (speed, wanted) in [(1.0, 1.0), (1.999, 1.0), (2.0, 2.0), (0.3, 0.25), (5e-324, 5e-324)] {
            assert_eq!(Pace::new::<f64>(speed).value::<f64>(), wanted, "{speed}");
        }
        assert_eq!(Pace::new(f64::MAX).value::<f64>(), 2_f64.powi(1023));
        assert_eq!(Pace::new(1e-45_f32).value::<f32>(), 1e-45);
        for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Pace::new(speed), Pace::ZERO);
        }
    }
}
