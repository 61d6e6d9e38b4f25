//! Computations that are watched, and may be cancelled.

/// A function that receives the completed part of a computation and returns true to cancel it. The
/// part is from 0 to 1, and 0 where it is not known. The function is called often, also on other
/// threads.
pub type Watch<'a> = &'a (dyn Fn(f64) -> bool + Sync);
