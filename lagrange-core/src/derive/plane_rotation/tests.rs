//! The worked example in the module's documentation, and rotations compared with individual
//! substitution of the same sums.

use super::turned_block;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::{Multiples, Rotations, Sweep};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

#[test]
fn a_block_in_numbers() {
    let graph = &mut Graph::new();
    let number = |graph: &mut Graph, p, q| graph.number(Number::ratio(p, q).expect("not over zero"));
    let [c, s, a, b, w] = [(3, 5), (4, 5), (7, 1), (2, 1), (5, 2)].map(|(p, q)| number(graph, p, q));
    let block = turned_block(graph, [c, s], [[a, w], [w, b]]).map(|row| row.map(|terms| graph.total(terms)));
    let expected = [[(7, 5), (17, 10)], [(17, 10), (38, 5)]].map(|row| row.map(|(p, q)| number(graph, p, q)));
    assert_eq!(block, expected);
}

/// The angular velocity and the velocity of a point, each rotated by θ with these signs, and the
/// unrotated values.
struct Turned {
    graph: Graph,
    wholes: [ExprId; 4],
    parts: [ExprId; 4],
    beside: ExprId,
}

impl Turned {
    fn new(signs: [i64; 4]) -> Turned {
        let graph = &mut Graph::new();
        let theta = graph.symbol("theta", Role::Coordinate(0));
        let [c, s] = [Function::Cos, Function::Sin].map(|f| graph.call(f, &[theta]));
        let velocities = [0, 1, 2, 3, 4].map(|i| graph.symbol(&format!("v{i}"), Role::Velocity(i)));
        let [p, q, x, y, beside] = velocities;
        let mut component = |[f, g]: [ExprId; 2], [a, b]: [ExprId; 2], [m, n]: [i64; 2]| {
            let terms = [(graph.multiply(f, a), Number::from(m)), (graph.multiply(g, b), Number::from(n))];
            graph.sum(Number::ZERO, terms)
        };
        let [alpha, beta, gamma, delta] = signs;
        let wholes = [
            component([c, s], [p, q], [alpha, beta]),
            component([s, c], [p, q], [gamma, delta]),
            component([c, s], [x, y], [1, 1]),
            component([s, c], [x, y], [-1, 1]),
        ];
        Turned { graph: std::mem::take(graph), wholes, parts: [p, q, x, y], beside }
    }

    /// Returns all remaining coefficients of the parts, as numbers.
    fn pushed(&mut self, rotations: Rotations) -> (bool, Vec<f64>) {
        let variables = [&self.wholes[..], &[self.beside]].concat();
        let graph = &mut self.graph;
        let mut form = QuadraticForm::default();
        for (n, &i) in variables.iter().enumerate() {
            let load = graph.number(3 + 7 * n as i64);
            form.add_linear(graph, i, load);
            for (m, &j) in variables.iter().enumerate().skip(n) {
                let weight = graph.number(10 * n as i64 * n as i64 + m as i64 + 1);
                form.add_pair(graph, i, j, weight);
            }
        }
        let leaves = [&self.parts[..], &[self.beside]].concat();
        let mut sweep = Sweep::new(graph, [&variables, &[]], &leaves, Multiples::Kept, rotations);
        let has_rotations = sweep.has_rotations();
        while let Some(step) = sweep.next_step() {
            form.apply(graph, &step);
        }
        let pairs = leaves.iter().flat_map(|&i| leaves.iter().map(move |&j| (i, j)));
        let mut left = pairs.map(|(i, j)| form.coefficient(graph, i, j)).collect::<Vec<_>>();
        left.extend(leaves.iter().map(|&i| form.linear(graph, i)).collect::<Vec<_>>());
        (has_rotations, evaluate(graph, &left, |_| 0.7))
    }
}

#[test]
fn rotations_are_found_whatever_their_signs() {
    for bits in 0..16 {
        let signs = [1, 2, 4, 8].map(|bit| if bits & bit == 0 { 1 } else { -1 });
        let mut turned = Turned::new(signs);
        let (_, expected) = turned.pushed(Rotations::Split);
        for rotations in [Rotations::InTurn, Rotations::Last] {
            let (has_rotations, found) = turned.pushed(rotations);
            assert!(has_rotations, "the point turns whatever the signs {signs:?}");
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-12 * 100.0, "{signs:?}: {found} for {expected}");
            }
        }
    }
}
