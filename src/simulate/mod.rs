//! The front door: from a system and a start to a trajectory with named columns.
//!
//! ```
//! use lagrange::Simulate;
//!
//! lagrange::system! {
//!     /// A point mass on a massless rod.
//!     pub struct Pendulum;
//!     param m = 1.0, l = 1.0, g = 9.81;
//!     coord theta;
//!     kinetic = 1/2 * m * (l * dot(theta))^2;
//!     potential = -m * g * l * cos(theta);
//! }
//!
//! let trajectory = Pendulum::default().simulate([0.5, 0.0]).until(10.0).tolerance(1e-10).energy().run()?;
//! println!("{:?} after {} steps", trajectory.last(), trajectory.work().steps);
//! trajectory.write_csv(std::io::stdout())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A run is asked for in words: [`simulate`](Simulate::simulate) a start, [`until`](Start::until) an end, and then as
//! much of [`Simulation`] as is wanted: the method, what is sampled ([`every`](Simulation::every) so often, or
//! [`dense`](Simulation::dense)), what is observed besides the state, limits, and a callback for progress. What comes
//! back is a [`Trajectory`], or a [`SimulationError`] that holds the trajectory up to the last good state.
//!
//! # Methods
//!
//! | method | order | symplectic | cost of a step | take it for |
//! |---|---|---|---|---|
//! | [`Verner98`], the default | 9, adaptive | no | 16 evaluations, 9 more if sampled within | accuracy: anything from 1e-4 to rounding |
//! | [`RungeKutta4`] | 4 | no | 4 evaluations | fixed frame rates, systems with jumps |
//!
//! Code for microcontrollers and inner loops goes without heap through [`integrate`](crate::integrate::integrate).
//!
//! [`RungeKutta4`]: crate::integrate::RungeKutta4

mod builder;
mod csv;
mod dense;
mod error;
mod events;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "plot")]
mod plots;
mod progress;
mod record;
mod run;
mod sampling;
mod table;
mod trajectory;

#[cfg(doc)]
use crate::integrate::Verner98;
use crate::scalar::Scalar;
use crate::system::MechanicalSystem;

pub use self::builder::{Simulation, Start};
pub use self::error::SimulationError;
pub use self::events::Event;
pub use self::progress::{Progress, Verdict};
pub use self::table::Table;
pub use self::trajectory::{Ending, NotKept, Trajectory};
#[cfg(feature = "plot")]
pub use crate::plot::PlotError;

/// Lets every mechanical system be simulated.
pub trait Simulate: MechanicalSystem + Sized {
    /// Starts from a state at time 0: an array `[q…, v…]`, or the emitted type with named fields.
    ///
    /// # Example
    ///
    /// ```
    /// # lagrange::system! {
    /// #     pub struct Pendulum;
    /// #     param m = 1.0, l = 1.0, g = 9.81;
    /// #     coord theta;
    /// #     kinetic = 1/2 * m * (l * dot(theta))^2;
    /// #     potential = -m * g * l * cos(theta);
    /// # }
    /// use lagrange::Simulate;
    ///
    /// let start = PendulumState { theta: 0.5, theta_dot: 0.0 };
    /// let trajectory = Pendulum::default().simulate(start).until(2.0).every(0.1).run()?;
    /// assert_eq!(trajectory.len(), 21);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn simulate(&self, start: impl Into<Self::State>) -> Start<'_, Self> {
        Start::new(self, Self::Scalar::ZERO, start.into())
    }
}

impl<M: MechanicalSystem> Simulate for M {}

#[cfg(test)]
mod tests;
