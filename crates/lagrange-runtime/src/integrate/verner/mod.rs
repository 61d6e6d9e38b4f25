//! An explicit Runge–Kutta pair of order nine with adaptive steps.
//!
//! Sixteen stages yield the state to order nine and an error estimate of order eight. Nine more
//! stages yield the state within a step to order nine. They are evaluated only for steps whose
//! states are requested. The pair is not symplectic, but at tolerances near rounding the drift of
//! the energy is at the level of rounding.
//!
//! Sources: Verner, "Numerically optimal Runge–Kutta pairs with interpolants", *Numerical
//! Algorithms* 53 (2010) 383–396, in the version of 2024; step control and first step: Hairer,
//! Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.4; stiffness: Hairer, Wanner, *Solving
//! Ordinary Differential Equations II*, §IV.2.

mod control;
mod dense;
mod interpolant;
mod lanes;
mod lanes_control;
mod lanes_dense;
mod stage;
mod stepper;
mod stiffness;
mod tableau;
pub(super) mod tolerance;

use crate::integrate::attempt::adaptive_steps;
use crate::integrate::explicit::{ExplicitRungeKutta, TableauRow};
use crate::integrate::method::{LanesMethodVisitor, Method};
use crate::scalar::Scalar;
use crate::system::{OdeSystem, SettingError};

use self::lanes::ROWS;
pub use self::lanes::VernerLanes;
pub use self::lanes_dense::VernerLastStep;
use self::stage::STAGES;
pub use self::stepper::VernerStepper;
use self::tableau::ADVANCE;
use self::tolerance::{check_precision, check_settings};

/// Verner's pair of order nine with adaptive steps, for any non-stiff system.
///
/// An accepted step has an estimated error of at most `absolute + relative · |y|`, in the root mean
/// square over the components of the state. The motion propagates and accumulates these errors to
/// the end. Errors below 16 roundings of the state are always tolerated.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Verner98<S> {
    /// Tolerated error of a step relative to the state.
    pub relative: S,
    /// Tolerated error of a step in the units of the state.
    pub absolute: S,
    /// Length of the first step to try; estimated by default.
    pub first_step: Option<S>,
    /// Maximum step length. The default is a twentieth of the interval from the start to the end
    /// known there. While the state is at rest, it is a two-hundredth, since errors do not reveal
    /// later changes. Forces that act for less than about a quarter of a step may be missed.
    pub longest_step: Option<S>,
    /// Maximum number of attempted steps, including rejected ones.
    pub max_steps: u64,
    /// True if the integration should fail when stability rather than the tolerance limits the
    /// steps.
    pub refuses_stiff: bool,
}

impl<S: Scalar> Verner98<S> {
    /// Creates the method with this tolerance, relative for a state larger than one, and absolute
    /// for a smaller one.
    pub fn tolerance(tolerance: S) -> Self {
        Verner98 {
            relative: tolerance,
            absolute: tolerance,
            first_step: None,
            longest_step: None,
            max_steps: 100_000_000,
            refuses_stiff: true,
        }
    }
}

/// Default maximum step length, as a fraction of the interval.
const LONGEST: f64 = 1.0 / 20.0;
/// Default maximum step length while the state is at rest, as a fraction of the interval.
const LONGEST_AT_REST: f64 = 1.0 / 200.0;
/// The least tolerance in numbers wider than `f64`, in which the coefficients are.
const LEAST_OF_COEFFICIENTS: f64 = 5e-19;
/// A state is at rest if a step changes it by less than this fraction of the tolerance.
const AT_REST: f64 = 1e-3;

impl<M: OdeSystem + ?Sized> Method<M> for Verner98<M::Scalar> {
    adaptive_steps! { "Verner 9(8)", VernerStepper }

    fn order(&self) -> u32 {
        9
    }

    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        check_precision([self.relative, self.absolute], LEAST_OF_COEFFICIENTS)?;
        check_settings([self.relative, self.absolute], &[self.first_step, self.longest_step])
    }

    fn in_lanes<V: LanesMethodVisitor<M::Scalar>>(&self, visitor: V) -> Result<V::Output, V> {
        Ok(visitor.visit(*self))
    }
}

impl<S> ExplicitRungeKutta for Verner98<S> {
    /// Omits the stage that only the error needs.
    const STAGES: &'static [TableauRow] = ROWS.split_at(STAGES - 1).0;
    const ADVANCE: TableauRow = ADVANCE.row();
}

#[cfg(test)]
mod tests;
