//! Costs of the equations of robots, in operations; `-- operations --nocapture` prints them.

use lagrange_core::accuracy::Accuracy;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::expr::ExprId;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Derived, parse};
use lagrange_core::program::{Labels, OperationCounts, lower, optimise};

use crate::cases::read;

/// Models with upper bounds on the cost of their accelerations, inverse dynamics and mass matrix:
/// the measured cost plus 2 %.
const MOST: [(&str, [usize; 3]); 8] = [
    ("ur5", [515, 297, 157]),
    ("panda", [1160, 617, 344]),
    ("universal_5", [1181, 475, 591]),
    ("universal_10", [2793, 1031, 2513]),
    ("go2", [3232, 1513, 1069]),
    ("go2_free", [3319, 1498, 919]),
    ("ball_2", [203, 184, 104]),
    ("ball_5", [1400, 683, 1481]),
];

#[test]
fn robots_cost_no_more_operations_than_they_did() {
    println!("| model | accelerations | inverse dynamics | mass matrix |\n|---|---|---|---|");
    for (model, most) in MOST {
        let costs = costs_of(&read(&format!("models/{model}.lag")));
        println!("| {model} | {} | {} | {} |", costs[0], costs[1], costs[2]);
        assert!(costs.iter().zip(most).all(|(cost, most)| *cost <= most), "{model}: {costs:?}");
    }
}

/// Models with upper bounds on the cost of matrices, as above.
const MAX_OF_MATRICES: [(&str, [usize; 3]); 3] =
    [("ur5", [576, 433, 1181]), ("panda", [2547, 693, 5185]), ("go2", [5447, 5375, 11323])];

#[test]
fn matrices_cost_no_more_operations_than_they_did() {
    println!(
        "| model | Coriolis matrix | inverse mass matrix | derivatives of inverse dynamics |\n|---|---|---|---|"
    );
    let products = [Product::CoriolisMatrix, Product::InverseMassMatrix, Product::InverseDynamicsJacobian];
    let asked = products.map(Product::name).join(", ");
    for (model, most) in MAX_OF_MATRICES {
        let derived = derived(&format!("{} emit {{ {asked} }}", read(&format!("models/{model}.lag"))));
        let costs = products.map(|product| cost_of(&derived, product));
        println!("| {model} | {} | {} | {} |", costs[0], costs[1], costs[2]);
        assert!(costs.iter().zip(most).all(|(cost, most)| *cost <= most), "{model}: {costs:?}");
    }
}

/// Counts the operations of accelerations, inverse dynamics and the mass matrix.
pub(crate) fn costs_of(text: &str) -> [usize; 3] {
    let derived = derived(text);
    let accelerations = count(&derived, &derived.equations.accelerations);
    let [dynamics, matrix] =
        [Product::InverseDynamics, Product::MassMatrix].map(|product| cost_of(&derived, product));
    [accelerations, dynamics, matrix]
}

fn derived(text: &str) -> Derived {
    let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
    system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"))
}

fn cost_of(derived: &Derived, product: Product) -> usize {
    count(derived, &derived.equations.product(product, &derived.model).unwrap_or_default())
}

fn count(derived: &Derived, roots: &[ExprId]) -> usize {
    let program = lower(&derived.model.graph, roots, &Labels::default());
    OperationCounts::of(&optimise(&program, Accuracy::Standard)).total()
}
