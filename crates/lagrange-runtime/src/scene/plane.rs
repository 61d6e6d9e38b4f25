//! Shapes of bodies and kinds of joints in the plane.

/// An outline in its own coordinates, in which [`lagrange::inertia`](mod@crate::inertia) also
/// returns centres of mass.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Outline<'a, S> {
    /// A point mass at the origin.
    PointMass,
    /// A rod of this length along X, with its middle at the origin.
    SlenderRod(S),
    /// A disk of this radius about the origin; also a cylinder or sphere seen from its end.
    Disk(S),
    /// A disk about the origin with a concentric hole: inner and outer radius.
    Annulus(S, S),
    /// A circle of this radius about the origin.
    Ring(S),
    /// A rectangle about the origin: lengths along X and along Y.
    Rectangle(S, S),
    /// Half a disk of this radius, on the side of positive Y; the middle of its straight edge is at
    /// the origin.
    SemicircularDisk(S),
    /// A sector of a disk: its radius and its opening angle, bisected by the X axis; the apex is at
    /// the origin.
    CircularSector(S, S),
    /// A triangle with the right angle at the origin and legs of these lengths along X and Y.
    RightTriangle(S, S),
    /// A triangle with these three sides. The first extends from the origin along X, the second
    /// continues from its end, and the third returns; Y is positive inside.
    Triangle(S, S, S),
    /// An ellipse about the origin: semi-axes along X and along Y.
    Ellipse(S, S),
    /// A regular polygon with this number of corners on a circle of this radius about the origin,
    /// with the first corner on the X axis.
    RegularPolygon(S, S),
    /// A polygon with these corners.
    Polygon(&'a [[S; 2]]),
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
