//! Progress reports of a run, and its cancellation.

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
    /// True if the run is to continue.
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

/// A function that returns true to cancel.
pub(crate) type Cancellation<'a> = Box<dyn Fn() -> bool + 'a>;

/// The callbacks of a run.
pub(super) struct Callbacks<'a, S> {
    reporter: Option<Reporter<'a, S>>,
    is_cancelled: Option<Cancellation<'a>>,
    /// Number of turns until the next question.
    turns: u32,
}

/// Number of turns of a run between two questions whether it is cancelled, which take less time
/// than a step.
const TURNS: u32 = 32;

impl<'a, S: Scalar> Callbacks<'a, S> {
    pub(super) fn none() -> Self {
        Callbacks { reporter: None, is_cancelled: None, turns: TURNS }
    }

    /// Reports progress to this callback.
    pub(super) fn report_to<V: Verdict>(&mut self, callback: impl FnMut(Progress<S>) -> V + 'a) {
        self.reporter = Some(Reporter::new(callback));
    }

    /// Cancels the run soon after this function returns true.
    pub(super) fn cancel_when(&mut self, is_cancelled: impl Fn() -> bool + 'a) {
        self.is_cancelled = Some(Box::new(is_cancelled));
    }

    /// True if there are any.
    pub(super) fn are_set(&self) -> bool {
        self.reporter.is_some() || self.is_cancelled.is_some()
    }

    /// Reports progress and asks for cancellation if they are due; true to continue.
    pub(super) fn turn(&mut self, progress: Progress<S>) -> bool {
        self.reporter.as_mut().is_none_or(|reporter| reporter.step(progress)) && self.goes_on()
    }

    fn goes_on(&mut self) -> bool {
        let Some(is_cancelled) = &self.is_cancelled else { return true };
        self.turns -= 1;
        if self.turns > 0 {
            return true;
        }
        self.turns = TURNS;
        !is_cancelled()
    }
}

/// A callback, called whenever another part of the time is done, and at growing intervals of steps
/// otherwise. A run that makes no progress can therefore be cancelled, too.
struct Reporter<'a, S> {
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
    fn new<V: Verdict>(mut callback: impl FnMut(Progress<S>) -> V + 'a) -> Self {
        let callback = Box::new(move |progress| callback(progress).go_on());
        Reporter { callback, reported: 0, patience: PATIENCE }
    }

    /// Reports progress if it is due; true to continue.
    fn step(&mut self, progress: Progress<S>) -> bool {
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
