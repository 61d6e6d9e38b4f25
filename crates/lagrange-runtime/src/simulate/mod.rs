//! Simulations: from a system and a start to a trajectory with named columns.
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
//! A run is requested in words: [`simulate`](Simulate::simulate) a start,
//! [`until`](Simulation::until) an end, and other settings of [`Simulation`], in any order. The
//! result is a [`Trajectory`], or a [`SimulationError`] that holds the trajectory up to the last
//! good state.
//!
//! | to | say |
//! |---|---|
//! | ask for accuracy | [`tolerance`](Simulation::tolerance), or another [`method`](Simulation::method) |
//! | sample | [`every_step`](Simulation::every_step), [`every`](Simulation::every) so often, [`at_times`](Simulation::at_times), [`ends_only`](Simulation::ends_only), [`dense`](Simulation::dense) for any time |
//! | watch quantities | [`energy`](Simulation::energy), [`momenta`](Simulation::momenta), [`accelerations`](Simulation::accelerations), [`outputs`](Simulation::outputs), [`observe`](Simulation::observe) anything |
//! | differentiate with respect to parameters | [`sensitivities`](Simulation::sensitivities) |
//! | set inputs | [`drive`](Simulation::drive) by a law, or by a controller that is [`sampled`](Simulation::sampled) |
//! | run with delayed signals | [`with_history`](Simulation::with_history) |
//! | find events | [`event`](Simulation::event), [`stop_at`](Simulation::stop_at), [`event_with`](Simulation::event_with) a reaction |
//! | name times at which forces jump | [`restart_at`](Simulation::restart_at) |
//! | set limits, see progress | [`max_steps`](Simulation::max_steps), [`progress`](Simulation::progress), [`cancel_when`](Simulation::cancel_when) |
//! | read | columns by name, [`state`](Trajectory::state), [`iter`](Trajectory::iter), [`at`](Trajectory::at), [`events`](Trajectory::events), [`work`](Trajectory::work) |
//! | save | [`save_csv`](Trajectory::save_csv); `save_parquet` with the feature `parquet` |
//! | plot | `plot_states`, `plot_energy`, `plot_phase`, `plot_pair`, `plot_columns` with the feature `plot` |
//!
//! # Methods
//!
//! The module `integrate` of the crate `lagrange` lists them, with what each is for; the default is
//! [`Verner98`]. Code for microcontrollers and inner loops goes without heap through
//! [`integrate()`](crate::run::integrate).

mod builder;
mod closed_loop;
mod control;
mod controllers;
mod csv;
mod delays;
mod dense;
mod error;
mod events;
mod gradient;
mod history;
mod observer;
#[cfg(feature = "parquet")]
mod parquet;
mod plan;
#[cfg(feature = "plot")]
mod plots;
mod ports;
mod progress;
mod record;
mod run;
mod sampling;
mod sensitivity;
mod setters;
mod start;
mod table;
mod trajectory;
mod units;
#[cfg(not(all(feature = "plot", feature = "parquet")))]
mod without_features;

#[cfg(doc)]
use crate::integrate::Verner98;
use crate::system::MechanicalSystem;

#[cfg(feature = "ensemble")]
pub(crate) use self::builder::ENERGY;
#[cfg(any(feature = "ensemble", feature = "fit"))]
pub(crate) use self::builder::default_method;
pub use self::builder::{Ended, Simulation, Start, Unended};
pub use self::closed_loop::{ClosedLoop, GivenEvent};
pub use self::control::{Drive, Driven, Law, Undriven};
#[cfg(feature = "ensemble")]
pub(crate) use self::controllers::Act;
pub use self::delays::{Remembering, WithHistory};
pub use self::error::SimulationError;
#[cfg(feature = "ensemble")]
pub(crate) use self::error::explain_run;
pub use self::events::Event;
#[cfg(feature = "ensemble")]
pub(crate) use self::events::EventOf;
pub use self::gradient::Gradient;
#[cfg(any(feature = "ensemble", feature = "fit"))]
pub(crate) use self::observer::state_names;
#[cfg(feature = "ensemble")]
pub(crate) use self::observer::{columns_of, energy, inputs};
#[cfg(all(feature = "fit", feature = "parquet"))]
pub(crate) use self::parquet::UNIT_KEY;
#[cfg(all(feature = "ensemble", feature = "parquet"))]
pub(crate) use self::parquet::units;
#[cfg(feature = "ensemble")]
pub(crate) use self::plan::RunSettings;
#[cfg(any(feature = "ensemble", feature = "fit"))]
pub(crate) use self::plan::{Plan, RunPlan};
#[cfg(all(any(feature = "ensemble", feature = "fit", feature = "linear"), feature = "plot"))]
pub(crate) use self::plots::time_axis;
#[cfg(feature = "ensemble")]
pub(crate) use self::ports::held;
#[cfg(feature = "fit")]
pub(crate) use self::progress::Cancellation;
pub use self::progress::{Progress, Verdict};
#[cfg(feature = "ensemble")]
pub(crate) use self::sampling::Grid;
#[cfg(any(feature = "ensemble", feature = "fit"))]
pub(crate) use self::sampling::Sampling;
#[cfg(feature = "ensemble")]
pub(crate) use self::sensitivity::uncounted;
#[cfg(feature = "fit")]
pub(crate) use self::sensitivity::varied;
pub use self::sensitivity::{Differentiated, Sensitive, Stacked, Variables, Varied};
#[cfg(feature = "ensemble")]
pub(crate) use self::setters::{run_setters, tolerance_setters};
pub use self::start::InitialState;
#[cfg(any(feature = "fit", all(feature = "ensemble", feature = "plot")))]
pub(crate) use self::table::TIME;
pub use self::table::Table;
pub use self::trajectory::{Ending, NotKept, Trajectory};
#[cfg(all(any(feature = "ensemble", feature = "fit", feature = "linear"), feature = "plot"))]
pub(crate) use self::units::label_with_unit;
#[cfg(all(feature = "linear", feature = "plot"))]
pub(crate) use self::units::quotient;
#[cfg(any(feature = "fit", all(feature = "ensemble", feature = "plot")))]
pub(crate) use self::units::unit;
#[cfg(feature = "linear")]
pub(crate) use self::units::unit_among;
#[cfg(all(feature = "ensemble", not(all(feature = "plot", feature = "parquet"))))]
pub(crate) use self::without_features::without_feature;
#[cfg(feature = "plot")]
pub use lagrange_plot::PlotError;

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
    fn simulate(&self, start: impl InitialState<Self::State>) -> Start<'_, Self> {
        Start::of(self, start.into_state())
    }
}

impl<M: MechanicalSystem> Simulate for M {}

#[cfg(test)]
mod tests;
