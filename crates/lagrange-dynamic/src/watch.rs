//! Computations that are watched, and may be cancelled.

/// A function that receives the completed part of a computation, from 0 to 1 as far as it is known,
/// and returns true to cancel it. It is called often, also on other threads.
pub type Watch<'a> = &'a (dyn Fn(f64) -> bool + Sync);
