//! Shapes of bodies and kinds of joints in the plane.

/// Defines outlines from rows with their variants and the names of their dimensions. Only polygons
/// have corners.
macro_rules! outlines {
    ($($(#[doc = $doc:literal])* $Variant:ident $(($($size:ident: $Number:ty),+))?;)+) => {
        /// An outline in its own coordinates, in which [`lagrange::inertia`](mod@crate::inertia)
        /// also returns centres of mass.
        #[derive(Clone, Copy, PartialEq, Debug)]
        pub enum Outline<'a, S> {
            $($(#[doc = $doc])* $Variant $(($($Number),+))?,)+
            /// A polygon with these corners.
            Polygon(&'a [[S; 2]]),
        }

        impl<'a, S> Outline<'a, S> {
            /// Returns the outline of a variant, with these corners or the next numbers as its
            /// dimensions.
            #[doc(hidden)]
            pub fn of_variant(
                variant: &str,
                corners: &'a [[S; 2]],
                next: &mut dyn FnMut() -> S,
            ) -> Option<Outline<'a, S>> {
                $(if variant == stringify!($Variant) {
                    $($(let $size = next();)+)?
                    return Some(Outline::$Variant $(($($size),+))?);
                })+
                (variant == "Polygon").then_some(Outline::Polygon(corners))
            }
        }
    };
}

outlines! {
    /// A point mass at the origin.
    PointMass;
    /// A rod of this length along X, with its middle at the origin.
    SlenderRod(length: S);
    /// A disk of this radius about the origin; also a cylinder or sphere seen from its end.
    Disk(radius: S);
    /// A disk about the origin with a concentric hole: inner and outer radius.
    Annulus(inner: S, outer: S);
    /// A circle of this radius about the origin.
    Ring(radius: S);
    /// A rectangle about the origin: lengths along X and along Y.
    Rectangle(a: S, b: S);
    /// Half a disk of this radius, on the side of positive Y; the middle of its straight edge is at
    /// the origin.
    SemicircularDisk(radius: S);
    /// A sector of a disk: its radius and its opening angle, bisected by the X axis; the apex is at
    /// the origin.
    CircularSector(radius: S, angle: S);
    /// A triangle with the right angle at the origin and legs of these lengths along X and Y.
    RightTriangle(a: S, b: S);
    /// A triangle with these three sides. The first extends from the origin along X, the second
    /// continues from its end, and the third returns; Y is positive inside.
    Triangle(a: S, b: S, c: S);
    /// An ellipse about the origin: semi-axes along X and along Y.
    Ellipse(a: S, b: S);
    /// A regular polygon with this number of corners on a circle of this radius about the origin,
    /// with the first corner on the X axis.
    RegularPolygon(corners: S, radius: S);
}

/// The kind of a joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Joint {
    /// Two points that stay together.
    Pin,
    /// A point that is fixed in place.
    Anchor,
    /// A point that stays on a line.
    Slide,
    /// A round body that rolls on a line.
    Roll,
}
