//! Factorisation of a mass matrix in which as many terms as possible cancel symbolically in
//! entries, pivots and right-hand sides.
//!
//! It serves kinetic energies that are not sums of squares of velocities, at the accuracy level
//! `strict`. Without it the accelerations of a written-out double pendulum have relative errors up
//! to 1e-4 in `tests/extremes`, with it 1e-16. Eliminating x with the pivot D leaves W − a b / D of
//! an entry W. If W D − a b has fewer terms when multiplied out, it is divided by D instead. For a
//! double pendulum, m₂ l₂² remains in the denominator, and m₁ l₁² + m₂ l₁² sin²(θ₁ − θ₂) in the
//! entry. The form (m₁ + m₂) l₁² − m₂ l₁² cos²(θ₁ − θ₂) would lose digits. These are the Schur
//! complements of Golub and Van Loan, *Matrix Computations*, 4th ed., §3.2.

use super::solution::Solution;
use crate::derive::algebra::Algebra;
use crate::derive::quadratic_form::QuadraticForm;
use lagrange_algebra::simplify;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Maximum number of coordinates for the search for terms that cancel, which would take too long in
/// the entries of a larger matrix.
pub(in crate::derive) const MAX_CONTRACTED: usize = 8;
/// Maximum number of parts of an expression that is searched for terms that cancel. Each round of
/// the search expands every sum in it once.
const LARGEST_OPENED: usize = 300;
/// Maximum number of sums expanded in one expression. Each expansion shortens it, so the limit only
/// bounds the time.
const MAX_ROUNDS: usize = 8;

/// Returns the form over the generalised velocities with its coefficients contracted. Without
/// contraction, one acceleration of a spherical pendulum loses half of its digits near the pole.
pub(in crate::derive) fn contracted(
    graph: &mut Graph,
    pushed: QuadraticForm,
    velocities: &[ExprId],
) -> QuadraticForm {
    if velocities.len() > MAX_CONTRACTED {
        return pushed;
    }
    let mut algebra = Algebra::new(graph);
    let mut form = QuadraticForm::default();
    for (n, &i) in velocities.iter().enumerate() {
        for &j in &velocities[n..] {
            let coefficient = pushed.coefficient(algebra.graph, i, j);
            let coefficient = shortest(&mut algebra, coefficient);
            form.add_pair(algebra.graph, i, j, coefficient);
        }
        let linear = pushed.linear(algebra.graph, i);
        let linear = shortest(&mut algebra, linear);
        form.add_linear(algebra.graph, i, linear);
    }
    form
}

/// Solves a form over the generalised velocities for the accelerations. `None` if a pivot vanishes,
/// or if there are too many coordinates.
pub(in crate::derive) fn solve_contracted(
    graph: &mut Graph,
    form: &QuadraticForm,
    velocities: &[ExprId],
) -> Option<Solution> {
    if velocities.len() > MAX_CONTRACTED {
        return None;
    }
    let mut system = LinearSystem::new(graph, form, velocities);
    let mut labels = Vec::new();
    while let Some(i) = system.next() {
        let pivot = system.rows[i].entries[i];
        if system.algebra.graph.is_zero(pivot) {
            return None;
        }
        system.eliminate(i);
        labels.push((pivot, format!("pivot_{i}")));
    }
    Some(Solution {
        values: system.accelerations(),
        labels,
        guards: Vec::new(),
        condition: None,
        elimination: None,
    })
}

/// One equation: Σ entry · acceleration + linear = 0.
struct Equation {
    entries: Vec<ExprId>,
    linear: ExprId,
    /// True if its acceleration has been eliminated from the other equations.
    is_done: bool,
}

struct LinearSystem<'g> {
    algebra: Algebra<'g>,
    rows: Vec<Equation>,
}

impl<'g> LinearSystem<'g> {
    fn new(graph: &'g mut Graph, form: &QuadraticForm, velocities: &[ExprId]) -> LinearSystem<'g> {
        let mut rows = Vec::with_capacity(velocities.len());
        for &velocity in velocities {
            let entries = velocities.iter().map(|&other| form.coefficient(graph, velocity, other)).collect();
            rows.push(Equation { entries, linear: form.linear(graph, velocity), is_done: false });
        }
        LinearSystem { algebra: Algebra::new(graph), rows }
    }

    /// Returns the accelerations that have not been eliminated.
    fn remaining(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|&i| !self.rows[i].is_done).collect()
    }

    /// Returns the remaining equation whose acceleration occurs in the fewest others and whose
    /// pivot contains the fewest sums.
    fn next(&self) -> Option<usize> {
        let remaining = self.remaining();
        let cost = |i: usize| {
            let entries = remaining.iter().map(|&j| self.rows[i].entries[j]);
            let entries = entries.filter(|entry| !self.algebra.graph.is_zero(*entry)).count();
            let pivot = [(self.rows[i].entries[i], Number::ONE)];
            let sums = simplify::factors_to_open(self.algebra.graph, &pivot).len();
            (entries, sums)
        };
        remaining.iter().copied().min_by_key(|&i| cost(i))
    }

    /// Eliminates an acceleration from all other equations (Gauss and Jordan), including the
    /// finished ones. Terms in these also cancel as they are formed.
    fn eliminate(&mut self, p: usize) {
        self.rows[p].is_done = true;
        let (pivot, linear) = (self.rows[p].entries[p], self.rows[p].linear);
        let columns = self.remaining();
        let across = columns.iter().map(|&j| self.rows[p].entries[j]).collect::<Vec<_>>();
        for i in (0..self.rows.len()).filter(|&i| i != p) {
            let a = self.rows[i].entries[p];
            for (&j, &b) in columns.iter().zip(&across) {
                let is_symmetric = j < i && !self.rows[i].is_done;
                self.rows[i].entries[j] = match is_symmetric {
                    true => self.rows[j].entries[i],
                    false => schur(&mut self.algebra, self.rows[i].entries[j], pivot, a, b),
                };
            }
            self.rows[i].linear = schur(&mut self.algebra, self.rows[i].linear, pivot, a, linear);
        }
    }

    fn accelerations(self) -> Vec<ExprId> {
        let graph = self.algebra.graph;
        let solved = self.rows.iter().enumerate().map(|(i, row)| {
            let free = simplify::quotient(graph, row.linear, row.entries[i]);
            graph.negate(free)
        });
        solved.collect()
    }
}

/// Returns value − a b / pivot.
fn schur(algebra: &mut Algebra<'_>, value: ExprId, pivot: ExprId, a: ExprId, b: ExprId) -> ExprId {
    let product = algebra.graph.multiply(a, b);
    if algebra.graph.is_zero(product) {
        return value;
    }
    let terms = [(algebra.graph.multiply(value, pivot), Number::ONE), (product, Number::MINUS_ONE)];
    let numerator = algebra.graph.sum(Number::ZERO, terms);
    // Put the entry over the pivot only if something cancels. Otherwise the fill-in keeps its own,
    // shared quotient.
    if let Some(numerator) = shorter(algebra, numerator, simplify::is_no_difference) {
        return simplify::quotient(algebra.graph, numerator, pivot);
    }
    let fill = simplify::quotient(algebra.graph, product, pivot);
    let rest = algebra.total(vec![(value, Number::ONE), (fill, Number::MINUS_ONE)]);
    shortest(algebra, rest)
}

/// Returns an expression in which sums are expanded if terms then cancel or can be contracted. Sums
/// are expanded one at a time if this suffices. Otherwise all sums that are not differences are
/// expanded, together with one difference.
fn shortest(algebra: &mut Algebra<'_>, sum: ExprId) -> ExprId {
    let mut best = algebra.total(vec![(sum, Number::ONE)]);
    for _ in 0..MAX_ROUNDS {
        let Some(found) = shorter_by_some(algebra, best) else { break };
        best = found;
    }
    best
}

fn shorter_by_some(algebra: &mut Algebra<'_>, sum: ExprId) -> Option<ExprId> {
    if algebra.graph.is_larger_than(sum, LARGEST_OPENED) {
        return None;
    }
    let terms = algebra.terms_of(sum);
    for factor in simplify::factors_to_open(algebra.graph, &terms) {
        let found = shorter(algebra, sum, |_, id| id == factor);
        if found.is_some() {
            return found;
        }
    }
    let found = shorter(algebra, sum, simplify::is_no_difference);
    if found.is_some() {
        return found;
    }
    let opened = simplify::open(algebra.graph, &terms, simplify::is_no_difference)?;
    let differences = simplify::factors_to_open(algebra.graph, &opened);
    differences.into_iter().find_map(|difference| {
        shorter(algebra, sum, |graph, id| id == difference || simplify::is_no_difference(graph, id))
    })
}

/// Expands the chosen sums of an expression; `None` unless terms then cancel or can be contracted.
fn shorter(
    algebra: &mut Algebra<'_>,
    sum: ExprId,
    is_chosen: impl Fn(&Graph, ExprId) -> bool,
) -> Option<ExprId> {
    let terms = algebra.terms_of(sum);
    let opened = simplify::open(algebra.graph, &terms, is_chosen)?;
    let found = algebra.simplified(opened);
    let [before, after] = [sum, found].map(|id| simplify::count_opened(algebra.graph, id));
    (after < before).then_some(found)
}
