//! Messages about runs that stopped early.

use core::fmt::{Debug, Display, Formatter, Result};

use super::step_failure::{DelayFault, EventSource, StepFailure};

impl<S: Debug> Display for StepFailure<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.event() {
            Some(event) => explain(self, &event, f),
            None => explain(self, &"an event", f),
        }
    }
}

impl<S: Debug> core::error::Error for StepFailure<S> {}

impl<S: Debug> Display for DelayFault<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            DelayFault::NotPositive => f.write_str("positive and finite"),
            DelayFault::Steps { least } => write!(
                f,
                "at least {least:?} for a run of this length, as no step is longer: end it earlier, or by an event or \
                 `max_steps`"
            ),
            DelayFault::Times { least } => write!(
                f,
                "at least {least:?}, a thousand spacings of the times of this run: measure time from near the start"
            ),
            DelayFault::Past { least } => write!(
                f,
                "at least {least:?}, since the past is kept for the longest delay and no step is longer than the shortest"
            ),
        }
    }
}

impl Display for EventSource {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            EventSource::Declared(name) => write!(f, "{}", EventName(name)),
            EventSource::Given(0) => f.write_str("the first event"),
            EventSource::Given(index) => write!(f, "the event at index {index}"),
        }
    }
}

/// The name of an event in messages; names of switches contain a quoted expression.
pub(crate) struct EventName<'a>(pub(crate) &'a str);

impl Display for EventName<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.0 {
            name if name.contains('`') => write!(f, "the switch at {name}"),
            name => write!(f, "event `{name}`"),
        }
    }
}

/// Writes the reason why a run stopped, naming this event if the reason concerns one.
pub(crate) fn explain<S: Debug>(
    cause: &StepFailure<S>,
    event: &dyn Display,
    f: &mut Formatter<'_>,
) -> Result {
    match cause {
        StepFailure::Setting(error) => write!(f, "{error}"),
        StepFailure::Stuck(what) => f.write_str(what),
        StepFailure::Violated(violation) => write!(f, "{violation}"),
        StepFailure::OutOfRange(error) => write!(f, "{error}"),
        StepFailure::Delay { signal, lag, fault } => {
            write!(f, "the delay of `{signal}` is {lag:?}, but it must be {fault}")
        }
        StepFailure::Restitution { contact, value } => write!(
            f,
            "the coefficient of restitution of contact `{contact}` is {value:?}; it must be from 0 to 1"
        ),
        StepFailure::FrictionLimit { friction, value } => write!(
            f,
            "the limit of friction `{friction}` is negative ({value:?}); it is the magnitude of a force, which \
            always opposes the slip velocity"
        ),
        StepFailure::Painleve { contact, coefficient, critical } => {
            write!(
                f,
                "the coefficient of friction {coefficient:?} of contact `{contact}` leaves no consistent forces for bodies \
                that slip this way (Painlevé paradox)"
            )?;
            critical.as_ref().map_or(Ok(()), |critical| write!(f, "; it must be less than {critical:?}"))
        }
        StepFailure::Residual { reaction, value } => write!(
            f,
            "the impulse of `{reaction}` over a step misses the law of contacts by the rate {value:?}, more than the \
            largest residual: reduce the step"
        ),
        StepFailure::NotFinite => f.write_str("the state or its rate is NaN or infinite"),
        StepFailure::Undefined(what) => write!(f, "{what}"),
        StepFailure::NoFirstStep { relative, absolute } => write!(
            f,
            "no first step meets the tolerances, {relative:?} relative and {absolute:?} absolute: the state is \
            too small or its rates too large; increase the absolute tolerance"
        ),
        StepFailure::StepUnderflow { step } => {
            write!(
                f,
                "a step of {step:?} is below the rounding error of the time; the motion may be singular, or \
                too fast this far from time zero"
            )
        }
        StepFailure::StepLost { step, time } => write!(
            f,
            "steps of {step:?} are below the rounding error of the time {time:?}: use longer steps, or measure \
            time from near the start"
        ),
        StepFailure::TooManySteps { limit } => write!(
            f,
            "the limit of {limit} steps is reached; increase it, or use a larger tolerance or longer steps"
        ),
        StepFailure::Stiff { limit, tolerance, wants_jacobian } => write!(
            f,
            "the system is stiff: steps longer than about {limit:?} are unstable; use \
            `.method(Radau5::tolerance({tolerance:?}))`, named `radau` on the command line and in Python{}",
            if *wants_jacobian { ", and add `emit { jacobian }` to the declaration for speed" } else { "" }
        ),
        StepFailure::StepTooLong { step, limit } => write!(
            f,
            "a step of {step:?} is too long for this method, unstable above about {limit:?}: use shorter steps, or an \
            implicit method (`Radau5` for damped motion)"
        ),
        StepFailure::NotConverged { iterations } => write!(
            f,
            "an implicit step did not converge in {iterations} iterations; use shorter steps, or `Radau5`, which adapts them"
        ),
        StepFailure::SingularMassMatrix => {
            f.write_str("the mass matrix is singular: velocities do not follow from momenta here")
        }
        StepFailure::EventNotFinite { .. } => write!(f, "the function of {event} is NaN or infinite"),
        StepFailure::EventsAccumulate { events, .. } => write!(
            f,
            "events accumulate: the last {events} of {event} cannot be distinguished in time; stop there, or use `impact(…)`, \
             which closes contacts of resting bodies"
        ),
        StepFailure::Slides { surface } => write!(
            f,
            "the state stays where the sign of {surface} changes: on both sides the equations lead back there; \
            declare dry friction by `friction name = slip velocity, limit;`"
        ),
        StepFailure::EventNotLocated { bisections, .. } => {
            write!(f, "the zero of {event} could not be located in {bisections} bisections")
        }
        StepFailure::EventUnresolved { time, spacing, .. } => write!(
            f,
            "the zero of {event} could not be located: times near {time:?} are {spacing:?} apart, too coarse for this \
            motion; measure time from near the start"
        ),
        StepFailure::NotDifferentiable { variable, .. } => write!(
            f,
            "the motion after {event} has no derivative with respect to `{variable}`: the event is only touched there, or its \
            reaction is not smooth"
        ),
    }
}
