//! Sizes of residuals.

use super::ConstrainedSystem;
use crate::linalg::vector::difference;
use crate::scalar::{Number, Scalar};
use crate::system::{StateVector, Violated, Violation, reach};
use crate::tolerance::RESIDUAL;

/// Lower bound on the size of coordinates.
const SMALLEST: f64 = 1e-6;

/// The constraint with the largest violation in proportion to its scale.
pub(super) struct Worst<S> {
    pub(super) violation: Violation<S>,
    /// The ratio of the residual to its scale; infinite if the residual is NaN.
    pub(super) part: S,
}

/// Returns the largest violation of the positions.
pub(super) fn of_positions<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
) -> Worst<M::Scalar> {
    let residuals = system.position_residuals(t, q);
    let scales = system.residual_scales(t, q, &reach(system, t, q, &sizes(q)));
    Worst::new(system.constraint_names(), residuals.as_ref(), scales.as_ref(), Violated::Positions)
}

/// Returns the largest violation of the velocities.
pub(super) fn of_velocities<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, v): (&M::Coordinates, &M::Velocities),
) -> Worst<M::Scalar> {
    let residuals = system.velocity_residuals(t, q, v);
    let scales = system.residual_scales(t, q, &sizes(v));
    Worst::new(system.constraint_names(), residuals.as_ref(), scales.as_ref(), Violated::Velocities)
}

/// Returns the largest residual of positions relative to the largest scale. Near configurations in
/// which constraints depend on each other, their own scales may vanish.
#[cold]
pub(super) fn of_positions_together<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
) -> M::Scalar {
    let scales = system.residual_scales(t, q, &reach(system, t, q, &sizes(q)));
    largest(system.position_residuals(t, q).as_ref()) / largest(scales.as_ref())
}

/// Returns the largest residual of velocities, relative to the largest scale.
#[cold]
pub(super) fn of_velocities_together<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, v): (&M::Coordinates, &M::Velocities),
) -> M::Scalar {
    let scales = system.residual_scales(t, q, &sizes(v));
    largest(system.velocity_residuals(t, q, v).as_ref()) / largest(scales.as_ref())
}

/// Computes A δ, the change of the residuals of velocities if these change by δ.
pub(super) fn gradients_times<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
    change: &M::Velocities,
) -> M::Multipliers {
    let [moved, still] = [change, &change.zeros()].map(|v| system.velocity_residuals(t, q, v));
    difference(&moved, &still)
}

/// Returns the largest magnitude; NaN if an entry is NaN.
#[inline]
pub(super) fn largest<S: Scalar>(x: &[S]) -> S {
    x.iter().fold(S::ZERO, |most, x| most.max(x.abs()))
}

/// Returns the largest violation of positions, or else of velocities, if it exceeds this fraction
/// of its scale.
pub(super) fn beyond<M: ConstrainedSystem + ?Sized>(
    part: M::Scalar,
    system: &M,
    t: M::Scalar,
    (q, v): (&M::Coordinates, &M::Velocities),
) -> Option<Violation<M::Scalar>> {
    let too_much = |worst: Worst<M::Scalar>| (worst.part > part).then_some(worst.violation);
    too_much(of_positions(system, t, q)).or_else(|| too_much(of_velocities(system, t, (q, v))))
}

/// Returns the largest violation of a state; the one of positions, if they violate their
/// constraints.
#[cold]
pub(super) fn worst<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, v): (&M::Coordinates, &M::Velocities),
) -> Violation<M::Scalar> {
    beyond(M::Scalar::epsilon().sqrt(), system, t, (q, v)).unwrap_or_else(|| {
        let (positions, velocities) = (of_positions(system, t, q), of_velocities(system, t, (q, v)));
        if positions.part >= velocities.part { positions.violation } else { velocities.violation }
    })
}

impl<S: Scalar> Worst<S> {
    fn new(names: &'static [&'static str], residuals: &[S], scales: &[S], of: Violated) -> Self {
        let mut worst = Worst {
            violation: Violation {
                constraint: names.first().copied().unwrap_or_default(),
                residual: S::ZERO,
                of,
            },
            part: S::ZERO,
        };
        let rounding = RESIDUAL.part::<S>() * scales.iter().fold(S::ZERO, |most, s| most.max(*s));
        for ((&constraint, &residual), &scale) in names.iter().zip(residuals).zip(scales) {
            let part = if residual.abs() <= rounding { S::ZERO } else { proportion(residual, scale) };
            if part > worst.part {
                worst = Worst { violation: Violation { constraint, residual, of }, part };
            }
        }
        worst
    }
}

/// Returns the ratio of a residual to its scale.
fn proportion<S: Scalar>(residual: S, scale: S) -> S {
    let part = if residual == S::ZERO { S::ZERO } else { residual.abs() / scale };
    if part >= S::ZERO { part } else { S::ONE / S::ZERO }
}

/// Returns the scales of coordinates or velocities: their magnitudes, but at least [`size`].
pub(crate) fn sizes<S: Scalar, Q: StateVector<S>>(x: &Q) -> Q {
    let least = size(x.as_ref());
    let mut sizes = *x;
    for entry in sizes.as_mut() {
        *entry = entry.abs().max(least);
    }
    sizes
}

/// Returns the largest magnitude, clamped between [`SMALLEST`] and one.
#[inline]
pub(super) fn size<S: Scalar>(x: &[S]) -> S {
    x.iter().fold(S::from_f64(SMALLEST), |most, x| most.max(x.abs())).min(S::ONE)
}

#[cfg(test)]
mod tests {
    use super::{Violated, Worst};

    #[test]
    fn residuals_without_a_scale_are_rounding_beside_the_largest() {
        let part = |roundings: f64| {
            let residual = roundings * f64::EPSILON;
            Worst::new(&["vanishing", "other"], &[residual, 0.0], &[0.0, 1.0], Violated::Positions).part
        };
        assert_eq!([4.0, 128.0].map(part), [0.0, f64::INFINITY]);
    }
}
