//! A declaration in plain statements, with additional data about its bodies.

use crate::syntax::ast::{
    AstId, ConnectorKind, Declaration, MobilizerKind, Name, StatementKind, SurfaceKind,
};
use lagrange_expr::diagnostics::Origin;

/// A declaration without statements about bodies, and the properties of the bodies.
///
/// Expressions are those of the declaration.
#[derive(Clone, Debug)]
pub struct Plain {
    /// The plain statements.
    pub declaration: Declaration,
    /// Motions of bodies, in the order of their declaration.
    pub motions: Vec<Motion>,
    /// Requested kinematics of bodies and frames in space.
    pub in_space: SpatialKinematics,
    /// Bodies by their inertial parameters, if the regressor is requested.
    pub inertial: Vec<InertialBody>,
    /// Items to draw.
    pub drawing: Vec<Drawn>,
    /// Conditions on numbers, checked when these are known.
    pub obligations: Vec<Obligation>,
    /// Names of the constraints of joints. They are omitted if the coordinates satisfy them
    /// identically.
    pub joints: Vec<Name>,
    /// Names of `let`s that are places, with their owners: they depend on coordinates and time.
    pub places: Vec<(String, String)>,
    /// Expressions in statements about bodies, so that errors in them are found even if they are
    /// not needed.
    pub mentioned: Vec<AstId>,
    /// Heights of terrain, which are among the mentioned expressions.
    pub heights: Vec<AstId>,
}

impl Plain {
    /// Removes these constraints of joints.
    pub fn without(self, constraints: &[String]) -> Declaration {
        let mut declaration = self.declaration;
        declaration.statements.retain(|statement| match &statement.kind {
            StatementKind::Constraint(name, _) => !constraints.contains(&name.text),
            _ => true,
        });
        declaration
    }
}

/// Motion of a body. Vectors have two components; rates may contain `ddot`.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The name of the body.
    pub body: Name,
    /// The position of its centre of mass.
    pub center: AstId,
    /// The centre of mass in the body's own coordinates.
    pub centroid: AstId,
    /// The angle of the frame's axes.
    pub angle: AstId,
    /// Its mass.
    pub mass: AstId,
    /// Its moment of inertia about the centre of mass.
    pub inertia: AstId,
}

/// A body by its inertial parameters and by the motion that multiplies them. All expressions are
/// scalars; rates may contain `ddot`.
#[derive(Clone, Debug)]
pub struct InertialBody {
    /// The name of the body.
    pub body: Name,
    /// Mass, first moments x, y, z, and the tensor xx, yy, zz, xy, xz, yz about the body-fixed
    /// origin.
    pub parameters: [AstId; 10],
    /// T − V of the body.
    pub lagrangian: AstId,
    /// Velocity of the origin, then angular velocity, in body-fixed axes.
    pub twist: [AstId; 6],
    /// Acceleration of the origin less that of free fall, then angular acceleration, in body-fixed
    /// axes.
    pub change: [AstId; 6],
}

impl InertialBody {
    /// Returns all expressions.
    pub(super) fn expressions(&self) -> impl Iterator<Item = AstId> {
        let vectors = self.twist.iter().chain(&self.change).copied();
        self.parameters.into_iter().chain(vectors.collect::<Vec<_>>()).chain([self.lagrangian])
    }
}

/// Bodies and frames in space, in the order of their declaration. All expressions are scalars.
#[derive(Clone, Default, Debug)]
pub struct SpatialKinematics {
    /// Motions of bodies.
    pub motions: Vec<SpatialMotion>,
    /// Poses of bodies and frames.
    pub frames: Vec<FramePose>,
    /// Twists of their frames.
    pub twists: Vec<FrameTwist>,
}

/// Motion of a body in space. Rates may contain `ddot`.
#[derive(Clone, Debug)]
pub struct SpatialMotion {
    /// The name of the body.
    pub body: Name,
    /// Its mass.
    pub mass: AstId,
    /// xx, yy, zz, xy, xz, yz of its tensor of inertia about the centre of mass, in body-fixed
    /// axes.
    pub tensor: [AstId; 6],
    /// The centre of mass in own coordinates.
    pub centroid: [AstId; 3],
    /// Its axes in the world.
    pub axes: [[AstId; 3]; 3],
    /// The position of the centre of mass, its velocity and its acceleration, in the world.
    pub center: [[AstId; 3]; 3],
    /// Angular velocity and angular acceleration, in the world.
    pub turning: [[AstId; 3]; 2],
}

/// The pose of a body or frame.
#[derive(Clone, Debug)]
pub struct FramePose {
    /// Its name.
    pub name: Name,
    /// Its axes in the world.
    pub axes: [[AstId; 3]; 3],
    /// Its origin in the world.
    pub origin: [AstId; 3],
}

/// The twist of a body's frame, in world axes.
#[derive(Clone, Debug)]
pub struct FrameTwist {
    /// Its name.
    pub name: Name,
    /// The angular velocity.
    pub spin: [AstId; 3],
    /// The velocity of its origin.
    pub velocity: [AstId; 3],
}

impl SpatialKinematics {
    /// Returns all expressions.
    pub(super) fn expressions(&self) -> Vec<AstId> {
        let mut all = Vec::new();
        for motion in &self.motions {
            all.push(motion.mass);
            all.extend(motion.tensor.iter().chain(&motion.centroid));
            all.extend(motion.axes.iter().chain(&motion.center).chain(&motion.turning).flatten());
        }
        for frame in &self.frames {
            all.extend(frame.axes.iter().flatten().chain(&frame.origin));
        }
        all.extend(self.twists.iter().flat_map(|twist| twist.spin.iter().chain(&twist.velocity)));
        all
    }
}

/// Item to be drawn.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Kind of the item.
    pub kind: DrawnKind,
    /// Its numbers, scalars and vectors, in the order of its kind.
    pub values: Vec<AstId>,
    /// Constraints whose multipliers the values contain: the item is omitted if one of them is
    /// omitted.
    pub needs: Vec<String>,
}

/// Kinds of items to draw; vectors have two components in the plane and three in space.
#[derive(Clone, Debug)]
pub enum DrawnKind {
    /// A body: no values, but one outline for each part of its shape.
    Body {
        /// Its index among the motions.
        body: usize,
        /// Its parts.
        outlines: Vec<Outline>,
    },
    /// A frame in space: the rotation from its axes to those of the world, in rows, and its origin.
    Frame {
        /// Its name.
        name: String,
    },
    /// A surface: a point on it or its centre, the rotation of its axes, and its radius if it is
    /// round. The rotation is an angle, and in space a matrix in rows.
    Surface {
        /// Its name.
        name: String,
        /// The body or frame that carries it.
        body: Option<String>,
        /// Its kind.
        kind: SurfaceKind,
        /// True if bodies touch it from inside.
        is_inside: bool,
        /// The height, if it is terrain, as a function of variables with these names.
        height: Option<(Vec<String>, AstId)>,
    },
    /// A connector: both ends and, if positive, its tension. The ends of torsion springs and
    /// dampers are one place.
    Connector {
        /// Its name.
        name: String,
        /// Kind of the connector.
        kind: ConnectorKind,
    },
    /// A joint: its position.
    Joint {
        /// Its name.
        name: String,
        /// Kind of joint: a pin, a slide or a roll.
        kind: JointForm,
    },
    /// A joint in space: its position, and the direction of its axis.
    SpatialJoint {
        /// Its name.
        name: String,
        /// Kind of joint.
        kind: SpatialJointForm,
        /// Names of the carrying and the placed link, or of the two pinned links; `None` for the
        /// ground.
        links: [Option<String>; 2],
    },
    /// A force: its point of application and its components.
    Force {
        /// Its name.
        name: String,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if that is known.
        body: Option<String>,
    },
    /// A friction cone: the touching point, the normal force, and the coefficient of friction.
    Cone {
        /// Its name.
        name: String,
        /// The body it acts on.
        body: Option<String>,
    },
    /// A moment: the position where it is drawn, and its value, which is a vector in space.
    Moment {
        /// Its name.
        name: String,
        /// Origin of the load.
        cause: LoadOrigin,
        /// The body it acts on, if that is known.
        body: Option<String>,
    },
    /// A torque on an angle that is not named after a body: its value, and the angle. The bodies
    /// that it turns follow from their angles.
    Torque {
        /// Name for pictures that cannot show it.
        name: String,
    },
    /// A force or moment that acts, but whose value or place is not known: no values.
    Omitted {
        /// Name of the omitted item.
        name: String,
    },
}

/// The outline of a part of a body, or the solid in space: its dimensions (corners of a polygon are
/// vectors).
#[derive(Clone, Debug)]
pub struct Outline {
    /// The variant of `lagrange::scene::Outline`, or in space of `lagrange::scene::Solid`.
    pub variant: &'static str,
    /// Its dimensions.
    pub dimensions: Vec<AstId>,
    /// Pose of its own coordinates in those of the body. In the plane, it consists of the origin as
    /// a vector and the angle of the axes. In space, it consists of the components of the origin,
    /// then those of the rotation in rows.
    pub place: Vec<AstId>,
    /// True if it is cut out.
    pub is_hole: bool,
}

/// The form of a joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JointForm {
    /// A pin.
    Pin,
    /// A pin on something at rest.
    Anchor,
    /// A point on a line.
    Slide,
    /// A round body on a line.
    Roll,
}

/// The form of a joint in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SpatialJointForm {
    /// A joint that creates coordinates.
    Mobilizer(MobilizerKind),
    /// A pin.
    Pin,
}

/// Origin of a force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoadOrigin {
    /// A `force` or `torque` statement.
    Applied,
    /// The weight.
    Gravity,
    /// A spring or damper.
    Connector,
    /// A joint: its multipliers.
    Joint,
    /// A contact: its normal force or its friction.
    Contact,
}

/// Condition on numbers, checked when these are known.
#[derive(Clone, Debug)]
pub enum Obligation {
    /// A mass must be positive.
    PositiveMass {
        /// The body.
        body: Name,
        /// Its mass.
        mass: AstId,
    },
    /// A moment of inertia must not be negative.
    Inertia {
        /// The body.
        body: Name,
        /// Its moment of inertia about its centre of mass.
        inertia: AstId,
    },
    /// A vector of two components.
    PlaneVector {
        /// Description in words.
        what: String,
        /// It.
        value: AstId,
    },
    /// A vector of three components.
    SpaceVector {
        /// Description in words.
        what: String,
        /// It.
        value: AstId,
    },
    /// A tensor of inertia must be that of some distribution of mass.
    Tensor {
        /// The body.
        body: Name,
        /// xx, yy, zz, xy, xz, yz about its centre of mass.
        tensor: [AstId; 6],
    },
    /// A mass or inertia, which may change, but neither with the motion nor with inputs.
    Unmoved {
        /// Description in words.
        what: String,
        /// It.
        value: AstId,
    },
    /// The mass or inertia of a body changes: the inertia only with the mass.
    Matter {
        /// The body.
        body: Name,
        /// Its mass.
        mass: AstId,
        /// The entries of its inertia.
        inertia: Vec<AstId>,
    },
    /// A property of a rigid body, which does not change during the motion.
    Fixed {
        /// Description in words.
        what: String,
        /// It.
        value: AstId,
    },
    /// Gravity is the same everywhere.
    Uniform {
        /// Its vector.
        gravity: AstId,
    },
    /// The place or the angle of a body changes with coordinates or time.
    Moves {
        /// The body.
        body: Name,
        /// Its centre of mass.
        center: AstId,
        /// Its angle.
        angle: AstId,
    },
    /// The gap of a compliant contact changes with coordinates.
    Opens {
        /// The contact.
        contact: Name,
        /// Its gap.
        gap: AstId,
    },
    /// A quantity of a contact is within bounds. Runs check it if it depends on parameters.
    InRange {
        /// The contact.
        contact: Name,
        /// Description in words that precede the name of the contact.
        quantity: String,
        /// It.
        value: AstId,
        /// Lower bound, with true if it is included.
        lower: (AstId, bool),
    },
    /// The centres of a compliant contact do not coincide.
    Apart {
        /// The contact.
        contact: Name,
        /// Their distance.
        distance: AstId,
    },
    /// The stated moment of inertia should be that of the shape.
    SameInertia {
        /// The body.
        body: Name,
        /// Stated value.
        stated: AstId,
        /// Value for the shape with the stated mass.
        of_shape: AstId,
        /// Place of the shape.
        shape: Origin,
    },
}
