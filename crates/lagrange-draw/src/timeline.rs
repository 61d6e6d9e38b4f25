//! Display times of a film's pictures, and the quantities plotted below them.

use crate::error::{DrawError, refusal};

/// Times, and values at these times.
#[derive(Clone, PartialEq, Debug)]
pub struct Timeline {
    /// Times in seconds, rising or falling.
    pub(crate) times: Vec<f64>,
    pub(crate) curves: Vec<Curve>,
}

/// A quantity plotted below the picture of a page.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Curve {
    pub(crate) name: String,
    /// One value for each picture; non-finite values leave gaps.
    pub(crate) values: Vec<f64>,
}

impl Timeline {
    /// Creates a timeline of strictly monotonic times.
    pub(crate) fn new(times: Vec<f64>) -> Result<Timeline, DrawError> {
        let is_finite = times.iter().all(|time| time.is_finite());
        let rises = times.windows(2).all(|pair| pair[0] < pair[1]);
        let falls = times.windows(2).all(|pair| pair[0] > pair[1]);
        if is_finite && (rises || falls) {
            return Ok(Timeline { times, curves: Vec::new() });
        }
        Err(refusal("times must be finite, and rise or fall from picture to picture"))
    }

    /// Returns the duration in seconds.
    pub(crate) fn duration(&self) -> f64 {
        self.elapsed().last().copied().unwrap_or(0.0)
    }

    /// Returns the time in seconds from the start to each of the times.
    pub(crate) fn elapsed(&self) -> Vec<f64> {
        let start = self.times.first().copied().unwrap_or(0.0);
        self.times.iter().map(|time| (time - start).abs()).collect()
    }
}
