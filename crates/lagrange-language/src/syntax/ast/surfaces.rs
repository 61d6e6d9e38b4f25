//! Surfaces, as written.

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
