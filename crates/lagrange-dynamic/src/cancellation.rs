//! Computations that may be cancelled.

use std::ops::ControlFlow;

/// A function that returns true to cancel a computation. It is called often, also on other threads.
pub type IsCancelled<'a> = &'a (dyn Fn() -> bool + Sync);

/// Returns the verdict of a progress callback.
pub fn verdict(is_cancelled: IsCancelled<'_>) -> ControlFlow<()> {
    if is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}
