//! Reductions over all processes.

use std::ops::Deref;

use lagrange::ensemble::{Pack, Reduce, Reduced};
use lagrange::system::MechanicalSystem;

/// The reduction over the motions of all processes, and the motions that it omits because they
/// failed. It dereferences to its value.
#[derive(Clone, PartialEq, Debug)]
pub struct Sum<R> {
    value: R,
    failed: u64,
    failures: Vec<u64>,
}

/// Maximum number of failures in the list; of further ones only the count is known.
const MOST_FAILURES: usize = 1000;

impl<R> Sum<R> {
    /// Returns the reduction of no motions.
    pub(crate) fn new(value: R) -> Self {
        Sum { value, failed: 0, failures: Vec::new() }
    }

    /// Returns the reduction of the motions of a part.
    pub(crate) fn of_part<M: MechanicalSystem>(part: Reduced<M, R>) -> Self {
        let failures = part.failures().iter().map(|failure| failure.index as u64).collect();
        Sum { failed: part.failed(), failures, value: part.into_value() }
    }

    /// Returns the value reduced from the motions that succeeded.
    pub fn into_value(self) -> R {
        self.value
    }

    /// Returns the number of failed motions.
    pub fn failed(&self) -> u64 {
        self.failed
    }

    /// The indices of the first thousand of the motions that failed. [`motion`](lagrange::ensemble::Ensemble::motion) runs one again and
    /// says why.
    pub fn failures(&self) -> &[u64] {
        &self.failures
    }
}

impl<R> Deref for Sum<R> {
    type Target = R;

    fn deref(&self) -> &R {
        &self.value
    }
}

impl<R: Reduce> Sum<R> {
    /// Adds what the motions that follow came down to.
    pub(crate) fn merge(&mut self, later: Self) {
        self.value.merge(later.value);
        self.failed += later.failed;
        self.failures.extend(later.failures);
        self.failures.truncate(MOST_FAILURES);
    }
}

impl<R: Pack> Pack for Sum<R> {
    fn pack(&self, words: &mut Vec<u64>) {
        self.value.pack(words);
        self.failed.pack(words);
        self.failures.pack(words);
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        let (value, failed, failures) = Pack::unpack(words)?;
        Some(Sum { value, failed, failures })
    }
}
