//! Names of a declaration: those of the scene with their objects, and names of plain statements that nobody else uses.

use super::messages;
use super::object::Object;
use crate::collections::{HashMap, OrderedMap};
use crate::diagnostics::{Report, nearest};
use crate::syntax::ast::{AstId, Declaration, Expression, Name, SceneStatement, StatementKind};

/// The names of a declaration.
pub(super) struct SceneNames {
    /// Objects of the scene that were declared so far.
    objects: OrderedMap<String, Object>,
    /// Objects that are declared anywhere.
    all_objects: OrderedMap<String, Name>,
    /// Parameters and constants, those with their values.
    fixed: HashMap<String, Option<AstId>>,
    /// Bodies and frames that joints place.
    placed_by_joints: HashMap<String, ()>,
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
        let mut placed_by_joints = HashMap::default();
        let (mut taken, mut declared) = (HashMap::default(), HashMap::default());
        let mut fixed: Vec<(String, Option<AstId>)> = Vec::new();
        for statement in &declaration.statements {
            let is_object = declares_object(&statement.kind);
            let is_line = matches!(statement.kind, StatementKind::Scene(SceneStatement::Line(_)));
            if let StatementKind::Scene(SceneStatement::Mobilizer(joint)) = &statement.kind {
                placed_by_joints.insert(joint.outboard.text.clone(), ());
            }
            for name in statement.kind.declared_names() {
                // A name that stands for something else already is not one that is used too early.
                if is_object && !taken.contains(&name.text) {
                    all_objects.insert(name.text.clone(), name.clone());
                }
                if !is_line {
                    declared.insert(name.text.clone(), ());
                }
            }
            fixed.extend(fixed_numbers(&statement.kind));
            for name in [statement.kind.declared_names(), statement.kind.member_names()].concat() {
                taken.insert(name.text.clone(), ());
            }
        }
        for (_, expression) in declaration.expressions.iter() {
            if let Expression::Name(name) = expression {
                taken.insert(name.clone(), ());
            }
        }
        let (objects, fixed) = (OrderedMap::default(), fixed.into_iter().collect());
        let nameless = HashMap::default();
        SceneNames { objects, all_objects, fixed, placed_by_joints, declared, taken, nameless }
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

    /// The value of a constant.
    pub(super) fn constant(&self, name: &str) -> Option<AstId> {
        self.fixed.get(&name.to_owned()).copied().flatten()
    }

    /// Whether a joint anywhere places the body or frame of this name.
    pub(super) fn is_placed_by_joint(&self, name: &str) -> bool {
        self.placed_by_joints.contains(&name.to_owned())
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

/// Parameters, and constants with their values.
fn fixed_numbers(kind: &StatementKind) -> Vec<(String, Option<AstId>)> {
    let (list, is_constant) = match kind {
        StatementKind::Parameters(list) => (list, false),
        StatementKind::Constants(list) => (list, true),
        _ => return Vec::new(),
    };
    let value = |value: Option<AstId>| value.filter(|_| is_constant);
    list.iter().map(|row| (row.name.text.clone(), value(row.value))).collect()
}

/// True if what a statement declares is an object of the scene; coordinates of joints are none.
fn declares_object(kind: &StatementKind) -> bool {
    matches!(kind, StatementKind::Scene(scene) if !matches!(scene, SceneStatement::Mobilizer(_)))
}

/// Reports objects of the scene that share their name with something else.
pub(super) fn report_repeated(declaration: &Declaration, report: &mut Report) {
    let mut first: OrderedMap<String, (&Name, bool)> = OrderedMap::default();
    for statement in &declaration.statements {
        let is_object = declares_object(&statement.kind);
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
