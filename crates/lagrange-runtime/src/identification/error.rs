//! Errors of the identification of parameters.

use std::fmt::{Display, Formatter, Result as Written};

/// The reason why parameters cannot be identified.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum IdentificationError {
    /// A state, its accelerations or its forces are not finite, or the regressor is not.
    NotFinite {
        /// The state in the order of adding, counted from zero.
        state: usize,
    },
    /// A parameter of the system is not finite.
    UndefinedParameter {
        /// Its name.
        name: &'static str,
    },
    /// The system is defined in none of many states that look random.
    Undefined {
        /// The largest magnitude of their entries.
        reach: f64,
    },
    /// The number of forces does not exceed the number of combinations.
    TooFew {
        /// Number of forces in all states.
        forces: usize,
        /// Number of combinations to be determined.
        combinations: usize,
    },
}

impl Display for IdentificationError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        match self {
            IdentificationError::NotFinite { state } => write!(
                f,
                "state {state}, counted from zero, or the regressor there, is not finite: leave it out"
            ),
            IdentificationError::UndefinedParameter { name } => {
                write!(
                    f,
                    "`{name}` is not finite: give the system a number for it, and for what it follows from"
                )
            }
            IdentificationError::Undefined { reach } => write!(
                f,
                "the regressor is not finite within ±{reach}: check the parameters of the system, or add other \
                 states to a `regression`"
            ),
            IdentificationError::TooFew { forces, combinations } => write!(
                f,
                "{forces} forces do not tell {combinations} combinations of parameters with their errors: \
                 add more states"
            ),
        }
    }
}

impl std::error::Error for IdentificationError {}
