//! Functions of the user's crate in interpreted systems.

use std::fmt;
use std::sync::Arc;

use lagrange_algebra::program::{NewtonProgram, Op, Program};
use lagrange_expr::collections::HashMap;
use lagrange_expr::opaque::Opaque;

type Callback = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;
/// Returns the numbers of the contact points of two blocks from those of the blocks.
pub(super) type ContactPoints = fn(&[f64]) -> Vec<f64>;

/// Functions by their names in emitted code, and solutions of equations.
#[derive(Clone, Default)]
pub(super) struct Callables {
    functions: HashMap<String, Callback>,
    solutions: Arc<[NewtonProgram]>,
    pub(super) contact_points: Option<ContactPoints>,
}

impl fmt::Debug for Callables {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Callables({})", self.functions.len() + self.solutions.len())
    }
}

impl Callables {
    pub(super) fn define(&mut self, name: &str, value: impl Fn(&[f64]) -> f64 + Send + Sync + 'static) {
        self.functions.insert(name.to_owned(), Arc::new(value));
    }

    /// Creates callables with only these solutions of equations.
    pub(super) fn solving(solutions: Vec<NewtonProgram>) -> Callables {
        Callables { solutions: solutions.into(), ..Callables::default() }
    }

    /// Returns the programs of all equations.
    pub(super) fn programs(&self) -> impl Iterator<Item = &Program> {
        self.solutions.iter().map(|solution| &solution.equation)
    }

    /// Returns the value of a function, or the values of all coupled unknowns; NaN if it is not
    /// provided.
    pub(super) fn call(&self, function: &Opaque, arguments: &[f64]) -> Vec<f64> {
        match self.solutions.iter().find(|solution| solution.functions.contains(function)) {
            Some(solution) => {
                solution.solve(arguments, |function, arguments| self.named(function, arguments))
            }
            None => self.named(function, arguments),
        }
    }

    fn named(&self, function: &Opaque, arguments: &[f64]) -> Vec<f64> {
        if let Some(points) = self.contact_points.filter(|_| function.is_contact_point()) {
            return points(arguments);
        }
        vec![self.functions.get(&function.rust_name()).map_or(f64::NAN, |value| value(arguments))]
    }
}

/// True if a program calls a function of that name.
pub(super) fn calls(program: &Program, name: &str) -> bool {
    let is_call = |op: &Op| matches!(op, Op::Opaque(function, _) if function.rust_name() == name);
    program.values().any(|(_, op)| is_call(op))
}
