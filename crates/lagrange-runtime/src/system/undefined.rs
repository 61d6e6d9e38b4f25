//! Names of numbers that are NaN or infinite.

use core::fmt::{Debug, Display, Formatter, Result};

use super::Description;
use super::rate_name::WithSuffix;
use crate::scalar::Scalar;

/// A number that is not finite, or that makes derived numbers so.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum Undefined<S> {
    /// The time at which a run starts.
    StartTime {
        /// Value.
        value: S,
    },
    /// The time at which a run ends.
    EndTime {
        /// Value.
        value: S,
    },
    /// An input of the system, as set directly or by a controller.
    Input {
        /// Its name.
        name: &'static str,
        /// Value.
        value: S,
        /// Time of the evaluation.
        time: S,
    },
    /// A parameter of the system.
    Parameter {
        /// Its name.
        name: &'static str,
        /// Value.
        value: S,
    },
    /// A component of the initial state, or of a state set by an event.
    State {
        /// Component.
        component: Component,
        /// Value.
        value: S,
    },
    /// The rate of a component of the state, if the state itself is finite.
    Rate {
        /// The component whose rate this is.
        component: Component,
        /// Value.
        value: S,
        /// Time of the evaluation.
        time: S,
    },
    /// An algebraic unknown whose equation could not be solved.
    Unknown {
        /// Its name.
        name: &'static str,
        /// Time of the evaluation.
        time: S,
    },
    /// The gap or the normal of a contact.
    Contact {
        /// Its name.
        name: &'static str,
        /// Time of the evaluation.
        time: S,
    },
    /// The mass matrix, which is singular, so that accelerations do not follow from forces.
    MassMatrix {
        /// The velocity of the first pivot that is lost in rounding when velocities are eliminated
        /// with the largest pivots first.
        velocity: Component,
        /// The first pivot that is lost.
        pivot: S,
        /// Time of the evaluation.
        time: S,
    },
}

/// A component of a state.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Component {
    /// The position with this name.
    Coordinate(&'static str),
    /// The rate of the position with this name, if it is a velocity.
    Velocity(&'static str),
    /// The velocity with a separate name.
    NamedVelocity(&'static str),
    /// The component at this index of a state without names.
    Index(usize),
}

impl Component {
    /// Returns the component at this index of a state of the system, or of a longer state that
    /// begins with it.
    #[must_use]
    pub fn of(system: &Description, index: usize) -> Self {
        Component::named(system, index).unwrap_or(Component::Index(index))
    }

    /// Returns the component at this index, if it has a name.
    pub(crate) fn named(system: &Description, index: usize) -> Option<Self> {
        match system.coordinates.get(index) {
            Some(name) => Some(Component::Coordinate(name)),
            None => Component::of_velocity(system, index - system.coordinates.len()),
        }
    }

    /// Returns the velocity at this index among the velocities of the system.
    pub(crate) fn of_velocity(system: &Description, index: usize) -> Option<Self> {
        if system.velocities_are_rates() {
            return system.coordinates.get(index).copied().map(Component::Velocity);
        }
        system.velocities.get(index).copied().map(Component::NamedVelocity)
    }
}

impl<S: Scalar> Undefined<S> {
    /// Returns the first component of a state that is not finite, or otherwise the first of its
    /// rates at this time.
    pub fn of_state(time: S, y: &[S], rates: &[S], component: impl Fn(usize) -> Component) -> Option<Self> {
        let not_finite = |values: &[S]| values.iter().position(|value| !value.is_finite());
        let state = not_finite(y).map(|k| Undefined::State { component: component(k), value: y[k] });
        let rate = |k: usize| Undefined::Rate { component: component(k), value: rates[k], time };
        state.or_else(|| not_finite(rates).map(rate))
    }

    /// Replaces the number with the first of these algebraic unknowns, in the order of declaration,
    /// that has no value, if there is one.
    #[must_use]
    pub fn with_unknowns(self, time: S, unknowns: &[(&'static str, S)]) -> Self {
        let unsolved = unknowns.iter().find(|(_, value)| !value.is_finite());
        match (self, unsolved) {
            (Undefined::Rate { .. } | Undefined::MassMatrix { .. }, Some(&(name, _))) => {
                Undefined::Unknown { name, time }
            }
            _ => self,
        }
    }

    /// Replaces the number with the first of these contacts whose centres coincide, if there is
    /// one. Each has the distance of its centres or, on a cylinder, from the axis.
    #[must_use]
    pub fn with_contacts(self, time: S, distances: &[(&'static str, S)]) -> Self {
        let concentric = distances.iter().find(|(_, distance)| *distance == S::ZERO);
        match (self, concentric) {
            (Undefined::Rate { .. }, Some(&(name, _))) => Undefined::Contact { name, time },
            _ => self,
        }
    }

    /// Replaces a component index with its name, for states of this system and for longer states
    /// that start with one.
    #[must_use]
    pub fn with_names_of(mut self, system: &Description) -> Self {
        if let Undefined::State { component, .. } | Undefined::Rate { component, .. } = &mut self
            && let Component::Index(index) = *component
        {
            *component = Component::of(system, index);
        }
        self
    }
}

impl Display for Component {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Component::Coordinate(name) | Component::NamedVelocity(name) => write!(f, "`{name}`"),
            Component::Velocity(name) => write!(f, "`{}`", WithSuffix::velocity(name)),
            Component::Index(index) => write!(f, "the component at index {index}"),
        }
    }
}

/// The acceleration that is the rate of a velocity, for messages.
pub(crate) struct Acceleration(pub(crate) Component);

impl Display for Acceleration {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.0 {
            Component::NamedVelocity(name) => {
                write!(f, "the acceleration `{}`", WithSuffix::rate_of(name))
            }
            Component::Coordinate(name) | Component::Velocity(name) => {
                write!(f, "the acceleration `{}`", WithSuffix::acceleration(name))
            }
            Component::Index(_) => write!(f, "the rate of {}", self.0),
        }
    }
}

/// The name of a pivot of the mass matrix in messages: the name of the coordinate, if velocities
/// have no separate names.
struct Pivot(Component);

impl Display for Pivot {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.0 {
            Component::Velocity(name) => write!(f, "`{name}`"),
            other => write!(f, "{other}"),
        }
    }
}

impl<S: Debug> Display for Undefined<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Undefined::StartTime { value } => write!(f, "the time of the start is {value:?}"),
            Undefined::EndTime { value } => write!(f, "the time of the end is {value:?}"),
            Undefined::Input { name, value, time } => {
                write!(f, "the input `{name}` is {value:?} at time {time:?}")
            }
            Undefined::Parameter { name, value } => write!(f, "the parameter `{name}` is {value:?}"),
            Undefined::State { component, value } => write!(f, "{component} of the state is {value:?}"),
            Undefined::Rate { component, value, time } => {
                match component {
                    Component::Coordinate(name) => write!(f, "the rate `{}`", WithSuffix::velocity(name))?,
                    velocity => write!(f, "{}", Acceleration(*velocity))?,
                }
                write!(
                    f,
                    " is {value:?} at time {time:?} for a finite state; look for roots of negative numbers, negative powers of zero, or \
                     functions beyond their guards"
                )
            }
            Undefined::Unknown { name, time } => write!(
                f,
                "there is no solution for `{name}` at time {time:?}: its equation has none there, or Newton's method does not reach it from the start"
            ),
            Undefined::Contact { name, time } => write!(
                f,
                "the gap or normal of contact `{name}` is undefined at time {time:?}: its centres coincide, or a ball does \
                 not fit terrain"
            ),
            Undefined::MassMatrix { velocity, pivot, time } => write!(
                f,
                "the mass matrix is singular at time {time:?}: its pivot for {} is {pivot:?}, so {} does not follow from the forces",
                Pivot(*velocity),
                Acceleration(*velocity)
            ),
        }
    }
}
