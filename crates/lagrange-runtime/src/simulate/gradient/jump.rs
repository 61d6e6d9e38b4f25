//! Jumps of the state, as adjoints pass them.

use std::sync::Arc;
use std::vec::Vec;

use crate::simulate::sensitivity::{Sensitive, Stacked, Varied, copy};
use crate::system::{Action, OdeSystem, ParametricSystem, ScalarOf, StepFailure};

/// A jump of a motion of the system M.
pub(super) struct Jump<M: OdeSystem> {
    /// The system before it.
    pub(super) system: M,
    pub(super) cause: Cause,
    pub(super) time: M::Scalar,
    /// Time since the start of the run.
    pub(super) elapsed: M::Scalar,
    /// The state before it.
    pub(super) state: M::State,
}

/// The cause of a jump.
pub(super) enum Cause {
    /// Declared events at the same time, by their indices.
    Events(Vec<usize>),
    /// Clocks.
    Tick,
}

impl<M, const N: usize> Jump<M>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
{
    /// Returns the derivative of the state after the jump with respect to a variable. That of the
    /// state before it is `change`; both are per scale of the variable.
    ///
    /// # Errors
    /// If there is none, as at an event function of zero rate.
    pub(super) fn derivative(
        &self,
        variable: Varied<M::Scalar>,
        change: M::State,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let mut system = Sensitive::<M, M, N, 2>::new(copy(&self.system), Arc::new([variable]));
        let mut state = Stacked::with_change(self.state, change);
        match &self.cause {
            Cause::Tick => state = system.tick(self.time, &state).unwrap_or(state),
            Cause::Events(events) => {
                for &event in events {
                    let response = system.react(event, self.time, self.elapsed, &state)?;
                    if let Action::Replace(after) = response.action {
                        state = after;
                    }
                    system = response.system.unwrap_or(system);
                }
            }
        }
        Ok(state.derivatives()[0])
    }
}
