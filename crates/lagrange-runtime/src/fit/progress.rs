//! Progress reports of a fit, and its cancellation.

use core::cell::Cell;
use std::boxed::Box;
use std::string::String;

use super::least_squares::{Comparison, half_square};
use crate::simulate::{Cancellation, Verdict};

/// The progress of a fit.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub struct FitProgress {
    /// Index of the point from which the search started, from zero.
    pub start: usize,
    /// Number of these points.
    pub starts: usize,
    /// Number of comparisons of a motion with the data so far.
    pub evaluations: usize,
    /// Half the lowest sum of squares so far; infinite before a motion reaches the end of the data.
    pub cost: f64,
}

/// A callback, which returns false to cancel.
pub(super) type FitCallback<'a> = Box<dyn FnMut(FitProgress) -> bool + 'a>;

/// The question whether a fit is cancelled.
pub(super) type Asks<'a> = &'a dyn Fn() -> bool;

/// Returns the callback of a closure.
pub(super) fn callback<'a, V: Verdict>(mut callback: impl FnMut(FitProgress) -> V + 'a) -> FitCallback<'a> {
    Box::new(move |progress| callback(progress).go_on())
}

/// The report of a fit that runs.
pub(super) struct FitReporter<'a> {
    callback: Option<FitCallback<'a>>,
    cancellation: Option<Cancellation<'a>>,
    progress: FitProgress,
    is_cancelled: Cell<bool>,
}

impl<'a> FitReporter<'a> {
    pub(super) fn new(
        callback: Option<FitCallback<'a>>,
        cancellation: Option<Cancellation<'a>>,
        starts: usize,
    ) -> Self {
        let progress = FitProgress { start: 0, starts, evaluations: 0, cost: f64::INFINITY };
        FitReporter { callback, cancellation, progress, is_cancelled: Cell::new(false) }
    }

    pub(super) fn begin(&mut self, start: usize) {
        self.progress.start = start;
    }

    /// True if the fit is cancelled. It remains so.
    pub(super) fn is_cancelled(&self) -> bool {
        let asked = || self.cancellation.as_ref().is_some_and(|is_cancelled| is_cancelled());
        self.is_cancelled.set(self.is_cancelled.get() || asked());
        self.is_cancelled.get()
    }

    /// Compares a motion with the data, and reports it. No motion is computed after a cancellation,
    /// so that searches end soon. The evaluation receives the question whether it is cancelled.
    ///
    /// # Errors
    /// If there is no comparison.
    pub(super) fn compare(
        &mut self,
        evaluate: impl FnOnce(Asks<'_>) -> Result<Comparison, String>,
    ) -> Result<Comparison, String> {
        if self.is_cancelled() {
            return Err(String::new());
        }
        let found = evaluate(&|| self.is_cancelled());
        if self.is_cancelled.get() {
            return found;
        }
        let cost = found.as_ref().map_or(f64::INFINITY, |found| half_square(&found.residuals));
        self.progress.evaluations += 1;
        self.progress.cost = self.progress.cost.min(cost);
        if let Some(callback) = &mut self.callback {
            self.is_cancelled.set(!callback(self.progress));
        }
        found
    }
}
