//! Shapes of values: scalars, vectors and matrices.

use std::ops::Range;

/// The shape of a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArrayShape {
    /// One number.
    Scalar,
    /// Components.
    Vector(usize),
    /// Rows and columns.
    Matrix([usize; 2]),
}

impl ArrayShape {
    /// Returns the shape of an array with these numbers of elements; `None` beyond matrices.
    pub fn of_sizes(sizes: &[usize]) -> Option<ArrayShape> {
        match *sizes {
            [] => Some(ArrayShape::Scalar),
            [count] => Some(ArrayShape::Vector(count)),
            [rows, columns] => Some(ArrayShape::Matrix([rows, columns])),
            _ => None,
        }
    }

    /// Returns the shape of `(a, b)`: rows of one shape; `None` if they have no common shape.
    pub fn stacked(rows: &[ArrayShape]) -> Option<ArrayShape> {
        let first = *rows.first()?;
        match first {
            _ if rows.iter().any(|row| *row != first) => None,
            ArrayShape::Scalar => Some(ArrayShape::Vector(rows.len())),
            ArrayShape::Vector(columns) => Some(ArrayShape::Matrix([rows.len(), columns])),
            ArrayShape::Matrix(_) => None,
        }
    }

    /// Returns the shape of a product; `None` if it is undefined.
    pub fn times(self, other: ArrayShape) -> Option<ArrayShape> {
        match (self, other) {
            (ArrayShape::Scalar, shape) | (shape, ArrayShape::Scalar) => Some(shape),
            (ArrayShape::Matrix([rows, inner]), ArrayShape::Vector(count)) if inner == count => {
                Some(ArrayShape::Vector(rows))
            }
            (ArrayShape::Matrix([rows, inner]), ArrayShape::Matrix([count, columns])) if inner == count => {
                Some(ArrayShape::Matrix([rows, columns]))
            }
            _ => None,
        }
    }

    /// Returns the shape of the transpose of a matrix.
    pub fn transposed(self) -> Option<ArrayShape> {
        match self {
            ArrayShape::Matrix([rows, columns]) => Some(ArrayShape::Matrix([columns, rows])),
            _ => None,
        }
    }

    /// Returns the number of components, by rows.
    pub fn count(self) -> usize {
        match self {
            ArrayShape::Scalar => 1,
            ArrayShape::Vector(count) => count,
            ArrayShape::Matrix([rows, columns]) => rows.saturating_mul(columns),
        }
    }

    /// Returns the components at indices, and their shape: a component of a vector, a row or an
    /// entry of a matrix. `None` for invalid indices.
    pub fn entry(self, indices: &[usize]) -> Option<(Range<usize>, ArrayShape)> {
        match (self, indices) {
            (ArrayShape::Vector(count), &[i]) if i < count => Some((i..i + 1, ArrayShape::Scalar)),
            (ArrayShape::Matrix([rows, columns]), &[i]) if i < rows => {
                Some((i * columns..(i + 1) * columns, ArrayShape::Vector(columns)))
            }
            (ArrayShape::Matrix([rows, columns]), &[i, j]) if i < rows && j < columns => {
                let place = i * columns + j;
                Some((place..place + 1, ArrayShape::Scalar))
            }
            _ => None,
        }
    }

    /// Returns a description of the shape.
    pub fn describe(self) -> String {
        match self {
            ArrayShape::Scalar => "a scalar".to_owned(),
            ArrayShape::Vector(1) => "a vector of 1 component".to_owned(),
            ArrayShape::Vector(count) => format!("a vector of {count} components"),
            ArrayShape::Matrix([rows, columns]) => format!("a {rows}×{columns} matrix"),
        }
    }
}
