//! The processes of a job.

use lagrange::ensemble::Shard;
use mpi::Threading;
use mpi::environment::Universe;
use mpi::traits::Communicator;

use crate::error::MpiError;

/// The MPI of this process, which ends when this is dropped. Its threads compute, and the one that calls this talks to other processes.
///
/// # Errors
/// If MPI runs already, or does not allow a process to have threads.
pub fn initialize() -> Result<Universe, MpiError> {
    let (universe, threading) =
        mpi::initialize_with_threading(Threading::Funneled).ok_or(MpiError::Initialized)?;
    if threading < Threading::Funneled { Err(MpiError::NoThreads) } else { Ok(universe) }
}

/// The share of this process: whole parts that follow each other, in the order of ranks.
pub fn shard(processes: &impl Communicator) -> Shard {
    // Ranks and sizes are not negative.
    Shard::of(u64::from(processes.rank().unsigned_abs()), u64::from(processes.size().unsigned_abs()))
}
