//! Compositions of kicks and drifts for several motions in lanes.
//!
//! Equations in lanes return rates of whole states, [v…, a…]; steps use the accelerations in them.
//! Coordinates and velocities are the halves of a state, since only systems with q̇ = v are
//! separable.
//!
//! The composition is the same data as for one motion, whose loop also serves derivatives. This
//! loop stays apart: that one calls the acceleration with coordinates and velocities as separate
//! arrays. Equations in lanes have no such call, and copies between states and halves would cost
//! stores in every lane.

use super::Composition;
use super::blanes_moan::{self, BlanesMoan4};
use super::symplectic_euler::{self, SymplecticEuler};
use super::verlet::{self, StormerVerlet};
use crate::integrate::fixed::{FixedSteps, LanesFormula};
use crate::integrate::interpolation::{Motion, Place, quintic};
use crate::integrate::method::SuspectStep;
use crate::integrate::stability;
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{Equations, OdeSystem, SideBySide, StateVector};

/// The formula of a composition in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct SplittingLanes<S, Y, const DRIFTS: usize> {
    composition: Composition<DRIFTS>,
    /// The rates at both ends of the last steps.
    rates: [Y; 2],
    /// Change of the states.
    increment: Y,
    h: S,
}

impl<S: SideBySide, Y: StateVector<S>, const DRIFTS: usize> SplittingLanes<S, Y, DRIFTS> {
    #[inline(always)]
    fn new(composition: Composition<DRIFTS>) -> Self {
        SplittingLanes { composition, rates: [Y::ZERO; 2], increment: Y::ZERO, h: S::ZERO }
    }
}

impl<S, Y, const DRIFTS: usize> LanesFormula<S, Y> for SplittingLanes<S, Y, DRIFTS>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    type End = ();
    const EVALUATIONS: (u64, u64) = (1, DRIFTS as u64);
    const NO_END: () = ();

    #[inline(always)]
    fn prepare<E: Equations<S, State = Y>>(&mut self, equations: &E, t: S, y: &Y) {
        self.rates = [equations.rhs(t, y); 2];
    }

    #[inline(always)]
    fn carried(&self) -> &[S] {
        self.rates[1].as_ref()
    }

    #[inline(always)]
    fn carried_mut(&mut self) -> &mut [S] {
        self.rates[1].as_mut()
    }

    #[inline(always)]
    fn increment<E: Equations<S, State = Y>>(&mut self, equations: &E, t: S, y: &Y, h: S) -> Y {
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
        increment
    }

    #[inline(always)]
    fn hints_at_instability(&self) -> S::Mask {
        let half = half(&self.increment);
        let ([start, end], change) = (&self.rates, change(&self.increment));
        let accelerations = start.as_ref()[half..].iter().zip(&end.as_ref()[half..]);
        let bent = accelerations.fold(S::ZERO, |sum, (start, end)| sum + (*start - *end).abs());
        let stable = S::from_f64(self.composition.stable * self.composition.stable);
        (stable * change).less(bent * (self.h * self.h))
    }

    #[inline(always)]
    fn suspect(&self, t: S, y: &Y) -> SuspectStep<S, Y> {
        let [start, end] = self.rates.each_ref().map(second_half);
        let direction = combined(&end, -S::ONE, &start);
        SuspectStep { t, y: *y, h: self.h, direction, change: change(&self.increment) }
    }

    #[inline(always)]
    fn end<E: Equations<S, State = Y>>(&self, _equations: &E, _t: S, _y: &Y) {}

    #[inline(always)]
    fn interpolate(&self, (from, y0): (S, &Y), (to, y1): (S, &Y), (): &(), t: S) -> Y {
        let motion = Motion {
            change: self.increment,
            velocities: [second_half(y0), second_half(y1)],
            accelerations: [second_half(&self.rates[0]), second_half(&self.rates[1])],
        };
        let (change, velocity) = quintic(Place { h: self.h, s: (t - from) / (to - from) }, &motion);
        let mut within = combined(y0, S::ONE, &change);
        let half = half(y1);
        within.as_mut()[half..].copy_from_slice(&velocity.as_ref()[..half]);
        within
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

/// Computes v += c a, with the accelerations of these rates.
#[inline(always)]
fn kick<S: Number, Y: StateVector<S>>(increment: &mut Y, c: S, rate: &Y) {
    let half = half(rate);
    for (gain, rate) in increment.as_mut()[half..].iter_mut().zip(&rate.as_ref()[half..]) {
        *gain = rate.multiply_add(c, *gain);
    }
}

/// Computes q += c v, with the velocities of the state `y` and their gain.
#[inline(always)]
fn drift<S: Number, Y: StateVector<S>>(increment: &mut Y, c: S, y: &Y) {
    let half = half(y);
    let (change, gain) = increment.as_mut().split_at_mut(half);
    for ((change, gain), v) in change.iter_mut().zip(gain).zip(&y.as_ref()[half..]) {
        *change = (*v + *gain).multiply_add(c, *change);
    }
}

/// Copies the second half of a state to the first half.
#[inline(always)]
fn second_half<S: Number, Y: StateVector<S>>(y: &Y) -> Y {
    let mut moved = Y::ZERO;
    for (moved, entry) in moved.as_mut().iter_mut().zip(&y.as_ref()[half(y)..]) {
        *moved = *entry;
    }
    moved
}

/// True if this step of a composition is stable.
#[cold]
fn is_stable<M: OdeSystem, const DRIFTS: usize>(
    composition: &Composition<DRIFTS>,
    system: &M,
    &SuspectStep { t, ref y, h, ref direction, change }: &SuspectStep<M::Scalar, M::State>,
) -> bool {
    let velocities = half(y);
    // Accelerations as rates of coordinates, at constant velocities.
    let rates = |at: &M::State| {
        let mut state = *at;
        state.as_mut()[velocities..].copy_from_slice(&y.as_ref()[velocities..]);
        second_half(&system.rhs(t, &state))
    };
    let square = stability::largest_eigenvalue(rates, y, change, direction);
    h.abs() <= M::Scalar::from_f64(composition.stable) / square.sqrt()
}

/// Implements steps in lanes for methods with these compositions.
macro_rules! side_by_side {
    ($($method:ident: $composition:expr, $drifts:literal;)*) => {
        $(impl<T: Scalar> FixedSteps for $method<T> {
            type Scalar = T;
            type Formula<S: SideBySide<Element = T>, Y: StateVector<S>> = SplittingLanes<S, Y, $drifts>;

            #[inline(always)]
            fn length(&self) -> T {
                self.step
            }

            #[inline(always)]
            fn formula<S: SideBySide<Element = T>, Y: StateVector<S>>() -> Self::Formula<S, Y> {
                SplittingLanes::new($composition)
            }

            fn is_stable<M: OdeSystem<Scalar = T>>(system: &M, step: &SuspectStep<T, M::State>) -> bool {
                is_stable(&$composition, system, step)
            }
        })*
    };
}

side_by_side! {
    SymplecticEuler: symplectic_euler::COMPOSITION, 1;
    StormerVerlet: verlet::COMPOSITION, 1;
    BlanesMoan4: blanes_moan::COMPOSITION, 6;
}
