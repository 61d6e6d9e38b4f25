//! One step of velocities under contacts and friction.
//!
//! Over a step of the length h, impulses r of all contacts and friction change the velocities
//! together with the other forces:
//!
//! ```text
//! v⁺ = v + h a + Σ w r,        q⁺ = q + h N(q) v⁺.
//! ```
//!
//! Impulses and rates u⁺ at the end of the step satisfy the law of [`cone`](super::cone). A contact
//! with the gap g may close with u⁺ ≥ −g/h in the step, and touches at its end. A contact that is
//! hit rebounds by Newton's law instead, u⁺ ≥ −e u. It is hit if its speed of approach exceeds
//! twice the change of its rate by the other forces in a step. Otherwise it comes to rest; it would
//! bounce forever if slow contacts were hit as well.
//!
//! Rates at the end of a step include the drifts of their gradients. Gradients that jump have none:
//! see [`turning`](super::turning).
//!
//! Overlaps are removed by displacements, half of the overlap in each step, and never become
//! velocities. Sources: Moreau, "Numerical aspects of the sweeping process", *Comput. Methods Appl.
//! Mech. Eng.* 177 (1999) 329–349; Anitescu, "Optimization-based simulation of nonsmooth rigid
//! multibody dynamics", *Mathematical Programming* 105 (2006) 113–143.
//!
//! # A ball in numbers
//!
//! It falls at the speed 2 from a height of 0.01, with g = 10 and h = 0.01. At the end of the step
//! it would be 0.011 below the floor. With e = 0 it gets the velocity −1 and touches. With e = ½ it
//! is hit, since 2 is more than twice 0.1, and leaves with 1.

use core::array;

use super::choice::{Choice, Rule, Settled};
use super::cone::Approximation;
use super::heading::Heading;
use super::law::ContactLaw;
use super::pace::Pace;
use super::responses::Metric;
use super::slip::{is_planar, present_direction};
use super::{Contact, ContactSystem, Friction, Mode, Terms};
use crate::linalg::vector::inner;
use crate::scalar::Scalar;
use crate::system::StepFailure;
use crate::tolerance::{BOUND, IMPACT_ENERGY};

/// Speed of approach from which a contact is hit, as a multiple of the change by other forces.
const HIT: f64 = 2.0;
/// Fraction of an overlap that a step removes.
const SHARE: f64 = 0.5;
/// Number of bisections for the fraction of the restitution.
const BISECTIONS: u32 = 20;

/// Impulses over a step.
pub(super) struct Impulses<S, const N: usize, const K: usize> {
    pub(super) impulses: [S; K],
    /// Modes in which the step ends; friction that slips in a plane has directions instead.
    pub(super) modes: [Mode; K],
    /// Components of the directions in which friction slips in planes; zero for others.
    pub(super) directions: [S; K],
    /// The largest rate by which an impulse misses the law, and the index of this impulse.
    pub(super) residual: (S, usize),
    pub(super) is_exact: bool,
    pub(super) iterations: u32,
    /// The velocities that the impulses add.
    pub(super) change: [S; N],
}

/// The terms of a step of length h.
pub(super) struct ContactStep<'a, S, const N: usize, const K: usize> {
    pub(super) terms: &'a mut Terms<S, N, K>,
    pub(super) metric: &'a Metric<S, N>,
    modes: &'a [Mode; K],
    pub(super) h: S,
    /// Gaps up to which contacts are closed, as they differ from zero by rounding. Supports that
    /// differ by less share a load.
    pub(super) closed: S,
    /// Rates at the end of the step without impulses.
    pub(super) free: [S; K],
}

impl<'a, S: Scalar, const N: usize, const K: usize> ContactStep<'a, S, N, K> {
    pub(super) fn new(
        terms: &'a mut Terms<S, N, K>,
        metric: &'a Metric<S, N>,
        modes: &'a [Mode; K],
        [h, closed]: [S; 2],
    ) -> Self {
        let mut free = [S::ZERO; K];
        for (k, free) in free.iter_mut().enumerate() {
            let rate = inner(&terms.rows[k], &terms.free) + terms.drifts[k];
            *free = h.multiply_add(rate, terms.rates[k]);
        }
        ContactStep { terms, metric, modes, h, closed, free }
    }

    /// True if everything that impulses depend on is finite. Rates are, if gradients and inertia
    /// are.
    pub(super) fn is_finite(&self) -> bool {
        let terms = &*self.terms;
        let are = |values: &[S]| values.iter().fold(true, |all, value| all & value.is_finite());
        let are_slopes = terms.slopes.iter().all(|slope| are(&[slope.kinetic, slope.fixed]));
        let are_complete = self.metric.is_normal() || terms.responses.iter().all(|response| are(response));
        let vectors = [&self.free, &terms.gaps, &terms.kinetic, &terms.fixed];
        vectors.into_iter().all(|vector| are(vector)) && are_slopes && are_complete
    }

    /// Checks limits of friction that contain no constraint forces.
    pub(super) fn check_limits<M>(&mut self, system: &M) -> Result<(), StepFailure<S>>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        self.metric.respond(self.terms, &[true; K]);
        self.terms.check_limits(system, self.modes, self.rows())
    }

    /// Searches for the impulses, starting from these. Contacts that others push together take part
    /// once they would overlap. Closed ones with an impulse at the start take part from the
    /// beginning.
    pub(super) fn solve(&mut self, restitutions: &[S; K], start: &[S; K]) -> Impulses<S, N, K> {
        let mut acts = [false; K];
        for (k, acts) in acts.iter_mut().enumerate() {
            let pressed = self.is_contact(k) && start[k] > S::ZERO && self.open_gap(k) == S::ZERO;
            *acts = pressed || self.closes(k, self.free[k]);
        }
        let (mut start, mut iterations) = (*start, 0);
        loop {
            let choices = self.choices(&acts);
            self.respond(&choices);
            let found = self.without_gain(restitutions, &choices, &start);
            iterations += found.iterations;
            let impulses = &found.settled.reactions;
            let change = self.change(impulses);
            let rates = self.rates(&change);
            let mut also = acts;
            also.iter_mut().enumerate().for_each(|(k, acts)| *acts |= self.closes(k, rates[k]));
            if also == acts {
                let (modes, directions) = self.modes_after(&found.settled, &rates);
                let Approximation { settled, residual, is_exact, .. } = found;
                let impulses = settled.reactions;
                return Impulses { impulses, modes, directions, residual, is_exact, iterations, change };
            }
            (acts, start) = (also, *impulses);
        }
    }

    /// Computes the displacements that remove overlaps beyond these slits.
    pub(super) fn separation(&mut self, slits: &[S; K]) -> [S; N] {
        let near: [bool; K] = array::from_fn(|k| self.is_contact(k) && self.terms.gaps[k] <= slits[k]);
        let choices = array::from_fn(|k| if near[k] { Choice::Touch } else { Choice::Only(Rule::Absent) });
        let share = S::from_f64(SHARE);
        let values = array::from_fn(|k| if near[k] { share * self.terms.gaps[k] } else { S::ZERO });
        self.respond(&choices);
        self.change(&self.law(values, S::ZERO).near(&choices, &[S::ZERO; K]).settled.reactions)
    }

    /// Computes the responses to reactions that may act.
    fn respond(&mut self, choices: &[Choice<S>; K]) {
        let acts = array::from_fn(|k| choices[k] != Choice::Only(Rule::Absent));
        self.metric.respond(self.terms, &acts);
    }

    fn law(&self, offsets: [S; K], presence: S) -> ContactLaw<'_, S, N, K> {
        ContactLaw { rows: self.rows(), ..ContactLaw::new(self.terms, offsets, presence) }
    }

    /// Returns the gradients of rates, in the coordinates of the responses.
    fn rows(&self) -> &[[S; N]; K] {
        if self.metric.is_normal() { &self.terms.responses } else { &self.terms.rows }
    }

    /// Returns the velocities that these impulses add.
    fn change(&self, impulses: &[S; K]) -> [S; N] {
        self.metric.velocities(self.terms.change(impulses))
    }

    pub(super) fn is_contact(&self, k: usize) -> bool {
        matches!(self.modes[k], Mode::Contact(_))
    }

    /// True if contact k would overlap at the end of the step with this rate. A closed one need
    /// only open by no more than rounding.
    fn closes(&self, k: usize, rate: S) -> bool {
        let gap = self.open_gap(k);
        let most = if gap > S::ZERO { -(BOUND.part::<S>() * gap) } else { self.closed };
        self.is_contact(k) && self.h.multiply_add(rate, gap) <= most
    }

    /// Returns the distance by which contact k may close; zero if it overlaps.
    fn open_gap(&self, k: usize) -> S {
        let gap = self.terms.gaps[k];
        if gap > self.closed { gap } else { S::ZERO }
    }

    /// Computes the impulses with the largest fraction of the restitution that creates no energy.
    fn without_gain(
        &self,
        restitutions: &[S; K],
        choices: &[Choice<S>; K],
        start: &[S; K],
    ) -> Approximation<S, K> {
        let with = |part: S| self.approximate(&restitutions.map(|e| part * e), choices, start);
        let whole = with(S::ONE);
        let hits = |k: usize| choices[k] == Choice::Touch && self.is_hit(k, restitutions[k]);
        if !(0..K).any(hits) {
            return whole;
        }
        if !whole.is_exact {
            // Only without restitution do impulses always exist.
            let plastic = with(S::ZERO);
            return if plastic.residual.0 < whole.residual.0 { plastic } else { whole };
        }
        if !self.creates_energy(&whole.settled.reactions) {
            return whole;
        }
        let half = S::from_f64(0.5);
        let (mut below, mut above) = (S::ZERO, S::ONE);
        for _ in 0..BISECTIONS {
            let middle = half * (below + above);
            match self.creates_energy(&with(middle).settled.reactions) {
                true => above = middle,
                false => below = middle,
            }
        }
        with(below)
    }

    fn approximate(
        &self,
        restitutions: &[S; K],
        choices: &[Choice<S>; K],
        start: &[S; K],
    ) -> Approximation<S, K> {
        let mut offsets = self.free;
        for k in (0..K).filter(|&k| choices[k] == Choice::Touch) {
            offsets[k] = match self.is_hit(k, restitutions[k]) {
                true => restitutions[k].multiply_add(self.terms.rates[k], self.free[k]),
                false => self.free[k] + self.open_gap(k) / self.h,
            };
        }
        self.law(offsets, self.h).near(choices, start)
    }

    /// Returns what is possible for each reaction if these contacts act.
    fn choices(&self, acts: &[bool; K]) -> [Choice<S>; K] {
        let mut choices = [Choice::Only(Rule::Absent); K];
        for k in 0..K {
            choices[k] = match self.modes[k] {
                Mode::Contact(_) if acts[k] => Choice::Touch,
                Mode::Friction(_) => Choice::Rest,
                Mode::Across(_) => Choice::Across,
                Mode::Smooth => Choice::Only(Rule::Smooth),
                _ => continue,
            };
        }
        self.law([S::ZERO; K], self.h).possible(&choices)
    }

    /// True if contact k is hit, instead of coming to rest.
    fn is_hit(&self, k: usize, restitution: S) -> bool {
        let approach = self.terms.rates[k];
        let change = (self.free[k] - approach).abs();
        restitution > S::ZERO && approach < -(S::from_f64(HIT) * change)
    }

    /// Returns the rates after this change of the velocities.
    fn rates(&self, change: &[S; N]) -> [S; K] {
        let mut rates = self.free;
        rates.iter_mut().zip(&self.terms.rows).for_each(|(rate, row)| *rate = *rate + inner(row, change));
        rates
    }

    /// True if these impulses add more energy than rounding.
    fn creates_energy(&self, impulses: &[S; K]) -> bool {
        let (mut work, mut exchanged) = (S::ZERO, S::ZERO);
        let rates = self.rates(&self.change(impulses));
        for ((impulse, before), after) in impulses.iter().zip(&self.free).zip(rates) {
            work = work + *impulse * (*before + after);
            exchanged = exchanged + (*impulse * *before).abs();
        }
        work > IMPACT_ENERGY.part::<S>() * exchanged
    }

    /// Returns the modes in which a step ends, and the directions of friction that slips in planes.
    fn modes_after(&self, settled: &Settled<S, K>, rates: &[S; K]) -> ([Mode; K], [S; K]) {
        let (mut modes, mut directions) = (*self.modes, [S::ZERO; K]);
        for k in 0..K {
            modes[k] = match (self.modes[k], settled.rules[k]) {
                (Mode::Contact(_), Rule::Holds) => Mode::Contact(Contact::Closed),
                (Mode::Contact(_), _) => Mode::Contact(Contact::Open),
                (Mode::Friction(_), Rule::Holds) => Mode::Friction(Friction::Sticks),
                (Mode::Friction(_), Rule::Slips(_)) if is_planar(self.modes, k) => {
                    let [slip, force] = [[rates[k], rates[k + 1]], [k, k + 1].map(|k| settled.reactions[k])];
                    [directions[k], directions[k + 1]] = direction(slip, force);
                    Mode::Friction(Friction::Slips)
                }
                (Mode::Friction(_), Rule::Slips(along)) if along > S::ZERO => {
                    Mode::Friction(Friction::SlipsForwards)
                }
                (Mode::Friction(_), Rule::Slips(_)) => Mode::Friction(Friction::SlipsBackwards),
                (Mode::Friction(_), _) => Mode::Friction(Friction::Slips),
                (Mode::Across(_), _) => match modes[k - 1] {
                    Mode::Friction(first) => Mode::Across(first),
                    _ => Mode::Across(Friction::Slips),
                },
                (Mode::Smooth, _) => Mode::Smooth,
            };
        }
        (modes, directions)
    }
}

/// Returns the direction of this slip velocity, opposite to which this force acts; zero without a
/// direction.
fn direction<S: Scalar>(slip: [S; 2], force: [S; 2]) -> [S; 2] {
    let against = || present_direction(force).map(|direction| direction.map(|component| -component));
    present_direction(slip).or_else(against).unwrap_or([S::ZERO; 2])
}

/// Returns these modes with these directions of friction that slips in planes.
pub(super) fn directed<S: Scalar, const K: usize>(modes: &[Mode; K], directions: &[S; K]) -> [Mode; K] {
    let towards = |k: usize| match [directions[k], directions[k + 1]] {
        direction if direction == [S::ZERO; 2] => Friction::Slips,
        direction => Friction::SlipsTowards(Heading::new(direction), Pace::ZERO),
    };
    array::from_fn(|k| match modes[k] {
        Mode::Friction(Friction::Slips) if is_planar(modes, k) => Mode::Friction(towards(k)),
        Mode::Across(Friction::Slips) if k > 0 => Mode::Across(towards(k - 1)),
        mode => mode,
    })
}
