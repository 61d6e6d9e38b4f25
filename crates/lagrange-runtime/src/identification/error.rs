//! Why parameters are not identified.

use std::fmt::{Display, Formatter, Result as Written};

/// Why parameters are not identified.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum IdentificationError {
    /// A state, its accelerations or its forces are not finite, or the regressor is not.
    NotFinite {
        /// The state in the order of adding, counted from zero.
        state: usize,
    },
    /// There are no more forces than combinations.
    TooFew {
        /// Number of forces in all states.
        forces: usize,
        /// Number of combinations that they could tell.
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
            IdentificationError::TooFew { forces, combinations } => write!(
                f,
                "{forces} forces do not tell {combinations} combinations of parameters with their errors: \
                 add more states"
            ),
        }
    }
}

impl std::error::Error for IdentificationError {}
