//! Names that stand for nothing where they are used: each is reported once, with the number of other places.

use std::collections::BTreeSet;

use super::expression::Evaluator;
use super::messages;
use super::scope::Kind;
use crate::collections::OrderedMap;
use crate::diagnostics::Origin;
use crate::syntax::foreign;

/// What was reported of names.
#[derive(Default)]
pub(super) struct Unresolved {
    names: OrderedMap<String, Places>,
    /// Names that are used too early.
    late: Vec<Late>,
    /// The number of the statement that is looked at.
    pub(super) statement: usize,
}

/// A name that is used before it is declared. One statement that stands too early or too late is one mistake.
#[derive(Clone, Copy)]
struct Late {
    /// The number of the statement that uses it.
    user: usize,
    /// The number of the statement that declares it.
    declaration: usize,
    /// The number of the mistake that was reported.
    mistake: usize,
}

/// Where a name stands.
struct Places {
    /// The number of the mistake that was reported at the first of them.
    mistake: usize,
    /// Whether the mistake names it, and not another name beside which it was reported.
    is_named: bool,
    /// Lines and columns, the first place included.
    all: BTreeSet<(usize, usize)>,
}

fn place(origin: Origin) -> (usize, usize) {
    let start = origin.start.start();
    (start.line, start.column)
}

impl Places {
    fn new(mistake: usize, origin: Origin) -> Places {
        Places { mistake, is_named: true, all: BTreeSet::from([place(origin)]) }
    }
}

/// Whether a name is written as constants of Rust are: several capital letters.
fn is_constant_of_rust(name: &str) -> bool {
    let is_capital = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    name.len() > 2 && name.chars().all(is_capital)
}

impl Evaluator<'_> {
    /// Whether it was reported already that a name has no meaning where it is used, so that this place only counts.
    pub(super) fn is_known_unresolved(&mut self, name: &str, origin: Origin) -> bool {
        let places = self.unresolved.names.get_mut(&name.to_owned());
        places.map(|places| places.all.insert(place(origin))).is_some()
    }

    /// Reports a name without a meaning.
    pub(super) fn report_unknown(&mut self, name: &str, origin: Origin, help: impl Into<String>) {
        self.report.error(origin, messages::names::unknown_name(name)).help(help);
        self.remember(name, origin);
    }

    fn remember(&mut self, name: &str, origin: Origin) {
        let mistake = self.report.diagnostics().len() - 1;
        self.unresolved.names.insert(name.to_owned(), Places::new(mistake, origin));
    }

    /// Whether an unknown name is declared further down, which is reported here, or may have been declared
    /// where the declaration could not be read. Names of one statement are too far down together.
    pub(super) fn is_declared_elsewhere(&mut self, name: &str, origin: Origin) -> bool {
        let Some((statement, declaration)) = self.declaration.find(name) else {
            return self.declaration.lacks_names
                || self.declaration.unreadable_words.contains(&name.to_owned());
        };
        let (late, user) = (&mut self.unresolved.late, self.unresolved.statement);
        let reported = late.iter().find(|late| late.user == user || late.declaration == statement).copied();
        let mistake = match reported {
            Some(late) => {
                if let Some(mistake) = self.report.diagnostic_mut(late.mistake) {
                    mistake.related(declaration.into(), messages::names::also_declared_here(name));
                }
                late.mistake
            }
            None => {
                let error = self
                    .report
                    .error(origin, messages::names::used_too_early(name))
                    .help(messages::names::ORDER_HELP);
                error.related(declaration.into(), messages::names::DECLARED_HERE);
                self.report.diagnostics().len() - 1
            }
        };
        late.push(Late { user, declaration: statement, mistake });
        let places = Places { is_named: reported.is_none(), ..Places::new(mistake, origin) };
        self.unresolved.names.insert(name.to_owned(), places);
        true
    }

    /// What to do about a name without a meaning: how it is spelt here, or where it is to be declared.
    pub(super) fn help_for_unknown(&self, name: &str) -> String {
        let moves = |name: &str| {
            let entry = self.scope.find(name);
            entry.is_some_and(|entry| matches!(entry.kind, Kind::Coordinate | Kind::Abbreviation))
        };
        if let Some(rate) = foreign::rate(name, moves) {
            return messages::names::write_call(&rate.written());
        }
        if let Some(meant) = foreign::letter(name).filter(|meant| self.scope.find(meant).is_some()) {
            return messages::names::write_call(&meant);
        }
        if let Some(meant) = foreign::name(name) {
            return messages::names::write_call(meant);
        }
        if foreign::is_library(name) {
            return messages::names::PLAIN_NAMES_HELP.to_owned();
        }
        if let ([single], true) = (&self.declaration.coordinates()[..], foreign::is_word_for_rate(name)) {
            return messages::names::rate_of_single(&single.text);
        }
        match self.scope.nearest(name, Kind::has_value) {
            Some(nearest) => messages::names::did_you_mean(nearest),
            None if is_constant_of_rust(name) => messages::names::RUST_CONSTANT_HELP.to_owned(),
            None => messages::names::DECLARE_FIRST.to_owned(),
        }
    }

    /// Adds the number of other places to what was reported of names.
    pub(super) fn count_unresolved(&mut self) {
        let is_elsewhere = |places: &Places| places.is_named && places.all.len() > 1;
        for (_, places) in self.unresolved.names.iter().filter(|(_, places)| is_elsewhere(places)) {
            if let Some(mistake) = self.report.diagnostic_mut(places.mistake) {
                mistake.message.push_str(&messages::names::and_elsewhere(places.all.len() - 1));
            }
        }
    }
}
