//! The continuation of a motion after events at the same time.

use crate::integrate::Stepper;
use crate::system::{Action, OdeSystem, Response, StepFailure};

/// The combined outcome of simultaneous events. Stopping takes precedence.
pub(super) struct EventOutcome<M: OdeSystem> {
    action: Action<M::State>,
    /// The system that continues, if events switched it.
    pub(super) system: Option<M>,
}

/// The state from which a motion continues, and the system if it changed.
type Continuation<M> = Result<(<M as OdeSystem>::State, Option<M>), StepFailure<<M as OdeSystem>::Scalar>>;

impl<M: OdeSystem> EventOutcome<M> {
    /// Creates the outcome of no events: the motion continues.
    pub(super) fn new() -> Self {
        EventOutcome { action: Action::Continue, system: None }
    }

    /// Adds the response to another event at this state.
    pub(super) fn add(&mut self, answer: Response<M, M::Scalar, M::State>, state: M::State) {
        let later = match answer.action {
            Action::Continue if answer.system.is_some() => Action::Replace(state),
            action => action,
        };
        self.system = answer.system.or(self.system.take());
        self.action = match (later, self.action) {
            (Action::Continue, earlier) | (_, earlier @ Action::Stop) => earlier,
            (later, _) => later,
        };
    }

    /// True if nothing has changed.
    pub(super) fn goes_on(&self) -> bool {
        matches!(self.action, Action::Continue)
    }

    /// Returns the replaced state, if any.
    pub(super) fn state(&self) -> Option<M::State> {
        if let Action::Replace(state) = self.action { Some(state) } else { None }
    }

    /// Returns the state from which the motion continues, on the constraints, and the system if it
    /// differs from `system`. `None` if the state was not replaced. T is the type of the stepper
    /// that continues.
    ///
    /// # Errors
    /// If no motion can continue from that state.
    pub(super) fn resume<T: Stepper<M>>(self, system: &M, t: M::Scalar) -> Option<Continuation<M>> {
        self.state().map(|mut state| {
            let next = match self.system {
                Some(next) => Some(next),
                None if T::FINDS_MODES => system.on_sides(t, &state),
                None => system.begin(t, &state)?,
            };
            next.as_ref().unwrap_or(system).restore(t, &mut state)?;
            Ok((state, next))
        })
    }
}
