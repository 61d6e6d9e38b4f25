//! The system of a run as it is at present.

use crate::system::{MOST_LOCATED, OdeSystem, SettingError, StepFailure};

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

    /// Becomes the system as a motion starts from this time and state towards `end`, after `act`
    /// has had its way with it.
    ///
    /// # Errors
    /// If no motion starts there; the system is then unchanged.
    pub fn begin(
        &mut self,
        (t, y): (M::Scalar, &M::State),
        end: M::Scalar,
        act: impl FnOnce(&M) -> Result<Option<M>, StepFailure<M::Scalar>>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        check_direction(self.system(), [t, end])?;
        let acted = act(self.system())?;
        let begun = acted.as_ref().unwrap_or(self.system()).begin(t, y)?;
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

    /// Goes on with this system, if it is another one.
    #[inline]
    pub fn switch(&mut self, system: Option<M>) {
        if system.is_some() {
            self.switched = system;
        }
    }
}

/// Checks the direction of a run: impacts and friction exclude backward runs, since the past does
/// not follow from the present.
///
/// # Errors
/// If it may not, or if there are more events than can be looked for.
pub fn check_direction<M: OdeSystem>(
    system: &M,
    [t, end]: [M::Scalar; 2],
) -> Result<(), SettingError<M::Scalar>> {
    if system.events().len() > MOST_LOCATED {
        return Err(SettingError::Invalid("the system declares too many events"));
    }
    if end < t && system.events().iter().any(|event| event.is_switch && !event.is_side) {
        return Err(SettingError::Invalid("contacts and dry friction run forwards in time only"));
    }
    Ok(())
}
