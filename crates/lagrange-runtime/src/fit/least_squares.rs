//! Levenberg–Marquardt steps between bounds.
//!
//! A step δ minimises |r + J δ|² + λ|D δ|² over the variables that are free. D holds the largest
//! lengths that the columns of J had. Variables at a bound against which the gradient pushes them
//! are not free. Variables that a step would move beyond a bound are set to it, and the step is
//! recomputed for the others. λ follows the ratio of the actual to the predicted decrease. Sources:
//! Moré 1978; Madsen, Nielsen, Tingleff 2004, §3.2.

use std::vec::Vec;

use crate::linalg::dense::DenseMatrix;
use crate::linalg::singular_values::{SingularValues, dot, length};

/// The gradient counts as zero if its angle to the residuals has a cosine below this.
const LEAST_COSINE: f64 = 1e-9;
/// Minimum step, relative to the variables, below which a search ends.
const LEAST_STEP: f64 = 1e-11;
/// Minimum predicted relative decrease of the sum of squares, below which a search ends.
const LEAST_DECREASE: f64 = 1e-12;
/// Minimum ratio of the actual to the predicted decrease for which a step is accepted.
const LEAST_RATIO: f64 = 1e-4;
/// The initial λ, for columns of length one.
const FIRST_DAMPING: f64 = 1e-3;
/// Maximum λ, at which a search gives up.
const MAX_DAMPING: f64 = 1e20;

/// Residuals and their derivatives with respect to the variables.
#[derive(Clone)]
pub(super) struct Comparison {
    pub(super) residuals: Vec<f64>,
    pub(super) jacobian: DenseMatrix,
}

/// The final point of a search.
#[derive(Clone)]
pub(super) struct Minimum {
    pub(super) values: Vec<f64>,
    pub(super) at: Comparison,
    /// Half the sum of squares.
    pub(super) cost: f64,
    pub(super) iterations: usize,
    pub(super) evaluations: usize,
    pub(super) has_converged: bool,
}

/// Searches from a point between bounds for a minimum of the sum of squares.
///
/// # Errors
/// If there are no residuals at the start. If a later point has none, the step is shortened.
pub(super) fn minimise<E>(
    start: Vec<f64>,
    bounds: &[(f64, f64)],
    most_iterations: usize,
    mut evaluate: impl FnMut(&[f64]) -> Result<Comparison, E>,
) -> Result<Minimum, E> {
    let at = evaluate(&start)?;
    let cost = half_square(&at.residuals);
    let mut now = Minimum { values: start, at, cost, iterations: 0, evaluations: 1, has_converged: false };
    let mut scales = std::vec![0.0_f64; bounds.len()];
    let (mut damping, mut growth) = (FIRST_DAMPING, 2.0);
    while now.iterations < most_iterations && !now.has_converged {
        now.iterations += 1;
        grow(&mut scales, &now.at.jacobian);
        let free = free(&now, bounds);
        if is_stationary(&now, &free) {
            now.has_converged = true;
        }
        while !now.has_converged {
            let trial = BoundedStep::new(&now, bounds, &free, &scales, damping);
            if trial.is_negligible(&now, &scales) || damping > MAX_DAMPING {
                now.has_converged = trial.is_negligible(&now, &scales);
                return Ok(now);
            }
            now.evaluations += 1;
            let found = evaluate(&trial.values).ok().filter(|found| found.jacobian.is_finite());
            let cost = found.as_ref().map_or(f64::INFINITY, |found| half_square(&found.residuals));
            let ratio = (now.cost - cost) / trial.decrease;
            if let Some(at) = found.filter(|_| ratio > LEAST_RATIO) {
                now.has_converged = now.cost - cost <= LEAST_DECREASE * now.cost && ratio > 0.5;
                (now.values, now.at, now.cost) = (trial.values, at, cost);
                damping *= (1.0 - (2.0 * ratio - 1.0).powi(3)).clamp(1.0 / 3.0, 2.0);
                growth = 2.0;
                break;
            }
            damping *= growth;
            growth *= 2.0;
        }
    }
    Ok(now)
}

/// A step between bounds.
struct BoundedStep {
    values: Vec<f64>,
    step: Vec<f64>,
    /// The decrease of the cost predicted by linear residuals.
    decrease: f64,
}

impl BoundedStep {
    fn new(
        now: &Minimum,
        bounds: &[(f64, f64)],
        free: &[usize],
        scales: &[f64],
        damping: f64,
    ) -> BoundedStep {
        let Comparison { residuals, jacobian } = &now.at;
        let mut step = std::vec![0.0; bounds.len()];
        let mut free = free.to_vec();
        let rows = (0..jacobian.rows()).collect::<Vec<_>>();
        while !free.is_empty() {
            let left = residuals.iter().enumerate();
            let left = left.map(|(row, residual)| -residual - fixed_part(jacobian.row(row), &step, &free));
            let left = left.collect::<Vec<_>>();
            let part = jacobian.part(&rows, &free);
            let scaled = DenseMatrix::from_fn(part.rows(), free.len(), |i, j| part[(i, j)] / scales[free[j]]);
            let Some(values) = SingularValues::of(&scaled) else { break };
            for (entry, j) in values.damped(&left, damping).into_iter().zip(&free) {
                step[*j] = entry / scales[*j];
            }
            let is_beyond = |j: &usize| {
                let value = now.values[*j] + step[*j];
                !(bounds[*j].0..=bounds[*j].1).contains(&value)
            };
            let (beyond, within) = free.iter().partition::<Vec<usize>, _>(|j| is_beyond(j));
            for &j in &beyond {
                step[j] = (now.values[j] + step[j]).clamp(bounds[j].0, bounds[j].1) - now.values[j];
            }
            if beyond.is_empty() {
                break;
            }
            free = within;
        }
        BoundedStep::of_step(now, bounds, step)
    }

    fn of_step(now: &Minimum, bounds: &[(f64, f64)], step: Vec<f64>) -> BoundedStep {
        let moved = now.values.iter().zip(&step).zip(bounds);
        let values = moved.map(|((value, step), (low, high))| (value + step).clamp(*low, *high)).collect();
        let Comparison { residuals, jacobian } = &now.at;
        let linear = residuals.iter().enumerate();
        let linear =
            linear.map(|(row, residual)| residual + dot(jacobian.row(row), &step)).collect::<Vec<_>>();
        let decrease = now.cost - half_square(&linear);
        BoundedStep { values, step, decrease }
    }

    fn is_negligible(&self, now: &Minimum, scales: &[f64]) -> bool {
        let size =
            |vector: &[f64]| length(&vector.iter().zip(scales).map(|(x, d)| x * d).collect::<Vec<_>>());
        size(&self.step) <= LEAST_STEP * size(&now.values)
            || self.decrease <= LEAST_DECREASE * LEAST_DECREASE * now.cost
    }
}

/// Returns the part of a product with a row that is due to variables that are not free.
fn fixed_part(row: &[f64], step: &[f64], free: &[usize]) -> f64 {
    let others = (0..step.len()).filter(|j| !free.contains(j));
    others.fold(0.0, |sum, j| sum + row[j] * step[j])
}

/// Raises scales to the lengths of the columns; columns of zeros have the scale one.
fn grow(scales: &mut [f64], jacobian: &DenseMatrix) {
    for (j, scale) in scales.iter_mut().enumerate() {
        *scale = scale.max(length(&jacobian.column(j)));
        if *scale == 0.0 {
            *scale = 1.0;
        }
    }
}

/// Returns the variables that are not held at a bound.
pub(super) fn free(now: &Minimum, bounds: &[(f64, f64)]) -> Vec<usize> {
    let is_free = |j: &usize| {
        let (value, (low, high)) = (now.values[*j], bounds[*j]);
        let slope = dot(&now.at.jacobian.column(*j), &now.at.residuals);
        !(value <= low && slope >= 0.0 || value >= high && slope <= 0.0)
    };
    (0..bounds.len()).filter(is_free).collect()
}

/// True if no free variable decreases the sum of squares to first order.
fn is_stationary(now: &Minimum, free: &[usize]) -> bool {
    let Comparison { residuals, jacobian } = &now.at;
    let size = length(residuals);
    let is_level = |j: &usize| {
        let column = jacobian.column(*j);
        dot(&column, residuals).abs() <= LEAST_COSINE * length(&column) * size
    };
    free.iter().all(is_level)
}

/// Computes half the sum of squares.
pub(super) fn half_square(residuals: &[f64]) -> f64 {
    0.5 * dot(residuals, residuals)
}

#[cfg(test)]
mod tests {
    use super::{Comparison, DenseMatrix, minimise};

    /// Computes Rosenbrock's valley: 10 (y − x²) and 1 − x.
    fn valley(x: &[f64]) -> Result<Comparison, ()> {
        let residuals = std::vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]];
        let jacobian = DenseMatrix::from_rows(&[[-20.0 * x[0], 10.0], [-1.0, 0.0]]);
        Ok(Comparison { residuals, jacobian })
    }

    const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

    #[test]
    fn the_end_of_a_valley_is_found() {
        let minimum = minimise(std::vec![-1.2, 1.0], &[FREE, FREE], 100, valley).unwrap();
        assert!(minimum.has_converged && minimum.iterations < 30, "{}", minimum.iterations);
        assert!(
            (minimum.values[0] - 1.0).abs() + (minimum.values[1] - 1.0).abs() < 1e-10,
            "{:?}",
            minimum.values
        );
    }

    /// With x ≤ ½ the minimum is (½, ¼). With y ≥ 1.5 it minimises 100 (1.5 − x²)² + (1 − x)².
    #[test]
    fn bounds_hold() {
        let minimum = minimise(std::vec![-1.2, 1.0], &[(-2.0, 0.5), FREE], 100, valley).unwrap();
        assert_eq!(minimum.values[0], 0.5);
        assert!(minimum.has_converged && (minimum.values[1] - 0.25).abs() < 1e-12);
        let minimum = minimise(std::vec![1.0, 2.0], &[FREE, (1.5, 9.0)], 100, valley).unwrap();
        let x = minimum.values[0];
        assert_eq!(minimum.values[1], 1.5);
        assert!(minimum.has_converged && (200.0 * x * x * x - 299.0 * x - 1.0).abs() < 1e-6, "{x}");
    }

    /// Steps to points without residuals are shortened.
    #[test]
    fn steps_stay_where_there_are_residuals() {
        let cliff = |x: &[f64]| if x[0] > 0.9 { Err(()) } else { valley(x) };
        let minimum = minimise(std::vec![-1.2, 1.0], &[FREE, FREE], 200, cliff).unwrap();
        assert!(minimum.values[0] > 0.8, "{:?}", minimum.values);
        assert!(minimise(std::vec![1.2, 1.0], &[FREE, FREE], 100, cliff).is_err());
    }
}
