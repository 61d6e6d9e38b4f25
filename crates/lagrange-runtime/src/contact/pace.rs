//! Speeds below which slipping has no direction yet.

use crate::scalar::Scalar;
use crate::tolerance::BOUND;

/// Slip speed in a plane from which there is a direction, relative to its terms.
const SLOW: f64 = 1e-6;
/// Slip speed up to which there is no direction, as a multiple of its rounding error.
const ABOVE_NOISE: f64 = 8.0;
/// Bound of the rounding error of a slip velocity, in roundings of its terms.
const ROUNDINGS: f64 = 8.0;

/// A speed, rounded down to a power of two so that modes can be compared and hashed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Pace {
    /// `None` for zero.
    exponent: Option<i16>,
}

impl Pace {
    /// The speed zero.
    pub const ZERO: Self = Pace { exponent: None };

    /// Rounds this speed down. A value that is not a positive number gives zero.
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

    /// Returns the speed from which slip velocities with these terms and this rounding error have a
    /// direction.
    pub(super) fn of_slip<S: Scalar>(terms: S, noise: S) -> Self {
        Pace::new((S::from_f64(SLOW) * terms).max(S::from_f64(ABOVE_NOISE) * noise))
    }

    /// Returns the size below which slip velocities with this pace are rounding.
    pub(super) fn rounding<S: Scalar>(self) -> S {
        let part = S::from_f64(SLOW).max(S::from_f64(ABOVE_NOISE) * BOUND.part::<S>());
        S::from_f64(ROUNDINGS) * S::epsilon() * self.value::<S>() / part
    }

    /// Returns the speed.
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
