//! The worked example in the module's documentation.

use super::{SplitLagrangian, Terms, least_constraint_form};
use crate::derive::elimination::solution::push_down;
use crate::derive::quadratic_form::QuadraticForm;
use crate::model::Model;
use crate::pipeline::parse;
use lagrange_algebra::calculus::{AccelerationTerms, Rates};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

fn model(statements: &str) -> Model {
    parse(statements).unwrap_or_else(|report| panic!("{report}")).model
}

fn form(model: &mut Model) -> (SplitLagrangian, QuadraticForm) {
    let split = SplitLagrangian::new(model);
    let form = least_constraint_form(model, &split, AccelerationTerms::Dropped, Terms::All);
    (split, form)
}

/// Evaluates an expression at these positions and velocities, to nine decimal places.
fn value(graph: &Graph, id: ExprId, positions: &[f64], velocities: &[f64]) -> f64 {
    let value = evaluate(graph, &[id], |role| match role {
        Role::Parameter(0) => 1.0,
        Role::Parameter(1) => 5.0,
        Role::Parameter(_) => 10.0,
        Role::Coordinate(i) => positions[i as usize],
        Role::Velocity(i) => velocities[i as usize],
        _ => f64::NAN,
    });
    (value[0] * 1e9).round() / 1e9
}

#[test]
fn a_pendulum_in_numbers() {
    let mut model = model(
        "param m, l, g; coord theta; let (x, y) = (l * sin(theta), -l * cos(theta));
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); potential = m * g * y;",
    );
    let (split, form) = form(&mut model);
    let (velocities, rates) = (model.velocities(), [0, 1].map(|i| model.rates[i].0));
    let graph = &mut model.graph;
    let at = |graph: &Graph, id| value(graph, id, &[3.0_f64.atan2(4.0)], &[1.0]);
    let [x_dot, y_dot] = rates;
    assert_eq!([x_dot, y_dot].map(|u| at(graph, u)), [4.0, 3.0]);
    let squares = [x_dot, y_dot].map(|u| form.coefficient(graph, u, u));
    assert_eq!(squares.map(|weight| at(graph, weight)), [1.0, 1.0]);
    let linear = [x_dot, y_dot].map(|u| form.linear(graph, u));
    assert_eq!(linear.map(|load| at(graph, load)), [-3.0, 4.0]);
    let power = Rates::new(AccelerationTerms::Dropped).of(graph, split.potential);
    let load = form.linear(graph, power);
    assert_eq!((at(graph, power), at(graph, load)), (30.0, 1.0));

    let pushed = push_down(graph, form, &velocities);
    let mass = pushed.coefficient(graph, velocities[0], velocities[0]);
    let load = pushed.linear(graph, velocities[0]);
    assert_eq!((at(graph, mass), at(graph, load)), (25.0, 30.0));
}

#[test]
fn polar_coordinates_in_numbers() {
    let mut model = model("param m; coord r, phi; kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(phi)^2);");
    let (_, form) = form(&mut model);
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let pushed = push_down(graph, form, &velocities);
    let at = |graph: &Graph, id| value(graph, id, &[2.0, 0.0], &[3.0, 5.0]);
    let weights = [0, 1].map(|i| pushed.coefficient(graph, velocities[i], velocities[i]));
    assert_eq!(weights.map(|weight| at(graph, weight)), [1.0, 4.0]);
    let linear = [0, 1].map(|i| pushed.linear(graph, velocities[i]));
    assert_eq!(linear.map(|load| at(graph, load)), [-50.0, 60.0]);
}
