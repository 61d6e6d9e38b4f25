//! Systems as runs integrate them: a plant alone, under a law of inputs, or with derivatives.

use std::string::String;
use std::vec::Vec;

use crate::integrate::Stepper;
use crate::system::{MechanicalSystem, OdeSystem, SettingError, StepFailure};

/// A system M, the plant, in a closed loop, perhaps with more unknowns.
pub trait ClosedLoop<M: MechanicalSystem>: OdeSystem<Scalar = M::Scalar> + Sized {
    /// True if it is the plant itself.
    const IS_PLANT: bool = false;
    /// True if it keeps the past of its motions.
    const HAS_HISTORY: bool = false;

    /// Returns the plant in its present modes, with its own inputs.
    fn plant(&self) -> &M;

    /// Returns the loop around another plant.
    fn with_plant(&self, plant: M) -> Self;

    /// Returns the plant.
    fn into_plant(self) -> M;

    /// Returns a copy for a motion in a lane, if the loop has data beyond the plant.
    fn detached(&self) -> Option<Self> {
        None
    }

    /// Asks the plant with the inputs that it has at this time and state of the plant.
    fn ask<R>(&self, t: M::Scalar, y: &M::State, question: impl FnOnce(&M) -> R) -> R;

    /// Returns the state of the loop with this initial state of the plant.
    fn extended(&self, t: M::Scalar, y: &M::State) -> Self::State;

    /// Returns the state of the plant.
    fn state_of_plant(y: &Self::State) -> M::State;

    /// Checks what the loop requires of a run over this span.
    ///
    /// # Errors
    /// If it cannot run.
    fn check(&self, _span: [M::Scalar; 2], _has_controllers: bool) -> Result<(), SettingError<M::Scalar>> {
        Ok(())
    }

    /// Checks what the loop requires of the parameters of a motion over this span. Its steps
    /// `are_bounded` if a limit or an event may end it before.
    ///
    /// # Errors
    /// If it cannot run with them.
    fn check_parameters(
        &self,
        _span: [M::Scalar; 2],
        _are_bounded: bool,
    ) -> Result<(), StepFailure<M::Scalar>> {
        Ok(())
    }

    /// Returns the names of columns behind all others.
    fn further_columns(&self) -> Vec<String> {
        Vec::new()
    }

    /// Returns the number of variables by which the state of the plant is differentiated there.
    fn variables(&self) -> usize {
        0
    }

    /// Adds the values of these columns to a row.
    fn extend_row(&self, _y: &Self::State, _row: &mut Vec<M::Scalar>) {}

    /// Starts to keep the past of a motion from this time and state, by a method of this order. Its
    /// rates jump at the times `restarts`.
    fn start_history(&self, _start: (M::Scalar, &Self::State), _order: u32, _restarts: &[M::Scalar]) {}

    /// Returns the time to which the next step may go, if the past limits it.
    #[inline]
    fn limit(&self) -> Option<M::Scalar> {
        None
    }

    /// Keeps the last step up to this time.
    #[inline]
    fn keep(&self, _stepper: &mut impl Stepper<Self>, _to: M::Scalar) {}

    /// Notes that the state, the modes or the inputs jump at this time.
    #[inline]
    fn jump(&self, _at: M::Scalar) {}

    /// Returns the state after an event of a run, from which the plant goes on at `after`. The
    /// default is a new start from there.
    ///
    /// # Errors
    /// If the rest of the state does not follow from that of the plant.
    fn after_event(
        &self,
        at: (M::Scalar, &Self::State),
        after: M::State,
        _event: &mut dyn GivenEvent<M>,
    ) -> Result<Self::State, StepFailure<M::Scalar>> {
        Ok(self.extended(at.0, &after))
    }
}

/// An event that a run was given, as a function of time and state.
pub trait GivenEvent<M: MechanicalSystem> {
    /// Computes the function that is zero at the event.
    fn value(&mut self, plant: &M, t: M::Scalar, y: &M::State) -> M::Scalar;

    /// Returns the state after the event; `None` if it would not replace it.
    fn outcome(&mut self, plant: &M, t: M::Scalar, y: &M::State) -> Option<M::State>;

    /// Returns its place among the events of the run.
    fn index(&self) -> usize;
}

impl<M: MechanicalSystem> ClosedLoop<M> for M {
    const IS_PLANT: bool = true;

    #[inline]
    fn plant(&self) -> &M {
        self
    }

    #[inline]
    fn with_plant(&self, plant: M) -> M {
        plant
    }

    #[inline]
    fn into_plant(self) -> M {
        self
    }

    #[inline]
    fn ask<R>(&self, _t: M::Scalar, _y: &M::State, question: impl FnOnce(&M) -> R) -> R {
        question(self)
    }

    #[inline]
    fn extended(&self, _t: M::Scalar, y: &M::State) -> M::State {
        *y
    }

    #[inline]
    fn state_of_plant(y: &M::State) -> M::State {
        *y
    }
}
