//! Estimates of base parameters by weighted least squares.

use std::fmt::{Display, Formatter, Result as Written};
use std::vec::Vec;

use super::base::{BaseParameter, BaseParameters, six_digits};
use crate::linalg::dense::DenseMatrix;
use crate::linalg::independent::IndependentColumns;
use crate::linalg::singular_values::{dot, length};

/// Remainder of columns below which they count as dependent; these are known to be independent.
const NOTHING: f64 = 0.0;
/// Maximum number of solutions to find the weights.
const MAX_WEIGHINGS: usize = 30;
/// Relative change of the weights below which they are final.
const SETTLED: f64 = 1e-4;
/// Fewer degrees of freedom than this are rounding: residuals then say nothing of the noise.
const LEAST_DEGREES: f64 = 1e-6;

/// The estimate of a combination of parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct EstimatedValue {
    /// The combination.
    pub parameter: BaseParameter,
    /// Its value by the parameters of the system.
    pub known: f64,
    /// Its value by the forces.
    pub value: f64,
    /// The standard error of the estimated value.
    pub standard_error: f64,
}

/// Parameters estimated from forces.
#[derive(Clone, Debug)]
pub struct Estimate {
    names: &'static [&'static str],
    values: Vec<EstimatedValue>,
    covariance: DenseMatrix,
    parameters: Vec<f64>,
    noise: Vec<f64>,
    without_effect: Vec<&'static str>,
}

impl Estimate {
    pub(super) fn of(
        names: &'static [&'static str],
        known: &[f64],
        (columns, forces): (&[Vec<f64>], &[f64]),
        velocities: usize,
        base: &BaseParameters,
    ) -> Estimate {
        let places = base.parameters().iter().map(|parameter| parameter.places[0]).collect::<Vec<_>>();
        let columns = places.iter().map(|&place| &columns[place]).collect::<Vec<_>>();
        let equations = Equations { columns: &columns, forces, velocities };
        let (solution, noise) = equations.solve_weighted();
        let values = base.parameters().iter().zip(&solution.values).enumerate();
        let values = values.map(|(index, (parameter, &value))| EstimatedValue {
            parameter: parameter.clone(),
            known: parameter.value(known),
            value,
            standard_error: solution.covariance[(index, index)].sqrt(),
        });
        let values = values.collect::<Vec<_>>();
        let mut parameters = known.to_vec();
        for (place, estimated) in places.into_iter().zip(&values) {
            // The others of the combination keep their values.
            parameters[place] += estimated.value - estimated.known;
        }
        let without_effect = base.without_effect().to_vec();
        Estimate { names, values, covariance: solution.covariance, parameters, noise, without_effect }
    }

    /// Returns the estimated combinations.
    #[must_use]
    pub fn values(&self) -> &[EstimatedValue] {
        &self.values
    }

    /// Returns the estimate of a parameter that forces determine by itself; `None` for any other.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<f64> {
        let is_it =
            |value: &&EstimatedValue| matches!(value.parameter.terms[..], [(only, _)] if only == name);
        self.values.iter().find(is_it).map(|value| value.value)
    }

    /// Returns the covariance of the estimated combinations.
    #[must_use]
    pub fn covariance(&self) -> &DenseMatrix {
        &self.covariance
    }

    /// Returns all parameters, in the order of
    /// [`REGRESSOR_PARAMETERS`](crate::system::RegressorSystem::REGRESSOR_PARAMETERS). The first of
    /// each combination makes up for the estimate, and all others have the values of the system. Y
    /// times these are the forces that belong to the estimate.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Returns the noise level of the force of each velocity, from its residuals.
    #[must_use]
    pub fn noise(&self) -> &[f64] {
        &self.noise
    }

    /// Returns the names of all parameters.
    #[must_use]
    pub fn names(&self) -> &'static [&'static str] {
        self.names
    }
}

impl Display for Estimate {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        for EstimatedValue { parameter, known, value, standard_error } in &self.values {
            let [value, known] = [value, known].map(|number| six_digits(*number));
            writeln!(f, "{value:>12?} ± {standard_error:<10.2e} ({known:?})  {parameter}")?;
        }
        match self.without_effect.is_empty() {
            true => Ok(()),
            false => writeln!(f, "without effect: {}", self.without_effect.join(", ")),
        }
    }
}

/// Returns weights of forces with these levels of noise; those without noise count like the best
/// others.
fn weights(noise: &[f64]) -> Vec<f64> {
    let least =
        noise.iter().filter(|level| **level > 0.0).fold(f64::INFINITY, |least, level| least.min(*level));
    let least = if least.is_finite() { least } else { 1.0 };
    noise.iter().map(|level| 1.0 / level.max(least)).collect()
}

/// Equations for independent columns.
struct Equations<'a> {
    columns: &'a [&'a Vec<f64>],
    forces: &'a [f64],
    velocities: usize,
}

struct Solution {
    values: Vec<f64>,
    covariance: DenseMatrix,
}

impl Equations<'_> {
    /// Returns the least squares with a weight for the force of each velocity, and the covariance
    /// for weights that are reciprocal levels of noise.
    fn solve(&self, weights: &[f64]) -> Solution {
        let weighted = |column: &[f64]| {
            let entries = column.iter().enumerate();
            entries.map(|(row, entry)| entry * weights[row % self.velocities]).collect::<Vec<_>>()
        };
        let columns = self.columns.iter().map(|column| weighted(column)).collect::<Vec<_>>();
        let lengths = columns.iter().map(|column| length(column)).collect::<Vec<_>>();
        let unit = columns.into_iter().zip(&lengths);
        let unit = unit.map(|(column, length)| column.into_iter().map(|entry| entry / length).collect());
        let factors = IndependentColumns::of(unit.collect(), NOTHING);
        let (amounts, gram) = (factors.combination(weighted(self.forces)), factors.inverse_gram());
        let count = lengths.len();
        let (mut values, mut covariance) = (std::vec![0.0; count], DenseMatrix::zeros(count, count));
        for (i, &place) in factors.independent().iter().enumerate() {
            values[place] = amounts[i] / lengths[place];
            for (j, &other) in factors.independent().iter().enumerate() {
                covariance[(place, other)] = gram[(i, j)] / (lengths[place] * lengths[other]);
            }
        }
        Solution { values, covariance }
    }

    /// Solves until the weights are those of the noise that residuals show. Returns its levels,
    /// too.
    fn solve_weighted(&self) -> (Solution, Vec<f64>) {
        let mut weighing = std::vec![1.0; self.velocities];
        let mut solution = self.solve(&weighing);
        let mut noise = self.noise(&solution, &weighing);
        for _ in 0..MAX_WEIGHINGS {
            weighing = weights(&noise);
            solution = self.solve(&weighing);
            let next = self.noise(&solution, &weighing);
            let is_settled = noise.iter().zip(&next).all(|(old, new)| (old - new).abs() <= SETTLED * old);
            noise = next;
            if is_settled {
                break;
            }
        }
        if noise.iter().all(|level| *level == 0.0) {
            // Nothing is wrong with forces that are met exactly, whatever their weights.
            let count = solution.values.len();
            solution.covariance = DenseMatrix::zeros(count, count);
        }
        (solution, noise)
    }

    /// Returns the noise level of the force of each velocity, from its residuals. What the solution
    /// takes of them is the trace of its part of the projection onto the columns.
    fn noise(&self, Solution { values, covariance }: &Solution, weights: &[f64]) -> Vec<f64> {
        let mut squares = std::vec![0.0; self.velocities];
        let mut degrees = std::vec![0.0; self.velocities];
        for (row, force) in self.forces.iter().enumerate() {
            let entries = self.columns.iter().map(|column| column[row]).collect::<Vec<_>>();
            let velocity = row % self.velocities;
            squares[velocity] += (force - dot(&entries, values)).powi(2);
            let spread = (0..values.len()).map(|i| entries[i] * dot(covariance.row(i), &entries));
            degrees[velocity] += 1.0 - weights[velocity].powi(2) * spread.sum::<f64>();
        }
        let level = |(square, degrees): (f64, f64)| {
            if degrees > LEAST_DEGREES { (square / degrees).sqrt() } else { 0.0 }
        };
        squares.into_iter().zip(degrees).map(level).collect()
    }
}
