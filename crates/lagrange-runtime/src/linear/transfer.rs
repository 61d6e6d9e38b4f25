//! Transfer functions from one input to one output of a linear model.

use core::fmt::{self, Display, Formatter};
use std::string::{String, ToString};
use std::vec::Vec;

use super::response::TimeResponse;
use crate::linalg::dense::{DenseMatrix, TriangularFactors};

/// Number of frequencies and of times of a response.
const POINTS: usize = 500;
/// Real parts below this fraction of the largest eigenvalue may be rounding.
const ROUNDING: f64 = 1e-12;
/// Factor by which frequencies extend beyond the slowest and the fastest mode.
const BEYOND: f64 = 10.0;

/// The transfer function G(s) = C (s − A)⁻¹ B + D from one input to one output.
#[derive(Clone, PartialEq, Debug)]
pub struct Transfer {
    a: DenseMatrix,
    /// The column of B.
    b: DenseMatrix,
    /// The row of C.
    c: Vec<f64>,
    d: f64,
    /// The name of the input.
    pub input: &'static str,
    /// The name of the output.
    pub output: &'static str,
    /// Units of the input and the output, as far as they are declared.
    pub(super) units: [Option<&'static str>; 2],
}

/// A name that is not an input or not an output of a linear model.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NoSuchChannel {
    /// The name.
    pub name: String,
    /// The existing names.
    pub known: Vec<&'static str>,
}

impl Display for NoSuchChannel {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { name, known } = self;
        write!(f, "the linear model has no `{name}`; it has `{}`", known.join("`, `"))
    }
}

impl core::error::Error for NoSuchChannel {}

impl Transfer {
    /// Selects the row and the column of the matrices A, B, C and D for two names.
    pub(super) fn new(
        [a, b, c, d]: [&DenseMatrix; 4],
        (inputs, input): (&[&'static str], &str),
        (outputs, output): (&[&'static str], &str),
        units: [Option<&'static str>; 2],
    ) -> Result<Transfer, NoSuchChannel> {
        let (from, to) = (place(inputs, input)?, place(outputs, output)?);
        Ok(Transfer {
            a: a.clone(),
            b: DenseMatrix::from_fn(b.rows(), 1, |row, _| b[(row, from)]),
            c: c.row(to).to_vec(),
            d: d[(to, from)],
            input: inputs[from],
            output: outputs[to],
            units,
        })
    }

    /// Computes G(iω) as its real and its imaginary part. It is not finite if the model has an
    /// undamped mode of this frequency.
    #[must_use]
    pub fn at(&self, frequency: f64) -> (f64, f64) {
        let n = self.a.rows();
        // (iω − A)(x + i y) = b is one real system.
        let system = DenseMatrix::from_fn(2 * n, 2 * n, |row, column| match (row < n, column < n) {
            (true, true) => -self.a[(row, column)],
            (false, false) => -self.a[(row - n, column - n)],
            (true, false) => {
                if row == column - n {
                    -frequency
                } else {
                    0.0
                }
            }
            (false, true) => {
                if row - n == column {
                    frequency
                } else {
                    0.0
                }
            }
        });
        let mut right = self.b.column(0);
        right.resize(2 * n, 0.0);
        let Some(factors) = TriangularFactors::new(system, 0.0) else { return (f64::NAN, f64::NAN) };
        let solution = factors.solve(&right);
        let (real, imaginary) = solution.split_at(n);
        (self.seen(real) + self.d, self.seen(imaginary))
    }

    /// Computes C x.
    fn seen(&self, x: &[f64]) -> f64 {
        self.c.iter().zip(x).map(|(c, x)| c * x).sum()
    }

    /// Returns frequencies for plots, evenly on a logarithmic axis. They reach a decade beyond the
    /// slowest and the fastest mode.
    #[must_use]
    pub fn frequencies(&self) -> Vec<f64> {
        let modes = self.a.eigenvalues().unwrap_or_default();
        let sizes = modes.into_iter().map(|(real, imaginary)| real.hypot(imaginary));
        let largest = sizes.clone().fold(0.0, f64::max);
        // A rigid-body mode has the eigenvalue zero, up to rounding.
        let moving = sizes.filter(|size| *size > 1e-7 * largest);
        let smallest = moving.fold(f64::INFINITY, f64::min);
        let (from, to) = if largest > 0.0 { (smallest / BEYOND, largest * BEYOND) } else { (0.01, 100.0) };
        let ratio = (to / from).ln() / (POINTS - 1) as f64;
        (0..POINTS).map(|index| from * (ratio * index as f64).exp()).collect()
    }

    /// Computes the output from the state zero until a time, after the input has jumped to one. It
    /// is exact at its 500 samples. `None` if the time is not positive, or if the states overflow.
    #[must_use]
    pub fn step_response(&self, until: f64) -> Option<TimeResponse> {
        let zero = std::vec![0.0; self.a.rows()];
        self.response(until, zero, 1.0)
    }

    /// Computes the output after an impulse of area one, without the impulse that D adds at zero.
    /// `None` as for [`step_response`](Self::step_response).
    #[must_use]
    pub fn impulse_response(&self, until: f64) -> Option<TimeResponse> {
        self.response(until, self.b.column(0), 0.0)
    }

    fn response(&self, until: f64, mut state: Vec<f64>, input: f64) -> Option<TimeResponse> {
        let period = until / (POINTS - 1) as f64;
        if period.is_nan() || period <= 0.0 {
            return None;
        }
        let (a, b) = super::sampled::held(&self.a, &self.b, period)?;
        let mut values = Vec::with_capacity(POINTS);
        for _ in 0..POINTS {
            values.push(self.seen(&state) + self.d * input);
            let next = |row: usize| {
                let kept = a.row(row).iter().zip(&state).map(|(a, x)| a * x).sum::<f64>();
                kept + b[(row, 0)] * input
            };
            state = (0..state.len()).map(next).collect();
        }
        let times = (0..POINTS).map(|index| index as f64 * period).collect();
        let limit = self.limit().map(|gain| gain * input);
        let (names, [_, unit]) = ((self.input, self.output), self.units);
        let is_finite = values.iter().all(|value| value.is_finite());
        is_finite.then_some(TimeResponse { names, unit, times, values, limit })
    }

    /// Returns the output for an input of one after all motion has decayed; `None` if it does not
    /// decay.
    fn limit(&self) -> Option<f64> {
        let modes = self.a.eigenvalues()?;
        let largest = modes.iter().map(|(real, imaginary)| real.hypot(*imaginary)).fold(0.0, f64::max);
        let decays = modes.iter().all(|(real, _)| *real < -ROUNDING * largest);
        decays.then(|| self.at(0.0).0)
    }
}

fn place(known: &[&'static str], name: &str) -> Result<usize, NoSuchChannel> {
    let place = known.iter().position(|known| *known == name);
    place.ok_or_else(|| NoSuchChannel { name: name.to_string(), known: known.to_vec() })
}
