//! Rigid bodies and their connections, as written.

use super::contacts::{Contact, ContactDefaults};
use super::keywords::{Keyword, Soft};
use super::mobilizers::{Mobilizer, MobilizerKind};
use super::surfaces::Surface;
use super::{AstId, Name, Reach};
use lagrange_expr::diagnostics::Origin;

/// A statement about rigid bodies.
///
/// ```text
/// scene     = "gravity" "=" sum ";"
///           | "body" NAME "{" { body-line } "}" [ ";" ]
///           | "frame" NAME ";"
///           | mobilizer
///           | ( "line" | "plane" | "circle" | "sphere" | "cylinder" | "terrain" ) NAME
///                 "{" { "on" ":" NAME ";" | surface-label ":" sum ";" } "}" [ ";" ]
///           | ( "spring" | "torsion_spring" ) [ NAME ]
///                 "{" { ( "from" | "to" | "stiffness" | "rest" ) ":" sum ";" } "}" [ ";" ]
///           | ( "damper" | "torsion_damper" ) [ NAME ]
///                 "{" { ( "from" | "to" | "damping" ) ":" sum ";" } "}" [ ";" ]
///           | "pin" [ NAME "=" ] sum "to" sum ";"
///           | "slide" [ NAME "=" ] sum "on" NAME ";"
///           | "roll" [ NAME "=" ] NAME "on" NAME [ "," "radius" ":" sum ] ";"
///           | "contact" NAME "=" sum ( "on" | "inside" ) NAME
///                 ( ";" | "{" { contact-label ":" sum ";" } "}" [ ";" ] )
///           | "contacts" ":" ( "rigid" ";" | "compliant" "{" { compliant-label ":" sum ";" } "}" [ ";" ] )
/// body-line = ( "mass" | "inertia" | "center" | "origin" | "centroid" | "angle" | "angles" ) ":" sum ";"
///           | "inertia" ":" "(" sum "," sum "," sum "," sum "," sum "," sum ")" ";"
///           | "sequence" ":" NAME ";"
///           | "shape" ":" solid ";"
///           | "compound" "{" { [ "hole" ] solid { "," ( "mass" | "at" | "angle" | "turned" ) ":" sum } ";" } "}" [ ";" ]
/// solid     = NAME "(" [ sum { "," sum } ] ")"
/// ```
///
/// The labels of a surface are those of its [`SurfaceKind`](super::SurfaceKind), where names in
/// parentheses follow `height`; those of a contact are [`Contact::LABELS`](super::Contact::LABELS).
#[derive(Clone, Debug)]
pub enum SceneStatement {
    /// `gravity = (gx, gy);`
    Gravity(AstId),
    /// `body name { … }`
    Body(Box<Body>),
    /// `frame name;`
    Frame(Name),
    /// `line name { … }` and similar statements
    Surface(Surface),
    /// `contact name = p on floor { … }`
    Contact(Box<Contact>),
    /// `contacts: rigid;` or `contacts: compliant { … }`
    Contacts(Box<ContactDefaults>),
    /// `spring name { … }` and similar statements
    Connector(Connector),
    /// `pin`, `slide` and `roll`
    Joint(Joint),
    /// `revolute q = a to b { … }` and similar statements
    Mobilizer(Box<Mobilizer>),
}

/// Words that begin statements about rigid bodies, except those of [`Mobilizer`].
pub const KEYWORDS: [Keyword; 18] = [
    Keyword::new("gravity", "write `gravity = (0, -g);`"),
    Keyword::new("body", "write `body name { mass: m; inertia: disk(m, r); center: (x, y); angle: phi; }`"),
    Keyword::new("frame", "write `frame name;`, and a joint that places it").before(Soft::Alone),
    Keyword::new("line", "write `line name { through: (x, y); angle: e; }`").before(Soft::Braces),
    Keyword::new("plane", "write `plane name { through: (x, y, z); normal: (a, b, c); }`").before(Soft::Braces),
    Keyword::new("circle", "write `circle name { center: (x, y); radius: r; }`").before(Soft::Braces),
    Keyword::new("sphere", "write `sphere name { center: (x, y, z); radius: r; }`").before(Soft::Braces),
    Keyword::new("cylinder", "write `cylinder name { through: (x, y, z); axis: (a, b, c); radius: r; }`")
        .before(Soft::Braces),
    Keyword::new("terrain", "write `terrain name { height(x, y): e; }`, or `height(x): e;` in the plane")
        .before(Soft::Braces),
    Keyword::new(
        "contact",
        "write `contact name = wheel on ground { friction: mu; restitution: e; }`, or `… = wheel inside bowl { … }`",
    )
    .before(Soft::Definition),
    Keyword::new("contacts", "write `contacts: compliant { stiffness: k; dissipation: d; stiction: v; }` for all contacts, or `contacts: rigid;`")
        .before(Soft::Way),
    Keyword::new("spring", "write `spring { from: p; to: q; stiffness: k; rest: l; }`, with a name after `spring` if it needs one")
        .before(Soft::Braces),
    Keyword::new("damper", "write `damper { from: p; to: q; damping: c; }`, with a name after `damper` if it needs one")
        .before(Soft::Braces),
    Keyword::new("torsion_spring", "write `torsion_spring { from: ground; to: arm; stiffness: k; rest: e; }`")
        .before(Soft::Braces),
    Keyword::new("torsion_damper", "write `torsion_damper { from: ground; to: arm; damping: c; }`")
        .before(Soft::Braces),
    Keyword::new("pin", "write `pin p to q;` or `pin name = p to q;`").before(Soft::Joint),
    Keyword::new("slide", "write `slide p on floor;` or `slide name = p on floor;`, with the name of a line")
        .before(Soft::Joint),
    Keyword::new("roll", "write `roll wheel on floor;` or `roll name = wheel on floor, radius: r;`, with the names of a body and a line")
        .before(Soft::Joint),
];

impl SceneStatement {
    /// Returns the names that a statement declares, and where they are known.
    pub(super) fn names(&self) -> (Vec<&Name>, Reach) {
        match self {
            SceneStatement::Gravity(_) | SceneStatement::Contacts(_) => (Vec::new(), Reach::Expressions),
            SceneStatement::Body(body) => (vec![&body.name], Reach::Both),
            SceneStatement::Frame(name) => (vec![name], Reach::Both),
            SceneStatement::Surface(surface) => (vec![&surface.name], Reach::Expressions),
            SceneStatement::Contact(contact) => (contact.names(), Reach::Both),
            SceneStatement::Connector(connector) => (connector.name.iter().collect(), Reach::Expressions),
            SceneStatement::Joint(joint) => (joint.name.iter().collect(), Reach::Expressions),
            SceneStatement::Mobilizer(joint) if joint.kind == MobilizerKind::Weld => {
                (Vec::new(), Reach::Expressions)
            }
            SceneStatement::Mobilizer(joint) => (joint.names(), Reach::Both),
        }
    }

    /// Returns its names, except those derived from others.
    pub(super) fn names_mut(&mut self) -> Vec<&mut Name> {
        match self {
            SceneStatement::Gravity(_) | SceneStatement::Contacts(_) => Vec::new(),
            SceneStatement::Body(body) => vec![&mut body.name],
            SceneStatement::Frame(name) => vec![name],
            SceneStatement::Surface(surface) => {
                [&mut surface.name].into_iter().chain(&mut surface.on).collect()
            }
            SceneStatement::Contact(contact) => vec![&mut contact.name, &mut contact.surface],
            SceneStatement::Connector(connector) => connector.name.iter_mut().collect(),
            SceneStatement::Joint(joint) => joint.name.iter_mut().chain(joint.kind.names_mut()).collect(),
            SceneStatement::Mobilizer(joint) => joint.names_mut(),
        }
    }

    /// Returns its expressions.
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        match self {
            SceneStatement::Gravity(value) => vec![value],
            SceneStatement::Body(body) => body.expressions_mut(),
            SceneStatement::Frame(_) => Vec::new(),
            SceneStatement::Surface(Surface { place, direction, radius, height, .. }) => {
                [place, direction, radius, height].into_iter().flatten().collect()
            }
            SceneStatement::Contact(contact) => contact.expressions_mut(),
            SceneStatement::Contacts(defaults) => defaults.compliance.values_mut().collect(),
            SceneStatement::Connector(connector) => {
                let Connector { from, to, stiffness, rest, damping, .. } = connector;
                [from, to, stiffness, rest, damping].into_iter().flatten().collect()
            }
            SceneStatement::Joint(joint) => joint.kind.expressions_mut(),
            SceneStatement::Mobilizer(joint) => joint.expressions_mut(),
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
    /// `inertia: j;`, about the centre of mass; a vector of principal moments for a body in space.
    pub inertia: Option<AstId>,
    /// `inertia: (xx, yy, zz, xy, xz, yz);`, the tensor about the centre of mass in the body's own
    /// axes.
    pub tensor: Option<[AstId; 6]>,
    /// `center: (x, y);`, the position of the centre of mass.
    pub center: Option<AstId>,
    /// `origin: (x, y);`, the position of the origin of the body's own coordinates.
    pub origin: Option<AstId>,
    /// `centroid: (X, Y);`, the centre of mass in the body's own coordinates.
    pub centroid: Option<AstId>,
    /// `angle: e;`, by which the body-fixed axes are turned.
    pub angle: Option<AstId>,
    /// `angles: (e, e, e);`, applied one after the other about the axes of `sequence`.
    pub angles: Option<AstId>,
    /// `sequence: zxz;`
    pub sequence: Option<Name>,
    /// `shape: solid(e);`
    pub shape: Option<Shape>,
    /// `compound { … }`; empty without one.
    pub parts: Vec<Part>,
    /// `visual { … }`, the shape in pictures instead of shape or compound; empty without one.
    pub visuals: Vec<Part>,
}

impl Body {
    fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let Body {
            mass,
            inertia,
            tensor,
            center,
            origin,
            centroid,
            angle,
            angles,
            shape,
            parts,
            visuals,
            ..
        } = self;
        let properties = [mass, inertia, center, origin, centroid, angle, angles].into_iter().flatten();
        let properties = properties.chain(tensor.iter_mut().flatten());
        let dimensions = shape.iter_mut().flat_map(|shape| &mut shape.dimensions);
        let parts = parts.iter_mut().chain(visuals).flat_map(Part::expressions_mut);
        properties.chain(dimensions).chain(parts).collect()
    }
}

/// A solid with its dimensions: `rectangle(a, b)`.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The name of the solid.
    pub solid: Name,
    /// Its dimensions; its corners for a polygon.
    pub dimensions: Vec<AstId>,
    /// Place of all of it.
    pub origin: Origin,
}

impl Shape {
    /// Returns the number of its corners, or of the ends of a rod; 0 if it has none.
    pub(crate) fn corner_count(&self) -> usize {
        match (self.solid.text.as_str(), self.dimensions.len()) {
            ("cuboid", 3) => 8,
            ("cuboid" | "rectangle", 2) => 4,
            ("right_triangle", 2) => 3,
            ("slender_rod" | "rod", 1) => 2,
            ("polygon", count) => count,
            _ => 0,
        }
    }
}

/// One line of a compound: `disk(r), mass: m, at: (X, Y), angle: e;`, preceded by `hole` if it is
/// cut out.
#[derive(Clone, Debug)]
pub struct Part {
    /// True if it is cut out of the other parts.
    pub is_hole: bool,
    /// Shape of the part.
    pub shape: Shape,
    /// Its mass; for a hole the missing mass. Parts of `visual` have none.
    pub mass: Option<AstId>,
    /// Origin of its own coordinates in those of the body.
    pub at: Option<AstId>,
    /// Angle by which its own axes are turned in those of the body.
    pub angle: Option<AstId>,
    /// `turned: (roll, pitch, yaw)`, the orientation of its own axes in a body in space.
    pub turned: Option<AstId>,
    /// Place of all of it.
    pub origin: Origin,
}

impl Part {
    fn expressions_mut(&mut self) -> impl Iterator<Item = &mut AstId> {
        let properties =
            [&mut self.mass, &mut self.at, &mut self.angle, &mut self.turned].into_iter().flatten();
        self.shape.dimensions.iter_mut().chain(properties)
    }
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

    /// Returns the keyword of this kind.
    pub fn name(self) -> &'static str {
        match self {
            ConnectorKind::Spring => "spring",
            ConnectorKind::Damper => "damper",
            ConnectorKind::TorsionSpring => "torsion_spring",
            ConnectorKind::TorsionDamper => "torsion_damper",
        }
    }

    /// Returns the kind with this keyword.
    pub fn named(word: &str) -> Option<ConnectorKind> {
        ConnectorKind::ALL.into_iter().find(|kind| kind.name() == word)
    }
}

/// A joint.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// Kind of the joint, with the bodies that it connects.
    pub kind: JointKind,
}

/// Kind of a joint, with the bodies that it connects.
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
        /// `, radius: r`; by default, that of its shape.
        radius: Option<AstId>,
    },
}

impl JointKind {
    fn names_mut(&mut self) -> Vec<&mut Name> {
        match self {
            JointKind::Pin { .. } => Vec::new(),
            JointKind::Slide { line, .. } => vec![line],
            JointKind::Roll { body, line, .. } => vec![body, line],
        }
    }

    fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        match self {
            JointKind::Pin { first, second } => vec![first, second],
            JointKind::Slide { point, .. } => vec![point],
            JointKind::Roll { radius, .. } => radius.iter_mut().collect(),
        }
    }
}
