//! The way back onto the constraints.
//!
//! Newton's method with the gradients of the constraints at the current point. Each correction is
//! the smallest change by mass that removes the residuals to first order, so that the remainder is
//! quadratic in it. A correction that overshoots is halved until the next one, by the same
//! gradients, would be smaller. Constraints are linear in velocities, so one correction suffices
//! there. Source: Deuflhard, *Newton Methods for Nonlinear Problems*, §3.3; see also the sources of
//! the module above.

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

type Residuals<M> = <M as ConstrainedSystem>::Multipliers;
type StepOf<M> = Correction<ScalarOf<M>, Positions<M>, Velocities<M>>;

/// More corrections than this are no use within a motion,
const MAX_ITERATIONS: u32 = 20;
/// and more than this from far away.
const MAX_FROM_AFAR: u32 = 200;
/// The root of a rounding, times this, is the part of the coordinates below which the square of a
/// correction is left alone.
const NEGLIGIBLE: f64 = 1e-2;
/// The part of velocities up to which rounding of a correction is lost in theirs.
const SLIGHT: f64 = 1e-3;
/// Corrections that are so many times larger than residuals, as parts of their scales, are
const MAGNIFIED: f64 = 1e3;
/// not made if these parts are smaller than this times the root of a rounding.
const NEXT_TO_NOTHING: f64 = 0.1;
/// Corrections of velocities by a smaller part of them are not looked at for that.
const LARGE: f64 = 1e-6;
/// Velocities may not change by a larger part of them within a motion,
const LEAP: f64 = 0.1;
/// unless the change is slower than this part of the coordinates in a unit of time.
const SLOW: f64 = 1e-4;
/// Error message for dependent constraints.
pub(crate) const UNDETERMINED: &str = "constraints depend on each other here and do not determine the motion";
/// Starts are admitted if constraints miss by no more than this part of their scales.
const ADMITTED: f64 = 1e-6;

/// Takes positions and velocities to the nearest ones that satisfy the constraints, as the mass
/// matrix measures distances: first positions, then velocities.
///
/// Near the constraints each correction squares the error. One or two suffice within a motion. Far
/// away up to 200 are made, and shortened where they overshoot. From there, positions move along
/// the constraints as long as that brings them nearer to the start. The
/// [displacement](MechanicalSystem) δ = q − q₀ therefore ends normal to the allowed directions: M δ =
/// Aᵀμ with the mass matrix and the gradients at q. This is a local minimum of the distance √(δᵀM
/// δ), and the only one near the constraints. Where constraints on velocities hold the system, too,
/// it moves along them as it does in motions. Bodies whose orientations are unit quaternions also
/// end where M δ = Aᵀμ, with δ = 2 Im(q̄₀ ⊗ q) in their axes. That is near the least distance, but
/// not at it if they are turned far and their moments of inertia differ.
///
/// Constraints that depend on each other are satisfied together or not at all. The remainder of a
/// residual must be a small part, √ε (1.5·10⁻⁸ for `f64`), of its scale.
///
/// The scale of a residual is its value if every coordinate were off by its size: Σⱼ |Aᵢⱼ| sⱼ. The
/// size sⱼ of a coordinate is its magnitude, but at least the largest magnitude of all coordinates.
/// The latter counts as 10⁻⁶ if below and as one if above. A coordinate at zero therefore has a
/// size, too, and one that is far away does not lend its size to the others. Sizes of velocities
/// follow from velocities in the same way. Where velocities are not the rates of the positions, the
/// sizes of positions are converted to displacements. Unit quaternions are normalised first.
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

/// Returns the nearest velocities that satisfy the constraints at these positions, which stay
/// unchanged.
///
/// # Errors
/// If there are none, with the constraint that is violated most in proportion to its scale, as in
/// [`project`].
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

/// Brings a state of a motion back onto the constraints, as [`project`] does, but without checking
/// the remainder: the corrections show that it is small.
/// [`OdeSystem::correct`](crate::system::OdeSystem::correct) of emitted types calls it.
///
/// # Errors
/// [`StepFailure::Violated`] if corrections do not converge, [`StepFailure::Stuck`] if they would
/// lead to another motion; the state is then unchanged.
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

/// Brings a state that replaced another onto the constraints, as [`project`] does.
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

/// True if velocities change so much that what follows is another motion. Errors of a step do not
/// do that, but the smallest residual does where constraints are on the point of depending on each
/// other.
#[inline]
fn leaps<S: Scalar, Q: StateVector<S>, V: StateVector<S>>(before: &V, after: &V, q: &Q) -> bool {
    let changes = before.as_ref().iter().zip(after.as_ref()).map(|(before, after)| (*after - *before).abs());
    let change = changes.fold(S::ZERO, S::max);
    change > S::from_f64(LEAP) * largest(before.as_ref()) && change > S::from_f64(SLOW) * size(q.as_ref())
}

/// Brings the initial state of a motion onto the constraints if it nearly satisfies them. That is
/// the case if every residual is at most 10⁻⁶ of its scale, as [`project`] measures it.
/// [`OdeSystem::admit`](crate::system::OdeSystem::admit) of emitted types calls it.
///
/// # Errors
/// [`StepFailure::Violated`] with the constraint that is violated most in proportion to its scale;
/// the state is then unchanged.
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

/// Brings positions and velocities onto the constraints; whether that succeeded. They are spoilt if
/// not.
#[inline]
fn bring<M: ConstrainedSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &mut M::Coordinates,
    v: &mut M::Velocities,
) -> bool {
    bring_positions(system, t, q, v, MAX_ITERATIONS) && bring_velocities(system, t, q, v)
}

/// Brings positions to the nearest ones on the constraints, if corrections converge. Small
/// corrections are as short as can be.
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

/// Brings positions onto the constraints, if that many corrections do.
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
    // What is not a number is larger than anything, too.
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

/// True if a correction is out of proportion to the residual, which is next to nothing. Constraints
/// are then about to depend on each other, and the rest is better ignored.
#[inline]
fn is_magnified<S: Scalar>(length: S, size: S, part: impl FnOnce() -> S) -> bool {
    let part = part();
    part <= S::from_f64(NEXT_TO_NOTHING) * S::epsilon().sqrt()
        && length > S::from_f64(MAGNIFIED) * part * size
}

/// Newton's method from its first step on.
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

/// Shortens a step until the next one with the same gradients is smaller; returns its end, the
/// residuals there, and that next step.
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

/// A correction and from where.
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

/// Brings velocities onto the constraints, if corrections converge. A second one removes what
/// rounding left of a large first one.
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
fn are_zero<S: Scalar>(residuals: &[S]) -> bool {
    residuals.iter().all(|residual| *residual == S::ZERO)
}

/// Corrections up to this leave nothing behind but rounding.
#[inline]
fn negligible<S: Scalar>(q: &[S]) -> S {
    S::from_f64(NEGLIGIBLE) * S::epsilon().sqrt() * size(q)
}

#[cfg(test)]
mod tests;
