//! Methods that advance a system ẏ = f(t, y) in time.
//!
//! One file per family of methods, each citing its source. They need no heap, run forwards or backwards in time,
//! and stop with a [`Cause`] instead of passing on NaN or infinity. States and times are summed with compensation, so
//! that rounding errors do not grow with the number of steps where the method itself lets them not.
//!
//! A [`Method`] is chosen and given to [`integrate`], or to the front door `simulate`, which also samples, watches
//! for events and keeps trajectories; loops of one's own drive a [`Stepper`].
//!
//! | method | order | symplectic | evaluations a step | systems |
//! |---|---|---|---|---|
//! | [`Verner98`] | 9, steps by tolerance | no | 16, and 9 where a state within the step is asked for | any that is not stiff |
//! | [`RungeKutta4`] | 4 | no | 4 | any that is not stiff |
//! | [`SymplecticEuler`] | 1 | yes | 1 | separable |
//! | [`StormerVerlet`] | 2 | yes | 1 | separable |
//! | [`BlanesMoan4`] | 4 | yes | 6 | separable |
//! | [`ImplicitMidpoint`] | 2 | yes | by iteration | any mass matrix, stiff or not |
//! | [`GaussLegendre4`], [`GaussLegendre6`] | 4, 6 | yes | by iteration | any mass matrix, stiff or not |
//! | [`Variational`] | 4 | yes, momenta kept to rounding | by iteration | any mass matrix |
//! | [`PlainGaussLegendre`] | 2, 4, 6 | if the mass matrix is constant | by iteration | any, stiff or not |
//!
//! A separable system is one whose [declaration](crate::system!) shows a constant mass matrix and accelerations without
//! velocities; emitted types say so themselves ([`SeparableSystem`](crate::system::SeparableSystem)), and the compiler
//! refuses the others. The implicit methods for any mass matrix want momenta and their rates,
//! `emit { momentum_rates }`, and iterate by Newton's method with `emit { jacobian }`.

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
