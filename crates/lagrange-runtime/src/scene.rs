//! A description of a system of rigid bodies to be drawn at one moment.
//!
//! Types declared with `emit { drawing }` implement [`Scene`], whose [`Space`] is the [`Plane`] or
//! [`Spatial`]; the feature `draw` makes pictures and films of both. Here are numbers only: no
//! picture, no scale, no colour.

mod plane;
mod space;
mod spatial;

pub use plane::{Joint, Line, Outline};
pub use space::{Plane, Space, Spatial};
pub use spatial::{Frame, Solid, SpatialJoint, SpatialJointKind};

use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, OdeSystem};

/// An item of a system.
type ItemOf<'a, M> = Item<'a, <M as OdeSystem>::Scalar, <M as Scene>::Space>;

/// A system of bodies that hands out what there is to draw of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has nothing to draw",
    note = "declare it with `emit {{ drawing }}`"
)]
pub trait Scene: MechanicalSystem {
    /// The plane or space.
    type Space: Space;

    /// Passes on everything to be drawn at time `t`, coordinates `q` and velocities `v`. First come
    /// lines, bodies and frames, connectors and joints, then forces and moments, each in the order
    /// of the declaration. Everything is in the axes of the world. In space, only the places of
    /// items change with time, not the items or their shapes.
    fn items(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        visit: &mut dyn FnMut(ItemOf<'_, Self>),
    );
}

/// Something to be drawn.
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
    /// A straight line without ends, in the plane only.
    Line(D::Line<'a, S>),
    /// A spring or damper.
    Connector {
        /// Its name.
        name: &'a str,
        /// Kind of connector.
        kind: Connector,
        /// One end; for torsion springs and dampers where the two bodies meet.
        from: D::Vector<S>,
        /// The other end; the same for torsion springs and dampers.
        to: D::Vector<S>,
        /// The force by which it pulls both ends together, or the moment that turns the first body
        /// towards the second.
        tension: S,
    },
    /// A joint.
    Joint {
        /// Its name. In space it is that of its quaternion, of its first coordinate, of the placed
        /// body, or of a pin.
        name: &'a str,
        /// Kind of joint; in space with its axis and the bodies that it joins.
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
        /// The body it acts on, if that is known.
        body: Option<&'a str>,
        /// The point it acts on.
        at: D::Vector<S>,
        /// Its components.
        force: D::Vector<S>,
    },
    /// A moment: positive counterclockwise, in space about its own direction by the right hand.
    Moment {
        /// Its name.
        name: &'a str,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if that is known.
        body: Option<&'a str>,
        /// Position at which it is drawn.
        at: D::Vector<S>,
        /// Its value, in space its components.
        moment: D::Moment<S>,
    },
    /// A force or moment that acts and is not included. A joint that the coordinates satisfy has no
    /// multiplier, and a torque on a coordinate may determine neither a body nor a place.
    Omitted {
        /// The name of the joint, or what acts.
        name: &'a str,
    },
}

/// A part of a body's shape.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Part<'a, S: Scalar, D: Space = Plane> {
    /// Its outline, in space its solid, in its own coordinates.
    pub shape: D::Shape<'a, S>,
    /// Origin of its own coordinates in those of the body.
    pub at: D::Vector<S>,
    /// The rotation from its own axes to those of the body.
    pub rotation: D::Rotation<S>,
    /// True if it is cut out of the parts before it.
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
    /// A joint, which upholds its constraint by this force.
    Joint,
    /// A contact, by its normal force or its friction.
    Contact,
}
