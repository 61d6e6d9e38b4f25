//! Cases by their numbers.

use std::env;
use std::ops::Range;

/// Reads the cases to run from an environment variable, either a count or a range such as `17..18`.
/// If it is not set, the default number is taken.
pub(crate) fn numbered(variable: &str, usual: usize) -> Range<usize> {
    let number =
        |text: &str| text.parse().unwrap_or_else(|_| panic!("{variable} is a number or a range, not {text}"));
    let wanted = env::var(variable).ok();
    match wanted.as_deref().map(|wanted| wanted.split_once("..").ok_or(wanted)) {
        None => 0..usual,
        Some(Err(count)) => 0..number(count),
        Some(Ok((from, to))) => number(from)..number(to),
    }
}
