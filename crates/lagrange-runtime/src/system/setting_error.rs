//! Settings of a run that make no sense.

use core::fmt::{Debug, Display, Formatter, Result};

/// A setting that makes no sense, reported before anything moves.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum SettingError<S> {
    /// The reason, in words.
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
        }
    }
}

impl<S: Debug> core::error::Error for SettingError<S> {}
