//! Final states of motions.

use std::fmt;
use std::ops::Deref;

use lagrange_runtime::Number;
use lagrange_runtime::system::{Columns, KernelSystem, StateVector, StepFailure};

use crate::backend::{Status, Work};
use crate::number::{DeviceNumber, Precision};

/// The final states of the motions: one row each, in columns.
///
/// For an emitted system the columns are also methods, such as `ends.theta()`. The row of a failed
/// motion holds NaN; [`failures`](Ends::failures) describes it.
pub struct Ends<M: KernelSystem> {
    columns: M::Columns<States<M::Scalar>>,
    failures: Vec<Failure<M>>,
}

/// States in columns.
#[derive(Clone, Debug)]
pub struct States<S> {
    columns: Vec<Vec<S>>,
}

impl<S> Columns for States<S> {
    type Scalar = S;

    fn column(&self, index: usize) -> &[S] {
        &self.columns[index]
    }
}

/// A failed motion, with the time that it reached and the cause.
#[non_exhaustive]
pub struct Failure<M: KernelSystem> {
    /// Index of the motion.
    pub index: usize,
    /// The time of the last good state.
    pub time: M::Scalar,
    /// The last good state; finite, unless the start was not.
    pub state: M::State,
    /// The cause: `NotFinite`, `TooManySteps` or `StepUnderflow`.
    pub cause: StepFailure<M::Scalar>,
}

impl<M: KernelSystem<Scalar: DeviceNumber>> Ends<M> {
    pub(crate) fn new<T: Precision>(work: &Work<T>) -> Self {
        let convert = |value: &T| <M::Scalar as Number>::from_f64(value.to_f64());
        let count = work.statuses.len();
        let mut columns =
            work.states.chunks(count).map(|column| column.iter().map(convert).collect::<Vec<_>>());
        let mut columns = columns.by_ref().collect::<Vec<_>>();
        let mut failures = Vec::new();
        for (index, status) in work.statuses.iter().enumerate() {
            let cause = match Status::of(*status) {
                Status::Running | Status::Done => continue,
                Status::NotFinite => StepFailure::NotFinite,
                Status::TooManySteps => StepFailure::TooManySteps { limit: work.most.into() },
                Status::StepUnderflow => StepFailure::StepUnderflow { step: convert(&work.controls[index]) },
            };
            let mut state = M::State::ZERO;
            for (entry, column) in state.as_mut().iter_mut().zip(&mut columns) {
                *entry = std::mem::replace(&mut column[index], <M::Scalar as Number>::NAN);
            }
            failures.push(Failure { index, time: convert(&work.times[index]), state, cause });
        }
        Ends { columns: States { columns }.into(), failures }
    }
}

impl<M: KernelSystem> Ends<M> {
    /// Returns the number of rows, including those of failed motions; at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is at least one motion")]
    pub fn len(&self) -> usize {
        self.columns.as_ref().columns[0].len()
    }

    /// Returns the final state of the motion with this index, or `None` if it failed or does not
    /// exist.
    pub fn state(&self, index: usize) -> Option<M::State> {
        if index >= self.len() || self.failures.binary_search_by_key(&index, |failure| failure.index).is_ok()
        {
            return None;
        }
        let mut state = M::State::ZERO;
        for (entry, column) in state.as_mut().iter_mut().zip(&self.columns.as_ref().columns) {
            *entry = column[index];
        }
        Some(state)
    }

    /// Returns the failed motions, in their order.
    pub fn failures(&self) -> &[Failure<M>] {
        &self.failures
    }
}

impl<M: KernelSystem> Deref for Ends<M> {
    type Target = M::Columns<States<M::Scalar>>;

    fn deref(&self) -> &Self::Target {
        &self.columns
    }
}

/// Leaves out the rows, which may be millions.
impl<M: KernelSystem> fmt::Debug for Ends<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Ends").field("len", &self.len()).field("failures", &self.failures.len()).finish()
    }
}

impl<M: KernelSystem> fmt::Debug for Failure<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Failure")
            .field("index", &self.index)
            .field("time", &self.time)
            .field("state", &self.state)
            .field("cause", &self.cause)
            .finish()
    }
}

impl<M: KernelSystem> fmt::Display for Failure<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "motion {}: {} at t = {:?}", self.index, self.cause, self.time)
    }
}
