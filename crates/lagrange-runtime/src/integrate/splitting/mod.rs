//! Explicit symplectic methods for separable systems: alternating kicks and drifts.
//!
//! With time as an additional coordinate, the motion is split into two exactly solvable ones,
//!
//! ```text
//! kick:   v += β h a(t, q)                drift:   q += α h v,   t += α h
//! ```
//!
//! and a method composes kicks β₀, β₁, … and drifts α₁, α₂, …: first the kick β₀, then each drift
//! αᵢ with the kick βᵢ after it. Every part is symplectic in (q, M v) with the constant mass matrix
//! M, for any dependence of the forces on time. Their composition is symplectic, too. Each kick and
//! drift also conserves the momenta of linear symmetries, such as the angular momentum in Cartesian
//! coordinates. The last kick of a step shares its acceleration with the first kick of the next
//! step.
//!
//! A single drift between kicks can also end on constraints on positions. Several drifts would
//! leave the constraints in between.
//!
//! Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*, 2nd ed., §II.5 and §VI.3.

mod blanes_moan;
mod constrained;
mod derivatives;
mod lanes;
mod symplectic_euler;
mod verlet;

use crate::integrate::fixed::{Formula, Memory, Step, WithinStep};
use crate::integrate::interpolation::{Motion, Place, quintic};
use crate::integrate::method::Work;
use crate::integrate::stability::{self, Watch};
use crate::linalg::vector::{combined, l1_distance, l1_norm};
use crate::scalar::{Number, Scalar};
use crate::system::{LeapfrogSystem, StateVector, StepFailure, join, split};

pub use self::blanes_moan::BlanesMoan4;
pub use self::lanes::SplittingLanes;
pub use self::symplectic_euler::SymplecticEuler;
pub use self::verlet::StormerVerlet;

/// A composition of kicks and drifts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Composition<const DRIFTS: usize> {
    /// The kick before the first drift.
    first: f64,
    /// Drifts, each with the kick after it.
    rest: [(f64, f64); DRIFTS],
    /// Maximum product of the step and the frequency of an oscillation for which its amplitude is
    /// bounded.
    stable: f64,
}

/// The formula of a composition; S is the scalar and Q the vector of coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Splitting<S, Q, const DRIFTS: usize> {
    composition: Composition<DRIFTS>,
    /// The end time of the last accepted step, if the acceleration there is still valid.
    known: Option<S>,
    /// True if the state there was moved onto constraints.
    was_moved: bool,
    /// Parts of the last increment.
    trial: Trial<S, Q>,
    /// Parts of the increment of the last accepted step.
    taken: Trial<S, Q>,
    watch: Watch,
}

/// A tentative step.
#[derive(Clone, Copy, Debug)]
struct Trial<S, Q> {
    h: S,
    change: Q,
    accelerations: [Q; 2],
}

impl<S: Scalar, Q: StateVector<S>, const DRIFTS: usize> Splitting<S, Q, DRIFTS> {
    pub(super) fn new(composition: Composition<DRIFTS>) -> Self {
        let nothing = Trial { h: S::ZERO, change: Q::ZERO, accelerations: [Q::ZERO; 2] };
        Splitting {
            composition,
            known: None,
            was_moved: false,
            trial: nothing,
            taken: nothing,
            watch: Watch::default(),
        }
    }
}

impl<S: Scalar, Q: StateVector<S>, const DRIFTS: usize> Memory<S> for Splitting<S, Q, DRIFTS> {
    fn visit(&mut self, t: S, each: &mut impl FnMut(&mut S)) {
        let mut is_known = if self.known == Some(t) { S::ONE } else { S::ZERO };
        each(&mut is_known);
        self.taken.accelerations[1].as_mut().iter_mut().for_each(each);
        self.known = (is_known != S::ZERO).then_some(t);
    }
}

impl<M, const DRIFTS: usize> Formula<M> for Splitting<M::Scalar, M::Coordinates, DRIFTS>
where
    M: LeapfrogSystem + ?Sized,
{
    const KEEPS_CONSTRAINTS: bool = M::IS_HELD;

    fn variables(&mut self, _system: &M, _t: M::Scalar, y: &M::State) -> M::State {
        self.known = None;
        *y
    }

    #[inline]
    fn increment(
        &mut self,
        &Step { system, t, y, h }: &Step<'_, M>,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let (q, v) = split::<M>(y);
        let start = match self.known {
            Some(time) if time == t => self.taken.accelerations[1],
            _ => {
                work.evaluations += 1;
                system.acceleration(t, &q, &v)
            }
        };
        work.evaluations += DRIFTS as u64;
        let (trial, gain) = if M::IS_HELD {
            constrained::composed(system, &self.composition, t, (&q, &v), h, &start, work)?
        } else {
            composed(system, &self.composition, t, (&q, &v), h, &start, |_| {})
        };
        self.trial = trial;
        self.check(system, t, (&q, &v), work)?;
        Ok(join::<M>(&trial.change, &gain))
    }

    fn follow(
        &mut self,
        _system: &M,
        _t: M::Scalar,
        (_, to): (&M::State, &M::State),
        variables: &mut M::State,
    ) {
        *variables = *to;
        self.was_moved = true;
    }

    #[inline]
    fn accept(&mut self, t: M::Scalar) {
        // The last acceleration belongs to the state before the correction.
        self.known = if core::mem::take(&mut self.was_moved) { None } else { Some(t) };
        self.taken = self.trial;
    }

    fn longest_stable(&self, system: &M, t: M::Scalar, y: &M::State, work: &mut Work) -> Option<M::Scalar> {
        let (q, v) = split::<M>(y);
        let rates = |q: &M::Coordinates| {
            work.evaluations += 1;
            system.acceleration(t, q, &v)
        };
        let square = stability::eigenvalue_at(rates, &q)?;
        Some(M::Scalar::from_f64(self.composition.stable) / square.sqrt())
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, _work: &mut Work) -> M::State {
        let [(q, v), (_, v_end)] = within.states().map(split::<M>);
        let Trial { h, change, accelerations, .. } = self.taken;
        let place = Place { h, ..within.place() };
        let (change, velocity) = quintic(place, &Motion { change, velocities: [v, v_end], accelerations });
        join::<M>(&combined(&q, M::Scalar::ONE, &change), &velocity)
    }
}

/// A drift and the place of the kick after it.
struct Kick<'a, M: LeapfrogSystem + ?Sized> {
    drift: f64,
    kick: f64,
    t: M::Scalar,
    q: &'a M::Coordinates,
    v: &'a M::Coordinates,
}

/// Computes the step with this composition from `q` and `v` at time `t`, where the acceleration is
/// `start`, and the change of the velocities. Each kick but the first is visited.
#[inline]
fn composed<M: LeapfrogSystem + ?Sized, const DRIFTS: usize>(
    system: &M,
    composition: &Composition<DRIFTS>,
    t: M::Scalar,
    (q, v): (&M::Coordinates, &M::Coordinates),
    h: M::Scalar,
    start: &M::Coordinates,
    mut visit: impl FnMut(Kick<'_, M>),
) -> (Trial<M::Scalar, M::Coordinates>, M::Coordinates) {
    let (number, zero) = (M::Scalar::from_f64, M::Coordinates::ZERO);
    let (mut change, mut acceleration, mut drifted) = (zero, *start, 0.0);
    let mut gain = combined(&zero, number(composition.first) * h, start);
    for (drift, kick) in composition.rest {
        drifted += drift;
        let velocity = combined(v, M::Scalar::ONE, &gain);
        change = combined(&change, number(drift) * h, &velocity);
        let (time, position) = (t + number(drifted) * h, combined(q, M::Scalar::ONE, &change));
        acceleration = system.acceleration(time, &position, &velocity);
        visit(Kick { drift, kick, t: time, q: &position, v: &velocity });
        gain = combined(&gain, number(kick) * h, &acceleration);
    }
    (Trial { h, change, accelerations: [*start, acceleration] }, gain)
}

impl<S: Scalar, Q: StateVector<S>, const DRIFTS: usize> Splitting<S, Q, DRIFTS> {
    /// Rejects the step if an oscillation is too fast for it.
    #[inline]
    fn check<M>(&mut self, system: &M, t: S, (q, v): (&Q, &Q), work: &mut Work) -> Result<(), StepFailure<S>>
    where
        M: LeapfrogSystem<Scalar = S, Coordinates = Q> + ?Sized,
    {
        let ([start, end], h) = (&self.trial.accelerations, self.trial.h);
        let stable = S::from_f64(self.composition.stable);
        let (change, bent) = (l1_norm(&self.trial.change), l1_distance(start, end));
        if !self.watch.follows(bent * (h * h) > stable * stable * change) {
            return Ok(());
        }
        work.evaluations += stability::EVALUATIONS;
        let rates = |q: &Q| system.acceleration(t, q, v);
        let direction = combined(end, -S::ONE, start);
        let limit = stable / stability::largest_eigenvalue(rates, q, change, &direction).sqrt();
        if h.abs() > limit {
            return Err(StepFailure::StepTooLong { step: h.abs(), limit });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
