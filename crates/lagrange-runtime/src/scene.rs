//! Descriptions of a system of rigid bodies for drawing at one moment.
//!
//! Types declared with `emit { drawing }` implement [`Scene`], whose [`Space`] is [`Plane`] or
//! [`Spatial`]. The feature `draw` makes pictures and films of both. This module contains only
//! numbers: no pictures, scales or colours.

mod plane;
mod space;
mod spatial;
mod surface;

pub use plane::{Joint, Outline};
pub use space::{Plane, Space, Spatial};
pub use spatial::{Frame, Solid, SpatialJoint, SpatialJointKind};
pub use surface::{Height, Surface, SurfaceShape};

use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, OdeSystem};

/// An item of a system.
type ItemOf<'a, M> = Item<'a, <M as OdeSystem>::Scalar, <M as Scene>::Space>;

/// A system of bodies that provides a description of its drawing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has nothing to draw",
    note = "declare it with `emit {{ drawing }}`"
)]
pub trait Scene: MechanicalSystem {
    /// The plane, or space.
    type Space: Space;

    /// Passes every item to be drawn at time `t`, coordinates `q` and velocities `v` to `visit`.
    /// Surfaces, bodies and frames come first, then connectors and joints, then friction cones,
    /// forces and moments, each in the order of the declaration. Everything is in world axes. In
    /// space, only the places of items change with time, not the items or their shapes, except for
    /// heights of terrain.
    fn items(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        visit: &mut dyn FnMut(ItemOf<'_, Self>),
    );
}

/// An item to be drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Item<'a, S: Scalar, D: Space = Plane> {
    /// A rigid body.
    Body {
        /// Its name.
        name: &'a str,
        /// Motion.
        motion: D::Motion<S>,
        /// Its shape, in its own coordinates; empty for a body without shape.
        parts: &'a [Part<'a, S, D>],
    },
    /// A frame, in space only.
    Frame(D::Frame<'a, S>),
    /// A surface that bodies touch.
    Surface(Surface<'a, S, D>),
    /// A spring or damper.
    Connector {
        /// Its name.
        name: &'a str,
        /// Kind of connector.
        kind: Connector,
        /// One end; for torsion springs and dampers the place where the two bodies meet.
        from: D::Vector<S>,
        /// The other end; the same for torsion springs and dampers.
        to: D::Vector<S>,
        /// The force that pulls both ends together, or the moment that rotates the first body
        /// towards the second.
        tension: S,
    },
    /// A joint.
    Joint {
        /// Its name. In space it is the name of its quaternion, of its first coordinate, of the
        /// placed body, or of a pin.
        name: &'a str,
        /// Kind of joint; in space also its axis and the bodies that it joins.
        kind: D::Joint<'a, S>,
        /// Position; in space the origin of its frame on the carrier.
        at: D::Vector<S>,
    },
    /// A force.
    Force {
        /// Its name.
        name: &'a str,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if known.
        body: Option<&'a str>,
        /// The point it acts on.
        at: D::Vector<S>,
        /// Its components.
        force: D::Vector<S>,
    },
    /// The friction cone of a contact. The force of the contact is within it.
    Cone {
        /// Its name.
        name: &'a str,
        /// The body it acts on, if known.
        body: Option<&'a str>,
        /// The touching point, which is its apex.
        at: D::Vector<S>,
        /// The normal force along its axis; zero if the contact is open.
        normal: D::Vector<S>,
        /// Coefficient of friction, the tangent of half its opening angle.
        coefficient: S,
    },
    /// A moment: positive counterclockwise, in space by the right-hand rule about its own
    /// direction.
    Moment {
        /// Its name.
        name: &'a str,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if known.
        body: Option<&'a str>,
        /// Position at which it is drawn.
        at: D::Vector<S>,
        /// Its value; in space its components.
        moment: D::Moment<S>,
    },
    /// A force or moment that acts but cannot be drawn. A joint satisfied by the choice of
    /// coordinates has no multiplier, and a torque on a coordinate may determine neither a body nor
    /// a place.
    Omitted {
        /// The name of the joint or load.
        name: &'a str,
    },
}

/// A part of a body's shape.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Part<'a, S: Scalar, D: Space = Plane> {
    /// Its outline, or in space its solid, in its own coordinates.
    pub shape: D::Shape<'a, S>,
    /// Origin of its own coordinates in those of the body.
    pub at: D::Vector<S>,
    /// The rotation from its own axes to those of the body.
    pub rotation: D::Rotation<S>,
    /// True if it is cut out of the previous parts.
    pub is_hole: bool,
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

/// The origin of a force or moment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoadOrigin {
    /// It is declared.
    Applied,
    /// The weight of a body, at its centre of mass.
    Gravity,
    /// A spring or damper.
    Connector,
    /// A joint, which enforces its constraint by this force.
    Joint,
    /// A contact, by its normal force or its friction.
    Contact,
}
