//! Names and units of a system's variables, as plain data.

/// Names and units of the variables of a system.
///
/// They are the constants of the system's type, unless the system was read at run time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Description {
    /// Names of the positions, `COORDINATES`.
    pub coordinates: &'static [&'static str],
    /// Names of the velocities, `VELOCITIES`.
    pub velocities: &'static [&'static str],
    /// Coordinates whose rates are the named velocities, `RATES_OF`.
    pub rates_of: &'static [&'static str],
    /// Number of first-order states, `FIRST_ORDER_STATES`.
    pub first_order_states: usize,
    /// Units by name, `UNITS`.
    pub units: &'static [(&'static str, &'static str)],
    /// Indices at which unit quaternions begin, in addition to those that `normalise` of the type
    /// handles.
    pub quaternions: &'static [usize],
}

impl Description {
    /// True if each velocity is the rate of a position and is named after it.
    #[must_use]
    pub const fn velocities_are_rates(&self) -> bool {
        self.velocities.is_empty() && self.first_order_states == 0
    }
}
