//! Scalars, vectors and matrices, and the operations of the language on them.

use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions;
use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::ArrayShape;

/// The value of an expression of the language.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Operand {
    Scalar(ExprId),
    /// Its components.
    Vector(Vec<ExprId>),
    /// Numbers of rows and columns, and the entries by rows.
    Matrix([usize; 2], Vec<ExprId>),
}

impl Operand {
    /// Creates an operand of this shape from its components.
    pub(super) fn of(shape: ArrayShape, components: Vec<ExprId>) -> Operand {
        match shape {
            ArrayShape::Scalar => Operand::Scalar(components[0]),
            ArrayShape::Vector(_) => Operand::Vector(components),
            ArrayShape::Matrix(sizes) => Operand::Matrix(sizes, components),
        }
    }

    /// Returns the shape.
    pub(super) fn shape(&self) -> ArrayShape {
        match self {
            Operand::Scalar(_) => ArrayShape::Scalar,
            Operand::Vector(components) => ArrayShape::Vector(components.len()),
            Operand::Matrix(sizes, _) => ArrayShape::Matrix(*sizes),
        }
    }

    /// Returns the entry or row at these indices, if it exists.
    pub(super) fn entry(&self, indices: &[usize]) -> Option<Operand> {
        let (places, shape) = self.shape().entry(indices)?;
        Some(Operand::of(shape, self.components()[places].to_vec()))
    }

    /// Returns the number of components of a vector, or of rows of a matrix.
    pub(super) fn len(&self) -> usize {
        match self {
            Operand::Scalar(_) => 1,
            Operand::Vector(components) => components.len(),
            Operand::Matrix([rows, _], _) => *rows,
        }
    }

    /// Returns the components: one for a scalar, all of them for a vector or a matrix.
    pub(super) fn components(&self) -> &[ExprId] {
        match self {
            Operand::Scalar(id) => std::slice::from_ref(id),
            Operand::Vector(components) | Operand::Matrix(_, components) => components,
        }
    }

    /// Returns an operand of the same kind with every component mapped.
    pub(super) fn map(&self, mut f: impl FnMut(ExprId) -> ExprId) -> Operand {
        Operand::of(self.shape(), self.components().iter().map(|&id| f(id)).collect())
    }

    /// Returns a description for messages.
    pub(super) fn kind(&self) -> String {
        self.shape().describe()
    }

    /// True if both have the same shape.
    pub(super) fn same_kind(&self, other: &Operand) -> bool {
        self.shape() == other.shape()
    }
}

/// Returns Σ aᵢ·bᵢ.
pub(super) fn inner(graph: &mut Graph, a: &[ExprId], b: &[ExprId]) -> ExprId {
    let products = a.iter().zip(b).map(|(&a, &b)| graph.multiply(a, b)).collect::<Vec<_>>();
    graph.total(products)
}

/// Returns Σ aᵢ².
pub(super) fn norm_squared(graph: &mut Graph, a: &[ExprId]) -> ExprId {
    inner(graph, a, a)
}

/// Returns (Σ aᵢ²)^½, without a root if all components but one are zero.
pub(super) fn norm(graph: &mut Graph, a: &[ExprId]) -> ExprId {
    let others = a.iter().copied().filter(|&component| !graph.is_zero(component)).collect::<Vec<_>>();
    match others.as_slice() {
        [] => graph.number(0),
        &[single] => functions::apply(graph, Function::Abs, &[single]),
        _ => {
            let square = norm_squared(graph, a);
            functions::apply(graph, Function::Sqrt, &[square])
        }
    }
}

/// Returns a × b: the out-of-plane component for plane vectors, or a vector in space.
pub(super) fn cross(graph: &mut Graph, a: &[ExprId], b: &[ExprId]) -> Operand {
    let mut minor = |i: usize, j: usize| {
        let (forward, backward) = (graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i]));
        graph.subtract(forward, backward)
    };
    match a.len() {
        2 => Operand::Scalar(minor(0, 1)),
        _ => Operand::Vector(vec![minor(1, 2), minor(2, 0), minor(0, 1)]),
    }
}

/// Returns ½·weight·Σ aᵢ².
pub(super) fn half_square(graph: &mut Graph, weight: ExprId, a: &[ExprId]) -> ExprId {
    let square = norm_squared(graph, a);
    let product = graph.multiply(weight, square);
    graph.scale(Number::HALF, product)
}

/// Returns the product of a matrix and a vector, a matrix or a scalar; `None` if their shapes do
/// not match. Each entry is the sum Σ aᵢₖ bₖⱼ.
pub(super) fn product(graph: &mut Graph, a: &Operand, b: &Operand) -> Option<Operand> {
    let shape = a.shape().times(b.shape())?;
    match (a, b) {
        (Operand::Scalar(factor), other) | (other, Operand::Scalar(factor)) => {
            Some(other.map(|component| graph.multiply(*factor, component)))
        }
        (Operand::Matrix([rows, width], entries), other) => {
            let columns = shape.count() / rows;
            let column = |j: usize| other.components().iter().skip(j).step_by(columns).copied().collect();
            let all: Vec<Vec<ExprId>> = (0..columns).map(column).collect();
            let components =
                entries.chunks(*width).flat_map(|row| all.iter().map(move |column| (row, column)));
            let components = components.map(|(row, column)| inner(graph, row, column)).collect();
            Some(Operand::of(shape, components))
        }
        _ => None,
    }
}

/// Returns the matrix with rows and columns exchanged.
pub(super) fn transposed([rows, columns]: [usize; 2], entries: &[ExprId]) -> Operand {
    let places = (0..columns).flat_map(|j| (0..rows).map(move |i| i * columns + j));
    Operand::Matrix([columns, rows], places.map(|place| entries[place]).collect())
}
