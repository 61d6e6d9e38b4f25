//! Limits on time and memory: work that exceeds them is abandoned, and the next case begins.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, mpsc};
use std::time::{Duration, Instant};
use std::{fs, thread};

/// Processor seconds allowed for one case; unoptimised code is up to fifteen times slower.
const MAX_SECONDS: f64 = if cfg!(debug_assertions) { 30.0 } else { 2.0 };
/// Bytes allowed in use at a time.
const MAX_BYTES: usize = 500_000_000;
/// Number of failures after which the search stops.
const MAX_FAILURES: usize = 20;
/// Number of workers that judge cases at a time.
const WORKERS: usize = 2;
/// The stack of the compiler's threads.
const STACK: usize = 8 << 20;

/// The response of the compiler to a text.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Answer {
    /// Errors.
    Refused,
    /// Code with warnings.
    Accepted,
    /// Code without warnings.
    Clean,
}

/// A text with its judge, which returns an answer or an error about the output.
pub(crate) struct Case {
    pub(crate) text: String,
    pub(crate) judge: fn(&str) -> Result<Answer, String>,
}

/// The outcome of a case.
#[derive(Clone, Default)]
pub(crate) struct Verdict {
    pub(crate) case: usize,
    /// Kept for failures only: all texts together would take more memory than all cases.
    pub(crate) text: String,
    pub(crate) seconds: f64,
    pub(crate) bytes: usize,
    pub(crate) answer: Option<Answer>,
    pub(crate) failure: Option<String>,
}

thread_local! {
    static IN_USE: Cell<usize> = const { Cell::new(0) };
    static MOST_IN_USE: Cell<usize> = const { Cell::new(0) };
    /// The flag by which a worker signals that it waits, because it asked for more than the limit.
    /// Other threads have no limit.
    static EXCEEDED: Cell<Option<&'static AtomicBool>> = const { Cell::new(None) };
}

/// The allocator of the platform, except that it never answers a thread that exceeds the limit.
struct Limited;

#[global_allocator]
static ALLOCATOR: Limited = Limited;

fn count(size: usize) {
    let total = IN_USE.get().saturating_add(size);
    IN_USE.set(total);
    MOST_IN_USE.set(MOST_IN_USE.get().max(total));
    let Some(exceeded) = EXCEEDED.get().filter(|_| total > MAX_BYTES) else { return };
    exceeded.store(true, Ordering::SeqCst);
    loop {
        thread::sleep(Duration::from_secs(3600));
    }
}

// SAFETY: requests reach the allocator of the platform unchanged, or never return.
unsafe impl GlobalAlloc for Limited {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: the caller keeps the promises of `GlobalAlloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        IN_USE.set(IN_USE.get().saturating_sub(layout.size()));
        // SAFETY: the caller keeps the promises of `GlobalAlloc`.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size.saturating_sub(layout.size()));
        IN_USE.set(IN_USE.get().saturating_sub(layout.size().saturating_sub(size)));
        // SAFETY: the caller keeps the promises of `GlobalAlloc`.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

/// The case in progress of a worker.
struct Current {
    case: usize,
    text: String,
    /// Processor time of the thread when the case began.
    start: Duration,
}

/// Judges the cases that `make` builds. Verdicts are in the order of the cases.
pub(crate) fn run(cases: Range<usize>, make: impl Fn(usize) -> Case + Send + Sync + 'static) -> Vec<Verdict> {
    let make: Arc<dyn Fn(usize) -> Case + Send + Sync> = Arc::new(make);
    let bound = |share: usize| cases.start + share * cases.len() / WORKERS;
    thread::scope(|scope| {
        let judged = |share| {
            let (make, share) = (&make, bound(share)..bound(share + 1));
            scope.spawn(move || one_by_one(share, make))
        };
        let shares = (0..WORKERS).map(judged).collect::<Vec<_>>();
        shares.into_iter().flat_map(|share| share.join().expect("watching does not panic")).collect()
    })
}

/// Judges cases one after the other.
fn one_by_one(cases: Range<usize>, make: &Arc<dyn Fn(usize) -> Case + Send + Sync>) -> Vec<Verdict> {
    let (mut next, mut verdicts, mut failures) = (cases.start, Vec::new(), 0);
    while next < cases.end && failures < MAX_FAILURES {
        let found = watch(next..cases.end, make);
        next += found.len();
        failures += found.iter().filter(|verdict| verdict.failure.is_some()).count();
        verdicts.extend(found);
    }
    verdicts
}

/// Runs a worker until it is done or exceeds a limit.
fn watch(cases: Range<usize>, make: &Arc<dyn Fn(usize) -> Case + Send + Sync>) -> Vec<Verdict> {
    let current = Arc::new(Mutex::new(None::<Current>));
    let (sender, receiver) = mpsc::channel();
    let (clocks, clock) = mpsc::channel();
    let worker = (Arc::clone(make), Arc::clone(&current));
    // The allocator reads the flag as long as the thread lives, even after it is abandoned.
    let has_exceeded: &AtomicBool = Box::leak(Box::default());
    let work = move || {
        EXCEEDED.set(Some(has_exceeded));
        let clock = Clock::of_this_thread();
        clocks.send(clock.clone()).expect("somebody watches");
        for case in cases {
            let verdict = judged(case, &worker.0, &worker.1, &clock);
            if sender.send(verdict).is_err() {
                return;
            }
        }
    };
    thread::Builder::new().stack_size(STACK).spawn(work).expect("a thread");
    let clock: Clock = clock.recv().expect("a worker says hello");
    let mut verdicts = Vec::new();
    loop {
        match receiver.recv_timeout(Duration::from_millis(100)) {
            Ok(verdict) => {
                told(&verdict);
                verdicts.push(verdict);
            }
            Err(mpsc::RecvTimeoutError::Disconnected) => return verdicts,
            Err(mpsc::RecvTimeoutError::Timeout) => {
                let Some(failure) = exceeded(has_exceeded, &current, &clock) else { continue };
                verdicts.extend(receiver.try_iter());
                let stuck = current.lock().expect("no panic").take();
                verdicts.extend(stuck.map(|Current { case, text, .. }| Verdict {
                    case,
                    text,
                    failure: Some(failure),
                    ..Verdict::default()
                }));
                return verdicts;
            }
        }
    }
}

/// Prints the progress of a long run, and failures as they occur.
fn told(verdict: &Verdict) {
    if verdict.case % 50_000 == 49_999 {
        println!("{} cases", verdict.case + 1);
    }
    if let Some(failure) = &verdict.failure {
        println!("case {}: {failure}\n{}", verdict.case, verdict.text);
    }
}

/// Returns the limit that the worker exceeds, if any.
fn exceeded(has_exceeded: &AtomicBool, current: &Mutex<Option<Current>>, clock: &Clock) -> Option<String> {
    if has_exceeded.load(Ordering::SeqCst) {
        return Some(format!("more than {} MB", MAX_BYTES / 1_000_000));
    }
    let current = current.lock().expect("no panic");
    let seconds = current.as_ref().map(|current| (clock.now() - current.start).as_secs_f64());
    // A case that ends on its own is reported with its duration.
    (seconds? > 10.0 * MAX_SECONDS).then(|| format!("more than {} s", 10.0 * MAX_SECONDS))
}

fn judged(
    case: usize,
    make: &Arc<dyn Fn(usize) -> Case + Send + Sync>,
    current: &Mutex<Option<Current>>,
    clock: &Clock,
) -> Verdict {
    let Case { text, judge } = make(case);
    let start = clock.now();
    *current.lock().expect("no panic") = Some(Current { case, text: text.clone(), start });
    let before = IN_USE.get();
    MOST_IN_USE.set(before);
    let result = catch_unwind(AssertUnwindSafe(|| judge(&text)));
    let bytes = MOST_IN_USE.get() - before;
    // All texts remain in memory until they are invalidated.
    proc_macro2::extra::invalidate_current_thread_spans();
    let seconds = (clock.now() - start).as_secs_f64();
    *current.lock().expect("no panic") = None;
    let result = result.unwrap_or_else(|panic| Err(format!("panic: {}", message(&*panic))));
    let is_slow = seconds > MAX_SECONDS;
    let slow = is_slow.then(|| format!("{seconds:.1} s"));
    let (answer, failure) = match result {
        Ok(answer) => (Some(answer), slow),
        Err(failure) => (None, Some(failure)),
    };
    let text = if failure.is_some() { text } else { String::new() };
    Verdict { case, text, seconds, bytes, answer, failure }
}

fn message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

/// The processor time of a thread, or the time of day where the platform does not measure it.
#[derive(Clone)]
struct Clock {
    statistics: Option<PathBuf>,
    start: Instant,
}

impl Clock {
    fn of_this_thread() -> Clock {
        let thread = fs::read_link("/proc/thread-self").ok();
        let statistics = thread.map(|thread| PathBuf::from("/proc").join(thread).join("schedstat"));
        Clock { statistics, start: Instant::now() }
    }

    fn now(&self) -> Duration {
        let text = self.statistics.as_ref().and_then(|path| fs::read_to_string(path).ok());
        let nanoseconds = text.and_then(|text| text.split(' ').next()?.parse().ok());
        nanoseconds.map_or_else(|| self.start.elapsed(), Duration::from_nanos)
    }
}
