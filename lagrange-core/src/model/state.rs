//! Entries of the state.

use lagrange_expr::expr::ExprId;

/// A bound of the values of a parameter, or of a quantity of a contact.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bound {
    /// Value of the bound; that of a parameter is free of symbols.
    pub value: ExprId,
    /// True if the bound is a possible value.
    pub is_included: bool,
}

/// A position: a generalised coordinate, a component of a unit quaternion, or a first-order or
/// discrete state.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Name of the position.
    pub name: String,
    /// q
    pub position: ExprId,
    /// q̇, a function of positions and generalised velocities, linear in the velocities; for a
    /// first-order state, any function of time, positions, velocities and inputs
    pub rate: ExprId,
    /// True if it is a state, which displacements do not change.
    pub is_state: bool,
    /// Its range and nominal value.
    pub limits: EntryLimits,
}

/// The range and the nominal value of an entry of the state.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct EntryLimits {
    /// Lower and upper bound, each with true if it is included.
    pub bounds: [Option<(f64, bool)>; 2],
    /// The magnitude that counts as one, if it is declared.
    pub nominal: Option<f64>,
}

impl EntryLimits {
    /// Returns the nominal values of all entries of a state; none if none is declared.
    pub fn nominal_values(entries: &[EntryLimits]) -> Vec<f64> {
        let is_declared = entries.iter().any(|limits| limits.nominal.is_some());
        let declared = entries.iter().filter(|_| is_declared);
        declared.map(|limits| limits.nominal.unwrap_or(1.0)).collect()
    }

    /// True if it has a lower or an upper bound.
    pub fn is_bounded(&self) -> bool {
        self.bounds.iter().any(Option::is_some)
    }

    /// True if a value is in the range.
    pub(crate) fn contains(&self, value: f64) -> bool {
        let [lower, upper] = self.bounds;
        let is_above = lower.is_none_or(|(bound, included)| value > bound || included && value == bound);
        is_above && upper.is_none_or(|(bound, included)| value < bound || included && value == bound)
    }
}

/// A generalised velocity, called generalised speed by Kane: the rate of a coordinate, or a
/// component of an angular velocity.
#[derive(Clone, Debug)]
pub struct Speed {
    /// Name in the state.
    pub name: String,
    /// Index of the coordinate whose rate it is; `None` for an angular velocity.
    pub coordinate: Option<usize>,
    /// v
    pub velocity: ExprId,
    /// v̇
    pub acceleration: ExprId,
    /// Its range and nominal value.
    pub limits: EntryLimits,
}

/// An orientation as a unit quaternion among the positions, with the angular velocity in the
/// rotated axes among the velocities.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Orientation {
    /// Index of the scalar part among the positions; the vector part follows.
    pub position: usize,
    /// Index of the first component of the angular velocity among the velocities; the others
    /// follow.
    pub velocity: usize,
}
