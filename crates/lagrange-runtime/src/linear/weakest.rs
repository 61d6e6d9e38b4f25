//! Controllability of modes by inputs, and their observability by outputs.
//!
//! An eigenvalue λ is controllable if [A − λI, B] has full rank (Hautus, *Controllability and
//! observability conditions of linear autonomous systems*, Indag. Math. 31 (1969) 443–448). The
//! smallest singular value is the distance from an uncontrollable system (Eising, *Between
//! controllable and uncontrollable*, Syst. Control Lett. 4 (1984) 263–264). Observability in the
//! outputs is controllability of Aᵀ by inputs Cᵀ.

use std::fmt::{Display, Formatter, Result as Written};
use std::string::String;
use std::vec::Vec;

use crate::linalg::dense::DenseMatrix;
use crate::linalg::eigenvalues::{balanced, eigenvalues};
use crate::linalg::singular_values::SingularValues;

/// Distances from an uncontrollable system below this, relative to the matrices, are rounding.
const UNCONTROLLABLE: f64 = 1e-10;
/// Entries of a direction below this fraction of the largest are not written.
const UNWRITTEN: f64 = 0.01;

/// The side of a system: inputs or outputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Channel {
    /// Inputs, which control modes.
    Inputs,
    /// Outputs, in which modes are observed.
    Outputs,
}

/// The combination of states that the inputs control least, or that is least observable in the
/// outputs.
#[derive(Clone, PartialEq, Debug)]
pub struct WeakestDirection {
    /// Inputs or outputs.
    pub channel: Channel,
    /// The real and the imaginary part of the eigenvalue of its mode.
    pub eigenvalue: (f64, f64),
    /// The distance from an uncontrollable or unobservable system, relative to the matrices: 0 for
    /// such a system.
    pub distance: f64,
    /// The combination: each state with its magnitude, the largest of which is one. They are equal
    /// in scale, after balancing.
    pub direction: Vec<(String, f64)>,
}

impl WeakestDirection {
    /// True if all modes are controllable, or observable, by more than rounding.
    #[must_use]
    pub fn is_controllable(&self) -> bool {
        self.distance > UNCONTROLLABLE
    }
}

impl Display for WeakestDirection {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let (real, imaginary) = self.eigenvalue;
        let words = match (self.channel, self.is_controllable()) {
            (Channel::Inputs, true) => "the inputs move least",
            (Channel::Inputs, false) => "the inputs do not move",
            (Channel::Outputs, true) => "the outputs show least",
            (Channel::Outputs, false) => "the outputs do not show",
        };
        write!(f, "{words} the mode of the eigenvalue {real:.4}")?;
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

/// Returns the combination of states, among the modes of these eigenvalues, that the inputs B
/// control least. For outputs, A and B are Aᵀ and Cᵀ.
pub(super) fn weakest(
    a: &DenseMatrix,
    b: &DenseMatrix,
    states: &[String],
    channel: Channel,
    is_wanted: impl Fn(&(f64, f64)) -> bool,
) -> Option<WeakestDirection> {
    let (a, scales) = balanced(a.clone());
    let size = a.largest().max(f64::MIN_POSITIVE);
    // Scale each input to the strength of the matrix, so that units of inputs do not matter.
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
    Some(WeakestDirection { channel, eigenvalue, distance, direction })
}

/// Returns [A − λI, B]ᴴ in real numbers: its columns are real and imaginary parts of combinations
/// of rows.
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
