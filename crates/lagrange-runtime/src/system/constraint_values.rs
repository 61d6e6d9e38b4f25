//! The constraints that act at an instant.

use crate::linalg::vector::{StateVector, dot};
use crate::scalar::Scalar;

/// Residuals and gradients of the constraints that act at a time and state.
/// A constraint on positions stores c, its rate ċ and the row ∂c/∂q of A. A constraint on
/// velocities stores its residual and its gradient with respect to them. The number of acting
/// constraints is at most the number of coordinates: more cannot be independent, and all results
/// are then NaN.
///
/// ```
/// use lagrange::constraint::ConstraintValues;
///
/// // A point at (x, y) on a circle of unit radius.
/// let ([x, y], [u, v]) = ([0.6, 0.8], [-0.8, 0.6]);
/// let mut values = ConstraintValues::<f64, [f64; 2]>::NONE;
/// values.push_holonomic((x * x + y * y - 1.0) / 2.0, x * u + y * v, &[x, y]);
/// assert_eq!(values.count(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct ConstraintValues<S: Scalar, Q: StateVector<S>> {
    /// Residuals of positions; zero for constraints on velocities.
    pub(crate) positions: Q,
    /// Residuals of velocities.
    pub(crate) velocities: Q,
    /// A in rows; rows beyond the last constraint are zero.
    pub(crate) jacobian: Q::Square,
    /// One for each constraint on positions, zero for the others.
    is_holonomic: Q::Indices,
    count: usize,
}

impl<S: Scalar, Q: StateVector<S>> ConstraintValues<S, Q> {
    /// No constraint.
    pub const NONE: Self = ConstraintValues {
        positions: Q::ZERO,
        velocities: Q::ZERO,
        jacobian: Q::ZERO_SQUARE,
        is_holonomic: Q::ZERO_INDICES,
        count: 0,
    };

    /// Adds a constraint on positions: its residual, its rate and its gradient.
    #[inline]
    pub fn push_holonomic(&mut self, position: S, velocity: S, row: &Q) {
        self.push(1, position, velocity, row);
    }

    /// Adds a constraint on velocities alone: its residual and its gradient with respect to
    /// velocities.
    #[inline]
    pub fn push_nonholonomic(&mut self, velocity: S, row: &Q) {
        self.push(0, S::ZERO, velocity, row);
    }

    /// Returns the number of constraints.
    #[inline]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the gradient of the constraint at this index.
    #[inline]
    pub(crate) fn row(&self, index: usize) -> &Q {
        &self.jacobian.as_ref()[index]
    }

    /// Computes A x.
    #[inline]
    pub(crate) fn applied(&self, x: &Q) -> Q {
        self.by_rows(|row| dot(row, x))
    }

    /// Computes Σⱼ |Aᵢⱼ| xⱼ of each constraint.
    #[inline]
    pub(crate) fn sizes(&self, x: &Q) -> Q {
        self.by_rows(|row| {
            let terms = row.as_ref().iter().zip(x.as_ref());
            terms.fold(S::ZERO, |sum, (a, x)| a.abs().multiply_add(*x, sum))
        })
    }

    /// Computes Aᵀμ.
    #[inline]
    pub(crate) fn force(&self, multipliers: &Q) -> Q {
        let mut force = Q::ZERO;
        for (row, multiplier) in self.rows().zip(multipliers.as_ref()) {
            for (force, entry) in force.as_mut().iter_mut().zip(row.as_ref()) {
                *force = entry.multiply_add(*multiplier, *force);
            }
        }
        force
    }

    /// Computes Σᵢ |Aᵢⱼ| |μᵢ| of each coordinate.
    #[inline]
    pub(crate) fn load(&self, multipliers: &Q) -> Q {
        let mut load = Q::ZERO;
        for (row, multiplier) in self.rows().zip(multipliers.as_ref()) {
            for (load, entry) in load.as_mut().iter_mut().zip(row.as_ref()) {
                *load = entry.abs().multiply_add(multiplier.abs(), *load);
            }
        }
        load
    }

    /// Returns the gradients of all constraints.
    #[inline]
    pub(crate) fn rows(&self) -> impl Iterator<Item = &Q> {
        self.jacobian.as_ref().iter().take(self.count)
    }

    #[inline]
    fn by_rows(&self, entry: impl Fn(&Q) -> S) -> Q {
        let mut entries = Q::ZERO;
        for (value, row) in entries.as_mut().iter_mut().zip(self.rows()) {
            *value = entry(row);
        }
        entries
    }

    /// True if the constraint at this index is one on positions.
    #[inline]
    pub(crate) fn is_holonomic(&self, index: usize) -> bool {
        self.is_holonomic.as_ref()[index] == 1
    }

    #[inline]
    fn push(&mut self, is_holonomic: usize, position: S, velocity: S, row: &Q) {
        let Some(place) = self.jacobian.as_mut().get_mut(self.count) else {
            self.positions.as_mut().fill(S::from_f64(f64::NAN));
            self.velocities.as_mut().fill(S::from_f64(f64::NAN));
            return;
        };
        *place = *row;
        self.positions.as_mut()[self.count] = position;
        self.velocities.as_mut()[self.count] = velocity;
        self.is_holonomic.as_mut()[self.count] = is_holonomic;
        self.count += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::ConstraintValues;

    #[test]
    fn more_constraints_than_coordinates_are_not_numbers() {
        let mut values = ConstraintValues::<f64, [f64; 1]>::NONE;
        values.push_holonomic(0.5, 0.25, &[1.0]);
        assert_eq!((values.count(), values.positions, values.velocities), (1, [0.5], [0.25]));
        values.push_nonholonomic(0.0, &[2.0]);
        assert_eq!(values.count(), 1);
        assert!(values.positions[0].is_nan() && values.velocities[0].is_nan());
    }
}
