//! Limits of friction, which are magnitudes.

use super::{ContactSystem, LimitSlope, Mode, Terms};
use crate::scalar::Scalar;
use crate::system::StepFailure;

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// True if some part of a limit is negative.
    pub(super) fn may_have_negative_limits(&self, modes: &[Mode; K]) -> bool {
        let is_negative = |k: usize, parts: [S; 2]| {
            self.side(k, modes).is_some_and(|side| parts.iter().any(|part| side * *part < S::ZERO))
        };
        (0..K).any(|k| is_negative(k, [self.kinetic[k], self.fixed[k]]))
            || self.slopes.iter().any(|slope| is_negative(slope.limited, [slope.kinetic, slope.fixed]))
    }

    /// Returns the sign that the limits of friction k have; `None` for contacts, and for the unused
    /// slopes of systems read at run time.
    fn side(&self, k: usize, modes: &[Mode; K]) -> Option<S> {
        match modes.get(k)? {
            Mode::Contact(_) | Mode::Across(_) => None,
            // Its kinetic limit has the sign of the slip velocity.
            Mode::Smooth => Some(self.rates[k].sign()),
            Mode::Friction(_) => Some(S::ONE),
        }
    }

    /// Checks limits of friction that contain no constraint forces. The gradients `rows` are in the
    /// coordinates of the responses.
    ///
    /// A limit may be negative if it is small relative to the forces at its friction. Where v
    /// changes its sign, `abs(v)` continues as v up to the event.
    ///
    /// # Errors
    /// If a limit is negative for all forces of the contacts.
    pub(super) fn check_limits<M>(
        &self,
        system: &M,
        modes: &[Mode; K],
        rows: &[[S; N]; K],
    ) -> Result<(), StepFailure<S>>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        for k in (0..K).filter(|&k| !system.limit_reverses(k)) {
            let Some(side) = self.side(k, modes) else { continue };
            let of = |slope: fn(&LimitSlope<S>) -> S| {
                self.slopes_of(k).map(move |entry| (entry.reaction, slope(entry)))
            };
            let negative = negative(side, self.kinetic[k], of(|slope| slope.kinetic), modes)
                .or_else(|| negative(side, self.fixed[k], of(|slope| slope.fixed), modes));
            if let Some(value) = negative.filter(|value| self.is_felt(k, &rows[k], -*value)) {
                return Err(StepFailure::FrictionLimit { friction: system.reaction_name(k), value });
            }
        }
        Ok(())
    }

    /// True if this value is more than rounding relative to the forces that friction k would have
    /// to hold. It may be a limit, or the growth of a limit with the force of a contact.
    fn is_felt(&self, k: usize, row: &[S; N], limit: S) -> bool {
        let parts = row.iter().zip(&self.responses[k]);
        let response = parts.fold(S::ZERO, |sum, (entry, response)| sum + (*entry * *response).abs());
        let force = if response > S::ZERO { self.acceleration_of(k) / response } else { S::ZERO };
        limit > S::epsilon().sqrt() * force.min(S::ONE)
    }
}

/// Returns the part of a limit on this side that makes it negative, if no other part can compensate
/// for it: contacts only press.
fn negative<S: Scalar, const K: usize>(
    side: S,
    free: S,
    slopes: impl Iterator<Item = (usize, S)>,
    modes: &[Mode; K],
) -> Option<S> {
    let mut least = side * free;
    for (reaction, slope) in slopes.filter(|(_, slope)| *slope != S::ZERO) {
        let is_pressing = matches!(modes[reaction], Mode::Contact(_));
        if side * slope > S::ZERO || side * free > S::ZERO || !is_pressing {
            return None;
        }
        least = least.min(side * slope);
    }
    (least < S::ZERO).then_some(least)
}
