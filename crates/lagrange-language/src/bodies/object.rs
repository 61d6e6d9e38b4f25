//! Meanings of the names in a scene.

use super::terms::Pair;
use crate::syntax::ast::{self, AstId, ConnectorKind, Name};
use crate::syntax::foreign::Owner;

/// A rigid body whose statement has been read.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) name: Name,
    pub(super) mass: AstId,
    pub(super) inertia: AstId,
    /// The centre of mass.
    pub(super) center: AstId,
    /// The origin of the own coordinates.
    pub(super) origin: Pair,
    pub(super) angle: AstId,
    /// The radius on which it rolls, if its shape is round.
    pub(super) radius: Option<AstId>,
}

/// A body or frame that waits for the joint that places it.
#[derive(Clone, Debug)]
pub(super) enum WaitingBody {
    Body(Box<ast::Body>),
    Frame(Name),
}

impl WaitingBody {
    pub(super) fn name(&self) -> &Name {
        match self {
            WaitingBody::Body(body) => &body.name,
            WaitingBody::Frame(name) => name,
        }
    }

    /// Returns the kind of object, in the user's words.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            WaitingBody::Body(_) => "body",
            WaitingBody::Frame(_) => "frame",
        }
    }
}

/// A line.
#[derive(Clone, Debug)]
pub(super) struct Line {
    pub(super) body: Option<usize>,
    pub(super) through: Pair,
    pub(super) angle: AstId,
}

/// A spring or damper.
#[derive(Clone, Debug)]
pub(super) struct Connector {
    pub(super) kind: ConnectorKind,
    /// The distance of its ends or the angle between them.
    pub(super) length: AstId,
    /// Force that pulls the ends together.
    pub(super) tension: AstId,
}

/// A joint: the names that stand for its forces.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    /// The force on the first of what it holds.
    pub(super) force: AstId,
    /// Components with names of their own.
    pub(super) parts: Vec<(&'static str, AstId)>,
}

/// Meaning of a name in a scene.
#[derive(Clone, Debug)]
pub(super) enum Object {
    Body(usize),
    /// A body or frame in space.
    Link {
        index: usize,
        is_frame: bool,
    },
    Line(usize),
    Connector(Connector),
    Joint(Joint),
}

impl Object {
    /// Kind of object, for those who look for parts of it under other names.
    pub(super) fn owner(&self) -> Option<Owner> {
        match self {
            Object::Body(_) => Some(Owner::Body),
            Object::Link { is_frame: false, .. } => Some(Owner::BodyInSpace),
            Object::Link { .. } => Some(Owner::Frame),
            Object::Line(_) => None,
            Object::Connector(_) => Some(Owner::Connector),
            Object::Joint(_) => Some(Owner::Joint),
        }
    }

    /// Description in the user's words, with its article.
    pub(super) fn describe(&self) -> &'static str {
        match self {
            Object::Body(_) | Object::Link { is_frame: false, .. } => "a body",
            Object::Link { .. } => "a frame",
            Object::Line(_) => "a line",
            Object::Connector(connector) => match connector.kind {
                ConnectorKind::Spring => "a spring",
                ConnectorKind::Damper => "a damper",
                ConnectorKind::TorsionSpring => "a torsion spring",
                ConnectorKind::TorsionDamper => "a torsion damper",
            },
            Object::Joint(_) => "a joint",
        }
    }
}
