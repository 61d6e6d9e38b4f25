//! Failures that name a contact.
//!
//! A contact that slips with friction μ in the direction c is pressed by N. Its gap accelerates by
//! N (g − μ h), with the response g of the gap to its own force and h = c·(response to friction).
//! From the critical coefficient g/h on, the normal force cannot stop a contact that accelerates
//! downwards (Painlevé's paradox). Source: Génot, Brogliato, "New results on Painlevé paradoxes",
//! *European Journal of Mechanics A* 18 (1999), eq. 7.
//!
//! A homogeneous rod of mass 1 and length 2 slips with one end ahead, at 60° to the ground. Its
//! moment of inertia is 1/3. The responses are g = 1 + 3 cos² 60° = 7/4 and h = 3 sin 60° cos 60° =
//! 1.299. The critical coefficient is 1.347.

use super::slip::{is_planar, present_direction};
use super::{ContactSystem, LimitSlope, Mode, Terms};
use crate::linalg::vector::dot;
use crate::scalar::Scalar;
use crate::system::{StepFailure, Undefined};

const NO_FORCES: &str = "no forces of contacts and friction are consistent with this state: friction is too \
strong for these rigid bodies (Painlevé paradox)";

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Returns the failure of terms that are not finite at this time and position. It names a
    /// contact if nothing else is to blame.
    #[cold]
    pub(super) fn not_finite<M>(&self, system: &M, t: S, q: &M::Coordinates) -> StepFailure<S>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let are_finite = |values: &[S]| values.iter().all(|value| value.is_finite());
        let is_undefined = |k: &usize| {
            !(are_finite(&self.rows[*k]) && self.gaps[*k].is_finite() && self.rates[*k].is_finite())
        };
        let undefined =
            (0..K).find(is_undefined).filter(|_| are_finite(q.as_ref()) && are_finite(&self.free));
        let Some(k) = undefined else { return StepFailure::NotFinite };
        let mut parameters = (0..).map_while(|index| system.parameter(index));
        StepFailure::Undefined(match parameters.find(|(_, value)| !value.is_finite()) {
            Some((name, value)) => Undefined::Parameter { name, value },
            None => Undefined::Contact { name: system.reaction_name(k), time: t },
        })
    }

    /// Returns the failure if no forces are consistent. It names the contact that slips with the
    /// largest friction relative to its critical coefficient.
    #[cold]
    pub(super) fn inconsistent<M>(
        &self,
        system: &M,
        modes: &[Mode; K],
        [is_touching, is_still]: [&[bool; K]; 2],
    ) -> StepFailure<S>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let slips = |slope: &&LimitSlope<S>| {
            matches!(modes.get(slope.limited), Some(Mode::Friction(_)))
                && !is_still[slope.limited]
                && is_touching[slope.reaction]
        };
        let excess = |slope: &LimitSlope<S>| slope.kinetic * self.inverse_critical(modes, slope);
        let larger = |a, b| if excess(b) > excess(a) { b } else { a };
        let Some(strongest) = self.slopes.iter().filter(slips).reduce(larger) else {
            return StepFailure::Stuck(NO_FORCES);
        };
        let critical = (excess(strongest) >= S::ONE).then(|| strongest.kinetic / excess(strongest));
        let contact = system.reaction_name(strongest.reaction);
        StepFailure::Painleve { contact, coefficient: strongest.kinetic, critical }
    }

    /// Returns h/g, the inverse of the critical coefficient of friction on one contact; zero if it
    /// does not slip.
    fn inverse_critical(&self, modes: &[Mode; K], slope: &LimitSlope<S>) -> S {
        let (k, row) = (slope.limited, &self.rows[slope.reaction]);
        let is_planar = is_planar(modes, k);
        let Some([along, across]) = present_direction(self.slip(k, is_planar)) else { return S::ZERO };
        let second = if is_planar { across * dot(row, &self.responses[k + 1]) } else { S::ZERO };
        (along * dot(row, &self.responses[k]) + second) / dot(row, &self.responses[slope.reaction])
    }
}
