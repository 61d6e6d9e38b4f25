//! Search for the nearest positions, from positions on the constraints.
//!
//! The distance from q₀ is √(δᵀM δ) with the displacement δ = q − q₀ and the mass matrix M at q.
//! Its slope along the constraints is minus the *pull*. The pull is the tangential part of q₀ − q,
//! without its component M-orthogonal to the directions that the constraints allow. Conjugate
//! gradients follow it. Each step is brought back onto the constraints, and directions are
//! transported by projection. Steps end where the slope nearly vanishes rather than at the least
//! distance, since differences of distances lose half of the digits. Sources: Absil, Mahony,
//! Sepulchre, *Optimization Algorithms on Matrix Manifolds*, §8.3; Nocedal, Wright, *Numerical
//! Optimization*, 2nd ed., §§3.5, 5.2.

use super::ConstrainedSystem;
use super::residuals::{gradients_times, largest};
use crate::linalg::vector::{add, difference};
use crate::scalar::{Number, Scalar};
use crate::system::{Positions, ScalarOf, Velocities, displaced};
use crate::tolerance::PULL;

/// Maximum number of steps.
const MAX_ITERATIONS: u32 = 100;
/// Maximum number of trial lengths per step.
const MAX_LENGTHS: u32 = 20;
/// A step ends when its slope is at most this fraction of its initial value.
const LEFT: f64 = 0.1;
/// Factor by which the longest length that is too short is extended.
const STRETCH: f64 = 4.0;
/// Minimum distance of a length from both ends of its bracket, as a fraction of the bracket.
const MARGIN: f64 = 0.1;

/// Square of the largest slight pull, relative to the square of the distance. The latter may
/// increase by the same part of itself.
const SLIGHT: f64 = 1e-2;

/// A search for the positions on the constraints nearest to `from`. The mass matrix is evaluated at
/// the velocities `v`.
pub(super) struct NearestSearch<'a, M: ConstrainedSystem + ?Sized> {
    pub(super) system: &'a M,
    pub(super) t: M::Scalar,
    pub(super) v: &'a M::Velocities,
    pub(super) from: &'a M::Coordinates,
}

/// Positions on the constraints.
struct SearchPoint<Q, V> {
    q: Q,
    /// The tangential part of the displacement to the start of the search.
    pull: V,
}

/// The end of a step along a direction.
struct End<S, Q, V> {
    point: SearchPoint<Q, V>,
    /// The direction, transported there.
    direction: V,
    length: S,
    /// Slope of the distance.
    slope: S,
}

type PointOf<M> = SearchPoint<Positions<M>, Velocities<M>>;
type EndOf<M> = End<ScalarOf<M>, Positions<M>, Velocities<M>>;

impl<M: ConstrainedSystem + ?Sized> NearestSearch<'_, M> {
    /// Finds the nearest positions from the positions `found` on the constraints. The function
    /// `onto` brings positions onto the constraints and returns true if it succeeds.
    pub(super) fn nearest(
        &self,
        found: Positions<M>,
        onto: impl Fn(&mut Positions<M>) -> bool,
    ) -> Positions<M> {
        let mut point = self.point(found);
        let mut direction = point.pull;
        let mut length = ScalarOf::<M>::ONE;
        for _ in 0..MAX_ITERATIONS {
            let size = largest(point.q.as_ref()).max(largest(self.from.as_ref()));
            let is_pulled = largest(point.pull.as_ref()) > PULL.part::<ScalarOf<M>>() * size;
            let slope = self.product(&point.q, &point.pull, &direction);
            // Both comparisons are false for NaN.
            if !(is_pulled && slope > ScalarOf::<M>::ZERO) {
                break;
            }
            let Some(end) = self.step(&point, &direction, (slope, length), &onto) else { break };
            direction = self.conjugate(&point, &end);
            (point, length) = (end.point, end.length);
        }
        point.q
    }

    fn point(&self, q: Positions<M>) -> PointOf<M> {
        SearchPoint { q, pull: self.tangential(&q, &self.way_back(&q)) }
    }

    /// Returns the displacement to the start of the search.
    fn way_back(&self, q: &Positions<M>) -> Velocities<M> {
        self.system.displacement(self.t, q, self.from)
    }

    /// Returns the step along a direction to the point where the distance hardly decreases further.
    /// If positions there cannot be brought onto nearby constraints, it is the longest known step
    /// that leads nearer.
    fn step(
        &self,
        start: &PointOf<M>,
        direction: &Velocities<M>,
        (slope, first): (ScalarOf<M>, ScalarOf<M>),
        onto: impl Fn(&mut Positions<M>) -> bool,
    ) -> Option<EndOf<M>> {
        // The longest length that is too short and the shortest that is too long, with their
        // slopes.
        let (mut short, mut long) = ((ScalarOf::<M>::ZERO, slope), None);
        let (mut length, mut nearer) = (first, None);
        for _ in 0..MAX_LENGTHS {
            let mut q = displaced(self.system, self.t, &start.q, [(length, direction)]);
            let end = onto(&mut q).then(|| self.end(q, direction, length));
            match end.filter(|end| !self.is_farther(start, &end.point)) {
                Some(end) if end.slope.abs() <= ScalarOf::<M>::from_f64(LEFT) * slope => return Some(end),
                Some(end) if end.slope > ScalarOf::<M>::ZERO => {
                    short = (length, end.slope);
                    nearer = Some(end);
                }
                Some(end) => long = Some((length, end.slope)),
                None => long = Some((length, -slope)),
            }
            length = between(short, long);
        }
        nearer
    }

    fn end(&self, q: Positions<M>, direction: &Velocities<M>, length: ScalarOf<M>) -> EndOf<M> {
        let point = self.point(q);
        let direction = self.tangential(&q, direction);
        let slope = self.product(&q, &point.pull, &direction);
        End { point, direction, length, slope }
    }

    /// True if a point is farther away by more than rounding. Both distances are measured by the
    /// mass matrix at the start.
    ///
    /// The pull on orientations is the slope of the distance except for terms of third order. Where
    /// it is slight, steps may therefore lead somewhat farther away if the pull decreases.
    fn is_farther(&self, start: &PointOf<M>, end: &PointOf<M>) -> bool {
        let square = |change: &Velocities<M>| self.product(&start.q, change, change);
        let [before, after] = [start, end].map(|point| square(&self.way_back(&point.q)));
        let [pull, left] = [start, end].map(|point| square(&point.pull));
        let is_slight = pull <= ScalarOf::<M>::from_f64(SLIGHT) * before && left < pull;
        let more = if is_slight { ScalarOf::<M>::from_f64(SLIGHT) } else { PULL.part() };
        // NaN counts as farther.
        let is_near = after <= before + more * before;
        !is_near
    }

    /// Returns the direction of the next step, after Polak and Ribière; the pull itself if that
    /// would lead away.
    fn conjugate(&self, start: &PointOf<M>, end: &EndOf<M>) -> Velocities<M> {
        let End { point, direction, .. } = end;
        let before = self.product(&start.q, &start.pull, &start.pull);
        let change = difference(&point.pull, &self.tangential(&point.q, &start.pull));
        let part = self.product(&point.q, &point.pull, &change) / before;
        let mut next = point.pull;
        if part > ScalarOf::<M>::ZERO {
            add(&mut next, part, direction);
        }
        let is_nearer = self.product(&point.q, &point.pull, &next) > ScalarOf::<M>::ZERO;
        if is_nearer { next } else { point.pull }
    }

    /// Removes the component of a displacement normal to the constraints.
    fn tangential(&self, q: &Positions<M>, change: &Velocities<M>) -> Velocities<M> {
        let NearestSearch { system, t, v, .. } = self;
        let mut tangential = *change;
        let moved = gradients_times(*system, *t, q, change);
        add(&mut tangential, Number::ONE, &system.correction(*t, q, v, &moved));
        tangential
    }

    /// Computes aᵀM b.
    fn product(&self, q: &Positions<M>, a: &Velocities<M>, b: &Velocities<M>) -> ScalarOf<M> {
        let weighed = self.system.mass_times(self.t, q, self.v, b);
        let products = a.as_ref().iter().zip(weighed.as_ref());
        products.fold(ScalarOf::<M>::ZERO, |sum, (a, b)| a.multiply_add(*b, sum))
    }
}

/// Returns the length at which the slope would vanish if it were linear between two known lengths.
/// It lies beyond the known lengths if the slope is not negative yet.
fn between<S: Scalar>((short, falls): (S, S), long: Option<(S, S)>) -> S {
    let Some((long, rises)) = long else {
        return S::from_f64(STRETCH) * short;
    };
    let part = falls / (falls - rises);
    let part = part.max(S::from_f64(MARGIN)).min(S::from_f64(1.0 - MARGIN));
    (long - short).multiply_add(part, short)
}
