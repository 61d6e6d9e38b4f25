//! The worked order in the module's documentation.

use super::{Multiples, Rotations, Step, Sweep};
use crate::derive::plane_rotation::TurnedPair;
use crate::pipeline::parse;
use lagrange_algebra::formula::text::text;

/// Returns the substitutions and the generalised velocities that become free between them, as text.
fn order(declaration: &str, rotations: Rotations) -> Vec<String> {
    let mut model = parse(declaration).unwrap_or_else(|report| panic!("{report}")).model;
    let heads = match model.outputs.first() {
        Some(output) => output.components.clone(),
        None => model.rates.iter().map(|(velocity, _)| *velocity).collect::<Vec<_>>(),
    };
    let velocities = model.velocities();
    let mut sweep = Sweep::new(&mut model.graph, [&heads, &[]], &velocities, Multiples::Merged, rotations);
    let name = |id| {
        let label = model.labels.iter().find(|(labelled, _)| *labelled == id);
        label.map_or_else(|| text(&model.graph, id), |(_, name)| name.clone())
    };
    let names = |ids: &mut dyn Iterator<Item = _>| ids.map(name).collect::<Vec<_>>().join(", ");
    let mut order = Vec::new();
    loop {
        if let Some(free) = sweep.next_leaf() {
            order.push(format!("{} is free", name(free)));
        } else if let Some(step) = sweep.next_step() {
            order.push(match step {
                Step::Replace(id, parts) => {
                    format!("{} by {}", name(id), names(&mut parts.iter().map(|(part, _)| *part)))
                }
                Step::Collapse(target, multiples) => {
                    format!("{} by {}", names(&mut multiples.iter().map(|(id, _)| *id)), name(target))
                }
                Step::Turn(pairs) => {
                    let [wholes, parts] =
                        [|pair: &TurnedPair| pair.turned.clone(), |pair: &TurnedPair| pair.parts.clone()]
                            .map(|of| names(&mut pairs.iter().flat_map(of).map(|(id, _)| id)));
                    format!("{wholes} turned to {parts}")
                }
            });
        } else {
            return order;
        }
    }
}

#[test]
fn the_outer_body_is_finished_before_the_one_that_carries_it() {
    let found = order(
        "param m1, m2, l1, l2, g; coord theta1, theta2;
        let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
        let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
        kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
        potential = m1 * g * y1 + m2 * g * y2;",
        Rotations::Last,
    );
    let expected = [
        "y2_dot by y1_dot, l2*sin(theta2)*dot(theta2)",
        "x2_dot by x1_dot, l2*cos(theta2)*dot(theta2)",
        "l2*sin(theta2)*dot(theta2), l2*cos(theta2)*dot(theta2) by dot(theta2)",
        "dot(theta2) is free",
        "y1_dot, x1_dot by dot(theta1)",
        "dot(theta1) is free",
    ];
    assert_eq!(found, expected);
}

#[test]
fn axes_are_turned_when_what_a_joint_moves_is_eliminated() {
    let text = "coord x, y, a;
        let along = cos(a) * dot(x) + sin(a) * dot(y);
        let across = cos(a) * dot(y) - sin(a) * dot(x);
        let end = across + 3 * dot(a);
        kinetic = 1/2 * (along^2 + end^2); output heads = (along, end);";
    let found = [Rotations::Last, Rotations::Split].map(|rotations| order(text, rotations));
    let turned = [
        "end by dot(a), across",
        "dot(a) is free",
        "along, across turned to dot(x), dot(y)",
        "dot(x) is free",
        "dot(y) is free",
    ];
    let split = [
        "end by dot(a), across",
        "dot(a) is free",
        "across by cos(a)*dot(y), sin(a)*dot(x)",
        "along by cos(a)*dot(x), sin(a)*dot(y)",
        "cos(a)*dot(y), sin(a)*dot(y) by dot(y)",
        "dot(y) is free",
        "sin(a)*dot(x), cos(a)*dot(x) by dot(x)",
        "dot(x) is free",
    ];
    assert_eq!(found, [turned.map(str::to_owned).to_vec(), split.map(str::to_owned).to_vec()]);
}
