//! Steps of equal length for several motions in lanes.

use crate::integrate::clock::{Clock, check_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::lane_wise::{Counts, are_finite, chosen, is_equal, take};
use crate::integrate::method::{LanesMethod, LanesStepper, MAX_LANES, SuspectStep, Work};
use crate::integrate::stability::Watch;
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{Domain, Equations, OdeSystem, SideBySide, StateVector};

/// A formula that advances several motions in lanes, like [`Formula`](super::Formula) for one
/// motion. Y is the state.
pub trait LanesFormula<S: SideBySide, Y: StateVector<S>>: Copy {
    /// Data at the end of a step that interpolation needs in addition to the state.
    type End: Copy;
    /// Number of evaluations at the start of a motion, and in each step.
    const EVALUATIONS: (u64, u64);
    /// The data before any step.
    const NO_END: Self::End;

    /// Prepares for motions that start at the states `y` at time `t`.
    fn prepare<E: Equations<S, State = Y>>(&mut self, equations: &E, t: S, y: &Y);

    /// Returns the numbers that one step passes to the next. Each lane belongs to one motion.
    fn carried(&self) -> &[S];

    /// Returns the same numbers for modification.
    fn carried_mut(&mut self) -> &mut [S];

    /// Returns the change of the states from time `t` to `t + h`.
    fn increment<E: Equations<S, State = Y>>(&mut self, equations: &E, t: S, y: &Y, h: S) -> Y;

    /// True in each lane in which a component may be too fast for the last step.
    fn hints_at_instability(&self) -> S::Mask;

    /// Returns the last step, from `y` at time `t`, as a suspect one.
    fn suspect(&self, t: S, y: &Y) -> SuspectStep<S, Y>;

    /// Returns the interpolation data for the end `y` of the last step at time `t`.
    fn end<E: Equations<S, State = Y>>(&self, equations: &E, t: S, y: &Y) -> Self::End;

    /// Returns the states at time `t` between `from` and `to`, the ends of the last steps with
    /// their times.
    fn interpolate(&self, from: (S, &Y), to: (S, &Y), end: &Self::End, t: S) -> Y;
}

/// A method in equal steps with a formula for lanes, by which it advances motions in lanes.
pub trait FixedSteps: Copy {
    /// The number type.
    type Scalar: Scalar;
    /// The formula.
    type Formula<S: SideBySide<Element = Self::Scalar>, Y: StateVector<S>>: LanesFormula<S, Y>;

    /// Returns the length of a step.
    fn length(&self) -> Self::Scalar;

    /// Creates the formula.
    fn formula<S: SideBySide<Element = Self::Scalar>, Y: StateVector<S>>() -> Self::Formula<S, Y>;

    /// True if this step of a system is stable.
    fn is_stable<M: OdeSystem<Scalar = Self::Scalar>>(
        system: &M,
        step: &SuspectStep<Self::Scalar, M::State>,
    ) -> bool;
}

impl<T: Scalar, K: FixedSteps<Scalar = T>> LanesMethod<T> for K {
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>> =
        FixedLanes<S, E::State, K::Formula<S, E::State>>;

    #[inline(always)]
    fn empty_lanes<S, E>(&self, [t, end]: [T; 2], _domain: &'static Domain) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        FixedLanes::new(K::formula(), self.length(), t, end)
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
        stepper.take(lane, other, from);
    }

    fn bears<M: OdeSystem<Scalar = T>>(&self, system: &M, step: &SuspectStep<T, M::State>) -> bool {
        K::is_stable(system, step)
    }
}

/// Integrations with a formula in equal steps, one in each lane; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct FixedLanes<S: Number, Y, F> {
    formula: F,
    end: S,
    clock: Clock<S>,
    state: Compensated<Y>,
    suspicion: S::Mask,
    suspects: SuspectStep<S, Y>,
    watches: [Watch; MAX_LANES],
    are_watched: bool,
    most_steps: u64,
    counts: Counts,
}

/// The last steps with a formula in lanes; D is the interpolation data at their ends.
#[derive(Clone, Copy, Debug)]
pub struct FixedLastStep<S, Y, D> {
    /// The times at which they began.
    t: S,
    /// The states there.
    y: Y,
    end: D,
}

impl<S, Y, F> FixedLanes<S, Y, F>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
    F: LanesFormula<S, Y>,
{
    /// Creates motions that start at time `t` with steps of this length towards `end`; their states
    /// are initially zero. They are abandoned if such steps are lost in the rounding of time.
    #[inline(always)]
    fn new(formula: F, step: S::Element, t: S::Element, end: S::Element) -> Self {
        let suspects =
            SuspectStep { t: S::ZERO, y: Y::ZERO, h: S::ZERO, direction: Y::ZERO, change: S::ZERO };
        let start = check_step(step, t, end).map_or(S::Element::NAN, |()| t);
        FixedLanes {
            formula,
            end: S::splat(end),
            clock: Clock::new(S::splat(start), S::splat(step)),
            state: Compensated::new(Y::ZERO),
            suspicion: S::Mask::splat(false),
            suspects,
            watches: [Watch::default(); MAX_LANES],
            are_watched: false,
            most_steps: u64::MAX,
            counts: Counts::new(),
        }
    }

    /// Copies the lane `from` of other motions into a lane of these.
    #[inline(always)]
    fn take<O, Z, G>(&mut self, lane: usize, other: &FixedLanes<O, Z, G>, from: usize)
    where
        O: SideBySide<Element = S::Element>,
        Z: StateVector<O>,
        G: LanesFormula<O, Z>,
    {
        take(self.formula.carried_mut(), lane, other.formula.carried(), from);
        self.clock.take(lane, &other.clock, from);
        self.state.take(lane, &other.state, from);
        self.watches[lane] = other.watches[from];
        self.are_watched |= other.are_watched;
        self.counts.take(lane, &other.counts, from);
    }

    /// Follows up the hints that require it, for a step that began at `y` at time `t`.
    #[cold]
    fn watch(&mut self, hints: S::Mask, t: S, y: &Y) {
        let mut followed = S::ZERO;
        self.are_watched = false;
        for lane in 0..S::LANES {
            if self.watches[lane].follows(hints.lane(lane)) {
                followed.set_lane(lane, S::Element::ONE);
            }
            self.are_watched |= self.watches[lane].is_awake();
        }
        self.suspicion = S::ZERO.less(followed);
        if self.suspicion.any() {
            self.suspects = self.formula.suspect(t, y);
        }
    }

    /// Abandons motions that cannot continue or exceed the maximum number of steps.
    #[cold]
    fn give_up(&mut self, go_on: S::Mask) {
        for lane in 0..S::LANES {
            if !go_on.lane(lane) || self.counts.tried(lane) > self.most_steps {
                self.clock.set_time(lane, S::Element::NAN);
            }
        }
    }
}

impl<S, E, F> LanesStepper<S, E> for FixedLanes<S, E::State, F>
where
    S: SideBySide<Element: Scalar>,
    E: Equations<S>,
    F: LanesFormula<S, E::State>,
{
    type LastStep = FixedLastStep<S, E::State, F::End>;

    type Workspace = ();

    #[inline(always)]
    fn workspace() {}

    #[inline(always)]
    fn start(&mut self, equations: &E, y: &E::State) {
        self.formula.prepare(equations, self.clock.time(), y);
        self.state = Compensated::new(*y);
    }

    #[inline(always)]
    fn last_step(&self) -> Self::LastStep {
        FixedLastStep { t: self.clock.time(), y: *self.state.value(), end: F::NO_END }
    }

    #[inline(always)]
    fn begin(&self, last: &mut Self::LastStep) {
        (last.t, last.y) = (self.clock.time(), *self.state.value());
    }

    #[inline(always)]
    fn step(&mut self, equations: &E, (): &mut ()) {
        let (t, y, mut clock) = (self.clock.time(), *self.state.value(), self.clock);
        let h = clock.advance(self.end);
        let increment = self.formula.increment(equations, t, &y, h);
        let hints = self.formula.hints_at_instability();
        let are_stopped = self.clock.is_stopped(&clock) & !is_equal(t, self.end);
        self.state.add(&increment);
        self.clock = clock;
        let are_spent = self.counts.count::<S>(S::Mask::splat(true), self.most_steps);
        let go_on = are_finite(self.state.value()) & !are_stopped;
        if are_spent || !go_on.all() {
            self.give_up(go_on);
        }
        self.suspicion = S::Mask::splat(false);
        if self.are_watched || hints.any() {
            self.watch(hints, t, &y);
        }
    }

    #[inline(always)]
    fn confirm(&mut self, equations: &E, last: &mut Self::LastStep, _asked: S::Mask) {
        last.end = self.formula.end(equations, self.clock.time(), self.state.value());
    }

    #[inline(always)]
    fn interpolate(&self, (): &(), last: &Self::LastStep, t: S) -> E::State {
        let (to, y) = (self.clock.time(), self.state.value());
        let within = self.formula.interpolate((last.t, &last.y), (to, y), &last.end, t);
        chosen(is_equal(t, to), y, &within)
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

    fn suspects(&self) -> Option<&SuspectStep<S, E::State>> {
        Some(&self.suspects)
    }

    fn limit_steps(&mut self, most: u64) {
        self.most_steps = most;
    }

    fn work(&self, lane: usize) -> Work {
        let (first, each) = F::EVALUATIONS;
        let steps = self.counts.taken(lane);
        Work { steps, evaluations: first + each * steps, ..Work::default() }
    }
}
