//! Reasons why a step failed.

use super::event::DeclaredEvent;
use super::out_of_range::{OutOfRange, RangedKind};
use super::setting_error::SettingError;
use super::undefined::Undefined;
use super::violation::Violation;

/// The reason why a step failed.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum StepFailure<S> {
    /// No step was tried, because a setting is invalid.
    Setting(SettingError<S>),
    /// A time, the state or its rate is NaN or infinite. Methods do not identify it; runs name it
    /// if possible, as [`Undefined`](StepFailure::Undefined).
    NotFinite,
    /// This number is NaN or infinite, or makes derived numbers so.
    Undefined(Undefined<S>),
    /// Errors of the initial state relative to the tolerance are not finite, so no first step can
    /// be chosen.
    NoFirstStep {
        /// The tolerated error relative to the state.
        relative: S,
        /// The tolerated error in the units of the state.
        absolute: S,
    },
    /// The step required by the tolerance is lost in the rounding of time.
    StepUnderflow {
        /// The required step.
        step: S,
    },
    /// Steps of the specified length are lost in the rounding of time.
    StepLost {
        /// The specified length.
        step: S,
        /// The time, between the start and the end of the run, at which they are lost.
        time: S,
    },
    /// The run took the maximum number of steps.
    TooManySteps {
        /// Maximum number of steps.
        limit: u64,
    },
    /// The steps of an explicit method are limited by stability and not by accuracy.
    Stiff {
        /// Approximate length of the longest stable step.
        limit: S,
        /// The larger tolerance of the method.
        tolerance: S,
        /// True if the declaration could emit the Jacobian but does not.
        wants_jacobian: bool,
    },
    /// The step of a method with steps of given length exceeds the stability limit.
    StepTooLong {
        /// The length of the step.
        step: S,
        /// Approximate length of the longest stable step at this state. It is the stability limit
        /// of the method over the magnitude of the largest eigenvalue of the linearised equations.
        limit: S,
    },
    /// The equations of an implicit step could not be solved.
    NotConverged {
        /// Number of iterations.
        iterations: u32,
    },
    /// The mass matrix is singular, so that velocities do not follow from momenta.
    SingularMassMatrix,
    /// An event function is NaN or infinite.
    EventNotFinite {
        /// Source of the event.
        event: EventSource,
    },
    /// A state violates a constraint and cannot be brought onto it.
    Violated(Violation<S>),
    /// A parameter, an entry of the state, or a quantity of a contact is outside of its range.
    OutOfRange(OutOfRange<S>),
    /// A delay is not positive and finite, or too short for the run.
    Delay {
        /// The name of the delayed signal.
        signal: &'static str,
        /// The delay.
        lag: S,
        /// The reason.
        fault: DelayFault<S>,
    },
    /// A coefficient of restitution that depends on time or the state is not between 0 and 1.
    Restitution {
        /// The name of the contact.
        contact: &'static str,
        /// Value.
        value: S,
    },
    /// A limit of friction is negative.
    FrictionLimit {
        /// The name of the friction.
        friction: &'static str,
        /// The limit, or its change per unit of a contact force.
        value: S,
    },
    /// Impulses of contacts and friction over a step violate their law by more than is allowed.
    Residual {
        /// The contact or friction with the largest violation.
        reaction: &'static str,
        /// The violation, as a rate.
        value: S,
    },
    /// No forces of contacts fit the state: friction is so strong that a contact that slips would
    /// have to be pulled (Painlevé's paradox).
    Painleve {
        /// The name of the contact.
        contact: &'static str,
        /// Its coefficient of friction while it slips.
        coefficient: S,
        /// The coefficient from which the paradox occurs in this contact alone, if it does.
        critical: Option<S>,
    },
    /// No motion continues from here, for this reason: no contact forces or friction fit the state,
    /// or a method of another crate failed.
    Stuck(&'static str),
    /// The number of events at the same time is so large that it is treated as infinite, as when a
    /// bouncing ball comes to rest.
    EventsAccumulate {
        /// Number of events.
        events: u32,
        /// Source of the last event.
        event: EventSource,
    },
    /// The state slides along a surface on which the equations are not smooth: on either side they
    /// lead back to the surface.
    Slides {
        /// The function that changes its sign there, and the statement that contains it.
        surface: &'static str,
    },
    /// The zero of an event function could not be located.
    EventNotLocated {
        /// Source of the event.
        event: EventSource,
        /// Number of bisections.
        bisections: u32,
    },
    /// An event function passes zero between two times so fast that it is far from zero at both.
    /// Times this far from the origin are too coarse.
    EventUnresolved {
        /// Source of the event.
        event: EventSource,
        /// The time.
        time: S,
        /// Its distance from the next representable time.
        spacing: S,
    },
    /// The state after an event has no derivative with respect to this variable. The function of
    /// the event touches zero with zero rate, or its outcome changes with the variable.
    NotDifferentiable {
        /// Source of the event.
        event: EventSource,
        /// The parameter, input or initial state.
        variable: &'static str,
    },
}

/// The reason why a run does not permit a delay.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum DelayFault<S> {
    /// It is not positive and finite.
    NotPositive,
    /// Steps no longer than the delay would be too many.
    Steps {
        /// The shortest delay that the run permits.
        least: S,
    },
    /// Times of the run are too coarse.
    Times {
        /// The shortest delay that the run permits.
        least: S,
    },
    /// Another delay is so much longer that its past would have too many steps.
    Past {
        /// The shortest delay that the run permits.
        least: S,
    },
}

/// The source of an event function.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum EventSource {
    /// The declaration of the system, with this name.
    Declared(&'static str),
    /// The run, at this zero-based index among its events. A simulation reports it by name.
    Given(usize),
}

impl<S> From<OutOfRange<S>> for StepFailure<S> {
    fn from(error: OutOfRange<S>) -> Self {
        StepFailure::OutOfRange(error)
    }
}

impl<S> From<SettingError<S>> for StepFailure<S> {
    fn from(error: SettingError<S>) -> Self {
        StepFailure::Setting(error)
    }
}

impl<S> StepFailure<S> {
    /// True if a run was refused because of its settings or parameters, so that it has no motion.
    /// Initial states are not among them, since any state of a motion may be invalid.
    pub fn is_refusal(&self) -> bool {
        match self {
            StepFailure::Setting(_) | StepFailure::Delay { .. } => true,
            StepFailure::OutOfRange(outside) => {
                matches!(outside.kind, RangedKind::Parameter | RangedKind::OfContact)
            }
            _ => false,
        }
    }

    /// Returns the event that caused the failure, if one did.
    pub fn event(&self) -> Option<EventSource> {
        match *self {
            StepFailure::EventNotFinite { event }
            | StepFailure::EventsAccumulate { event, .. }
            | StepFailure::EventNotLocated { event, .. }
            | StepFailure::EventUnresolved { event, .. }
            | StepFailure::NotDifferentiable { event, .. } => Some(event),
            _ => None,
        }
    }

    /// Replaces the event that the failure concerns with the result of `source`.
    pub(crate) fn of_event(mut self, source: impl FnOnce(EventSource) -> EventSource) -> Self {
        if let StepFailure::EventNotFinite { event }
        | StepFailure::EventsAccumulate { event, .. }
        | StepFailure::EventNotLocated { event, .. }
        | StepFailure::EventUnresolved { event, .. }
        | StepFailure::NotDifferentiable { event, .. } = &mut self
        {
            *event = source(*event);
        }
        self
    }

    /// Replaces the index of the event with its name. If switches accumulate, the failure becomes
    /// [`StepFailure::Slides`].
    pub(crate) fn named(self, declared: &'static [DeclaredEvent]) -> Self {
        let Some(EventSource::Given(index)) = self.event() else { return self };
        match (declared.get(index), self) {
            (Some(side), StepFailure::EventsAccumulate { .. }) if side.is_side => {
                StepFailure::Slides { surface: side.name }
            }
            (Some(event), cause) => cause.of_event(|_| EventSource::Declared(event.name)),
            (None, cause) => cause,
        }
    }
}
