//! The steps of a run, with some of its states.

use std::vec::Vec;

use crate::integrate::{Method, Stepper};
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StepFailure};

/// Steps of a run: all of their times, and states at every so many of them.
///
/// As many states are kept as lie between two of them, or twice as many. To go backwards, the
/// states in between are computed again. Source: Griewank, Walther, *Evaluating Derivatives*, 2nd
/// ed., §12.2, there with more levels.
pub(super) struct Trace<S, Y> {
    /// Start of each step, and the end of the last one.
    pub(super) times: Vec<S>,
    /// Number of steps between states.
    pub(super) stride: usize,
    /// States at the starts of steps 0, stride, 2 stride, …
    pub(super) states: Vec<Y>,
    /// Numbers of steps before each sample.
    pub(super) samples: Vec<usize>,
}

impl<S: Scalar, Y: Copy> Trace<S, Y> {
    /// Follows a motion. Steps end at the times of samples.
    pub(super) fn of<M, K>(
        system: &M,
        method: &K,
        (t, y): (S, Y),
        samples: &[S],
        max_steps: Option<u64>,
    ) -> Result<Trace<S, Y>, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S, State = Y>,
        K: Method<M>,
    {
        let end = *samples.last().unwrap_or(&t);
        let mut stepper = method.start(system, t, &y, end)?;
        let limit = max_steps.unwrap_or(u64::MAX);
        stepper.limit_steps(limit);
        let mut trace = Trace { times: std::vec![t], stride: 1, states: std::vec![y], samples: Vec::new() };
        for &sample in samples {
            while stepper.time() != sample {
                if stepper.work().steps + stepper.work().rejections >= limit {
                    return Err(StepFailure::TooManySteps { limit });
                }
                stepper.step(system, sample)?;
                trace.push(stepper.time(), *stepper.state());
            }
            trace.samples.push(trace.steps());
        }
        Ok(trace)
    }

    /// Returns the number of steps.
    pub(super) fn steps(&self) -> usize {
        self.times.len() - 1
    }

    fn push(&mut self, t: S, y: Y) {
        self.times.push(t);
        if !self.steps().is_multiple_of(self.stride) {
            return;
        }
        self.states.push(y);
        if self.states.len() > 2 * self.stride {
            self.stride *= 2;
            let mut index = 0;
            self.states.retain(|_| {
                index += 1;
                index % 2 == 1
            });
        }
    }
}
