//! Formulas for moments of inertia and centres of mass that are more complex than a quotient.

use crate::expr::{ExprId, Function, Graph};
use crate::functions;
use crate::number::Number;

/// Returns x · numerator / denominator.
pub(super) fn fraction(graph: &mut Graph, numerator: i64, x: ExprId, denominator: i64) -> ExprId {
    let (multiple, denominator) = (graph.scale(Number::from(numerator), x), graph.number(denominator));
    graph.divide(multiple, denominator)
}

/// Returns Σ xᵢ² · numerator / denominator.
pub(super) fn sum_of_squares(graph: &mut Graph, x: &[ExprId], numerator: i64, denominator: i64) -> ExprId {
    let squares = x.iter().map(|&x| graph.square(x)).collect::<Vec<_>>();
    let sum = graph.total(squares);
    fraction(graph, numerator, sum, denominator)
}

/// Returns r²/2 − s². About the centre of the circle, at the distance s from its centre of mass, a
/// sector behaves like the whole disk.
pub(super) fn about_center(graph: &mut Graph, r: ExprId, s: ExprId) -> ExprId {
    let about_circle = sum_of_squares(graph, &[r], 1, 2);
    let square = graph.square(s);
    graph.subtract(about_circle, square)
}

/// Returns (0, 4 r / 3π).
pub(super) fn semicircular_center(graph: &mut Graph, x: &[ExprId]) -> [ExprId; 2] {
    let (pi, r) = (graph.pi(), fraction(graph, 4, x[0], 3));
    [graph.number(0), graph.divide(r, pi)]
}

/// Returns (4 r sin(angle/2) / (3 angle), 0).
pub(super) fn sector_center(graph: &mut Graph, x: &[ExprId]) -> [ExprId; 2] {
    let half = fraction(graph, 1, x[1], 2);
    let sine = functions::apply(graph, Function::Sin, &[half]);
    let product = graph.multiply(x[0], sine);
    let scaled = fraction(graph, 4, product, 3);
    [graph.divide(scaled, x[1]), graph.number(0)]
}

/// Returns a third of the sum of the corners (0, 0), (a, 0) and (p, q). By Heron, p = (a² − b² +
/// c²)/2a and q = √(c² − p²).
pub(super) fn triangle_center(graph: &mut Graph, x: &[ExprId]) -> [ExprId; 2] {
    let [a, b, c] = [x[0], x[1], x[2]];
    let [a2, b2, c2] = [a, b, c].map(|side| graph.square(side));
    let twice = graph.scale(Number::TWO, a);
    let numerator = graph.sum(Number::ZERO, [(a2, Number::ONE), (b2, Number::MINUS_ONE), (c2, Number::ONE)]);
    let p = graph.divide(numerator, twice);
    let signs = [[1, 1, 1], [-1, 1, 1], [1, -1, 1], [1, 1, -1]];
    let factors = signs.map(|signs| {
        let terms = [a, b, c].into_iter().zip(signs);
        graph.sum(Number::ZERO, terms.map(|(side, sign)| (side, Number::from(sign))))
    });
    let heron = graph.product(factors.map(|factor| (factor, Number::ONE)));
    let root = functions::apply(graph, Function::Sqrt, &[heron]);
    let q = graph.divide(root, twice);
    let sum = graph.add(a, p);
    [fraction(graph, 1, sum, 3), fraction(graph, 1, q, 3)]
}

/// Returns r² (2 + cos(2π/n)) / 6.
pub(super) fn regular_polygon(graph: &mut Graph, x: &[ExprId]) -> ExprId {
    let pi = graph.pi();
    let turn = graph.scale(Number::TWO, pi);
    let angle = graph.divide(turn, x[0]);
    let cosine = functions::apply(graph, Function::Cos, &[angle]);
    let sum = graph.sum(Number::TWO, [(cosine, Number::ONE)]);
    let square = graph.square(x[1]);
    let product = graph.multiply(square, sum);
    fraction(graph, 1, product, 6)
}

/// Returns 2/5 (R⁵ − r⁵)/(R³ − r³) with R − r cancelled, which leaves 2/3 R² for a thin sphere.
pub(super) fn hollow_sphere(graph: &mut Graph, x: &[ExprId]) -> ExprId {
    let homogeneous = |graph: &mut Graph, degree: i64| {
        let terms =
            (0..=degree).map(|i| graph.product([(x[0], Number::from(i)), (x[1], Number::from(degree - i))]));
        let terms = terms.collect::<Vec<_>>();
        graph.total(terms)
    };
    let (upper, lower) = (homogeneous(graph, 4), homogeneous(graph, 2));
    let quotient = graph.divide(upper, lower);
    fraction(graph, 2, quotient, 5)
}
