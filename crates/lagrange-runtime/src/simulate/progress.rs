//! Progress reports of a run.

use std::boxed::Box;
use std::ops::ControlFlow;

use crate::scalar::Scalar;

/// The progress of a run.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub struct Progress<S> {
    /// The time at which the run started.
    pub start: S,
    /// The time reached so far.
    pub time: S,
    /// The time at which the run will end.
    pub end: S,
    /// Steps taken so far.
    pub steps: u64,
}

impl<S: Scalar + Into<f64>> Progress<S> {
    /// Returns the completed fraction of the time, from 0 to 1.
    pub fn fraction(&self) -> f64 {
        if self.time == self.end {
            return 1.0;
        }
        ((self.time - self.start) / (self.end - self.start)).into()
    }
}

/// The return value of a progress callback: nothing, or true to continue.
pub trait Verdict {
    /// True to continue.
    fn go_on(self) -> bool;
}

impl Verdict for () {
    fn go_on(self) -> bool {
        true
    }
}

impl Verdict for ControlFlow<()> {
    fn go_on(self) -> bool {
        self.is_continue()
    }
}

/// A callback, called whenever another part of the time is done, and at growing intervals of steps
/// otherwise. A run that makes no progress can therefore be cancelled, too.
pub(super) struct Reporter<'a, S> {
    callback: Box<dyn FnMut(Progress<S>) -> bool + 'a>,
    /// Number of parts of the time that were reported.
    reported: u32,
    /// Number of steps at which to report in any case.
    patience: u64,
}

/// Number of parts into which a run is divided.
const PARTS: u32 = 200;
/// Number of steps after which an unfinished part is reported; doubled each time.
const PATIENCE: u64 = 1 << 12;

impl<'a, S: Scalar> Reporter<'a, S> {
    pub(super) fn new<V: Verdict>(mut callback: impl FnMut(Progress<S>) -> V + 'a) -> Self {
        let callback = Box::new(move |progress| callback(progress).go_on());
        Reporter { callback, reported: 0, patience: PATIENCE }
    }

    /// Reports progress if it is due; true to continue.
    pub(super) fn step(&mut self, progress: Progress<S>) -> bool {
        let done = self.parts_done(&progress);
        let is_long = progress.steps >= self.patience;
        if done == self.reported && !is_long {
            return true;
        }
        if is_long {
            self.patience = self.patience.saturating_mul(2);
        }
        self.reported = done;
        (self.callback)(progress)
    }

    /// Returns the number of finished parts of the time, at least as many as were reported.
    fn parts_done(&self, progress: &Progress<S>) -> u32 {
        if progress.time == progress.end {
            return PARTS;
        }
        let part = (progress.end - progress.start) / S::from_f64(f64::from(PARTS));
        let done = (progress.time - progress.start) / part;
        let is_done = |parts: u32| done >= S::from_f64(f64::from(parts));
        (self.reported..PARTS)
            .take_while(|parts| is_done(parts + 1))
            .last()
            .map_or(self.reported, |parts| parts + 1)
    }
}
