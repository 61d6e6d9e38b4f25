//! Names of a declaration: those of the scene with their objects, and names of plain statements that nobody else uses.

use super::messages;
use super::object::Object;
use crate::collections::{HashMap, OrderedMap};
use crate::diagnostics::{Report, nearest};
use crate::syntax::ast::{Declaration, Expression, Name, SceneStatement, StatementKind};

/// The names of a declaration.
pub(super) struct SceneNames {
    /// Objects of the scene that were declared so far.
    objects: OrderedMap<String, Object>,
    /// Objects that are declared anywhere.
    all_objects: OrderedMap<String, Name>,
    /// Parameters and constants.
    fixed: HashMap<String, ()>,
    /// Names declared anywhere but on lines.
    declared: HashMap<String, ()>,
    /// Names that plain statements must not take.
    taken: HashMap<String, ()>,
    /// Number of nameless statements of each kind.
    nameless: HashMap<String, u32>,
}

impl SceneNames {
    pub(super) fn new(declaration: &Declaration) -> SceneNames {
        let mut all_objects = OrderedMap::default();
        let (mut taken, mut fixed, mut declared) =
            (HashMap::default(), HashMap::default(), HashMap::default());
        for statement in &declaration.statements {
            let is_object = matches!(statement.kind, StatementKind::Scene(_));
            let is_line = matches!(statement.kind, StatementKind::Scene(SceneStatement::Line(_)));
            let is_fixed =
                matches!(statement.kind, StatementKind::Parameters(_) | StatementKind::Constants(_));
            for name in statement.kind.declared_names() {
                // A name that stands for something else already is not one that is used too early.
                if is_object && !taken.contains(&name.text) {
                    all_objects.insert(name.text.clone(), name.clone());
                }
                if !is_line {
                    declared.insert(name.text.clone(), ());
                }
                if is_fixed {
                    fixed.insert(name.text.clone(), ());
                }
            }
            for name in [statement.kind.declared_names(), statement.kind.member_names()].concat() {
                taken.insert(name.text.clone(), ());
            }
        }
        for (_, expression) in declaration.expressions.iter() {
            if let Expression::Name(name) = expression {
                taken.insert(name.clone(), ());
            }
        }
        let objects = OrderedMap::default();
        SceneNames { objects, all_objects, fixed, declared, taken, nameless: HashMap::default() }
    }

    pub(super) fn declare(&mut self, name: &str, object: Object) {
        self.objects.insert(name.to_owned(), object);
    }

    /// Object declared under a name so far.
    pub(super) fn find(&self, name: &str) -> Option<&Object> {
        self.objects.get(&name.to_owned())
    }

    /// Declaration of an object of that name, be it further down.
    pub(super) fn anywhere(&self, name: &str) -> Option<&Name> {
        self.all_objects.get(&name.to_owned())
    }

    /// Whether something else than a line has this name, be it further down.
    pub(super) fn is_declared(&self, name: &str) -> bool {
        self.declared.contains(&name.to_owned())
    }

    /// Whether a name stands for a number that does not change during the motion.
    pub(super) fn is_fixed(&self, name: &str) -> bool {
        name == "pi" || self.fixed.contains(&name.to_owned())
    }

    /// The name of an object like this one.
    pub(super) fn nearest(&self, name: &str, accept: impl Fn(&Object) -> bool) -> Option<&str> {
        let known = self.objects.iter().filter(|(_, object)| accept(object));
        nearest(name, known.map(|(name, _)| name.as_str()))
    }

    /// A name like `wish` that nothing has.
    pub(super) fn fresh(&mut self, wish: &str) -> String {
        let mut name = wish.to_owned();
        let mut count = 1;
        while self.taken.contains(&name) {
            count += 1;
            name = format!("{wish}_{count}");
        }
        self.taken.insert(name.clone(), ());
        name
    }

    /// `spring_1`, `spring_2`, … for statements without a name.
    pub(super) fn of_nameless(&mut self, kind: &str) -> String {
        let count = self.nameless.get(&kind.to_owned()).copied().unwrap_or(0) + 1;
        self.nameless.insert(kind.to_owned(), count);
        self.fresh(&format!("{kind}_{count}"))
    }
}

/// Reports objects of the scene that share their name with something else.
pub(super) fn report_repeated(declaration: &Declaration, report: &mut Report) {
    let mut first: OrderedMap<String, (&Name, bool)> = OrderedMap::default();
    for statement in &declaration.statements {
        let is_object = matches!(statement.kind, StatementKind::Scene(_));
        for name in statement.kind.declared_names() {
            match first.get(&name.text) {
                // Two plain names are reported where names are resolved.
                Some((_, false)) if !is_object => {}
                Some((before, _)) => {
                    let error = report.error(name.span, messages::declared_twice(&name.text));
                    error
                        .related(before.span.into(), messages::FIRST_DECLARED)
                        .help(messages::OTHER_NAME_HELP);
                }
                None => drop(first.insert(name.text.clone(), (name, is_object))),
            }
        }
    }
}
