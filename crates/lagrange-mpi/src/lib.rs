//! Sums of an ensemble over the processes of an MPI job, with the same bits from any number of them.
//!
//! ```no_run
//! use lagrange::Ensembles;
//! use lagrange::ensemble::Moments;
//! use lagrange_mpi::ReduceOver;
//!
//! lagrange::system! {
//!     #[derive(Clone)]
//!     struct Pendulum;
//!     param l = 1.0, g = 9.81;
//!     coord theta;
//!     kinetic = 1/2 * (l * dot(theta))^2;
//!     potential = -g * l * cos(theta);
//! }
//!
//! let universe = lagrange_mpi::initialize()?;
//! let pendulum = Pendulum::default();
//! let ensemble = pendulum.ensemble(1_000_000).start(|_, random| [0.1 * random.normal(), 0.0]).until(1.0);
//! let angles = ensemble.reduce_over(&universe.world(), Moments::new(), |moments, motion| moments.add(motion.end().theta))?;
//! println!("{} ± {}", angles.mean(), angles.standard_deviation());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Every process runs the same program with the same arguments. Files need no MPI, `.shard(Shard::from_environment()?)` before
//! `.save_parquet(…)` will do; in a program that has it `all_ok(&world, ensemble.shard(shard(&world)).save_parquet(…))` lets no process wait
//! for one that failed.
//!
//! If a process is killed `mpirun` ends the others. Parts that were saved are kept, and the job started again goes on behind them; a sum
//! begins anew. Ensembles that take longer than machines live are saved, and what they come down to is read from their files.
//!
//! Not for single machines, on which threads do the same with less.

#![forbid(unsafe_code)]

mod collect;
mod error;
mod processes;
mod sum;

pub use self::collect::{ReduceOver, all_ok};
pub use self::error::MpiError;
pub use self::processes::{initialize, shard};
pub use self::sum::Sum;
