//! `reduce` statements: names resolved, and what can be wrong with them before anything is reduced.

use proc_macro2::Span;

use super::elaborator::Elaborator;
use super::messages;
use crate::expr::{Dependencies, ExprId};
use crate::model::{Held, Reduction};
use crate::syntax::ast::{self, AstId, ReductionItem, ReductionKind, ScalarType, StatementKind};

/// Methods of reduced types beside those of every system; no output may take their names.
pub const METHODS_OF_REDUCED: [&str; 2] = ["expand", "deviation"];
/// What a value must not depend on, the most telling first.
const CHANGING: [Dependencies; 7] = [
    Dependencies::MULTIPLIER,
    Dependencies::REACTION,
    Dependencies::ACCELERATION,
    Dependencies::VELOCITY,
    Dependencies::COORDINATE,
    Dependencies::INPUT,
    Dependencies::TIME,
];

impl Elaborator<'_> {
    pub(super) fn reduction(&mut self, syntax: &ast::Reduction) {
        self.check_type_name(syntax);
        let mut reduction = Reduction { name: syntax.name.clone(), frozen: Vec::new(), small: Vec::new() };
        for item in &syntax.items {
            let Some(held) = self.held(item) else { continue };
            let named = reduction.frozen.iter().chain(&reduction.small);
            if let Some(earlier) = named.into_iter().find(|earlier| earlier.coordinate == held.coordinate) {
                let message = messages::reduced_twice(&item.coordinate.text);
                let error = self.evaluator.report.error(held.span, message);
                error.related(earlier.span.into(), messages::NAMED_HERE).help(messages::NAMED_TWICE_HELP);
                continue;
            }
            match item.kind {
                ReductionKind::Frozen => reduction.frozen.push(held),
                ReductionKind::Small => reduction.small.push(held),
            }
        }
        self.reductions.push(reduction);
    }

    fn held(&mut self, item: &ReductionItem) -> Option<Held> {
        let name = &item.coordinate;
        self.evaluator.scope.resolve(&name.text);
        let coordinate = self.coordinates.iter().position(|(known, _)| known.name == name.text);
        let value = match item.value {
            Some(syntax) => self.constant_in_motion(syntax, messages::HELD_VALUE),
            None => Some(self.evaluator.graph.number(0)),
        };
        if coordinate.is_none() {
            self.report_no_coordinate(name, messages::REDUCTION_HELP);
        }
        Some(Held { coordinate: coordinate?, value: value?, span: name.span })
    }

    /// A value that does not change during the motion.
    pub(super) fn constant_in_motion(&mut self, syntax: AstId, what: &str) -> Option<ExprId> {
        self.evaluator.evaluate(syntax)?;
        let value = self.evaluator.scalar(syntax, what)?;
        for kind in CHANGING {
            if self.evaluator.graph.dependencies(value).intersects(kind) {
                let (place, _) = self.evaluator.blame(syntax, kind);
                self.evaluator
                    .report
                    .error(place, messages::not_constant(what))
                    .help(messages::CONSTANT_IN_MOTION_HELP);
                return None;
            }
        }
        Some(value)
    }

    /// The types `Name` and `NameState` must be new.
    fn check_type_name(&mut self, syntax: &ast::Reduction) {
        let declaration = self.declaration;
        let full = (declaration.name.text.as_str(), declaration.name.span);
        let earlier = declaration.reductions().map(|(r, _)| (r.name.text.as_str(), r.name.span));
        let earlier = earlier.take(self.reductions.len());
        let parameter = match &declaration.scalar {
            ScalarType::Generic(name) => Some((name.text.as_str(), name.span)),
            _ => None,
        };
        let new = &syntax.name;
        let clashes = |&(name, _): &(&str, Span)| {
            let belongs = |name: &str, to: &str| {
                ["State", "Columns", "Inputs"].iter().any(|suffix| name.strip_suffix(suffix) == Some(to))
            };
            name == new.text || belongs(name, &new.text) || belongs(&new.text, name)
        };
        let types = std::iter::once(full).chain(earlier).chain(parameter);
        if let Some((_, span)) = types.into_iter().find(clashes) {
            let error = self.evaluator.report.error(new.span, messages::type_name_taken(&new.text));
            error.related(span.into(), messages::TYPE_NAMED_HERE).help(messages::TYPE_NAME_HELP);
        }
    }

    /// What can be judged only with all coordinates and outputs known.
    pub(super) fn check_reductions(&mut self) {
        if self.reductions.is_empty() {
            return;
        }
        let report = &mut *self.evaluator.report;
        let all = self.coordinates.len();
        for reduction in self.reductions.iter().filter(|r| all > 0 && r.frozen.len() == all) {
            report.error(reduction.name.span, messages::ALL_FROZEN).help(messages::ALL_FROZEN_HELP);
        }
        for statement in &self.declaration.statements {
            if let StatementKind::Output(name, _) = &statement.kind
                && METHODS_OF_REDUCED.contains(&name.text.as_str())
            {
                let error = report.error(name.span, messages::output_of_reduced(&name.text));
                error.help(messages::OTHER_NAME_HELP);
            }
        }
    }
}
