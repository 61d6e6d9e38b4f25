//! The continuation of a motion after events at the same time.

use crate::integrate::Stepper;
use crate::system::{Action, OdeSystem, Response, StepFailure};

/// The combined outcome of simultaneous events. Stopping prevails.
pub(super) struct EventOutcome<M: OdeSystem> {
    action: Action<M::State>,
    /// The system that goes on, if events switched it.
    pub(super) system: Option<M>,
}

/// The state that a motion goes on from, and the system if it is another one.
type Continuation<M> = Result<(<M as OdeSystem>::State, Option<M>), StepFailure<<M as OdeSystem>::Scalar>>;

impl<M: OdeSystem> EventOutcome<M> {
    /// To go on.
    pub(super) fn new() -> Self {
        EventOutcome { action: Action::Continue, system: None }
    }

    /// Another event happened at this state.
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

    /// The state that was left, if it is another one.
    pub(super) fn state(&self) -> Option<M::State> {
        if let Action::Replace(state) = self.action { Some(state) } else { None }
    }

    /// The state to go on from, put onto the constraints, and the system if it is another one than
    /// `system`; `None` if the motion ends. Steppers of the kind T take it on.
    ///
    /// # Errors
    /// If no motion goes on from there.
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
