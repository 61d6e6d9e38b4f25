//! The picture of a page, and the script that animates it.

use std::collections::HashMap;

use lagrange_core::bodies::DrawnKind;
use lagrange_core::pipeline::{DrawnScene, NumericSystem, PlacedItem, PlacedPart};
use lagrange_core::syntax::ast::SurfaceKind;
use lagrange_draw::{
    DrawError, LiveLoads, LiveMesh, LiveScene, body_colour, is_made_up, live_terrain, named_colours,
};
use lagrange_dynamic::{connector, visit_items};
use lagrange_plot::characters::escaped;
use lagrange_plot::label::Label;
use lagrange_plot::notation::formula;
use lagrange_runtime::scene::Item;
use serde_json::{Value, json};

const PLANE: &str = concat!(include_str!("reach.js"), include_str!("plane.js"));
const SPACE: &str = concat!(include_str!("reach.js"), include_str!("pick.js"), include_str!("space.js"));
/// Help text for the pointer.
const DRAG: &str = " Drag a body to start from another place.";

/// A picture that a page animates; empty by default.
#[derive(Default)]
pub(crate) struct Shown {
    /// Elements of the picture.
    pub(crate) elements: String,
    /// Data for the script.
    pub(crate) scene: Value,
    /// The script.
    pub(crate) viewer: String,
    /// CSS rules.
    pub(crate) style: &'static str,
    /// Help text for keys.
    pub(crate) keys: String,
}

/// Returns the picture of a system, if it has a drawing.
pub(crate) fn shown(system: &NumericSystem, start: &[f64]) -> Result<Shown, DrawError> {
    match &system.programs().drawing {
        None => Ok(Shown::default()),
        Some(drawing) if drawing.is_in_space => in_space(system, drawing, start),
        Some(drawing) => Ok(in_plane(system, drawing, start)),
    }
}

/// Splits a state into positions and velocities.
fn split<'s>(system: &NumericSystem, start: &'s [f64]) -> (&'s [f64], &'s [f64]) {
    start.split_at(system.programs().layout.positions.min(start.len()))
}

/// True if forces or moments can be drawn.
fn has_loads(drawing: &DrawnScene) -> bool {
    drawing.items.iter().any(|item| matches!(item.kind, DrawnKind::Force { .. } | DrawnKind::Moment { .. }))
}

fn figure(elements: &str) -> String {
    format!("<figure id=\"picture\">{elements}</figure>")
}

fn in_plane(system: &NumericSystem, drawing: &DrawnScene, start: &[f64]) -> Shown {
    let (q, v) = split(system, start);
    let visit_start = |visit: &mut dyn FnMut(Item<'_, f64>)| visit_items(system, drawing, (0.0, q, v), visit);
    let LiveLoads { labels, note } = LiveLoads::new(visit_start);
    let mut terrain = live_terrain(visit_start).into_iter();
    let (mut labels, mut centers, mut at) = (labels.into_iter(), HashMap::new(), 0);
    let items = drawing.items.iter().map(|item| {
        let first = at;
        at += count(item, 2);
        plane_item(item, first, &mut centers, (&mut labels, &mut terrain))
    });
    let items = items.collect::<Vec<_>>();
    let colours = HashMap::from(named_colours());
    let canvas = "<canvas id=\"canvas\" role=\"img\" aria-label=\"Drawing of the motion\"></canvas>";
    let note = if note.is_empty() { note } else { format!("<p class=\"note\">{}</p>", escaped(&note)) };
    Shown {
        elements: figure(&[canvas, &note].concat()),
        scene: json!({ "items": items, "hasLoads": has_loads(drawing), "colours": colours }),
        viewer: PLANE.to_owned(),
        keys: DRAG.to_owned(),
        ..Shown::default()
    }
}

/// Returns the data of an item whose numbers start at `first`. `centers` are the places of the
/// centres of bodies before it; `labels` and `terrain` belong to the loads and the terrain from it.
fn plane_item<'d>(
    item: &'d PlacedItem,
    first: usize,
    centers: &mut HashMap<&'d str, usize>,
    (labels, terrain): (
        &mut impl Iterator<Item = [String; 2]>,
        &mut impl Iterator<Item = Vec<Vec<[f64; 2]>>>,
    ),
) -> Value {
    match &item.kind {
        DrawnKind::Body { .. } => {
            let colour = body_colour(centers.len());
            // The centre follows the centroid.
            centers.insert(&item.body, first + 2);
            let parts = item.parts.iter().map(part).collect::<Vec<_>>();
            json!({ "kind": "body", "label": plain(&item.body), "colour": colour, "parts": parts })
        }
        DrawnKind::Surface { kind: SurfaceKind::Line, .. } => json!({ "kind": "line" }),
        DrawnKind::Surface { kind: SurfaceKind::Circle, is_inside, .. } => {
            json!({ "kind": "circle", "inside": is_inside })
        }
        DrawnKind::Surface { .. } => json!({ "kind": "terrain", "pieces": terrain.next() }),
        DrawnKind::Connector { name, kind } => {
            let label = if is_made_up(name, connector(*kind)) { String::new() } else { plain(name) };
            json!({ "kind": "connector", "label": label, "variant": format!("{kind:?}") })
        }
        DrawnKind::Joint { kind, .. } => json!({ "kind": "joint", "variant": format!("{kind:?}") }),
        DrawnKind::Force { .. } => json!({ "kind": "force", "label": labels.next() }),
        DrawnKind::Moment { body, .. } => {
            let center = body.as_deref().and_then(|body| centers.get(body));
            json!({ "kind": "moment", "label": labels.next(), "center": center })
        }
        DrawnKind::Cone { .. } => json!({ "kind": "cone" }),
        // Loads that are not drawn have no numbers.
        _ => json!({ "kind": "omitted" }),
    }
}

fn part(part: &PlacedPart) -> Value {
    json!({ "variant": part.variant, "count": part.dimension_count, "hole": part.is_hole })
}

fn plain(name: &str) -> String {
    Label::parse(&formula(name)).plain()
}

fn in_space(system: &NumericSystem, drawing: &DrawnScene, start: &[f64]) -> Result<Shown, DrawError> {
    let (q, v) = split(system, start);
    let live = LiveScene::new(|visit| visit_items(system, drawing, (0.0, q, v), visit))?;
    let places = Places::of(drawing);
    let things = live.meshes.iter().map(|mesh| places.thing(*mesh)).collect::<Vec<_>>();
    let space = serde_json::from_str::<Value>(&live.space).unwrap_or_default();
    Ok(Shown {
        scene: json!({
            "space": space, "things": things, "middle": live.middle, "radius": live.radius,
            "hasLoads": has_loads(drawing), "longest": live.longest_arrow, "shortest": live.shortest_arrow,
        }),
        elements: figure(&live.elements),
        viewer: [LiveScene::VIEWER, SPACE].concat(),
        style: LiveScene::STYLE,
        keys: [DRAG, " Drag elsewhere ", LiveScene::KEYS].concat(),
    })
}

/// Returns the number of numbers of an item, where vectors have `dimension` components.
fn count(item: &PlacedItem, dimension: usize) -> usize {
    let (turn, moment) = if dimension == 2 { (1, 1) } else { (9, 3) };
    match item.kind {
        DrawnKind::Body { .. } => {
            let parts = item.parts.iter().map(|part| part.dimension_count + dimension + turn);
            2 * dimension + turn + parts.sum::<usize>()
        }
        DrawnKind::Surface { kind, .. } => dimension + turn + usize::from(kind.labels().contains(&"radius")),
        DrawnKind::Frame { .. } => dimension + turn,
        DrawnKind::Connector { .. } | DrawnKind::Cone { .. } => 2 * dimension + 1,
        DrawnKind::Joint { .. } => dimension,
        DrawnKind::SpatialJoint { .. } | DrawnKind::Force { .. } => 2 * dimension,
        DrawnKind::Moment { .. } => dimension + moment,
        DrawnKind::Omitted { .. } | DrawnKind::Torque { .. } => 0,
    }
}

/// Indices of the first numbers of items, by kind.
#[derive(Default)]
struct Places {
    /// Bodies and frames, and true for a frame.
    bodies: Vec<(usize, bool)>,
    surfaces: Vec<usize>,
    connectors: Vec<usize>,
    joints: Vec<usize>,
    /// Forces and moments, and true for a moment.
    loads: Vec<(usize, bool)>,
}

impl Places {
    fn of(drawing: &DrawnScene) -> Places {
        let mut places = Places::default();
        let mut at = 0;
        for item in &drawing.items {
            match item.kind {
                DrawnKind::Body { .. } => places.bodies.push((at, false)),
                DrawnKind::Frame { .. } => places.bodies.push((at, true)),
                DrawnKind::Surface { .. } => places.surfaces.push(at),
                DrawnKind::Connector { .. } => places.connectors.push(at),
                DrawnKind::Force { .. } => places.loads.push((at, false)),
                DrawnKind::Moment { .. } => places.loads.push((at, true)),
                DrawnKind::Cone { .. } | DrawnKind::Omitted { .. } | DrawnKind::Torque { .. } => {}
                _ => places.joints.push(at),
            }
            at += count(item, 3);
        }
        places
    }

    fn thing(&self, mesh: LiveMesh) -> Value {
        match mesh {
            LiveMesh::Body(index) => self.body(index),
            LiveMesh::Surface(index, place) => {
                json!({ "kind": "surface", "at": self.surfaces[index], "place": place })
            }
            LiveMesh::Connector(index, lane) => {
                json!({ "kind": "connector", "at": self.connectors[index], "lane": lane })
            }
            LiveMesh::Joint(index) => json!({ "kind": "joint", "at": self.joints[index] }),
            LiveMesh::Rod(index, outer) => {
                let outer = outer.map(|body| self.body(body));
                json!({ "kind": "rod", "at": self.joints[index], "outer": outer })
            }
            LiveMesh::Load(index) => {
                let (at, is_moment) = self.loads[index];
                json!({ "kind": "load", "at": at, "isMoment": is_moment })
            }
        }
    }

    fn body(&self, index: usize) -> Value {
        let (at, is_frame) = self.bodies[index];
        json!({ "kind": if is_frame { "frame" } else { "body" }, "at": at })
    }
}

#[cfg(test)]
mod tests {
    use super::{json, shown};
    use lagrange_core::derive::StrategyChoice;
    use lagrange_core::pipeline::{NumericSystem, Programs, parse};
    use std::sync::Arc;

    #[test]
    fn terrain_beyond_its_domain_is_left_out() {
        let text = "struct Bowl; coord x, y; gravity = (0, -9.81);
            terrain bowl { height(s): 1 - sqrt(1 - s^2); }
            body ball { mass: 1; shape: disk(0.1); center: (x, y); }
            contact touch = ball on bowl { stiffness: 1000; }
            emit { drawing }";
        let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
        let system = NumericSystem::of(Arc::new(programs));
        let terrain = |x: f64| {
            let scene = shown(&system, &[x, 0.5, 0.0, 0.0]).expect("is drawn").scene;
            let items = scene["items"].as_array().cloned().unwrap_or_default();
            items.into_iter().find(|item| item["kind"] == "terrain").expect("a terrain")
        };
        let near = terrain(0.3);
        let [piece] = &near["pieces"].as_array().expect("pieces")[..] else { panic!("one piece: {near}") };
        let points = piece.as_array().expect("points");
        assert!(points.len() > 90);
        for point in points {
            let [x, height] = [0, 1].map(|part| point[part].as_f64().expect("a number"));
            assert!((height - 1.0 + (1.0 - x * x).sqrt()).abs() < 1e-12, "{x} {height}");
        }
        assert_eq!(terrain(90.0)["pieces"], json!([]));
    }
}
