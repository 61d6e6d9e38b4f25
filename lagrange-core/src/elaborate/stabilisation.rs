//! The `stabilise` statement: the rate at which residuals of constraints decay.
//!
//! Source: Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems",
//! Computer Methods in Applied Mechanics and Engineering 1 (1972), with both gains derived from one
//! rate, so that residuals decay without overshoot.

use proc_macro2::Span;

use super::elaborator::Elaborator;
use super::messages::events as messages;
use lagrange_language::syntax::ast::{AstId, StatementKind};

pub(super) fn set_stabilisation(elaborator: &mut Elaborator<'_>, syntax: AstId, keyword: Span) {
    if let Some((_, first)) = elaborator.stabilisation {
        let error = elaborator.evaluator.report.error(keyword, messages::STABILISED_TWICE);
        error.related(first.into(), messages::STABILISED_HERE).help(messages::STABILISED_TWICE_HELP);
    }
    let Some(rate) = elaborator.constant_in_motion(syntax, messages::STABILISATION) else { return };
    if let Some(number) = elaborator.numeric(rate).filter(|&number| number < 0.0) {
        let help = messages::NEGATIVE_RATE_HELP;
        elaborator.evaluator.refuse::<()>(syntax, &messages::negative_rate(number), help);
    }
    elaborator.stabilisation = Some((rate, keyword));
}

pub(super) fn check_stabilisation(elaborator: &mut Elaborator<'_>) {
    let is_constraint = |kind: &StatementKind| matches!(kind, StatementKind::Constraint(..));
    let is_constrained = elaborator.declaration.statements.iter().any(|s| is_constraint(&s.kind));
    // A statement that could not be read may be a constraint.
    if is_constrained || !elaborator.declaration.unreadable_words.is_empty() {
        return;
    }
    if let Some((_, keyword)) = elaborator.stabilisation {
        let error = elaborator.evaluator.report.error(keyword, messages::NOTHING_TO_STABILISE);
        error.help(messages::NOTHING_TO_STABILISE_HELP);
    }
}
