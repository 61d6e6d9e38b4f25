//! The completed part of a computation, on the terminal.

use std::io::{IsTerminal, stderr};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::console::report;

/// Time before the first line: most computations are shorter.
const PATIENCE: Duration = Duration::from_millis(700);
/// Time between two lines.
const INTERVAL: Duration = Duration::from_millis(100);

/// A line with the completed part on the standard error, if that is a terminal. It vanishes with
/// the meter.
pub(crate) struct Meter {
    /// The time of the next line; `None` without a terminal.
    next: Option<Mutex<Instant>>,
}

impl Meter {
    pub(crate) fn new() -> Meter {
        Meter { next: stderr().is_terminal().then(|| Mutex::new(Instant::now() + PATIENCE)) }
    }

    /// Shows a part, from 0 to 1, if the last line is old enough.
    pub(crate) fn show(&self, part: f64) {
        let Some(next) = &self.next else { return };
        let (now, mut next) = (Instant::now(), next.lock().unwrap_or_else(PoisonError::into_inner));
        if now >= *next {
            *next = now + INTERVAL;
            report(&format!("\r{:5.1} %", 100.0 * part));
        }
    }
}

impl Drop for Meter {
    fn drop(&mut self) {
        if self.next.is_some() {
            report("\r\x1b[K");
        }
    }
}
