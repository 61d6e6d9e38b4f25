//! The violated constraint and its residual.

use core::error::Error;
use core::fmt::{Debug, Display, Formatter};

/// A constraint, or a contact, that does not hold where it must.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Violation<S> {
    /// The name of the constraint that is violated most, or of the contact.
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
    /// Positions satisfy it and velocities do not: dc/dt is not zero.
    Velocities,
    /// Positions overlap: a gap is negative, or one that is closed is not zero.
    Gap,
}

impl<S> Violation<S> {
    /// The gap of a contact that is not what it must be.
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
