//! Why a fit fails.

use std::boxed::Box;
use std::fmt::{Debug, Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use super::fitted::Fitted;
use crate::system::ParametricSystem;

/// Why a fit fails.
#[non_exhaustive]
pub enum FitError<M: ParametricSystem<Scalar = f64>> {
    /// A column of the data is neither a state nor a measured quantity of the system, or a noise
    /// level has no column.
    UnknownColumn {
        /// Its name.
        name: String,
        /// Known names.
        known: Vec<String>,
    },
    /// The unit of a column of the data differs from the unit in the system.
    Unit {
        /// Its name.
        column: String,
        /// Unit in the data.
        unit: String,
        /// Unit of the system.
        wanted: &'static str,
    },
    /// The number of values of a column differs from the number of times.
    Length {
        /// Its name.
        column: String,
        /// Number of values.
        values: usize,
        /// Number of times.
        times: usize,
    },
    /// A value is NaN or infinite.
    NotFinite {
        /// The column, `t` for times.
        column: String,
        /// The row, counted from zero.
        row: usize,
    },
    /// Two columns have this name.
    RepeatedColumn(String),
    /// A time is not after the one before it, or not after the start.
    Times {
        /// The row of the time, counted from zero.
        row: usize,
    },
    /// The data have fewer values than there are variables.
    TooFew {
        /// Number of values.
        values: usize,
        /// Number of variables.
        variables: usize,
    },
    /// No variables were specified.
    NothingVaries,
    /// The system has no parameter, input or state of this name, or it varies twice.
    Variable {
        /// Its name.
        name: &'static str,
        /// The reason.
        reason: String,
    },
    /// Noise levels are missing or not positive.
    Noise {
        /// The column.
        column: String,
        /// The level, if there is one.
        level: Option<f64>,
    },
    /// No motion with the initial values of the search reaches the end of the data.
    Motion {
        /// The values, by name.
        values: Vec<(&'static str, f64)>,
        /// The cause.
        cause: String,
    },
    /// The data do not determine all variables. The fit contains the results so far, and the
    /// undetermined [combination](Fitted::weakest).
    Undetermined(Box<Fitted<M>>),
    /// The search did not converge; the fit contains the best values so far.
    NotConverged(Box<Fitted<M>>),
    /// The progress callback cancelled the fit. It contains the best values so far, if a motion
    /// reached the end of the data.
    Cancelled(Option<Box<Fitted<M>>>),
}

impl<M: ParametricSystem<Scalar = f64>> FitError<M> {
    /// Returns the best values so far, if motions were compared with the data.
    pub fn fitted(&self) -> Option<&Fitted<M>> {
        match self {
            FitError::Undetermined(fitted) | FitError::NotConverged(fitted) => Some(fitted),
            FitError::Cancelled(fitted) => fitted.as_deref(),
            _ => None,
        }
    }
}

impl<M: ParametricSystem<Scalar = f64>> Display for FitError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        match self {
            FitError::UnknownColumn { name, known } => write!(
                f,
                "nothing of the system is called `{name}`, as a column of the data is; known are {}",
                known.iter().map(|name| std::format!("`{name}`")).collect::<Vec<_>>().join(", ")
            ),
            FitError::Unit { column, unit, wanted } => {
                write!(
                    f,
                    "column `{column}` of the data is in {unit}, and `{column}` of the system in {wanted}"
                )
            }
            FitError::Length { column, values, times } => {
                write!(f, "column `{column}` has {values} values for {times} times")
            }
            FitError::NotFinite { column, row } => write!(
                f,
                "the value in row {row} of column `{column}` is not finite; leave values out that are missing"
            ),
            FitError::RepeatedColumn(name) => write!(f, "two columns of the data are called `{name}`"),
            FitError::Times { row } => write!(
                f,
                "the time in row {row} is not after the one before it, or before the start of the motion"
            ),
            FitError::TooFew { values, variables } => {
                write!(f, "{values} values do not tell {variables} variables: vary fewer, or measure more")
            }
            FitError::NothingVaries => {
                f.write_str("nothing varies: name a parameter by `.vary(\"m\", 0.1..=10.0)`")
            }
            FitError::Variable { name, reason } => write!(f, "`{name}` cannot vary: {reason}"),
            FitError::Noise { column, level: Some(level) } => {
                write!(f, "the noise level {level:?} of column `{column}` is not a positive number")
            }
            FitError::Noise { column, level: None } => write!(
                f,
                "column `{column}` needs a noise level, `.noise(\"{column}\", …)`, by which its residuals count \
                 beside those of other columns"
            ),
            FitError::Motion { values, cause } => {
                f.write_str("no motion reaches the end of the data from")?;
                for (index, (name, value)) in values.iter().enumerate() {
                    write!(f, "{} {name} = {value:?}", if index == 0 { "" } else { "," })?;
                }
                write!(f, ": {cause}")
            }
            FitError::Undetermined(fitted) => {
                f.write_str("the data do not tell all variables: nearly the same motion follows if")?;
                fitted.write_weakest(f)?;
                f.write_str(" change together; give one of them its value, or measure something else")
            }
            FitError::Cancelled(_) => f.write_str("the fit was cancelled"),
            FitError::NotConverged(fitted) => write!(
                f,
                "no minimum was found in {} iterations; the last values are in the error: {}",
                fitted.iterations(),
                fitted
                    .values()
                    .iter()
                    .map(|value| std::format!("{} = {:?}", value.name, value.value))
                    .collect::<Vec<_>>()
                    .join(", ")
            ),
        }
    }
}

impl<M: ParametricSystem<Scalar = f64>> Debug for FitError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        write!(f, "FitError({self})")
    }
}

impl<M: ParametricSystem<Scalar = f64>> std::error::Error for FitError<M> {}
