mod counts;
mod lowering;
mod passes;
pub(crate) mod random;
mod verifier;

use super::{Labels, OperationCounts, Program, lower, optimise, verify};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

/// Returns a graph with parameters `a` to `d` and coordinates `x` and `y`.
pub(crate) fn letters() -> (Graph, [ExprId; 4], [ExprId; 2]) {
    let mut graph = Graph::new();
    let parameters = ["a", "b", "c", "d"];
    let parameters = std::array::from_fn(|i| graph.symbol(parameters[i], Role::Parameter(i as u32)));
    let coordinates = ["x", "y"];
    let coordinates = std::array::from_fn(|i| graph.symbol(coordinates[i], Role::Coordinate(i as u32)));
    (graph, parameters, coordinates)
}

pub(crate) fn lowered(graph: &Graph, outputs: &[ExprId]) -> Program {
    let program = lower(graph, outputs, &Labels::default());
    assert_eq!(verify(&program), Ok(()), "{program:?}");
    program
}

/// Returns the program after every pass, each of which is verified.
fn optimised(graph: &Graph, outputs: &[ExprId]) -> Program {
    let mut program = lowered(graph, outputs);
    for pass in super::passes(Accuracy::Standard) {
        program = (pass.run)(&program);
        assert_eq!(verify(&program), Ok(()), "after {}: {program:?}", pass.name);
    }
    program
}

fn counts(graph: &Graph, outputs: &[ExprId]) -> String {
    let before = OperationCounts::of(&lowered(graph, outputs));
    let after = OperationCounts::of(&optimise(&lowered(graph, outputs), Accuracy::Standard));
    if before.functions == after.functions {
        assert_eq!(before, after, "fusing and ordering add no work");
    }
    after.to_string()
}
