//! Scenes in space for pages that compute motions themselves: the meshes of a moment, and the
//! viewer of films.

use super::page;
use super::projector::Projector;
use super::recording::{Kind, MovingMesh, Recording};
use super::size::Size;
use super::stage;
use super::vector::Vector;
use crate::error::DrawError;
use crate::geometry::{dot, subtract};
use crate::look::{Direction, Look, Wanted};
use crate::snapshot::Snapshot;
use lagrange_runtime::scene::{Item, Spatial};

/// A scene in space whose meshes are moved by a page.
#[derive(Clone, PartialEq, Debug)]
pub struct LiveScene {
    /// Elements that the viewer fills, with the picture that is seen without it.
    pub elements: String,
    /// The object of JSON that the viewer reads. Its things are in the order of `meshes`.
    pub space: String,
    /// The item to which each mesh belongs.
    pub meshes: Vec<LiveMesh>,
    /// The middle of all that is seen.
    pub middle: [f64; 3],
    /// The distance to which all reaches from there, which is the unit of length of the viewer.
    pub radius: f64,
}

/// The item to which a mesh belongs, by its place among those of its kind.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LiveMesh {
    /// A body or frame, by its place among both.
    Body(usize),
    /// A connector, and how far it is drawn beside the line between its ends, along its first axis.
    Connector(usize, f64),
    /// A joint.
    Joint(usize),
    /// The rod of a joint, which leads to the origin of this body.
    Rod(usize, Option<usize>),
}

impl LiveScene {
    /// Rules of CSS for the elements.
    pub const STYLE: &'static str = page::STYLE;
    /// The script of the viewer: `viewer()` returns a function that shows the `poses` of
    /// `film.space`.
    pub const VIEWER: &'static str = page::VIEWER;
    /// The help on its keys.
    pub const KEYS: &'static str = page::KEYS;

    /// Records the scene that `visit` hands out.
    ///
    /// # Errors
    /// If a number is not finite, or there is nothing to draw.
    pub fn new(visit: impl FnOnce(&mut dyn FnMut(Item<'_, f64, Spatial>))) -> Result<LiveScene, DrawError> {
        let snapshot = [Snapshot::collected(visit)];
        let wanted = Wanted { names: true, ..Wanted::default() };
        let things = stage::things(&snapshot, wanted, &Size::of(&snapshot));
        let meshes = meshes(&snapshot[0], &things);
        let recording = Recording { times: vec![0.0], things, traces: Vec::new(), note: String::new() };
        let (middle, radius) = recording.ball();
        let look = Look { size: [640.0, 480.0], title: String::new(), direction: Direction::default() };
        let projector = Projector::new(recording.checked()?, look)?;
        let (elements, space) = page::parts(&projector);
        Ok(LiveScene { elements, space, meshes, middle, radius })
    }
}

fn meshes(scene: &Snapshot<Spatial>, things: &[MovingMesh]) -> Vec<LiveMesh> {
    let of = |(number, thing): (usize, &MovingMesh)| {
        let is_second =
            number > 0 && things[number - 1].kind == Kind::Joint && things[number - 1].name == thing.name;
        let place = |mut names: Box<dyn Iterator<Item = &str> + '_>| {
            names.position(|name| name == thing.name).unwrap_or_default()
        };
        match thing.kind {
            Kind::Connector => {
                let index = place(Box::new(scene.connectors.iter().map(|connector| &*connector.name)));
                LiveMesh::Connector(index, offset(thing, scene.connectors[index].ends[0]))
            }
            Kind::Joint => {
                let index = place(Box::new(scene.joints.iter().map(|joint| &*joint.name)));
                let outer = &scene.joints[index].kind.links[1];
                let body = scene.bodies.iter().position(|link| outer.as_ref() == Some(&link.name));
                if is_second { LiveMesh::Rod(index, body) } else { LiveMesh::Joint(index) }
            }
            _ => LiveMesh::Body(place(Box::new(scene.bodies.iter().map(|link| &*link.name)))),
        }
    };
    things.iter().enumerate().map(of).collect()
}

/// The distance of a connector from the line between its ends.
fn offset(thing: &MovingMesh, end: Vector) -> f64 {
    let placement = &thing.track[0];
    dot(placement.rotation.map(|row| row[0]), subtract(placement.origin, end))
}
