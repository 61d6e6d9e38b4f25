//! Missing derivatives of user functions.

use super::product::plan;
use crate::emit::base::callees::MissingDerivative;
use crate::emit::base::writer::MethodWriter;
use lagrange_expr::expr::{ExprId, Node};
use lagrange_expr::opaque::Opaque;

/// Description of the equations of motion as a caller.
const EQUATIONS: &str = "the equations of motion";

/// Returns the derivatives that the written methods call but the user has not declared, each with
/// its caller.
pub(in crate::emit) fn missing_derivatives(writer: &mut MethodWriter<'_>) -> Vec<MissingDerivative> {
    let called = writer.members.callees.clone();
    called.into_iter().filter(Opaque::is_missing).map(|derivative| because(writer, derivative)).collect()
}

fn because(writer: &mut MethodWriter<'_>, derivative: Opaque) -> MissingDerivative {
    let of_motion = writer.equations.of_motion(writer.model);
    if holds(writer, &of_motion, &derivative) {
        return MissingDerivative { derivative, needed_by: EQUATIONS.to_owned(), product: None };
    }
    for product in writer.model.products.clone() {
        let planned = plan(product, writer.model, writer.equations, writer.shape);
        if planned.is_some_and(|plan| holds(writer, &plan.roots, &derivative)) {
            let (name, needed_by) = (product.name(), format!("the method `{}`", product.name()));
            return MissingDerivative { derivative, needed_by, product: Some(name) };
        }
    }
    let outputs = writer.model.outputs.iter().find(|output| holds(writer, &output.components, &derivative));
    let needed_by =
        outputs.map_or_else(|| EQUATIONS.to_owned(), |output| format!("the output `{}`", output.name));
    MissingDerivative { derivative, needed_by, product: None }
}

fn holds(writer: &MethodWriter<'_>, roots: &[ExprId], derivative: &Opaque) -> bool {
    let graph = &writer.model.graph;
    let is_it = |id: ExprId| matches!(graph.node(id), Node::Opaque(function, _) if function == derivative);
    graph.reachable(roots).into_iter().any(is_it)
}
