//! The parts of all processes, merged in their order.

use lagrange::ensemble::{Ensemble, EnsembleError, Keep, Motion, Pack, Reduce, SharedSystem};
use lagrange::integrate::Method;
use lagrange::simulate::Drive;
use mpi::collective::SystemOperation;
use mpi::traits::{Communicator, CommunicatorCollectives, Destination, Root, Source};

use crate::error::MpiError;
use crate::processes::shard;
use crate::sum::Sum;

/// Lets ensembles be summed up over the processes of an MPI job.
pub trait ReduceOver<M: SharedSystem> {
    /// Computes all motions, each process its [share](shard), and hands to every process what all of them come down to. A shard that the
    /// ensemble was given counts for nothing.
    ///
    /// Every process sends what each of its [parts](Ensemble::motions_per_part) comes down to to the first one, which merges them in their
    /// order: the sum has the bits of [`Ensemble::reduce`] in a single process with the same parts, for any number of processes. All of
    /// them must call this, with the same ensemble. There must be a part for each at least.
    ///
    /// # Errors
    /// If the share of a process cannot be computed; the others are told when they have computed theirs, so that none waits for ever. A
    /// process that is killed ends all, as `mpirun` sees to.
    fn reduce_over<R: Reduce + Pack>(
        self,
        processes: &impl CommunicatorCollectives,
        identity: R,
        add: impl Fn(&mut R, &Motion<'_, M>) + Sync,
    ) -> Result<Sum<R>, MpiError>;
}

impl<M, K, D, P> ReduceOver<M> for Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
    P: Keep,
{
    fn reduce_over<R: Reduce + Pack>(
        self,
        processes: &impl CommunicatorCollectives,
        identity: R,
        add: impl Fn(&mut R, &Motion<'_, M>) + Sync,
    ) -> Result<Sum<R>, MpiError> {
        let mut parts = Vec::new();
        let ensemble = self.shard(shard(processes));
        let result = ensemble.reduce_parts(&identity, add, |part| parts.push(Sum::of_part(part)));
        all_ok(processes, result)?;
        collect(processes, Sum::new(identity), parts)
    }
}

/// Waits until all processes come here with a result, as of saving their shards.
///
/// A process that ended because of an error alone would leave the others waiting for it for ever.
///
/// # Errors
/// If one of the results is an error: everywhere.
pub fn all_ok<T>(
    processes: &impl CommunicatorCollectives,
    result: Result<T, EnsembleError>,
) -> Result<T, MpiError> {
    let (mine, mut first) = (if result.is_ok() { processes.size() } else { processes.rank() }, 0);
    processes.all_reduce_into(&mine, &mut first, SystemOperation::min());
    match result {
        Ok(_) if first < processes.size() => Err(MpiError::Elsewhere { rank: first }),
        result => result.map_err(MpiError::Ensemble),
    }
}

/// The rank that merges.
const FIRST: i32 = 0;

/// Merges the parts of all processes at the first, which tells all.
fn collect<R: Reduce + Pack>(
    processes: &impl CommunicatorCollectives,
    none: Sum<R>,
    parts: Vec<Sum<R>>,
) -> Result<Sum<R>, MpiError> {
    let first = processes.process_at_rank(FIRST);
    let mut words = Vec::new();
    let sum = if processes.rank() == FIRST {
        Some(merged(processes, none, parts))
    } else {
        parts.pack(&mut words);
        first.send(&words[..]);
        words.clear();
        None
    };
    if let Some(Ok(sum)) = &sum {
        sum.pack(&mut words);
    }
    let mut length = words.len() as u64;
    first.broadcast_into(&mut length);
    words.resize(length as usize, 0);
    first.broadcast_into(&mut words[..]);
    sum.unwrap_or_else(|| unpacked(words, FIRST))
}

/// The parts of this process and those that the others send, which do not lie in memory together.
fn merged<R: Reduce + Pack>(
    processes: &impl Communicator,
    mut sum: Sum<R>,
    parts: Vec<Sum<R>>,
) -> Result<Sum<R>, MpiError> {
    parts.into_iter().for_each(|part| sum.merge(part));
    // Who sends is heard, also behind one that sent something else.
    let mut result = Ok(());
    for rank in FIRST + 1..processes.size() {
        let (words, _) = processes.process_at_rank(rank).receive_vec::<u64>();
        match unpacked::<Vec<Sum<R>>>(words, rank) {
            Ok(parts) => parts.into_iter().for_each(|part| sum.merge(part)),
            Err(error) => result = result.and(Err(error)),
        }
    }
    result.map(|()| sum)
}

/// Unpacks the words of a process.
fn unpacked<T: Pack>(words: Vec<u64>, rank: i32) -> Result<T, MpiError> {
    let mut words = words.into_iter();
    let found = T::unpack(&mut words).filter(|_| words.next().is_none());
    found.ok_or(MpiError::Garbled { rank })
}
