//! Impacts.
//!
//! All touching contacts take part, including closed ones. Rates of gaps after an impact and
//! impulses satisfy
//!
//! ```text
//! Λ ≥ 0,  ξ = rate⁺ + e rate⁻ ≥ 0,  Λ ξ = 0,     v⁺ = v⁻ + Σ w Λ,
//! ```
//!
//! which is v⁺ = v⁻ − (1 + e) W (J W)⁻¹ J v⁻ for one contact. A contact that would have to pull is
//! excluded. Friction whose limit grows with the reactions of contacts obeys the same law as its
//! force. It satisfies |Λ| ≤ slope of the limit times the impulses, and acts against the remaining
//! slip. Limits that do not grow with reactions are finite forces and give no impulse.
//!
//! With friction, or with several contacts of different restitution, Newton's law of restitution
//! may create energy (the paradox of Kane and Levinson). There may also be no impulses, as for a
//! body wedged between more walls than it has degrees of freedom. All coefficients are then reduced
//! in proportion until impulses exist and no energy is created. Without restitution there are
//! always impulses ([`lemke`](super::lemke)), and they take the energy −Λ·rate⁺ + ½ Λ·G Λ ≥ 0, as
//! seen from moving surfaces.
//!
//! A jam is the limit of such an impact as the speed of approach tends to zero. It has an effect
//! only if friction is so strong that a slipping contact would be pulled in. Sources: Moreau,
//! "Unilateral contact and dry friction in finite freedom dynamics", in *Nonsmooth Mechanics and
//! Applications* (1988). Glocker, *Set-Valued Force Laws*, §8; Kane, Levinson, *Dynamics: Theory
//! and Applications*, §5.8; Brogliato, *Nonsmooth Mechanics*, 3rd ed., §4.3.
//!
//! # A block on a floor in numbers
//!
//! m = 2 falls with 4 and slides with 3, e = 1/2 and friction 0.25 times the normal force. Without
//! impulses rate⁺ + e rate⁻ is (−6, 3), and G = diag(1/2, 1/2). Held together the impulses would be
//! (12, −6), but friction gives no more than 0.25 · 12 = 3. They are (12, −3), and the block leaves
//! with 2 and slides on with 3/2. It had 25 J and keeps 6.25.

use core::array;

use super::choice::{Choice, Rule, Settled};
use super::reaction_forces::Balance;
use super::{LimitSlope, Mode, Terms};
use crate::scalar::Scalar;
use crate::system::StepFailure;
use crate::tolerance::IMPACT_ENERGY;

/// Number of bisections for the fraction of the restitution.
const MOST_BISECTIONS: u32 = 40;
/// Number of bisections if the full impulses do not exist.
const FEW_BISECTIONS: u32 = 6;
/// Speeds of approach at which a jam is searched for, relative to the largest slip velocity. The
/// smaller ones are for contacts that slip at very different speeds.
const APPROACHES: [f64; 3] = [1e-4, 1e-7, 1e-10];
const NO_IMPULSES: &str = "no impulses of contacts and friction are consistent with the impact";

/// The effect of an impact.
pub(super) struct Collision<S, const N: usize, const K: usize> {
    /// The velocities after the impact.
    pub(super) velocities: [S; N],
    pub(super) impulses: [S; K],
    /// The kinetic energy lost in all contacts and friction, from the mean of their rates before
    /// and after.
    pub(super) energy_loss: S,
    /// True for each rate that is zero after the impact, up to rounding.
    pub(super) is_still: [bool; K],
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Computes the impact in the touching contacts from the velocities `v`. Coefficients of
    /// restitution are zero for friction.
    ///
    /// # Errors
    /// If no impulses fit, or if something is not finite.
    pub(super) fn impact(
        &self,
        v: &[S; N],
        modes: &[Mode; K],
        is_touching: &[bool; K],
        restitutions: &[S; K],
    ) -> Result<Collision<S, N, K>, StepFailure<S>> {
        let choices = self.choices(modes, is_touching);
        if !Balance::of_impulses(self, &self.rates, restitutions).is_finite() {
            return Err(StepFailure::NotFinite);
        }
        let part = |part: S| self.collide(v, &choices, &restitutions.map(|e| part * e));
        let creates = |collision: &Collision<S, N, K>| collision.energy_loss < -self.rounding(collision);
        if let Some(collision) = part(S::ONE).filter(|collision| !creates(collision)) {
            return Ok(collision);
        }
        self.reduced(part, creates).ok_or(StepFailure::Stuck(NO_IMPULSES))
    }

    /// Returns the impact with the largest fraction of the restitution for which impulses exist and
    /// no energy is created. Without restitution, both conditions hold.
    fn reduced(
        &self,
        part: impl Fn(S) -> Option<Collision<S, N, K>>,
        creates: impl Fn(&Collision<S, N, K>) -> bool,
    ) -> Option<Collision<S, N, K>> {
        let half = S::from_f64(0.5);
        let (mut below, mut above) = (S::ZERO, S::ONE);
        let (mut round, mut most) = (0, MOST_BISECTIONS);
        while round < most {
            let middle = half * (below + above);
            match part(middle) {
                Some(collision) if creates(&collision) => above = middle,
                Some(_) => below = middle,
                // Impulses grow without bound towards the largest fraction. Half of the interval is
                // kept, which needs few bisections.
                None => (below, above, most) = (below.min(half * middle), half * middle, FEW_BISECTIONS),
            }
            round += 1;
        }
        part(below).filter(|collision| !creates(collision)).or_else(|| part(S::ZERO))
    }

    /// Returns the impact without approach by which `pressed` contacts jam, if there is one. It is
    /// the limit of impacts as the speed of approach tends to zero, and changes the motion.
    pub(super) fn jam(
        &self,
        v: &[S; N],
        modes: &[Mode; K],
        is_pressed: &[bool; K],
    ) -> Option<Collision<S, N, K>> {
        let choices = self.choices(modes, is_pressed);
        let rates = array::from_fn(|k| if is_pressed[k] { S::ZERO } else { self.rates[k] });
        let balance = Balance::of_impulses(self, &rates, &[S::ZERO; K]);
        APPROACHES.into_iter().find_map(|approach| {
            let found = balance.approached(S::from_f64(approach), is_pressed).settle(&choices)?;
            let impulses = balance.confirmed(&choices, found.rules)?;
            let jam = self.collision(v, &balance, impulses, (&rates, &[S::ZERO; K]));
            let is_felt = jam.energy_loss > self.rounding(&jam);
            is_felt.then_some(jam)
        })
    }

    /// Returns the choices of participating contacts and friction in an impact.
    fn choices(&self, modes: &[Mode; K], is_touching: &[bool; K]) -> [Choice<S>; K] {
        array::from_fn(|k| match modes[k] {
            Mode::Contact(_) if is_touching[k] => Choice::Touch,
            Mode::Friction(_) | Mode::Smooth if self.has_impulses(k) => Choice::Rest,
            Mode::Across(_) if self.has_impulses(k) => Choice::Across,
            _ => Choice::Only(Rule::Absent),
        })
    }

    /// Computes the impact with these coefficients of restitution; `None` if there are no impulses.
    fn collide(
        &self,
        v: &[S; N],
        choices: &[Choice<S>; K],
        restitutions: &[S; K],
    ) -> Option<Collision<S, N, K>> {
        let balance = Balance::of_impulses(self, &self.rates, restitutions);
        let settled = balance.settle(choices)?;
        Some(self.collision(v, &balance, settled, (&self.rates, restitutions)))
    }

    fn collision(
        &self,
        v: &[S; N],
        balance: &Balance<'_, S, N, K>,
        settled: Settled<S, K>,
        (rates, restitutions): (&[S; K], &[S; K]),
    ) -> Collision<S, N, K> {
        let impulses = settled.reactions;
        let mut energy_loss = S::ZERO;
        for (k, &impulse) in impulses.iter().enumerate() {
            let mean = rates[k] + S::from_f64(0.5) * balance.change(k, &impulses);
            energy_loss = energy_loss - impulse * mean;
        }
        let is_thrown_back = |k: usize| rates[k] * restitutions[k] < S::ZERO;
        let is_still = array::from_fn(|k| settled.rules[k] == Rule::Holds && !is_thrown_back(k));
        Collision { velocities: self.added(v, &impulses), impulses, energy_loss, is_still }
    }

    /// Returns the rounding level of the energy that impulses exchange.
    fn rounding(&self, collision: &Collision<S, N, K>) -> S {
        let works = collision.impulses.iter().zip(&self.rates);
        let exchanged = works.fold(S::ZERO, |sum, (impulse, rate)| sum + (*impulse * *rate).abs());
        IMPACT_ENERGY.part::<S>() * exchanged
    }

    /// True if the limits of friction k grow with reactions.
    fn has_impulses(&self, k: usize) -> bool {
        self.slopes_of(k).any(LimitSlope::is_present)
    }
}
