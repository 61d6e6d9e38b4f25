//! Causes of a search or a linearisation without a result.

use std::boxed::Box;
use std::error::Error;
use std::fmt::{Debug, Display, Formatter, Result};
use std::string::{String, ToString};
use std::vec::Vec;

use super::names::Names;
use crate::system::{Acceleration, Component, MechanicalSystem, OutOfRange, StepFailure, Undefined};

/// An equation of an equilibrium.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Equation {
    /// The rate of this velocity is zero.
    Acceleration(Component),
    /// The rate of the first-order state of this name is zero.
    Rate(&'static str),
    /// The constraint of this name holds.
    Constraint(&'static str),
}

impl Display for Equation {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Equation::Acceleration(component) => write!(f, "{}", Acceleration(*component)),
            Equation::Rate(name) => write!(f, "the rate of the state `{name}`"),
            Equation::Constraint(name) => write!(f, "the constraint `{name}`"),
        }
    }
}

/// A search that found no equilibrium, and the last good state.
pub struct EquilibriumError<M: MechanicalSystem> {
    /// Cause.
    pub cause: EquilibriumCause<M::Scalar>,
    /// The state at which Newton's method stopped.
    pub state: M::State,
    /// The inputs at which it stopped, in the order of their declaration; empty if none were
    /// trimmed.
    pub inputs: Vec<M::Scalar>,
    /// Number of steps that were taken.
    pub iterations: u32,
    pub(super) names: Box<Names>,
}

/// The cause of a search without a result.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum EquilibriumCause<S> {
    /// This is NaN or infinite where the search starts.
    Undefined(Undefined<S>),
    /// A derivative is NaN or infinite where the search stopped.
    Derivative(Undetermined),
    /// No step brings the equations closer to zero, and this one is left.
    Left {
        /// The equation that is violated most.
        equation: Equation,
        /// Its value.
        residual: S,
        /// True if a change of any unknown changes it.
        is_changed: bool,
    },
    /// Accelerations vanish at the state, and change with the given velocities.
    Unsteady {
        /// The quantity that changes.
        equation: Equation,
        /// Its rate.
        rate: f64,
    },
    /// The velocities do not satisfy the constraints, as where a constraint moves.
    NotAdmitted(StepFailure<S>),
    /// The start of the search or the equilibrium is outside of its declared range.
    OutOfRange(OutOfRange<S>),
    /// A name that stands for no unknown.
    UnknownName {
        /// The name.
        name: String,
        /// The names that are known.
        known: Vec<String>,
    },
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl<M: MechanicalSystem> Debug for EquilibriumError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "EquilibriumError({self})")
    }
}

impl<M: MechanicalSystem> Display for EquilibriumError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match &self.cause {
            EquilibriumCause::Undefined(undefined) => return write!(f, "{undefined}"),
            EquilibriumCause::UnknownName { name, known } => {
                write!(f, "`{name}` is not among the unknowns: these are ")?;
                return listed(f, known.iter().map(|name| ("`", name, "`")));
            }
            EquilibriumCause::Derivative(entry) => write!(f, "no equilibrium was found: {entry}")?,
            EquilibriumCause::Left { equation, residual, is_changed } => {
                write!(f, "no equilibrium was found: {equation} remains {residual:?} instead of 0")?;
                if !is_changed {
                    write!(f, ", which no unknown changes there")?;
                }
            }
            EquilibriumCause::Unsteady { equation, rate } => write!(
                f,
                "the motion with these velocities is not steady: {equation} is 0 and changes by {rate:?} per unit of time"
            )?,
            EquilibriumCause::NotAdmitted(failure) => write!(f, "no equilibrium was found: {failure}")?,
            EquilibriumCause::OutOfRange(outside) => {
                write!(f, "no equilibrium was found within the declared ranges: {outside}")?;
            }
        }
        write!(f, " (Newton's method stopped after {} steps at ", self.iterations)?;
        let inputs = self.names.beyond.inputs.iter().zip(&self.inputs);
        let values = self.names.state.coordinates.iter().zip(self.state.as_ref()).chain(inputs);
        listed(f, values.map(|(name, value)| ("", name, std::format!(" = {value:?}"))))?;
        write!(f, ")")
    }
}

impl<M: MechanicalSystem> Error for EquilibriumError<M> {}

/// Writes items with commas between them, each in three pieces.
fn listed<A: Display, B: Display, C: Display>(
    f: &mut Formatter<'_>,
    items: impl Iterator<Item = (A, B, C)>,
) -> Result {
    for (index, (before, item, behind)) in items.enumerate() {
        let comma = if index == 0 { "" } else { ", " };
        write!(f, "{comma}{before}{item}{behind}")?;
    }
    Ok(())
}

/// The cause of a linearisation without a result.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum LinearisationError<S> {
    /// The state, or a rate at it, is NaN or infinite.
    Undefined(Undefined<S>),
    /// The state violates a constraint, or cannot be a state of a motion for another reason.
    NotAdmitted(StepFailure<S>),
    /// The state is on a switch, and on its two sides rates or derivatives differ.
    Corner {
        /// The function that vanishes there, and the statement that contains it.
        surface: &'static str,
    },
    /// A derivative is NaN or infinite.
    Derivative(Undetermined),
}

impl<S: Copy + Debug + PartialEq> Display for LinearisationError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            LinearisationError::Undefined(undefined) => write!(f, "{undefined}"),
            LinearisationError::NotAdmitted(failure) => write!(f, "{failure}"),
            LinearisationError::Corner { surface } => write!(
                f,
                "there is no linear model where {surface} is 0: the equations have a corner or jump there; linearise on one side of it"
            ),
            LinearisationError::Derivative(entry) => write!(f, "there is no linear model: {entry}"),
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl<S: Copy + Debug + PartialEq> Debug for LinearisationError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "LinearisationError({self})")
    }
}

impl<S: Copy + Debug + PartialEq> Error for LinearisationError<S> {}

/// An entry of the system matrix that is NaN or infinite.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Undetermined {
    /// The differentiated quantity.
    pub of: String,
    /// The name of the displacement, state, velocity or input by which it is differentiated.
    pub by: String,
}

impl Undetermined {
    /// Returns the entry at this row and column.
    pub(super) fn of(names: &Names, (row, column): (usize, usize)) -> Undetermined {
        let (components, layout) = (names.tangent(), names.beyond);
        let by = components.get(column).cloned();
        let input = || layout.inputs[column - components.len()].to_string();
        let by = by.unwrap_or_else(input);
        let beyond = row.saturating_sub(components.len());
        let of = match (components.get(row), layout.outputs.get(beyond)) {
            (Some(name), _) => std::format!("the rate of `{name}`"),
            (None, Some(name)) => std::format!("the output `{name}`"),
            (None, None) => {
                std::format!(
                    "the constraint velocity `{}`",
                    layout.constraints[beyond - layout.outputs.len()]
                )
            }
        };
        Undetermined { of, by }
    }
}

impl Display for Undetermined {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(
            f,
            "the derivative of {} by `{}` is not finite; look for roots at zero, singular mass matrices and constraints that depend on each other",
            self.of, self.by
        )
    }
}

/// Eigenvalues that the QR iteration did not find.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NotConverged;

impl Display for NotConverged {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "the iteration for the eigenvalues did not converge")
    }
}

impl Error for NotConverged {}

/// The cause for which a mode is not shown as a motion.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum ModeMotionError<S> {
    /// A setting is not finite, or not positive where it must be, or leads to a state that is not
    /// finite.
    Setting {
        /// Description of the number.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// The mode is that of another system.
    OtherSystem {
        /// Number of components of the mode.
        of_mode: usize,
        /// Number of displacements, first-order states and velocities of the system.
        of_system: usize,
    },
    /// The eigenvalue is zero up to rounding, so that nothing moves.
    Still,
    /// The film would be too long.
    TooMany {
        /// Number of moments.
        moments: f64,
    },
    /// No state at this amplitude satisfies the constraints.
    Constrained(StepFailure<S>),
}

impl<S: Copy + Debug + PartialEq> Display for ModeMotionError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            ModeMotionError::Setting { what, value } => {
                write!(f, "a mode cannot be shown with the {what} {value:?}")
            }
            ModeMotionError::OtherSystem { of_mode, of_system } => write!(
                f,
                "the mode has {of_mode} components and the system {of_system}: it is the mode of another system"
            ),
            ModeMotionError::Still => f.write_str(
                "the eigenvalue of the mode is zero up to rounding: nothing moves; its `extremes` can be shown",
            ),
            ModeMotionError::TooMany { moments } => {
                write!(f, "the film would have {moments:.0} moments: show fewer periods, or fewer moments a second")
            }
            ModeMotionError::Constrained(failure) => {
                write!(f, "the amplitude is too large for the constraints: {failure}")
            }
        }
    }
}

impl<S: Copy + Debug + PartialEq> Error for ModeMotionError<S> {}
