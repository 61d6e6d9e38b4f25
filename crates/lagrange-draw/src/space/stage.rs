//! Conversion of scenes in space to meshes and labels of each item.

use super::arrows::Arrows;
use super::mesh::{Mesh, Placement};
use super::recording::{Kind, Label, MovingMesh};
use super::size::Size;
use super::skeleton::Skeleton;
use super::snapshot::{Hold, Link};
use super::solids;
use super::surroundings::Surroundings;
use super::vector::{NONE, UPRIGHT, Vector, apply, axes_along};
use crate::colour::{self, ACCELERATION, INK, PALE, VELOCITY};
use crate::geometry::{add, length, subtract, unit};
use crate::look::Wanted;
use crate::picture::Colour;
use crate::snapshot::{Joint, Snapshot, Span};
use crate::stage::is_made_up;
use lagrange_plot::notation::formula;
use lagrange_runtime::scene::{Connector, Spatial, SpatialJointKind};

/// Radius of pins relative to that of rods.
const PIN: f64 = 2.0;
/// Length of pins relative to the radius of rods.
const PIN_LENGTH: f64 = 5.5;
/// Radius of springs relative to that of rods.
const COIL: f64 = 3.0;
/// Offset between connectors relative to the radius of rods.
const LANE: f64 = 7.0;
/// Distance relative to the diagonal below which ends coincide.
const TOUCHING: f64 = 1e-6;

/// Returns all things of a motion; every scene of it has the same items.
pub(super) fn things(surroundings: &Surroundings<'_>, wanted: Wanted) -> Vec<MovingMesh> {
    let &Surroundings { film, size, .. } = surroundings;
    let Some(first) = film.first() else { return Vec::new() };
    let stage = Stage { film, wanted, size };
    let mut things = Vec::new();
    things.extend(wanted.floor.map(|height| surroundings.floor(height)));
    things.extend((0..first.supports.len()).flat_map(|index| surroundings.surfaces(index)));
    let skeleton = Skeleton::of(first, size.thin());
    let mut bodies = 0;
    for (index, link) in first.bodies.iter().enumerate() {
        let mesh = skeleton.mesh(link);
        let colour = colour::solid(bodies);
        bodies += usize::from(link.motion.is_some());
        things.extend(mesh.map(|mesh| stage.link(index, link, mesh, colour)));
    }
    things.extend(first.connectors.iter().enumerate().map(|(index, span)| stage.connector(index, span)));
    things.extend(first.joints.iter().enumerate().flat_map(|(index, joint)| stage.joint(index, joint)));
    things.extend(arrows(&Arrows { film, size }, first, wanted));
    things
}

fn arrows(arrows: &Arrows<'_>, first: &Snapshot<Spatial>, wanted: Wanted) -> Vec<MovingMesh> {
    let mut things = Vec::new();
    if wanted.velocities {
        things.extend(arrows.rates(first, "v", VELOCITY, |motion| motion.velocity));
    }
    if wanted.accelerations {
        things.extend(arrows.rates(first, "a", ACCELERATION, |motion| motion.acceleration));
    }
    if wanted.frames {
        things.extend(arrows.own_axes(first));
    }
    if wanted.forces {
        things.extend(arrows.cones(first));
        things.extend(arrows.loads(first));
    }
    if wanted.axes {
        things.extend(arrows.axes_of_world());
    }
    things
}

struct Stage<'a> {
    film: &'a [Snapshot<Spatial>],
    wanted: Wanted,
    size: &'a Size,
}

impl Stage<'_> {
    fn track(&self, placement: impl Fn(&Snapshot<Spatial>) -> Placement) -> Vec<Placement> {
        self.film.iter().map(placement).collect()
    }

    fn name(&self, name: &str) -> String {
        if self.wanted.names { formula(name) } else { String::new() }
    }

    fn link(&self, index: usize, link: &Link, mesh: Mesh, colour: Colour) -> MovingMesh {
        let center = link.motion.map_or(NONE, |motion| motion.centroid);
        let track = self.track(|snapshot| {
            let Link { origin, rotation, .. } = snapshot.bodies[index];
            Placement::rigid(origin, rotation)
        });
        let text = if link.motion.is_some() { self.name(&link.name) } else { String::new() };
        MovingMesh {
            name: link.name.clone(),
            label: Label::new(text, center, 0.0),
            colour,
            kind: Kind::Body,
            mesh,
            track,
        }
    }

    fn connector(&self, index: usize, span: &Span<Spatial>) -> MovingMesh {
        let thin = self.size.thin();
        let (mesh, colour) = match span.kind {
            Connector::Damper | Connector::TorsionDamper => (solids::damper(COIL * thin), PALE),
            Connector::Spring | Connector::TorsionSpring => (solids::spring(COIL * thin), INK),
        };
        let (leader, lane) = self.lane(index);
        let spanned = |index: usize| {
            let ends = self.film.iter().map(|snapshot| snapshot.connectors[index].ends);
            Placement::spanned(ends.map(|[from, to]| [from, subtract(to, from)]))
        };
        // Offsets are to the same side even for reversed connectors.
        let beside = |(placement, leader): (Placement, Placement)| {
            let aside = apply(&leader.rotation, [LANE * thin * lane, 0.0, 0.0]);
            Placement { origin: add(placement.origin, aside), ..placement }
        };
        let track = spanned(index).into_iter().zip(spanned(leader)).map(beside).collect();
        let text = if is_made_up(&span.name, span.kind) { String::new() } else { self.name(&span.name) };
        let label = Label::new(text, [COIL * thin, 0.0, 0.0], 0.5);
        MovingMesh { name: span.name.clone(), label, colour, kind: Kind::Connector, mesh, track }
    }

    /// Returns the first connector between the same points, and this one's offset from the line
    /// between them.
    fn lane(&self, index: usize) -> (usize, f64) {
        let near = TOUCHING * self.size.diagonal();
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
        let lane = place as f64 - 0.5 * (together.len().max(1) - 1) as f64;
        (together.first().copied().unwrap_or(index), lane)
    }

    fn joint(&self, index: usize, joint: &Joint<Spatial>) -> Vec<MovingMesh> {
        let thin = self.size.thin();
        let mesh = match joint.kind.kind {
            SpatialJointKind::Revolute
            | SpatialJointKind::Cylindrical
            | SpatialJointKind::Screw
            | SpatialJointKind::Universal => solids::pin(PIN * thin, PIN_LENGTH * thin),
            SpatialJointKind::Prismatic => {
                solids::cuboid([2.0 * PIN * thin, 2.0 * PIN * thin, PIN_LENGTH * thin])
            }
            SpatialJointKind::Ball | SpatialJointKind::Pin => solids::ball(PIN * thin),
            SpatialJointKind::Planar | SpatialJointKind::Free | SpatialJointKind::Weld => return Vec::new(),
        };
        let thing = |mesh, track| MovingMesh {
            name: joint.name.clone(),
            label: None,
            colour: PALE,
            kind: Kind::Joint,
            mesh,
            track,
        };
        let at = |snapshot: &Snapshot<Spatial>| {
            let Joint { at, kind: Hold { axis, .. }, .. } = &snapshot.joints[index];
            let rotation = unit(*axis).map_or(UPRIGHT, axes_along);
            Placement::rigid(*at, rotation)
        };
        let mut things = vec![thing(mesh, self.track(at))];
        if joint.kind.kind == SpatialJointKind::Prismatic {
            let rod = Placement::spanned(self.film.iter().map(|snapshot| {
                let Joint { at, kind: Hold { links, .. }, .. } = &snapshot.joints[index];
                let outer = snapshot.bodies.iter().find(|link| links[1].as_ref() == Some(&link.name));
                [*at, outer.map_or(NONE, |link| subtract(link.origin, *at))]
            }));
            things.push(thing(solids::stick(thin), rod));
        }
        things
    }
}
