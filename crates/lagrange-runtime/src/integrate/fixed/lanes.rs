//! Steps of equal length for several motions in lanes.

use crate::integrate::clock::{Clock, check_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::lane_wise::{Counts, are_finite, is_equal};
use crate::integrate::method::{MOST_LANES, SuspectStep};
use crate::integrate::stability::Watch;
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{SideBySide, StateVector};

/// The common parts of fixed-step methods in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct FixedLanes<S: Number, Y> {
    end: S,
    clock: Clock<S>,
    state: Compensated<Y>,
    suspicion: S::Mask,
    suspects: SuspectStep<S, Y>,
    watches: [Watch; MOST_LANES],
    are_watched: bool,
    most_steps: u64,
    counts: Counts,
}

impl<S, Y> FixedLanes<S, Y>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// Motions that start at time `t` in steps of this length towards `end`; their states are zero
    /// as yet. They are given up if such steps are lost in the rounding of time.
    #[inline(always)]
    pub(in crate::integrate) fn new(step: S::Element, t: S::Element, end: S::Element) -> Self {
        let suspects =
            SuspectStep { t: S::ZERO, y: Y::ZERO, h: S::ZERO, direction: Y::ZERO, change: S::ZERO };
        let start = check_step(step, t, end).map_or(S::Element::NAN, |()| t);
        FixedLanes {
            end: S::splat(end),
            clock: Clock::new(S::splat(start), S::splat(step)),
            state: Compensated::new(Y::ZERO),
            suspicion: S::Mask::splat(false),
            suspects,
            watches: [Watch::default(); MOST_LANES],
            are_watched: false,
            most_steps: u64::MAX,
            counts: Counts::new(),
        }
    }

    /// Continues the motions from this state.
    #[inline(always)]
    pub(in crate::integrate) fn at(self, y: &Y) -> Self {
        FixedLanes { state: Compensated::new(*y), ..self }
    }

    /// The times that were reached.
    #[inline(always)]
    pub(in crate::integrate) fn time(&self) -> S {
        self.clock.time()
    }

    /// The states that were reached.
    #[inline(always)]
    pub(in crate::integrate) fn state(&self) -> &Y {
        self.state.value()
    }

    /// Returns the lanes whose last step hinted at instability strongly enough to follow up.
    #[inline(always)]
    pub(in crate::integrate) fn suspicion(&self) -> S::Mask {
        self.suspicion
    }

    /// The steps under suspicion.
    pub(in crate::integrate) fn suspects(&self) -> &SuspectStep<S, Y> {
        &self.suspects
    }

    /// Returns the number of steps of the motion in a lane.
    pub(in crate::integrate) fn steps(&self, lane: usize) -> u64 {
        self.counts.taken(lane)
    }

    /// Lets no more steps than this be taken of a motion.
    pub(in crate::integrate) fn limit_steps(&mut self, most: u64) {
        self.most_steps = most;
    }

    /// The lengths of the next steps, and the clock after them.
    #[inline(always)]
    pub(in crate::integrate) fn next(&self) -> (S, Clock<S>) {
        let mut clock = self.clock;
        let h = clock.advance(self.end);
        (h, clock)
    }

    /// Takes steps by these increments up to where the clock then is; they hint at instability
    /// where the mask is true. What they were is asked for only there.
    #[inline(always)]
    pub(in crate::integrate) fn accept(
        &mut self,
        clock: Clock<S>,
        increment: &Y,
        hints: S::Mask,
        step: impl FnOnce(S, Y) -> SuspectStep<S, Y>,
    ) {
        let (t, y) = (self.clock.time(), *self.state.value());
        let are_stopped = self.clock.is_stopped(&clock) & !is_equal(t, self.end);
        self.state.add(increment);
        self.clock = clock;
        let are_spent = self.counts.count::<S>(S::Mask::splat(true), self.most_steps);
        let go_on = are_finite(self.state.value()) & !are_stopped;
        if are_spent || !go_on.all() {
            self.give_up(go_on);
        }
        self.suspicion = S::Mask::splat(false);
        if self.are_watched || hints.any() {
            self.watch(hints);
            if self.suspicion.any() {
                self.suspects = step(t, y);
            }
        }
    }

    /// Puts what is in the lane `from` of other motions into a lane of these.
    #[inline(always)]
    pub(in crate::integrate) fn take<O, Z>(&mut self, lane: usize, other: &FixedLanes<O, Z>, from: usize)
    where
        O: SideBySide<Element = S::Element>,
        Z: StateVector<O>,
    {
        self.clock.take(lane, &other.clock, from);
        self.state.take(lane, &other.state, from);
        self.watches[lane] = other.watches[from];
        self.are_watched |= other.are_watched;
        self.counts.take(lane, &other.counts, from);
    }

    /// Gives motions up that do not go on or took more steps than they may.
    #[cold]
    fn give_up(&mut self, go_on: S::Mask) {
        for lane in 0..S::LANES {
            if !go_on.lane(lane) || self.counts.tried(lane) > self.most_steps {
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
