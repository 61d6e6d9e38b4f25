//! What all processes come down to.

use std::ops::Deref;

use lagrange::ensemble::{Pack, Reduce, Reduced};
use lagrange::system::MechanicalSystem;

/// What the motions of all processes came down to, and which are not in it because they failed. It is used as what it holds.
#[derive(Clone, PartialEq, Debug)]
pub struct Sum<R> {
    value: R,
    failed: u64,
    failures: Vec<u64>,
}

/// Of more failed motions it is only known how many there were.
const MOST_FAILURES: usize = 1000;

impl<R> Sum<R> {
    /// Of no motion.
    pub(crate) fn new(value: R) -> Self {
        Sum { value, failed: 0, failures: Vec::new() }
    }

    /// Of the motions of a part.
    pub(crate) fn of_part<M: MechanicalSystem>(part: Reduced<M, R>) -> Self {
        let failures = part.failures().iter().map(|failure| failure.index as u64).collect();
        Sum { failed: part.failed(), failures, value: part.into_value() }
    }

    /// What the motions that did not fail came down to.
    pub fn into_value(self) -> R {
        self.value
    }

    /// How many motions failed.
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
