//! Ensembles: many motions of one declaration, from separate starts and with separate parameters,
//! over threads and processes.
//!
//! ```
//! use lagrange::Ensembles;
//! use lagrange::ensemble::Histogram;
//!
//! lagrange::system! {
//!     /// A point mass on a massless rod.
//!     #[derive(Clone)]
//!     pub struct Pendulum;
//!     param m = 1.0, l = 1.0, g = 9.81;
//!     coord theta;
//!     kinetic = 1/2 * m * (l * dot(theta))^2;
//!     potential = -m * g * l * cos(theta);
//! }
//!
//! let pendulum = Pendulum::default();
//! let ends = pendulum
//!     .ensemble(1000)
//!     .start(|_, random| [2.0 + 0.1 * random.normal(), 0.0])
//!     .parameters(|i, pendulum| pendulum.l = 0.5 + 1e-3 * i as f64)
//!     .until(1.0)
//!     .tolerance(1e-8)
//!     .seed(7)
//!     .run()?;
//! assert_eq!((ends.theta().len(), ends.failures().len()), (1000, 0));
//!
//! let starts: Vec<[f64; 2]> = (0..1000).map(|i| [1e-3 * i as f64, 0.0]).collect();
//! let ensemble = pendulum.ensemble(starts).until(1.0);
//! let angles = ensemble.reduce(Histogram::new(64), |histogram, motion| histogram.add(motion.end().theta))?;
//! assert_eq!(angles.count(), 1000);
//! # Ok::<(), lagrange::ensemble::EnsembleError>(())
//! ```
//!
//! | purpose | methods |
//! |---|---|
//! | define the motions | [`ensemble`](Ensembles::ensemble) with a number or a list of starts, [`start`](Motions::start), [`parameters`](Motions::parameters), [`until`](Motions::until), [`seed`](Ensemble::seed) |
//! | control the runs | [`tolerance`](Ensemble::tolerance), [`method`](Ensemble::method), [`drive`](Ensemble::drive), [`sampled`](Ensemble::sampled), [`stop_at`](Ensemble::stop_at), [`max_steps`](Ensemble::max_steps) as in single runs |
//! | keep ends | [`run`](Ensemble::run), which returns [`Ends`]; [`observe`](Ensemble::observe) and [`energy`](Ensemble::energy) add columns, [`sensitivities`](Ensemble::sensitivities) derivatives |
//! | keep samples | [`every`](Ensemble::every); `run` then returns [`Samples`] |
//! | keep a summary | [`reduce`](Ensemble::reduce) to [`Moments`], a [`Histogram`] or any [`Reduce`] |
//! | plot results | [`plot_quantiles`](Samples) over time, [`map`](Ends) over the two quantities of a [`Grid`], with the feature `plot` |
//! | save files | `save_parquet` with the feature `parquet`, which resumes after an interruption, and `verify` |
//! | examine one motion | [`motion`](Ensemble::motion) |
//! | spread the work | [`threads`](Ensemble::threads), [`shard`](Ensemble::shard); reductions over processes by MPI: `examples/mpi` |
//!
//! Every motion is a separate run of [`simulate`](mod@crate::simulate), with the same bits. They do
//! not depend on threads, shards, restarts or other motions. Reductions are accumulated in an order
//! that does not depend on threads either.
//!
//! Ensembles require the feature `ensemble`.

mod batch;
mod builder;
mod ends;
mod engine;
mod error;
mod failure;
mod grid;
mod histogram;
mod lanes;
#[cfg(feature = "plot")]
mod maps;
mod moments;
mod motion;
mod pack;
mod plan;
mod progress;
mod quantiles;
mod random;
mod reduce;
mod reduction;
mod requests;
mod room;
mod rows;
mod samples;
#[cfg(feature = "parquet")]
mod save;
mod shard;
mod starts;
#[cfg(test)]
mod tests;
#[cfg(not(all(feature = "parquet", feature = "plot")))]
mod without_features;

pub use self::builder::{Ensemble, Keep, KeepEnds, KeepSamples, Motions};
pub use self::ends::Ends;
pub use self::error::EnsembleError;
pub use self::failure::Failure;
pub use self::grid::Grid;
pub use self::histogram::Histogram;
#[cfg(feature = "plot")]
pub use self::maps::Map;
pub use self::moments::Moments;
pub use self::motion::Motion;
pub use self::pack::Pack;
pub use self::plan::SharedSystem;
pub use self::progress::Done;
pub use self::random::{OfNoise, OfParameters, OfStart, Purpose, Random};
pub use self::reduce::Reduce;
pub use self::reduction::Reduced;
pub use self::samples::Samples;
#[cfg(feature = "parquet")]
pub use self::save::{Saved, Verified, verify};
pub use self::shard::Shard;
pub use self::starts::Starts;

/// Ensembles of every mechanical system that threads may share.
pub trait Ensembles: SharedSystem + Sized {
    /// Creates motions of this system: a number of them, or one from each start of a list.
    fn ensemble(&self, starts: impl Starts<Self>) -> Motions<'_, Self> {
        Motions::new(self, starts)
    }
}

impl<M: SharedSystem> Ensembles for M {}
