//! What is said about systems that are hard to compile.

pub(super) fn expensive(size: usize, checking: f64, optimising: f64, bytes: f64) -> String {
    format!(
        "the methods of this system take {size} operations: checking them takes the compiler roughly {checking:.0} s \
         and {:.1} GB, optimising them up to {optimising:.0} s more",
        bytes / 1e9
    )
}

pub(super) fn expensive_help() -> String {
    format!("{}; `#[allow(deprecated)]` on the struct silences this warning", smaller())
}

pub(super) fn hopeless(limit: usize) -> String {
    format!(
        "this system takes more than {limit} operations, which no compiler gets through in reasonable time"
    )
}

pub(super) fn smaller() -> &'static str {
    "leave out methods with `emit { no … }`, or compute forces between many bodies in a loop and hand them in as \
     inputs"
}
