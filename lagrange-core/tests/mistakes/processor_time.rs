//! How long a thread was at work, whoever else was.

use std::fs;
use std::time::{Duration, Instant};

/// The processor time of this thread; where the system does not tell, the time of day, from some
/// beginning.
pub(crate) fn of_this_thread() -> Duration {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = text.and_then(|text| text.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| beginning().elapsed(), Duration::from_nanos)
}

fn beginning() -> Instant {
    static BEGINNING: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    *BEGINNING.get_or_init(Instant::now)
}
