//! Bodies whose mass or inertia changes.

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages::inertia as words;
use crate::model::Product;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Name};

/// Mass and inertia may depend on these.
const ALLOWED: Dependencies =
    Dependencies::PARAMETER.with(Dependencies::TIME).with(Dependencies::STATE).with(Dependencies::DISCRETE);

/// Checks that a mass or inertia changes neither with the motion nor with inputs, whose rates are
/// unknown.
pub(super) fn unmoved(elaborator: &mut Elaborator, what: &str, syntax: AstId) {
    let Some(value) = value_of(&mut elaborator.evaluator, syntax) else { return };
    let graph = &elaborator.evaluator.graph;
    let depends = |kinds| value.components().iter().any(|&part| graph.dependencies(part).intersects(kinds));
    // Noise is reported in the energies of the body.
    if depends(Dependencies::NOISE) {
        return;
    }
    let (message, help) = if depends(Dependencies::INPUT) {
        (words::matter_of_input(what), words::MATTER_OF_INPUT_HELP)
    } else if value.components().iter().any(|&part| !graph.dependencies(part).is_within(ALLOWED)) {
        (words::moving_matter(what), words::MOVING_MATTER_HELP)
    } else {
        return;
    };
    let origin = elaborator.evaluator.origin(syntax);
    elaborator.evaluator.report.error(origin, message).help(help);
}

/// Checks that an inertia changes between events only with the mass, and that no product needs
/// constant masses.
pub(super) fn changes(elaborator: &mut Elaborator, body: &Name, mass: AstId, inertia: &[AstId]) {
    let Some(mass) = value_of(&mut elaborator.evaluator, mass) else { return };
    let values = inertia.iter().filter_map(|&entry| value_of(&mut elaborator.evaluator, entry));
    let values = values.flat_map(|value| value.components().to_vec()).chain(mass.components().to_vec());
    let values = values.collect::<Vec<_>>();
    let graph = &elaborator.evaluator.graph;
    let are = |kinds| values.iter().all(|&value| graph.dependencies(value).is_within(kinds));
    if are(Dependencies::PARAMETER) || !are(ALLOWED) {
        return;
    }
    let sources = changing_symbols(elaborator, mass.components());
    for &entry in inertia {
        let Some(value) = value_of(&mut elaborator.evaluator, entry) else { return };
        let own = changing_symbols(elaborator, value.components());
        if own.iter().any(|symbol| !sources.contains(symbol)) {
            let origin = elaborator.evaluator.origin(entry);
            let error = elaborator.evaluator.report.error(origin, words::inertia_alone(&body.text));
            error.help(words::INERTIA_ALONE_HELP);
            return;
        }
    }
    for span in elaborator.demands(Product::Regressor) {
        let report = &mut *elaborator.evaluator.report;
        let error = report.error(span, words::regressor_of_changing_mass(&body.text));
        error.related(body.span.into(), words::BODY_IS_HERE).help(words::REGRESSOR_OF_CHANGING_MASS_HELP);
    }
}

/// Returns time and states on which values depend.
fn changing_symbols(elaborator: &Elaborator, values: &[ExprId]) -> Vec<Role> {
    let graph = &elaborator.evaluator.graph;
    let roles = graph.reachable(values).into_iter().filter_map(|id| Some(graph.symbol_of(id)?.role));
    roles.filter(|role| matches!(role, Role::Time | Role::State(_))).collect()
}
