//! From scenes in space to things: what stands for each item, and what is written beside it.

use super::mesh::{Corner, Mesh, Placement};
use super::recording::{Kind, Label, Thing};
use super::size::Size;
use super::skeleton::Skeleton;
use super::snapshot::{Joint, Link, Snapshot, Span};
use super::solids::{self, SHORTEST_ARROW};
use super::vector::{NONE, UPRIGHT, Vector, add, apply, axes_along, length, subtract, times, unit};
use crate::colour::{self, ACCELERATION, FORCE, INK, PALE, VELOCITY};
use crate::picture::Colour;
use crate::text::{formula, symbol};
use lagrange_runtime::body::SpatialMotion;
use lagrange_runtime::scene::{Connector, LoadOrigin, SpatialJoint};

/// What is drawn beside the scene itself.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct Wanted {
    pub(super) velocities: bool,
    pub(super) accelerations: bool,
    pub(super) forces: bool,
    pub(super) frames: bool,
    pub(super) axes: bool,
    pub(super) names: bool,
    /// The height of a floor.
    pub(super) floor: Option<f64>,
}

/// The longest arrows of a kind, and axes, in terms of the diagonal of the whole.
const LONGEST: f64 = 0.3;
const AXIS: f64 = 0.12;
/// Sizes in terms of the radius of rods.
const PIN: f64 = 2.4;
const PIN_LENGTH: f64 = 7.0;
const COIL: f64 = 3.0;
const LANE: f64 = 8.0;
/// Fields of a floor along the longer side.
const FIELDS: f64 = 12.0;

/// All things of a motion; every scene of it hands out the same items.
pub(super) fn things(film: &[Snapshot], wanted: Wanted, size: &Size) -> Vec<Thing> {
    let Some(first) = film.first() else { return Vec::new() };
    let stage = Stage { film, wanted, size };
    let mut things = Vec::new();
    things.extend(wanted.floor.map(|height| stage.floor(height)));
    let skeleton = Skeleton::of(first, size.thin());
    let mut bodies = 0;
    for (index, link) in first.links.iter().enumerate() {
        let mesh = skeleton.mesh(link);
        let colour = colour::solid(bodies);
        bodies += usize::from(link.motion.is_some());
        things.extend(mesh.map(|mesh| stage.link(index, link, mesh, colour)));
    }
    things.extend(first.connectors.iter().enumerate().map(|(index, span)| stage.connector(index, span)));
    things.extend(first.joints.iter().enumerate().flat_map(|(index, joint)| stage.joint(index, joint)));
    things.extend(stage.kinematics(first));
    if wanted.forces {
        things.extend(stage.loads(first));
    }
    if wanted.axes {
        things.extend(stage.axes("", |_| Some((NONE, UPRIGHT)), ["x", "y", "z"]));
    }
    things
}

struct Stage<'a> {
    film: &'a [Snapshot],
    wanted: Wanted,
    size: &'a Size,
}

/// A label at a place of a thing.
fn label(text: String, at: Vector, share: f64) -> Option<Label> {
    (!text.is_empty()).then_some(Label { text, at: Corner { at, share } })
}

impl Stage<'_> {
    fn track(&self, placement: impl Fn(&Snapshot) -> Placement) -> Vec<Placement> {
        self.film.iter().map(placement).collect()
    }

    fn name(&self, name: &str) -> String {
        if self.wanted.names { formula(name) } else { String::new() }
    }

    fn link(&self, index: usize, link: &Link, mesh: Mesh, colour: Colour) -> Thing {
        let center = link.motion.map_or(NONE, |motion| motion.centroid);
        let track = self.track(|snapshot| {
            let Link { origin, rotation, .. } = snapshot.links[index];
            Placement { origin, rotation, stretch: 0.0, scale: 1.0 }
        });
        let text = if link.motion.is_some() { self.name(&link.name) } else { String::new() };
        Thing {
            name: link.name.clone(),
            label: label(text, center, 0.0),
            colour,
            kind: Kind::Body,
            mesh,
            track,
        }
    }

    fn connector(&self, index: usize, span: &Span) -> Thing {
        let thin = self.size.thin();
        let mesh = match span.kind {
            Connector::Damper | Connector::TorsionDamper => solids::damper(COIL * thin),
            Connector::Spring | Connector::TorsionSpring => solids::spring(COIL * thin),
        };
        let aside = LANE * thin * self.lane(index);
        let track = self.track(|snapshot| {
            let [from, to] = snapshot.connectors[index].ends;
            let placement = spanned(from, subtract(to, from));
            let aside = apply(&placement.rotation, [aside, 0.0, 0.0]);
            Placement { origin: add(placement.origin, aside), ..placement }
        });
        let is_made_up = span.name.starts_with("spring_") || span.name.starts_with("damper_");
        let text = if is_made_up { String::new() } else { self.name(&span.name) };
        let label = label(text, [COIL * thin, 0.0, 0.0], 0.5);
        Thing { name: span.name.clone(), label, colour: INK, kind: Kind::Connector, mesh, track }
    }

    /// How far beside the line between its ends a connector lies: those between the same points lie side by side.
    fn lane(&self, index: usize) -> f64 {
        let near = 1e-9 * self.size.diagonal();
        let are_one = |other: usize| {
            self.film.iter().all(|snapshot| {
                let [a, b] = [index, other].map(|index| snapshot.connectors[index].ends);
                let meet = |c: [Vector; 2]| (0..2).all(|end| length(subtract(a[end], c[end])) <= near);
                meet(b) || meet([b[1], b[0]])
            })
        };
        let count = self.film.first().map_or(0, |snapshot| snapshot.connectors.len());
        let together: Vec<usize> = (0..count).filter(|&other| are_one(other)).collect();
        let place = together.iter().position(|&other| other == index).unwrap_or(0);
        place as f64 - 0.5 * (together.len().max(1) - 1) as f64
    }

    fn joint(&self, index: usize, joint: &Joint) -> Vec<Thing> {
        let thin = self.size.thin();
        let mesh = match joint.kind {
            SpatialJoint::Revolute
            | SpatialJoint::Cylindrical
            | SpatialJoint::Screw
            | SpatialJoint::Universal => solids::pin(PIN * thin, PIN_LENGTH * thin),
            SpatialJoint::Prismatic => {
                solids::cuboid([2.0 * PIN * thin, 2.0 * PIN * thin, PIN_LENGTH * thin])
            }
            SpatialJoint::Ball | SpatialJoint::Pin => solids::ball(PIN * thin),
            SpatialJoint::Planar | SpatialJoint::Free | SpatialJoint::Weld => return Vec::new(),
        };
        let thing = |mesh, track| Thing {
            name: joint.name.clone(),
            label: None,
            colour: PALE,
            kind: Kind::Joint,
            mesh,
            track,
        };
        let at = |snapshot: &Snapshot| {
            let Joint { at, axis, .. } = snapshot.joints[index];
            let rotation = unit(axis).map_or(UPRIGHT, axes_along);
            Placement { origin: at, rotation, stretch: 0.0, scale: 1.0 }
        };
        let mut things = vec![thing(mesh, self.track(at))];
        if joint.kind == SpatialJoint::Prismatic {
            let rod = self.track(|snapshot| {
                let Joint { at, links, .. } = &snapshot.joints[index];
                let outer = snapshot.links.iter().find(|link| links[1].as_ref() == Some(&link.name));
                spanned(*at, outer.map_or(NONE, |link| subtract(link.origin, *at)))
            });
            things.push(thing(solids::stick(thin), rod));
        }
        things
    }

    /// Velocities, accelerations and axes of bodies.
    fn kinematics(&self, first: &Snapshot) -> Vec<Thing> {
        let bodies =
            first.links.iter().enumerate().filter(|(_, link)| link.motion.is_some()).collect::<Vec<_>>();
        let Wanted { velocities, accelerations, frames, .. } = self.wanted;
        type Rate = fn(&SpatialMotion<f64>) -> Vector;
        let kinds: [(bool, &str, Colour, Rate); 2] = [
            (velocities, "v", VELOCITY, |motion| motion.velocity),
            (accelerations, "a", ACCELERATION, |motion| motion.acceleration),
        ];
        let mut things = Vec::new();
        for (_, letter, colour, rate) in kinds.into_iter().filter(|(is_wanted, ..)| *is_wanted) {
            let vectors = bodies.iter().map(|(index, link)| {
                let vector = |snapshot: &Snapshot| {
                    let motion = snapshot.links[*index].motion;
                    motion.map_or([NONE; 2], |motion| [motion.center, rate(&motion)])
                };
                (
                    &*link.name,
                    symbol(letter, &link.name, bodies.len() > 1),
                    self.film.iter().map(vector).collect(),
                )
            });
            things.extend(self.arrows(vectors.collect(), colour, solids::arrow(self.size.thin())));
        }
        for (index, link) in first.links.iter().enumerate().filter(|_| frames) {
            let pose = |snapshot: &Snapshot| {
                let link = &snapshot.links[index];
                Some((link.origin, link.rotation))
            };
            things.extend(self.axes(&link.name, pose, ["X", "Y", "Z"]));
        }
        things
    }

    /// Forces, then moments, each kind on a scale of its own.
    fn loads(&self, first: &Snapshot) -> Vec<Thing> {
        let of_kind = |is_moment: bool| {
            let loads = first.loads.iter().enumerate().filter(|(_, load)| load.is_moment == is_moment);
            let vectors = loads.map(|(index, load)| {
                let vector = |snapshot: &Snapshot| {
                    let load = &snapshot.loads[index];
                    [load.at, load.value]
                };
                let text = match (load.cause, &load.body) {
                    (LoadOrigin::Gravity, Some(body)) => symbol("G", body, true),
                    _ => formula(&load.name),
                };
                (&*load.name, text, self.film.iter().map(vector).collect())
            });
            let thin = self.size.thin();
            let mesh = if is_moment { solids::double_arrow(thin) } else { solids::arrow(thin) };
            self.arrows(vectors.collect(), FORCE, mesh)
        };
        [of_kind(false), of_kind(true)].concat()
    }

    /// Arrows, each by its name, its label, and where it is and what it shows at each moment; the longest has a readable length.
    fn arrows(
        &self,
        vectors: Vec<(&str, String, Vec<[Vector; 2]>)>,
        colour: Colour,
        mesh: Mesh,
    ) -> Vec<Thing> {
        let all = vectors.iter().flat_map(|(_, _, track)| track.iter().map(|[_, vector]| length(*vector)));
        let largest = all.fold(0.0, f64::max);
        let scale = LONGEST * self.size.diagonal() / largest;
        let scale = if scale.is_finite() { scale } else { 0.0 };
        let thing = |(name, text, track): (&str, String, Vec<[Vector; 2]>)| Thing {
            name: name.to_owned(),
            label: label(text, NONE, 1.0),
            colour,
            kind: Kind::Arrow,
            mesh: mesh.clone(),
            track: track.into_iter().map(|[at, vector]| self.arrow(at, times(scale, vector))).collect(),
        };
        vectors.into_iter().map(thing).collect()
    }

    /// An arrow that is smaller as a whole if it is short, and vanishes if it has no length to be seen.
    fn arrow(&self, at: Vector, vector: Vector) -> Placement {
        const SEEN: f64 = 0.05;
        let placement = spanned(at, vector);
        let part = placement.stretch / (SHORTEST_ARROW * self.size.thin());
        Placement { scale: if part < SEEN { 0.0 } else { part.min(1.0) }, ..placement }
    }

    /// Three axes.
    fn axes(
        &self,
        name: &str,
        pose: impl Fn(&Snapshot) -> Option<(Vector, super::vector::Rotation)>,
        letters: [&str; 3],
    ) -> Vec<Thing> {
        let length = AXIS * self.size.diagonal();
        let axis = |(axis, letter): (usize, &str)| {
            let track = self.track(|snapshot| {
                let (origin, rotation) = pose(snapshot).unwrap_or((NONE, UPRIGHT));
                spanned(origin, rotation.map(|row| length * row[axis]))
            });
            Thing {
                name: format!("{letter} {name}").trim_end().to_owned(),
                label: label(letter.to_owned(), NONE, 1.0),
                colour: PALE,
                kind: Kind::Arrow,
                mesh: solids::arrow(0.6 * self.size.thin()),
                track,
            }
        };
        letters.into_iter().enumerate().map(axis).collect()
    }

    /// A grid at a height, under all that moves.
    fn floor(&self, height: f64) -> Thing {
        let Size { low, high } = *self.size;
        let field = (high[0] - low[0]).max(high[1] - low[1]).max(0.2 * self.size.diagonal()) / FIELDS;
        let from = [0, 1].map(|axis| (low[axis] / field).floor() as i64 - 1);
        let to = [0, 1].map(|axis| (high[axis] / field).ceil() as i64 + 1);
        let mut mesh = Mesh::default();
        let mut line = |ends: [[i64; 2]; 2]| {
            let start = mesh.corners.len();
            mesh.corners.extend(
                ends.map(|[x, y]| Corner { at: [x as f64 * field, y as f64 * field, 0.0], share: 0.0 }),
            );
            mesh.lines.push(vec![start, start + 1]);
        };
        (from[0]..=to[0]).for_each(|x| line([[x, from[1]], [x, to[1]]]));
        (from[1]..=to[1]).for_each(|y| line([[from[0], y], [to[0], y]]));
        let placement = Placement { origin: [0.0, 0.0, height], rotation: UPRIGHT, stretch: 0.0, scale: 1.0 };
        let track = self.track(|_| placement);
        Thing {
            name: "floor".to_owned(),
            label: None,
            colour: colour::HATCHING,
            kind: Kind::Surroundings,
            mesh,
            track,
        }
    }
}

/// A placement that stretches from a point along a vector.
fn spanned(from: Vector, vector: Vector) -> Placement {
    let rotation = unit(vector).map_or(UPRIGHT, axes_along);
    Placement { origin: from, rotation, stretch: length(vector), scale: 1.0 }
}

/// A line through points at rest, in a film of so many moments.
pub(super) fn path(label: &str, points: &[Vector], colour: Colour, moments: usize) -> Thing {
    let corners = points.iter().map(|&at| Corner { at, share: 0.0 }).collect();
    let placement = Placement { origin: NONE, rotation: UPRIGHT, stretch: 0.0, scale: 1.0 };
    Thing {
        name: label.to_owned(),
        label: points.last().and_then(|&at| self::label(formula(label), at, 0.0)),
        colour,
        kind: Kind::Surroundings,
        mesh: Mesh { corners, faces: Vec::new(), lines: vec![(0..points.len()).collect()], is_closed: false },
        track: vec![placement; moments],
    }
}
