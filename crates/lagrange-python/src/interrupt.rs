//! Computations that Ctrl-C interrupts.

use std::convert::Infallible;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use lagrange_dynamic::Watch;
use pyo3::{PyErr, PyResult, Python};

/// Time between two checks for signals.
const INTERVAL: Duration = Duration::from_millis(50);

/// Returns the exception that a signal raises now.
fn exception_of_signals() -> Option<PyErr> {
    Python::attach(|py| py.check_signals().err())
}

/// The time of the last check, and the exception that a signal raised.
struct Signals(Mutex<(Instant, Option<PyErr>)>);

impl Signals {
    /// True if a signal raised an exception. Python handles signals on its main thread only.
    fn are_raised(&self) -> bool {
        let (last, raised) = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if raised.is_none() && last.elapsed() >= INTERVAL {
            *last = Instant::now();
            *raised = exception_of_signals();
        }
        raised.is_some()
    }
}

/// Computes on this thread, while other Python threads run. Returns the result and the exception of
/// a signal, such as `KeyboardInterrupt`, that cancelled the computation.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    compute: impl FnOnce(Watch<'_>) -> T + Send,
) -> (T, Option<PyErr>) {
    let signals = Signals(Mutex::new((Instant::now(), None)));
    let result = py.detach(|| compute(&|_| signals.are_raised()));
    (result, signals.0.into_inner().unwrap_or_else(PoisonError::into_inner).1)
}

/// Computes on another thread, for computations that check for cancellation on threads of their
/// own.
///
/// # Errors
/// The exception of a signal.
pub(crate) fn interruptible_on_threads<T: Send>(
    py: Python<'_>,
    compute: impl FnOnce(Watch<'_>) -> T + Send,
) -> PyResult<T> {
    let (is_cancelled, mut raised) = (&AtomicBool::new(false), None);
    let result = py.detach(|| {
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel::<Infallible>();
            let worker = scope.spawn(move || {
                // It is dropped at the end, which the other thread notices at once.
                let _sender = sender;
                compute(&|_| is_cancelled.load(Ordering::Relaxed))
            });
            while let Err(RecvTimeoutError::Timeout) = receiver.recv_timeout(INTERVAL) {
                raised = raised.take().or_else(exception_of_signals);
                is_cancelled.store(raised.is_some(), Ordering::Relaxed);
            }
            worker.join().unwrap_or_else(|panic| resume_unwind(panic))
        })
    });
    raised.map_or(Ok(result), Err)
}
