//! A moment of a motion, as passed to user additions to pictures.

use crate::load::Value;
use crate::remainder::REMAINDER;
use crate::snapshot::{Snapshot, Stored};
use lagrange_runtime::body::Motion;
use lagrange_runtime::scene::{Plane, Scene};
use lagrange_runtime::system::split;

/// A system at one moment of its motion.
#[derive(Debug)]
pub struct Moment<'m, M: Scene<Space: Stored>> {
    /// The system.
    pub system: &'m M,
    /// The time.
    pub t: M::Scalar,
    /// The state.
    pub y: M::State,
    /// The coordinates.
    pub q: M::Coordinates,
    /// The velocities.
    pub v: M::Velocities,
    snapshot: &'m Snapshot<M::Space>,
}

impl<'m, M: Scene<Space = Plane>> Moment<'m, M> {
    pub(super) fn new(system: &'m M, t: M::Scalar, y: M::State, snapshot: &'m Snapshot) -> Self {
        let (q, v) = split::<M>(&y);
        Moment { system, t, y, q, v, snapshot }
    }

    /// Returns the motion of a body.
    pub fn motion(&self, body: &str) -> Option<Motion<f64>> {
        self.snapshot.body(body).map(|body| body.motion)
    }

    /// Returns the point of application and the components of the first force of this name. On a
    /// free body, R is the resultant of unnamed forces.
    pub fn force(&self, name: &str) -> Option<([f64; 2], [f64; 2])> {
        let named = self.snapshot.loads.iter().find_map(|load| match load.value {
            Value::Force(force) if load.name == name => Some((load.at, force)),
            _ => None,
        });
        let rest = self.snapshot.remainder.filter(|_| name == REMAINDER);
        named.or_else(|| rest.map(|rest| (rest.at, rest.force)))
    }
}
