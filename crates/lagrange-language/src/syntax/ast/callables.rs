//! Functions that a declaration defines, names or tabulates, and values that are defined by
//! equations.

use super::{AstId, Name};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::opaque::{Interpolation, Outside};

/// A user-defined function, which is replaced by an expression.
#[derive(Clone, Debug)]
pub struct FunctionDefinition {
    /// Its name.
    pub name: Name,
    /// Names of the arguments in its value.
    pub parameters: Vec<Name>,
    /// Value.
    pub value: AstId,
}

/// A function of the user's crate, which emitted code calls.
#[derive(Clone, Debug)]
pub struct ExternalFunction {
    /// Its name, in the declaration and in the crate.
    pub name: Name,
    /// The names of its arguments.
    pub parameters: Vec<Name>,
    /// Its derivatives; `None` if all of them have their default names.
    pub derivatives: Option<Vec<ExternalDerivative>>,
}

/// A derivative of a function of the user's crate.
#[derive(Clone, Debug)]
pub struct ExternalDerivative {
    /// Order of differentiation with respect to each argument.
    pub orders: Vec<u8>,
    /// The name of the function that computes it.
    pub name: Name,
}

/// Values that are defined by an equal number of equations, usually one.
#[derive(Clone, Debug)]
pub struct UnknownDefinition {
    /// Their names.
    pub names: Vec<Name>,
    /// Expressions that are zero at the solution.
    pub residuals: Vec<AstId>,
    /// Initial guesses, one for each name; zero if they are omitted.
    pub starts: Vec<AstId>,
    /// Maximum number of steps.
    pub iterations: Option<AstId>,
}

/// A function through given points.
#[derive(Clone, Debug)]
pub struct TableDefinition {
    /// Its name.
    pub name: Name,
    /// The names of its arguments.
    pub parameters: Vec<Name>,
    /// The points.
    pub source: TableSource,
    /// Function between the points.
    pub interpolation: Interpolation,
    /// Function beyond the points.
    pub outside: Outside,
}

/// Points of a table.
#[derive(Clone, Debug)]
pub enum TableSource {
    /// Points in the declaration: arguments, then the value, each with its place.
    Points(Vec<(Vec<AstId>, Origin)>),
    /// A matrix of values between two axes.
    Grid(TableGrid),
    /// A file of points, one on each line.
    File {
        /// Path as written.
        path: Name,
        /// Contents; `None` if it has not been read.
        contents: Option<TableFile>,
    },
}

impl TableSource {
    /// Returns the numbers in the declaration. Each has the index of its argument; values have the
    /// number of arguments instead.
    pub fn numbers(&self) -> Vec<(usize, AstId)> {
        // A copy is used so that numbers are only listed in one place.
        self.clone().numbers_mut().into_iter().map(|(column, number)| (column, *number)).collect()
    }

    /// Returns the numbers in the declaration like [`TableSource::numbers`], to be changed.
    pub fn numbers_mut(&mut self) -> Vec<(usize, &mut AstId)> {
        match self {
            TableSource::Points(points) => {
                points.iter_mut().flat_map(|(point, _)| point.iter_mut().enumerate()).collect()
            }
            TableSource::Grid(TableGrid { axes, rows }) => {
                let of_axes = axes.iter_mut().enumerate();
                let of_axes =
                    of_axes.flat_map(|(axis, knots)| knots.iter_mut().map(move |knot| (axis, knot)));
                of_axes.chain(rows.iter_mut().flatten().map(|value| (2, value))).collect()
            }
            TableSource::File { .. } => Vec::new(),
        }
    }
}

/// Values on a grid of two arguments.
#[derive(Clone, Debug)]
pub struct TableGrid {
    /// Values of the first argument, one for each row, and of the second, one for each column.
    pub axes: [Vec<AstId>; 2],
    /// Values of the table.
    pub rows: Vec<Vec<AstId>>,
}

/// A file of points that has been read.
#[derive(Clone, Debug)]
pub struct TableFile {
    /// Path under which the compiler finds it; empty if changes are not tracked.
    pub path: String,
    /// Points, each with its line number: arguments, then the value. Those of a grid are listed
    /// row by row.
    pub points: Vec<(usize, Vec<f64>)>,
}
