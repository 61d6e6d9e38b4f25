//! The method for several motions in lanes.

use super::{RungeKutta4, RungeKuttaStages, hints_at_instability, longest_bearable};
use crate::integrate::fixed::FixedLanes;
use crate::integrate::interpolation::{Place, cubic};
use crate::integrate::lane_wise::{chosen, is_equal};
use crate::integrate::method::{LanesMethod, LanesStepper, SuspectStep, Work};
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{Equations, OdeSystem, SideBySide, StateVector};

/// Integrations by [`RungeKutta4`] in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct RungeKuttaLanes<S: Number, Y> {
    motions: FixedLanes<S, Y>,
    /// The rates where the last steps began.
    start: Y,
}

/// The last steps by [`RungeKutta4`] in lanes.
#[derive(Clone, Copy, Debug)]
pub struct RungeKuttaLastStep<S, Y> {
    /// Start time of the steps.
    t: S,
    y: Y,
    /// The rates where they ended, if states within them were asked for.
    end: Y,
}

impl<T: Scalar> LanesMethod<T> for RungeKutta4<T> {
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>> = RungeKuttaLanes<S, E::State>;

    #[inline(always)]
    fn empty_lanes<S, E>(&self, t: T, end: T) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        RungeKuttaLanes { motions: FixedLanes::new(self.step, t, end), start: E::State::ZERO }
    }

    #[inline(always)]
    fn start<S, E>(&self, _equations: &E, t: T, y: &E::State, end: T) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        RungeKuttaLanes { motions: FixedLanes::new(self.step, t, end).at(y), start: E::State::ZERO }
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
    }

    fn bears<M: OdeSystem<Scalar = T>>(&self, system: &M, step: &SuspectStep<T, M::State>) -> bool {
        step.h.abs() <= longest_bearable(system, step)
    }
}

impl<S, Y> RungeKuttaLanes<S, Y>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// Evaluates the stages of steps of these lengths.
    #[inline(always)]
    fn evaluate<E: Equations<S, State = Y>>(&self, equations: &E, h: S) -> RungeKuttaStages<Y> {
        let (t, y) = (self.motions.time(), self.motions.state());
        let half = h / S::from_f64(2.0);
        let mut rates = [Y::ZERO; 4];
        // One place of call, so that the right-hand side is inlined once.
        for stage in 0..4 {
            let (ahead, rate) = match stage {
                0 => (S::ZERO, &Y::ZERO),
                1 => (half, &rates[0]),
                2 => (half, &rates[1]),
                _ => (h, &rates[2]),
            };
            rates[stage] = equations.rhs(t + ahead, &combined(y, ahead, rate));
        }
        let [k1, k2, k3, k4] = rates;
        RungeKuttaStages { k1, k2, k3, k4 }
    }
}

impl<S, E> LanesStepper<S, E> for RungeKuttaLanes<S, E::State>
where
    S: SideBySide<Element: Scalar>,
    E: Equations<S>,
{
    type LastStep = RungeKuttaLastStep<S, E::State>;

    #[inline(always)]
    fn last_step(&self) -> Self::LastStep {
        RungeKuttaLastStep { t: self.motions.time(), y: *self.motions.state(), end: E::State::ZERO }
    }

    #[inline(always)]
    fn begin(&self, last: &mut Self::LastStep) {
        (last.t, last.y) = (self.motions.time(), *self.motions.state());
    }

    #[inline(always)]
    fn step(&mut self, equations: &E) {
        let (h, clock) = self.motions.next();
        let stages = self.evaluate(equations, h);
        let hints = hints_at_instability(&stages);
        self.motions.accept(clock, &stages.increment(h), hints, |t, y| stages.suspect((t, &y), h));
        self.start = stages.k1;
    }

    #[inline(always)]
    fn confirm(&mut self, equations: &E, last: &mut Self::LastStep, _asked: S::Mask) {
        last.end = equations.rhs(self.motions.time(), self.motions.state());
    }

    #[inline(always)]
    fn interpolate(&self, last: &Self::LastStep, t: S) -> E::State {
        let (to, y) = (self.motions.time(), self.motions.state());
        let h = to - last.t;
        let within = cubic(Place { h, s: (t - last.t) / h }, [&last.y, y], [&self.start, &last.end]);
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
        Work { steps, evaluations: 4 * steps, ..Work::default() }
    }
}
