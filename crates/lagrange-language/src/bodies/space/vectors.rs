//! Vectors of three components, matrices and symmetric tensors as syntax.
//!
//! Zeros and ones are left out, as everywhere in [`TermWriter`], so that sparse frames stay sparse
//! in print.

use crate::bodies::terms::TermWriter;
use crate::syntax::ast::AstId;

/// A vector in space.
pub(in crate::bodies) type Triple = [AstId; 3];
/// A matrix in rows.
pub(in crate::bodies) type Matrix = [Triple; 3];
/// xx, yy, zz, xy, xz, yz of a symmetric matrix.
pub(super) type Tensor = [AstId; 6];

/// Rows and columns of the components of a [`Tensor`].
pub(super) const TENSOR_PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

pub(in crate::bodies) fn zero_triple(terms: &mut TermWriter<'_>) -> Triple {
    [0, 0, 0].map(|_| terms.number(0))
}

/// Returns the direction of a coordinate axis.
pub(in crate::bodies) fn unit(terms: &mut TermWriter<'_>, axis: usize) -> Triple {
    [0, 1, 2].map(|other| terms.number(i64::from(other == axis)))
}

pub(in crate::bodies) fn plus(terms: &mut TermWriter<'_>, a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|axis| terms.plus(a[axis], b[axis]))
}

pub(in crate::bodies) fn minus(terms: &mut TermWriter<'_>, a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|axis| terms.minus(a[axis], b[axis]))
}

pub(in crate::bodies) fn scale(terms: &mut TermWriter<'_>, factor: AstId, a: Triple) -> Triple {
    a.map(|component| terms.times(factor, component))
}

/// Returns a · b.
pub(in crate::bodies) fn inner(terms: &mut TermWriter<'_>, a: Triple, b: Triple) -> AstId {
    let products = [0, 1, 2].map(|axis| terms.times(a[axis], b[axis]));
    let sum = terms.plus(products[0], products[1]);
    terms.plus(sum, products[2])
}

/// Returns a × b.
pub(in crate::bodies) fn cross(terms: &mut TermWriter<'_>, a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let (forward, backward) = (terms.times(a[next], b[last]), terms.times(a[last], b[next]));
        terms.minus(forward, backward)
    })
}

/// Returns the combination Σ aₖ eₖ of three vectors.
pub(super) fn combined(terms: &mut TermWriter<'_>, a: Triple, axes: [Triple; 3]) -> Triple {
    let parts = [0, 1, 2].map(|axis| scale(terms, a[axis], axes[axis]));
    let sum = plus(terms, parts[0], parts[1]);
    plus(terms, sum, parts[2])
}

/// Returns A a.
pub(super) fn apply(terms: &mut TermWriter<'_>, matrix: Matrix, a: Triple) -> Triple {
    matrix.map(|row| inner(terms, row, a))
}

pub(in crate::bodies) fn transposed(matrix: Matrix) -> Matrix {
    [0, 1, 2].map(|column| [0, 1, 2].map(|row| matrix[row][column]))
}

/// Returns A B.
pub(super) fn matrix_product(terms: &mut TermWriter<'_>, a: Matrix, b: Matrix) -> Matrix {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| inner(terms, row, column)))
}

/// Returns the matrix of a tensor.
pub(super) fn matrix_of(tensor: Tensor) -> Matrix {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

pub(super) fn tensor_sum(terms: &mut TermWriter<'_>, a: Tensor, b: Tensor) -> Tensor {
    [0, 1, 2, 3, 4, 5].map(|place| terms.plus(a[place], b[place]))
}

/// Returns R J Rᵀ.
pub(super) fn turned_tensor(terms: &mut TermWriter<'_>, rotation: Matrix, tensor: Tensor) -> Tensor {
    let half = matrix_product(terms, rotation, matrix_of(tensor));
    TENSOR_PLACES.map(|(row, column)| inner(terms, half[row], rotation[column]))
}

/// Returns m (d² 1 − d dᵀ), the contribution of a point mass to the tensor of inertia about the
/// origin (Steiner, Huygens).
pub(super) fn tensor_of_point(terms: &mut TermWriter<'_>, mass: AstId, place: Triple) -> Tensor {
    TENSOR_PLACES.map(|(row, column)| {
        let moment = match row == column {
            true => {
                let others = [(row + 1) % 3, (row + 2) % 3];
                let squares = others.map(|axis| square_or_zero(terms, place[axis]));
                terms.plus(squares[0], squares[1])
            }
            false => {
                let product = terms.times(place[row], place[column]);
                terms.negative(product)
            }
        };
        terms.times(mass, moment)
    })
}

/// Returns ½ w·J w.
pub(super) fn half_square(terms: &mut TermWriter<'_>, tensor: Tensor, w: Triple) -> AstId {
    let mut sum = terms.number(0);
    for (component, (row, column)) in tensor.into_iter().zip(TENSOR_PLACES) {
        let (weight, product) = match row == column {
            true => {
                let half = terms.half();
                (terms.times(half, component), square_or_zero(terms, w[row]))
            }
            false => (component, terms.times(w[row], w[column])),
        };
        let term = terms.times(weight, product);
        sum = terms.plus(sum, term);
    }
    sum
}

fn square_or_zero(terms: &mut TermWriter<'_>, value: AstId) -> AstId {
    match terms.is_zero(value) {
        true => value,
        false => terms.square(value),
    }
}
