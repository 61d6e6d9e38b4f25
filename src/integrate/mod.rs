//! Methods that advance a system ẏ = f(t, y) in time.
//!
//! One file per family of methods, each citing its source. They need no heap, run forwards or backwards in time,
//! and stop with a [`Cause`] instead of passing on NaN or infinity.
//!
//! A [`Method`] is chosen and given to [`integrate`], or to the front door `simulate`, which also samples, watches
//! for events and keeps trajectories; loops of one's own drive a [`Stepper`].

mod canonical;
#[cfg(test)]
mod canonical_systems;
mod clock;
mod compensated;
mod error;
mod fixed;
mod gauss;
mod interpolation;
mod linear;
mod method;
mod newton;
mod prediction;
mod rk4;
mod run;
mod splitting;
mod stability;
mod variational;
mod verner;

pub use self::error::{Cause, IntegrationError, Outcome};
pub use self::fixed::{FixedStepper, Formula};
pub use self::gauss::{GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, PlainGaussLegendre};
pub use self::method::{Method, Stepper, Work};
pub use self::rk4::{RungeKutta4, rk4_step};
pub use self::run::integrate;
pub use self::splitting::{BlanesMoan4, StormerVerlet, SymplecticEuler};
pub use self::variational::Variational;
pub use self::verner::{Verner98, VernerStepper};
