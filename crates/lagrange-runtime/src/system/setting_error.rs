//! Invalid settings of a run.

use core::fmt::{Debug, Display, Formatter, Result};

use super::{Component, Description};

/// An invalid setting, reported before the motion starts.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum SettingError<S> {
    /// The reason, as text.
    Invalid(&'static str),
    /// Two columns of a run have the same name.
    RepeatedColumn,
    /// The run would keep too many samples.
    TooManySamples {
        /// Number of samples.
        samples: S,
        /// Maximum number of samples.
        most: S,
    },
    /// The system does not declare this output.
    UnknownOutput {
        /// Requested name.
        name: &'static str,
        /// The declared outputs or their components.
        known: &'static [&'static str],
    },
    /// The system has no parameter, input or state of this name.
    UnknownVariable {
        /// Requested name.
        name: &'static str,
        /// Parameters and inputs.
        numbers: &'static [&'static str],
        /// The states.
        state: &'static Description,
    },
    /// Times at which the equations jump depend on a parameter or input. Derivatives of the motion
    /// by it are then not supported.
    MovesTimes {
        /// Its name.
        name: &'static str,
    },
}

impl<S: Debug> Display for SettingError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            SettingError::Invalid(what) => f.write_str(what),
            SettingError::RepeatedColumn => f.write_str("two columns have the same name; rename one of them"),
            SettingError::TooManySamples { samples, most } => write!(
                f,
                "{samples:?} samples exceed the limit of {most:?}: use a longer interval, or `.ends_only()`"
            ),
            SettingError::UnknownOutput { name, known } => {
                write!(f, "there is no output `{name}`; there are")?;
                let mut known = known.iter().enumerate();
                known
                    .try_for_each(|(index, name)| write!(f, "{} `{name}`", if index == 0 { "" } else { "," }))
            }
            SettingError::UnknownVariable { name, numbers, state } => {
                write!(f, "there is no parameter, input or state `{name}`; there are")?;
                let known = numbers.iter().map(|name| Component::Coordinate(name));
                let states = (0..).map_while(|index| Component::named(state, index));
                { known.chain(states).enumerate() }
                    .try_for_each(|(index, name)| write!(f, "{} {name}", if index == 0 { "" } else { "," }))
            }
            SettingError::MovesTimes { name } => write!(
                f,
                "the equations jump at times that depend on `{name}`: sensitivities to it are not \
                 supported; write the condition as a function of the state"
            ),
        }
    }
}

impl<S: Debug> core::error::Error for SettingError<S> {}
