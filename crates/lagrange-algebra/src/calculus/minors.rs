//! Determinants of small matrices of expressions, by expansion along rows.
//!
//! A minor of some columns in the last rows occurs in many larger ones and is computed once. A
//! determinant has at most 2ⁿ of them, and fewer if entries are zero.

use crate::calculus::partial;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};

/// The minors of a matrix.
pub(super) struct Minors<'a> {
    rows: &'a [Vec<ExprId>],
    /// Minors by the bit sets of their rows and columns.
    known: HashMap<(u32, u32), ExprId>,
}

impl Minors<'_> {
    pub(super) fn new(rows: &[Vec<ExprId>]) -> Minors<'_> {
        Minors { rows, known: HashMap::default() }
    }

    pub(super) fn determinant(&mut self, graph: &mut Graph) -> ExprId {
        let all = self.all();
        self.minor(graph, all, all)
    }

    /// Returns the derivative of the determinant with respect to an entry.
    pub(super) fn cofactor(&mut self, graph: &mut Graph, row: usize, column: usize) -> ExprId {
        let all = self.all();
        let minor = self.minor(graph, all & !(1 << row), all & !(1 << column));
        if (row + column).is_multiple_of(2) { minor } else { graph.negate(minor) }
    }

    /// Returns one of the unknowns for which the rows and these constants add up to zero, by
    /// Cramer's rule.
    pub(super) fn root(&mut self, graph: &mut Graph, constants: &[ExprId], place: usize) -> ExprId {
        let mut terms = Vec::new();
        for (row, &constant) in constants.iter().enumerate() {
            let cofactor = self.cofactor(graph, row, place);
            terms.push(graph.multiply(constant, cofactor));
        }
        let (numerator, determinant) = (graph.total(terms), self.determinant(graph));
        let quotient = graph.divide(numerator, determinant);
        graph.negate(quotient)
    }

    fn all(&self) -> u32 {
        (1 << self.rows.len()) - 1
    }

    /// Returns a minor; the recursion depth is the number of rows.
    fn minor(&mut self, graph: &mut Graph, rows: u32, columns: u32) -> ExprId {
        if rows == 0 {
            return graph.number(1);
        }
        if let Some(&known) = self.known.get(&(rows, columns)) {
            return known;
        }
        let first = rows.trailing_zeros();
        let (mut terms, mut is_odd) = (Vec::new(), false);
        for column in (0..self.rows.len()).filter(|column| columns & 1 << column != 0) {
            let entry = self.rows[first as usize][column];
            if !graph.is_zero(entry) {
                let rest = self.minor(graph, rows & !(1 << first), columns & !(1 << column));
                let term = graph.multiply(entry, rest);
                terms.push(if is_odd { graph.negate(term) } else { term });
            }
            is_odd = !is_odd;
        }
        let minor = graph.total(terms);
        self.known.insert((rows, columns), minor);
        minor
    }
}

/// Returns the determinant of the Jacobian of expressions with respect to the same number of
/// symbols.
pub fn jacobian_determinant(graph: &mut Graph, expressions: &[ExprId], symbols: &[ExprId]) -> ExprId {
    let mut rows = Vec::new();
    for &expression in expressions {
        rows.push(symbols.iter().map(|&symbol| partial(graph, expression, symbol)).collect());
    }
    Minors::new(&rows).determinant(graph)
}
