//! The present system of a run.

use crate::integrate::Stepper;
use crate::scalar::{Number, Scalar};
use crate::system::{MAX_LOCATED, OdeSystem, SettingError, StepFailure, check_delays, have_modes};

/// The original system, or its present form after contacts, friction, switches or inputs changed
/// it.
pub struct Current<'a, M> {
    given: &'a M,
    switched: Option<M>,
}

impl<'a, M: OdeSystem> Current<'a, M> {
    /// Wraps the original system.
    pub fn new(given: &'a M) -> Self {
        Current { given, switched: None }
    }

    /// Applies `act` to the system and sets its modes for a motion from this time and state towards
    /// `end`, by steppers of type T.
    ///
    /// # Errors
    /// If no motion can start there; the system is then unchanged.
    pub fn begin<T: Stepper<M>>(
        &mut self,
        (t, y): (M::Scalar, &M::State),
        end: M::Scalar,
        act: impl FnOnce(&M) -> Result<Option<M>, StepFailure<M::Scalar>>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        check_delays(self.system())?;
        check_direction(self.system(), [t, end])?;
        check_clocks(self.system(), t, end)?;
        let acted = act(self.system())?;
        let system = acted.as_ref().unwrap_or(self.system());
        let begun = if T::FINDS_MODES { system.on_sides(t, y) } else { system.begin(t, y)? };
        check_ranges::<M, T>(system, y)?;
        self.switch(begun.or(acted));
        Ok(())
    }

    /// Returns the system.
    #[inline]
    pub fn system(&self) -> &M {
        self.switched.as_ref().unwrap_or(self.given)
    }

    /// Returns the system if it differs from the original one.
    pub fn switched(&self) -> Option<&M> {
        self.switched.as_ref()
    }

    /// Returns the switched system for storage.
    pub fn into_switched(self) -> Option<M> {
        self.switched
    }

    /// Replaces the system, if there is another one.
    #[inline]
    pub fn switch(&mut self, system: Option<M>) {
        if system.is_some() {
            self.switched = system;
        }
    }
}

/// Checks that a state is in the declared ranges. Methods that find modes keep limits up to errors
/// of steps, and are not checked.
///
/// # Errors
/// If an entry is out of its range.
#[inline]
pub(super) fn check_ranges<M: OdeSystem, T: Stepper<M>>(
    system: &M,
    y: &M::State,
) -> Result<(), StepFailure<M::Scalar>> {
    if T::FINDS_MODES { Ok(()) } else { Ok(system.domain().check(y.as_ref())?) }
}

/// Checks that ticks of clocks are distinct in time, and that the run is not backwards.
fn check_clocks<M: OdeSystem>(
    system: &M,
    t: M::Scalar,
    end: M::Scalar,
) -> Result<(), SettingError<M::Scalar>> {
    let Some(period) = system.shortest_period() else { return Ok(()) };
    let spacing = M::Scalar::epsilon() * t.abs().max(end.abs());
    if end < t {
        return Err(SettingError::Invalid("clocks tick forwards in time only"));
    }
    match period > M::Scalar::ZERO && period > spacing {
        true => Ok(()),
        false => Err(SettingError::Invalid(
            "the period of a clock must be positive and longer than the spacing of times",
        )),
    }
}

/// Checks the direction of a run: impacts and friction exclude backward runs, since the past does
/// not follow from the present.
///
/// # Errors
/// If the direction is excluded, or there are more events than can be located.
pub fn check_direction<M: OdeSystem>(
    system: &M,
    [t, end]: [M::Scalar; 2],
) -> Result<(), SettingError<M::Scalar>> {
    if system.events().len() > M::MAX_EVENTS.min(MAX_LOCATED) {
        return Err(SettingError::Invalid("the system has more events than its `MAX_EVENTS`"));
    }
    if end < t && have_modes(system.events()) {
        return Err(SettingError::Invalid("contacts and dry friction run forwards in time only"));
    }
    Ok(())
}
