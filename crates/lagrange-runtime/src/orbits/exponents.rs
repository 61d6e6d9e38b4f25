//! Lyapunov exponents.
//!
//! The exponents are the mean rates at which the axes of a small ball of states grow. Vectors are
//! propagated by the derivatives of the motion, interval by interval. After each interval they are
//! made orthogonal, and the logarithms of their lengths are accumulated. Sources: Benettin,
//! Galgani, Giorgilli, Strelcyn, "Lyapunov characteristic exponents for smooth dynamical systems",
//! *Meccanica* 15 (1980) 9–30; Wolf, Swift, Swinney, Vastano, *Physica D* 16 (1985) 285–317.
//!
//! If the rates have the divergence −c, the exponents have the sum −c. Exponents of a Hamiltonian
//! system come in pairs ±λ.

use std::vec::Vec;

use super::error::OrbitError;
use super::flow::flow;
use crate::linalg::dense::DenseMatrix;
use crate::linalg::singular_values::{dot, length};
use crate::system::{OdeSystem, ParametricSystem};

/// Default error tolerance of integration steps.
const TOLERANCE: f64 = 1e-10;

/// A computation of Lyapunov exponents.
#[must_use = "nothing is computed before `run`"]
pub struct LyapunovSearch<'a, M, const N: usize> {
    system: &'a M,
    start: [f64; N],
    from: f64,
    transient: usize,
    tolerance: f64,
}

impl<'a, M, const N: usize> LyapunovSearch<'a, M, N>
where
    M: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]>,
{
    pub(super) fn new(system: &'a M, start: [f64; N]) -> Self {
        LyapunovSearch { system, start, from: 0.0, transient: 0, tolerance: TOLERANCE }
    }

    /// Starts at this time instead of 0.
    pub fn from(self, time: f64) -> Self {
        LyapunovSearch { from: time, ..self }
    }

    /// Omits this many initial intervals, in which the motion and the vectors settle.
    pub fn transient(self, intervals: usize) -> Self {
        LyapunovSearch { transient: intervals, ..self }
    }

    /// Sets the error tolerance of integration steps, 1e-10 by default.
    pub fn tolerance(self, tolerance: f64) -> Self {
        LyapunovSearch { tolerance, ..self }
    }

    /// Computes the exponents, the largest first, over `intervals` intervals of length `interval`.
    /// Within an interval, vectors must not grow so much that they are parallel up to rounding.
    /// This limits it to a few times the reciprocal of the largest exponent.
    ///
    /// # Errors
    /// If a motion fails, or a setting is invalid.
    pub fn run(self, interval: f64, intervals: usize) -> Result<Vec<f64>, OrbitError> {
        if !(interval > 0.0 && interval.is_finite()) || intervals == 0 {
            return Err(OrbitError::Setting("there must be intervals, of a positive length"));
        }
        let (mut state, mut vectors, mut sums) = (self.start, DenseMatrix::identity(N), std::vec![0.0; N]);
        for index in 0..self.transient + intervals {
            let time = |index: usize| self.from + interval * index as f64;
            let end = flow(self.system, &state, [time(index), time(index + 1)], self.tolerance)?;
            (state, vectors) = (end.state, end.matrix.times(&vectors));
            let lengths = orthonormalise(&mut vectors);
            if index >= self.transient {
                sums.iter_mut().zip(lengths).for_each(|(sum, length)| *sum += length.ln());
            }
        }
        let mut exponents =
            sums.into_iter().map(|sum| sum / (interval * intervals as f64)).collect::<Vec<_>>();
        exponents.sort_by(|a, b| b.total_cmp(a));
        Ok(exponents)
    }
}

/// Orthonormalises columns, and returns the length of each one's component orthogonal to those to
/// its left. Done twice, since rounding of long columns remains after the first pass.
fn orthonormalise(vectors: &mut DenseMatrix) -> Vec<f64> {
    let mut done = Vec::<Vec<f64>>::new();
    let mut lengths = Vec::new();
    for j in 0..vectors.columns() {
        let mut column = vectors.column(j);
        for other in done.iter().chain(&done) {
            let share = dot(&column, other);
            column.iter_mut().zip(other).for_each(|(entry, other)| *entry -= share * other);
        }
        let size = length(&column);
        column.iter_mut().for_each(|entry| *entry /= size);
        lengths.push(size);
        done.push(column);
    }
    *vectors = DenseMatrix::from_fn(vectors.rows(), done.len(), |i, j| done[j][i]);
    lengths
}
