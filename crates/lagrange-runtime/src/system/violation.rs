//! The violated constraint and its residual.

use core::error::Error;
use core::fmt::{Debug, Display, Formatter};

/// A violated constraint or contact.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Violation<S> {
    /// Name of the contact, or of the constraint with the largest violation.
    pub constraint: &'static str,
    /// Residual: c, dc/dt or a gap, according to `of`.
    pub residual: S,
    /// Violating part of the state.
    pub of: Violated,
}

/// The part of the state that violates a constraint.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Violated {
    /// Positions: c is not zero.
    Positions,
    /// Positions satisfy the constraint and velocities do not: dc/dt is not zero.
    Velocities,
    /// Positions overlap: a gap is negative, or the gap of a closed contact is not zero.
    Gap,
}

impl<S> Violation<S> {
    /// Creates the violation of a contact with this gap.
    pub(crate) fn of_gap(contact: &'static str, gap: S) -> Self {
        Violation { constraint: contact, residual: gap, of: Violated::Gap }
    }
}

impl<S: Debug> Display for Violation<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        let Violation { constraint, residual, of } = self;
        let what = match of {
            Violated::Positions => "the positions violate",
            Violated::Velocities => "the velocities violate",
            Violated::Gap => {
                return write!(
                    f,
                    "the gap of the contact `{constraint}` is {residual:?}: its bodies overlap"
                );
            }
        };
        write!(f, "{what} the constraint `{constraint}`, which is {residual:?} instead of 0")
    }
}

impl<S: Debug> Error for Violation<S> {}
