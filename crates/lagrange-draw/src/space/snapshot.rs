//! A stored scene in space at one moment.

use super::vector::{Rotation, Vector, add, apply, apply_back, subtract};
use lagrange_runtime::body::SpatialMotion;
use lagrange_runtime::scene::{
    Connector, LoadOrigin, Solid, SolidPart, SpatialItem, SpatialJoint, SpatialScene,
};

/// A scene in space at one moment.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct SpatialSnapshot {
    pub(super) links: Vec<Link>,
    pub(super) connectors: Vec<Span>,
    pub(super) joints: Vec<Joint>,
    pub(super) loads: Vec<SpatialLoad>,
    /// Loads that act but are unknown.
    pub(super) omitted: Vec<String>,
}

/// A body or frame.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Link {
    pub(super) name: String,
    pub(super) origin: Vector,
    pub(super) rotation: Rotation,
    /// Motion, if it has mass.
    pub(super) motion: Option<SpatialMotion<f64>>,
    pub(super) parts: Vec<SolidPart<f64>>,
}

/// A spring or damper.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Span {
    pub(super) name: String,
    pub(super) kind: Connector,
    pub(super) ends: [Vector; 2],
}

#[derive(Clone, PartialEq, Debug)]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) kind: SpatialJoint,
    pub(super) at: Vector,
    pub(super) axis: Vector,
    pub(super) links: [Option<String>; 2],
}

/// A force or moment.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct SpatialLoad {
    pub(super) name: String,
    pub(super) cause: LoadOrigin,
    pub(super) body: Option<String>,
    pub(super) at: Vector,
    pub(super) value: Vector,
    pub(super) is_moment: bool,
}

impl SpatialSnapshot {
    pub(super) fn of<M: SpatialScene>(system: &M, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> Self
    where
        M::Scalar: Into<f64>,
    {
        let mut snapshot = SpatialSnapshot::default();
        system.items(t, q, v, &mut |item| snapshot.keep(item));
        snapshot
    }

    fn keep<S: Copy + Into<f64>>(&mut self, item: SpatialItem<'_, S>) {
        match item {
            SpatialItem::Body { name, motion, parts } => {
                let (motion, parts) = (numbers(&motion), parts.iter().map(part).collect());
                let origin = subtract(motion.center, apply(&motion.rotation, motion.centroid));
                let rotation = motion.rotation;
                self.links.push(Link {
                    name: name.to_owned(),
                    origin,
                    rotation,
                    motion: Some(motion),
                    parts,
                });
            }
            SpatialItem::Frame { name, rotation, origin } => {
                let (origin, rotation) = (vector(origin), rotation.map(vector));
                self.links.push(Link {
                    name: name.to_owned(),
                    origin,
                    rotation,
                    motion: None,
                    parts: Vec::new(),
                });
            }
            SpatialItem::Connector { name, kind, from, to, .. } => {
                self.connectors.push(Span { name: name.to_owned(), kind, ends: [from, to].map(vector) });
            }
            SpatialItem::Joint { name, kind, at, axis, bodies } => self.joints.push(Joint {
                name: name.to_owned(),
                kind,
                at: vector(at),
                axis: vector(axis),
                links: bodies.map(|body| body.map(ToOwned::to_owned)),
            }),
            SpatialItem::Force { name, cause, body, at, force } => {
                self.load(name, cause, body, [at, force], false);
            }
            SpatialItem::Moment { name, cause, body, at, moment } => {
                self.load(name, cause, body, [at, moment], true);
            }
            SpatialItem::Omitted { name } => self.omitted.push(name.to_owned()),
        }
    }

    fn load<S: Into<f64>>(
        &mut self,
        name: &str,
        cause: LoadOrigin,
        body: Option<&str>,
        values: [[S; 3]; 2],
        is_moment: bool,
    ) {
        let [at, value] = values.map(vector);
        let body = body.map(ToOwned::to_owned);
        self.loads.push(SpatialLoad { name: name.to_owned(), cause, body, at, value, is_moment });
    }

    /// The names of everything.
    pub(super) fn names(&self) -> impl Iterator<Item = &String> {
        let links = self.links.iter().map(|link| &link.name);
        let connectors = self.connectors.iter().map(|connector| &connector.name);
        let joints = self.joints.iter().map(|joint| &joint.name);
        links
            .chain(connectors)
            .chain(joints)
            .chain(self.loads.iter().map(|load| &load.name))
            .chain(&self.omitted)
    }

    /// The name of the first thing that is not the same in another scene but for where it is.
    pub(super) fn difference(&self, other: &SpatialSnapshot) -> Option<String> {
        let names = [self, other].map(|scene| scene.names().cloned().collect::<Vec<_>>());
        let [own, others] = &names;
        let renamed = own.iter().zip(others).find(|(a, b)| a != b).map(|(name, _)| name);
        let missing = own.get(others.len()).or_else(|| others.get(own.len()));
        let reshaped = self.links.iter().zip(&other.links).find(|(a, b)| a.parts != b.parts);
        let changed = self.joints.iter().zip(&other.joints).find(|(a, b)| a.kind != b.kind);
        let of_things = reshaped.map(|(a, _)| &a.name).or_else(|| changed.map(|(a, _)| &a.name));
        renamed.or(missing).or(of_things).cloned()
    }

    /// Without what has one of these names.
    pub(super) fn without(mut self, hidden: &[String]) -> Self {
        self.links.retain(|link| !hidden.contains(&link.name));
        self.connectors.retain(|connector| !hidden.contains(&connector.name));
        self.joints.retain(|joint| !hidden.contains(&joint.name));
        self.loads.retain(|load| !hidden.contains(&load.name));
        self.omitted.retain(|name| !hidden.contains(name));
        self
    }
}

impl Link {
    /// From its own axes to the world, and back.
    pub(super) fn place_of(&self, own: Vector) -> Vector {
        add(self.origin, apply(&self.rotation, own))
    }

    pub(super) fn own(&self, place: Vector) -> Vector {
        apply_back(&self.rotation, subtract(place, self.origin))
    }
}

fn vector<S: Into<f64>>(vector: [S; 3]) -> Vector {
    vector.map(Into::into)
}

fn numbers<S: Copy + Into<f64>>(motion: &SpatialMotion<S>) -> SpatialMotion<f64> {
    SpatialMotion {
        mass: motion.mass.into(),
        inertia: motion.inertia.map(vector),
        centroid: vector(motion.centroid),
        center: vector(motion.center),
        rotation: motion.rotation.map(vector),
        velocity: vector(motion.velocity),
        angular_velocity: vector(motion.angular_velocity),
        acceleration: vector(motion.acceleration),
        angular_acceleration: vector(motion.angular_acceleration),
    }
}

fn part<S: Copy + Into<f64>>(part: &SolidPart<S>) -> SolidPart<f64> {
    let SolidPart { at, rotation, is_hole, .. } = *part;
    let solid = match part.solid {
        Solid::PointMass => Solid::PointMass,
        Solid::SlenderRod(l) => Solid::SlenderRod(l.into()),
        Solid::Sphere(r) => Solid::Sphere(r.into()),
        Solid::Ellipsoid(a, b, c) => Solid::Ellipsoid(a.into(), b.into(), c.into()),
        Solid::Cuboid(a, b, c) => Solid::Cuboid(a.into(), b.into(), c.into()),
        Solid::Disk(r) => Solid::Disk(r.into()),
        Solid::Ring(r) => Solid::Ring(r.into()),
        Solid::Cylinder(r, h) => Solid::Cylinder(r.into(), h.into()),
        Solid::HollowCylinder(inner, outer, h) => Solid::HollowCylinder(inner.into(), outer.into(), h.into()),
        Solid::Cone(r, h) => Solid::Cone(r.into(), h.into()),
    };
    SolidPart { solid, at: vector(at), rotation: rotation.map(vector), is_hole }
}
