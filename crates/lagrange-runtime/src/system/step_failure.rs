//! Why a step could not be taken.

use super::event::DeclaredEvent;
use super::out_of_range::OutOfRange;
use super::setting_error::SettingError;
use super::undefined::Undefined;
use super::violation::Violation;

/// Why a step could not be taken.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum StepFailure<S> {
    /// No step was tried, because a setting makes no sense.
    Setting(SettingError<S>),
    /// A time, the state or its rate is NaN or infinite. Methods do not know which; runs name it
    /// where possible, as [`Undefined`](StepFailure::Undefined).
    NotFinite,
    /// This is NaN or infinite, or makes what follows from it so.
    Undefined(Undefined<S>),
    /// Errors of the initial state, measured by the tolerance, are not numbers or too large for
    /// them, so that no first step can be chosen.
    NoFirstStep {
        /// The error that is tolerated as a part of the state.
        relative: S,
        /// The error that is tolerated in the units of the state.
        absolute: S,
    },
    /// The step required by the tolerance is lost in the rounding of time.
    StepUnderflow {
        /// The required step.
        step: S,
    },
    /// Steps of the length that was set are lost in the rounding of time.
    StepLost {
        /// The length that was set.
        step: S,
        /// The time, of the way that the run was to go.
        time: S,
    },
    /// The run took the maximum number of steps.
    TooManySteps {
        /// Maximum number of steps.
        limit: u64,
    },
    /// An explicit method whose steps are limited by stability and not by accuracy.
    Stiff {
        /// About the longest step that is stable.
        limit: S,
        /// The larger tolerance of the method.
        tolerance: S,
        /// True if the declaration may emit the Jacobian, and does not.
        wants_jacobian: bool,
    },
    /// A method in steps of given length whose step is longer than stability allows.
    StepTooLong {
        /// The length of the step.
        step: S,
        /// About the longest step that is stable at this state: what the method stands over the
        /// magnitude of the largest eigenvalue of the linearised equations.
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
    /// A state violates a constraint, and cannot be brought onto it.
    Violated(Violation<S>),
    /// A parameter is outside of its declared range.
    OutOfRange(OutOfRange<S>),
    /// A coefficient of restitution that is not from 0 to 1.
    Restitution {
        /// The name of the contact.
        contact: &'static str,
        /// Value.
        value: S,
    },
    /// A limit of friction that is negative.
    FrictionLimit {
        /// The name of the friction.
        friction: &'static str,
        /// The limit, or its change with a unit of a contact force.
        value: S,
    },
    /// Impulses of contacts and friction over a step miss their law by more than is allowed.
    Residual {
        /// The contact or friction that misses it most.
        reaction: &'static str,
        /// The rate by which it does.
        value: S,
    },
    /// No motion continues from here, in words: no contact forces or friction fit the state, or a
    /// method of another crate failed.
    Stuck(&'static str),
    /// The number of events at the same time is so large that it counts as infinite, as when a
    /// bouncing ball comes to rest.
    EventsAccumulate {
        /// Number of events.
        events: u32,
        /// Source of the last event.
        event: EventSource,
    },
    /// The state slides along a surface on which the equations are not smooth: on either side they
    /// lead back to it.
    Slides {
        /// The function that vanishes there and changes its sign, and the statement that holds it.
        surface: &'static str,
    },
    /// The zero of an event function could not be located.
    EventNotLocated {
        /// Source of the event.
        event: EventSource,
        /// Number of bisections.
        bisections: u32,
    },
    /// An event function passes zero between two times so fast that neither is near its zero: times
    /// so far from zero are too far apart.
    EventUnresolved {
        /// Source of the event.
        event: EventSource,
        /// The time.
        time: S,
        /// Its distance from the next one.
        spacing: S,
    },
    /// The state after an event has no derivative by this variable. The function of the event
    /// touches zero without a rate, or its outcome changes with the variable.
    NotDifferentiable {
        /// Source of the event.
        event: EventSource,
        /// The parameter, input or initial state.
        variable: &'static str,
    },
}

/// The source of an event function.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum EventSource {
    /// The declaration of the system, where it has this name.
    Declared(&'static str),
    /// The run, to which it was given beside others, counted from zero. A simulation knows it by
    /// name.
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

    /// Replaces the event that the failure concerns by the result of `source`.
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

    /// Replaces the index of the event by its name. Where switches accumulate, the state slides.
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
