//! Stored bodies and joints of the plane.

use crate::geometry::Place;
use crate::outline::Piece;
use crate::remainder::Remainder;
use crate::snapshot::{Named, Snapshot, Stored};
use lagrange_runtime::body::Motion;
use lagrange_runtime::scalar::Scalar;
use lagrange_runtime::scene::{Joint, Part, Plane};
use std::convert::Infallible;

/// A body.
#[derive(Clone, PartialEq, Debug)]
pub struct Body {
    pub(super) name: String,
    /// Index of the body in the scene, regardless of hidden bodies.
    pub(super) index: usize,
    pub(super) motion: Motion<f64>,
    pub(super) pieces: Vec<Piece>,
}

impl Stored for Plane {
    type Body = Body;
    type Joint = Joint;

    fn body<S: Scalar + Into<f64>>(
        name: &str,
        index: usize,
        motion: &Motion<S>,
        parts: &[Part<'_, S>],
    ) -> Body {
        let motion = Motion {
            mass: motion.mass.into(),
            inertia: motion.inertia.into(),
            centroid: Self::vector(motion.centroid),
            center: Self::vector(motion.center),
            angle: motion.angle.into(),
            velocity: Self::vector(motion.velocity),
            angular_velocity: motion.angular_velocity.into(),
            acceleration: Self::vector(motion.acceleration),
            angular_acceleration: motion.angular_acceleration.into(),
        };
        Body { name: name.to_owned(), index, motion, pieces: parts.iter().map(Piece::of).collect() }
    }

    fn frame<S: Scalar + Into<f64>>(frame: &Infallible) -> Body {
        match *frame {}
    }

    fn rotation<S: Scalar + Into<f64>>(angle: S) -> f64 {
        angle.into()
    }

    fn joint<S: Scalar + Into<f64>>(joint: &Joint) -> Joint {
        *joint
    }

    fn vector<S: Scalar + Into<f64>>(vector: [S; 2]) -> [f64; 2] {
        vector.map(Into::into)
    }

    fn moment<S: Scalar + Into<f64>>(moment: S) -> f64 {
        moment.into()
    }
}

impl Named for Body {
    fn name(&self) -> &str {
        &self.name
    }
}

impl Body {
    /// Returns the map from the body's own coordinates to the world.
    pub(super) fn place(&self) -> Place {
        let Motion { center, centroid, angle, .. } = self.motion;
        let turned = Place { at: [0.0, 0.0], angle }.of(centroid);
        Place { at: [center[0] - turned[0], center[1] - turned[1]], angle }
    }
}

impl Snapshot {
    /// Returns the resultant of unnamed loads on a body, in numbers with the relative spacing
    /// `epsilon`.
    pub(super) fn remainder_of(&self, name: &str, epsilon: f64) -> Option<Remainder> {
        let loads = self.loads.iter().filter(|load| load.body.as_deref() == Some(name));
        self.body(name).map(|body| Remainder::of(&body.motion, loads, epsilon))
    }

    /// Keeps only one body and its loads.
    pub(super) fn free_body(mut self, name: &str) -> Self {
        self.bodies.retain(|body| body.name == name);
        self.loads.retain(|load| load.body.as_deref() == Some(name));
        // Loads omitted from a free body are part of its remainder. Joints stay, since they
        // determine the labels of forces.
        self.cones.retain(|cone| cone.body.as_deref() == Some(name));
        Snapshot { supports: Vec::new(), connectors: Vec::new(), omitted: Vec::new(), ..self }
    }
}
