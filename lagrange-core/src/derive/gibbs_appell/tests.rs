//! The worked example in the module's documentation, and the equivalence of terms.

use super::{GibbsForm, remainder};
use crate::derive::elimination::solution::push_down;
use crate::model::Model;
use crate::pipeline::parse;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

fn model(statements: &str) -> Model {
    parse(statements).unwrap_or_else(|report| panic!("{report}")).model
}

/// Returns the coefficient of q̇² and, without and with accelerations, the coefficient of q̇, for a
/// system with one coordinate q.
fn coefficients(model: &mut Model) -> [ExprId; 3] {
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let gibbs = GibbsForm::new(graph, model.gibbs.expect("a Gibbs function").function);
    let [dropped, kept] = [AccelerationTerms::Dropped, AccelerationTerms::Kept].map(|accelerations| {
        let mut form = gibbs.quadratic.clone();
        gibbs.add_linear(graph, &mut form, accelerations);
        push_down(graph, form, &velocities)
    });
    let q = velocities[0];
    [dropped.coefficient(graph, q, q), dropped.linear(graph, q), kept.linear(graph, q)]
}

/// Evaluates expressions at q, q̇ and q̈, to nine decimal places.
fn values(graph: &Graph, ids: &[ExprId], [q, v, a]: [f64; 3]) -> Vec<f64> {
    let values = evaluate(graph, ids, |role| match role {
        Role::Coordinate(_) => q,
        Role::Velocity(_) => v,
        Role::Acceleration(_) => a,
        _ => f64::NAN,
    });
    values.into_iter().map(|value| (value * 1e9).round() / 1e9).collect()
}

#[test]
fn a_pendulum_in_numbers() {
    let mut model = model(
        "coord theta; let T = 1/2 * 25 * dot(theta)^2; let V = -50 * cos(theta); kinetic = T; potential = V;
        gibbs = 1/2 * (5 * ddot(theta) + 10 * sin(theta))^2, for: T - V;",
    );
    let coefficients = coefficients(&mut model);
    let at = [3.0_f64.atan2(4.0), 1.0, 2.0];
    assert_eq!(values(&model.graph, &coefficients, at), [25.0, 30.0, 80.0]);
}

#[test]
fn velocities_are_no_coefficients_of_principal_parts() {
    // ∂S/∂a = 2 a + 3 q̇² + 5 q, though the product of q̇² and a is affine in a.
    let mut model = model(
        "coord q; kinetic = dot(q)^2; gibbs = ddot(q)^2 + 3 * dot(q)^2 * ddot(q) + 5 * q * ddot(q), for: dot(q)^2;",
    );
    let coefficients = coefficients(&mut model);
    assert_eq!(values(&model.graph, &coefficients, [7.0, 11.0, 13.0]), [2.0, 398.0, 424.0]);
}

#[test]
fn branches_have_branches_as_principal_parts() {
    let mut model = model(
        "coord q; kinetic = dot(q)^2;
        let a = if q < 0 { 2 * ddot(q) } else { 3 * ddot(q) + 1 };
        gibbs = 1/2 * a^2, for: dot(q)^2;",
    );
    let coefficients = coefficients(&mut model);
    assert_eq!(values(&model.graph, &coefficients, [-1.0, 0.0, 1.0]), [4.0, 0.0, 4.0]);
    assert_eq!(values(&model.graph, &coefficients, [1.0, 0.0, 1.0]), [9.0, 3.0, 12.0]);
}

#[test]
fn sums_are_opened_as_far_as_they_agree() {
    let graph = &mut Graph::new();
    let x = (0..12).map(|i| graph.symbol(&format!("x{i}"), Role::Coordinate(i))).collect::<Vec<_>>();
    // More terms than the constructors of sums would flatten.
    let kept = graph.total(x[8..].iter().copied());
    let nested = graph.add(x[0], kept);
    let others = graph.total(x[1..8].iter().copied());
    let whole = graph.add(nested, others);
    let part = graph.total(x[..8].iter().copied());
    let rest = remainder(graph, whole, part);
    assert_eq!(rest, kept);
    assert_eq!(remainder(graph, whole, whole), graph.number(0));
    let more = remainder(graph, kept, part);
    let expected = graph.subtract(kept, part);
    assert_eq!(more, expected);
}
