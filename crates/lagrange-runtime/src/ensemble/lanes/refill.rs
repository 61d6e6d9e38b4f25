//! Motions in lanes, one per lane; a lane whose motion has ended is refilled with the next one.
//!
//! Motions are started one by one, each in a single lane. The start of a method costs little at run
//! time. A copy of it for all lanes would be a third of the compiled code.

use std::boxed::Box;
use std::vec::Vec;

use super::dispatch::Task;
use super::sampler::{Sampler, SamplesWithin};
use crate::ensemble::progress::Counter;
use crate::integrate::{LanesMethod, LanesStepper, MAX_LANES, SuspectStep, Work};
use crate::scalar::{Lanes, Mask, Scalar};
use crate::simulate::Grid;
use crate::system::{Equations, LanesSystem, OdeSystem, ScalarOf, SideBySide, StateVector};

/// Number of lanes: two of the widest vector registers, or four of the usual ones.
const LANES: usize = 8;
/// Number of lanes on processors without fused products, which are few. A single register costs
/// little to compile.
const LANES_APART: usize = 2;
/// Motion index of a free lane.
const FREE: usize = usize::MAX;
/// Number of steps between two questions whether the ensemble is cancelled.
const TURNS: u32 = 32;

/// The start of a motion.
pub(in crate::ensemble) struct MotionStart<M: OdeSystem> {
    /// Its system, unless it is the common one.
    pub(in crate::ensemble) system: Option<M>,
    pub(in crate::ensemble) state: M::State,
}

impl<M: OdeSystem> MotionStart<M> {
    /// Returns the system of the motion, given the common one.
    pub(in crate::ensemble) fn system<'s>(&'s self, all: &'s M) -> &'s M {
        self.system.as_ref().unwrap_or(all)
    }
}

/// The final state of a motion and its work, with its samples between start and end if requested.
#[derive(Clone, Debug)]
pub(in crate::ensemble) struct Arrival<T, Y> {
    pub(in crate::ensemble) state: Y,
    pub(in crate::ensemble) samples: SamplesWithin<T, Y>,
    pub(in crate::ensemble) work: Work,
}

/// The final state of a motion of this system.
pub(in crate::ensemble) type ArrivalOf<M> = Arrival<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>;

/// Final states of motions, in order; `None` for a motion that a single run must compute.
pub(in crate::ensemble) type EndsOf<M> = Vec<Option<ArrivalOf<M>>>;

/// Motions to be computed, with samples if they are `SAMPLED`.
pub(super) struct Queue<'q, 'a, M: OdeSystem, const SAMPLED: bool> {
    pub(super) system: &'q M,
    pub(super) starts: &'q [MotionStart<M>],
    /// The indices of the starts to be computed.
    pub(super) motions: &'q [usize],
    pub(super) from: M::Scalar,
    pub(super) end: M::Scalar,
    /// The times of samples.
    pub(super) grid: Option<Grid<M::Scalar>>,
    pub(super) max_steps: Option<u64>,
    pub(super) counter: &'q Counter<'q, 'a>,
}

/// A queue and the method by which it is computed.
pub(super) struct Refill<'q, 'a, M: OdeSystem, L, const SAMPLED: bool> {
    pub(super) queue: Queue<'q, 'a, M, SAMPLED>,
    pub(super) method: L,
}

impl<M, L, const SAMPLED: bool> Task for Refill<'_, '_, M, L, SAMPLED>
where
    M: LanesSystem,
    L: LanesMethod<ScalarOf<M>>,
{
    type Output = EndsOf<M>;

    #[inline(always)]
    fn compute<const FUSED: bool>(self) -> EndsOf<M> {
        if FUSED {
            refilled::<M, L, Lanes<ScalarOf<M>, LANES, true>, SAMPLED>(&self.queue, &self.method)
        } else {
            refilled::<M, L, Lanes<ScalarOf<M>, LANES_APART, false>, SAMPLED>(&self.queue, &self.method)
        }
    }
}

/// Equations and motions side by side.
struct LanesGroup<E, T> {
    equations: E,
    stepper: T,
    /// Index of the motion in each lane.
    motions: [usize; MAX_LANES],
}

type LanesGroupOf<M, L, S> = LanesGroup<<M as LanesSystem>::Lanes<S>, StepperOf<M, L, S>>;

/// Stepper of motions side by side.
type StepperOf<M, L, S> = <L as LanesMethod<ScalarOf<M>>>::Stepper<S, <M as LanesSystem>::Lanes<S>>;

/// Storage of the stepper.
type WorkspaceOf<M, L, S> = <StepperOf<M, L, S> as LanesStepper<S, <M as LanesSystem>::Lanes<S>>>::Workspace;

/// Sampler of motions side by side.
type SamplerOf<M, L, S> = Sampler<
    S,
    <M as OdeSystem>::State,
    <StepperOf<M, L, S> as LanesStepper<S, <M as LanesSystem>::Lanes<S>>>::LastStep,
>;

impl<E, T> LanesGroup<E, T> {
    /// Returns a lane with a motion.
    fn busy_lane(&self) -> Option<usize> {
        self.motions.iter().position(|motion| *motion != FREE)
    }
}

impl<M: OdeSystem, const SAMPLED: bool> Queue<'_, '_, M, SAMPLED> {
    /// Returns the system of a motion.
    fn system(&self, motion: usize) -> &M {
        self.starts[motion].system(self.system)
    }

    /// Starts a motion in a single lane.
    #[inline(always)]
    fn started<L, O>(&self, method: &L, motion: usize) -> StepperOf<M, L, O>
    where
        M: LanesSystem,
        L: LanesMethod<ScalarOf<M>>,
        O: SideBySide<Element = ScalarOf<M>>,
    {
        let equations = self.system(motion).lanes(O::splat);
        let mut state = <M::Lanes<O> as Equations<O>>::State::ZERO;
        for (component, value) in state.as_mut().iter_mut().zip(self.starts[motion].state.as_ref()) {
            *component = O::splat(*value);
        }
        method.start(&equations, &state, [self.from, self.end], self.system.domain())
    }

    /// Returns lanes without motions.
    #[inline(always)]
    fn lanes<L, S>(&self, method: &L) -> LanesGroupOf<M, L, S>
    where
        M: LanesSystem,
        L: LanesMethod<ScalarOf<M>>,
        S: SideBySide<Element = ScalarOf<M>>,
    {
        let span = [self.from, self.end];
        let mut stepper = method.empty_lanes::<S, M::Lanes<S>>(span, self.system.domain());
        if let Some(most) = self.max_steps {
            stepper.limit_steps(most);
        }
        LanesGroup { equations: self.system.lanes(S::splat), stepper, motions: [FREE; MAX_LANES] }
    }
}

/// Computes the final states of the motions in a queue.
#[inline(always)]
pub(super) fn refilled<M, L, S, const SAMPLED: bool>(
    queue: &Queue<'_, '_, M, SAMPLED>,
    method: &L,
) -> EndsOf<M>
where
    M: LanesSystem,
    L: LanesMethod<ScalarOf<M>>,
    S: SideBySide<Element = ScalarOf<M>>,
{
    let mut running = queue.lanes::<L, S>(method);
    let sampler = queue.grid.filter(|_| SAMPLED).map(|grid| Sampler::new(grid, running.stepper.last_step()));
    let workspace = Box::new(<StepperOf<M, L, S> as LanesStepper<S, M::Lanes<S>>>::workspace());
    let mut progress =
        QueueProgress { queue, method, ends: Vec::new(), next: 0, busy: 0, turns: 0, workspace, sampler };
    progress.ends.resize_with(queue.starts.len(), || None);
    let domain = queue.system.domain();
    loop {
        // Starts, steps and samples have one call site each, so that the right-hand side is inlined
        // only once in each.
        if progress.busy < S::LANES && progress.has_more() {
            progress.refill(&mut running);
        }
        if progress.busy == 0 || progress.is_cancelled() {
            break;
        }
        progress.step(&mut running);
        let are_outside = !domain.contains(running.stepper.state().as_ref());
        let are_settled = is_settled(running.stepper.time(), queue.end);
        if (are_settled | running.stepper.suspicion() | are_outside).any() {
            progress.settle(&mut running, are_outside);
        }
    }
    progress.ends
}

/// True if motions at these times have ended or were given up.
#[inline(always)]
fn is_settled<S: SideBySide>(time: S, end: S::Element) -> S::Mask {
    let end = S::splat(end);
    let is_at_end = time.less_equal(end) & end.less_equal(time);
    is_at_end | !time.less_equal(time)
}

/// The progress of a queue.
struct QueueProgress<'p, 'q, 'a, M, L, S, const SAMPLED: bool>
where
    M: LanesSystem,
    L: LanesMethod<ScalarOf<M>>,
    S: SideBySide<Element = ScalarOf<M>>,
{
    queue: &'p Queue<'q, 'a, M, SAMPLED>,
    method: &'p L,
    ends: EndsOf<M>,
    /// Number of motions started.
    next: usize,
    /// Number of motions in lanes.
    busy: usize,
    /// Number of steps in all lanes.
    turns: u32,
    workspace: Box<WorkspaceOf<M, L, S>>,
    /// `Some` if motions are `SAMPLED`.
    sampler: Option<SamplerOf<M, L, S>>,
}

impl<M, L, S, const SAMPLED: bool> QueueProgress<'_, '_, '_, M, L, S, SAMPLED>
where
    M: LanesSystem,
    L: LanesMethod<ScalarOf<M>>,
    S: SideBySide<Element = ScalarOf<M>>,
{
    /// True if the ensemble is cancelled, as far as is known: it asks every few dozen steps.
    fn is_cancelled(&mut self) -> bool {
        self.turns = self.turns.wrapping_add(1);
        self.turns.is_multiple_of(TURNS) && self.queue.counter.asks()
    }

    /// True if there are motions left to start, and the ensemble was not cancelled.
    fn has_more(&self) -> bool {
        self.next < self.queue.motions.len() && !self.queue.counter.is_cancelled()
    }

    /// Registers a new motion in this lane.
    fn fill(&mut self, lane: usize) {
        self.busy += 1;
        if SAMPLED && let Some(sampler) = &mut self.sampler {
            sampler.start(lane);
        }
    }

    /// Tries a step in every lane, and keeps the samples within it.
    #[inline(always)]
    fn step(&mut self, LanesGroup { equations, stepper, .. }: &mut LanesGroupOf<M, L, S>) {
        if SAMPLED && let Some(sampler) = &mut self.sampler {
            sampler.begin(stepper);
        }
        stepper.step(equations, &mut self.workspace);
        if SAMPLED && let Some(sampler) = &mut self.sampler {
            sampler.keep(equations, stepper, &self.workspace);
        }
    }

    /// Starts motions in free lanes, as long as any are left.
    #[inline(always)]
    fn refill(&mut self, running: &mut LanesGroupOf<M, L, S>) {
        for lane in 0..S::LANES {
            if running.motions[lane] != FREE {
                continue;
            }
            if !self.has_more() {
                self.replace(running, lane);
                continue;
            }
            let motion = self.queue.motions[self.next];
            self.next += 1;
            let started = self.queue.started::<L, S::One>(self.method, motion);
            L::take::<S, M::Lanes<S>, S::One, M::Lanes<S::One>>(&mut running.stepper, lane, &started, 0);
            self.queue.system(motion).set_lane(&mut running.equations, lane);
            running.motions[lane] = motion;
            self.fill(lane);
        }
    }

    /// Removes motions that have ended, were given up or are out of their domain from their lanes.
    #[inline(always)]
    fn settle(&mut self, running: &mut LanesGroupOf<M, L, S>, are_outside: S::Mask) {
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
            let bears =
                |steps: &SuspectStep<S, _>| self.method.bears(self.queue.system(motion), &steps.lane(lane));
            let is_borne = !suspicion.lane(lane) || running.stepper.suspects().is_some_and(bears);
            if !time.is_finite() || !is_borne || are_outside.lane(lane) {
                self.free(running, lane);
                self.replace(running, lane);
            } else if time == self.queue.end {
                let (samples, work) = (self.free(running, lane), running.stepper.work(lane));
                self.ends[motion] = Some(Arrival { state, samples, work });
                self.queue.counter.count(1);
            }
        }
    }

    /// Frees a lane and returns the samples of its motion.
    fn free(
        &mut self,
        running: &mut LanesGroupOf<M, L, S>,
        lane: usize,
    ) -> SamplesWithin<ScalarOf<M>, M::State> {
        running.motions[lane] = FREE;
        self.busy -= 1;
        match &mut self.sampler {
            Some(sampler) if SAMPLED => sampler.end(lane),
            _ => Vec::new(),
        }
    }

    /// Copies a running motion into a free lane, because NaN would take the slow path of elementary
    /// functions.
    #[cold]
    fn replace(&self, running: &mut LanesGroupOf<M, L, S>, lane: usize) {
        if let Some(busy) = running.busy_lane() {
            let same = running.stepper;
            L::take::<S, M::Lanes<S>, S, M::Lanes<S>>(&mut running.stepper, lane, &same, busy);
            self.queue.system(running.motions[busy]).set_lane(&mut running.equations, lane);
        }
    }
}
