//! Integration methods as used by their callers.
//!
//! A [`Method`] contains settings and can be stored and compared. It starts a [`Stepper`], which
//! contains all data that change from step to step and needs no heap.
//!
//! Some methods can also advance several motions at once, as a [`LanesMethod`]. Every lane has its
//! own time and its own step. Motions do not interact, so the result of a lane has the same bits
//! regardless of the other lanes. A lane handles the steps of ordinary motions. In all other cases,
//! such as NaN, steps that are lost in rounding, or too many steps, it abandons the motion. A
//! single run then reports the cause.

use crate::scalar::{Mask, Scalar};
use crate::system::{Domain, Equations, OdeSystem, SettingError, SideBySide, StateVector, StepFailure};

/// A method of integration with its settings.
pub trait Method<M: OdeSystem + ?Sized> {
    /// An integration by this method in progress.
    type Stepper: Stepper<M>;

    /// Returns the name of the method for tables.
    fn name(&self) -> &'static str;

    /// Returns the power of the step length with which the global error decreases.
    fn order(&self) -> u32;

    /// Checks the settings.
    ///
    /// # Errors
    /// If a setting is invalid for any system and state.
    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        Ok(())
    }

    /// Starts at the state `y` at time `t`, with steps towards `end`, which may precede `t`.
    ///
    /// # Errors
    /// If a setting is invalid, or `t`, `y`, `end` or, if the method needs it, the rate at the
    /// start is not finite.
    fn start(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self::Stepper, StepFailure<M::Scalar>>;

    /// Returns the method with a maximum step length, to be checked by [`check`](Method::check).
    ///
    /// # Errors
    /// If its step length is already a setting.
    fn with_longest_step(self, _longest: M::Scalar) -> Result<Self, SettingError<M::Scalar>>
    where
        Self: Sized,
    {
        Err(SettingError::Invalid("this method has a fixed step size: reduce it instead"))
    }

    /// Returns the method for the motion of an ensemble with this index. It differs from the method
    /// itself only if the method draws random numbers.
    #[must_use]
    fn of_motion(self, _index: usize) -> Self
    where
        Self: Sized,
    {
        self
    }

    /// Calls a visitor if the method can advance several motions in lanes.
    ///
    /// # Errors
    /// Returns the visitor if this method cannot.
    fn in_lanes<V: LanesMethodVisitor<M::Scalar>>(&self, visitor: V) -> Result<V::Output, V>
    where
        Self: Sized,
    {
        Err(visitor)
    }
}

/// An integration in progress.
pub trait Stepper<M: OdeSystem + ?Sized> {
    /// True if steps determine the modes of contacts and friction, which
    /// [`in_modes`](Self::in_modes) returns. Runs then locate neither the events that change modes
    /// nor the modes at the start of a motion.
    const FINDS_MODES: bool = false;

    /// Returns the present time.
    fn time(&self) -> M::Scalar;

    /// Returns the present state, which is always finite.
    fn state(&self) -> &M::State;

    /// Takes one step towards `limit` and not beyond; a step that would end slightly before the
    /// limit ends there.
    ///
    /// Values computed at the end of the last step may be reused. After a change of `system`, such
    /// as another input, continue with [`restart`](Stepper::restart) from the present state.
    ///
    /// # Errors
    /// If no step can be taken. Time and state are then unchanged.
    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>>;

    /// Returns the time at which the last step began; the present time if there was none since the
    /// start.
    fn last_time(&self) -> M::Scalar;

    /// Returns the state at a time within the last step. At both ends it equals the result of the
    /// method.
    ///
    /// The error has the order of the method. Methods that need further evaluations perform them at
    /// the first call after a step.
    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State;

    /// True if the method estimates that [`interpolate`](Stepper::interpolate) is as accurate as
    /// the last step. Otherwise the step is reverted: time and state are those before it, and the
    /// next attempt is shorter.
    ///
    /// It must be called once after a step, before interpolation within the step and before the
    /// step is used.
    fn confirm(&mut self, _system: &M) -> bool {
        true
    }

    /// Limits the number of attempted steps since the first start, including rejected ones. Methods
    /// that reject no steps leave the counting to their callers.
    fn limit_steps(&mut self, _most: u64) {}

    /// Continues from another state at another time, as after an impact. The work done so far still
    /// counts. The method discards everything it stores between steps. To continue with the same
    /// bits, use a clone, or the numbers passed on by
    /// [`FixedStepper::save`](super::FixedStepper::save).
    ///
    /// # Errors
    /// If the state or, if the method needs it, its rate is not finite.
    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>>;

    /// Returns the system in the modes of the last step, if steps determine them.
    fn in_modes(&self, _system: &M) -> Option<M>
    where
        M: Sized,
    {
        None
    }

    /// Returns the work so far.
    fn work(&self) -> Work;
}

/// The work of an integration.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[non_exhaustive]
pub struct Work {
    /// Number of accepted steps.
    pub steps: u64,
    /// Number of steps rejected because of their errors.
    pub rejections: u64,
    /// Number of evaluations of the right-hand side, or of momenta and their rates.
    pub evaluations: u64,
    /// Number of evaluations of the Jacobian, including difference quotients.
    pub jacobians: u64,
    /// Number of factorisations of matrices by adaptive implicit methods; those of one step count
    /// once.
    pub factorisations: u64,
    /// Number of iterations of implicit methods, and of methods that compute impulses of contacts.
    pub iterations: u64,
    /// Number of steps whose impulses of contacts and friction violate their law by more than
    /// rounding.
    pub inexact: u64,
}

/// Maximum number of lanes of a [`LanesStepper`].
pub const MAX_LANES: usize = 16;

/// A method of integration that advances several motions in lanes.
pub trait LanesMethod<T: Scalar>: Copy {
    /// Motions in progress.
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>>: LanesStepper<S, E>;

    /// Creates lanes to be filled by [`take`](LanesMethod::take) with motions in a domain. They
    /// start at the first of two times, with steps towards the second, which may precede it.
    fn empty_lanes<S, E>(&self, span: [T; 2], domain: &'static Domain) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>;

    /// Creates lanes with a motion of the same kind in each, at the state `y`.
    #[inline(always)]
    fn start<S, E>(
        &self,
        equations: &E,
        y: &E::State,
        span: [T; 2],
        domain: &'static Domain,
    ) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        let mut lanes = self.empty_lanes::<S, E>(span, domain);
        lanes.start(equations, y);
        lanes
    }

    /// Copies the motion in the lane `from` of another stepper, started for the same end, into a
    /// lane of this one.
    fn take<S, E, O, F>(
        stepper: &mut Self::Stepper<S, E>,
        lane: usize,
        other: &Self::Stepper<O, F>,
        from: usize,
    ) where
        S: SideBySide<Element = T>,
        E: Equations<S>,
        O: SideBySide<Element = T>,
        F: Equations<O>;

    /// True if a motion of this system under [suspicion](LanesStepper::suspicion) for this step may
    /// continue in its lane.
    fn bears<M: OdeSystem<Scalar = T>>(&self, _system: &M, _step: &SuspectStep<T, M::State>) -> bool {
        false
    }
}

/// A step that may have been too long for its method, and the direction in which to search for fast
/// components.
#[derive(Clone, Copy, Debug)]
pub struct SuspectStep<S, Y> {
    /// The time at which the step began.
    pub t: S,
    /// The state at which the step began.
    pub y: Y,
    /// The length of the step, negative backwards in time.
    pub h: S,
    /// Differences of rates within the step, in place of the corresponding components.
    pub direction: Y,
    /// Length of the change, as a sum of magnitudes.
    pub change: S,
}

impl<S: SideBySide, Y: AsRef<[S]>> SuspectStep<S, Y> {
    /// Returns the step in one lane.
    pub fn lane<Z: StateVector<S::Element>>(&self, lane: usize) -> SuspectStep<S::Element, Z> {
        let of = |lanes: &Y| {
            let mut state = Z::ZERO;
            for (component, lanes) in state.as_mut().iter_mut().zip(lanes.as_ref()) {
                *component = lanes.lane(lane);
            }
            state
        };
        let SuspectStep { t, h, change, .. } = *self;
        let [t, h, change] = [t, h, change].map(|number| number.lane(lane));
        SuspectStep { t, y: of(&self.y), h, direction: of(&self.direction), change }
    }
}

/// Motions in progress, one in each lane.
pub trait LanesStepper<S: SideBySide, E: Equations<S>>: Copy {
    /// Data of the last step in every lane for interpolation; empty unless requested.
    type LastStep: Copy;
    /// Storage for steps that no copy of the stepper contains.
    type Workspace;

    /// Creates the storage.
    fn workspace() -> Self::Workspace;

    /// Starts a motion of the same kind in every lane at the state `y`.
    fn start(&mut self, equations: &E, y: &E::State);

    /// Returns the data before any step.
    fn last_step(&self) -> Self::LastStep;

    /// Stores the start of the next step.
    fn begin(&self, last: &mut Self::LastStep);

    /// Tries a step in every lane, towards the end and not beyond.
    fn step(&mut self, equations: &E, workspace: &mut Self::Workspace);

    /// Prepares for [`interpolate`](LanesStepper::interpolate) in these lanes, all of which have
    /// just taken a step. If the method estimates that interpolation is less accurate than the end
    /// of the step, the step is reverted, as by [`Stepper::confirm`].
    #[inline(always)]
    fn confirm(&mut self, _equations: &E, _last: &mut Self::LastStep, _asked: S::Mask) {}

    /// Returns the states at times within the last steps, in prepared lanes, or at their ends. For
    /// other times, the result is arbitrary.
    fn interpolate(&self, workspace: &Self::Workspace, last: &Self::LastStep, t: S) -> E::State;

    /// Returns the present times: exactly the end if a motion has ended, NaN if it was abandoned.
    fn time(&self) -> S;

    /// Returns the present states.
    fn state(&self) -> &E::State;

    /// Returns the lanes whose last step indicated that the method is unsuitable for the motion.
    #[inline(always)]
    fn suspicion(&self) -> S::Mask {
        S::Mask::splat(false)
    }

    /// Returns the suspect steps, for the lanes under suspicion.
    fn suspects(&self) -> Option<&SuspectStep<S, E::State>> {
        None
    }

    /// Limits the number of attempted steps of a motion, including rejected ones; beyond it, the
    /// motion is abandoned.
    fn limit_steps(&mut self, most: u64);

    /// Returns the work of the motion in a lane so far.
    fn work(&self, lane: usize) -> Work;
}

/// A visitor of methods that can advance motions in lanes.
pub trait LanesMethodVisitor<T: Scalar> {
    /// The result.
    type Output;

    /// Visits the method.
    fn visit(self, method: impl LanesMethod<T>) -> Self::Output;
}
