//! Rigid bodies of a model: their motion, and the items to draw.

use lagrange_expr::expr::ExprId;
use lagrange_expr::symbol::Role;
use lagrange_language::bodies::DrawnKind;
use lagrange_language::syntax::ast::Name;

/// The requested properties of rigid bodies.
#[derive(Clone, Default, Debug)]
pub struct Scene {
    /// Motions of bodies, in the order of their declaration.
    pub motions: Vec<BodyMotion>,
    /// Poses of bodies and frames in space.
    pub frames: Vec<LinkPose>,
    /// Twists of the frames of bodies.
    pub twists: Vec<LinkTwist>,
    /// Bodies by their inertial parameters, for the regressor.
    pub inertial: Vec<InertialBody>,
    /// Items to draw, in the order of output.
    pub drawing: Vec<DrawnItem>,
}

/// Motion of a body.
#[derive(Clone, Debug)]
pub struct BodyMotion {
    /// The name of the body.
    pub body: Name,
    /// Mass, moment of inertia, centroid in own coordinates, centre, angle, velocity, angular
    /// velocity, acceleration, angular acceleration. In the plane, vectors take two places. In
    /// space, they take three, and the tensor of inertia and the rotation take nine, in rows.
    pub values: Vec<ExprId>,
}

impl BodyMotion {
    /// Number of values that describe the motion of a body in the plane, and in space.
    pub const VALUES: [usize; 2] = [13, 37];

    fn is_in_space(&self) -> bool {
        self.values.len() == BodyMotion::VALUES[1]
    }

    /// Returns the values from one place in the plane, or in space.
    fn part(&self, places: [usize; 2], counts: [usize; 2]) -> &[ExprId] {
        let dimension = usize::from(self.is_in_space());
        &self.values[places[dimension]..][..counts[dimension]]
    }

    /// Returns the mass.
    pub(crate) fn mass(&self) -> ExprId {
        self.values[0]
    }

    /// Returns the moment of inertia, or the tensor in rows, about the centre of mass in body-fixed
    /// axes.
    pub(crate) fn inertia(&self) -> &[ExprId] {
        self.part([1, 1], [1, 9])
    }

    /// Returns the centre of mass.
    pub(crate) fn place(&self) -> &[ExprId] {
        self.part([4, 13], [2, 3])
    }

    /// Returns the rotation from body-fixed axes to those of the world in space, in rows.
    pub(crate) fn rotation(&self) -> Option<&[ExprId]> {
        self.is_in_space().then(|| &self.values[16..25])
    }

    /// Returns the velocity of the centre of mass.
    pub(crate) fn velocity(&self) -> &[ExprId] {
        self.part([7, 25], [2, 3])
    }

    /// Returns the angular velocity.
    pub(crate) fn angular_velocity(&self) -> &[ExprId] {
        self.part([9, 28], [1, 3])
    }

    /// Returns the centre of mass in the plane.
    pub(crate) fn center(&self) -> [ExprId; 2] {
        [self.values[4], self.values[5]]
    }

    /// Returns the angular velocity in the plane.
    pub(crate) fn spin(&self) -> ExprId {
        self.values[9]
    }
}

/// The pose of a body or frame in space.
#[derive(Clone, Debug)]
pub struct LinkPose {
    /// Its name.
    pub name: Name,
    /// Rotation from its axes to those of the world, in rows, and its origin in the world.
    pub values: [ExprId; LinkPose::VALUES],
}

impl LinkPose {
    /// Number of values that describe the pose of a frame.
    pub const VALUES: usize = 12;
}

/// The twist of a body's frame, in world axes.
#[derive(Clone, Debug)]
pub struct LinkTwist {
    /// Its name.
    pub name: Name,
    /// Angular velocity, then the velocity of its origin; affine in the velocities.
    pub values: [ExprId; 6],
}

/// A body by its inertial parameters and by the motion that multiplies them.
#[derive(Clone, Debug)]
pub struct InertialBody {
    /// Its name.
    pub body: Name,
    /// Mass, first moments x, y, z, and the tensor xx, yy, zz, xy, xz, yz about the body-fixed
    /// origin.
    pub parameters: [ExprId; InertialBody::PARAMETERS.len()],
    /// T − V of the body.
    pub lagrangian: ExprId,
    /// Velocity of the origin, then angular velocity, in body-fixed axes; affine in the velocities.
    pub twist: [ExprId; 6],
    /// Acceleration of the origin less that of free fall, then angular acceleration, in body-fixed
    /// axes.
    pub change: [ExprId; 6],
}

impl InertialBody {
    /// Suffixes of the parameters, after the name of the body.
    pub const PARAMETERS: [&'static str; 10] = ["mass", "mx", "my", "mz", "xx", "yy", "zz", "xy", "xz", "yz"];

    fn places(&mut self) -> impl Iterator<Item = &mut ExprId> {
        let vectors = self.twist.iter_mut().chain(&mut self.change);
        self.parameters.iter_mut().chain(vectors).chain([&mut self.lagrangian])
    }
}

/// Item to be drawn.
#[derive(Clone, Debug)]
pub struct DrawnItem {
    /// Kind of the item.
    pub kind: DrawnKind,
    /// Its numbers in the order of its kind; vectors take two places in the plane and three in
    /// space.
    pub values: Vec<ExprId>,
    /// The shape, if it is a body.
    pub parts: Vec<OutlinedPart>,
    /// The height, if it is terrain.
    pub height: Option<SampledHeight>,
}

impl DrawnItem {
    /// Creates an item for a load that is not known.
    pub(crate) fn omitted(name: &str) -> DrawnItem {
        let kind = DrawnKind::Omitted { name: name.to_owned() };
        DrawnItem { kind, values: Vec::new(), parts: Vec::new(), height: None }
    }
}

/// The height of terrain over any place.
#[derive(Clone, Debug)]
pub struct SampledHeight {
    /// Roles of the symbols for one coordinate in the plane, and for two in space.
    pub variables: Vec<Role>,
    /// The height over them.
    pub value: ExprId,
}

/// A part of a body's shape.
#[derive(Clone, Debug)]
pub struct OutlinedPart {
    /// A variant of `lagrange::scene::Outline`, in space of `lagrange::scene::Solid`.
    pub variant: &'static str,
    /// True if the dimensions are corners, of which each takes two places.
    pub has_corners: bool,
    /// Number of values that are dimensions.
    pub dimension_count: usize,
    /// The dimensions, then the origin of its coordinates, then the angle of its axes. In space,
    /// their rotation in rows replaces the angle.
    pub values: Vec<ExprId>,
    /// True if it is cut out.
    pub is_hole: bool,
}

impl Scene {
    /// Returns all places that hold expressions.
    pub(crate) fn places(&mut self) -> Vec<&mut ExprId> {
        let mut places = self.motions.iter_mut().flat_map(|motion| &mut motion.values).collect::<Vec<_>>();
        places.extend(self.frames.iter_mut().flat_map(|frame| &mut frame.values));
        places.extend(self.twists.iter_mut().flat_map(|twist| &mut twist.values));
        places.extend(self.inertial.iter_mut().flat_map(InertialBody::places));
        for item in &mut self.drawing {
            places.extend(&mut item.values);
            places.extend(item.parts.iter_mut().flat_map(|part| &mut part.values));
            places.extend(item.height.iter_mut().map(|height| &mut height.value));
        }
        places
    }
}
