//! Frames, shapes of bodies and joints in space.

/// A frame: a massless link.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame<'a, S> {
    /// Its name.
    pub name: &'a str,
    /// The rotation from its axes to world axes, in rows.
    pub rotation: [[S; 3]; 3],
    /// Its origin.
    pub origin: [S; 3],
}

/// Defines solids from rows with their variants and the names of their dimensions.
macro_rules! solids {
    ($($(#[doc = $doc:literal])* $Variant:ident $(($($size:ident: $Number:ty),+))?;)+) => {
        /// A solid in its own axes. Its axis of symmetry is z; a rod is along x.
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum Solid<S> {
            $($(#[doc = $doc])* $Variant $(($($Number),+))?,)+
        }

        impl<S> Solid<S> {
            /// Returns the solid of a variant, with the next numbers as its dimensions.
            #[doc(hidden)]
            pub fn of_variant(variant: &str, next: &mut dyn FnMut() -> S) -> Option<Solid<S>> {
                $(if variant == stringify!($Variant) {
                    $($(let $size = next();)+)?
                    return Some(Solid::$Variant $(($($size),+))?);
                })+
                None
            }

            /// Converts the dimensions.
            #[must_use]
            pub fn map<T>(self, convert: impl Fn(S) -> T) -> Solid<T> {
                match self {
                    $(Solid::$Variant $(($($size),+))? => Solid::$Variant $(($(convert($size)),+))?,)+
                }
            }
        }
    };
}

solids! {
    /// A point mass at the origin.
    PointMass;
    /// A rod of this length along x, with its middle at the origin.
    SlenderRod(length: S);
    /// A sphere of this radius about the origin, solid or hollow.
    Sphere(radius: S);
    /// An ellipsoid about the origin: its semi-axes along x, y and z.
    Ellipsoid(a: S, b: S, c: S);
    /// A cuboid about the origin: its sides along x, y and z.
    Cuboid(a: S, b: S, c: S);
    /// A disk of this radius about the origin, normal to z.
    Disk(radius: S);
    /// A ring of this radius about the origin, normal to z.
    Ring(radius: S);
    /// A cylinder of this radius and height, with its middle at the origin.
    Cylinder(radius: S, height: S);
    /// A tube of this inner radius, outer radius and height, with its middle at the origin.
    HollowCylinder(inner: S, outer: S, height: S);
    /// A cone of this radius and height, with its base at z = 0 and its tip at z = h.
    Cone(radius: S, height: S);
}

/// A joint in space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpatialJoint<'a, S> {
    /// Its kind.
    pub kind: SpatialJointKind,
    /// The unit vector along its axis. It is the first axis of a universal joint and the normal of
    /// a planar one. Without an axis, it is z of the joint's frame.
    pub axis: [S; 3],
    /// Names of the carrying and the placed body, or of the two pinned bodies; `None` for the
    /// ground.
    pub bodies: [Option<&'a str>; 2],
}

/// The kind of a joint in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SpatialJointKind {
    /// Rotation about its axis.
    Revolute,
    /// Translation along its axis.
    Prismatic,
    /// Independent rotation about and translation along its axis.
    Cylindrical,
    /// Rotation about its axis with a proportional translation along it.
    Screw,
    /// Rotation about two axes at right angles.
    Universal,
    /// Translation normal to its axis and rotation about it.
    Planar,
    /// Rotation about a point.
    Ball,
    /// Motion without any restriction.
    Free,
    /// No relative motion.
    Weld,
    /// Two points that stay together.
    Pin,
}
