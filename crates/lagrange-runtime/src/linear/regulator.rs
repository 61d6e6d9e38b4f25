//! Linear-quadratic regulators, and how well inputs move what they must stabilise.
//!
//! The feedback u = −K x minimises ∫ (xᵀQx + uᵀRu) dt for K = R⁻¹BᵀX. Here X is the stabilising
//! solution of AᵀX + XA − XGX + Q = 0 with G = BR⁻¹Bᵀ. The matrix sign S of the
//! Hamiltonian matrix H = [A −G; −Q −Aᵀ] determines it: (S + I) [I; X] = 0. S is the limit of Z ←
//! (cZ + (cZ)⁻¹)/2 from H, with c = |det Z|^(−1/2n). One step of Newton's method removes what
//! rounding leaves; its Lyapunov equation is solved by the same iteration. Sources: Roberts,
//! *Linear model reduction and solution of the algebraic Riccati equation by use of the sign
//! function*, Int. J. Control 32 (1980) 677–687; Byers, *Solving the algebraic Riccati equation
//! with the matrix sign function*, Linear Algebra Appl. 85 (1987) 267–279; Kleinman, *On an
//! iterative technique for Riccati equation computations*, IEEE Trans. Autom. Control 13 (1968)
//! 114–115.
//!
//! Example: of ẋ = x + u with Q = 3 and R = 1, H = [1 −1; −3 −1] has the eigenvalues ±2, and its
//! sign is H/2. Then (S + I) [1; X] = [3/2 − X/2; −3/2 + X/2] vanishes for X = 3. The feedback u =
//! −3 x leads to the pole −2.
//!
//! An eigenvalue λ is controllable if [A − λI, B] has full rank (Hautus, *Controllability and
//! observability conditions of linear autonomous systems*, Indag. Math. 31 (1969) 443–448). Its
//! smallest singular value is the distance from where it is not (Eising, *Between controllable and
//! uncontrollable*, Syst. Control Lett. 4 (1984) 263–264).

use std::fmt::{Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use crate::linalg::dense::{DenseMatrix, TriangularFactors};
use crate::linalg::eigenvalues::{balanced, eigenvalues};
use crate::linalg::singular_values::SingularValues;

/// Iterations for a matrix sign; eight or nine are usual.
const MAX_ITERATIONS: usize = 60;
/// Beside the matrices, a smaller distance from an uncontrollable system is rounding.
const UNCONTROLLABLE: f64 = 1e-10;
/// Entries of a direction that are smaller beside the largest are not written.
const UNWRITTEN: f64 = 0.01;

/// The feedback u = −K x that minimises a quadratic cost.
#[derive(Clone, PartialEq, Debug)]
pub struct Regulator {
    /// K, with a row for each input and a column for each state.
    pub gain: DenseMatrix,
    /// X, the cost xᵀXx of a start from x.
    pub cost: DenseMatrix,
    /// A − B K
    pub closed_loop: DenseMatrix,
}

/// The cause of a regulator that does not exist.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum RegulatorError {
    /// The weights of the states or of the inputs have another size than these.
    Size {
        /// The number of rows and columns that they must have.
        expected: usize,
        /// True for the weights of the inputs.
        of_inputs: bool,
    },
    /// Weights of the states are not symmetric with eigenvalues from 0 on, or weights of the inputs
    /// are not symmetric with positive eigenvalues.
    NotPositive {
        /// True for the weights of the inputs.
        of_inputs: bool,
    },
    /// No input stabilises this mode.
    NotStabilisable(WeakestDirection),
    /// The states that the weights contain do not show a mode that neither grows nor decays.
    NotDetectable,
}

impl Display for RegulatorError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let name = |of_inputs: &bool| if *of_inputs { "inputs" } else { "states" };
        match self {
            RegulatorError::Size { expected, of_inputs } => {
                write!(f, "the weights of the {} must have {expected} rows and columns", name(of_inputs))
            }
            RegulatorError::NotPositive { of_inputs } => {
                let sign = if *of_inputs { "positive" } else { "not negative" };
                write!(
                    f,
                    "the weights of the {} must be symmetric with eigenvalues that are {sign}",
                    name(of_inputs)
                )
            }
            RegulatorError::NotStabilisable(weakest) => {
                write!(f, "no feedback stabilises the system: {weakest}")
            }
            RegulatorError::NotDetectable => {
                write!(f, "a mode that neither grows nor decays has no weight: give weights to more states")
            }
        }
    }
}

impl std::error::Error for RegulatorError {}

/// The combination of states that the inputs move least.
#[derive(Clone, PartialEq, Debug)]
pub struct WeakestDirection {
    /// The real and the imaginary part of the eigenvalue of its mode.
    pub eigenvalue: (f64, f64),
    /// The distance from a system in which the inputs do not move it, relative to the matrices: 0
    /// if they do not.
    pub distance: f64,
    /// The combination: each state with its magnitude, the largest of which is one. They are equal
    /// in scale, after balancing.
    pub direction: Vec<(String, f64)>,
}

impl WeakestDirection {
    /// True if the inputs move all modes by more than rounding.
    #[must_use]
    pub fn is_controllable(&self) -> bool {
        self.distance > UNCONTROLLABLE
    }
}

impl Display for WeakestDirection {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let (real, imaginary) = self.eigenvalue;
        let verb = if self.is_controllable() { "move least" } else { "do not move" };
        write!(f, "the inputs {verb} the mode of the eigenvalue {real:.4}")?;
        if imaginary != 0.0 {
            write!(f, " ± {imaginary:.4} i")?;
        }
        write!(f, ", which consists of")?;
        let seen = self.direction.iter().filter(|(_, part)| *part > UNWRITTEN);
        for (index, (name, part)) in seen.enumerate() {
            write!(f, "{} {part:.2} `{name}`", if index == 0 { "" } else { "," })?;
        }
        Ok(())
    }
}

/// The regulator of ẋ = A x + B u with the weights Q and R.
pub(super) fn regulator(
    (a, b): (&DenseMatrix, &DenseMatrix),
    (q, r): (&DenseMatrix, &DenseMatrix),
    states: &[String],
) -> Result<Regulator, RegulatorError> {
    check(q, a.rows(), false)?;
    check(r, b.columns(), true)?;
    let error = || not_stabilisable(a, b, states);
    let not_positive = RegulatorError::NotPositive { of_inputs: true };
    let inverse = TriangularFactors::new(r.clone(), 0.0).ok_or(not_positive)?;
    let to_inputs = inverse.solve_columns(&b.transposed());
    let g = b.times(&to_inputs);
    let cost = riccati(a, &g, q).ok_or_else(error)?;
    let gain = to_inputs.times(&cost);
    let closed_loop = a.plus(-1.0, &b.times(&gain));
    let poles = eigenvalues(&closed_loop).ok_or_else(error)?;
    match poles.iter().all(|(real, _)| *real < 0.0) {
        true => Ok(Regulator { gain, cost, closed_loop }),
        false => Err(error()),
    }
}

fn check(weights: &DenseMatrix, expected: usize, of_inputs: bool) -> Result<(), RegulatorError> {
    if (weights.rows(), weights.columns()) != (expected, expected) {
        return Err(RegulatorError::Size { expected, of_inputs });
    }
    let is_symmetric = *weights == weights.transposed();
    let least = -1e-12 * weights.largest();
    let is_weight = |(real, _): &(f64, f64)| if of_inputs { *real > 0.0 } else { *real >= least };
    match eigenvalues(weights) {
        Some(found) if is_symmetric && found.iter().all(is_weight) => Ok(()),
        _ => Err(RegulatorError::NotPositive { of_inputs }),
    }
}

/// The stabilising solution of AᵀX + XA − XGX + Q = 0, if there is one.
fn riccati(a: &DenseMatrix, g: &DenseMatrix, q: &DenseMatrix) -> Option<DenseMatrix> {
    let n = a.rows();
    let hamiltonian = DenseMatrix::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => a[(i, j)],
        (true, false) => -g[(i, j - n)],
        (false, true) => -q[(i - n, j)],
        (false, false) => -a[(j - n, i - n)],
    });
    let (sign, _) = sign(hamiltonian, None)?;
    let shifted = sign.plus(1.0, &DenseMatrix::identity(2 * n));
    let (all, first, last) = (0..2 * n, 0..n, n..2 * n);
    let part = |columns: core::ops::Range<usize>| {
        shifted.part(&all.clone().collect::<Vec<_>>(), &columns.collect::<Vec<_>>())
    };
    let (known, unknown) = (part(first), SingularValues::of(&part(last))?);
    let columns = (0..n).map(|j| unknown.shortest(&known.column(j), f64::EPSILON)).collect::<Vec<_>>();
    let x = DenseMatrix::from_fn(n, n, |i, j| -(columns[j][i] + columns[i][j]) / 2.0);
    let residual = a.transposed().times(&x).plus(1.0, &x.times(a)).plus(1.0, q);
    let residual = residual.plus(-1.0, &x.times(g).times(&x));
    let closed = a.plus(-1.0, &g.times(&x));
    let change = lyapunov(closed, residual)?;
    let x = x.plus(1.0, &change);
    Some(x.plus(1.0, &x.transposed()).scaled(0.5)).filter(DenseMatrix::is_finite)
}

/// The solution of AᵀX + XA + Q = 0 with eigenvalues of A to the left: with the sign of A, −I, Q
/// becomes 2 X.
fn lyapunov(a: DenseMatrix, q: DenseMatrix) -> Option<DenseMatrix> {
    let (_, doubled) = sign(a, Some(q))?;
    doubled.map(|doubled| doubled.scaled(0.5))
}

/// The sign of a matrix without eigenvalues on the imaginary axis, and what becomes of Q under Q ←
/// (cQ + Z⁻ᵀQZ⁻¹/c)/2.
fn sign(mut z: DenseMatrix, mut q: Option<DenseMatrix>) -> Option<(DenseMatrix, Option<DenseMatrix>)> {
    let identity = DenseMatrix::identity(z.rows());
    let mut is_last = false;
    for _ in 0..MAX_ITERATIONS {
        let factors = TriangularFactors::new(z.clone(), 0.0)?;
        let inverse = factors.solve_columns(&identity);
        // Near the limit scaling would only disturb.
        let c = if is_last { 1.0 } else { (-factors.mean_log()).exp() };
        let next = z.scaled(c / 2.0).plus(0.5 / c, &inverse);
        q = q.map(|q| q.scaled(c / 2.0).plus(0.5 / c, &inverse.transposed().times(&q).times(&inverse)));
        let (change, size) = (next.plus(-1.0, &z).largest(), next.largest());
        z = next;
        if !size.is_finite() {
            return None;
        }
        if is_last && change <= f64::EPSILON.sqrt() * size {
            return Some((z, q));
        }
        is_last = change <= 1e-3 * size;
    }
    None
}

/// The mode that does not decay by itself and that the inputs move least, if they do not move it.
fn not_stabilisable(a: &DenseMatrix, b: &DenseMatrix, states: &[String]) -> RegulatorError {
    let growing = weakest(a, b, states, |(real, _)| *real > -f64::EPSILON.sqrt() * a.largest());
    match growing {
        Some(weakest) if !weakest.is_controllable() => RegulatorError::NotStabilisable(weakest),
        _ => RegulatorError::NotDetectable,
    }
}

/// The combination of states, among the modes of these eigenvalues, that the inputs move least.
pub(super) fn weakest(
    a: &DenseMatrix,
    b: &DenseMatrix,
    states: &[String],
    is_wanted: impl Fn(&(f64, f64)) -> bool,
) -> Option<WeakestDirection> {
    let (a, scales) = balanced(a.clone());
    let size = a.largest().max(f64::MIN_POSITIVE);
    // Each input as strong as the matrix: units of inputs do not matter.
    let strength = |j: usize| (0..b.rows()).fold(0.0, |most: f64, i| most.max((b[(i, j)] / scales[i]).abs()));
    let b = DenseMatrix::from_fn(b.rows(), b.columns(), |i, j| {
        let strength = strength(j);
        if strength > 0.0 { b[(i, j)] / scales[i] * (size / strength) } else { 0.0 }
    });
    let found = eigenvalues(&a)?.into_iter().filter(|value| value.1 >= 0.0 && is_wanted(value));
    let all = found.filter_map(|eigenvalue| {
        let values = SingularValues::of(&pencil(&a, &b, eigenvalue))?;
        let distance = values.values().last()? / size;
        Some((eigenvalue, distance, values.weakest()?.to_vec()))
    });
    let (eigenvalue, distance, direction) = all.min_by(|one, other| one.1.total_cmp(&other.1))?;
    let n = a.rows();
    let sizes = (0..n).map(|i| direction[i].hypot(direction[n + i])).collect::<Vec<_>>();
    let largest = sizes.iter().fold(0.0, |most: f64, size| most.max(*size));
    let direction = states.iter().cloned().zip(sizes.into_iter().map(|size| size / largest)).collect();
    Some(WeakestDirection { eigenvalue, distance, direction })
}

/// [A − λI, B]ᴴ in real numbers: its columns are real and imaginary parts of combinations of rows.
fn pencil(a: &DenseMatrix, b: &DenseMatrix, (real, imaginary): (f64, f64)) -> DenseMatrix {
    let (n, m) = (a.rows(), b.columns());
    DenseMatrix::from_fn(2 * (n + m), 2 * n, |row, column| {
        let (is_imaginary, row) = (row >= n + m, row % (n + m));
        let (of_imaginary, state) = (column >= n, column % n);
        let is_diagonal = row == state;
        match (is_imaginary == of_imaginary, row < n) {
            (true, true) if is_diagonal => a[(state, row)] - real,
            (true, true) => a[(state, row)],
            (true, false) => b[(state, row - n)],
            (false, true) if is_diagonal && is_imaginary => imaginary,
            (false, true) if is_diagonal => -imaginary,
            (false, _) => 0.0,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, RegulatorError, regulator};
    use std::string::{String, ToString};
    use std::vec::Vec;

    fn names(count: usize) -> Vec<String> {
        (0..count).map(|index| std::format!("x{index}")).collect()
    }

    #[test]
    fn the_worked_example_holds() {
        let [a, b, q] = [1.0, 1.0, 3.0].map(|entry| DenseMatrix::from_rows(&[[entry]]));
        let found = regulator((&a, &b), (&q, &b), &names(1)).expect("a regulator");
        for (found, wanted) in [(&found.cost, 3.0), (&found.gain, 3.0), (&found.closed_loop, -2.0)] {
            assert!((found[(0, 0)] - wanted).abs() < 1e-14, "{found:?}");
        }
    }

    #[test]
    fn what_inputs_do_not_move_is_named() {
        // The second state grows by itself.
        let a = DenseMatrix::from_rows(&[[0.0, 0.0], [0.0, 2.0]]);
        let b = DenseMatrix::from_rows(&[[1.0], [0.0]]);
        let (q, r) = (DenseMatrix::identity(2), DenseMatrix::identity(1));
        let error = regulator((&a, &b), (&q, &r), &names(2)).expect_err("it grows");
        assert_eq!(
            error.to_string(),
            "no feedback stabilises the system: the inputs do not move the mode of the eigenvalue 2.0000, which consists of 1.00 `x1`"
        );
        // Where it decays by itself it does not matter.
        let a = DenseMatrix::from_rows(&[[0.0, 0.0], [0.0, -2.0]]);
        let found = regulator((&a, &b), (&q, &r), &names(2)).expect("a regulator");
        assert!((found.gain[(0, 0)] - 1.0).abs() < 1e-14 && found.gain[(0, 1)].abs() < 1e-14);
    }

    #[test]
    fn weights_are_checked() {
        let one = DenseMatrix::identity(1);
        let with = |q: &DenseMatrix, r: &DenseMatrix| regulator((&one, &one), (q, r), &names(1)).err();
        assert_eq!(
            with(&DenseMatrix::identity(2), &one),
            Some(RegulatorError::Size { expected: 1, of_inputs: false })
        );
        assert_eq!(with(&one, &one.scaled(-1.0)), Some(RegulatorError::NotPositive { of_inputs: true }));
        assert_eq!(with(&one, &one.scaled(0.0)), Some(RegulatorError::NotPositive { of_inputs: true }));
        assert_eq!(with(&one.scaled(f64::NAN), &one), Some(RegulatorError::NotPositive { of_inputs: false }));
        // An integrator that nothing asks to return.
        let zero = one.scaled(0.0);
        let error = regulator((&zero, &one), (&zero, &one), &names(1)).err();
        assert_eq!(error, Some(RegulatorError::NotDetectable));
    }
}
