//! Names and units of a system's variables, as plain data.

/// Names and units of the variables of a system.
///
/// By default a system has those of the constants of its type. Systems that are read at run time
/// have their own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Description {
    /// Names of the positions, `COORDINATES`.
    pub coordinates: &'static [&'static str],
    /// Names of the velocities, `VELOCITIES`.
    pub velocities: &'static [&'static str],
    /// Coordinates of which named velocities are the rates, `RATES_OF`.
    pub rates_of: &'static [&'static str],
    /// Number of first-order states, `FIRST_ORDER_STATES`.
    pub first_order_states: usize,
    /// Units by name, `UNITS`.
    pub units: &'static [(&'static str, &'static str)],
    /// Indices at which unit quaternions begin, beside those that `normalise` of the type brings to
    /// length one.
    pub quaternions: &'static [usize],
}

impl Description {
    /// True if velocities are the rates of the positions, one by one, and named after them.
    #[must_use]
    pub const fn velocities_are_rates(&self) -> bool {
        self.velocities.is_empty() && self.first_order_states == 0
    }
}
