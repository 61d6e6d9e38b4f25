//! The double pendulum with absolute angles, from its energies to the text of its equations.

use crate::calculus::{AccelerationTerms, Rates, partial};
use crate::formula::text::text;
use crate::simplify::{present, proves_zero};
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// The double pendulum with absolute angles, derived by brute force from the positions of its
/// masses.
struct DoublePendulum {
    graph: Graph,
    mass: [[ExprId; 2]; 2],
    forcing: [ExprId; 2],
    energy: ExprId,
}

fn double_pendulum() -> DoublePendulum {
    let mut g = Graph::new();
    let [m1, m2, gravity, l1, l2] = ["m1", "m2", "g", "l1", "l2"].map(|name| {
        let index = g.len() as u32;
        g.symbol(name, Role::Parameter(index))
    });
    let angles = [0, 1].map(|i| g.symbol(&format!("theta{}", i + 1), Role::Coordinate(i)));
    let speeds = [0, 1].map(|i| g.symbol(&format!("theta{}", i + 1), Role::Velocity(i)));
    let arm = |g: &mut Graph, f: Function, l: ExprId, angle: ExprId| {
        let f = apply(g, f, &[angle]);
        g.multiply(l, f)
    };
    let (x1, c1) = (arm(&mut g, Function::Sin, l1, angles[0]), arm(&mut g, Function::Cos, l1, angles[0]));
    let (x2, c2) = (arm(&mut g, Function::Sin, l2, angles[1]), arm(&mut g, Function::Cos, l2, angles[1]));
    let (y1, x2) = (g.negate(c1), g.add(x1, x2));
    let y2 = g.subtract(y1, c2);
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let half = Number::ratio(1, 2).expect("no zero");
    let (mut kinetic, mut potential) = (Vec::new(), Vec::new());
    for (m, x, y) in [(m1, x1, y1), (m2, x2, y2)] {
        let squares = [x, y].map(|p| {
            let rate = rates.of(&mut g, p);
            g.square(rate)
        });
        let square = g.total(squares);
        let product = g.multiply(m, square);
        kinetic.push((product, half.clone()));
        potential.push(g.product([m, gravity, y].map(|f| (f, Number::ONE))));
    }
    let kinetic = g.sum(Number::ZERO, kinetic);
    let potential = g.total(potential);
    let momenta = speeds.map(|v| partial(&mut g, kinetic, v));
    let mass = momenta.map(|p| speeds.map(|v| partial(&mut g, p, v)));
    let lagrangian = g.subtract(kinetic, potential);
    let forcing = [0, 1].map(|i| {
        let bias = rates.of(&mut g, momenta[i]);
        let force = partial(&mut g, lagrangian, angles[i]);
        g.subtract(force, bias)
    });
    let energy = g.add(kinetic, potential);
    DoublePendulum { graph: g, mass, forcing, energy }
}

fn presented(d: &mut DoublePendulum, expr: ExprId) -> String {
    let readable = present(&mut d.graph, expr, 200);
    assert_eq!(present(&mut d.graph, readable, 200), readable, "presenting again changes nothing");
    let difference = d.graph.subtract(expr, readable);
    assert!(proves_zero(&mut d.graph, difference, 200), "{}", text(&d.graph, readable));
    text(&d.graph, readable)
}

#[test]
fn the_equations_read_as_in_a_textbook() {
    let mut d = double_pendulum();
    let [[m00, m01], [m10, m11]] = d.mass;
    assert_eq!(presented(&mut d, m00), "(m1 + m2)*l1^2");
    assert_eq!(presented(&mut d, m01), "m2*l1*l2*cos(theta1 - theta2)");
    assert_eq!(presented(&mut d, m10), "m2*l1*l2*cos(theta1 - theta2)");
    assert_eq!(presented(&mut d, m11), "m2*l2^2");
    let [f0, f1] = d.forcing;
    assert_eq!(
        presented(&mut d, f0),
        "-m2*l1*l2*sin(theta1 - theta2)*dot(theta2)^2 - (m1 + m2)*g*l1*sin(theta1)"
    );
    assert_eq!(presented(&mut d, f1), "m2*l1*l2*sin(theta1 - theta2)*dot(theta1)^2 - m2*g*l2*sin(theta2)");
}

#[test]
fn the_energy_reads_as_in_a_textbook() {
    let mut d = double_pendulum();
    let energy = d.energy;
    assert_eq!(
        presented(&mut d, energy),
        "1/2*(m1 + m2)*l1^2*dot(theta1)^2 + m2*l1*l2*cos(theta1 - theta2)*dot(theta1)*dot(theta2) \
         + 1/2*m2*l2^2*dot(theta2)^2 - (m1 + m2)*g*l1*cos(theta1) - m2*g*l2*cos(theta2)"
    );
}
