//! Linear-quadratic regulators and observers, in continuous and in discrete time.
//!
//! The feedback u = −K x minimises ∫ (xᵀQx + uᵀRu) dt for K = R⁻¹BᵀX, where X solves a [Riccati
//! equation](super::riccati) with G = BR⁻¹Bᵀ. In discrete time it minimises Σ (xᵀQx + uᵀRu) for K =
//! (R + BᵀXB)⁻¹BᵀXA. An observer is the regulator of the dual system, with Aᵀ and Cᵀ in place of A
//! and B. Its gain is Kᵀ. Source: Kwakernaak, Sivan, *Linear Optimal Control Systems*, 1972, §§3,
//! 4, 6.

use std::fmt::{Debug, Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use super::riccati;
use super::tables::NamedMatrix;
use super::weakest::{Channel, WeakestDirection, weakest};
use crate::linalg::dense::{DenseMatrix, TriangularFactors};
use crate::linalg::eigenvalues::eigenvalues;

/// The feedback u = −K x that minimises a quadratic cost.
#[derive(Clone, PartialEq, Debug)]
pub struct Regulator {
    /// K, with a row for each input and a column for each state.
    pub gain: DenseMatrix,
    /// X; a start from x has the cost xᵀXx.
    pub cost: DenseMatrix,
    /// A − B K
    pub closed_loop: DenseMatrix,
    /// Names of the states: the columns of K.
    pub states: Vec<String>,
    /// Names of the inputs: the rows of K.
    pub inputs: &'static [&'static str],
}

/// Writes the gain K as a table with names. A precision is that of significant digits: `{:.3}`.
impl Display for Regulator {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        NamedMatrix::new("K", &self.gain, self.inputs, &self.states).fmt(f)
    }
}

/// The observer with the minimum variance of the estimated states: the stationary Kalman filter.
#[derive(Clone, PartialEq, Debug)]
pub struct Observer {
    /// L, with a row for each state and a column for each output. The estimate x follows A x + B u +
    /// L (y − C x − D u).
    pub gain: DenseMatrix,
    /// The covariance of the estimation error; in discrete time, before the output is measured.
    pub covariance: DenseMatrix,
    /// A − L C
    pub error_dynamics: DenseMatrix,
    /// Names of the states: the rows of L.
    pub states: Vec<String>,
    /// Names of the outputs: the columns of L.
    pub outputs: &'static [&'static str],
}

/// Writes the gain L as a table with names. A precision is that of significant digits: `{:.3}`.
impl Display for Observer {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        NamedMatrix::new("L", &self.gain, &self.states, self.outputs).fmt(f)
    }
}

/// Design matrices of regulators and observers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DesignMatrix {
    /// Weights of the states in the cost.
    States,
    /// Weights of the inputs in the cost.
    Inputs,
    /// Intensities of disturbances of the states.
    Disturbances,
    /// Intensities of the noise of the outputs.
    Noise,
}

impl DesignMatrix {
    /// True if eigenvalues must be positive, not just nonnegative.
    fn is_definite(self) -> bool {
        matches!(self, DesignMatrix::Inputs | DesignMatrix::Noise)
    }

    fn words(self) -> &'static str {
        match self {
            DesignMatrix::States => "weights of the states",
            DesignMatrix::Inputs => "weights of the inputs",
            DesignMatrix::Disturbances => "intensities of the disturbances",
            DesignMatrix::Noise => "intensities of the noise",
        }
    }
}

/// The reason why a regulator or an observer does not exist.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum DesignError {
    /// The size of a matrix differs from the number of states, inputs or outputs.
    Size {
        /// Required number of rows and columns.
        expected: usize,
        /// The matrix.
        matrix: DesignMatrix,
    },
    /// Weights of states or intensities of disturbances are not symmetric with eigenvalues
    /// from 0 on. Or weights of inputs or intensities of noise are not symmetric with positive
    /// eigenvalues.
    NotPositive {
        /// The matrix.
        matrix: DesignMatrix,
    },
    /// No input stabilises this mode, or it is not observable in any output.
    OutOfReach(WeakestDirection),
    /// A mode that neither grows nor decays is not weighted in the states, or not excited by the
    /// disturbances.
    NotWeighted {
        /// The matrix.
        matrix: DesignMatrix,
    },
}

impl Display for DesignError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        match self {
            DesignError::Size { expected, matrix } => {
                write!(f, "the {} must have {expected} rows and columns", matrix.words())
            }
            DesignError::NotPositive { matrix } => {
                let sign = if matrix.is_definite() { "positive" } else { "not negative" };
                write!(f, "the {} must be symmetric with eigenvalues that are {sign}", matrix.words())
            }
            DesignError::OutOfReach(weakest) => {
                let design = match weakest.channel {
                    Channel::Inputs => "no feedback stabilises the system",
                    Channel::Outputs => "no observer follows the system",
                };
                write!(f, "{design}: {weakest}")
            }
            DesignError::NotWeighted { matrix } => {
                write!(f, "the {} leave out a mode that neither grows nor decays", matrix.words())
            }
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl Debug for DesignError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        write!(f, "DesignError({self})")
    }
}

impl std::error::Error for DesignError {}

/// A system with its modes and how they must decay.
#[derive(Clone, Copy)]
pub(super) struct Plant<'a> {
    pub(super) time: Time,
    pub(super) a: &'a DenseMatrix,
    pub(super) states: &'a [String],
}

/// The kind of time in which a system moves.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Time {
    Continuous,
    Discrete,
}

impl Time {
    fn decays(self, (real, imaginary): (f64, f64)) -> bool {
        match self {
            Time::Continuous => real < 0.0,
            Time::Discrete => real.hypot(imaginary) < 1.0,
        }
    }

    /// True of eigenvalues that do not decay but for rounding.
    fn may_persist(self, (real, imaginary): (f64, f64), size: f64) -> bool {
        match self {
            Time::Continuous => real > -f64::EPSILON.sqrt() * size,
            Time::Discrete => real.hypot(imaginary) > 1.0 - f64::EPSILON.sqrt(),
        }
    }
}

/// Computes the regulator with the weights Q and R.
pub(super) fn regulator(
    plant: Plant<'_>,
    (b, inputs): (&DenseMatrix, &'static [&'static str]),
    q: &DenseMatrix,
    r: &DenseMatrix,
) -> Result<Regulator, DesignError> {
    let Design { gain, cost, closed_loop } =
        design(plant, b, (q, DesignMatrix::States), (r, DesignMatrix::Inputs))?;
    Ok(Regulator { gain, cost, closed_loop, states: plant.states.to_vec(), inputs })
}

/// Computes the observer of the outputs C x for disturbances and noise of the intensities W and V.
pub(super) fn observer(
    plant: Plant<'_>,
    (c, outputs): (&DenseMatrix, &'static [&'static str]),
    w: &DenseMatrix,
    v: &DenseMatrix,
) -> Result<Observer, DesignError> {
    let dual = Plant { a: &plant.a.transposed(), ..plant };
    let Design { gain, cost, closed_loop } =
        design(dual, &c.transposed(), (w, DesignMatrix::Disturbances), (v, DesignMatrix::Noise))?;
    let (gain, error_dynamics) = (gain.transposed(), closed_loop.transposed());
    Ok(Observer { gain, covariance: cost, error_dynamics, states: plant.states.to_vec(), outputs })
}

/// The matrices of a regulator, or of the dual of an observer.
struct Design {
    gain: DenseMatrix,
    cost: DenseMatrix,
    closed_loop: DenseMatrix,
}

fn design(
    plant: Plant<'_>,
    b: &DenseMatrix,
    (q, of_states): (&DenseMatrix, DesignMatrix),
    (r, of_channels): (&DenseMatrix, DesignMatrix),
) -> Result<Design, DesignError> {
    let Plant { time, a, .. } = plant;
    check(q, a.rows(), of_states)?;
    check(r, b.columns(), of_channels)?;
    let error = || out_of_reach(plant, b, of_states);
    let not_positive = DesignError::NotPositive { matrix: of_channels };
    let inverse = TriangularFactors::new(r.clone(), 0.0).ok_or(not_positive)?;
    let to_inputs = inverse.solve_columns(&b.transposed());
    let g = b.times(&to_inputs);
    let (cost, gain) = match time {
        Time::Continuous => {
            let x = riccati::continuous(a, &g, q).ok_or_else(error)?;
            let gain = to_inputs.times(&x);
            (x, gain)
        }
        Time::Discrete => riccati::discrete((a, b), (&g, q, r)).ok_or_else(error)?,
    };
    let closed_loop = a.plus(-1.0, &b.times(&gain));
    let poles = eigenvalues(&closed_loop).ok_or_else(error)?;
    match poles.into_iter().all(|pole| time.decays(pole)) {
        true => Ok(Design { gain, cost, closed_loop }),
        false => Err(error()),
    }
}

fn check(entries: &DenseMatrix, expected: usize, matrix: DesignMatrix) -> Result<(), DesignError> {
    if (entries.rows(), entries.columns()) != (expected, expected) {
        return Err(DesignError::Size { expected, matrix });
    }
    let is_symmetric = *entries == entries.transposed();
    let least = -1e-12 * entries.largest();
    let is_definite = matrix.is_definite();
    let is_weight = |(real, _): &(f64, f64)| if is_definite { *real > 0.0 } else { *real >= least };
    match eigenvalues(entries) {
        Some(found) if is_symmetric && found.iter().all(is_weight) => Ok(()),
        _ => Err(DesignError::NotPositive { matrix }),
    }
}

/// Returns the mode that does not decay by itself and that the inputs move least, if they do not
/// move it.
fn out_of_reach(Plant { time, a, states }: Plant<'_>, b: &DenseMatrix, matrix: DesignMatrix) -> DesignError {
    let size = a.largest();
    let channel = if matrix == DesignMatrix::States { Channel::Inputs } else { Channel::Outputs };
    match weakest(a, b, states, channel, |value| time.may_persist(*value, size)) {
        Some(weakest) if !weakest.is_controllable() => DesignError::OutOfReach(weakest),
        _ => DesignError::NotWeighted { matrix },
    }
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, DesignError, DesignMatrix, Plant, Regulator, Time};
    use std::string::{String, ToString};
    use std::vec::Vec;

    fn names(count: usize) -> Vec<String> {
        (0..count).map(|index| std::format!("x{index}")).collect()
    }

    fn regulator(
        (a, b): (&DenseMatrix, &DenseMatrix),
        (q, r): (&DenseMatrix, &DenseMatrix),
    ) -> Result<Regulator, DesignError> {
        let plant = Plant { time: Time::Continuous, a, states: &names(a.rows()) };
        super::regulator(plant, (b, &["u"]), q, r)
    }

    #[test]
    fn the_worked_example_holds() {
        let [a, b, q] = [1.0, 1.0, 3.0].map(|entry| DenseMatrix::from_rows(&[[entry]]));
        let found = regulator((&a, &b), (&q, &b)).expect("a regulator");
        for (found, wanted) in [(&found.cost, 3.0), (&found.gain, 3.0), (&found.closed_loop, -2.0)] {
            assert!((found[(0, 0)] - wanted).abs() < 1e-14, "{found:?}");
        }
    }

    #[test]
    fn uncontrollable_states_are_named() {
        // The second state grows by itself.
        let a = DenseMatrix::from_rows(&[[0.0, 0.0], [0.0, 2.0]]);
        let b = DenseMatrix::from_rows(&[[1.0], [0.0]]);
        let (q, r) = (DenseMatrix::identity(2), DenseMatrix::identity(1));
        let error = regulator((&a, &b), (&q, &r)).expect_err("it grows");
        assert_eq!(
            error.to_string(),
            "no feedback stabilises the system: the inputs do not move the mode of the eigenvalue 2.0000, which consists of 1.00 `x1`"
        );
        // Where it decays by itself it does not matter.
        let a = DenseMatrix::from_rows(&[[0.0, 0.0], [0.0, -2.0]]);
        let found = regulator((&a, &b), (&q, &r)).expect("a regulator");
        assert!((found.gain[(0, 0)] - 1.0).abs() < 1e-14 && found.gain[(0, 1)].abs() < 1e-14);
    }

    #[test]
    fn weights_are_checked() {
        let one = DenseMatrix::identity(1);
        let with = |q: &DenseMatrix, r: &DenseMatrix| regulator((&one, &one), (q, r)).err();
        assert_eq!(
            with(&DenseMatrix::identity(2), &one),
            Some(DesignError::Size { expected: 1, matrix: DesignMatrix::States })
        );
        assert_eq!(
            with(&one, &one.scaled(-1.0)),
            Some(DesignError::NotPositive { matrix: DesignMatrix::Inputs })
        );
        assert_eq!(
            with(&one, &one.scaled(0.0)),
            Some(DesignError::NotPositive { matrix: DesignMatrix::Inputs })
        );
        assert_eq!(
            with(&one.scaled(f64::NAN), &one),
            Some(DesignError::NotPositive { matrix: DesignMatrix::States })
        );
        // An integrator that nothing asks to return.
        let zero = one.scaled(0.0);
        let error = regulator((&zero, &one), (&zero, &one)).err();
        assert_eq!(error, Some(DesignError::NotWeighted { matrix: DesignMatrix::States }));
    }
}
