//! The method for several motions in lanes.

use super::{NODES, RungeKutta4, RungeKuttaStages, hints_at_instability, longest_bearable};
use crate::integrate::fixed::{FixedSteps, LanesFormula};
use crate::integrate::interpolation::{Place, cubic};
use crate::integrate::method::SuspectStep;
use crate::scalar::Scalar;
use crate::system::{Equations, OdeSystem, SideBySide, StateVector};

/// The formula of [`RungeKutta4`] in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct ClassicalLanes<S, Y> {
    stages: RungeKuttaStages<Y>,
    h: S,
}

impl<T: Scalar> FixedSteps for RungeKutta4<T> {
    type Scalar = T;
    type Formula<S: SideBySide<Element = T>, Y: StateVector<S>> = ClassicalLanes<S, Y>;

    #[inline(always)]
    fn length(&self) -> T {
        self.step
    }

    #[inline(always)]
    fn formula<S: SideBySide<Element = T>, Y: StateVector<S>>() -> ClassicalLanes<S, Y> {
        ClassicalLanes { stages: RungeKuttaStages::new(), h: S::ZERO }
    }

    fn is_stable<M: OdeSystem<Scalar = T>>(system: &M, step: &SuspectStep<T, M::State>) -> bool {
        step.h.abs() <= longest_bearable(system, step)
    }
}

impl<S, Y> LanesFormula<S, Y> for ClassicalLanes<S, Y>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// The rates at the ends.
    type End = Y;
    const EVALUATIONS: (u64, u64) = (0, 4);
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
        let mut stages = RungeKuttaStages::new();
        // A single call site, so that the right-hand side is inlined once.
        for stage in 0..NODES.len() {
            let (ahead, place) = stages.place(stage, y, h);
            stages.rates[stage] = equations.rhs(t + ahead, &place);
        }
        *self = ClassicalLanes { stages, h };
        self.stages.increment(h)
    }

    #[inline(always)]
    fn hints_at_instability(&self) -> S::Mask {
        hints_at_instability(&self.stages)
    }

    #[inline(always)]
    fn suspect(&self, t: S, y: &Y) -> SuspectStep<S, Y> {
        self.stages.suspect((t, y), self.h)
    }

    #[inline(always)]
    fn end<E: Equations<S, State = Y>>(&self, equations: &E, t: S, y: &Y) -> Y {
        equations.rhs(t, y)
    }

    #[inline(always)]
    fn interpolate(&self, (from, y0): (S, &Y), (to, y1): (S, &Y), end: &Y, t: S) -> Y {
        let h = to - from;
        cubic(Place { h, s: (t - from) / h }, [y0, y1], [&self.stages.rates[0], end])
    }
}
