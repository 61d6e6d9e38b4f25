//! Reductions of ensembles over the processes of an MPI job, with the same bits for any number of
//! processes.
//!
//! A program that reduces over processes starts from a copy of this file. All processes run the
//! same program with the same arguments. If one is killed, `mpirun` ends the others; saved parts
//! are kept, and a reduction starts again.

use std::error::Error;

use lagrange::ensemble::{Ensemble, Keep, Motion, Pack, Reduce, Shard, SharedSystem};
use lagrange::integrate::Method;
use lagrange::simulate::Drive;
use mpi::Threading;
use mpi::collective::SystemOperation;
use mpi::environment::Universe;
use mpi::traits::{Communicator, CommunicatorCollectives, Destination, Root, Source};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// A value reduced from the motions that succeeded, the number of failed motions, and the indices
/// of the first of them.
///
/// `Ensemble::motion` runs one of them again and returns its error.
pub(crate) type Sum<R> = (R, u64, Vec<u64>);

/// Maximum number of failures in a list; of further ones only the count is known.
const MAX_FAILURES: usize = 1000;
/// The rank that merges.
const FIRST: i32 = 0;

/// Starts MPI, which ends when the result is dropped. Threads of a process compute; the one that
/// calls this communicates.
pub(crate) fn initialize() -> Result<Universe> {
    let started = mpi::initialize_with_threading(Threading::Funneled);
    let (universe, threading) = started.ok_or("MPI was initialised already, or has ended")?;
    let has_threads = threading >= Threading::Funneled;
    has_threads.then_some(universe).ok_or_else(|| "this MPI does not allow a process to have threads".into())
}

/// Returns the shard of this process: whole consecutive parts, in the order of ranks.
pub(crate) fn shard(processes: &impl Communicator) -> Shard {
    // Ranks and sizes are not negative.
    Shard::of(u64::from(processes.rank().unsigned_abs()), u64::from(processes.size().unsigned_abs()))
}

/// Computes all motions, each process its shard, and hands their reduction to every process.
///
/// The first process merges the reductions of parts in their order. The result therefore has the
/// bits of `Ensemble::reduce` in a single process with the same parts. All processes must call this
/// with the same ensemble, which needs at least one part for each.
pub(crate) fn reduce_over<M, K, D, P, R>(
    processes: &impl CommunicatorCollectives,
    ensemble: Ensemble<'_, M, K, D, P>,
    identity: R,
    add: impl Fn(&mut R, &Motion<'_, M>) + Sync,
) -> Result<Sum<R>>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
    P: Keep,
    R: Reduce + Pack,
{
    let mut parts: Vec<Sum<R>> = Vec::new();
    let ensemble = ensemble.shard(shard(processes));
    let result = ensemble.reduce_parts(&identity, add, |part| {
        let failures = part.failures().iter().map(|failure| failure.index as u64).collect();
        let failed = part.failed();
        parts.push((part.into_value(), failed, failures));
    });
    all_ok(processes, result)?;
    let first = processes.process_at_rank(FIRST);
    let mut words = Vec::new();
    let sum = if processes.rank() == FIRST {
        merged(processes, (identity, 0, Vec::new()), parts)
    } else {
        parts.pack(&mut words);
        first.send(&words[..]);
        Ok((identity, 0, Vec::new()))
    };
    // The others wait for the first in any case.
    words.clear();
    if let Ok(sum) = &sum {
        sum.pack(&mut words);
    }
    let mut length = words.len() as u64;
    first.broadcast_into(&mut length);
    words.resize(length as usize, 0);
    first.broadcast_into(&mut words[..]);
    sum.and_then(|_| unpacked(words, FIRST))
}

/// Waits until all processes have called this, and returns an error in all of them if one result is
/// an error.
///
/// A process that ended because of its own error would leave the others waiting for ever.
pub(crate) fn all_ok<T, E: Error + 'static>(
    processes: &impl CommunicatorCollectives,
    result: std::result::Result<T, E>,
) -> Result<T> {
    let mine = if result.is_ok() { processes.size() } else { processes.rank() };
    let mut first = 0;
    processes.all_reduce_into(&mine, &mut first, SystemOperation::min());
    let value = result?;
    if first < processes.size() {
        return Err(format!("the process with rank {first} failed, and reports the cause").into());
    }
    Ok(value)
}

/// Merges the parts of this process and those that the others send, which are not in memory
/// together.
fn merged<R: Reduce + Pack>(
    processes: &impl Communicator,
    mut sum: Sum<R>,
    parts: Vec<Sum<R>>,
) -> Result<Sum<R>> {
    let mut merge = |parts: Vec<Sum<R>>| {
        parts.into_iter().for_each(|part| sum.merge(part));
        sum.2.truncate(MAX_FAILURES);
    };
    merge(parts);
    let mut result = Ok(());
    for rank in FIRST + 1..processes.size() {
        // All are received, even after a damaged one.
        let (words, _) = processes.process_at_rank(rank).receive_vec::<u64>();
        result = result.and(unpacked(words, rank).map(&mut merge));
    }
    result.map(|()| sum)
}

/// Unpacks the words of a process.
fn unpacked<T: Pack>(words: Vec<u64>, rank: i32) -> Result<T> {
    let mut words = words.into_iter();
    let found = T::unpack(&mut words).filter(|_| words.next().is_none());
    found.ok_or_else(|| {
        format!("the process with rank {rank} sent other data: all must run one program").into()
    })
}
