//! The classical Runge–Kutta method of order four.
//!
//! ```text
//!  0  |
//! 1/2 | 1/2
//! 1/2 |  0   1/2
//!  1  |  0    0    1
//! ----+--------------------
//!     | 1/6  1/3  1/3  1/6
//! ```
//!
//! One motion, several in lanes, and derivatives of a step go through the same stages.
//! [`RungeKuttaStages`] holds their nodes and weights. The sum of a step is written out: equal
//! weights are factored out, which saves a product for each component.
//!
//! Sources: Kutta 1901; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*,
//! §II.1, table 1.2.

mod derivatives;
mod lanes;

pub use self::lanes::ClassicalLanes;

use crate::integrate::explicit::{ExplicitRungeKutta, TableauRow};
use crate::integrate::fixed::{Formula, Memory, Step, WithinStep, fixed_steps};
use crate::integrate::interpolation::cubic;
use crate::integrate::method::{Method, SuspectStep, Work};
use crate::integrate::stability::{EVALUATIONS, Watch, eigenvalue_at, largest_eigenvalue};
use crate::linalg::vector::{combined, l1_distance, l1_norm};
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, StateVector, StepFailure};

/// Computes the state after one step of length `h` from `y` at time `t`, by the classical
/// Runge–Kutta method.
///
/// It evaluates the right-hand side four times; the error of a step is O(h⁵). A negative `h` steps
/// backwards in time. Values are not checked and may be NaN or infinite.
#[inline]
pub fn rk4_step<M>(system: &M, t: M::Scalar, y: &M::State, h: M::Scalar) -> M::State
where
    M: OdeSystem + ?Sized,
{
    let stages = RungeKuttaStages::after(system.rhs(t, y), |t, y| system.rhs(t, y), (t, y), h);
    combined(y, M::Scalar::ONE, &stages.increment(h))
}

/// The nodes of the stages. Each stage depends on the rate before it alone, with the node as its
/// weight.
const NODES: [f64; 4] = [0.0, 0.5, 0.5, 1.0];
/// The weights of the rates in a step, in sixths.
const SIXTHS: [f64; 4] = [1.0, 2.0, 2.0, 1.0];

/// Maximum |h λ| of stable steps on the negative real axis; the limit on the imaginary axis is
/// slightly larger.
const STABLE: f64 = 2.785;

/// The classical Runge–Kutta method of order four in equal steps, for any system.
///
/// It uses four evaluations per step and is not symplectic: the energy drifts in proportion to time
/// and h⁵. Steps longer than about 2.8 times the shortest time constant are rejected as unstable.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RungeKutta4<S> {
    /// Length of a step.
    pub step: S,
}

impl<M: OdeSystem + ?Sized> Method<M> for RungeKutta4<M::Scalar> {
    fixed_steps! { "Runge–Kutta 4", 4, Classical<M::State> = Classical::new(), lanes }
}

impl<S> ExplicitRungeKutta for RungeKutta4<S> {
    const STAGES: &'static [TableauRow] = &[
        TableauRow { node: NODES[0], weights: &[] },
        TableauRow { node: NODES[1], weights: &[(0, NODES[1])] },
        TableauRow { node: NODES[2], weights: &[(1, NODES[2])] },
        TableauRow { node: NODES[3], weights: &[(2, NODES[3])] },
    ];
    const ADVANCE: TableauRow = TableauRow {
        node: 1.0,
        weights: &[(0, SIXTHS[0] / 6.0), (1, SIXTHS[1] / 6.0), (2, SIXTHS[2] / 6.0), (3, SIXTHS[3] / 6.0)],
    };
}

/// The formula of [`RungeKutta4`]; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct Classical<Y> {
    /// The rate at the start of the last increment.
    trial: Y,
    /// The rate at the start of the last accepted step.
    start: Y,
    /// The rate at the end of the last accepted step, if it was requested.
    end: Option<Y>,
    watch: Watch,
}

impl<M: OdeSystem + ?Sized> Formula<M> for Classical<M::State> {
    fn variables(&mut self, _system: &M, _t: M::Scalar, y: &M::State) -> M::State {
        self.end = None;
        *y
    }

    #[inline]
    fn increment(&mut self, step: &Step<'_, M>, work: &mut Work) -> Result<M::State, StepFailure<M::Scalar>> {
        let Step { system, t, y, h } = *step;
        let k1 = self.end.take().unwrap_or_else(|| {
            work.evaluations += 1;
            system.rhs(t, y)
        });
        work.evaluations += 3;
        let stages = RungeKuttaStages::after(k1, |t, y| system.rhs(t, y), (t, y), h);
        self.trial = stages.rates[0];
        self.check(step, &stages, work)?;
        Ok(stages.increment(h))
    }

    #[inline]
    fn accept(&mut self, _t: M::Scalar) {
        self.start = self.trial;
        self.end = None;
    }

    fn longest_stable(&self, system: &M, t: M::Scalar, y: &M::State, work: &mut Work) -> Option<M::Scalar> {
        longest_stable(system, t, y, work)
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, work: &mut Work) -> M::State {
        let end = *self.end.get_or_insert_with(|| {
            work.evaluations += 1;
            within.system.rhs(within.to.0, within.to.1)
        });
        cubic(within.place(), within.states(), [&self.start, &end])
    }
}

impl<S, Y> Memory<S> for Classical<Y> {
    /// Resets the rate at the end, which is recomputed from the same state.
    fn visit(&mut self, _t: S, _each: &mut impl FnMut(&mut S)) {
        self.end = None;
    }
}

impl<Y> Classical<Y> {
    fn new<S: Scalar>() -> Self
    where
        Y: StateVector<S>,
    {
        Classical { trial: Y::ZERO, start: Y::ZERO, end: None, watch: Watch::default() }
    }

    /// Rejects the step if a component is too fast for it.
    #[inline]
    fn check<M>(
        &mut self,
        &Step { system, t, y, h }: &Step<'_, M>,
        stages: &RungeKuttaStages<Y>,
        work: &mut Work,
    ) -> Result<(), StepFailure<M::Scalar>>
    where
        M: OdeSystem<State = Y> + ?Sized,
        Y: StateVector<M::Scalar>,
    {
        if !self.watch.follows(hints_at_instability(stages)) {
            return Ok(());
        }
        work.evaluations += EVALUATIONS;
        let limit = longest_bearable(system, &stages.suspect((t, y), h));
        if h.abs() > limit { Err(StepFailure::StepTooLong { step: h.abs(), limit }) } else { Ok(()) }
    }
}

/// Returns the approximate length of the longest stable step where this one was tried; NaN if it
/// cannot be determined.
#[cold]
fn longest_bearable<M: OdeSystem + ?Sized>(
    system: &M,
    SuspectStep { t, y, direction, change, .. }: &SuspectStep<M::Scalar, M::State>,
) -> M::Scalar {
    M::Scalar::from_f64(STABLE) / largest_eigenvalue(|y| system.rhs(*t, y), y, *change, direction)
}

/// True if a step with these stages may be too long for a fast component. Up to higher powers of h,
/// k₃ − k₂ is (h/2)² J² k₁ with the Jacobian J.
#[inline(always)]
fn hints_at_instability<S: Number, Y: StateVector<S>>(stages: &RungeKuttaStages<Y>) -> S::Mask {
    let [k1, k2, k3, _] = &stages.rates;
    let hint = S::from_f64(STABLE * STABLE / 4.0) * l1_norm(k1);
    hint.less(l1_distance(k2, k3))
}

/// Returns the approximate length of the longest stable step from here; `None` if nothing moves.
#[cold]
fn longest_stable<M: OdeSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    work: &mut Work,
) -> Option<M::Scalar> {
    let rates = |y: &M::State| {
        work.evaluations += 1;
        system.rhs(t, y)
    };
    let eigenvalue = eigenvalue_at(rates, y)?;
    Some(M::Scalar::from_f64(STABLE) / eigenvalue)
}

/// The rates of the four stages.
#[derive(Clone, Copy, Debug)]
struct RungeKuttaStages<Y> {
    rates: [Y; 4],
}

impl<Y> RungeKuttaStages<Y> {
    /// Creates stages before their evaluation.
    #[inline(always)]
    fn new<S: Number>() -> Self
    where
        Y: StateVector<S>,
    {
        RungeKuttaStages { rates: [Y::ZERO; 4] }
    }

    /// Evaluates the stages after the first one, whose rate is `k1`.
    #[inline(always)]
    fn after<S: Number>(k1: Y, rate: impl Fn(S, &Y) -> Y, (t, y): (S, &Y), h: S) -> Self
    where
        Y: StateVector<S>,
    {
        let mut stages = Self::new();
        stages.rates[0] = k1;
        for stage in 1..NODES.len() {
            let (ahead, place) = stages.place(stage, y, h);
            stages.rates[stage] = rate(t + ahead, &place);
        }
        stages
    }

    /// Returns the time of a stage after the start of the step, and its state.
    #[inline(always)]
    fn place<S: Number>(&self, stage: usize, y: &Y, h: S) -> (S, Y)
    where
        Y: StateVector<S>,
    {
        let (ahead, rate) = match stage.checked_sub(1) {
            Some(before) => (S::from_f64(NODES[stage]) * h, &self.rates[before]),
            None => (S::ZERO, &Y::ZERO),
        };
        (ahead, combined(y, ahead, rate))
    }

    /// Returns the step of length h from `y` at time t as a suspect step.
    #[inline]
    fn suspect<S: Number>(&self, (t, y): (S, &Y), h: S) -> SuspectStep<S, Y>
    where
        Y: StateVector<S>,
    {
        let [k1, k2, k3, _] = &self.rates;
        let direction = combined(k3, -S::ONE, k2);
        SuspectStep { t, y: *y, h, direction, change: h.abs() * l1_norm(k1) }
    }

    /// Computes h (k₁ + 2 k₂ + 2 k₃ + k₄)/6.
    #[inline(always)]
    fn increment<S: Number>(&self, h: S) -> Y
    where
        Y: StateVector<S>,
    {
        let (sixth, two) = (h / S::from_f64(6.0), S::from_f64(SIXTHS[1]));
        let [k1, k2, k3, k4] = &self.rates;
        let mut increment = *k1;
        let middle = k2.as_ref().iter().zip(k3.as_ref());
        for ((sum, (k2, k3)), k4) in increment.as_mut().iter_mut().zip(middle).zip(k4.as_ref()) {
            *sum = sixth * (*sum + two * (*k2 + *k3) + *k4);
        }
        increment
    }
}

#[cfg(test)]
mod tests;
