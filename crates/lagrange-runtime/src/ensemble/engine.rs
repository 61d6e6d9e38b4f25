//! Distribution of motions over threads, in chunks of fixed size whose results are merged in order.

use core::ops::Range;
use std::string::ToString;
use std::vec::Vec;

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::error::EnsembleError;
use super::progress::Counter;

/// Number of motions accumulated into one summary, which one thread computes one after the other.
/// The bits of reductions depend on it.
pub(super) const BLOCK: usize = 64;
/// Maximum number of blocks per chunk in lanes. Towards the end of a chunk some lanes are empty.
const BLOCKS_IN_LANES: usize = 16;
/// Maximum number of blocks per chunk if samples are kept, since they are held in memory.
const BLOCKS_OF_SAMPLES: usize = 4;
/// Minimum number of chunks per thread, unless chunks are single blocks, so that fast threads find
/// more work.
const CHUNKS_FOR_BALANCE: usize = 4;
/// Number of chunks per thread that are computed before they are merged, and so are held in memory.
const CHUNKS_PER_THREAD: usize = 64;

/// A dedicated pool of threads, or the shared one.
pub(super) struct Engine {
    /// `None` for the calling thread alone, or for the shared pool.
    pool: Option<ThreadPool>,
    threads: usize,
    pub(super) chunk: usize,
    /// Number of chunks per thread that are computed before they are merged.
    ahead: usize,
}

impl Engine {
    /// Returns an engine with this many threads, or with the shared pool. Threads with stacks of a
    /// given size, in bytes, are a pool of their own.
    pub(super) fn new(threads: Option<usize>, stack: Option<usize>) -> Result<Self, EnsembleError> {
        let number = threads.unwrap_or_else(rayon::current_num_threads);
        let pool = match (threads, stack) {
            (_, Some(stack)) => Some(ThreadPoolBuilder::new().num_threads(number).stack_size(stack).build()),
            (None | Some(1), None) => None,
            (Some(_), None) => Some(ThreadPoolBuilder::new().num_threads(number).build()),
        };
        let pool = pool.transpose().map_err(|error| EnsembleError::Threads(error.to_string()))?;
        Ok(Engine { pool, threads: number, chunk: BLOCK, ahead: CHUNKS_PER_THREAD })
    }

    /// Uses chunks for lanes, with enough of them for all threads.
    pub(super) fn with_wide_chunks(self, motions: usize) -> Self {
        Engine { chunk: BLOCK * self.blocks(motions, BLOCKS_IN_LANES), ..self }
    }

    /// Uses chunks for lanes and samples, with as many motions ahead as without lanes.
    pub(super) fn with_chunks_of_samples(self, motions: usize) -> Self {
        let blocks = self.blocks(motions, BLOCKS_OF_SAMPLES);
        Engine { chunk: BLOCK * blocks, ahead: CHUNKS_PER_THREAD / blocks, ..self }
    }

    /// Returns the number of blocks in a chunk, at most `most`, that leaves enough chunks for all
    /// threads.
    fn blocks(&self, motions: usize, most: usize) -> usize {
        (motions / (BLOCK * CHUNKS_FOR_BALANCE * self.threads)).clamp(1, most)
    }

    /// Computes all chunks of the motions and passes their results on in order.
    ///
    /// # Errors
    /// If several motions fail, the error of the first. If the consumer fails, its error at once.
    pub(super) fn chunks<R: Send>(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        compute: impl Fn(Range<usize>) -> Result<R, EnsembleError> + Sync,
        mut merge: impl FnMut(R) -> Result<(), EnsembleError>,
    ) -> Result<(), EnsembleError> {
        let chunks = motions.clone().step_by(self.chunk);
        let chunks = chunks.map(|start| start..start.saturating_add(self.chunk).min(motions.end));
        let mut chunks = chunks.peekable();
        while chunks.peek().is_some() {
            let wave: Vec<_> = chunks.by_ref().take(self.ahead * self.threads).collect();
            for result in self.wave(wave, &compute) {
                merge(result?)?;
            }
            counter.check()?;
        }
        Ok(())
    }

    /// Computes some chunks and returns their results in order.
    fn wave<R: Send>(
        &self,
        chunks: Vec<Range<usize>>,
        compute: &(impl Fn(Range<usize>) -> R + Sync),
    ) -> Vec<R> {
        match &self.pool {
            Some(pool) => pool.install(|| chunks.into_par_iter().map(compute).collect()),
            None if self.threads == 1 => chunks.into_iter().map(compute).collect(),
            None => chunks.into_par_iter().map(compute).collect(),
        }
    }
}
