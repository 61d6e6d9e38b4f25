//! What bodies look like: their solids or, where a body is given by numbers only, rods between the joints that it carries.

use super::mesh::Mesh;
use super::snapshot::{Link, SpatialSnapshot};
use super::solids::{ball, cylinder, solid};
use super::vector::{NONE, Vector, axes_along, length, subtract, unit};
use lagrange_runtime::scene::SolidPart;

/// Rods of a tree of bodies.
pub(super) struct Skeleton<'a> {
    scene: &'a SpatialSnapshot,
    /// The radius of arrows, by which everything is sized.
    thin: f64,
}

/// Radii of rods and of centres of mass, in terms of the radius of arrows, and corners around a rod.
const ROD: f64 = 1.5;
const CENTER: f64 = 2.6;
const ROUND: usize = 16;

impl<'a> Skeleton<'a> {
    pub(super) fn of(scene: &'a SpatialSnapshot, thin: f64) -> Self {
        Skeleton { scene, thin }
    }

    /// What a link looks like, if there is anything to see.
    pub(super) fn mesh(&self, link: &Link) -> Option<Mesh> {
        match link.parts.is_empty() {
            true => self.rods(link),
            false => Some(link.parts.iter().map(|part| self.part(part)).reduce(Mesh::with)?),
        }
    }

    /// Holes are drawn by their edges.
    fn part(&self, part: &SolidPart<f64>) -> Mesh {
        let mesh = solid(part.solid, 2.0 * self.thin).placed(part.at, &part.rotation);
        if part.is_hole { mesh.edges_only() } else { mesh }
    }

    /// Rods from the origin of a link to the joints that it carries and, where there are none, to its centre of mass.
    fn rods(&self, link: &Link) -> Option<Mesh> {
        let carried = self
            .scene
            .joints
            .iter()
            .filter(|joint| joint.links.iter().flatten().any(|name| *name == link.name));
        let mut ends: Vec<Vector> = carried.map(|joint| link.own(joint.at)).collect();
        ends.retain(|end| length(*end) > self.thin);
        let center = link.motion.map(|motion| motion.centroid);
        if ends.is_empty() {
            ends.extend(center.filter(|center| length(*center) > self.thin));
        }
        let rods = ends.iter().filter_map(|end| self.rod(NONE, *end));
        let is_leaf = ends.len() <= 1;
        let mass = center
            .filter(|_| is_leaf)
            .map(|center| ball(CENTER * self.thin).placed(center, &super::vector::UPRIGHT));
        rods.chain(mass).reduce(Mesh::with)
    }

    fn rod(&self, from: Vector, to: Vector) -> Option<Mesh> {
        let span = subtract(to, from);
        let rod = cylinder(ROD * self.thin, [0.0, length(span)], ROUND);
        Some(rod.placed(from, &axes_along(unit(span)?)))
    }
}
