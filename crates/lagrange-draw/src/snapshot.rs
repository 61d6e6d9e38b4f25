//! A stored scene at one moment.

use std::fmt::Debug;

use crate::geometry::Place;
use crate::load::{Load, Value};
use crate::remainder::Remainder;
use lagrange_runtime::scalar::Scalar;
use lagrange_runtime::scene::{
    Connector, Item, LoadOrigin, Part, Plane, Scene, Space, Surface, SurfaceShape,
};

/// A space whose scenes are stored as double-precision numbers.
pub trait Stored: Space {
    /// A body or frame.
    type Body: Named + Clone + PartialEq + Debug;
    /// A joint, apart from its name and place.
    type Joint: Clone + PartialEq + Debug;

    /// Stores a body with its index in the scene.
    fn body<S: Scalar + Into<f64>>(
        name: &str,
        index: usize,
        motion: &Self::Motion<S>,
        parts: &[Part<'_, S, Self>],
    ) -> Self::Body;
    /// Stores a frame.
    fn frame<S: Scalar + Into<f64>>(frame: &Self::Frame<'_, S>) -> Self::Body;
    /// Stores a rotation.
    fn rotation<S: Scalar + Into<f64>>(rotation: Self::Rotation<S>) -> Self::Rotation<f64>;
    /// Stores a joint.
    fn joint<S: Scalar + Into<f64>>(joint: &<Self as Space>::Joint<'_, S>) -> <Self as Stored>::Joint;
    /// Stores a vector.
    fn vector<S: Scalar + Into<f64>>(vector: Self::Vector<S>) -> Self::Vector<f64>;
    /// Stores a moment.
    fn moment<S: Scalar + Into<f64>>(moment: Self::Moment<S>) -> Self::Moment<f64>;
}

/// An item with a name.
pub trait Named {
    /// Returns the name of the item.
    fn name(&self) -> &str;
}

/// A scene at one moment.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Snapshot<D: Stored = Plane> {
    /// Bodies and, in space, frames.
    pub(super) bodies: Vec<D::Body>,
    pub(super) supports: Vec<Support<D>>,
    pub(super) connectors: Vec<Span<D>>,
    pub(super) joints: Vec<Joint<D>>,
    pub(super) cones: Vec<Cone<D>>,
    pub(super) loads: Vec<Load<D>>,
    /// Loads that act but are not drawn.
    pub(super) omitted: Vec<String>,
    /// Resultant of unnamed loads on a free body.
    pub(super) remainder: Option<Remainder>,
    /// Labels of loads, by names, in place of the usual ones.
    pub(super) letters: Vec<(String, String)>,
}

/// A surface that bodies touch.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Support<D: Space = Plane> {
    pub(super) name: String,
    pub(super) body: Option<String>,
    pub(super) form: Form,
    pub(super) at: D::Vector<f64>,
    pub(super) rotation: D::Rotation<f64>,
    pub(super) is_inside: bool,
}

/// The shape of a surface in its own axes.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Form {
    Flat,
    Round(f64),
    Cylinder(f64),
    /// Terrain, with its height over places; none before it is sampled.
    Terrain(Vec<([f64; 2], f64)>),
}

/// The friction cone of a contact: its apex, the force along its axis, and the coefficient of
/// friction.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Cone<D: Space = Plane> {
    pub(super) name: String,
    pub(super) body: Option<String>,
    pub(super) at: D::Vector<f64>,
    pub(super) normal: D::Vector<f64>,
    pub(super) coefficient: f64,
}

/// A spring or damper.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Span<D: Space = Plane> {
    pub(super) name: String,
    pub(super) kind: Connector,
    pub(super) ends: [D::Vector<f64>; 2],
}

#[derive(Clone, PartialEq, Debug)]
pub(super) struct Joint<D: Stored = Plane> {
    pub(super) name: String,
    pub(super) kind: <D as Stored>::Joint,
    pub(super) at: D::Vector<f64>,
}

impl<D: Stored> Snapshot<D> {
    pub(super) fn of<M: Scene<Space = D>>(
        system: &M,
        t: M::Scalar,
        q: &M::Coordinates,
        v: &M::Velocities,
    ) -> Self
    where
        M::Scalar: Into<f64>,
    {
        Snapshot::collected(|keep| system.items(t, q, v, keep))
    }

    /// Collects the visited items.
    pub(super) fn collected<S: Scalar + Into<f64>>(
        visit: impl FnOnce(&mut dyn FnMut(Item<'_, S, D>)),
    ) -> Self {
        let mut snapshot = Snapshot::default();
        visit(&mut |item| snapshot.keep(item));
        snapshot
    }

    fn keep<S: Scalar + Into<f64>>(&mut self, item: Item<'_, S, D>) {
        match item {
            Item::Body { name, motion, parts } => {
                self.bodies.push(D::body(name, self.bodies.len(), &motion, parts));
            }
            Item::Frame(frame) => self.bodies.push(D::frame(&frame)),
            Item::Surface(surface) => self.supports.push(support(&surface)),
            Item::Cone { name, body, at, normal, coefficient } => self.cones.push(Cone {
                name: name.to_owned(),
                body: body.map(ToOwned::to_owned),
                at: D::vector(at),
                normal: D::vector(normal),
                coefficient: coefficient.into(),
            }),
            Item::Connector { name, kind, from, to, .. } => {
                self.connectors.push(Span { name: name.to_owned(), kind, ends: [from, to].map(D::vector) });
            }
            Item::Joint { name, kind, at } => {
                let (kind, at) = (D::joint(&kind), D::vector(at));
                self.joints.push(Joint { name: name.to_owned(), kind, at });
            }
            Item::Omitted { name } => self.omitted.push(name.to_owned()),
            Item::Force { name, cause, body, at, force } => {
                self.load(name, cause, body, D::vector(at), Value::Force(D::vector(force)));
            }
            Item::Moment { name, cause, body, at, moment } => {
                self.load(name, cause, body, D::vector(at), Value::Moment(D::moment(moment)));
            }
        }
    }

    fn load(
        &mut self,
        name: &str,
        cause: LoadOrigin,
        body: Option<&str>,
        at: D::Vector<f64>,
        value: Value<D>,
    ) {
        let body = body.map(ToOwned::to_owned);
        self.loads.push(Load { name: name.to_owned(), cause, body, at, value });
    }

    pub(super) fn body(&self, name: &str) -> Option<&D::Body> {
        self.bodies.iter().find(|body| body.name() == name)
    }

    /// Returns the ends of a connector.
    pub(super) fn ends(&self, name: &str) -> Option<[D::Vector<f64>; 2]> {
        self.connectors.iter().find(|connector| connector.name == name).map(|connector| connector.ends)
    }

    /// Returns the label that replaces the usual one of a load.
    pub(super) fn letter(&self, name: &str) -> Option<&str> {
        self.letters.iter().rev().find(|(known, _)| known == name).map(|(_, letter)| &**letter)
    }

    /// Returns the names of all items, including omitted ones.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.drawn_names().chain(self.omitted.iter().map(|name| &**name))
    }

    /// Returns the names of all items that can be drawn.
    pub(super) fn drawn_names(&self) -> impl Iterator<Item = &str> {
        let bodies = self.bodies.iter().map(Named::name).chain(self.supports.iter().map(|one| &*one.name));
        let connectors = self.connectors.iter().map(|connector| &*connector.name);
        let joints = self.joints.iter().map(|joint| &*joint.name);
        let cones = self.cones.iter().map(|cone| &*cone.name);
        let loads = self.loads.iter().map(|load| &*load.name).chain(cones);
        bodies.chain(connectors).chain(joints).chain(loads)
    }

    /// Removes the items with these names.
    pub(super) fn without(mut self, hidden: &[String]) -> Self {
        let is_shown = |name: &str| hidden.iter().all(|other| other != name);
        self.bodies.retain(|body| is_shown(body.name()));
        self.supports.retain(|support| is_shown(&support.name));
        self.connectors.retain(|connector| is_shown(&connector.name));
        self.joints.retain(|joint| is_shown(&joint.name));
        self.cones.retain(|cone| is_shown(&cone.name));
        self.loads.retain(|load| is_shown(&load.name));
        self.omitted.retain(|name| is_shown(name));
        self
    }
}

fn support<S: Scalar + Into<f64>, D: Stored>(surface: &Surface<'_, S, D>) -> Support<D> {
    let form = match surface.shape {
        SurfaceShape::Flat => Form::Flat,
        SurfaceShape::Round(radius) => Form::Round(radius.into()),
        SurfaceShape::Cylinder(radius) => Form::Cylinder(radius.into()),
        SurfaceShape::Terrain(_) => Form::Terrain(Vec::new()),
    };
    Support {
        name: surface.name.to_owned(),
        body: surface.body.map(ToOwned::to_owned),
        form,
        at: D::vector(surface.at),
        rotation: D::rotation(surface.rotation),
        is_inside: surface.is_inside,
    }
}

/// Samples the height of a terrain among the visited items over places.
pub(super) fn sampled<S: Scalar + Into<f64>, D: Space>(
    visit: impl FnOnce(&mut dyn FnMut(Item<'_, S, D>)),
    terrain: &str,
    places: Vec<[f64; 2]>,
) -> Form {
    let mut heights = Vec::new();
    visit(&mut |item| match item {
        Item::Surface(Surface { name, shape: SurfaceShape::Terrain(height), .. }) if name == terrain => {
            heights.extend(places.iter().map(|place| height.over(place.map(S::from_f64)).into()));
        }
        _ => {}
    });
    Form::Terrain(places.into_iter().zip(heights).collect())
}

impl Support {
    /// Returns the map from its own coordinates to the world.
    pub(super) fn place(&self) -> Place {
        Place { at: self.at, angle: self.rotation }
    }
}

impl<D: Stored> Default for Snapshot<D> {
    fn default() -> Self {
        Snapshot {
            bodies: Vec::new(),
            supports: Vec::new(),
            connectors: Vec::new(),
            joints: Vec::new(),
            cones: Vec::new(),
            loads: Vec::new(),
            omitted: Vec::new(),
            remainder: None,
            letters: Vec::new(),
        }
    }
}
