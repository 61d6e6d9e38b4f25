//! Processor time of one thread, independent of other load.

use std::fs;
use std::time::{Duration, Instant};

/// Returns the processor time of this thread, or the elapsed time where the platform does not
/// measure it.
pub(crate) fn of_this_thread() -> Duration {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = text.and_then(|text| text.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| beginning().elapsed(), Duration::from_nanos)
}

fn beginning() -> Instant {
    static BEGINNING: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    *BEGINNING.get_or_init(Instant::now)
}
