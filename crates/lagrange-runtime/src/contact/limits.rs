//! Limits of friction, which are magnitudes.

use super::{ContactSystem, Mode, Terms};
use crate::scalar::Scalar;
use crate::system::StepFailure;

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Checks limits of friction that contain no constraint forces.
    ///
    /// A limit may be negative if it is small relative to the forces at its friction. Where v
    /// changes its sign, `abs(v)` continues as v up to the event.
    ///
    /// # Errors
    /// If a limit is negative for all forces of the contacts.
    pub(super) fn check_limits<M>(&self, modes: &[Mode; K]) -> Result<(), StepFailure<S>>
    where
        M: ContactSystem<N, K>,
    {
        for k in (0..K).filter(|&k| !M::LIMITS_REVERSE[k]) {
            let side = match modes[k] {
                Mode::Contact(_) | Mode::Across(_) => continue,
                // Its kinetic limit has the sign of the slip velocity.
                Mode::Smooth => self.rates[k].sign(),
                Mode::Friction(_) => S::ONE,
            };
            let limits =
                [(self.kinetic[k], &self.kinetic_slopes[k]), (self.fixed[k], &self.static_slopes[k])];
            let negative = limits.into_iter().find_map(|(free, slopes)| negative(side, free, slopes, modes));
            if let Some(value) = negative.filter(|value| self.is_felt(k, -*value)) {
                return Err(StepFailure::FrictionLimit { friction: M::REACTIONS[k], value });
            }
        }
        Ok(())
    }

    /// True if this value is more than rounding relative to the forces that friction k would have
    /// to hold. It may be a limit, or the growth of a limit with the force of a contact.
    fn is_felt(&self, k: usize, limit: S) -> bool {
        let response = self.size_of(k, &self.responses[k]);
        let force = if response > S::ZERO { self.acceleration_of(k) / response } else { S::ZERO };
        limit > S::epsilon().sqrt() * force.min(S::ONE)
    }
}

/// Returns the part of a limit on this side that makes it negative, if no other part can compensate
/// for it: contacts only press.
fn negative<S: Scalar, const K: usize>(side: S, free: S, slopes: &[S; K], modes: &[Mode; K]) -> Option<S> {
    let mut least = side * free;
    for (&slope, mode) in slopes.iter().zip(modes).filter(|(slope, _)| **slope != S::ZERO) {
        let is_pressing = matches!(mode, Mode::Contact(_));
        if side * slope > S::ZERO || side * free > S::ZERO || !is_pressing {
            return None;
        }
        least = least.min(side * slope);
    }
    (least < S::ZERO).then_some(least)
}
