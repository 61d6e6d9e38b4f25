//! An explicit Runge–Kutta pair of order nine with steps as long as a tolerance allows.
//!
//! Sixteen stages give the state to order nine and an estimate of its error of order eight. Within
//! a step, nine more give the state anywhere to order nine; they are evaluated only for steps whose
//! states are requested. Not symplectic, but at tolerances near rounding the drift of the energy is
//! rounding.
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

use crate::integrate::explicit::{ExplicitRungeKutta, TableauRow};
use crate::integrate::method::{LanesMethodVisitor, Method};
use crate::scalar::Scalar;
use crate::system::{OdeSystem, SettingError, StepFailure};

use self::lanes::ROWS;
pub use self::lanes::VernerLanes;
pub use self::lanes_dense::VernerLastStep;
use self::stage::STAGES;
pub use self::stepper::VernerStepper;
use self::tableau::ADVANCE;
use self::tolerance::check_settings;

/// Verner's pair of order nine in steps as long as the tolerance allows, for any system that is not
/// stiff.
///
/// An accepted step has an estimated error of at most `absolute + relative · |y|`, in the root mean
/// square over the components of the state. The motion propagates and accumulates these errors to
/// the end. Errors below 16 roundings of the state are always tolerated.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Verner98<S> {
    /// Error of a step as a part of the state.
    pub relative: S,
    /// Error of a step in the units of the state.
    pub absolute: S,
    /// Length of the first step to try; estimated if not given.
    pub first_step: Option<S>,
    /// No step is longer. The default is a twentieth of the way from the start to the end known
    /// there. While the state stays where it is, it is a two-hundredth, since errors do not show
    /// later changes. Forces that act for a shorter time than about a quarter of a step may be
    /// stepped over.
    pub longest_step: Option<S>,
    /// No more steps are tried, rejected ones included.
    pub max_steps: u64,
    /// True if to give up where stability and not the tolerance limits the steps.
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

/// No step is longer than this part of the way, unless that is a setting,
const LONGEST: f64 = 1.0 / 20.0;
/// nor than this part of it while the state stays where it is:
const LONGEST_AT_REST: f64 = 1.0 / 200.0;
/// while a step changes it by less than this part of what is tolerated.
const AT_REST: f64 = 1e-3;

impl<M: OdeSystem + ?Sized> Method<M> for Verner98<M::Scalar> {
    type Stepper = VernerStepper<M>;

    fn name(&self) -> &'static str {
        "Verner 9(8)"
    }

    fn order(&self) -> u32 {
        9
    }

    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        check_settings([self.relative, self.absolute], &[self.first_step, self.longest_step])
    }

    fn start(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self::Stepper, StepFailure<M::Scalar>> {
        Method::<M>::check(self)?;
        VernerStepper::start(*self, system, t, y, end)
    }

    fn with_longest_step(self, longest: M::Scalar) -> Result<Self, SettingError<M::Scalar>> {
        Ok(Verner98 { longest_step: Some(longest), ..self })
    }

    fn in_lanes<V: LanesMethodVisitor<M::Scalar>>(&self, visitor: V) -> Result<V::Output, V> {
        Ok(visitor.visit(*self))
    }
}

impl<S> ExplicitRungeKutta for Verner98<S> {
    /// Without the stage that only the error needs.
    const STAGES: &'static [TableauRow] = ROWS.split_at(STAGES - 1).0;
    const ADVANCE: TableauRow = ADVANCE.row();
}

#[cfg(test)]
mod tests;
