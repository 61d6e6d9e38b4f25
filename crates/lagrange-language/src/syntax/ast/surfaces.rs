//! Surfaces, and the contacts on them, as written.

use super::{AstId, Name};

/// `line name { on: body; through: (x, y); angle: e; }` and similar statements
#[derive(Clone, Debug)]
pub struct Surface {
    /// Kind of the surface.
    pub kind: SurfaceKind,
    /// Its name.
    pub name: Name,
    /// The body that carries it; at rest without one.
    pub on: Option<Name>,
    /// A point of it, or the centre.
    pub place: Option<AstId>,
    /// The angle of a line, the normal of a plane, the axis of a cylinder.
    pub direction: Option<AstId>,
    /// Its radius, if it is round.
    pub radius: Option<AstId>,
    /// The height of a terrain.
    pub height: Option<AstId>,
    /// Names for coordinates in the height: one in the plane, two in space. They cannot occur
    /// elsewhere in a declaration.
    pub coordinates: Vec<Name>,
}

/// Kind of a surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfaceKind {
    /// `line`, in the plane; its free side is on the left
    Line,
    /// `plane`, in space; its free side is that of the normal
    Plane,
    /// `circle`, in the plane
    Circle,
    /// `sphere`, in space
    Sphere,
    /// `cylinder`, in space, of any length
    Cylinder,
    /// `terrain`, in the plane or in space; its free side is above
    Terrain,
}

impl SurfaceKind {
    /// Every kind.
    pub const ALL: [SurfaceKind; 6] = [
        SurfaceKind::Line,
        SurfaceKind::Plane,
        SurfaceKind::Circle,
        SurfaceKind::Sphere,
        SurfaceKind::Cylinder,
        SurfaceKind::Terrain,
    ];

    /// Returns the word that declares this kind.
    pub fn name(self) -> &'static str {
        match self {
            SurfaceKind::Line => "line",
            SurfaceKind::Plane => "plane",
            SurfaceKind::Circle => "circle",
            SurfaceKind::Sphere => "sphere",
            SurfaceKind::Cylinder => "cylinder",
            SurfaceKind::Terrain => "terrain",
        }
    }

    /// Returns the word with its article.
    pub fn described(self) -> &'static str {
        match self {
            SurfaceKind::Line => "a line",
            SurfaceKind::Plane => "a plane",
            SurfaceKind::Circle => "a circle",
            SurfaceKind::Sphere => "a sphere",
            SurfaceKind::Cylinder => "a cylinder",
            SurfaceKind::Terrain => "a terrain",
        }
    }

    /// Returns the kind that a word declares.
    pub fn named(word: &str) -> Option<SurfaceKind> {
        SurfaceKind::ALL.into_iter().find(|kind| kind.name() == word)
    }

    /// Returns the labels of its carrier, place, direction, radius and height, as far as it has
    /// them.
    pub fn labels(self) -> &'static [&'static str] {
        match self {
            SurfaceKind::Line => &["on", "through", "angle"],
            SurfaceKind::Plane => &["on", "through", "normal"],
            SurfaceKind::Circle | SurfaceKind::Sphere => &["on", "center", "radius"],
            SurfaceKind::Cylinder => &["on", "through", "axis", "radius"],
            SurfaceKind::Terrain => &["on", "height"],
        }
    }

    /// True if scenes in space or in the plane can have this kind.
    pub fn belongs_to(self, is_spatial: bool) -> bool {
        match self {
            SurfaceKind::Line | SurfaceKind::Circle => !is_spatial,
            SurfaceKind::Plane | SurfaceKind::Sphere | SurfaceKind::Cylinder => is_spatial,
            SurfaceKind::Terrain => true,
        }
    }
}

impl Surface {
    /// Creates a surface without further properties.
    pub fn named(kind: SurfaceKind, name: Name) -> Surface {
        let [place, direction, radius, height] = [None; 4];
        Surface { kind, name, on: None, place, direction, radius, height, coordinates: Vec::new() }
    }

    /// Returns the place for the value of a label.
    pub fn value_mut(&mut self, label: &str) -> &mut Option<AstId> {
        match label {
            "through" | "center" => &mut self.place,
            "radius" => &mut self.radius,
            "height" => &mut self.height,
            _ => &mut self.direction,
        }
    }

    /// Returns its labels with their values.
    pub fn values(&self) -> Vec<(&'static str, Option<AstId>)> {
        let mut copy = self.clone();
        let labels = self.kind.labels()[1..].iter();
        labels.map(|&label| (label, *copy.value_mut(label))).collect()
    }
}

/// `contact name = wheel on floor { friction: mu; restitution: e; }`, rigid unless it has a
/// stiffness
#[derive(Clone, Debug)]
pub struct Contact {
    /// Its name, which denotes the normal force.
    pub name: Name,
    /// `name_friction`, the name of the friction in it.
    pub friction_name: Name,
    /// The touching body, or a point of one.
    pub object: AstId,
    /// The touched surface: of a body, a line or similar object, or the ground.
    pub surface: Name,
    /// True if the body is inside the surface.
    pub is_inside: bool,
    /// `radius: r;` around the point or the rim; by default, that of a round body.
    pub radius: Option<AstId>,
    /// `rim: r;`, the radius of a circle about the touching point.
    pub rim: Option<AstId>,
    /// `axis: (a, b, c);` of the rim in the body; its third axis by default.
    pub axis: Option<AstId>,
    /// `friction: mu;`, one coefficient for slipping and sticking.
    pub friction: Option<AstId>,
    /// `kinetic: mu;`, the coefficient while it slips.
    pub kinetic: Option<AstId>,
    /// `static: mu;`, the coefficient while it sticks.
    pub fixed: Option<AstId>,
    /// `restitution: e;`; 0 by default.
    pub restitution: Option<AstId>,
    /// `stiffness: k;`, which makes the contact compliant.
    pub stiffness: Option<AstId>,
    /// `dissipation: d;` of Hunt and Crossley; 0 by default.
    pub dissipation: Option<AstId>,
    /// `stiction: v;`, the speed below which compliant friction creeps.
    pub stiction: Option<AstId>,
}

impl Contact {
    /// The labels of a contact.
    pub const LABELS: [&'static str; 10] = [
        "radius",
        "rim",
        "axis",
        "friction",
        "kinetic",
        "static",
        "restitution",
        "stiffness",
        "dissipation",
        "stiction",
    ];

    /// Creates a contact without further properties.
    pub fn between(name: Name, object: AstId, surface: Name, is_inside: bool) -> Contact {
        let friction_name = Contact::friction_name(&name);
        let [radius, rim, axis, friction, kinetic, fixed] = [None; 6];
        let [restitution, stiffness, dissipation, stiction] = [None; 4];
        Contact {
            name,
            friction_name,
            object,
            surface,
            is_inside,
            radius,
            rim,
            axis,
            friction,
            kinetic,
            fixed,
            restitution,
            stiffness,
            dissipation,
            stiction,
        }
    }

    /// Returns the name of the friction in a contact.
    pub fn friction_name(name: &Name) -> Name {
        Name::new(format!("{}_friction", name.text), name.span)
    }

    /// True if it has friction.
    pub fn has_friction(&self) -> bool {
        [self.friction, self.kinetic, self.fixed].iter().any(Option::is_some)
    }

    /// Returns the names that it declares.
    pub fn names(&self) -> Vec<&Name> {
        let friction = self.has_friction().then_some(&self.friction_name);
        [&self.name].into_iter().chain(friction).collect()
    }

    /// Returns the place for the value of a label.
    pub fn value_mut(&mut self, label: &str) -> &mut Option<AstId> {
        match label {
            "radius" => &mut self.radius,
            "rim" => &mut self.rim,
            "axis" => &mut self.axis,
            "friction" => &mut self.friction,
            "kinetic" => &mut self.kinetic,
            "static" => &mut self.fixed,
            "stiffness" => &mut self.stiffness,
            "dissipation" => &mut self.dissipation,
            "stiction" => &mut self.stiction,
            _ => &mut self.restitution,
        }
    }

    /// Returns its labels with their values.
    pub fn values(&self) -> Vec<(&'static str, Option<AstId>)> {
        let mut copy = self.clone();
        Contact::LABELS.map(|label| (label, *copy.value_mut(label))).to_vec()
    }

    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let Contact { object, radius, rim, axis, friction, kinetic, fixed, restitution, .. } = self;
        let rigid = [radius, rim, axis, friction, kinetic, fixed, restitution];
        let compliant = [&mut self.stiffness, &mut self.dissipation, &mut self.stiction];
        [object].into_iter().chain(rigid.into_iter().chain(compliant).flatten()).collect()
    }
}
