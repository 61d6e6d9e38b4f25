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

/// A solid in its own axes. Its axis of symmetry is z; a rod is along x.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Solid<S> {
    /// A point mass at the origin.
    PointMass,
    /// A rod of this length along x, with its middle at the origin.
    SlenderRod(S),
    /// A sphere of this radius about the origin, solid or hollow.
    Sphere(S),
    /// An ellipsoid about the origin: its semi-axes along x, y and z.
    Ellipsoid(S, S, S),
    /// A cuboid about the origin: its sides along x, y and z.
    Cuboid(S, S, S),
    /// A disk of this radius about the origin, normal to z.
    Disk(S),
    /// A ring of this radius about the origin, normal to z.
    Ring(S),
    /// A cylinder of this radius and height, with its middle at the origin.
    Cylinder(S, S),
    /// A tube of this inner radius, outer radius and height, with its middle at the origin.
    HollowCylinder(S, S, S),
    /// A cone of this radius and height, with its base at z = 0 and its tip at z = h.
    Cone(S, S),
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
