//! Singular value decomposition by one-sided Jacobi rotations, and its applications.
//!
//! Rotations of pairs of columns make all columns of A V orthogonal: A V = U Σ. Small singular
//! values keep their relative accuracy if the columns differ only in scale. Sources: Hestenes,
//! *Inversion of matrices by biorthogonalization and related results*, J. SIAM 6 (1958) 51–90;
//! Golub, Van Loan, *Matrix Computations*, 4th ed., §8.6.3.
//!
//! Example: the columns of A = [3 0; 4 5] have the product 20 and the squares 25. They are rotated
//! by 45° to (3, 9)/√2 and (−3, 1)/√2. These are orthogonal, with the lengths √45 and √5, which are
//! the singular values.

use super::dense::DenseMatrix;
use std::vec::Vec;

/// Maximum number of sweeps, after which only rounding errors remain. Matrices of a hundred columns
/// need about ten.
const MAX_SWEEPS: usize = 60;

/// Singular values in descending order, with the corresponding directions.
pub(crate) struct SingularValues {
    /// A direction in the space of the columns, its singular value, and A times the direction.
    triples: Vec<(Vec<f64>, f64, Vec<f64>)>,
}

impl SingularValues {
    /// Computes the decomposition; `None` if an entry is not finite.
    pub(crate) fn of(a: &DenseMatrix) -> Option<SingularValues> {
        if !a.is_finite() {
            return None;
        }
        let n = a.columns();
        let mut images = (0..n).map(|j| a.column(j)).collect::<Vec<_>>();
        let identity = DenseMatrix::identity(n);
        let mut directions = (0..n).map(|j| identity.column(j)).collect::<Vec<_>>();
        for _ in 0..MAX_SWEEPS {
            let mut is_done = true;
            for j in 1..n {
                for i in 0..j {
                    let Some((cosine, sine)) = rotation(&images[i], &images[j]) else { continue };
                    is_done = false;
                    rotate(&mut images, (i, j), cosine, sine);
                    rotate(&mut directions, (i, j), cosine, sine);
                }
            }
            if is_done {
                break;
            }
        }
        let triples = directions.into_iter().zip(images);
        let mut triples =
            triples.map(|(direction, image)| (direction, length(&image), image)).collect::<Vec<_>>();
        triples.sort_by(|one, other| other.1.total_cmp(&one.1));
        Some(SingularValues { triples })
    }

    /// Returns the number of singular values above this fraction of the largest one.
    pub(crate) fn rank(&self, part: f64) -> usize {
        let largest = self.triples.first().map_or(0.0, |(_, value, _)| *value);
        self.triples.iter().filter(|(_, value, _)| *value > part * largest).count()
    }

    /// Computes the shortest x that minimises |A x − b|. Singular values below this fraction of the
    /// largest one count as zero.
    #[cfg(any(feature = "linear", test))]
    pub(crate) fn shortest(&self, b: &[f64], part: f64) -> Vec<f64> {
        let mut x = std::vec![0.0; self.triples.len()];
        for (direction, value, image) in &self.triples[..self.rank(part)] {
            let share = dot(image, b) / (value * value);
            x.iter_mut().zip(direction).for_each(|(x, entry)| *x += share * entry);
        }
        x
    }

    /// Computes the x that minimises |A x − b|² + λ|x|².
    pub(crate) fn damped(&self, b: &[f64], lambda: f64) -> Vec<f64> {
        let mut x = std::vec![0.0; self.triples.len()];
        for (direction, value, image) in self.triples.iter().filter(|(_, value, _)| *value > 0.0) {
            let share = dot(image, b) / (value * value + lambda);
            x.iter_mut().zip(direction).for_each(|(x, entry)| *x += share * entry);
        }
        x
    }

    /// Returns (AᵀA)⁻¹, if all singular values are positive.
    #[cfg(feature = "fit")]
    pub(crate) fn inverse_square(&self) -> Option<DenseMatrix> {
        let n = self.triples.len();
        let entry = |i, j| {
            self.triples
                .iter()
                .fold(0.0, |sum, (v, value, _): &(Vec<f64>, f64, _)| sum + v[i] * v[j] / (value * value))
        };
        let inverse = DenseMatrix::from_fn(n, n, entry);
        inverse.is_finite().then_some(inverse)
    }

    /// Returns the singular values.
    pub(crate) fn values(&self) -> Vec<f64> {
        self.triples.iter().map(|(_, value, _)| *value).collect()
    }

    /// Returns the direction with the shortest image.
    pub(crate) fn weakest(&self) -> Option<&[f64]> {
        self.triples.last().map(|(direction, ..)| direction.as_slice())
    }
}

/// Returns cosine and sine of the rotation that makes two columns orthogonal; `None` if they
/// already are.
fn rotation(one: &[f64], other: &[f64]) -> Option<(f64, f64)> {
    let (a, b, product) = (dot(one, one), dot(other, other), dot(one, other));
    if product.abs() <= f64::EPSILON * (a * b).sqrt() {
        return None;
    }
    let zeta = (b - a) / (2.0 * product);
    let tangent = 1.0_f64.copysign(zeta) / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    Some((cosine, cosine * tangent))
}

fn rotate(columns: &mut [Vec<f64>], (i, j): (usize, usize), cosine: f64, sine: f64) {
    let (before, from) = columns.split_at_mut(j);
    for (x, y) in before[i].iter_mut().zip(&mut from[0]) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
}

/// Computes aᵀb.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// Computes √(aᵀa).
pub(crate) fn length(a: &[f64]) -> f64 {
    let largest = a.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    largest * a.iter().fold(0.0, |sum, entry| sum + (entry / largest).powi(2)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, SingularValues};

    #[test]
    fn the_worked_example_holds() {
        let values = SingularValues::of(&DenseMatrix::from_rows(&[[3.0, 0.0], [4.0, 5.0]])).expect("finite");
        for (found, square) in values.values().into_iter().zip([45.0_f64, 5.0]) {
            assert!((found - square.sqrt()).abs() < 1e-15, "{found}");
        }
        let x = values.shortest(&[3.0, 9.0], 1e-9);
        assert!((x[0] - 1.0).abs() + (x[1] - 1.0).abs() < 1e-15, "{x:?}");
    }

    #[test]
    fn of_many_solutions_the_shortest_is_found() {
        let wide = SingularValues::of(&DenseMatrix::from_rows(&[[1.0, 2.0, 2.0]])).expect("finite");
        assert_eq!(wide.rank(1e-9), 1);
        for (found, wanted) in wide.shortest(&[9.0], 1e-9).into_iter().zip([1.0, 2.0, 2.0]) {
            assert!((found - wanted).abs() < 1e-14, "{found}");
        }
        let nothing = SingularValues::of(&DenseMatrix::zeros(2, 2)).expect("finite");
        assert_eq!(nothing.shortest(&[1.0, 1.0], 1e-9), [0.0, 0.0]);
    }

    #[test]
    fn what_is_not_finite_has_none() {
        assert!(SingularValues::of(&DenseMatrix::from_rows(&[[f64::INFINITY]])).is_none());
    }
}
