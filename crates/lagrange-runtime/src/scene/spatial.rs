//! A description of bodies in space to be drawn.

use super::{Connector, LoadOrigin};
use crate::body::SpatialMotion;
use crate::system::MechanicalSystem;

/// A system of bodies in space that says what there is to draw of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what there is to draw of it in space",
    note = "declare it with `emit {{ drawing }}`; systems in the plane are drawn by `Drawing`"
)]
pub trait SpatialScene: MechanicalSystem {
    /// Hands out everything that is to be drawn at time `t`, coordinates `q` and velocities `v`: bodies and frames, then connectors,
    /// joints, and then forces and moments, each in the order of the declaration. Everything is in the axes of the world.
    /// At all moments these are the same things of the same shape, but for where they are.
    fn items(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        visit: &mut dyn FnMut(SpatialItem<'_, Self::Scalar>),
    );
}

/// Something to be drawn in space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SpatialItem<'a, S> {
    /// A rigid body.
    Body {
        /// Its name.
        name: &'a str,
        /// Motion.
        motion: SpatialMotion<S>,
        /// Its shape, in its own axes; empty if it has none.
        parts: &'a [SolidPart<S>],
    },
    /// A frame: a link without mass.
    Frame {
        /// Its name.
        name: &'a str,
        /// The rotation from its axes to those of the world, in rows.
        rotation: [[S; 3]; 3],
        /// Its origin.
        origin: [S; 3],
    },
    /// A spring or damper between two points.
    Connector {
        /// Its name.
        name: &'a str,
        /// Kind of connector.
        kind: Connector,
        /// One end.
        from: [S; 3],
        /// The other end.
        to: [S; 3],
        /// The force by which it pulls both ends together.
        tension: S,
    },
    /// A joint.
    Joint {
        /// Its name: that of its quaternion, of its first coordinate, or of what it places; that of a pin.
        name: &'a str,
        /// Kind of joint.
        kind: SpatialJoint,
        /// Position: the origin of its frame on the carrier.
        at: [S; 3],
        /// The direction of its axis, of length one: the first axis of a universal joint, the normal of a planar one, z of the joint's frame
        /// if it has no axis.
        axis: [S; 3],
        /// Names of the carrying and the placed body, or of the two that are pinned; `None` for the
        /// ground.
        bodies: [Option<&'a str>; 2],
    },
    /// A force.
    Force {
        /// Its name.
        name: &'a str,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if that is known.
        body: Option<&'a str>,
        /// The point it acts on.
        at: [S; 3],
        /// Its components.
        force: [S; 3],
    },
    /// A moment, about its own direction by the right hand.
    Moment {
        /// Its name.
        name: &'a str,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if that is known.
        body: Option<&'a str>,
        /// Position at which it is drawn.
        at: [S; 3],
        /// Its components.
        moment: [S; 3],
    },
    /// A force or moment that acts and is not handed out: that of a pin which the coordinates fulfil by themselves, since it has no
    /// multipliers, or one on a coordinate that does not tell where it acts.
    Omitted {
        /// The name of the pin, or what acts.
        name: &'a str,
    },
}

/// A part of a body's shape.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SolidPart<S> {
    /// Solid, in its own axes.
    pub solid: Solid<S>,
    /// Origin of its own axes in those of the body.
    pub at: [S; 3],
    /// The rotation from its own axes to those of the body, in rows.
    pub rotation: [[S; 3]; 3],
    /// True if it is cut out of the parts before it.
    pub is_hole: bool,
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

/// The kind of a joint in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SpatialJoint {
    /// It turns about its axis.
    Revolute,
    /// It moves along its axis.
    Prismatic,
    /// It turns about its axis and moves along it by itself.
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
