//! The `stabilise` statement: how fast what is left of constraints decays.
//!
//! Source: Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems", Computer Methods in
//! Applied Mechanics and Engineering 1 (1972), with both gains from one rate, so that residuals decay without overshoot.

use proc_macro2::Span;

use super::elaborator::Elaborator;
use super::messages::events as messages;
use crate::syntax::ast::{AstId, StatementKind};

impl Elaborator<'_> {
    pub(super) fn stabilise(&mut self, syntax: AstId, keyword: Span) {
        if let Some((_, first)) = self.stabilisation {
            let error = self.evaluator.report.error(keyword, messages::STABILISED_TWICE);
            error.related(first.into(), messages::STABILISED_HERE).help(messages::STABILISED_TWICE_HELP);
        }
        let Some(rate) = self.constant_in_motion(syntax, messages::STABILISATION) else { return };
        if let Some(number) = self.numeric(rate).filter(|&number| number < 0.0) {
            let help = messages::NEGATIVE_RATE_HELP;
            self.refuse::<()>(syntax, &messages::negative_rate(number), help);
        }
        self.stabilisation = Some((rate, keyword));
    }

    pub(super) fn check_stabilisation(&mut self) {
        let is_constraint = |kind: &StatementKind| matches!(kind, StatementKind::Constraint(..));
        let is_constrained = self.declaration.statements.iter().any(|s| is_constraint(&s.kind));
        // A constraint may be among what could not be read.
        if is_constrained || !self.declaration.unreadable_words.is_empty() {
            return;
        }
        if let Some((_, keyword)) = self.stabilisation {
            let error = self.evaluator.report.error(keyword, messages::NOTHING_TO_STABILISE);
            error.help(messages::NOTHING_TO_STABILISE_HELP);
        }
    }
}
