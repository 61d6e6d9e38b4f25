//! Contacts whose gradients turn within a step.
//!
//! A step continues a gap g by its gradient d and its curvature. This is wrong where d turns far
//! within a step, like the lowest point of a rim that is almost flat. The curvature of a rim of
//! radius R at the inclination s is about R ω²/s. Such curvatures are not used. Instead, the end of
//! the step is computed without them, at the velocities v*. If bodies overlap there, at q*, the
//! step is repeated with the bound
//!
//! ```text
//! g(q*) + h d(q*)·(v⁺ − v*) ≥ 0.
//! ```
//!
//! The gap of a convex body over a plane is concave in its motion. A bound therefore never forbids
//! what the contact permits, and its impulses add no energy. If the bound before it is then
//! violated, the body is held at two places. These may be both ends of a diameter of a flat coin.
//! Both bounds are satisfied with equality by a mean of them, to which one reaction belongs. Its
//! share is the zero of the difference of both gaps. The mean is a bound as well, to which the
//! next one is added.
//!
//! Source: Kelley, "The cutting-plane method for solving convex programs", *J. SIAM* 8 (1960)
//! 703–712.
//!
//! # A coin in numbers
//!
//! Its radius is 1 and its inclination 0.001. It falls at the speed 1 onto its lowest point A,
//! which stops. With a moment of inertia of ¼ the coin then turns at the rate 0.8. In a step of
//! 0.01, the opposite point B would fall by 0.016, to 0.014 below the ground. The bounds of A and B
//! with equal shares have a reaction at the centre. It stops the coin, up to the rate by which it
//! gets flat.

use super::padding::own;
use super::step::{ContactStep, Impulses};
use super::{ContactSystem, Terms};
use crate::linalg::vector::{combined, inner, l1_distance};
use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, OdeSystem, displaced};

/// Distance at which a bound replaces another one, as a part of that between two bounds.
const NEAR: f64 = 0.02;
/// Part of an overlap to which two bounds must reduce it for one of them to be replaced alone.
const SHRUNK: f64 = 0.25;
/// Number of bounds that a step adds.
const BOUNDS: u32 = 16;
/// Number of steps of the search for a share.
const SHARES: u32 = 24;

/// Time, position and velocities at the beginning of a step.
pub(super) type Beginning<'a, M, const N: usize> =
    (<M as OdeSystem>::Scalar, &'a <M as MechanicalSystem>::Coordinates, &'a [<M as OdeSystem>::Scalar; N]);

/// Linear bounds of gaps, and slip velocities, at one position.
struct Bounds<S, const N: usize, const K: usize> {
    rows: [[S; N]; K],
    responses: [[S; N]; K],
    gaps: [S; K],
    rates: [S; K],
}

impl<S: Scalar, const N: usize, const K: usize> Bounds<S, N, K> {
    fn of(terms: &Terms<S, N, K>) -> Self {
        Bounds { rows: terms.rows, responses: terms.responses, gaps: terms.gaps, rates: terms.rates }
    }
}

/// Returns the bound of contact k in a pair that remains if the next one replaces the other, which
/// is close to it.
fn opposite<S: Scalar, const N: usize, const K: usize>(
    k: usize,
    [first, second]: [Bounds<S, N, K>; 2],
    next: &Bounds<S, N, K>,
) -> Option<Bounds<S, N, K>> {
    let apart = |a: &Bounds<S, N, K>, b: &Bounds<S, N, K>| l1_distance(&a.rows[k], &b.rows[k]);
    let close = S::from_f64(NEAR) * apart(&first, &second);
    match [apart(&first, next) < close, apart(&second, next) < close] {
        [_, true] => Some(first),
        [true, _] => Some(second),
        _ => None,
    }
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Removes the curvatures of these contacts and of their friction.
    pub(super) fn remove_curvatures(&mut self, contacts: &[bool; K]) {
        for k in 0..K {
            if contacts[k] || (0..K).any(|contact| contacts[contact] && self.is_limited_by(k, contact)) {
                self.drifts[k] = S::ZERO;
            }
        }
    }

    /// True if limits of friction k depend on this reaction.
    fn is_limited_by(&self, k: usize, reaction: usize) -> bool {
        self.slopes_of(k).any(|slope| slope.reaction == reaction)
    }
}

impl<S: Scalar, const N: usize, const K: usize> ContactStep<'_, S, N, K> {
    /// Repeats a step as long as contacts whose gradients jump overlap at its end.
    #[inline(never)]
    pub(super) fn follow<M>(
        &mut self,
        system: &M,
        beginning: Beginning<'_, M, N>,
        jumps: &[bool; K],
        (restitutions, first): (&[S; K], Impulses<S, N, K>),
    ) -> Impulses<S, N, K>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let mut found = first;
        let gaps = self.terms.gaps;
        let mut held: Option<(usize, S, [Bounds<S, N, K>; 2])> = None;
        for _ in 0..BOUNDS {
            let (ends, mut next) = self.bounds_at_end(system, beginning, &found.change);
            // Positions do not change along lines: a bound may be too low by the third order.
            next.gaps.iter_mut().zip(gaps).for_each(|(bound, gap)| *bound = bound.max(gap));
            let overlaps = |k: &usize| jumps[*k] && ends[*k] < gaps[*k].min(S::ZERO) - self.closed;
            let deepest = |a: usize, b: usize| if ends[b] < ends[a] { b } else { a };
            let Some(k) = (0..K).filter(overlaps).reduce(deepest) else { break };
            let shrinks = |(of, depth, _): &(usize, S, _)| *of == k && ends[k] > S::from_f64(SHRUNK) * *depth;
            let other = held.take().filter(shrinks).and_then(|(_, _, pair)| opposite(k, pair, &next));
            let pair = [other.unwrap_or_else(|| Bounds::of(self.terms)), next];
            let iterations = found.iterations;
            found = self.bounded(k, &pair, restitutions, &found.impulses);
            found.iterations += iterations;
            held = Some((k, ends[k], pair));
        }
        self.terms.gaps = gaps;
        found
    }

    /// Returns the gaps at the end of a step with this change of velocities, and bounds there.
    fn bounds_at_end<M>(
        &self,
        system: &M,
        (t, q, v): Beginning<'_, M, N>,
        change: &[S; N],
    ) -> ([S; K], Bounds<S, N, K>)
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let h = self.h;
        let added = combined(change, h, &self.terms.free);
        let to = combined(v, S::ONE, &added);
        let velocities = own(system, &to);
        let moved = combined(q, h, &system.position_rates(t, q, &velocities));
        let moved = displaced(system, t, &moved, [(S::ZERO, &velocities)]);
        let mut forced = system.step_terms(t + h, &moved, &to, h);
        let mut bounds = match self.metric.is_normal() {
            true => Bounds::of(forced.terms()),
            false => Bounds::of(forced.normalise().0),
        };
        let ends = bounds.gaps;
        for (k, end) in ends.iter().enumerate() {
            bounds.gaps[k] = *end - h * bounds.rates[k];
            bounds.rates[k] = bounds.rates[k] - inner(&bounds.rows[k], &added);
        }
        (ends, bounds)
    }

    /// Returns the impulses with these two bounds of contact k. The first alone is not enough.
    fn bounded(
        &mut self,
        k: usize,
        pair: &[Bounds<S, N, K>; 2],
        restitutions: &[S; K],
        start: &[S; K],
    ) -> Impulses<S, N, K> {
        let solved = |step: &mut Self, share: S| {
            step.mix(k, pair, share);
            let found = step.solve(restitutions, start);
            let [before, after] = [0, 1].map(|i| step.gap_at_end(&pair[i], k, &found.change));
            (found, before, after - before)
        };
        let (mut best, before, difference) = solved(self, S::ONE);
        if before >= -self.closed || difference <= S::ZERO {
            return best;
        }
        let (found, _, least) = solved(self, S::ZERO);
        if least >= S::ZERO {
            return found;
        }
        let mut ends = [(S::ZERO, least), (S::ONE, difference)];
        let mut kept = None;
        for _ in 0..SHARES {
            let [low, high] = ends;
            let share = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let iterations = best.iterations;
            let (found, _, difference) = solved(self, share);
            best = found;
            best.iterations += iterations;
            if difference.abs() <= self.closed {
                break;
            }
            let (moves, stays) = if difference < S::ZERO { (0, 1) } else { (1, 0) };
            ends[moves] = (share, difference);
            if kept == Some(stays) {
                ends[stays].1 = S::from_f64(0.5) * ends[stays].1;
            }
            kept = Some(stays);
        }
        best
    }

    /// Returns the gap k at the end of a step by these bounds.
    fn gap_at_end(&self, bounds: &Bounds<S, N, K>, k: usize, change: &[S; N]) -> S {
        let rate = inner(&bounds.rows[k], &combined(change, self.h, &self.terms.free));
        self.h.multiply_add(bounds.rates[k] + rate, bounds.gaps[k])
    }

    /// Replaces the bound of contact k and its friction by a mean of two; the share is that of the
    /// second.
    fn mix(&mut self, contact: usize, [first, second]: &[Bounds<S, N, K>; 2], share: S) {
        let mean = |a: S, b: S| share.multiply_add(b - a, a);
        for k in 0..K {
            if k != contact && !self.terms.is_limited_by(k, contact) {
                continue;
            }
            let means = |a: &[S; N], b: &[S; N]| core::array::from_fn(|i| mean(a[i], b[i]));
            self.terms.rows[k] = means(&first.rows[k], &second.rows[k]);
            self.terms.responses[k] = means(&first.responses[k], &second.responses[k]);
            self.terms.rates[k] = mean(first.rates[k], second.rates[k]);
            if k == contact {
                self.terms.gaps[k] = mean(first.gaps[k], second.gaps[k]);
            }
            self.free[k] =
                self.h.multiply_add(inner(&self.terms.rows[k], &self.terms.free), self.terms.rates[k]);
        }
    }
}
