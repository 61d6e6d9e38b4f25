//! Meanings of the names in a scene.

use super::plain::Outline;
use super::terms::{Pair, TermWriter};
use crate::syntax::ast::{self, AstId, ConnectorKind, Name, SurfaceKind};
use crate::syntax::foreign::Owner;

/// A rigid body whose statement has been read.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) name: Name,
    pub(super) mass: AstId,
    pub(super) inertia: AstId,
    /// The centre of mass.
    pub(super) center: AstId,
    /// The centre of mass in own coordinates.
    pub(super) centroid: Pair,
    /// The origin of the own coordinates.
    pub(super) origin: Pair,
    pub(super) angle: AstId,
    /// The radius on which it rolls, if its shape is round.
    pub(super) radius: Option<AstId>,
    /// The solid that `shape` states.
    pub(super) shape: Option<Outline>,
    pub(super) energies: Energies,
}

/// The available energies of a body.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Energies {
    /// ½ m v²
    pub(super) of_translation: Option<AstId>,
    /// ½ ω·J ω
    pub(super) of_rotation: Option<AstId>,
    /// −m g·r
    pub(super) potential: Option<AstId>,
}

impl Energies {
    /// Returns T − V.
    pub(super) fn lagrangian(self, terms: &mut TermWriter<'_>) -> AstId {
        let kinetic = [self.of_translation, self.of_rotation].into_iter().flatten();
        let kinetic = kinetic.fold(terms.number(0), |sum, energy| terms.plus(sum, energy));
        match self.potential {
            Some(potential) => terms.minus(kinetic, potential),
            None => kinetic,
        }
    }
}

/// A body or frame that has not yet been placed by a joint.
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

    /// Returns the kind of object, for messages.
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

/// A joint: the names of its forces.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    /// The force on the first of the connected objects.
    pub(super) force: AstId,
    /// Components with separate names.
    pub(super) parts: Vec<(&'static str, AstId)>,
}

/// The height of a terrain.
#[derive(Clone, Debug)]
pub(super) struct Height {
    /// Names for coordinates of the carrier of the terrain.
    pub(super) coordinates: Vec<String>,
    /// Height over them.
    pub(super) value: AstId,
    /// True if it does not change with time.
    pub(super) is_fixed: bool,
}

/// A surface other than a line, in the world. Vectors in the plane have a third component of zero.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    /// Kind of the surface.
    pub(super) kind: SurfaceKind,
    /// The body, or in space the link, that carries it.
    pub(super) carrier: Option<usize>,
    /// A point of it, its centre, or the origin of the coordinates of a terrain.
    pub(super) place: [AstId; 3],
    /// The normal of a plane, the axis of a cylinder or the vertical of a terrain, of length one.
    pub(super) direction: [AstId; 3],
    /// The length of the vector that states the direction, unless its components are numbers.
    pub(super) length: Option<AstId>,
    /// Two perpendicular directions in a plane, of length one, whose cross product is its normal;
    /// the axes of the coordinates of a terrain.
    pub(super) tangents: [[AstId; 3]; 2],
    pub(super) radius: AstId,
    /// The height, if it is terrain.
    pub(super) height: Option<Height>,
    /// The rate of the angle of a line that no body carries.
    pub(super) turning: AstId,
}

/// A contact: the names of its forces, and its other properties.
#[derive(Clone, Debug)]
pub(super) struct Contact {
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
    Surface(Box<Surface>),
    /// The name of a contact also has a value: the normal force.
    Contact(Contact),
}

impl Object {
    /// Returns the kind of object, for suggestions of other names for its parts.
    pub(super) fn owner(&self) -> Option<Owner> {
        match self {
            Object::Body(_) => Some(Owner::Body),
            Object::Link { is_frame: false, .. } => Some(Owner::BodyInSpace),
            Object::Link { .. } => Some(Owner::Frame),
            Object::Line(_) | Object::Surface(_) | Object::Contact(_) => None,
            Object::Connector(_) => Some(Owner::Connector),
            Object::Joint(_) => Some(Owner::Joint),
        }
    }

    /// Returns a description for messages, with its article.
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
            Object::Surface(surface) => surface.kind.described(),
            Object::Contact(_) => "a contact",
        }
    }
}
