//! A few motions at a time, one in each lane; a lane whose motion has ended takes the next one.
//!
//! Motions are started in full lanes and then wait there, since a start costs as much for one as for all.

use std::vec::Vec;

use super::dispatch::Task;
use crate::ensemble::progress::Counter;
use crate::integrate::{LanesMethod, LanesStepper, MOST_LANES, Work};
use crate::scalar::{Lanes, Mask, Scalar};
use crate::system::{Equations, LanesSystem, MechanicalSystem, OdeSystem, ScalarOf, SideBySide, StateVector};

/// Motions that fill a register of the widest instructions twice, or four times one of the usual.
const LANES: usize = 8;
/// Stands in the place of the motion in a lane that has none.
const FREE: usize = usize::MAX;

/// Where a motion begins.
pub(in crate::ensemble) struct Beginning<M: MechanicalSystem> {
    /// Its system, if that is not the one of all.
    pub(in crate::ensemble) system: Option<M>,
    pub(in crate::ensemble) state: M::State,
}

impl<M: MechanicalSystem> Beginning<M> {
    /// Its system, which may be the one of all.
    pub(in crate::ensemble) fn system<'s>(&'s self, all: &'s M) -> &'s M {
        self.system.as_ref().unwrap_or(all)
    }
}

/// Where a motion ended, and what it took.
#[derive(Clone, Copy, Debug)]
pub(in crate::ensemble) struct Arrival<Y> {
    pub(in crate::ensemble) state: Y,
    pub(in crate::ensemble) work: Work,
}

/// Where motions ended, in their order; `None` of one that is to be told by a run of its own.
pub(in crate::ensemble) type EndsOf<M> = Vec<Option<Arrival<<M as OdeSystem>::State>>>;

/// Motions that are to be computed.
pub(super) struct Queue<'q, 'a, M: MechanicalSystem> {
    pub(super) system: &'q M,
    pub(super) beginnings: &'q [Beginning<M>],
    /// The places of those that are to be computed.
    pub(super) motions: &'q [usize],
    pub(super) from: M::Scalar,
    pub(super) end: M::Scalar,
    pub(super) most_steps: Option<u64>,
    pub(super) counter: &'q Counter<'q, 'a>,
}

/// A queue and the method by which it is computed.
pub(super) struct Refill<'q, 'a, M: MechanicalSystem, L> {
    pub(super) queue: Queue<'q, 'a, M>,
    pub(super) method: L,
}

impl<M: MechanicalSystem + LanesSystem, L: LanesMethod<ScalarOf<M>>> Task for Refill<'_, '_, M, L> {
    type Output = EndsOf<M>;

    #[inline(always)]
    fn compute<const FUSED: bool>(self) -> EndsOf<M> {
        refilled::<M, L, Lanes<ScalarOf<M>, LANES, FUSED>>(&self.queue, &self.method)
    }
}

/// Equations and motions side by side.
struct LanesGroup<E, T> {
    equations: E,
    stepper: T,
    /// Which motion is in which lane.
    motions: [usize; MOST_LANES],
}

type LanesGroupOf<M, L, S> = LanesGroup<
    <M as LanesSystem>::Lanes<S>,
    <L as LanesMethod<ScalarOf<M>>>::Stepper<S, <M as LanesSystem>::Lanes<S>>,
>;

impl<E, T> LanesGroup<E, T> {
    /// A lane with a motion.
    fn busy_lane(&self) -> Option<usize> {
        self.motions.iter().position(|motion| *motion != FREE)
    }
}

impl<M: MechanicalSystem> Queue<'_, '_, M> {
    /// The system of a motion.
    fn system(&self, motion: usize) -> &M {
        self.beginnings[motion].system(self.system)
    }

    /// Starts as many motions as there are lanes, from `first` on; the last one several times if there are fewer.
    #[inline(always)]
    fn start<L, S>(&self, method: &L, first: usize) -> LanesGroupOf<M, L, S>
    where
        M: MechanicalSystem + LanesSystem,
        L: LanesMethod<ScalarOf<M>>,
        S: SideBySide<Element = ScalarOf<M>>,
    {
        let last = self.motions.len() - 1;
        let mut motions = [FREE; MOST_LANES];
        let mut equations = self.system.lanes(splat::<S>);
        let mut state = <M::Lanes<S> as Equations<S>>::State::ZERO;
        for (lane, place) in motions.iter_mut().enumerate().take(S::LANES) {
            let motion = self.motions[last.min(first + lane)];
            if first + lane <= last {
                *place = motion;
            }
            self.system(motion).set_lane(&mut equations, lane);
            for (component, value) in state.as_mut().iter_mut().zip(self.beginnings[motion].state.as_ref()) {
                component.set_lane(lane, *value);
            }
        }
        let mut stepper = method.start(&equations, self.from, &state, self.end);
        if let Some(most) = self.most_steps {
            stepper.limit_steps(most);
        }
        LanesGroup { equations, stepper, motions }
    }
}

/// Where the motions of a queue end.
#[inline(always)]
pub(super) fn refilled<M, L, S>(queue: &Queue<'_, '_, M>, method: &L) -> EndsOf<M>
where
    M: MechanicalSystem + LanesSystem,
    L: LanesMethod<ScalarOf<M>>,
    S: SideBySide<Element = ScalarOf<M>>,
{
    let mut filling = Filling { queue, method, ends: Vec::new(), next: 0, busy: 0 };
    filling.ends.resize_with(queue.beginnings.len(), || None);
    let (mut running, mut waiting) = (None, None);
    loop {
        // One place of call each for starts and steps, so that the right-hand side is inlined twice and no more.
        if waiting.is_none() && filling.has_more() {
            let group = queue.start::<L, S>(method, filling.next);
            filling.next += S::LANES;
            if running.is_none() {
                filling.busy = group.motions.iter().filter(|motion| **motion != FREE).count();
                running = Some(group);
            } else {
                waiting = Some(group);
            }
        }
        let Some(running) = &mut running else { break };
        if filling.busy < S::LANES {
            filling.refill(running, &mut waiting);
            if waiting.is_none() && filling.has_more() {
                continue;
            }
        }
        if filling.busy == 0 {
            break;
        }
        running.stepper.step(&running.equations);
        if is_settled(running.stepper.time(), queue.end).any() || running.stepper.suspicion().any() {
            filling.settle(running);
        }
    }
    filling.ends
}

/// Whether motions at these times have ended or were given up.
#[inline(always)]
fn is_settled<S: SideBySide>(time: S, end: S::Element) -> S::Mask {
    let end = splat::<S>(end);
    let is_at_end = time.less_equal(end) & end.less_equal(time);
    is_at_end | !time.less_equal(time)
}

/// The same number in every lane.
#[inline(always)]
fn splat<S: SideBySide>(value: S::Element) -> S {
    let mut lanes = S::ZERO;
    for lane in 0..S::LANES {
        lanes.set_lane(lane, value);
    }
    lanes
}

/// How far a queue is computed.
struct Filling<'p, 'q, 'a, M: MechanicalSystem, L> {
    queue: &'p Queue<'q, 'a, M>,
    method: &'p L,
    ends: EndsOf<M>,
    /// How many motions were started.
    next: usize,
    /// How many motions are in lanes.
    busy: usize,
}

impl<M: MechanicalSystem + LanesSystem, L: LanesMethod<ScalarOf<M>>> Filling<'_, '_, '_, M, L> {
    /// Whether there are motions that were not started, and that are still wanted.
    fn has_more(&self) -> bool {
        self.next < self.queue.motions.len() && !self.queue.counter.is_cancelled()
    }

    /// Puts motions that wait into lanes that have none.
    #[inline(always)]
    fn refill<S: SideBySide<Element = ScalarOf<M>>>(
        &mut self,
        running: &mut LanesGroupOf<M, L, S>,
        waiting: &mut Option<LanesGroupOf<M, L, S>>,
    ) {
        for lane in 0..S::LANES {
            let Some(group) = waiting else { return };
            if running.motions[lane] != FREE {
                continue;
            }
            let Some(from) = group.busy_lane() else {
                *waiting = None;
                return;
            };
            let motion = core::mem::replace(&mut group.motions[from], FREE);
            running.motions[lane] = motion;
            running.stepper.take(lane, &group.stepper, from);
            self.queue.system(motion).set_lane(&mut running.equations, lane);
            self.busy += 1;
        }
        if waiting.as_ref().is_some_and(|group| group.busy_lane().is_none()) {
            *waiting = None;
        }
    }

    /// Takes the ends of motions out of their lanes, and those that are given up.
    #[inline(always)]
    fn settle<S: SideBySide<Element = ScalarOf<M>>>(&mut self, running: &mut LanesGroupOf<M, L, S>) {
        let (time, suspicion) = (running.stepper.time(), running.stepper.suspicion());
        for lane in 0..S::LANES {
            let (motion, time) = (running.motions[lane], time.lane(lane));
            if motion == FREE {
                continue;
            }
            let mut state = M::State::ZERO;
            for (component, lanes) in state.as_mut().iter_mut().zip(running.stepper.state().as_ref()) {
                *component = lanes.lane(lane);
            }
            let is_borne =
                !suspicion.lane(lane) || self.method.bears(self.queue.system(motion), time, &state);
            let (has_ended, is_lost) = (time == self.queue.end && is_borne, !time.is_finite() || !is_borne);
            if has_ended {
                self.ends[motion] = Some(Arrival { state, work: running.stepper.work(lane) });
                self.queue.counter.count(1);
            }
            if has_ended || is_lost {
                running.motions[lane] = FREE;
                self.busy -= 1;
            }
            if is_lost {
                self.replace(running, lane);
            }
        }
    }

    /// Puts another motion once more into a lane that is free: NaN would take the slow way through elementary functions.
    #[cold]
    fn replace<S: SideBySide<Element = ScalarOf<M>>>(
        &self,
        running: &mut LanesGroupOf<M, L, S>,
        lane: usize,
    ) {
        if let Some(busy) = running.busy_lane() {
            running.stepper.repeat(lane, busy);
            self.queue.system(running.motions[busy]).set_lane(&mut running.equations, lane);
        }
    }
}
