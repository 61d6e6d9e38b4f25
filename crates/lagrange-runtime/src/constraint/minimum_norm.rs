//! Multipliers of dependent constraints.
//!
//! Redundant constraints share a force in ways that the motion does not distinguish. A mechanism
//! may also pass through configurations in which constraints lose their independence for an
//! instant. Among all multipliers that yield the same motion, the solution is the one with the
//! smallest sum of squares. Independence is judged by orthogonal factors of the scaled equations,
//! never by products of matrices with themselves, which would lose half of the digits. Sources:
//! Golub, Van Loan, *Matrix Computations*, 4th ed., §5.4, §5.5. García de Jalón, Bayo, *Kinematic
//! and Dynamic Simulation of Multibody Systems*. Ruiz, *A scaling algorithm to equilibrate both
//! rows and columns norms in matrices*, Rutherford Appleton Laboratory report RAL-TR-2001-034.

use crate::linalg::orthogonal::{OrthogonalFactors, euclidean_norm};
use crate::scalar::Scalar;
use crate::tolerance::DEPENDENT_COLUMN;

/// Number of scaling iterations. Each takes the square root of the ratio of magnitudes.
const SCALINGS: u32 = 6;

/// Accelerations and multipliers of a system whose constraints may be dependent: N coordinates, D
/// constraints.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RedundantMotion<S, const N: usize, const D: usize> {
    /// The accelerations a.
    pub acceleration: [S; N],
    /// The multipliers λ with the smallest sum of squares among all that yield these accelerations.
    pub multipliers: [S; D],
    /// Number of independent constraints.
    pub rank: usize,
}

/// Returns the fraction of a constraint's gradient below which the part independent of other
/// constraints is ignored: ε^(5/16), which is 1.3·10⁻⁵ for `f64`.
///
/// Gradients are measured with the roots of the masses as units and scaled to length one. If a
/// fraction σ of one is independent, positions are accurate to ε/σ, and velocities and
/// accelerations to ε/σ². They become useless long before σ is as small as rounding. Moreover,
/// stages of a method violate the constraints by the errors of the method. Constraints that are
/// dependent along the motion differ by the same amount there. With a tolerance near rounding,
/// these differences would count as constraints.
pub fn rank_tolerance<S: Scalar>() -> S {
    let root = S::epsilon().sqrt().sqrt();
    root * root.sqrt().sqrt()
}

/// Returns the vector x with the smallest sum of squares among those that minimise the norm of
/// `matrix` x − `right`. The matrix is symmetric and may be singular or indefinite.
///
/// Rows and columns are scaled alike to determine the rank. A column depends on others if its
/// remainder is less than 32 D roundings of the largest column. If an entry of the matrix is itself
/// a rounding error, the matrix must therefore also contain the value that was rounded. A Schur
/// complement that vanished entirely cannot be distinguished from a small one. If any entry is NaN
/// or infinite, all results are NaN.
///
/// ```
/// use lagrange::constraint::minimum_norm;
///
/// // One constraint, stated twice: each copy takes half of the force.
/// let halves: [f64; 2] = minimum_norm([[2.0, 2.0], [2.0, 2.0]], [4.0, 4.0]);
/// assert!(halves.iter().all(|half| (half - 1.0).abs() < 1e-14));
/// ```
pub fn minimum_norm<S: Scalar, const D: usize>(matrix: [[S; D]; D], right: [S; D]) -> [S; D] {
    if !(finite(&matrix) && finite(&[right])) {
        return [S::NAN; D];
    }
    let unit = power_to_one(matrix.as_flattened().iter().map(|entry| entry.abs()));
    let (matrix, right) = (matrix.map(|row| row.map(|entry| unit * entry)), right.map(|entry| unit * entry));
    let scales = equilibration(&matrix);
    let scaled: [[S; D]; D] =
        core::array::from_fn(|j| core::array::from_fn(|i| scales[i] * matrix[i][j] * scales[j]));
    let factors = OrthogonalFactors::new(scaled, roundings::<S, D>());
    let scale = |right: &[S; D]| factors.inward(core::array::from_fn(|i| scales[i] * right[i]));
    let mut inner = scale(&right);
    if euclidean_norm(&inner[factors.rank()..]) > roundings::<S, D>() * euclidean_norm(&inner) {
        inner = scale(&Ignored::new(&factors, &scales).remove(right));
    }
    shortest(&factors, &inner, &scales)
}

/// Computes accelerations and multipliers of
///
/// ```text
/// M a = f + Aᵀλ,    A a + b = 0
/// ```
///
/// from the symmetric mass matrix M and the matrix A of the constraints, both in rows, the forcing
/// f and the drift b. The mass matrix may be singular if the constraints determine the remaining
/// accelerations.
///
/// [`rank_tolerance`] decides which constraints depend on each other. All results are NaN if an
/// argument is not finite, if the accelerations are not determined, or if the constraints
/// contradict each other. Constraints contradict each other if a dependent one is violated by more
/// than a hundred times that tolerance. The violation is relative to the accelerations with and
/// without constraints and the drifts.
///
/// Example: a table of weight 40 on four legs at (±1, ±1), loaded at (½, 0). Height and two tilts
/// are the three coordinates, and the height of each foot z + y a − x b is a constraint. The four
/// are dependent, since opposed loads on the two diagonals of legs cause no motion. Among all
/// forces that carry the load, Σ λ = 40, Σ x λ = 20 and Σ y λ = 0, the shortest are 10 + 5 x.
///
/// ```
/// use lagrange::constraint::redundant_motion;
///
/// let mass = [[4.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let weight = [-40.0, 0.0, 20.0];
/// let legs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(x, y)| [1.0, y, -x]);
/// let motion = redundant_motion(&mass, &weight, &legs, &[0.0; 4]);
/// assert_eq!(motion.rank, 3);
/// assert_eq!(motion.multipliers.map(|force: f64| (force * 1e12).round() / 1e12), [15.0, 15.0, 5.0, 5.0]);
/// assert!(motion.acceleration.iter().all(|acceleration| acceleration.abs() < 1e-12));
/// ```
pub fn redundant_motion<S: Scalar, const N: usize, const D: usize>(
    mass: &[[S; N]; N],
    forcing: &[S; N],
    jacobian: &[[S; N]; D],
    drift: &[S; D],
) -> RedundantMotion<S, N, D> {
    let equations = ScaledEquations::new(mass, jacobian).filter(|_| finite(&[*forcing]) && finite(&[*drift]));
    let motion = equations.and_then(|equations| {
        let (acceleration, multipliers) = equations.solve(forcing, drift)?;
        equations.agrees(&acceleration, forcing, drift).then(|| RedundantMotion {
            acceleration: equations.in_coordinates(&acceleration),
            multipliers,
            rank: equations.rank(),
        })
    });
    motion.unwrap_or(RedundantMotion { acceleration: [S::NAN; N], multipliers: [S::NAN; D], rank: 0 })
}

/// Computes the smallest change δ of the coordinates, measured by the mass matrix, with A δ =
/// −`residuals` for the independent constraints. The dependent ones are ignored, since their
/// remaining residuals are of second order unless they contradict the independent ones.
///
/// The result is NaN if an argument is not finite, if δ is not determined, or if a constraint
/// without a gradient has a residual.
pub fn redundant_correction<S: Scalar, const N: usize, const D: usize>(
    mass: &[[S; N]; N],
    jacobian: &[[S; N]; D],
    residuals: &[S; D],
) -> [S; N] {
    let is_lost = |(row, residual): (&[S; N], &S)| *residual != S::ZERO && row.iter().all(|x| *x == S::ZERO);
    let are_possible = finite(&[*residuals]) && !jacobian.iter().zip(residuals).any(is_lost);
    let equations = ScaledEquations::new(mass, jacobian).filter(|_| are_possible);
    let change = equations.and_then(|equations| {
        let (change, _) = equations.solve(&[S::ZERO; N], residuals)?;
        Some(equations.in_coordinates(&change))
    });
    change.unwrap_or([S::NAN; N])
}

/// The equations in coordinates with masses near one, with the gradients of the constraints scaled
/// to length one.
///
/// The result does not depend on units. If masses or lengths are multiplied by a power of two, all
/// scaled quantities remain identical bit by bit. Masses are first brought near one by a power of
/// two, since the root of an odd power of two would not be exact.
#[derive(Debug)]
struct ScaledEquations<S, const N: usize, const D: usize> {
    /// Power of two by which masses and forces are multiplied.
    unit: S,
    mass: [[S; N]; N],
    /// Scales of coordinates: a = scales a′.
    scales: [S; N],
    rows: [[S; N]; D],
    /// Scales of constraints: λ = row_scales λ′.
    row_scales: [S; D],
    factors: OrthogonalFactors<S, N, D>,
}

impl<S: Scalar, const N: usize, const D: usize> ScaledEquations<S, N, D> {
    /// Scales and factorises the matrices; `None` if one is not finite.
    fn new(mass: &[[S; N]; N], jacobian: &[[S; N]; D]) -> Option<Self> {
        if !(finite(mass) && finite(jacobian)) {
            return None;
        }
        let unit = power_to_one((0..N).map(|j| mass[j][j]));
        let mass = mass.map(|row| row.map(|entry| unit * entry));
        let scales = coordinate_scales(&mass, jacobian);
        let mass = core::array::from_fn(|i| core::array::from_fn(|j| scales[i] * mass[i][j] * scales[j]));
        let mut rows: [[S; N]; D] =
            core::array::from_fn(|i| core::array::from_fn(|j| jacobian[i][j] * scales[j]));
        let row_scales = core::array::from_fn(|i| reciprocal(euclidean_norm(&rows[i])));
        for (row, scale) in rows.iter_mut().zip(row_scales) {
            *row = row.map(|entry| entry * scale);
        }
        let factors = OrthogonalFactors::new(rows, rank_tolerance());
        Some(ScaledEquations { unit, mass, scales, rows, row_scales, factors })
    }

    fn rank(&self) -> usize {
        self.factors.rank()
    }

    /// Computes the scaled accelerations, and the multipliers; `None` if accelerations are not
    /// determined.
    fn solve(&self, forcing: &[S; N], drift: &[S; D]) -> Option<([S; N], [S; D])> {
        let demanded = core::array::from_fn(|i| -(self.row_scales[i] * drift[i]));
        let mut acceleration = self.factors.shortest(&demanded);
        let free = self.free_part(self.forces_on(&acceleration, forcing))?;
        for (sum, part) in acceleration.iter_mut().zip(free) {
            *sum = *sum + part;
        }
        let missing = self.forces_on(&acceleration, forcing).map(|force| -force);
        let components = self.factors.inward(missing);
        let multipliers = shortest(&self.factors, &components, &self.row_scales);
        Some((acceleration, multipliers.map(|multiplier| multiplier / self.unit)))
    }

    /// Computes f − M a.
    fn forces_on(&self, acceleration: &[S; N], forcing: &[S; N]) -> [S; N] {
        core::array::from_fn(|i| {
            let row = self.mass[i].iter().zip(acceleration);
            let force = self.scales[i] * (self.unit * forcing[i]);
            row.fold(force, |sum, (mass, part)| (-*mass).multiply_add(*part, sum))
        })
    }

    /// Computes the acceleration caused by these forces in the directions not restricted by
    /// constraints.
    fn free_part(&self, forces: [S; N]) -> Option<[S; N]> {
        let (rank, mut right) = (self.rank(), self.factors.inward(forces));
        right[..rank].fill(S::ZERO);
        let reduced: [[S; N]; N] = core::array::from_fn(|j| {
            let mut direction = [S::ZERO; N];
            direction[j] = S::ONE;
            if j < rank {
                return direction;
            }
            let direction = self.factors.outward(direction);
            let mut column =
                self.factors.inward(self.forces_on(&direction, &[S::ZERO; N])).map(|force| -force);
            column[..rank].fill(S::ZERO);
            column
        });
        let factors = OrthogonalFactors::new(reduced, roundings::<S, N>());
        let is_determined = factors.rank() == N;
        is_determined.then(|| self.factors.outward(factors.combination(right)))
    }

    /// True if the dependent constraints hold, too.
    fn agrees(&self, acceleration: &[S; N], forcing: &[S; N], drift: &[S; D]) -> bool {
        let scaled_forcing: [S; N] = core::array::from_fn(|j| self.scales[j] * (self.unit * forcing[j]));
        let drifts: [S; D] = core::array::from_fn(|i| self.row_scales[i] * drift[i]);
        let size = euclidean_norm(acceleration) + euclidean_norm(&scaled_forcing) + euclidean_norm(&drifts);
        let most = S::from_f64(100.0) * rank_tolerance::<S>() * size;
        self.factors.order()[self.rank()..].iter().all(|&i| {
            let row = self.rows[i].iter().zip(acceleration);
            row.fold(drifts[i], |sum, (entry, part)| entry.multiply_add(*part, sum)).abs() <= most
        })
    }

    fn in_coordinates(&self, scaled: &[S; N]) -> [S; N] {
        core::array::from_fn(|j| self.scales[j] * scaled[j])
    }
}

/// Computes the scales of coordinates: the reciprocal roots of their masses. The scale of a
/// massless coordinate is derived from its constraints, relative to the other coordinates in them.
fn coordinate_scales<S: Scalar, const N: usize, const D: usize>(
    mass: &[[S; N]; N],
    jacobian: &[[S; N]; D],
) -> [S; N] {
    let of_mass = |j: usize| if mass[j][j] > S::ZERO { S::ONE / mass[j][j].sqrt() } else { S::ZERO };
    let scales: [S; N] = core::array::from_fn(of_mass);
    let sizes = jacobian.map(|row| {
        let parts: [S; N] = core::array::from_fn(|j| row[j] * scales[j]);
        euclidean_norm(&parts)
    });
    core::array::from_fn(|j| {
        if scales[j] > S::ZERO {
            return scales[j];
        }
        let beside = jacobian.iter().zip(sizes).filter(|(_, size)| *size > S::ZERO);
        let most = beside.fold(S::ZERO, |most, (row, size)| most.max(row[j].abs() / size));
        let first = || jacobian.iter().map(|row| row[j].abs()).find(|entry| *entry > S::ZERO);
        reciprocal(if most > S::ZERO { most } else { first().unwrap_or(S::ONE) })
    })
}

/// Returns the shortest x for which the columns of the factors, in the amounts x / `scales`, add up
/// to a vector. The vector is given by its components in the directions of the independent columns.
fn shortest<S: Scalar, const ROWS: usize, const COLUMNS: usize>(
    factors: &OrthogonalFactors<S, ROWS, COLUMNS>,
    components: &[S; ROWS],
    scales: &[S; COLUMNS],
) -> [S; COLUMNS] {
    let mut products = [S::ZERO; COLUMNS];
    let mut rows = [[S::ZERO; COLUMNS]; COLUMNS];
    for (k, (row, product)) in rows.iter_mut().zip(&mut products).enumerate().take(factors.rank()) {
        for (l, &column) in factors.order().iter().enumerate().skip(k) {
            row[column] = factors.entry(k, l) / scales[column];
        }
        let scale = reciprocal(euclidean_norm(row));
        *product = components[k] * scale;
        *row = row.map(|entry| entry * scale);
    }
    OrthogonalFactors::new(rows, S::ZERO).shortest(&products)
}

/// The null space of a symmetric matrix.
#[derive(Debug)]
struct Ignored<S, const D: usize> {
    basis: OrthogonalFactors<S, D, D>,
}

impl<S: Scalar, const D: usize> Ignored<S, D> {
    fn new(factors: &OrthogonalFactors<S, D, D>, scales: &[S; D]) -> Self {
        let basis = core::array::from_fn(|l| {
            if l < factors.rank() {
                return [S::ZERO; D];
            }
            let amounts = factors.dependence(l);
            let vector: [S; D] = core::array::from_fn(|i| scales[i] * amounts[i]);
            let scale = reciprocal(euclidean_norm(&vector));
            vector.map(|entry| entry * scale)
        });
        Ignored { basis: OrthogonalFactors::new(basis, S::ZERO) }
    }

    /// Removes the null-space component of a vector.
    fn remove(&self, x: [S; D]) -> [S; D] {
        if self.basis.rank() == 0 {
            return x;
        }
        let mut inner = self.basis.inward(x);
        inner[..self.basis.rank()].fill(S::ZERO);
        self.basis.outward(inner)
    }
}

/// Returns factors that bring the largest entry of each row of a symmetric matrix near one, if rows
/// and columns are both multiplied by them.
pub(super) fn equilibration<S: Scalar, const D: usize>(matrix: &[[S; D]; D]) -> [S; D] {
    let mut scales = [S::ONE; D];
    for _ in 0..SCALINGS {
        let before = scales;
        for (i, scale) in scales.iter_mut().enumerate() {
            let row = matrix[i].iter().zip(&before);
            let largest =
                row.fold(S::ZERO, |most, (entry, other)| most.max((before[i] * *entry * *other).abs()));
            *scale = before[i] * reciprocal(largest.sqrt());
        }
    }
    scales
}

/// Returns the power of two that brings the first positive value between one and two; one if there
/// is none.
pub(super) fn power_to_one<S: Scalar>(mut values: impl Iterator<Item = S>) -> S {
    let Some(mut left) = values.find(|value| *value > S::ZERO) else { return S::ONE };
    let mut power = S::ONE;
    for exponent in [512, 256, 128, 64, 32, 16, 8, 4, 2, 1] {
        // Beyond the range of the number type these are infinity and zero, which never match.
        let [large, small] = [exponent, -exponent].map(|exponent| S::from_f64(2.0).powi(exponent));
        if left >= large {
            (left, power) = (left * small, power * small);
        } else if left < small + small {
            (left, power) = (left * large, power * large);
        }
    }
    power
}

/// Returns the reciprocal; one if it is not finite.
fn reciprocal<S: Scalar>(x: S) -> S {
    let reciprocal = S::ONE / x;
    if reciprocal.is_finite() { reciprocal } else { S::ONE }
}

/// Returns the relative rounding level of a scaled matrix with K rows.
pub(super) fn roundings<S: Scalar, const K: usize>() -> S {
    DEPENDENT_COLUMN.times(K).part::<S>()
}

pub(super) fn finite<S: Scalar, const K: usize>(rows: &[[S; K]]) -> bool {
    rows.iter().all(|row| row.iter().all(|entry| entry.is_finite()))
}

#[cfg(test)]
mod tests;
