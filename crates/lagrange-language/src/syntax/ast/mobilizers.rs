//! Joints with coordinates, as written.

use ElementaryMotion::{Advance, Orientation, Slide, Turn};
use JointLine::{Frame, Own};

use super::keywords::{Keyword, Soft};
use super::quaternion::Quaternion;
use super::{AstId, Name};

/// An elementary motion of a joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ElementaryMotion {
    /// Turns about an axis by a coordinate.
    Turn(JointLine),
    /// Moves along an axis by a coordinate.
    Slide(JointLine),
    /// Moves along the joint's own axis in proportion to the preceding turn.
    Advance,
    /// Turns in any direction by a quaternion.
    Orientation,
}

/// The line about or along which a joint moves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JointLine {
    /// The axis in the statement, or z.
    Own,
    /// An axis of the joint's frame.
    Frame(usize),
}

/// Passes the rows of joints to a macro. A row has the kind, the keyword, the coordinates as
/// written, the motions, the tokens required after the keyword, and the form of the statement.
#[doc(hidden)]
#[macro_export]
macro_rules! mobilizers {
    ($then:ident) => {
        $then! {
            /// `revolute q`: turns about an axis.
            Revolute "revolute" "q" [Turn(Own)] Coordinates:
                "write `revolute q = ground to arm { at: p; axis: u; }`";
            /// `prismatic s`: moves along an axis.
            Prismatic "prismatic" "s" [Slide(Own)] Coordinates:
                "write `prismatic s = ground to slider { at: p; axis: u; }`";
            /// `screw q`: turns about an axis and advances along it in proportion.
            Screw "screw" "q" [Turn(Own), Advance] Coordinates:
                "write `screw q = ground to nut { axis: u; pitch: e; }`";
            /// `cylindrical (q, s)`: turns about an axis and moves along it.
            Cylindrical "cylindrical" "(q, s)" [Turn(Own), Slide(Own)] Coordinates:
                "write `cylindrical (q, s) = ground to piston { axis: u; }`";
            /// `universal (a, b)`: turns about x, then about the rotated y.
            Universal "universal" "(a, b)" [Turn(Frame(0)), Turn(Frame(1))] Coordinates:
                "write `universal (a, b) = shaft to fork { at: p; }`";
            /// `planar (x, y, phi)`: moves along x and y and turns about z.
            Planar "planar" "(x, y, phi)" [Slide(Frame(0)), Slide(Frame(1)), Turn(Frame(2))] Coordinates:
                "write `planar (x, y, phi) = ground to puck;`";
            /// `ball hip`: turns about any axis.
            Ball "ball" "hip" [Orientation] Coordinates:
                "write `ball hip = trunk to leg { at: p; }`";
            /// `free trunk`: moves and turns in any direction, without a carrier.
            Free "free" "" [Slide(Frame(0)), Slide(Frame(1)), Slide(Frame(2)), Orientation] Alone:
                "write `free trunk;`, with the name of a body";
            /// `weld`: does not move.
            Weld "weld" "" [] Joint:
                "write `weld arm to hand { at: p; turned: (roll, pitch, yaw); }`";
        }
    };
}

/// Generates the kinds of joints and their properties from the rows.
macro_rules! joints {
    ($(
        #[doc = $doc:literal]
        $kind:ident $word:literal $coordinates:literal [$($motion:expr),*] $soft:ident: $form:literal;
    )*) => {
        /// Kind of a joint that creates coordinates.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum MobilizerKind {
            $(#[doc = $doc] $kind,)*
        }

        /// Words that begin statements about joints with coordinates.
        pub const KEYWORDS: [Keyword; MobilizerKind::ALL.len()] =
            [$(Keyword::new($word, $form).before(Soft::$soft)),*];

        impl MobilizerKind {
            /// Every kind.
            pub const ALL: [MobilizerKind; [$($word),*].len()] = [$(MobilizerKind::$kind),*];

            /// Returns the coordinates as written.
            pub fn written_coordinates(self) -> &'static str {
                match self {
                    $(MobilizerKind::$kind => $coordinates,)*
                }
            }

            /// Returns the motions of the placed body, each in the frame after the previous ones.
            pub fn motions(self) -> &'static [ElementaryMotion] {
                match self {
                    $(MobilizerKind::$kind => &[$($motion),*],)*
                }
            }
        }
    };
}

crate::mobilizers!(joints);

/// A joint that creates coordinates and places a body by them, called a mobilizer in Simbody and
/// Drake.
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
    /// The coordinates that it creates.
    pub coordinates: Vec<Name>,
    /// Names of their rates, if these have separate names.
    pub speeds: Vec<Name>,
    /// The orientation that it creates.
    pub quaternion: Option<Quaternion>,
    /// The body or frame that carries it, or `ground`.
    pub inboard: Name,
    /// The body or frame that it places.
    pub outboard: Name,
    /// `at: (x, y, z);`, the origin of the joint's frame in the axes of its carrier.
    pub at: Option<AstId>,
    /// `turned: (roll, pitch, yaw);`, the orientation of the joint's frame in its carrier; an angle
    /// in the plane.
    pub turned: Option<AstId>,
    /// `axis: (x, y, z);`, in the joint's frame.
    pub axis: Option<AstId>,
    /// `pitch: p;` of a screw, the advance per turn.
    pub pitch: Option<AstId>,
    /// `damping: c;`
    pub damping: Option<AstId>,
}

impl Mobilizer {
    /// Creates a joint without further properties.
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

    /// Creates a free body, with three coordinates and an orientation.
    pub fn free(body: Name) -> Mobilizer {
        let named = |suffix: &str| Name::new(format!("{}_{suffix}", body.text), body.span);
        let (coordinates, speeds) =
            (["x", "y", "z"].map(named).to_vec(), ["vx", "vy", "vz"].map(named).to_vec());
        let quaternion = Some(Quaternion::named(Name::new(body.text.as_str(), body.span)));
        let free = Mobilizer::between(MobilizerKind::Free, Name::new("ground", body.span), body);
        Mobilizer { coordinates, speeds, quaternion, ..free }
    }

    /// Returns the names that it declares.
    pub(super) fn names(&self) -> Vec<&Name> {
        let components = self.quaternion.iter().flat_map(Quaternion::names);
        self.coordinates.iter().chain(&self.speeds).chain(components).collect()
    }

    /// Returns its names, except those derived from others.
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
    /// Returns the keyword of this kind, with the form of its statement.
    pub fn keyword(self) -> &'static Keyword {
        &KEYWORDS[self as usize]
    }

    /// Returns the word that declares this kind.
    pub fn name(self) -> &'static str {
        self.keyword().word
    }

    /// Returns the kind that a word declares.
    pub fn named(word: &str) -> Option<MobilizerKind> {
        MobilizerKind::ALL.into_iter().find(|kind| kind.name() == word)
    }

    /// Returns the number of names before `=`.
    pub fn name_count(self) -> usize {
        let is_named = |motion: &&ElementaryMotion| self != MobilizerKind::Free && **motion != Advance;
        self.motions().iter().filter(is_named).count()
    }

    /// Returns the labels in the description of a joint.
    pub fn labels(self) -> Vec<&'static str> {
        let motions = self.motions();
        let has_axis = motions.iter().any(|motion| matches!(motion, Turn(Own) | Slide(Own)));
        let labels = [
            ("at", true),
            ("turned", true),
            ("axis", has_axis),
            ("pitch", motions.contains(&Advance)),
            ("damping", self.name_count() == 1),
        ];
        let labels = labels.into_iter().filter(|(_, is_known)| *is_known && self != MobilizerKind::Free);
        labels.map(|(label, _)| label).collect()
    }

    /// True if a body on such a joint can leave the plane.
    pub fn leads_out_of_the_plane(self) -> bool {
        let motions = self.motions();
        let is_plane =
            |motion: &ElementaryMotion| matches!(motion, Turn(Own | Frame(2)) | Slide(Own | Frame(0 | 1)));
        // A joint that also moves along its axis of rotation leaves the plane.
        !motions.iter().all(is_plane) || motions.starts_with(&[Turn(Own), Slide(Own)])
    }
}
