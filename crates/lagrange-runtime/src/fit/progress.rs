//! Progress reports of a fit.

use std::boxed::Box;
use std::string::String;

use super::least_squares::{Comparison, half_square};
use crate::simulate::Verdict;

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

/// Returns the callback of a closure.
pub(super) fn callback<'a, V: Verdict>(mut callback: impl FnMut(FitProgress) -> V + 'a) -> FitCallback<'a> {
    Box::new(move |progress| callback(progress).go_on())
}

/// The report of a fit that runs.
pub(super) struct FitReporter<'a> {
    callback: Option<FitCallback<'a>>,
    progress: FitProgress,
    is_cancelled: bool,
}

impl<'a> FitReporter<'a> {
    pub(super) fn new(callback: Option<FitCallback<'a>>, starts: usize) -> Self {
        let progress = FitProgress { start: 0, starts, evaluations: 0, cost: f64::INFINITY };
        FitReporter { callback, progress, is_cancelled: false }
    }

    pub(super) fn begin(&mut self, start: usize) {
        self.progress.start = start;
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.is_cancelled
    }

    /// Compares a motion with the data, and reports it. No motion is computed after a cancellation,
    /// so that searches end soon.
    ///
    /// # Errors
    /// If there is no comparison.
    pub(super) fn compare(
        &mut self,
        evaluate: impl FnOnce() -> Result<Comparison, String>,
    ) -> Result<Comparison, String> {
        if self.is_cancelled {
            return Err(String::new());
        }
        let found = evaluate();
        let cost = found.as_ref().map_or(f64::INFINITY, |found| half_square(&found.residuals));
        self.progress.evaluations += 1;
        self.progress.cost = self.progress.cost.min(cost);
        if let Some(callback) = &mut self.callback {
            self.is_cancelled = !callback(self.progress);
        }
        found
    }
}
