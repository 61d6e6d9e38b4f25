//! Scenes in space for pages that compute motions themselves: the meshes at one moment, and the
//! viewer of films.

use super::arrows::LONGEST;
use super::mesh::Placement;
use super::page;
use super::projector::Projector;
use super::recording::{Kind, MovingMesh, Recording};
use super::size::Size;
use super::solids::SHORTEST_ARROW;
use super::stage;
use super::surroundings::{Surroundings, sample_terrain};
use super::vector::{NONE, UPRIGHT, Vector, apply_back};
use crate::error::DrawError;
use crate::geometry::{dot, subtract};
use crate::load_label::omitted_loads;
use crate::look::{Direction, Look, Wanted};
use crate::snapshot::Snapshot;
use lagrange_runtime::scene::{Item, Spatial};

/// A scene in space whose meshes are moved by a page's script.
#[derive(Clone, PartialEq, Debug)]
pub struct LiveScene {
    /// Elements filled by the viewer, with the picture that is displayed without it.
    pub elements: String,
    /// JSON object for the viewer. Its things are in the order of `meshes`.
    pub space: String,
    /// The item to which each mesh belongs.
    pub meshes: Vec<LiveMesh>,
    /// Middle of the visible scene.
    pub middle: [f64; 3],
    /// Radius of the visible scene about its middle, the viewer's unit of length.
    pub radius: f64,
    /// Length of the longest arrow.
    pub longest_arrow: f64,
    /// Length below which an arrow is scaled down as a whole.
    pub shortest_arrow: f64,
}

/// The item to which a mesh belongs, by its index among items of its kind.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LiveMesh {
    /// A body or frame, by its index among both.
    Body(usize),
    /// A surface, and the place of its mesh in its own axes.
    Surface(usize, [f64; 3]),
    /// A connector, and its offset along its first axis from the line between its ends.
    Connector(usize, f64),
    /// A joint.
    Joint(usize),
    /// The rod of a joint, which leads to the origin of this body.
    Rod(usize, Option<usize>),
    /// A force or moment, by its index among both. It is hidden.
    Load(usize),
}

impl LiveScene {
    /// CSS rules for the elements.
    pub const STYLE: &'static str = page::STYLE;
    /// The script of the viewer: `viewer()` returns a function that displays the `poses` of
    /// `film.space`.
    pub const VIEWER: &'static str = page::VIEWER;
    /// Help text for the viewer's keys, after the word "Drag".
    pub const KEYS: &'static str = page::KEYS;

    /// Records the scene visited by `visit`.
    ///
    /// # Errors
    /// If a number is not finite, or there is nothing to draw.
    pub fn new(visit: impl Fn(&mut dyn FnMut(Item<'_, f64, Spatial>))) -> Result<LiveScene, DrawError> {
        let mut snapshot = [Snapshot::collected(&visit)];
        snapshot[0].cones.clear();
        let wanted = Wanted { names: true, forces: true, ..Wanted::default() };
        let size = Size::of(&snapshot);
        sample_terrain(&mut snapshot, &size, true, |_, keep| visit(keep));
        let surroundings = Surroundings { film: &snapshot, size: &size, is_live: true };
        let mut things = stage::things(&surroundings, wanted);
        for thing in things.iter_mut().filter(|thing| thing.kind == Kind::Arrow) {
            thing.track = vec![Placement { scale: 0.0, ..Placement::rigid(NONE, UPRIGHT) }];
        }
        let meshes = meshes(&snapshot[0], &things);
        let note = omitted_loads(&snapshot);
        let recording = Recording { times: vec![0.0], things, traces: Vec::new(), note };
        let (middle, radius) = recording.ball();
        let look = Look { size: [640.0, 480.0], title: String::new(), direction: Direction::default() };
        let projector = Projector::new(recording.checked()?, look)?;
        let (elements, space) = page::parts(&projector);
        let (longest_arrow, shortest_arrow) = (LONGEST * size.diagonal(), SHORTEST_ARROW * size.thin());
        Ok(LiveScene { elements, space, meshes, middle, radius, longest_arrow, shortest_arrow })
    }
}

fn meshes(scene: &Snapshot<Spatial>, things: &[MovingMesh]) -> Vec<LiveMesh> {
    // Arrows of moments follow those of forces.
    let loads = (0..scene.loads.len()).filter(|&load| !scene.loads[load].is_moment());
    let mut loads = loads.chain((0..scene.loads.len()).filter(|&load| scene.loads[load].is_moment()));
    let mut of = |(number, thing): (usize, &MovingMesh)| {
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
            Kind::Arrow => LiveMesh::Load(loads.next().unwrap_or_default()),
            Kind::Surroundings => {
                let index = place(Box::new(scene.supports.iter().map(|support| &*support.name)));
                let (support, Placement { origin, .. }) = (&scene.supports[index], thing.track[0]);
                LiveMesh::Surface(index, apply_back(&support.rotation, subtract(origin, support.at)))
            }
            _ => LiveMesh::Body(place(Box::new(scene.bodies.iter().map(|link| &*link.name)))),
        }
    };
    things.iter().enumerate().map(&mut of).collect()
}

/// Returns the distance of a connector from the line between its ends.
fn offset(thing: &MovingMesh, end: Vector) -> f64 {
    let placement = &thing.track[0];
    dot(placement.rotation.map(|row| row[0]), subtract(placement.origin, end))
}
