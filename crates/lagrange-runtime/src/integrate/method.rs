//! Integration methods as seen by their callers.
//!
//! A [`Method`] holds settings and can be kept and compared. It starts a [`Stepper`], which holds
//! all that changes from step to step and needs no heap.
//!
//! Some methods also take several motions at once, as a [`LanesMethod`]. Every lane has its own
//! time and its own step. No motion sees its neighbours, so the result of a lane has the same bits
//! whatever the others contain. A lane does the work of every step of an ordinary motion. In all
//! other cases, such as NaN, steps that are lost in rounding, or too many steps, it gives the
//! motion up. A single run then reports the cause.

use crate::scalar::Scalar;
use crate::system::{Equations, OdeSystem, SettingError, SideBySide, StateVector, StepFailure};

/// A method of integration with its settings.
pub trait Method<M: OdeSystem + ?Sized> {
    /// An integration by this method in progress.
    type Stepper: Stepper<M>;

    /// Returns the name of the method for tables.
    fn name(&self) -> &'static str;

    /// Returns the power of the step with which the global error falls.
    fn order(&self) -> u32;

    /// Checks the settings.
    ///
    /// # Errors
    /// If a setting makes no sense whatever the system and its state.
    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        Ok(())
    }

    /// Starts at the state `y` at time `t`, with steps towards `end`, which may lie before `t`.
    ///
    /// # Errors
    /// If a setting is invalid, or `t`, `y`, `end` or, where the method needs it, the rate at the
    /// start is not finite.
    fn start(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self::Stepper, StepFailure<M::Scalar>>;

    /// Returns the method with a maximum step length, which [`check`](Method::check) has yet to
    /// check.
    ///
    /// # Errors
    /// If the lengths of its steps are a setting already.
    fn with_longest_step(self, _longest: M::Scalar) -> Result<Self, SettingError<M::Scalar>>
    where
        Self: Sized,
    {
        Err(SettingError::Invalid("this method has a fixed step size: reduce it instead"))
    }

    /// Returns the method for the motion of an ensemble with this index. It differs from the method
    /// itself only if that draws random numbers.
    #[must_use]
    fn of_motion(self, _index: usize) -> Self
    where
        Self: Sized,
    {
        self
    }

    /// Calls a visitor if the method can take several motions in lanes.
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
    /// True if steps find the modes of contacts and friction, which [`in_modes`](Self::in_modes)
    /// returns. Runs do not look for the events by which these change then, nor for the modes in
    /// which a motion starts.
    const FINDS_MODES: bool = false;

    /// Returns the time that was reached.
    fn time(&self) -> M::Scalar;

    /// Returns the state that was reached; always finite.
    fn state(&self) -> &M::State;

    /// Takes one step towards `limit` and not beyond; a step that would end just short of it ends
    /// there.
    ///
    /// Values found at the end of the last step may be used again. After a change of `system`, such
    /// as another input, continue with [`restart`](Stepper::restart) from the state that was
    /// reached.
    ///
    /// # Errors
    /// If no step can be taken. Time and state are then unchanged.
    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>>;

    /// Returns the time at which the last step began; the present time if none was taken since the
    /// start.
    fn last_time(&self) -> M::Scalar;

    /// Returns the state at a time within the last step. At both ends it is what the method itself
    /// found there.
    ///
    /// The error is of the order of the method. A method that needs further evaluations makes them
    /// at the first call after a step.
    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State;

    /// True if [`interpolate`](Stepper::interpolate) is as accurate within the last step as the
    /// step itself, to the knowledge of the method. If not, the step is taken back: time and state
    /// are those before it, and the next attempt is shorter.
    ///
    /// To be asked once after a step, before anything within it is, and before the step is made use
    /// of.
    fn confirm(&mut self, _system: &M) -> bool {
        true
    }

    /// Lets no more steps than this be tried from the first start on, rejected ones included.
    /// Methods that reject no steps leave the counting to those who drive them.
    fn limit_steps(&mut self, _most: u64) {}

    /// Goes on from another state at another time, as after an impact. The work done so far still
    /// counts. What a method keeps between steps is forgotten: a motion goes on with the same bits
    /// from a clone, or from what [`FixedStepper::save`](super::FixedStepper::save) passes on.
    ///
    /// # Errors
    /// If the state or, where the method needs it, its rate is not finite.
    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>>;

    /// Returns the system in the modes of the last step, if steps find them.
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
    /// Steps taken.
    pub steps: u64,
    /// Steps tried and thrown away because their error was too large.
    pub rejections: u64,
    /// Evaluations of the right-hand side, or of momenta and their rates.
    pub evaluations: u64,
    /// Evaluations of the Jacobian, by difference quotients as well.
    pub jacobians: u64,
    /// Factorisations of the matrices of adaptive implicit methods; those of one step count once.
    pub factorisations: u64,
    /// Iterations of implicit methods, and of those that find impulses of contacts.
    pub iterations: u64,
    /// Steps whose impulses of contacts and friction miss their law by more than rounding.
    pub inexact: u64,
}

/// Most lanes that a [`LanesStepper`] may have.
pub const MOST_LANES: usize = 16;

/// A method of integration that takes several motions in lanes.
pub trait LanesMethod<T: Scalar>: Copy {
    /// Motions in progress.
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>>: LanesStepper<S, E>;

    /// Lanes that [`take`](LanesMethod::take) is to fill with motions which start at time `t`, with
    /// steps towards `end`, which may lie before `t`.
    fn empty_lanes<S, E>(&self, t: T, end: T) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>;

    /// Starts a motion in every lane at the state `y` at time `t`, with steps towards `end`, which
    /// may lie before `t`.
    fn start<S, E>(&self, equations: &E, t: T, y: &E::State, end: T) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>;

    /// Puts the motion that is in the lane `from` of another stepper, started for the same end,
    /// into a lane of this one.
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

    /// True if a motion of this system, which is under [suspicion](LanesStepper::suspicion) for
    /// this step, may continue in its lane.
    fn bears<M: OdeSystem<Scalar = T>>(&self, _system: &M, _step: &SuspectStep<T, M::State>) -> bool {
        false
    }
}

/// A step that may have been too long for its method, and the direction in which to look for fast
/// components.
#[derive(Clone, Copy, Debug)]
pub struct SuspectStep<S, Y> {
    /// The time at which it began.
    pub t: S,
    /// The state there.
    pub y: Y,
    /// Its length, negative backwards in time.
    pub h: S,
    /// Differences of rates within it, in place of the corresponding components.
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
    /// Data of the last step in every lane for states within it; empty unless requested.
    type LastStep: Copy;

    /// Returns the data before any step.
    fn last_step(&self) -> Self::LastStep;

    /// Remembers where a step begins that is about to be tried.
    fn begin(&self, last: &mut Self::LastStep);

    /// Tries a step in every lane, towards the end and not beyond.
    fn step(&mut self, equations: &E);

    /// Prepares for [`interpolate`](LanesStepper::interpolate) in these lanes, all of which have
    /// just taken a step. If states within it are less accurate than its end, to the knowledge of
    /// the method, the step is taken back, as by [`Stepper::confirm`].
    fn confirm(&mut self, equations: &E, last: &mut Self::LastStep, asked: S::Mask);

    /// Returns the states at times within the last steps, in lanes that were prepared, or at their
    /// ends. Other times give any value.
    fn interpolate(&self, last: &Self::LastStep, t: S) -> E::State;

    /// Returns the times that were reached: the end exactly where a motion has ended, NaN where it
    /// was given up.
    fn time(&self) -> S;

    /// Returns the states that were reached.
    fn state(&self) -> &E::State;

    /// Returns the lanes whose last step suggested that the method does not suit the motion.
    fn suspicion(&self) -> S::Mask;

    /// Returns the suspect steps, in the lanes that have one.
    fn suspects(&self) -> Option<&SuspectStep<S, E::State>> {
        None
    }

    /// Lets no more steps than this be tried of a motion, rejected ones included: it is given up
    /// then.
    fn limit_steps(&mut self, most: u64);

    /// Returns the work of the motion in a lane so far.
    fn work(&self, lane: usize) -> Work;
}

/// A visitor of methods that can take motions in lanes.
pub trait LanesMethodVisitor<T: Scalar> {
    /// The result.
    type Output;

    /// Does it.
    fn visit(self, method: impl LanesMethod<T>) -> Self::Output;
}
