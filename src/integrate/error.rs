//! Why an integration stopped early.

use core::error::Error;
use core::fmt::{Debug, Display, Formatter};

use crate::constraint::Violation;
use crate::event::DeclaredEvent;
use crate::system::OdeSystem;

/// What came of an integration of the system M.
pub type Outcome<M, T> = Result<T, IntegrationError<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>>;

/// An integration stopped before its end; S is the scalar and Y the state.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct IntegrationError<S, Y> {
    /// Why.
    pub cause: Cause<S>,
    /// Time of `state`.
    pub time: S,
    /// The last good state that was reached; finite unless it is the initial one.
    pub state: Y,
}

/// Why a step could not be taken.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum Cause<S> {
    /// A setting that makes no sense, in words.
    Setting(&'static str),
    /// The initial state, a time or the rate of the state is NaN or infinite.
    NotFinite,
    /// Errors of the initial state, measured by the tolerance, are not numbers or too large for them, so that no first step can be
    /// chosen.
    NoFirstStep {
        /// The error that is tolerated as a part of the state.
        relative: S,
        /// The error that is tolerated in the units of the state.
        absolute: S,
    },
    /// The step that the tolerance asks for is lost in the rounding of time.
    StepUnderflow {
        /// That step.
        step: S,
    },
    /// As many steps were taken as are allowed.
    TooManySteps {
        /// How many that is.
        limit: u64,
    },
    /// More samples were asked for than can be kept.
    TooManySamples {
        /// How many there would be.
        samples: S,
        /// How many there may be.
        most: S,
    },
    /// A control gave an input that is NaN or infinite.
    InputNotFinite {
        /// The name of the input.
        name: &'static str,
    },
    /// An output was asked for that the system does not declare.
    UnknownOutput {
        /// What was asked for.
        name: &'static str,
        /// The outputs that there are, or their components.
        known: &'static [&'static str],
    },
    /// An explicit method whose steps are limited by stability and not by accuracy.
    Stiff {
        /// About the longest step that is stable.
        limit: S,
    },
    /// The equations of an implicit step could not be solved.
    NotConverged {
        /// How many iterations were made.
        iterations: u32,
    },
    /// The mass matrix is singular, so that velocities do not follow from momenta.
    SingularMassMatrix,
    /// An event function is NaN or infinite.
    EventNotFinite {
        /// Which event, counted from zero: those of the declaration, then those given, in their order.
        event: usize,
    },
    /// A state violates a constraint, and cannot be brought onto it.
    Violated(Violation<S>),
    /// A coefficient of restitution that is not from 0 to 1.
    Restitution {
        /// The name of the contact.
        contact: &'static str,
        /// What it is.
        value: S,
    },
    /// No motion goes on from here, in words: no contact forces or friction fit the state.
    Stuck(&'static str),
    /// A method of another crate failed, in words.
    Adapted(&'static str),
    /// So many events follow each other at the same time that they are taken for infinitely many, as the bounces of a ball
    /// that comes to rest.
    EventsAccumulate {
        /// How many were counted.
        events: u32,
        /// Which event the last of them was, counted from zero: those of the declaration, then those given, in their order.
        event: usize,
        /// What it is called in the declaration, if it stands there.
        name: Option<&'static str>,
    },
    /// The state slides along a surface on which the equations are not smooth: on either side they lead back to it.
    Slides {
        /// The function that vanishes there and changes its sign, and the statement that holds it.
        surface: &'static str,
    },
    /// The zero of an event function could not be located.
    EventNotLocated {
        /// Which event, counted from zero: those of the declaration, then those given, in their order.
        event: usize,
        /// How many bisections were made.
        bisections: u32,
    },
}

impl<S> Cause<S> {
    /// The same, with events counted from this many others on.
    pub(crate) fn of_event_after(self, others: usize) -> Self {
        match self {
            Cause::EventNotFinite { event } => Cause::EventNotFinite { event: others + event },
            Cause::EventNotLocated { event, bisections } => {
                Cause::EventNotLocated { event: others + event, bisections }
            }
            Cause::EventsAccumulate { events, event, name } => {
                Cause::EventsAccumulate { events, event: others + event, name }
            }
            other => other,
        }
    }

    /// The same, with the name of the event if it is one of these. Where switches accumulate the state slides.
    pub(crate) fn named(self, declared: &'static [DeclaredEvent]) -> Self {
        let Cause::EventsAccumulate { events, event, .. } = self else { return self };
        match declared.get(event) {
            Some(side) if side.is_side => Cause::Slides { surface: side.name },
            found => Cause::EventsAccumulate { events, event, name: found.map(|event| event.name) },
        }
    }
}

impl<S: Debug> Display for Cause<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        match self {
            Cause::Setting(what) | Cause::Stuck(what) | Cause::Adapted(what) => f.write_str(what),
            Cause::Violated(violation) => write!(f, "{violation}"),
            Cause::Restitution { contact, value } => write!(
                f,
                "the coefficient of restitution of contact `{contact}` is {value:?}; it must be from 0 to 1"
            ),
            Cause::NotFinite => f.write_str("the state or its rate is NaN or infinite"),
            Cause::NoFirstStep { relative, absolute } => write!(
                f,
                "no first step fits the tolerance, {relative:?} of the state and {absolute:?} beside it: the state is too small or \
                 its rates are too large for that; tolerate a larger absolute error"
            ),
            Cause::StepUnderflow { step } => {
                write!(
                    f,
                    "a step of {step:?} is lost in the rounding of time; the motion may be singular here"
                )
            }
            Cause::TooManySteps { limit } => write!(f, "all {limit} steps that are allowed were taken"),
            Cause::TooManySamples { samples, most } => write!(
                f,
                "{samples:?} samples would be kept, more than {most:?}: take a longer interval, or `.ends_only()`"
            ),
            Cause::InputNotFinite { name } => {
                write!(f, "the control gave an input `{name}` that is NaN or infinite")
            }
            Cause::UnknownOutput { name, known } => {
                write!(f, "there is no output `{name}`; there are")?;
                known
                    .iter()
                    .enumerate()
                    .try_for_each(|(index, name)| write!(f, "{} `{name}`", if index == 0 { "" } else { "," }))
            }
            Cause::Stiff { limit } => write!(
                f,
                "the system is stiff: steps longer than about {limit:?} are unstable; take an implicit method"
            ),
            Cause::NotConverged { iterations } => write!(
                f,
                "an implicit step did not converge in {iterations} iterations; take shorter steps, or let the \
                 declaration `emit {{ jacobian }}`"
            ),
            Cause::SingularMassMatrix => {
                f.write_str("the mass matrix is singular: velocities do not follow from momenta here")
            }
            Cause::EventNotFinite { event } => write!(f, "the function of event {event} is NaN or infinite"),
            Cause::EventsAccumulate { events, event, name } => {
                write!(f, "events accumulate: the last {events} of event ")?;
                match name {
                    Some(name) => write!(f, "`{name}`")?,
                    None => write!(f, "{event}")?,
                }
                f.write_str(
                    " cannot be told apart in time; stop there, or declare a body that comes to rest with `impact(…)`, which \
                     closes the contact",
                )
            }
            Cause::Slides { surface } => write!(
                f,
                "the state stays where the sign of {surface} changes: on either side the equations lead back there, and they do \
                 not say what holds it; dry friction is declared by `friction name = slip velocity, limit;`"
            ),
            Cause::EventNotLocated { event, bisections } => {
                write!(f, "the zero of event {event} could not be located in {bisections} bisections")
            }
        }
    }
}

impl<S: Debug, Y> Display for IntegrationError<S, Y> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} (at time {:?})", self.cause, self.time)
    }
}

impl<S: Debug, Y: Debug> Error for IntegrationError<S, Y> {}
