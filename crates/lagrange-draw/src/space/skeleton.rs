//! The shapes of bodies: their solids or, for bodies given only by numbers, rods between the joints
//! that they carry.

use super::mesh::Mesh;
use super::snapshot::{Link, SolidPart};
use super::solids::{ball, cylinder, solid};
use super::vector::{NONE, UPRIGHT, Vector, axes_along};
use crate::geometry::{dot, length, subtract, times, unit};
use crate::snapshot::{Joint, Snapshot};
use lagrange_runtime::scene::{Spatial, SpatialJointKind};

/// The rods of a tree of bodies.
pub(super) struct Skeleton<'a> {
    scene: &'a Snapshot<Spatial>,
    /// Radius of arrows, the unit of all sizes.
    thin: f64,
}

/// Radius of rods relative to the radius of arrows.
const ROD: f64 = 1.5;
/// Radius of centres of mass relative to the radius of arrows.
const CENTER: f64 = 2.6;
/// Number of corners around a rod.
const ROUND: usize = 16;

impl<'a> Skeleton<'a> {
    pub(super) fn of(scene: &'a Snapshot<Spatial>, thin: f64) -> Self {
        Skeleton { scene, thin }
    }

    /// Returns the mesh of a link, if it is visible.
    pub(super) fn mesh(&self, link: &Link) -> Option<Mesh> {
        match link.parts.is_empty() {
            true => self.rods(link),
            false => Some(link.parts.iter().map(|part| self.part(part)).reduce(Mesh::with)?),
        }
    }

    /// Returns the mesh of a part; of a hole, only its edges.
    fn part(&self, part: &SolidPart) -> Mesh {
        let mesh = solid(part.shape, 2.0 * self.thin).placed(part.at, &part.rotation);
        if part.is_hole { mesh.edges_only() } else { mesh }
    }

    /// Returns rods from the origin of a link to the joints that it carries. Without joints, a rod
    /// leads to its centre of mass, which is a ball.
    fn rods(&self, link: &Link) -> Option<Mesh> {
        let is_carried = |joint: &&Joint<Spatial>| {
            let [carrier, other] = joint.kind.links.each_ref().map(|name| name.as_ref() == Some(&link.name));
            // A pin is fixed in both links.
            carrier || (other && joint.kind.kind == SpatialJointKind::Pin)
        };
        let carried = self.scene.joints.iter().filter(is_carried);
        let mut ends: Vec<Vector> = carried.map(|joint| link.own(joint.at)).collect();
        ends.retain(|end| length(*end) > self.thin);
        let center = link.motion.map(|motion| motion.centroid);
        if ends.is_empty() {
            ends.extend(center.filter(|center| length(*center) > self.thin));
        }
        let rods = ends.iter().filter_map(|end| self.rod(NONE, *end));
        // A centre of mass away from the rods would hang in the air.
        let mass = center
            .filter(|center| {
                ends.is_empty() || ends.iter().any(|end| distance(*center, *end) < CENTER * self.thin)
            })
            .map(|center| ball(CENTER * self.thin).placed(center, &UPRIGHT));
        rods.chain(mass).reduce(Mesh::with)
    }

    fn rod(&self, from: Vector, to: Vector) -> Option<Mesh> {
        let span = subtract(to, from);
        let rod = cylinder(ROD * self.thin, [0.0, length(span)], ROUND);
        Some(rod.placed(from, &axes_along(unit(span)?)))
    }
}

/// Returns the distance of a point from the rod between the origin and its end.
fn distance(place: Vector, end: Vector) -> f64 {
    let along = (dot(place, end) / dot(end, end)).clamp(0.0, 1.0);
    length(subtract(place, times(along, end)))
}
