//! Names of a declaration: objects of the scene, and unique names for plain statements.

use super::constants::constants_of;
use super::messages;
use super::object::Object;
use crate::syntax::ast::{
    Declaration, Expression, Name, SceneStatement, StateKind, StatementKind, SurfaceKind,
};
use lagrange_expr::collections::HashSet;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::diagnostics::{Report, nearest};

/// The names of a declaration.
pub(super) struct SceneNames {
    /// Objects of the scene that have been declared so far.
    objects: OrderedMap<String, Object>,
    /// Objects that are declared anywhere.
    all_objects: OrderedMap<String, Name>,
    /// Parameters and constants.
    fixed: HashSet<String>,
    /// Names of numbers without a rate: these, discrete states, and definitions by them.
    steady: HashSet<String>,
    /// Names on which no mass may depend: all except parameters, constants, states, modes, and
    /// definitions by them.
    unsuited: HashSet<String>,
    /// Parameters.
    parameters: HashSet<String>,
    /// Constants that are numbers.
    constants: HashMap<String, f64>,
    /// Bodies and frames that joints place.
    placed_by_joints: HashSet<String>,
    /// Names declared anywhere, except names of lines.
    declared: HashSet<String>,
    /// Names that plain statements must not take.
    taken: HashSet<String>,
    /// Number of nameless statements of each kind.
    nameless: HashMap<String, u32>,
}

impl SceneNames {
    pub(super) fn new(declaration: &Declaration) -> SceneNames {
        let mut all_objects = OrderedMap::default();
        let mut placed_by_joints = HashSet::default();
        let (mut taken, mut declared) = (HashSet::default(), HashSet::default());
        let (mut fixed, mut parameters) = (HashSet::default(), HashSet::default());
        let mut steady: HashSet<String> = HashSet::from_iter(["pi".to_owned()]);
        let mut unsuited = HashSet::default();
        for statement in &declaration.statements {
            let is_object = declares_object(&statement.kind);
            let is_line = matches!(
                &statement.kind,
                StatementKind::Scene(SceneStatement::Surface(surface)) if surface.kind == SurfaceKind::Line
            );
            if let StatementKind::Scene(SceneStatement::Mobilizer(joint)) = &statement.kind {
                placed_by_joints.insert(joint.outboard.text.clone());
            }
            for name in statement.kind.declared_names() {
                // A name that already has another meaning is not used too early.
                if is_object && !taken.contains(&name.text) {
                    all_objects.insert(name.text.clone(), name.clone());
                }
                if !is_line {
                    declared.insert(name.text.clone());
                }
            }
            for name in fixed_names(&statement.kind) {
                fixed.insert(name.clone());
                if matches!(statement.kind, StatementKind::Parameters(_)) {
                    parameters.insert(name);
                }
            }
            let is_steady = keeps_value(declaration, &statement.kind, &steady);
            let is_unsuited = is_unsuited(declaration, &statement.kind, &unsuited);
            for name in [statement.kind.declared_names(), statement.kind.member_names()].concat() {
                taken.insert(name.text.clone());
                if is_steady {
                    steady.insert(name.text.clone());
                }
                if is_unsuited {
                    unsuited.insert(name.text.clone());
                }
            }
        }
        for (_, expression) in declaration.expressions.iter() {
            if let Expression::Name(name) = expression {
                taken.insert(name.clone());
            }
        }
        let (objects, constants) = (OrderedMap::default(), constants_of(declaration));
        let nameless = HashMap::default();
        SceneNames {
            objects,
            all_objects,
            fixed,
            steady,
            unsuited,
            parameters,
            constants,
            placed_by_joints,
            declared,
            taken,
            nameless,
        }
    }

    pub(super) fn declare(&mut self, name: &str, object: Object) {
        self.objects.insert(name.to_owned(), object);
    }

    /// Returns the object declared under a name so far.
    pub(super) fn find(&self, name: &str) -> Option<&Object> {
        self.objects.get(&name.to_owned())
    }

    /// Returns the declaration of an object with this name, even further down.
    pub(super) fn anywhere(&self, name: &str) -> Option<&Name> {
        self.all_objects.get(&name.to_owned())
    }

    /// True if something other than a line has this name, even further down.
    pub(super) fn is_declared(&self, name: &str) -> bool {
        self.declared.contains(&name.to_owned())
    }

    /// True if a name denotes a number that does not change during the motion.
    pub(super) fn is_fixed(&self, name: &str) -> bool {
        name == "pi" || self.fixed.contains(&name.to_owned())
    }

    /// True if a name denotes a number without a rate.
    pub(super) fn is_steady(&self, name: &str) -> bool {
        self.steady.contains(name)
    }

    /// True for a name on which no mass may depend.
    pub(super) fn is_unsuited(&self, name: &str) -> bool {
        self.unsuited.contains(name)
    }

    /// Returns the values of the constants that are numbers.
    pub(super) fn constants(&self) -> &HashMap<String, f64> {
        &self.constants
    }

    /// True for the name of a parameter, or of a constant that is a number.
    pub(super) fn is_scalar(&self, name: &str) -> bool {
        self.parameters.contains(&name.to_owned()) || self.constants.contains(&name.to_owned())
    }

    /// True if a joint anywhere places the body or frame of this name.
    pub(super) fn is_placed_by_joint(&self, name: &str) -> bool {
        self.placed_by_joints.contains(&name.to_owned())
    }

    /// Returns the name of an object that is similar to this one.
    pub(super) fn nearest(&self, name: &str, accept: impl Fn(&Object) -> bool) -> Option<&str> {
        let known = self.objects.iter().filter(|(_, object)| accept(object));
        nearest(name, known.map(|(name, _)| name.as_str()))
    }

    /// Returns an unused name similar to `wish`.
    pub(super) fn fresh(&mut self, wish: &str) -> String {
        let mut name = wish.to_owned();
        let mut count = 1;
        while self.taken.contains(&name) {
            count += 1;
            name = format!("{wish}_{count}");
        }
        self.taken.insert(name.clone());
        name
    }

    /// Returns `spring_1`, `spring_2`, … for statements without a name.
    pub(super) fn of_nameless(&mut self, kind: &str) -> String {
        let count = self.nameless.get(&kind.to_owned()).copied().unwrap_or(0) + 1;
        self.nameless.insert(kind.to_owned(), count);
        self.fresh(&format!("{kind}_{count}"))
    }
}

/// Returns the names of parameters and constants.
fn fixed_names(kind: &StatementKind) -> Vec<String> {
    match kind {
        StatementKind::Parameters(list) | StatementKind::Constants(list) => {
            list.iter().map(|row| row.name.text.clone()).collect()
        }
        _ => Vec::new(),
    }
}

/// True if a statement defines numbers without a rate, given such names before it.
fn keeps_value(declaration: &Declaration, kind: &StatementKind, steady: &HashSet<String>) -> bool {
    match kind {
        StatementKind::Parameters(_)
        | StatementKind::Constants(_)
        | StatementKind::Mode(_)
        | StatementKind::States(StateKind::Discrete, _) => true,
        StatementKind::Let(_, value) | StatementKind::LetTuple(_, value) => {
            declaration.expressions.all_names(*value, |name| steady.contains(name))
        }
        _ => false,
    }
}

/// True if no mass may depend on what a statement defines, given such names before it.
fn is_unsuited(declaration: &Declaration, kind: &StatementKind, unsuited: &HashSet<String>) -> bool {
    match kind {
        StatementKind::Let(_, value) | StatementKind::LetTuple(_, value) => {
            !declaration.expressions.all_names(*value, |name| !unsuited.contains(name))
        }
        StatementKind::Parameters(_)
        | StatementKind::Constants(_)
        | StatementKind::Mode(_)
        | StatementKind::States(..) => false,
        _ => true,
    }
}

/// True if a statement declares an object of the scene; coordinates of joints and forces of
/// contacts do not count.
fn declares_object(kind: &StatementKind) -> bool {
    use SceneStatement::{Contact, Contacts, Mobilizer};
    matches!(kind, StatementKind::Scene(scene) if !matches!(scene, Contact(_) | Contacts(_) | Mobilizer(_)))
}

/// Reports objects of the scene that share a name with something else.
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
