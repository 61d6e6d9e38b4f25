//! The method for several motions side by side.

use super::{RungeKutta4, RungeKuttaStages, hints_at_instability, longest_stable};
use crate::integrate::clock::Clock;
use crate::integrate::compensated::Compensated;
use crate::integrate::interpolation::{Place, cubic};
use crate::integrate::lane_wise::{Counts, are_finite, chosen, is_equal, splat};
use crate::integrate::method::{LanesMethod, LanesStepper, MOST_LANES, Work};
use crate::integrate::stability::Watch;
use crate::linalg::vector::combined;
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{Equations, OdeSystem, SideBySide, StateVector};

/// Integrations by [`RungeKutta4`] side by side; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct RungeKuttaLanes<S: Number, Y> {
    end: S,
    clock: Clock<S>,
    state: Compensated<Y>,
    /// The rates where the last steps began.
    start: Y,
    suspicion: S::Mask,
    watches: [Watch; MOST_LANES],
    are_watched: bool,
    most_steps: u64,
    counts: Counts,
}

/// The last steps by [`RungeKutta4`] side by side.
#[derive(Clone, Copy, Debug)]
pub struct RungeKuttaLastStep<S, Y> {
    /// Where they began.
    t: S,
    y: Y,
    /// The rates where they ended, if states within them were asked for.
    end: Y,
}

impl<T: Scalar> LanesMethod<T> for RungeKutta4<T> {
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>> = RungeKuttaLanes<S, E::State>;

    #[inline(always)]
    fn start<S, E>(&self, _equations: &E, t: T, y: &E::State, end: T) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        RungeKuttaLanes {
            end: splat(end),
            clock: Clock::new(splat(t), splat(self.step)),
            state: Compensated::new(*y),
            start: E::State::ZERO,
            suspicion: S::Mask::splat(false),
            watches: [Watch::default(); MOST_LANES],
            are_watched: false,
            most_steps: u64::MAX,
            counts: Counts::new(),
        }
    }

    fn bears<M: OdeSystem<Scalar = T>>(&self, system: &M, t: T, y: &M::State) -> bool {
        longest_stable(system, t, y, &mut Work::default()).is_none_or(|limit| self.step <= limit)
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
        let (t, y) = (self.clock.time(), self.state.value());
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

    /// Gives motions up that are not finite or took more steps than they may.
    #[cold]
    fn give_up(&mut self, are_finite: S::Mask) {
        for lane in 0..S::LANES {
            if !are_finite.lane(lane) || self.counts.tried(lane) > self.most_steps {
                self.clock.set_time(lane, S::Element::NAN);
            }
        }
    }

    /// Follows hints where they are worth it.
    #[cold]
    fn watch(&mut self, hints: S::Mask) {
        let mut followed = S::ZERO;
        self.are_watched = false;
        for lane in 0..S::LANES {
            if self.watches[lane].follows(hints.lane(lane)) {
                followed.set_lane(lane, S::Element::ONE);
            }
            self.are_watched |= self.watches[lane].is_awake();
        }
        self.suspicion = S::ZERO.less(followed);
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
        RungeKuttaLastStep { t: self.clock.time(), y: *self.state.value(), end: E::State::ZERO }
    }

    #[inline(always)]
    fn begin(&self, last: &mut Self::LastStep) {
        (last.t, last.y) = (self.clock.time(), *self.state.value());
    }

    #[inline(always)]
    fn confirm(&mut self, equations: &E, last: &mut Self::LastStep, _asked: S::Mask) {
        last.end = equations.rhs(self.clock.time(), self.state.value());
    }

    #[inline(always)]
    fn interpolate(&self, last: &Self::LastStep, t: S) -> E::State {
        let (to, y) = (self.clock.time(), self.state.value());
        let h = to - last.t;
        let within = cubic(Place { h, s: (t - last.t) / h }, [&last.y, y], [&self.start, &last.end]);
        chosen(is_equal(t, to), y, &within)
    }

    #[inline(always)]
    fn step(&mut self, equations: &E) {
        let mut clock = self.clock;
        let h = clock.advance(self.end);
        let stages = self.evaluate(equations, h);
        self.start = stages.k1;
        self.state.add(&stages.increment(h));
        self.clock = clock;
        let are_spent = self.counts.count::<S>(S::Mask::splat(true), self.most_steps);
        let are_finite = are_finite(self.state.value());
        if are_spent || !are_finite.all() {
            self.give_up(are_finite);
        }
        let hints = hints_at_instability(&stages);
        self.suspicion = S::Mask::splat(false);
        if self.are_watched || hints.any() {
            self.watch(hints);
        }
    }

    #[inline(always)]
    fn time(&self) -> S {
        self.clock.time()
    }

    #[inline(always)]
    fn state(&self) -> &E::State {
        self.state.value()
    }

    #[inline(always)]
    fn suspicion(&self) -> S::Mask {
        self.suspicion
    }

    fn limit_steps(&mut self, most: u64) {
        self.most_steps = most;
    }

    fn work(&self, lane: usize) -> Work {
        let steps = self.counts.taken(lane);
        Work { steps, evaluations: 4 * steps, ..Work::default() }
    }

    #[inline(always)]
    fn take(&mut self, lane: usize, other: &Self, from: usize) {
        self.clock.take(lane, &other.clock, from);
        self.state.take(lane, &other.state, from);
        self.watches[lane] = other.watches[from];
        self.are_watched |= other.are_watched;
        self.counts.take(lane, &other.counts, from);
    }
}
