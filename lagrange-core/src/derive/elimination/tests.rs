//! The worked example in the module's documentation.

use super::order::eliminate_dense;
use crate::derive::quadratic_form::QuadraticForm;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Creates a form with these coefficients of products, including squares, and of single variables.
fn form(graph: &mut Graph, pairs: &[(ExprId, ExprId, i32)], linear: &[(ExprId, i32)]) -> QuadraticForm {
    let mut form = QuadraticForm::default();
    for &(i, j, weight) in pairs {
        let weight = graph.number(i64::from(weight));
        form.add_pair(graph, i, j, weight);
    }
    for &(i, load) in linear {
        let load = graph.number(i64::from(load));
        form.add_linear(graph, i, load);
    }
    form
}

fn numbers(graph: &Graph, ids: impl IntoIterator<Item = ExprId>) -> Vec<f64> {
    let number = |id| graph.as_number(id).map_or(f64::NAN, Number::to_f64);
    ids.into_iter().map(number).collect()
}

#[test]
fn two_masses_in_numbers() {
    let graph = &mut Graph::new();
    let [x, y] = [0, 1].map(|i| graph.symbol(["x", "y"][i as usize], Role::Velocity(i)));
    let form = form(graph, &[(x, x, 2), (x, y, 1), (y, y, 1)], &[(x, 3), (y, 5)]);
    let elimination = eliminate_dense(graph, form, &[x, y]).expect("a regular matrix");
    let [first, second] = elimination.eliminated.as_slice() else { panic!("two steps") };
    assert_eq!(numbers(graph, [first.pivot, first.factors[0].1, first.free]), [2.0, 0.5, -1.5]);
    assert_eq!(numbers(graph, [second.pivot, second.bias, second.free]), [0.5, 3.5, -7.0]);
    let values = elimination.values(graph, &[x, y]);
    assert_eq!(numbers(graph, values), [2.0, -7.0]);
    let unit = [1, 0].map(|value| graph.number(value));
    let values = elimination.solve_again(graph, &unit, &[x, y]);
    assert_eq!(numbers(graph, values), [-1.0, 1.0]);
}

#[test]
fn a_mass_on_a_slope_in_numbers() {
    let graph = &mut Graph::new();
    let [x, y] = [0, 1].map(|i| graph.symbol(["x", "y"][i as usize], Role::Velocity(i)));
    let multiplier = graph.symbol("c", Role::Multiplier(0));
    let unknowns = [x, y, multiplier];
    let pairs = [(x, x, 1), (y, y, 1), (x, multiplier, 3), (y, multiplier, -4)];
    let form = form(graph, &pairs, &[(y, 10)]);
    let elimination = eliminate_dense(graph, form, &unknowns).expect("a regular matrix");
    let pivots = elimination.eliminated.iter().map(|step| step.pivot).collect::<Vec<_>>();
    assert_eq!(numbers(graph, pivots), [1.0, 1.0, -25.0]);
    let biases = elimination.eliminated.iter().map(|step| step.bias).collect::<Vec<_>>();
    assert_eq!(numbers(graph, biases), [0.0, 10.0, 40.0]);
    assert_eq!(numbers(graph, elimination.ratios.iter().copied()), [1.0]);
    let values = elimination.values(graph, &unknowns);
    assert_eq!(numbers(graph, values), [-4.8, -3.6, 1.6]);
}
