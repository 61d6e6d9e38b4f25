//! Gibbs functions: equations of motion for part of the Lagrangian, in terms of accelerations.

use proc_macro2::Span;

use super::carried::{MOTION, report_carried_rate};
use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages;
use crate::model::GibbsFunction;
use lagrange_algebra::calculus::polynomial_degree;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_language::syntax::ast::AstId;

pub(super) fn add_gibbs(elaborator: &mut Elaborator<'_>, function: AstId, stated: AstId, keyword: Span) {
    let value = gibbs_value(elaborator, function);
    report_carried_rate(&mut elaborator.evaluator, function, MOTION);
    let stated = elaborator.term(stated, keyword, "the part of the Lagrangian that a Gibbs function states");
    if let (Some(function), Some(stated)) = (value, stated) {
        elaborator.gibbs.push(GibbsFunction { function, stated: stated.value });
    }
}

/// Returns a scalar that is linear or quadratic in the accelerations.
fn gibbs_value(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<ExprId> {
    let what = "a Gibbs function";
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, what)?;
    let forces = &[Dependencies::MULTIPLIER, Dependencies::REACTION];
    elaborator.forbid(forces, (syntax, value), what, messages::GIBBS_HELP)?;
    match polynomial_degree(&elaborator.evaluator.graph, value, Dependencies::ACCELERATION) {
        Some(1 | 2) => Some(value),
        // Bodies on joints without inertia.
        Some(0) if !elaborator.evaluator.declaration.expressions.is_written(syntax) => None,
        Some(0) => {
            elaborator.evaluator.refuse(syntax, messages::GIBBS_WITHOUT_ACCELERATIONS, messages::GIBBS_HELP)
        }
        _ => elaborator.evaluator.refuse(syntax, messages::GIBBS_OF_HIGH_DEGREE, messages::GIBBS_HELP),
    }
}

/// Returns the sum of all Gibbs functions, which gives the sum of their equations.
pub(super) fn total_gibbs(elaborator: &mut Elaborator<'_>) -> Option<GibbsFunction> {
    let graph = &mut elaborator.evaluator.graph;
    let functions = elaborator.gibbs.iter().map(|gibbs| gibbs.function).collect::<Vec<_>>();
    let stated = elaborator.gibbs.iter().map(|gibbs| gibbs.stated).collect::<Vec<_>>();
    let is_any = !functions.is_empty();
    is_any.then(|| GibbsFunction { function: graph.total(functions), stated: graph.total(stated) })
}
