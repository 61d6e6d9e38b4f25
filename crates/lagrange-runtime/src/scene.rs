//! A description of a system of rigid bodies to be drawn at one moment.
//!
//! Types declared with `emit { drawing }` implement [`Scene`] if their bodies move in the plane, and [`SpatialScene`] if they move in
//! space; the feature `draw` makes pictures and films of both. Here are numbers only: no picture, no scale, no colour.

mod spatial;

pub use spatial::{Solid, SolidPart, SpatialItem, SpatialJoint, SpatialScene};

use crate::body::Motion;
use crate::system::MechanicalSystem;

/// A system of bodies in the plane that says what there is to draw of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what there is to draw of it",
    note = "declare it with `emit {{ drawing }}`; systems in space are drawn by `SpatialDrawing`"
)]
pub trait Scene: MechanicalSystem {
    /// Hands out everything that is to be drawn at time `t`, coordinates `q` and velocities `v`, in the order of the declaration:
    /// lines, bodies, connectors, joints, and then forces and moments.
    fn items(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        visit: &mut dyn FnMut(Item<'_, Self::Scalar>),
    );
}

/// Something to be drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Item<'a, S> {
    /// A rigid body.
    Body {
        /// Its name.
        name: &'a str,
        /// Motion.
        motion: Motion<S>,
        /// Its shape, in its own coordinates; empty if it has none.
        parts: &'a [Part<'a, S>],
    },
    /// A straight line without ends: ground, a slope, a rail. Its free side is on the left of its direction.
    Line {
        /// Its name.
        name: &'a str,
        /// The body that carries it; none if it is at rest.
        body: Option<&'a str>,
        /// A point of it.
        through: [S; 2],
        /// Its direction.
        angle: S,
    },
    /// A spring or damper.
    Connector {
        /// Its name.
        name: &'a str,
        /// Kind of connector.
        kind: Connector,
        /// One end; for torsion springs and dampers where the two bodies meet.
        from: [S; 2],
        /// The other end; the same for torsion springs and dampers.
        to: [S; 2],
        /// The force by which it pulls both ends together, or the moment that turns the first body towards the second.
        tension: S,
    },
    /// A joint.
    Joint {
        /// Its name.
        name: &'a str,
        /// Kind of joint.
        kind: Joint,
        /// Position.
        at: [S; 2],
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
        at: [S; 2],
        /// Its components.
        force: [S; 2],
    },
    /// A moment, positive counterclockwise.
    Moment {
        /// Its name.
        name: &'a str,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if that is known.
        body: Option<&'a str>,
        /// Position at which it is drawn.
        at: [S; 2],
        /// Its value.
        moment: S,
    },
    /// A force or moment that acts and is not handed out: that of a joint which the coordinates fulfil by themselves, since it has no
    /// multiplier, or a torque on an angle that does not tell which bodies it turns.
    Omitted {
        /// The name of the joint, or what acts.
        name: &'a str,
    },
}

/// A part of a body's shape.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Part<'a, S> {
    /// Its outline, in its own coordinates.
    pub outline: Outline<'a, S>,
    /// Origin of its own coordinates in those of the body.
    pub at: [S; 2],
    /// Angle of its own axes relative to those of the body.
    pub angle: S,
    /// True if it is cut out of the parts before it.
    pub is_hole: bool,
}

/// An outline in its own coordinates, the same in which [`lagrange::inertia`](mod@crate::inertia) says where centres of mass are.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Outline<'a, S> {
    /// A point mass at the origin.
    PointMass,
    /// A rod of this length along X, its middle in the origin.
    SlenderRod(S),
    /// A disk of this radius about the origin; also a cylinder or sphere seen from its end.
    Disk(S),
    /// A disk about the origin with a hole: inner and outer radius.
    Annulus(S, S),
    /// A circle of this radius about the origin.
    Ring(S),
    /// A rectangle about the origin: lengths along X and along Y.
    Rectangle(S, S),
    /// Half a disk of this radius, on the side of positive Y; the middle of its straight edge is in the origin.
    SemicircularDisk(S),
    /// A sector of a disk: its radius and its opening angle, halved by the X axis; the apex is in the origin.
    CircularSector(S, S),
    /// A triangle with the right angle in the origin and legs of these lengths along X and Y.
    RightTriangle(S, S),
    /// A triangle of these three sides; the first goes from the origin along X, the second on from there, the third back; Y is
    /// positive inside.
    Triangle(S, S, S),
    /// An ellipse about the origin: semi-axes along X and along Y.
    Ellipse(S, S),
    /// A regular polygon of this many corners on a circle of this radius about the origin, the first on the X axis.
    RegularPolygon(S, S),
    /// A polygon of these corners.
    Polygon(&'a [[S; 2]]),
}

/// The kind of a connector.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Connector {
    /// A spring between two points.
    Spring,
    /// A damper between two points.
    Damper,
    /// A spring between two angles.
    TorsionSpring,
    /// A damper between two angles.
    TorsionDamper,
}

/// The kind of a joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Joint {
    /// Two points that stay together.
    Pin,
    /// A point that stays where it is.
    Anchor,
    /// A point that stays on a line.
    Slide,
    /// A round body that rolls on a line.
    Roll,
}

/// The origin of a force or moment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoadOrigin {
    /// It is declared.
    Applied,
    /// The weight of a body, at its centre of mass.
    Gravity,
    /// A spring or damper.
    Connector,
    /// A joint, which upholds its constraint by this force.
    Joint,
}
