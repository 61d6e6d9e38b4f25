//! Compositions of kicks and drifts for several motions in lanes.
//!
//! Equations in lanes are rates of whole states, [v…, a…]; steps use the accelerations in them.
//! Coordinates and velocities are the halves of a state, since only systems with q̇ = v are
//! separable.

use super::Composition;
use super::blanes_moan::{self, BlanesMoan4};
use super::symplectic_euler::{self, SymplecticEuler};
use super::verlet::{self, StormerVerlet};
use crate::integrate::fixed::FixedLanes;
use crate::integrate::interpolation::{Motion, Place, quintic};
use crate::integrate::lane_wise::{chosen, is_equal, take};
use crate::integrate::method::{LanesMethod, LanesStepper, SuspectStep, Work};
use crate::integrate::stability;
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{Equations, OdeSystem, SideBySide, StateVector};

/// Integrations by a composition in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct SplittingLanes<S: Number, Y, const DRIFTS: usize> {
    motions: FixedLanes<S, Y>,
    composition: Composition<DRIFTS>,
    /// The rates at both ends of the last steps.
    rates: [Y; 2],
    /// Change of the states.
    increment: Y,
    h: S,
}

/// The starts of the last steps by a composition.
#[derive(Clone, Copy, Debug)]
pub struct SplittingLastStep<S, Y> {
    t: S,
    y: Y,
}

impl<S, Y, const DRIFTS: usize> SplittingLanes<S, Y, DRIFTS>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// Motions in equal steps; their states and rates are zero as yet.
    #[inline(always)]
    fn new(composition: Composition<DRIFTS>, motions: FixedLanes<S, Y>) -> Self {
        SplittingLanes { motions, composition, rates: [Y::ZERO; 2], increment: Y::ZERO, h: S::ZERO }
    }

    /// Continues the motions from this state.
    #[inline(always)]
    fn at<E: Equations<S, State = Y>>(self, equations: &E, y: &Y) -> Self {
        let rate = equations.rhs(self.motions.time(), y);
        SplittingLanes { motions: self.motions.at(y), rates: [rate; 2], ..self }
    }

    /// Composes steps of these lengths from the rates where they begin.
    #[inline(always)]
    fn compose<E: Equations<S, State = Y>>(&mut self, equations: &E, h: S) {
        let (t, y) = (self.motions.time(), self.motions.state());
        let (mut increment, mut rate, mut drifted) = (Y::ZERO, self.rates[1], 0.0);
        self.rates[0] = rate;
        kick(&mut increment, S::from_f64(self.composition.first) * h, &rate);
        for (drift, strength) in self.composition.rest {
            drifted += drift;
            self::drift(&mut increment, S::from_f64(drift) * h, y);
            rate = equations.rhs(t + S::from_f64(drifted) * h, &combined(y, S::ONE, &increment));
            kick(&mut increment, S::from_f64(strength) * h, &rate);
        }
        (self.rates[1], self.increment, self.h) = (rate, increment, h);
    }

    /// True in each lane with an oscillation that may be too fast for the last step.
    #[inline(always)]
    fn hints_at_instability(&self) -> S::Mask {
        let half = half(&self.increment);
        let ([start, end], change) = (&self.rates, change(&self.increment));
        let accelerations = start.as_ref()[half..].iter().zip(&end.as_ref()[half..]);
        let bent = accelerations.fold(S::ZERO, |sum, (start, end)| sum + (*start - *end).abs());
        let stable = S::from_f64(self.composition.stable * self.composition.stable);
        (stable * change).less(bent * (self.h * self.h))
    }
}

/// Returns the number of coordinates in a state.
fn half<S, Y: AsRef<[S]>>(y: &Y) -> usize {
    y.as_ref().len() / 2
}

/// Returns the length of the change of states.
#[inline(always)]
fn change<S: Number, Y: AsRef<[S]>>(increment: &Y) -> S {
    increment.as_ref()[..half(increment)].iter().fold(S::ZERO, |sum, change| sum + change.abs())
}

/// v += c a, with the accelerations of these rates
#[inline(always)]
fn kick<S: Number, Y: StateVector<S>>(increment: &mut Y, c: S, rate: &Y) {
    let half = half(rate);
    for (gain, rate) in increment.as_mut()[half..].iter_mut().zip(&rate.as_ref()[half..]) {
        *gain = rate.multiply_add(c, *gain);
    }
}

/// q += c v, with the velocities of the state `y` and what they have gained
#[inline(always)]
fn drift<S: Number, Y: StateVector<S>>(increment: &mut Y, c: S, y: &Y) {
    let half = half(y);
    let (change, gain) = increment.as_mut().split_at_mut(half);
    for ((change, gain), v) in change.iter_mut().zip(gain).zip(&y.as_ref()[half..]) {
        *change = (*v + *gain).multiply_add(c, *change);
    }
}

/// Moves the second half of a state to the first.
#[inline(always)]
fn second_half<S: Number, Y: StateVector<S>>(y: &Y) -> Y {
    let mut moved = Y::ZERO;
    for (moved, entry) in moved.as_mut().iter_mut().zip(&y.as_ref()[half(y)..]) {
        *moved = *entry;
    }
    moved
}

/// True if this step by a composition is stable.
#[cold]
pub(super) fn bears<M: OdeSystem, const DRIFTS: usize>(
    composition: &Composition<DRIFTS>,
    system: &M,
    &SuspectStep { t, ref y, h, ref direction, change }: &SuspectStep<M::Scalar, M::State>,
) -> bool {
    let velocities = half(y);
    // Accelerations as rates of coordinates, while velocities stay what they are.
    let rates = |at: &M::State| {
        let mut state = *at;
        state.as_mut()[velocities..].copy_from_slice(&y.as_ref()[velocities..]);
        second_half(&system.rhs(t, &state))
    };
    let square = stability::largest_eigenvalue(rates, y, change, direction);
    h.abs() <= M::Scalar::from_f64(composition.stable) / square.sqrt()
}

impl<S, E, const DRIFTS: usize> LanesStepper<S, E> for SplittingLanes<S, E::State, DRIFTS>
where
    S: SideBySide<Element: Scalar>,
    E: Equations<S>,
{
    type LastStep = SplittingLastStep<S, E::State>;

    #[inline(always)]
    fn last_step(&self) -> Self::LastStep {
        SplittingLastStep { t: self.motions.time(), y: *self.motions.state() }
    }

    #[inline(always)]
    fn begin(&self, last: &mut Self::LastStep) {
        *last = SplittingLastStep { t: self.motions.time(), y: *self.motions.state() };
    }

    #[inline(always)]
    fn step(&mut self, equations: &E) {
        let (h, clock) = self.motions.next();
        self.compose(equations, h);
        let hints = self.hints_at_instability();
        self.motions.accept(clock, &self.increment, hints, |t, y| {
            let [start, end] = self.rates.each_ref().map(second_half);
            let direction = combined(&end, -S::ONE, &start);
            SuspectStep { t, y, h, direction, change: change(&self.increment) }
        });
    }

    #[inline(always)]
    fn confirm(&mut self, _equations: &E, _last: &mut Self::LastStep, _asked: S::Mask) {}

    #[inline(always)]
    fn interpolate(&self, last: &Self::LastStep, t: S) -> E::State {
        let (to, y) = (self.motions.time(), self.motions.state());
        let motion = Motion {
            change: self.increment,
            velocities: [second_half(&last.y), second_half(y)],
            accelerations: [second_half(&self.rates[0]), second_half(&self.rates[1])],
        };
        let (change, velocity) = quintic(Place { h: self.h, s: (t - last.t) / (to - last.t) }, &motion);
        let mut within = combined(&last.y, S::ONE, &change);
        let half = half(y);
        within.as_mut()[half..].copy_from_slice(&velocity.as_ref()[..half]);
        chosen(is_equal(t, to), y, &within)
    }

    #[inline(always)]
    fn time(&self) -> S {
        self.motions.time()
    }

    #[inline(always)]
    fn state(&self) -> &E::State {
        self.motions.state()
    }

    #[inline(always)]
    fn suspicion(&self) -> S::Mask {
        self.motions.suspicion()
    }

    fn suspects(&self) -> Option<&SuspectStep<S, E::State>> {
        Some(self.motions.suspects())
    }

    fn limit_steps(&mut self, most: u64) {
        self.motions.limit_steps(most);
    }

    fn work(&self, lane: usize) -> Work {
        let steps = self.motions.steps(lane);
        Work { steps, evaluations: 1 + DRIFTS as u64 * steps, ..Work::default() }
    }
}

/// Lets methods with these compositions take several motions in lanes.
macro_rules! side_by_side {
    ($($method:ident: $composition:expr, $drifts:literal;)*) => {
        $(impl<T: Scalar> LanesMethod<T> for $method<T> {
            type Stepper<S: SideBySide<Element = T>, E: Equations<S>> = SplittingLanes<S, E::State, $drifts>;

            #[inline(always)]
            fn empty_lanes<S, E>(&self, t: T, end: T) -> Self::Stepper<S, E>
            where
                S: SideBySide<Element = T>,
                E: Equations<S>,
            {
                SplittingLanes::new($composition, FixedLanes::new(self.step, t, end))
            }

            #[inline(always)]
            fn start<S, E>(&self, equations: &E, t: T, y: &E::State, end: T) -> Self::Stepper<S, E>
            where
                S: SideBySide<Element = T>,
                E: Equations<S>,
            {
                self.empty_lanes::<S, E>(t, end).at(equations, y)
            }

            #[inline(always)]
            fn take<S, E, O, F>(
                stepper: &mut Self::Stepper<S, E>,
                lane: usize,
                other: &Self::Stepper<O, F>,
                from: usize,
            ) where
                S: SideBySide<Element = T>,
                E: Equations<S>,
                O: SideBySide<Element = T>,
                F: Equations<O>,
            {
                stepper.motions.take(lane, &other.motions, from);
                let [_, rate] = &mut stepper.rates;
                take(rate.as_mut(), lane, other.rates[1].as_ref(), from);
            }

            fn bears<M: OdeSystem<Scalar = T>>(&self, system: &M, step: &SuspectStep<T, M::State>) -> bool {
                bears(&$composition, system, step)
            }
        })*
    };
}

side_by_side! {
    SymplecticEuler: symplectic_euler::COMPOSITION, 1;
    StormerVerlet: verlet::COMPOSITION, 1;
    BlanesMoan4: blanes_moan::COMPOSITION, 6;
}
