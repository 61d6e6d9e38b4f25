//! Joints with coordinates of their own, as written.

use super::keywords::{Keyword, Soft};
use super::quaternion::Quaternion;
use super::{AstId, Name};

/// Words that begin statements about joints with coordinates of their own.
pub const KEYWORDS: [Keyword; 9] = [
    Keyword::new("revolute", "write `revolute q = ground to arm { at: p; axis: u; }`")
        .before(Soft::Coordinates),
    Keyword::new("prismatic", "write `prismatic s = ground to slider { at: p; axis: u; }`")
        .before(Soft::Coordinates),
    Keyword::new("screw", "write `screw q = ground to nut { axis: u; pitch: e; }`").before(Soft::Coordinates),
    Keyword::new("cylindrical", "write `cylindrical (q, s) = ground to piston { axis: u; }`")
        .before(Soft::Coordinates),
    Keyword::new("universal", "write `universal (a, b) = shaft to fork { at: p; }`")
        .before(Soft::Coordinates),
    Keyword::new("planar", "write `planar (x, y, phi) = ground to puck;`").before(Soft::Coordinates),
    Keyword::new("ball", "write `ball hip = trunk to leg { at: p; }`").before(Soft::Coordinates),
    Keyword::new("free", "write `free trunk;`, with the name of a body").before(Soft::Alone),
    Keyword::new("weld", "write `weld arm to hand { at: p; turned: (roll, pitch, yaw); }`")
        .before(Soft::Joint),
];

/// A joint that makes coordinates and places a body by them, which is what Simbody and Drake call a mobilizer.
///
/// ```text
/// mobilizer = "weld" NAME "to" NAME tail
///           | "free" NAME ";"
///           | ( "revolute" | "prismatic" | "screw" | "ball" ) NAME "=" NAME "to" NAME tail
///           | ( "cylindrical" | "universal" | "planar" ) "(" NAME { "," NAME } ")" "=" NAME "to" NAME tail
/// tail      = ";" | "{" { ( "at" | "turned" | "axis" | "pitch" | "damping" ) ":" sum ";" } "}" [ ";" ]
/// ```
#[derive(Clone, Debug)]
pub struct Mobilizer {
    /// Kind of the joint.
    pub kind: MobilizerKind,
    /// The coordinates that it makes.
    pub coordinates: Vec<Name>,
    /// Names of their rates, if these have names of their own.
    pub speeds: Vec<Name>,
    /// The orientation that it makes.
    pub quaternion: Option<Quaternion>,
    /// The body or frame that carries it, or `ground`.
    pub inboard: Name,
    /// The body or frame that it places.
    pub outboard: Name,
    /// `at: (x, y, z);`, the origin of the joint's frame in the axes of its carrier.
    pub at: Option<AstId>,
    /// `turned: (roll, pitch, yaw);`, orientation of the joint's frame in its carrier; in the plane an angle.
    pub turned: Option<AstId>,
    /// `axis: (x, y, z);`, in the joint's frame.
    pub axis: Option<AstId>,
    /// `pitch: p;` of a screw, the distance that it advances in a turn.
    pub pitch: Option<AstId>,
    /// `damping: c;`
    pub damping: Option<AstId>,
}

/// Kind of a joint that makes coordinates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MobilizerKind {
    /// `revolute q`: turns about an axis.
    Revolute,
    /// `prismatic s`: moves along an axis.
    Prismatic,
    /// `screw q`: turns about an axis and advances along it in proportion.
    Screw,
    /// `cylindrical (q, s)`: turns about an axis and moves along it.
    Cylindrical,
    /// `universal (a, b)`: turns about x, then about the y that is turned with it.
    Universal,
    /// `planar (x, y, phi)`: moves along x and y and turns about z.
    Planar,
    /// `ball hip`: turns about any axis.
    Ball,
    /// `free trunk`: moves and turns in any direction, without a carrier.
    Free,
    /// `weld`: does not move.
    Weld,
}

impl Mobilizer {
    /// A joint of which nothing else is known yet.
    pub fn between(kind: MobilizerKind, inboard: Name, outboard: Name) -> Mobilizer {
        Mobilizer {
            kind,
            coordinates: Vec::new(),
            speeds: Vec::new(),
            quaternion: None,
            inboard,
            outboard,
            at: None,
            turned: None,
            axis: None,
            pitch: None,
            damping: None,
        }
    }

    /// A body that is free, with three coordinates and an orientation.
    pub fn free(body: Name) -> Mobilizer {
        let named = |suffix: &str| Name::new(format!("{}_{suffix}", body.text), body.span);
        let (coordinates, speeds) =
            (["x", "y", "z"].map(named).to_vec(), ["vx", "vy", "vz"].map(named).to_vec());
        let quaternion = Some(Quaternion::named(Name::new(body.text.as_str(), body.span)));
        let free = Mobilizer::between(MobilizerKind::Free, Name::new("ground", body.span), body);
        Mobilizer { coordinates, speeds, quaternion, ..free }
    }

    /// The names that it declares.
    pub(super) fn names(&self) -> Vec<&Name> {
        let components = self.quaternion.iter().flat_map(Quaternion::names);
        self.coordinates.iter().chain(&self.speeds).chain(components).collect()
    }

    /// Its names, but for those that are made of others.
    pub(super) fn names_mut(&mut self) -> Vec<&mut Name> {
        if self.kind == MobilizerKind::Free {
            return vec![&mut self.outboard];
        }
        let quaternion = self.quaternion.iter_mut().map(|quaternion| &mut quaternion.name);
        self.coordinates.iter_mut().chain(quaternion).chain([&mut self.inboard, &mut self.outboard]).collect()
    }

    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let Mobilizer { at, turned, axis, pitch, damping, .. } = self;
        [at, turned, axis, pitch, damping].into_iter().flatten().collect()
    }
}

impl MobilizerKind {
    /// Every kind.
    pub const ALL: [MobilizerKind; 9] = [
        MobilizerKind::Revolute,
        MobilizerKind::Prismatic,
        MobilizerKind::Screw,
        MobilizerKind::Cylindrical,
        MobilizerKind::Universal,
        MobilizerKind::Planar,
        MobilizerKind::Ball,
        MobilizerKind::Free,
        MobilizerKind::Weld,
    ];

    /// The word that declares one.
    pub fn name(self) -> &'static str {
        match self {
            MobilizerKind::Revolute => "revolute",
            MobilizerKind::Prismatic => "prismatic",
            MobilizerKind::Screw => "screw",
            MobilizerKind::Cylindrical => "cylindrical",
            MobilizerKind::Universal => "universal",
            MobilizerKind::Planar => "planar",
            MobilizerKind::Ball => "ball",
            MobilizerKind::Free => "free",
            MobilizerKind::Weld => "weld",
        }
    }

    /// The kind that a word declares.
    pub fn named(word: &str) -> Option<MobilizerKind> {
        MobilizerKind::ALL.into_iter().find(|kind| kind.name() == word)
    }

    /// The coordinates as they are written.
    pub fn written_coordinates(self) -> &'static str {
        match self {
            MobilizerKind::Revolute | MobilizerKind::Screw => "q",
            MobilizerKind::Prismatic => "s",
            MobilizerKind::Cylindrical => "(q, s)",
            MobilizerKind::Universal => "(a, b)",
            MobilizerKind::Planar => "(x, y, phi)",
            MobilizerKind::Ball => "hip",
            MobilizerKind::Free | MobilizerKind::Weld => "",
        }
    }

    /// Number of names in front of `=`.
    pub fn name_count(self) -> usize {
        match self {
            MobilizerKind::Weld | MobilizerKind::Free => 0,
            MobilizerKind::Revolute
            | MobilizerKind::Prismatic
            | MobilizerKind::Screw
            | MobilizerKind::Ball => 1,
            MobilizerKind::Cylindrical | MobilizerKind::Universal => 2,
            MobilizerKind::Planar => 3,
        }
    }
}
