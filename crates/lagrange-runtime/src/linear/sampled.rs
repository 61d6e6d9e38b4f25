//! Linear models in discrete time.
//!
//! Inputs are held for a period h. Over h, [A B; 0 0] has the exponential [Aₕ Bₕ; 0 I], and x⁺ = Aₕ
//! x + Bₕ u. The exponential is a Padé approximant of degree 13 of the matrix divided by 2ˢ,
//! squared s times. Sources: Van Loan, *Computing integrals involving the matrix exponential*, IEEE
//! Trans. Autom. Control 23 (1978) 395–404; Higham, *The scaling and squaring method for the matrix
//! exponential revisited*, SIAM J. Matrix Anal. Appl. 26 (2005) 1179–1193.

use std::fmt::{Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use super::regulator::{DesignError, Observer, Plant, Regulator, Time, observer, regulator};
use super::tables::write_model;
use crate::linalg::dense::{DenseMatrix, TriangularFactors};

/// The largest norm for which the approximant is exact up to rounding.
const PADE_NORM: f64 = 5.371_920_351_148_152;
/// Coefficients of the numerator, by powers of the matrix.
const PADE: [f64; 14] = [
    64_764_752_532_480_000.0,
    32_382_376_266_240_000.0,
    7_771_770_303_897_600.0,
    1_187_353_796_428_800.0,
    129_060_195_264_000.0,
    10_559_470_521_600.0,
    670_442_572_800.0,
    33_522_128_640.0,
    1_323_241_920.0,
    40_840_800.0,
    960_960.0,
    16_380.0,
    182.0,
    1.0,
];

/// The linear model x⁺ = A x + B u, y = C x + D u of a system whose inputs are held for a period.
#[derive(Clone, PartialEq, Debug)]
pub struct SampledModel {
    /// The period in units of time.
    pub period: f64,
    /// A: derivatives of the states after a period with respect to the states before.
    pub a: DenseMatrix,
    /// B: derivatives of the states after a period with respect to the inputs.
    pub b: DenseMatrix,
    /// C: derivatives of the outputs with respect to the states, at the beginning of a period.
    pub c: DenseMatrix,
    /// D: derivatives of the outputs with respect to the inputs.
    pub d: DenseMatrix,
    /// The names of the states.
    pub states: Vec<String>,
    /// The names of the inputs.
    pub inputs: &'static [&'static str],
    /// The names of the outputs.
    pub outputs: &'static [&'static str],
}

/// Writes the matrices as tables with names, without empty ones. A precision is that of significant
/// digits.
impl Display for SampledModel {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let matrices = [&self.a, &self.b, &self.c, &self.d];
        write_model(f, matrices, &self.states, (self.inputs, self.outputs))
    }
}

impl SampledModel {
    /// Computes the feedback u = −K x that minimises Σ (xᵀQx + uᵀRu) over all periods.
    ///
    /// # Errors
    /// If weights are not symmetric and positive, or if no feedback stabilises the system.
    pub fn lqr(&self, q: &DenseMatrix, r: &DenseMatrix) -> Result<Regulator, DesignError> {
        regulator(self.plant(), (&self.b, self.inputs), q, r)
    }

    /// Computes the stationary Kalman filter `x⁺ = A x + B u + L (y − C x − D u)`. Each period adds
    /// a disturbance of covariance W to the states, and noise of covariance V to the outputs.
    ///
    /// # Errors
    /// If covariances are not symmetric and positive, or if a growing mode is not observable in the
    /// outputs.
    pub fn observer(&self, w: &DenseMatrix, v: &DenseMatrix) -> Result<Observer, DesignError> {
        observer(self.plant(), (&self.c, self.outputs), w, v)
    }

    fn plant(&self) -> Plant<'_> {
        Plant { time: Time::Discrete, a: &self.a, states: &self.states }
    }
}

/// Returns Aₕ and Bₕ; `None` if they overflow.
pub(super) fn held(a: &DenseMatrix, b: &DenseMatrix, period: f64) -> Option<(DenseMatrix, DenseMatrix)> {
    let (n, m) = (a.rows(), b.columns());
    let both = DenseMatrix::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
        (true, true) => period * a[(i, j)],
        (true, false) => period * b[(i, j - n)],
        (false, _) => 0.0,
    });
    let both = exponential(&both)?;
    let rows = (0..n).collect::<Vec<_>>();
    Some((both.part(&rows, &rows), both.part(&rows, &(n..n + m).collect::<Vec<_>>())))
}

fn exponential(matrix: &DenseMatrix) -> Option<DenseMatrix> {
    let norm = |j: usize| matrix.column(j).iter().map(|entry| entry.abs()).sum::<f64>();
    let norm = (0..matrix.columns()).map(norm).fold(0.0, f64::max);
    if !norm.is_finite() {
        return None;
    }
    let squarings = (norm / PADE_NORM).log2().ceil().clamp(0.0, 2000.0) as i32;
    let scaled = matrix.scaled(0.5_f64.powi(squarings));
    let square = scaled.times(&scaled);
    // Horner's rule for the odd and the even powers.
    let polynomial = |odd: usize| {
        let powers = (0..=6).rev().map(|power| PADE[2 * power + odd]);
        let identity = DenseMatrix::identity(matrix.rows());
        powers.fold(DenseMatrix::zeros(matrix.rows(), matrix.rows()), |sum, coefficient| {
            square.times(&sum).plus(coefficient, &identity)
        })
    };
    let (odd, even) = (scaled.times(&polynomial(1)), polynomial(0));
    let denominator = TriangularFactors::new(even.plus(-1.0, &odd), 0.0)?;
    let approximant = denominator.solve_columns(&even.plus(1.0, &odd));
    let whole = (0..squarings).fold(approximant, |power, _| power.times(&power));
    whole.is_finite().then_some(whole)
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, held};

    #[test]
    fn closed_forms_are_met() {
        // An oscillator under a held force, over angles far beyond the scale.
        for angle in [1e-6, 0.3_f64, 2.0, 40.0, 1000.0] {
            let a = DenseMatrix::from_rows(&[[0.0, 1.0], [-1.0, 0.0]]);
            let b = DenseMatrix::from_rows(&[[0.0], [1.0]]);
            let (a, b) = held(&a, &b, angle).expect("finite");
            let (sine, cosine) = angle.sin_cos();
            let bound = 1e-15 * (4.0 + 4.0 * angle);
            let wanted = [[cosine, sine], [-sine, cosine]];
            for (i, row) in wanted.iter().enumerate() {
                for (j, wanted) in row.iter().enumerate() {
                    assert!((a[(i, j)] - wanted).abs() < bound, "{angle}: {a:?}");
                }
            }
            let by_force = [2.0 * (angle / 2.0).sin().powi(2), sine];
            assert!((0..2).all(|i| (b[(i, 0)] - by_force[i]).abs() < bound), "{angle}: {b:?}");
        }
        // Chains of integrators are exact.
        let a = DenseMatrix::from_rows(&[[0.0, 1.0], [0.0, 0.0]]);
        let (a, b) = held(&a, &DenseMatrix::from_rows(&[[0.0], [1.0]]), 0.5).expect("finite");
        assert!((a[(0, 1)] - 0.5).abs() < 1e-16 && (b[(0, 0)] - 0.125).abs() < 1e-16);
        let growing = DenseMatrix::from_rows(&[[1e6]]);
        assert!(held(&growing, &DenseMatrix::identity(1), 1.0).is_none());
    }
}
