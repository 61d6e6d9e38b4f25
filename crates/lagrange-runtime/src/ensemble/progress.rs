//! Progress reports of an ensemble.

use std::boxed::Box;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::string::String;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::error::{EnsembleError, panic_message};
use crate::simulate::Verdict;

/// The progress of an ensemble.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Done {
    /// Number of finished motions, including failed ones and those found saved.
    pub motions: u64,
    /// Number of motions of the ensemble or shard.
    pub of: u64,
}

/// The callback, which returns false to cancel.
type Callback<'a> = Box<dyn FnMut(Done) -> bool + Send + 'a>;

/// A callback and the time of its last call.
pub(super) struct BatchReporter<'a>(Mutex<(Callback<'a>, Option<Instant>)>);

/// Time between two reports.
const INTERVAL: Duration = Duration::from_millis(50);

impl<'a> BatchReporter<'a> {
    pub(super) fn new<V: Verdict>(mut callback: impl FnMut(Done) -> V + Send + 'a) -> Self {
        BatchReporter(Mutex::new((Box::new(move |done| callback(done).go_on()), None)))
    }
}

/// A counter of the motions finished by all threads.
pub(super) struct Counter<'r, 'a> {
    reporter: Option<&'r BatchReporter<'a>>,
    motions: AtomicU64,
    of: u64,
    is_cancelled: AtomicBool,
    /// Message of a panic in the callback.
    panic: Mutex<Option<String>>,
}

impl<'r, 'a> Counter<'r, 'a> {
    pub(super) fn new(reporter: Option<&'r BatchReporter<'a>>, of: usize) -> Self {
        let (of, is_cancelled) = (of as u64, AtomicBool::new(false));
        Counter { reporter, motions: AtomicU64::new(0), of, is_cancelled, panic: Mutex::new(None) }
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }

    fn motions(&self) -> u64 {
        self.motions.load(Ordering::Relaxed)
    }

    /// Checks that the ensemble is to continue.
    ///
    /// # Errors
    /// If the callback cancelled the ensemble, or panicked.
    pub(super) fn check(&self) -> Result<(), EnsembleError> {
        if let Some(message) = self.panic.lock().unwrap_or_else(PoisonError::into_inner).take() {
            return Err(EnsembleError::ProgressPanicked { message });
        }
        if self.is_cancelled() { Err(EnsembleError::Cancelled { motions: self.motions() }) } else { Ok(()) }
    }

    /// Adds finished motions, and reports progress if the last report is old enough.
    pub(super) fn count(&self, motions: usize) {
        self.motions.fetch_add(motions as u64, Ordering::Relaxed);
        self.report();
    }

    /// Reports progress if the last report is old enough; true if the ensemble is cancelled.
    /// Motions ask during their runs.
    pub(super) fn asks(&self) -> bool {
        self.report();
        self.is_cancelled()
    }

    /// True if there is a callback, which may cancel.
    pub(super) fn has_reporter(&self) -> bool {
        self.reporter.is_some()
    }

    /// Reports progress if the last report is old enough. A thread does not wait for the report of
    /// another.
    fn report(&self) {
        let Some(BatchReporter(callback)) = self.reporter else { return };
        let Ok(mut callback) = callback.try_lock() else { return };
        let (call, last) = &mut *callback;
        if last.is_none_or(|last| last.elapsed() >= INTERVAL) {
            *last = Some(Instant::now());
            self.tell(call);
        }
    }

    /// Reports the final progress, when there is nothing left to cancel.
    ///
    /// # Errors
    /// If the callback panics.
    pub(super) fn finish(&self) -> Result<(), EnsembleError> {
        if let Some(BatchReporter(callback)) = self.reporter {
            let mut callback = callback.lock().unwrap_or_else(PoisonError::into_inner);
            self.tell(&mut callback.0);
        }
        self.check().or_else(|error| match error {
            EnsembleError::Cancelled { .. } => Ok(()),
            other => Err(other),
        })
    }

    fn tell(&self, call: &mut Callback<'_>) {
        // The state that a panic leaves behind is not used again: the ensemble ends.
        let goes_on = catch_unwind(AssertUnwindSafe(|| call(self.done()))).unwrap_or_else(|panic| {
            *self.panic.lock().unwrap_or_else(PoisonError::into_inner) = Some(panic_message(&*panic));
            false
        });
        if !goes_on {
            self.is_cancelled.store(true, Ordering::Relaxed);
        }
    }

    fn done(&self) -> Done {
        Done { motions: self.motions(), of: self.of }
    }
}
