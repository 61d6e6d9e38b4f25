//! Motion where elimination in a fixed order fails. Constraints are dependent or compensate for a
//! zero mass, or a pivot of an indefinite mass matrix vanishes.
//!
//! The method is that of emitted code (`constraint::redundant_motion` and
//! `constraint::indefinite_motion` of `lagrange-runtime`), for sizes known at run time. It solves M
//! a = f + Aᵀλ and A a + b = 0 by orthogonal factors of the scaled gradients. Among all multipliers
//! with the same motion, it chooses those with the smallest sum of squares.

use super::orthogonal::{OrthogonalFactors, length, reciprocal};

/// Number of roundings per row below which a remaining column of a scaled symmetric matrix counts
/// as zero.
const ROUNDINGS: f64 = 32.0;
/// Number of rounds of equilibration.
const SCALINGS: usize = 6;
/// Maximum mismatch of dependent constraints, as a multiple of the rank tolerance.
const CONTRADICTION: f64 = 100.0;

/// Returns the fraction of a gradient below which the remainder orthogonal to other gradients
/// counts as zero: ε^(5/16).
fn rank_tolerance() -> f64 {
    f64::EPSILON.powf(0.3125)
}

/// True if results with this growth of rounding errors are reliable: below ε^(−5/8), as in emitted
/// code (`lagrange::constraint::are_regular`).
pub(super) fn is_regular(growth: f64) -> bool {
    growth * f64::EPSILON.powf(0.625) < 1.0
}

/// Returns the accelerations and multipliers of `n` coordinates and `m` constraints; `values`
/// contains M and A in rows, then f and b. All are NaN if the accelerations are undetermined, or if
/// constraints contradict each other.
pub(super) fn motion(n: usize, m: usize, values: &[f64]) -> Vec<f64> {
    let (mass, rest) = values.split_at(n * n);
    let (jacobian, rest) = rest.split_at(m * n);
    let (forcing, drifts) = rest.split_at(n);
    let rows = |matrix: &[f64]| matrix.chunks(n.max(1)).map(<[f64]>::to_vec).collect::<Vec<_>>();
    let is_finite = values.iter().all(|value| value.is_finite());
    let found = is_finite.then(|| match m {
        0 => unconstrained(rows(mass), forcing),
        _ => ScaledEquations::new(rows(mass), &rows(jacobian)).motion(forcing, drifts),
    });
    found.flatten().unwrap_or_else(|| vec![f64::NAN; n + m])
}

/// Returns the smallest change δ of `n` coordinates, measured by mass, with A δ = −`residuals`.
/// Constraints that depend on others are ignored. `values` begins with M and A in rows. NaN if the
/// change does not exist.
pub(super) fn correction(n: usize, residuals: &[f64], values: &[f64]) -> Vec<f64> {
    let rows = |matrix: &[f64]| matrix.chunks(n.max(1)).map(<[f64]>::to_vec).collect::<Vec<_>>();
    let (mass, rest) = values.split_at(n * n);
    let jacobian = &rest[..residuals.len() * n];
    let are_finite = [mass, jacobian, residuals].iter().all(|part| part.iter().all(|x| x.is_finite()));
    let is_lost = |(row, residual): (&[f64], &f64)| *residual != 0.0 && row.iter().all(|x| *x == 0.0);
    let is_possible = are_finite && !jacobian.chunks(n.max(1)).zip(residuals).any(is_lost);
    let change = is_possible.then(|| {
        let equations = ScaledEquations::new(rows(mass), &rows(jacobian));
        let drifts = product(&equations.gradient_scales, residuals);
        Some(product(&equations.scales, &equations.acceleration(&vec![0.0; n], &drifts)?))
    });
    change.flatten().unwrap_or_else(|| vec![f64::NAN; n])
}

/// Returns the solution of M a = f for a symmetric, possibly indefinite mass matrix; `None` if it
/// is singular.
fn unconstrained(mut mass: Vec<Vec<f64>>, forcing: &[f64]) -> Option<Vec<f64>> {
    let unit = power_to_one(mass.iter().flatten().map(|entry| entry.abs()));
    multiply(&mut mass, unit);
    let scales = equilibration(&mass);
    let factors = OrthogonalFactors::new(scaled(mass, &scales), forcing.len(), roundings(forcing.len()));
    let right = forcing.iter().zip(&scales).map(|(force, scale)| scale * (unit * force)).collect();
    (factors.rank() == forcing.len()).then(|| product(&scales, &factors.combination(right)))
}

/// The matrices in coordinates with masses near one, and with constraint gradients scaled to length
/// one. As in emitted code, results do not depend on units.
struct ScaledEquations {
    /// Power of two by which masses and forces are multiplied.
    unit: f64,
    mass: Vec<Vec<f64>>,
    /// Scales of coordinates: a = scales a′.
    scales: Vec<f64>,
    gradients: Vec<Vec<f64>>,
    /// Scales of constraints: λ = gradient_scales λ′.
    gradient_scales: Vec<f64>,
    factors: OrthogonalFactors,
}

impl ScaledEquations {
    fn new(mut mass: Vec<Vec<f64>>, jacobian: &[Vec<f64>]) -> ScaledEquations {
        let unit = power_to_one((0..mass.len()).map(|j| mass[j][j]));
        multiply(&mut mass, unit);
        let scales = coordinate_scales(&mass, jacobian);
        let mut gradients = jacobian.iter().map(|row| product(row, &scales)).collect::<Vec<_>>();
        let gradient_scales = gradients.iter().map(|row| reciprocal(length(row))).collect::<Vec<_>>();
        for (row, scale) in gradients.iter_mut().zip(&gradient_scales) {
            row.iter_mut().for_each(|entry| *entry *= scale);
        }
        let factors = OrthogonalFactors::new(gradients.clone(), scales.len(), rank_tolerance());
        ScaledEquations { unit, mass: scaled(mass, &scales), scales, gradients, gradient_scales, factors }
    }

    /// Returns the accelerations and multipliers; `None` if they are undetermined or constraints
    /// contradict each other.
    fn motion(&self, forcing: &[f64], drifts: &[f64]) -> Option<Vec<f64>> {
        let forcing = forcing.iter().zip(&self.scales).map(|(force, scale)| scale * (self.unit * force));
        let (forcing, drifts) = (forcing.collect::<Vec<_>>(), product(&self.gradient_scales, drifts));
        let acceleration = self.acceleration(&forcing, &drifts)?;
        let size = length(&acceleration) + length(&forcing) + length(&drifts);
        let most = CONTRADICTION * rank_tolerance() * size;
        let missed = |&i: &usize| (dot(&self.gradients[i], &acceleration) + drifts[i]).abs();
        if self.factors.dependent().iter().any(|i| missed(i) > most) {
            return None;
        }
        let missing = self.forces_on(&acceleration, &forcing).iter().map(|force| -force).collect();
        let multipliers = self.factors.shortest_amounts(&self.factors.inward(missing), &self.gradient_scales);
        let multipliers = multipliers.into_iter().map(|multiplier| multiplier / self.unit).collect();
        Some([product(&self.scales, &acceleration), multipliers].concat())
    }

    /// Returns the scaled accelerations for scaled forces and drifts; `None` if they are
    /// undetermined.
    fn acceleration(&self, forcing: &[f64], drifts: &[f64]) -> Option<Vec<f64>> {
        let demanded = drifts.iter().map(|drift| -drift).collect::<Vec<_>>();
        let mut acceleration = self.factors.shortest(&demanded);
        let free = self.free_part(self.forces_on(&acceleration, forcing))?;
        acceleration.iter_mut().zip(free).for_each(|(sum, part)| *sum += part);
        Some(acceleration)
    }

    /// Returns f − M a.
    fn forces_on(&self, acceleration: &[f64], forcing: &[f64]) -> Vec<f64> {
        self.mass.iter().zip(forcing).map(|(row, force)| force - dot(row, acceleration)).collect()
    }

    /// Returns the acceleration due to these forces in the directions that no constraint restricts;
    /// `None` if it is undetermined.
    fn free_part(&self, forces: Vec<f64>) -> Option<Vec<f64>> {
        let (n, rank) = (self.scales.len(), self.factors.rank());
        let unrestricted = |mut vector: Vec<f64>| {
            vector[..rank].fill(0.0);
            vector
        };
        let column = |j: usize| {
            let mut direction = vec![0.0; n];
            direction[j] = 1.0;
            if j < rank {
                return direction;
            }
            let direction = self.factors.outward(direction);
            let inertial = self.mass.iter().map(|row| dot(row, &direction)).collect();
            unrestricted(self.factors.inward(inertial))
        };
        let factors = OrthogonalFactors::new((0..n).map(column).collect(), n, roundings(n));
        let right = unrestricted(self.factors.inward(forces));
        (factors.rank() == n).then(|| self.factors.outward(factors.combination(right)))
    }
}

/// Returns the scales of coordinates: reciprocal roots of their masses. A massless coordinate is
/// scaled by the size of the other coordinates in its constraints.
fn coordinate_scales(mass: &[Vec<f64>], jacobian: &[Vec<f64>]) -> Vec<f64> {
    let of_mass = |j: usize| if mass[j][j] > 0.0 { 1.0 / mass[j][j].sqrt() } else { 0.0 };
    let scales = (0..mass.len()).map(of_mass).collect::<Vec<_>>();
    let sizes = jacobian.iter().map(|row| length(&product(row, &scales))).collect::<Vec<_>>();
    let scale = |j: usize| {
        if scales[j] > 0.0 {
            return scales[j];
        }
        let beside = jacobian.iter().zip(&sizes).filter(|(_, size)| **size > 0.0);
        let most = beside.fold(0.0, |most: f64, (row, size)| most.max(row[j].abs() / size));
        let first = || jacobian.iter().map(|row| row[j].abs()).find(|entry| *entry > 0.0);
        reciprocal(if most > 0.0 { most } else { first().unwrap_or(1.0) })
    };
    (0..mass.len()).map(scale).collect()
}

/// Returns the power of two that scales the first positive value to between one and two; one
/// without such a value.
fn power_to_one(mut values: impl Iterator<Item = f64>) -> f64 {
    let Some(mut left) = values.find(|value| *value > 0.0) else { return 1.0 };
    let mut power = 1.0;
    for exponent in [512, 256, 128, 64, 32, 16, 8, 4, 2, 1] {
        let [large, small] = [exponent, -exponent].map(|exponent| 2_f64.powi(exponent));
        if left >= large {
            (left, power) = (left * small, power * small);
        } else if left < 2.0 * small {
            (left, power) = (left * large, power * large);
        }
    }
    power
}

/// Multiplies all entries of a matrix by a number.
fn multiply(matrix: &mut [Vec<f64>], factor: f64) {
    matrix.iter_mut().flatten().for_each(|entry| *entry *= factor);
}

/// Returns the factors that scale the largest entry of each row of a symmetric matrix to near one,
/// if applied to both rows and columns.
fn equilibration(matrix: &[Vec<f64>]) -> Vec<f64> {
    let mut scales = vec![1.0; matrix.len()];
    for _ in 0..SCALINGS {
        let largest = |(row, scale): (&Vec<f64>, &f64)| {
            row.iter()
                .zip(&scales)
                .fold(0.0, |most: f64, (entry, other)| most.max((scale * entry * other).abs()))
        };
        let largest = matrix.iter().zip(&scales).map(largest).collect::<Vec<_>>();
        scales.iter_mut().zip(largest).for_each(|(scale, largest)| *scale *= reciprocal(largest.sqrt()));
    }
    scales
}

/// Multiplies rows and columns of a matrix by scales.
fn scaled(mut matrix: Vec<Vec<f64>>, scales: &[f64]) -> Vec<Vec<f64>> {
    for (row, scale) in matrix.iter_mut().zip(scales) {
        row.iter_mut().zip(scales).for_each(|(entry, other)| *entry *= scale * other);
    }
    matrix
}

/// Multiplies vectors entry by entry.
fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a * b).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns the rounding level of a scaled matrix with this many rows.
fn roundings(rows: usize) -> f64 {
    ROUNDINGS * rows as f64 * f64::EPSILON
}

#[cfg(test)]
mod tests {
    use super::motion;

    #[track_caller]
    fn assert_near(found: &[f64], wanted: &[f64]) {
        let is_near = |(found, wanted): (&f64, &f64)| (found - wanted).abs() <= 1e-12;
        assert!(
            found.len() == wanted.len() && found.iter().zip(wanted).all(is_near),
            "{found:?} for {wanted:?}"
        );
    }

    /// A table of weight 40 on four legs at (±1, ±1), loaded at (½, 0): the shortest forces that
    /// carry it are 10 + 5 x.
    #[test]
    fn redundant_constraints_share_a_force() {
        let legs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(x, y)| [1.0, y, -x]);
        let mass = [4.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        let values = [&mass[..], &legs.concat(), &[-40.0, 0.0, 20.0], &[0.0; 4]].concat();
        assert_near(&motion(3, 4, &values), &[0.0, 0.0, 0.0, 15.0, 15.0, 5.0, 5.0]);
    }

    /// Gradients in the ratio a : b share a force in this ratio.
    #[test]
    fn multipliers_have_the_smallest_sum_of_squares() {
        let (a, b) = (0.3_f64, 0.3_f64.sin());
        let found = motion(1, 2, &[1.0, a, b, 1.0, 0.0, 0.0]);
        let share = -1.0 / (a * a + b * b);
        assert_near(&found, &[0.0, a * share, b * share]);
    }

    #[test]
    fn contradictions_and_undetermined_motions_are_not_a_number() {
        assert!(motion(1, 2, &[1.0, 1.0, 1.0, 0.0, 0.0, 1.0]).iter().all(|value| value.is_nan()));
        assert!(
            motion(2, 1, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]).iter().all(|value| value.is_nan())
        );
        assert!(motion(2, 0, &[1.0, 1.0, 1.0, 1.0, 2.0, 2.0]).iter().all(|value| value.is_nan()));
    }

    #[test]
    fn constraints_make_up_for_a_mass_that_is_zero() {
        assert_near(&motion(2, 1, &[2.0, 0.0, 0.0, 0.0, 1.0, -1.0, 6.0, 0.0, 0.0]), &[3.0, 3.0, 0.0]);
        assert_near(&motion(2, 0, &[0.0, 1.0, 1.0, 0.0, 2.0, 3.0]), &[3.0, 2.0]);
    }
}
