//! Newton's method for the equations of algebraic unknowns, as programs.

mod coupled;

use coupled::coupled;

use super::interpret::run_with;
use super::ir::Program;
use super::labels::Labels;
use super::lower::lower;
use super::passes::optimise;
use crate::calculus::{partial, rounding};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{AlgebraicUnknowns, ExprId, Graph};
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Limits of `root::newton` in the runtime library.
const TOLERANCE: f64 = 4.0;
const MIN_SPAN: f64 = 4.0;
const SAME_SLOPE: f64 = 0.25;
const MAX_BEND: f64 = 65_536.0;
const CENTRAL: f64 = 4.0;
const ASIDE: f64 = 32.0;

/// The programs of Newton's method, in symbols for the arguments and the unknowns.
#[derive(Clone, Debug)]
pub struct NewtonProgram {
    /// The functions whose values the method computes.
    pub functions: Vec<Opaque>,
    /// Roles of the arguments.
    pub arguments: Vec<Role>,
    /// Roles of the unknowns.
    pub values: Vec<Role>,
    /// Initial guesses.
    pub start: Program,
    /// Program of the residuals r: r, ∂r/∂y in rows, and a bound on the rounding error of each r,
    /// in units of one rounding.
    pub equation: Program,
    /// Maximum number of steps.
    pub iterations: u32,
}

impl NewtonProgram {
    /// Lowers the equations of unknowns.
    pub fn new(graph: &mut Graph, unknowns: &AlgebraicUnknowns, accuracy: Accuracy) -> NewtonProgram {
        let (residuals, values) = (&unknowns.residuals, &unknowns.values);
        let mut equation = residuals.clone();
        for &residual in residuals {
            equation.extend(values.iter().map(|&value| partial(graph, residual, value)));
        }
        equation.extend(residuals.iter().map(|&residual| rounding(graph, residual, values)));
        let lowered = |roots: &[ExprId]| optimise(&lower(graph, roots, &Labels::default()), accuracy);
        let role = |&id: &ExprId| graph.symbol_of(id).map_or(Role::Time, |symbol| symbol.role);
        NewtonProgram {
            functions: unknowns.functions.clone(),
            arguments: unknowns.arguments.iter().map(role).collect(),
            values: values.iter().map(role).collect(),
            start: lowered(&unknowns.starts),
            equation: lowered(&equation),
            iterations: unknowns.iterations,
        }
    }

    /// Computes the unknowns by the operations of emitted code for `f64`; NaN if none are found.
    /// `call` computes functions of the user's crate.
    pub fn solve(&self, arguments: &[f64], call: impl Fn(&Opaque, &[f64]) -> Vec<f64>) -> Vec<f64> {
        let place = |roles: &[Role], role: Role| roles.iter().position(|known| *known == role);
        let argument = |role: Role| {
            let place = place(&self.arguments, role);
            place.and_then(|place| arguments.get(place)).copied().unwrap_or(f64::NAN)
        };
        let start = run_with(&self.start, argument, &call);
        let equation = |y: &[f64]| {
            let value_of = |role| place(&self.values, role).map_or_else(|| argument(role), |place| y[place]);
            run_with(&self.equation, value_of, &call)
        };
        match start[..] {
            [start] => vec![newton(start, self.iterations, |y| {
                let found = equation(&[y]);
                [found[0], found[1], found[2]]
            })],
            _ => coupled(start, self.iterations, equation),
        }
    }
}

/// Returns the zero that `root::newton` in the runtime library finds, by the same operations. The
/// reasons are explained there.
fn newton(start: f64, iterations: u32, equation: impl Fn(f64) -> [f64; 3]) -> f64 {
    let (mut y, mut last) = (start, [0.0; 2]);
    let root = f64::EPSILON.sqrt();
    let noise_part = root * root.sqrt();
    for _ in 0..iterations {
        let [residual, slope, rounding] = equation(y);
        let [last_length, last_slope]: [f64; 2] = last;
        let change = residual / slope;
        let (next, length, steepness) = (y - change, change.abs(), slope.abs());
        let bound = TOLERANCE * f64::EPSILON * rounding;
        let hidden = bound / steepness;
        let is_small = residual.abs() <= bound && bound < f64::INFINITY && steepness < f64::INFINITY;
        let no_longer_shrinks = 0.0 < last_length && last_length <= length;
        let is_noise = length < noise_part * next.abs() && no_longer_shrinks;
        let agrees = (slope - last_slope).abs() <= SAME_SLOPE * steepness;
        let spans = MIN_SPAN * hidden <= last_length;
        if is_small && (bound <= 0.0 || spans && agrees) {
            return next;
        }
        if is_small || is_noise {
            let noise = if is_small { 0.0 } else { larger(length, last_length) };
            let width = ASIDE * larger(hidden, noise);
            let [above, below] = [next + width, next - width].map(&equation);
            let are_opposite = above[0] < 0.0 && 0.0 < below[0] || below[0] < 0.0 && 0.0 < above[0];
            let (sum, difference) = ((above[0] + below[0]).abs(), (above[0] - below[0]).abs());
            let is_central = is_small || CENTRAL * sum <= difference;
            if are_opposite && is_central && is_similar(below[1], above[1]) && is_similar(below[1], slope) {
                return next;
            }
        }
        if next.is_nan() {
            break;
        }
        (y, last) = (next, [length, slope]);
    }
    f64::NAN
}

/// True if two slopes have the same sign and differ by at most a factor.
fn is_similar(a: f64, b: f64) -> bool {
    (a < 0.0) == (b < 0.0) && a.abs() < MAX_BEND * b.abs() && b.abs() < MAX_BEND * a.abs()
}

/// Returns the larger of two numbers, the first if one of them is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}
