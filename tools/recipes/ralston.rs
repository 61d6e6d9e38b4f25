//! Ralston's method of order two.
//!
//! ```text
//!  0  |
//! 2/3 | 2/3
//! ----+----------
//!     | 1/4  3/4
//! ```
//!
//! Source: Ralston, *Runge–Kutta methods with minimum error bounds*, 1962.

use crate::integrate::explicit::TableauRow;
use crate::integrate::fixed::{
    FixedSteps, Formula, LanesFormula, Memory, Step, WithinStep, fixed_steps,
};
use crate::integrate::interpolation::{Place, cubic};
use crate::integrate::method::{Method, SuspectStep, Work};
use crate::linalg::vector::{combined, l1_norm};
use crate::scalar::{Number, Scalar};
use crate::system::{Equations, OdeSystem, SideBySide, StateVector, StepFailure};

/// The second stage.
const STAGE: TableauRow = TableauRow { node: 2.0 / 3.0, weights: &[(0, 2.0 / 3.0)] };
/// The step, from rates to the change of the state.
const ADVANCE: TableauRow = TableauRow { node: 1.0, weights: &[(0, 0.25), (1, 0.75)] };

/// Ralston's method of order two in equal steps, for any system.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ralston<S> {
    /// Length of a step.
    pub step: S,
}

impl<M: OdeSystem + ?Sized> Method<M> for Ralston<M::Scalar> {
    fixed_steps! { "Ralston", 2, RalstonSteps<M::State> = RalstonSteps::new::<M::Scalar>(), lanes }
}

/// The formula of [`Ralston`], for one motion or for several in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct RalstonSteps<Y> {
    /// The rates of the last increment.
    rates: [Y; 2],
    /// The rate at the start of the last accepted step.
    start: Y,
}

impl<Y> RalstonSteps<Y> {
    #[inline(always)]
    fn new<S: Number>() -> Self
    where
        Y: StateVector<S>,
    {
        RalstonSteps { rates: [Y::ZERO; 2], start: Y::ZERO }
    }

    /// Computes the change of the state in a step.
    #[inline(always)]
    fn advance<S: Number>(&mut self, rate: impl Fn(S, &Y) -> Y, t: S, y: &Y, h: S) -> Y
    where
        Y: StateVector<S>,
    {
        self.rates[0] = rate(t, y);
        self.rates[1] = rate(STAGE.time(t, h), &STAGE.point(y, h, &self.rates));
        ADVANCE.point(&y.zeros(), h, &self.rates)
    }
}

impl<M: OdeSystem + ?Sized> Formula<M> for RalstonSteps<M::State> {
    #[inline]
    fn increment(
        &mut self,
        &Step { system, t, y, h }: &Step<'_, M>,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        work.evaluations += 2;
        Ok(self.advance(|t, y| system.rhs(t, y), t, y, h))
    }

    #[inline]
    fn accept(&mut self, _t: M::Scalar) {
        self.start = self.rates[0];
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, work: &mut Work) -> M::State {
        work.evaluations += 1;
        let (t, y) = within.to;
        cubic(within.place(), within.states(), [&self.start, &within.system.rhs(t, y)])
    }
}

impl<S, Y> Memory<S> for RalstonSteps<Y> {
    /// Visits nothing: a step depends on the state alone.
    fn visit(&mut self, _t: S, _each: &mut impl FnMut(&mut S)) {}
}

impl<T: Scalar> FixedSteps for Ralston<T> {
    type Scalar = T;
    type Formula<S: SideBySide<Element = T>, Y: StateVector<S>> = RalstonSteps<Y>;

    #[inline(always)]
    fn length(&self) -> T {
        self.step
    }

    #[inline(always)]
    fn formula<S: SideBySide<Element = T>, Y: StateVector<S>>() -> RalstonSteps<Y> {
        RalstonSteps::new::<S>()
    }

    fn is_stable<M: OdeSystem<Scalar = T>>(_system: &M, _step: &SuspectStep<T, M::State>) -> bool {
        true
    }
}

impl<S, Y> LanesFormula<S, Y> for RalstonSteps<Y>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// The rates at the ends.
    type End = Y;
    const EVALUATIONS: (u64, u64) = (0, 2);
    const NO_END: Y = Y::ZERO;

    #[inline(always)]
    fn prepare<E: Equations<S, State = Y>>(&mut self, _equations: &E, _t: S, _y: &Y) {}

    #[inline(always)]
    fn carried(&self) -> &[S] {
        &[]
    }

    #[inline(always)]
    fn carried_mut(&mut self) -> &mut [S] {
        &mut []
    }

    #[inline(always)]
    fn increment<E: Equations<S, State = Y>>(&mut self, equations: &E, t: S, y: &Y, h: S) -> Y {
        self.advance(|t, y| equations.rhs(t, y), t, y, h)
    }

    #[inline(always)]
    fn hints_at_instability(&self) -> S::Mask {
        S::ZERO.less(S::ZERO)
    }

    #[inline(always)]
    fn suspect(&self, t: S, y: &Y) -> SuspectStep<S, Y> {
        let [direction, last] = self.rates;
        let direction = combined(&last, -S::ONE, &direction);
        SuspectStep { t, y: *y, h: S::ZERO, direction, change: l1_norm(&last) }
    }

    #[inline(always)]
    fn end<E: Equations<S, State = Y>>(&self, equations: &E, t: S, y: &Y) -> Y {
        equations.rhs(t, y)
    }

    #[inline(always)]
    fn interpolate(&self, (from, y0): (S, &Y), (to, y1): (S, &Y), end: &Y, t: S) -> Y {
        let h = to - from;
        cubic(Place { h, s: (t - from) / h }, [y0, y1], [&self.rates[0], end])
    }
}
