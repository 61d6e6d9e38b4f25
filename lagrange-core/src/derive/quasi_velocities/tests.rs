//! The worked example in the module's documentation.

use crate::derive::least_constraint::{SplitLagrangian, Terms, linear_form};
use crate::pipeline::parse;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_expr::expr::evaluate;
use lagrange_expr::symbol::Role;

#[test]
fn a_rotating_frame_in_numbers() {
    let text = "coord x, y, q;
        let (u1, u2) = (cos(q)*dot(x) + sin(q)*dot(y), cos(q)*dot(y) - sin(q)*dot(x));
        kinetic = 1/2*(u1^2 + u2^2) + 1/2*dot(q)^2;";
    let mut model = parse(text).unwrap_or_else(|report| panic!("{report}")).model;
    let split = SplitLagrangian::new(&mut model);
    let node = |name: &str| model.labels.iter().find(|(_, label)| label == name).expect("a name").0;
    let nodes = [node("u1"), node("u2"), model.speeds[2].velocity];
    let form = linear_form(&mut model, &split, AccelerationTerms::Kept, Terms::Inertial);
    let loads = nodes.map(|node| form.linear(&mut model.graph, node));
    // The mass moves on a circle about the origin, so its components along the axes are constant.
    let found = evaluate(&model.graph, &loads, |role| match role {
        Role::Coordinate(2) => 0.0,
        Role::Velocity(i) => [-8.0, 6.0, 2.0][i as usize],
        Role::Acceleration(i) => [-12.0, -16.0, 0.0][i as usize],
        _ => f64::NAN,
    });
    assert_eq!(found, [-12.0, -16.0, 0.0]);
}
