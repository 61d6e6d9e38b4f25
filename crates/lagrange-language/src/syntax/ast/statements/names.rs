//! Names in statements, as written.

use super::StatementKind;
use crate::syntax::ast::bodies::SceneStatement;
use crate::syntax::ast::definitions::Definition;
use crate::syntax::ast::mobilizers::MobilizerKind;
use crate::syntax::ast::{AstId, Expression, Expressions, Name, Reach};

impl StatementKind {
    /// Returns the names that a statement declares, and their scope.
    pub(super) fn names(&self) -> (Vec<&Name>, Reach) {
        match self {
            StatementKind::Parameters(list) | StatementKind::Inputs(list) => (defined(list), Reach::Both),
            StatementKind::Constants(list) | StatementKind::Noises(list) => {
                (defined(list), Reach::Expressions)
            }
            StatementKind::Coordinates(list) | StatementKind::States(_, list) => (defined(list), Reach::Both),
            StatementKind::Mode(mode) => (mode.names(), Reach::Both),
            StatementKind::Quaternion(quaternion) => (quaternion.names(), Reach::Both),
            StatementKind::Velocity(name, _) | StatementKind::Delay { name, .. } => (vec![name], Reach::Both),
            StatementKind::Let(name, _) => (vec![name], Reach::Expressions),
            StatementKind::Solve(unknowns) => (unknowns.names.iter().collect(), Reach::Expressions),
            StatementKind::LetTuple(names, _) => (names.iter().collect(), Reach::Expressions),
            // Its name can be called, but has no value.
            StatementKind::Function(_) | StatementKind::External(_) | StatementKind::Table(_) => {
                (Vec::new(), Reach::Expressions)
            }
            StatementKind::Constraint(name, _) => (vec![name], Reach::Both),
            StatementKind::Event(event) => (vec![&event.name], Reach::Both),
            StatementKind::Friction(friction) => (vec![&friction.name], Reach::Both),
            StatementKind::Output(name, _) => (vec![name], Reach::Members),
            StatementKind::Reduce(reduction) => (vec![&reduction.name], Reach::Types),
            StatementKind::Scene(scene) => scene.names(),
            StatementKind::Kinetic(_)
            | StatementKind::Potential(_)
            | StatementKind::Lagrangian(_)
            | StatementKind::Gibbs { .. }
            | StatementKind::Dissipation(_)
            | StatementKind::StateRate(..)
            | StatementKind::RateEquation(_)
            | StatementKind::ForceOn(..)
            | StatementKind::ForceAt { .. }
            | StatementKind::ForceAlong { .. }
            | StatementKind::Torque { .. }
            | StatementKind::Stabilise(_)
            | StatementKind::Every(_)
            | StatementKind::Start(_)
            | StatementKind::History(_)
            | StatementKind::Ranges(_)
            | StatementKind::Block(_)
            | StatementKind::Emit(_) => (Vec::new(), Reach::Expressions),
        }
    }

    /// Returns mutable references to all names outside of expressions. These are the names that the
    /// statement declares, without derived ones, and those that it refers to. Names within loops
    /// are excluded.
    pub fn names_mut(&mut self) -> Vec<&mut Name> {
        match self {
            StatementKind::Parameters(list)
            | StatementKind::Inputs(list)
            | StatementKind::Noises(list)
            | StatementKind::Constants(list)
            | StatementKind::Coordinates(list)
            | StatementKind::States(_, list) => {
                list.iter_mut().map(|definition| &mut definition.name).collect()
            }
            StatementKind::Mode(mode) => mode.names_mut(),
            StatementKind::LetTuple(names, _) => names.iter_mut().collect(),
            StatementKind::Quaternion(quaternion) => vec![&mut quaternion.name],
            StatementKind::Velocity(name, _)
            | StatementKind::Let(name, _)
            | StatementKind::StateRate(name, _)
            | StatementKind::ForceOn(name, _)
            | StatementKind::Constraint(name, _)
            | StatementKind::Delay { name, .. }
            | StatementKind::Output(name, _) => vec![name],
            StatementKind::Function(function) => vec![&mut function.name],
            StatementKind::External(function) => vec![&mut function.name],
            StatementKind::Table(table) => vec![&mut table.name],
            StatementKind::Solve(unknowns) => unknowns.names.iter_mut().collect(),
            StatementKind::Event(event) => vec![&mut event.name],
            StatementKind::Friction(friction) => vec![&mut friction.name],
            StatementKind::Reduce(reduction) => {
                reduction.items.iter_mut().map(|item| &mut item.coordinate).collect()
            }
            StatementKind::Scene(scene) => scene.names_mut(),
            StatementKind::Kinetic(_)
            | StatementKind::Potential(_)
            | StatementKind::Lagrangian(_)
            | StatementKind::Gibbs { .. }
            | StatementKind::Dissipation(_)
            | StatementKind::RateEquation(_)
            | StatementKind::ForceAt { .. }
            | StatementKind::ForceAlong { .. }
            | StatementKind::Torque { .. }
            | StatementKind::Stabilise(_)
            | StatementKind::Every(_)
            | StatementKind::Start(_)
            | StatementKind::History(_)
            | StatementKind::Ranges(_)
            | StatementKind::Block(_)
            | StatementKind::Emit(_) => Vec::new(),
        }
    }

    /// Returns the names that a `let` gives to expressions in the text.
    pub fn named_expressions(&self, expressions: &Expressions) -> Vec<(&Name, AstId)> {
        match self {
            StatementKind::Let(name, value) => vec![(name, *value)],
            StatementKind::LetTuple(names, value) => match expressions.get(*value) {
                Expression::Tuple(parts) => names.iter().zip(parts.iter().copied()).collect(),
                _ => Vec::new(),
            },
            _ => Vec::new(),
        }
    }

    /// Returns the names that a statement declares, except those of types. Each is a name in the
    /// text and a suffix: a quaternion `hip` declares `hip` with the suffix `_qw`.
    pub fn written_names(&self) -> Vec<(&Name, String)> {
        match self {
            StatementKind::Quaternion(quaternion) => made_of(&quaternion.name, quaternion.names()),
            StatementKind::Function(function) => vec![(&function.name, String::new())],
            StatementKind::External(function) => vec![(&function.name, String::new())],
            StatementKind::Table(table) => vec![(&table.name, String::new())],
            StatementKind::Scene(SceneStatement::Mobilizer(joint)) => match (joint.kind, &joint.quaternion) {
                (MobilizerKind::Weld, _) => Vec::new(),
                (MobilizerKind::Free, _) => made_of(&joint.outboard, joint.names()),
                (_, Some(quaternion)) => made_of(&quaternion.name, quaternion.names()),
                (_, None) => as_written(joint.coordinates.iter().collect()),
            },
            StatementKind::Scene(SceneStatement::Contact(contact)) => {
                made_of(&contact.name, self.declared_names())
            }
            kind => match kind.member_names() {
                names if names.is_empty() => as_written(kind.declared_names()),
                names => as_written(names),
            },
        }
    }
}

fn as_written(names: Vec<&Name>) -> Vec<(&Name, String)> {
    names.into_iter().map(|name| (name, String::new())).collect()
}

fn made_of<'a>(name: &'a Name, made: Vec<&Name>) -> Vec<(&'a Name, String)> {
    let suffix = |made: &Name| made.text.strip_prefix(name.text.as_str()).unwrap_or_default().to_owned();
    made.into_iter().map(|made| (name, suffix(made))).collect()
}

fn defined(list: &[Definition]) -> Vec<&Name> {
    list.iter().map(|definition| &definition.name).collect()
}
