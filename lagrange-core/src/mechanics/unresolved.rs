//! Names that stand for nothing where they are used: each is reported once, with the number of other places.

use std::collections::BTreeSet;

use super::expression::Evaluator;
use super::messages;
use super::scope::Kind;
use crate::collections::OrderedMap;
use crate::diagnostics::Origin;

/// What was reported of names.
#[derive(Default)]
pub(super) struct Unresolved {
    names: OrderedMap<String, Places>,
}

/// Where a name stands.
struct Places {
    /// The number of the mistake that was reported at the first of them.
    mistake: usize,
    /// Lines and columns, the first place included.
    all: BTreeSet<(usize, usize)>,
}

fn place(origin: Origin) -> (usize, usize) {
    let start = origin.start.start();
    (start.line, start.column)
}

impl Evaluator<'_> {
    /// Whether it was reported already that a name has no meaning where it is used, so that this place only counts.
    pub(super) fn is_known_unresolved(&mut self, name: &str, origin: Origin) -> bool {
        let places = self.unresolved.names.get_mut(&name.to_owned());
        places.map(|places| places.all.insert(place(origin))).is_some()
    }

    /// Reports a name without a meaning.
    pub(super) fn report_unknown(&mut self, name: &str, origin: Origin, help: impl Into<String>) {
        self.report.error(origin, messages::unknown_name(name)).help(help);
        self.remember(name, origin);
    }

    fn remember(&mut self, name: &str, origin: Origin) {
        let mistake = self.report.diagnostics().len() - 1;
        self.unresolved
            .names
            .insert(name.to_owned(), Places { mistake, all: BTreeSet::from([place(origin)]) });
    }

    /// Whether an unknown name is declared further down, which is reported here, or may have been declared
    /// where the declaration could not be read.
    pub(super) fn is_declared_elsewhere(&mut self, name: &str, origin: Origin) -> bool {
        if let Some(declaration) = self.declaration.find(name) {
            let error = self.report.error(origin, messages::used_too_early(name)).help(messages::ORDER_HELP);
            error.related(declaration.into(), messages::DECLARED_HERE);
            self.remember(name, origin);
            return true;
        }
        self.declaration.unreadable_words.contains(&name.to_owned())
    }

    pub(super) fn help_for_unknown(&self, name: &str) -> String {
        let is_coordinate = |name: &str| self.scope.find(name).is_some_and(|e| e.kind == Kind::Coordinate);
        for (suffix, function) in [("_ddot", "ddot"), ("_dot", "dot")] {
            // The state has fields of these names.
            if let Some(coordinate) = name.strip_suffix(suffix).filter(|name| is_coordinate(name)) {
                return messages::write_call(&format!("{function}({coordinate})"));
            }
        }
        match self.scope.nearest(name, Kind::has_value) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => messages::DECLARE_FIRST.to_owned(),
        }
    }

    /// Adds the number of other places to what was reported of names.
    pub(super) fn count_unresolved(&mut self) {
        for (_, places) in self.unresolved.names.iter().filter(|(_, places)| places.all.len() > 1) {
            if let Some(mistake) = self.report.diagnostic_mut(places.mistake) {
                mistake.message.push_str(&messages::and_elsewhere(places.all.len() - 1));
            }
        }
    }
}
