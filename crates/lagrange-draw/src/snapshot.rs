//! A stored scene at one moment.

use crate::geometry::Place;
use crate::load::{Load, Value};
use crate::outline::Piece;
use crate::picture::Point;
use crate::remainder::Remainder;
use lagrange_runtime::body::Motion;
use lagrange_runtime::scene::{Connector, Item, Joint, LoadOrigin, Scene};

/// A scene at one moment.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Snapshot {
    pub(super) bodies: Vec<Body>,
    pub(super) lines: Vec<Line>,
    pub(super) connectors: Vec<(String, Connector, [Point; 2])>,
    pub(super) joints: Vec<(String, Joint, Point)>,
    pub(super) loads: Vec<Load>,
    /// Loads that act but are unknown.
    pub(super) omitted: Vec<String>,
    /// Resultant of unnamed loads on a free body.
    pub(super) remainder: Option<Remainder>,
}

#[derive(Clone, PartialEq, Debug)]
pub(super) struct Body {
    pub(super) name: String,
    /// Index of the body in the scene, regardless of hidden bodies.
    pub(super) index: usize,
    pub(super) motion: Motion<f64>,
    pub(super) pieces: Vec<Piece>,
}

#[derive(Clone, PartialEq, Debug)]
pub(super) struct Line {
    pub(super) name: String,
    pub(super) body: Option<String>,
    pub(super) place: Place,
}

impl Snapshot {
    pub(super) fn of<M: Scene>(system: &M, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> Self
    where
        M::Scalar: Into<f64>,
    {
        let mut snapshot = Snapshot::default();
        system.items(t, q, v, &mut |item| snapshot.keep(item));
        snapshot
    }

    fn keep<S: Copy + Into<f64>>(&mut self, item: Item<'_, S>) {
        match item {
            Item::Body { name, motion, parts } => self.bodies.push(Body {
                name: name.to_owned(),
                index: self.bodies.len(),
                motion: numbers(&motion),
                pieces: parts.iter().map(Piece::of).collect(),
            }),
            Item::Line { name, body, through, angle } => self.lines.push(Line {
                name: name.to_owned(),
                body: body.map(ToOwned::to_owned),
                place: Place { at: point(through), angle: angle.into() },
            }),
            Item::Connector { name, kind, from, to, .. } => {
                self.connectors.push((name.to_owned(), kind, [point(from), point(to)]));
            }
            Item::Joint { name, kind, at } => self.joints.push((name.to_owned(), kind, point(at))),
            Item::Omitted { name } => self.omitted.push(name.to_owned()),
            Item::Force { name, cause, body, at, force } => {
                self.load(name, cause, body, point(at), Value::Force(point(force)));
            }
            Item::Moment { name, cause, body, at, moment } => {
                self.load(name, cause, body, point(at), Value::Moment(moment.into()));
            }
        }
    }

    fn load(&mut self, name: &str, cause: LoadOrigin, body: Option<&str>, at: Point, value: Value) {
        let body = body.map(ToOwned::to_owned);
        self.loads.push(Load { name: name.to_owned(), cause, body, at, value });
    }

    pub(super) fn body(&self, name: &str) -> Option<&Body> {
        self.bodies.iter().find(|body| body.name == name)
    }

    /// The names of everything.
    pub(super) fn names(&self) -> impl Iterator<Item = &String> {
        let bodies =
            self.bodies.iter().map(|body| &body.name).chain(self.lines.iter().map(|line| &line.name));
        let connectors = self.connectors.iter().map(|(name, ..)| name);
        let joints = self.joints.iter().map(|(name, ..)| name);
        let loads = self.loads.iter().map(|load| &load.name);
        bodies.chain(connectors).chain(joints).chain(loads).chain(&self.omitted)
    }

    /// Without what has one of these names.
    pub(super) fn without(mut self, hidden: &[String]) -> Self {
        self.bodies.retain(|body| !hidden.contains(&body.name));
        self.lines.retain(|line| !hidden.contains(&line.name));
        self.connectors.retain(|(name, ..)| !hidden.contains(name));
        self.joints.retain(|(name, ..)| !hidden.contains(name));
        self.loads.retain(|load| !hidden.contains(&load.name));
        self.omitted.retain(|name| !hidden.contains(name));
        self
    }

    /// Returns the resultant of unnamed loads on a body, in numbers with the relative spacing
    /// `epsilon`.
    pub(super) fn remainder_of(&self, name: &str, epsilon: f64) -> Option<Remainder> {
        let loads = self.loads.iter().filter(|load| load.body.as_deref() == Some(name));
        self.body(name).map(|body| Remainder::of(&body.motion, loads, epsilon))
    }

    /// Only one body and what acts on it.
    pub(super) fn free_body(mut self, name: &str) -> Self {
        self.bodies.retain(|body| body.name == name);
        self.loads.retain(|load| load.body.as_deref() == Some(name));
        // What is not known of a free body is its remainder. Joints stay, for they tell what a force is.
        Snapshot { lines: Vec::new(), connectors: Vec::new(), omitted: Vec::new(), ..self }
    }
}

impl Body {
    /// From its own coordinates to the world.
    pub(super) fn place(&self) -> Place {
        let Motion { center, centroid, angle, .. } = self.motion;
        let turned = Place { at: [0.0, 0.0], angle }.of(centroid);
        Place { at: [center[0] - turned[0], center[1] - turned[1]], angle }
    }
}

fn point<S: Into<f64>>(point: [S; 2]) -> Point {
    point.map(Into::into)
}

fn numbers<S: Copy + Into<f64>>(motion: &Motion<S>) -> Motion<f64> {
    Motion {
        mass: motion.mass.into(),
        inertia: motion.inertia.into(),
        centroid: point(motion.centroid),
        center: point(motion.center),
        angle: motion.angle.into(),
        velocity: point(motion.velocity),
        angular_velocity: motion.angular_velocity.into(),
        acceleration: point(motion.acceleration),
        angular_acceleration: motion.angular_acceleration.into(),
    }
}
