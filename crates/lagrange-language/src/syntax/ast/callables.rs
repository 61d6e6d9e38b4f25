//! Functions that a declaration defines, names or tabulates, and values that equations define.

use super::{AstId, Name};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::opaque::{Interpolation, Outside};

/// A function of the user's, which stands for an expression.
#[derive(Clone, Debug)]
pub struct FunctionDefinition {
    /// Its name.
    pub name: Name,
    /// Names that stand for arguments in its value.
    pub parameters: Vec<Name>,
    /// Value.
    pub value: AstId,
}

/// A function of the user's crate, which emitted code calls.
#[derive(Clone, Debug)]
pub struct ExternalFunction {
    /// Its name, here and there.
    pub name: Name,
    /// The names of its arguments.
    pub parameters: Vec<Name>,
    /// Its derivatives; `None` if all of them have their default names.
    pub derivatives: Option<Vec<ExternalDerivative>>,
}

/// A derivative of a function of the user's crate.
#[derive(Clone, Debug)]
pub struct ExternalDerivative {
    /// Order of differentiation by each argument.
    pub orders: Vec<u8>,
    /// The name of the function that computes it.
    pub name: Name,
}

/// Values that as many equations define together, mostly one.
#[derive(Clone, Debug)]
pub struct UnknownDefinition {
    /// Their names.
    pub names: Vec<Name>,
    /// Expressions that are zero at the solution.
    pub residuals: Vec<AstId>,
    /// Initial guesses, one for each name; zero if they are omitted.
    pub starts: Vec<AstId>,
    /// The number of steps after which the search ends.
    pub iterations: Option<AstId>,
}

/// A function that goes through points.
#[derive(Clone, Debug)]
pub struct TableDefinition {
    /// Its name.
    pub name: Name,
    /// The names of its arguments.
    pub parameters: Vec<Name>,
    /// Points that it goes through.
    pub source: TableSource,
    /// Function between the points.
    pub interpolation: Interpolation,
    /// Function beyond them.
    pub outside: Outside,
}

/// Points of a table.
#[derive(Clone, Debug)]
pub enum TableSource {
    /// Points in the declaration: arguments, then the value, each with where it stands.
    Points(Vec<(Vec<AstId>, Origin)>),
    /// A file of points, one on each line.
    File {
        /// Path as it is written.
        path: Name,
        /// Contents; `None` if it has not been read.
        contents: Option<TableFile>,
    },
}

/// A file of points that has been read.
#[derive(Clone, Debug)]
pub struct TableFile {
    /// Path under which the compiler finds it; nothing if nobody waits for it to change.
    pub path: String,
    /// Points, each behind the number of its line: arguments, then the value.
    pub points: Vec<(usize, Vec<f64>)>,
}
