//! Projection onto the constraints.
//!
//! Newton's method with the gradients of the constraints at the current point. Each correction is
//! the smallest change, measured by the mass matrix, that removes the residuals to first order. The
//! remainder is quadratic in it. A correction that overshoots is halved until the next one, with
//! the same gradients, is smaller. Constraints are linear in velocities, so one correction suffices
//! for velocities. Source: Deuflhard, *Newton Methods for Nonlinear Problems*, §3.3; see also the
//! sources of the module above.

use super::ConstrainedSystem;
use super::nearest::NearestSearch;
use super::residuals::{
    beyond, largest, of_positions_together, of_velocities, of_velocities_together, size, worst,
};
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{
    MechanicalSystem, Positions, ScalarOf, StateVector, StepFailure, Velocities, Violation, displaced, join,
    normalise_described, normalise_positions, split,
};

pub(super) type Residuals<M> = <M as ConstrainedSystem>::Multipliers;
type StepOf<M> = Correction<ScalarOf<M>, Positions<M>, Velocities<M>>;

/// Maximum number of corrections within a motion.
const MAX_ITERATIONS: u32 = 20;
/// Maximum number of corrections from far away.
const MAX_FROM_AFAR: u32 = 200;
/// A correction of at most this times √ε, relative to the coordinates, is the last one: its square
/// is negligible.
const NEGLIGIBLE: f64 = 1e-2;
/// A correction of velocities of at most this relative size is the last one: its rounding error is
/// lost in that of the velocities.
const SLIGHT: f64 = 1e-3;
/// Corrections are skipped if they exceed tiny residuals by more than this factor, both relative to
/// their scales.
const MAGNIFIED: f64 = 1e3;
/// Residuals are tiny up to this times √ε, relative to their scales.
const NEXT_TO_NOTHING: f64 = 0.1;
/// Corrections of velocities up to this relative size are never skipped.
const LARGE: f64 = 1e-6;
/// Maximum relative change of velocities by a correction within a motion.
const LEAP: f64 = 0.1;
/// Changes of velocities up to this fraction of the coordinates per unit of time are always
/// accepted.
const SLOW: f64 = 1e-4;
/// Error message for dependent constraints.
pub(crate) const UNDETERMINED: &str = "constraints depend on each other here and do not determine the motion";
/// Initial states are admitted if residuals are at most this fraction of their scales.
const ADMITTED: f64 = 1e-6;

/// Moves positions and velocities to the nearest ones that satisfy the constraints, in the metric
/// of the mass matrix: first positions, then velocities.
///
/// Near the constraints each correction squares the error. One or two corrections suffice within a
/// motion. From far away, at most 200 corrections are made, and shortened if they overshoot.
/// Positions then move along the constraints as long as their distance from the start decreases.
/// The [displacement](MechanicalSystem) δ = q − q₀ therefore ends normal to the allowed directions:
/// M δ = Aᵀμ with the mass matrix and the gradients at q. This is a local minimum of the distance
/// √(δᵀM δ), and the only one near the constraints. If there are also constraints on velocities,
/// positions move along these as they do in motions. Bodies whose orientations are unit quaternions
/// also end where M δ = Aᵀμ, with δ = 2 Im(q̄₀ ⊗ q) in their axes. This is near the least distance,
/// but not exactly there if rotations are large and moments of inertia differ.
///
/// Dependent constraints are either all satisfied or all violated. The remainder of a residual must
/// be at most a small part, √ε (1.5·10⁻⁸ for `f64`), of its scale.
///
/// The scale of a residual is its value if every coordinate were off by its size: Σⱼ |Aᵢⱼ| sⱼ. The
/// size sⱼ of a coordinate is its magnitude, but at least the largest magnitude of all coordinates.
/// The latter is clamped between 10⁻⁶ and one. A coordinate at zero therefore has a size, too, and
/// a distant one does not affect the sizes of the others. Sizes of velocities are computed in the
/// same way. If velocities are not the rates of the positions, the sizes of positions are converted
/// to displacements. Unit quaternions are normalised first.
///
/// # Errors
/// If the constraints cannot be satisfied, from here or at all. The error names the constraint with
/// the largest violation in proportion to its scale. Positions and velocities are then unchanged.
pub fn project<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &mut M::Coordinates,
    v: &mut M::Velocities,
) -> Result<(), Violation<M::Scalar>> {
    let (mut positions, mut velocities) = (*q, *v);
    normalise_positions::<M>(system.description(), &mut positions);
    let is_found = bring_nearest(system, t, &mut positions, v)
        && bring_velocities(system, t, &positions, &mut velocities)
        && beyond(M::Scalar::epsilon().sqrt(), system, t, (&positions, &velocities)).is_none();
    if !is_found {
        return Err(worst(system, t, (q, v)));
    }
    (*q, *v) = (positions, velocities);
    Ok(())
}

/// Returns the nearest velocities that satisfy the constraints at these positions, which remain
/// unchanged.
///
/// # Errors
/// If there are none. The error names the constraint with the largest violation in proportion to
/// its scale, as in [`project`].
pub fn consistent_velocity<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
    v: &M::Velocities,
) -> Result<M::Velocities, Violation<M::Scalar>> {
    let mut found = *v;
    let is_found = bring_velocities(system, t, q, &mut found)
        && of_velocities(system, t, (q, &found)).part <= M::Scalar::epsilon().sqrt();
    if is_found { Ok(found) } else { Err(of_velocities(system, t, (q, v)).violation) }
}

/// Brings a state of a motion back onto the constraints as [`project`] does, without checking the
/// remainder. The sizes of the corrections prove that it is small.
/// [`OdeSystem::correct`](crate::system::OdeSystem::correct) of emitted types calls it.
///
/// # Errors
/// [`StepFailure::Violated`] if corrections do not converge, and [`StepFailure::Stuck`] if they
/// would lead to a different motion; the state is then unchanged.
#[inline]
pub fn correct<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &mut M::State,
) -> Result<(), StepFailure<M::Scalar>> {
    let mut unit = *y;
    normalise_described::<M>(system.description(), &mut unit)?;
    let (mut q, mut v) = split::<M>(&unit);
    if !bring(system, t, &mut q, &mut v) {
        let (q, v) = split::<M>(y);
        return Err(StepFailure::Violated(worst(system, t, (&q, &v))));
    }
    let (_, before) = split::<M>(y);
    if leaps(&before, &v, &q) {
        return Err(StepFailure::Stuck(UNDETERMINED));
    }
    *y = join::<M>(&q, &v);
    Ok(())
}

/// Brings a replacement state onto the constraints, as [`project`] does.
/// [`OdeSystem::restore`](crate::system::OdeSystem::restore) of emitted types calls it.
///
/// # Errors
/// [`StepFailure::Violated`]; the state is then unchanged.
pub fn restore<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &mut M::State,
) -> Result<(), StepFailure<M::Scalar>> {
    let mut unit = *y;
    normalise_described::<M>(system.description(), &mut unit)?;
    let (mut q, mut v) = split::<M>(&unit);
    project(system, t, &mut q, &mut v).map_err(StepFailure::Violated)?;
    *y = join::<M>(&q, &v);
    Ok(())
}

/// True if velocities change so much that a different motion follows. Errors of a step never cause
/// this, but tiny residuals do if constraints are nearly dependent.
#[inline]
fn leaps<S: Scalar, Q: StateVector<S>, V: StateVector<S>>(before: &V, after: &V, q: &Q) -> bool {
    let changes = before.as_ref().iter().zip(after.as_ref()).map(|(before, after)| (*after - *before).abs());
    let change = changes.fold(S::ZERO, S::max);
    change > S::from_f64(LEAP) * largest(before.as_ref()) && change > S::from_f64(SLOW) * size(q.as_ref())
}

/// Brings the initial state of a motion onto the constraints if it nearly satisfies them. Every
/// residual must be at most 10⁻⁶ of its scale, as defined by [`project`].
/// [`OdeSystem::admit`](crate::system::OdeSystem::admit) of emitted types calls it.
///
/// # Errors
/// [`StepFailure::Violated`] with the constraint that has the largest violation in proportion to
/// its scale; the state is then unchanged.
pub fn admit<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &mut M::State,
) -> Result<(), StepFailure<M::Scalar>> {
    let mut unit = *y;
    normalise_described::<M>(system.description(), &mut unit)?;
    let (mut q, mut v) = split::<M>(&unit);
    if let Some(violation) = beyond(M::Scalar::from_f64(ADMITTED), system, t, (&q, &v)) {
        return Err(StepFailure::Violated(violation));
    }
    project(system, t, &mut q, &mut v).map_err(StepFailure::Violated)?;
    *y = join::<M>(&q, &v);
    Ok(())
}

/// Brings positions and velocities onto the constraints. Returns true if this succeeds; otherwise
/// their values are arbitrary.
#[inline]
fn bring<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &mut M::Coordinates,
    v: &mut M::Velocities,
) -> bool {
    bring_positions(system, t, q, v, MAX_ITERATIONS) && bring_velocities(system, t, q, v)
}

/// Brings positions to the nearest ones on the constraints, if corrections converge. The search for
/// the nearest ones is omitted if the correction is negligible.
fn bring_nearest<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &mut M::Coordinates,
    v: &M::Velocities,
) -> bool {
    let from = *q;
    if !bring_positions(system, t, q, v, MAX_FROM_AFAR) {
        return false;
    }
    if largest(system.displacement(t, q, &from).as_ref()) > negligible(q.as_ref()) {
        let onto = |q: &mut M::Coordinates| bring_positions(system, t, q, v, MAX_ITERATIONS);
        *q = NearestSearch { system, t, v, from: &from }.nearest(*q, onto);
    }
    true
}

/// Brings positions onto the constraints, by at most this number of corrections.
#[inline]
fn bring_positions<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &mut M::Coordinates,
    v: &M::Velocities,
    most: u32,
) -> bool {
    let residuals = system.position_residuals(t, q);
    if are_zero(residuals.as_ref()) {
        return true;
    }
    let step = Correction::new(*q, system.correction(t, q, v, &residuals));
    // The comparison is false for NaN.
    if step.length <= negligible(q.as_ref()) {
        *q = end(system, t, &step, M::Scalar::ONE);
        return true;
    }
    let part = || of_positions_together(system, t, q);
    if is_magnified(step.length, largest(q.as_ref()), part) {
        return true;
    }
    newton(system, t, v, step, most).map(|found| *q = found).is_some()
}

/// True if a correction is out of proportion to a tiny residual. Constraints are then nearly
/// dependent, and the rest of the residual is better ignored.
#[inline]
fn is_magnified<S: Scalar>(length: S, size: S, part: impl FnOnce() -> S) -> bool {
    let part = part();
    part <= S::from_f64(NEXT_TO_NOTHING) * S::epsilon().sqrt()
        && length > S::from_f64(MAGNIFIED) * part * size
}

/// Runs Newton's method, starting with its first step.
#[cold]
fn newton<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    v: &M::Velocities,
    first: StepOf<M>,
    most: u32,
) -> Option<M::Coordinates> {
    let mut step = first;
    let negligible = negligible(step.from.as_ref());
    for _ in 1..most {
        let (to, residuals, next) = shortened(system, t, v, &step)?;
        if next.length <= negligible {
            return Some(end(system, t, &next, M::Scalar::ONE));
        }
        step = Correction::new(to, system.correction(t, &to, v, &residuals));
        if step.length <= negligible {
            return Some(end(system, t, &step, M::Scalar::ONE));
        }
    }
    None
}

/// Shortens a step until the next one with the same gradients is smaller. Returns its end, the
/// residuals there, and the next step.
fn shortened<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    v: &M::Velocities,
    step: &StepOf<M>,
) -> Option<(Positions<M>, Residuals<M>, StepOf<M>)> {
    let mut part = M::Scalar::ONE;
    for _ in 0..MAX_ITERATIONS {
        let to = end(system, t, step, part);
        let residuals = system.position_residuals(t, &to);
        let next = Correction::new(to, system.correction(t, &step.from, v, &residuals));
        let demanded = (M::Scalar::ONE - part / M::Scalar::from_f64(4.0)) * step.length;
        if next.length <= demanded && next.length.is_finite() {
            return Some((to, residuals, next));
        }
        part = part / M::Scalar::from_f64(2.0);
    }
    None
}

/// A correction and its starting point.
struct Correction<S, Q, V> {
    from: Q,
    change: V,
    length: S,
}

impl<S: Scalar, Q, V: StateVector<S>> Correction<S, Q, V> {
    #[inline]
    fn new(from: Q, change: V) -> Self {
        Correction { from, change, length: largest(change.as_ref()) }
    }
}

/// Returns the positions after a fraction of a correction.
#[inline]
fn end<M: MechanicalSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    step: &StepOf<M>,
    part: M::Scalar,
) -> M::Coordinates {
    displaced(system, t, &step.from, [(part, &step.change)])
}

/// Brings velocities onto the constraints, if corrections converge. A second one removes the
/// rounding errors of a large first one.
#[inline]
fn bring_velocities<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
    v: &mut M::Velocities,
) -> bool {
    for _ in 0..MAX_ITERATIONS {
        let residuals = system.velocity_residuals(t, q, v);
        if are_zero(residuals.as_ref()) {
            return true;
        }
        let step = Correction::new(*v, system.correction(t, q, v, &residuals));
        let part = || of_velocities_together(system, t, (q, v));
        let is_large = step.length > M::Scalar::from_f64(LARGE) * largest(v.as_ref());
        if is_large && is_magnified(step.length, largest(v.as_ref()), part) {
            return true;
        }
        *v = combined(&step.from, M::Scalar::ONE, &step.change);
        if step.length <= M::Scalar::from_f64(SLIGHT) * largest(v.as_ref()) {
            return step.length.is_finite();
        }
    }
    false
}

#[inline]
pub(super) fn are_zero<S: Scalar>(residuals: &[S]) -> bool {
    residuals.iter().all(|residual| *residual == S::ZERO)
}

/// Returns the size of corrections after which only rounding errors remain.
#[inline]
fn negligible<S: Scalar>(q: &[S]) -> S {
    S::from_f64(NEGLIGIBLE) * S::epsilon().sqrt() * size(q)
}

#[cfg(test)]
mod tests;
