//! Stored bodies, frames and joints of space.

use super::vector::{Rotation, Vector, apply, apply_back};
use crate::geometry::{add, subtract};
use crate::snapshot::{Joint, Named, Snapshot, Stored};
use lagrange_runtime::body::SpatialMotion;
use lagrange_runtime::scalar::Scalar;
use lagrange_runtime::scene::{Frame, Part, Spatial, SpatialJoint, SpatialJointKind};

/// A body or frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Link {
    pub(super) name: String,
    pub(super) origin: Vector,
    pub(super) rotation: Rotation,
    /// Motion, if the link has mass.
    pub(super) motion: Option<SpatialMotion<f64>>,
    pub(super) parts: Vec<SolidPart>,
}

/// A part of a body's shape.
pub(super) type SolidPart = Part<'static, f64, Spatial>;

/// A joint, apart from its name and place.
#[derive(Clone, PartialEq, Debug)]
pub struct Hold {
    pub(super) kind: SpatialJointKind,
    pub(super) axis: Vector,
    pub(super) links: [Option<String>; 2],
}

impl Stored for Spatial {
    type Body = Link;
    type Joint = Hold;

    fn body<S: Scalar + Into<f64>>(
        name: &str,
        _index: usize,
        motion: &SpatialMotion<S>,
        parts: &[Part<'_, S, Spatial>],
    ) -> Link {
        let motion = SpatialMotion {
            mass: motion.mass.into(),
            inertia: motion.inertia.map(Self::vector),
            centroid: Self::vector(motion.centroid),
            center: Self::vector(motion.center),
            rotation: Self::rotation(motion.rotation),
            velocity: Self::vector(motion.velocity),
            angular_velocity: Self::vector(motion.angular_velocity),
            acceleration: Self::vector(motion.acceleration),
            angular_acceleration: Self::vector(motion.angular_acceleration),
        };
        let rotation = motion.rotation;
        Link {
            name: name.to_owned(),
            origin: subtract(motion.center, apply(&rotation, motion.centroid)),
            rotation,
            motion: Some(motion),
            parts: parts.iter().map(part).collect(),
        }
    }

    fn frame<S: Scalar + Into<f64>>(frame: &Frame<'_, S>) -> Link {
        let (origin, rotation) = (Self::vector(frame.origin), Self::rotation(frame.rotation));
        Link { name: frame.name.to_owned(), origin, rotation, motion: None, parts: Vec::new() }
    }

    fn rotation<S: Scalar + Into<f64>>(rotation: [[S; 3]; 3]) -> Rotation {
        rotation.map(Self::vector)
    }

    fn joint<S: Scalar + Into<f64>>(joint: &SpatialJoint<'_, S>) -> Hold {
        let links = joint.bodies.map(|body| body.map(ToOwned::to_owned));
        Hold { kind: joint.kind, axis: Self::vector(joint.axis), links }
    }

    fn vector<S: Scalar + Into<f64>>(vector: [S; 3]) -> Vector {
        vector.map(Into::into)
    }

    fn moment<S: Scalar + Into<f64>>(moment: [S; 3]) -> Vector {
        Self::vector(moment)
    }
}

impl Named for Link {
    fn name(&self) -> &str {
        &self.name
    }
}

impl Link {
    /// Converts a position from body-fixed axes to the world; [`own`](Self::own) is the
    /// inverse.
    pub(super) fn place_of(&self, own: Vector) -> Vector {
        add(self.origin, apply(&self.rotation, own))
    }

    pub(super) fn own(&self, place: Vector) -> Vector {
        apply_back(&self.rotation, subtract(place, self.origin))
    }
}

/// Returns the name of the first item that differs between two scenes in anything but its position.
pub(super) fn difference(one: &Snapshot<Spatial>, other: &Snapshot<Spatial>) -> Option<String> {
    let [names, others] = [one, other].map(|scene| scene.drawn_names().collect::<Vec<_>>());
    let renamed = names.iter().zip(&others).find(|(a, b)| a != b).map(|(name, _)| name);
    let missing = names.get(others.len()).or_else(|| others.get(names.len()));
    let reshaped = one.bodies.iter().zip(&other.bodies).find(|(a, b)| a.parts != b.parts);
    let is_changed = |(a, b): &(&Joint<Spatial>, &Joint<Spatial>)| a.kind.kind != b.kind.kind;
    let changed = one.joints.iter().zip(&other.joints).find(is_changed);
    let of_things = reshaped.map(|(a, _)| &*a.name).or_else(|| changed.map(|(a, _)| &*a.name));
    renamed.or(missing).copied().or(of_things).map(ToOwned::to_owned)
}

fn part<S: Scalar + Into<f64>>(part: &Part<'_, S, Spatial>) -> SolidPart {
    let (at, rotation) = (Spatial::vector(part.at), Spatial::rotation(part.rotation));
    Part { shape: part.shape.map(Into::into), at, rotation, is_hole: part.is_hole }
}
