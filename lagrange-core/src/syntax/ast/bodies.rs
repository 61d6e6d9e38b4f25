//! Plane rigid bodies and what connects them, as written.

use super::{AstId, Name};
use crate::diagnostics::Origin;

/// A statement about plane rigid bodies.
#[derive(Clone, Debug)]
pub enum SceneStatement {
    /// `gravity = (gx, gy);`
    Gravity(AstId),
    /// `body name { … }`
    Body(Box<Body>),
    /// `line name { … }`
    Line(Line),
    /// `spring name { … }` and its kin
    Connector(Connector),
    /// `pin`, `slide` and `roll`
    Joint(Joint),
}

impl SceneStatement {
    /// The name that statements behind this one may mention.
    pub fn declared_name(&self) -> Option<&Name> {
        match self {
            SceneStatement::Gravity(_) => None,
            SceneStatement::Body(body) => Some(&body.name),
            SceneStatement::Line(line) => Some(&line.name),
            SceneStatement::Connector(connector) => connector.name.as_ref(),
            SceneStatement::Joint(joint) => joint.name.as_ref(),
        }
    }
}

/// `body name { mass: e; inertia: e; center: e; angle: e; shape: solid(e); … }`
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: Name,
    /// `mass: m;`
    pub mass: Option<AstId>,
    /// `inertia: j;`, about the centre of mass.
    pub inertia: Option<AstId>,
    /// `center: (x, y);`, where the centre of mass is.
    pub center: Option<AstId>,
    /// `origin: (x, y);`, where the origin of the body's own coordinates is.
    pub origin: Option<AstId>,
    /// `centroid: (X, Y);`, where the centre of mass is in the body's own coordinates.
    pub centroid: Option<AstId>,
    /// `angle: e;`, by which the body's own axes are turned.
    pub angle: Option<AstId>,
    /// `shape: solid(e);`
    pub shape: Option<Shape>,
    /// `compound { … }`; empty if there is none.
    pub parts: Vec<Part>,
}

/// A solid with its dimensions: `rectangle(a, b)`.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The name of the solid.
    pub solid: Name,
    /// Its dimensions; for a polygon its corners.
    pub dimensions: Vec<AstId>,
    /// Place of all of it.
    pub origin: Origin,
}

/// One line of a compound: `disk(r), mass: m, at: (X, Y), angle: e;`, with `hole` in front if it is missing.
#[derive(Clone, Debug)]
pub struct Part {
    /// Whether it is cut out of the others.
    pub is_hole: bool,
    /// Shape of the part.
    pub shape: Shape,
    /// Its mass; for a hole the mass that is missing.
    pub mass: Option<AstId>,
    /// Origin of its own coordinates in those of the body.
    pub at: Option<AstId>,
    /// Angle by which its own axes are turned in those of the body.
    pub angle: Option<AstId>,
    /// Place of all of it.
    pub origin: Origin,
}

/// `line name { on: body; through: (x, y); angle: e; }`
#[derive(Clone, Debug)]
pub struct Line {
    /// Its name.
    pub name: Name,
    /// The body that carries it; at rest if there is none.
    pub on: Option<Name>,
    /// A point of it.
    pub through: Option<AstId>,
    /// Its direction; its free side is on the left.
    pub angle: Option<AstId>,
}

/// Element that stores or dissipates energy between two points or two angles.
#[derive(Clone, Debug)]
pub struct Connector {
    /// Kind of the connector.
    pub kind: ConnectorKind,
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// One end.
    pub from: Option<AstId>,
    /// The other.
    pub to: Option<AstId>,
    /// `stiffness: k;` of a spring.
    pub stiffness: Option<AstId>,
    /// `rest: l;`, the length or angle without force.
    pub rest: Option<AstId>,
    /// `damping: c;` of a damper.
    pub damping: Option<AstId>,
}

/// Kind of a connector.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConnectorKind {
    /// `spring`, between points
    Spring,
    /// `damper`, between points
    Damper,
    /// `torsion_spring`, between angles
    TorsionSpring,
    /// `torsion_damper`, between angles
    TorsionDamper,
}

impl ConnectorKind {
    /// Every kind.
    pub const ALL: [ConnectorKind; 4] = [
        ConnectorKind::Spring,
        ConnectorKind::Damper,
        ConnectorKind::TorsionSpring,
        ConnectorKind::TorsionDamper,
    ];

    /// The word that declares one.
    pub fn name(self) -> &'static str {
        match self {
            ConnectorKind::Spring => "spring",
            ConnectorKind::Damper => "damper",
            ConnectorKind::TorsionSpring => "torsion_spring",
            ConnectorKind::TorsionDamper => "torsion_damper",
        }
    }

    /// The kind that a word declares.
    pub fn named(word: &str) -> Option<ConnectorKind> {
        ConnectorKind::ALL.into_iter().find(|kind| kind.name() == word)
    }
}

/// A joint.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// Kind of the joint, with what it holds together.
    pub kind: JointKind,
}

/// Kind of a joint, with what it holds together.
#[derive(Clone, Debug)]
pub enum JointKind {
    /// `pin p to q;`: two points stay together.
    Pin {
        /// One point.
        first: AstId,
        /// The other.
        second: AstId,
    },
    /// `slide p on line;`: a point stays on a line.
    Slide {
        /// The point.
        point: AstId,
        /// The line.
        line: Name,
    },
    /// `roll body on line;`: a round body stays on a line and does not slip.
    Roll {
        /// The body.
        body: Name,
        /// The line.
        line: Name,
        /// `, radius: r`; that of its shape if it is not given.
        radius: Option<AstId>,
    },
}
