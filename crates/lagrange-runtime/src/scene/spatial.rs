//! Frames, shapes of bodies and joints in space.

/// A frame: a link without mass.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame<'a, S> {
    /// Its name.
    pub name: &'a str,
    /// The rotation from its axes to those of the world, in rows.
    pub rotation: [[S; 3]; 3],
    /// Its origin.
    pub origin: [S; 3],
}

/// A solid in its own axes: its axis of symmetry is z, the long side of a rod is x.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Solid<S> {
    /// A point mass at the origin.
    PointMass,
    /// A rod of this length along x, its middle in the origin.
    SlenderRod(S),
    /// A sphere of this radius about the origin, solid or hollow.
    Sphere(S),
    /// An ellipsoid about the origin: its semi-axes along x, y and z.
    Ellipsoid(S, S, S),
    /// A cuboid about the origin: its sides along x, y and z.
    Cuboid(S, S, S),
    /// A disk of this radius about the origin, across z.
    Disk(S),
    /// A ring of this radius about the origin, across z.
    Ring(S),
    /// A cylinder of this radius and height, its middle in the origin.
    Cylinder(S, S),
    /// A tube of this inner radius, outer radius and height, its middle in the origin.
    HollowCylinder(S, S, S),
    /// A cone of this radius and height: its base is at z = 0, its tip at z = h.
    Cone(S, S),
}

/// A joint in space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpatialJoint<'a, S> {
    /// Its kind.
    pub kind: SpatialJointKind,
    /// The direction of its axis, of length one. It is the first axis of a universal joint and the
    /// normal of a planar one. Without an axis, it is z of the joint's frame.
    pub axis: [S; 3],
    /// Names of the carrying and the placed body, or of the two that are pinned; `None` for the
    /// ground.
    pub bodies: [Option<&'a str>; 2],
}

/// The kind of a joint in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SpatialJointKind {
    /// It turns about its axis.
    Revolute,
    /// It moves along its axis.
    Prismatic,
    /// It turns about its axis and moves along it independently.
    Cylindrical,
    /// It turns about its axis and moves along it in proportion.
    Screw,
    /// It turns about two axes at right angles.
    Universal,
    /// It moves across its axis and turns about it.
    Planar,
    /// It turns about a point.
    Ball,
    /// It does not hold anything.
    Free,
    /// It holds everything.
    Weld,
    /// Two points that stay together.
    Pin,
}
