//! The size of a motion, which determines all sizes that are not specified.

use super::snapshot::{Link, SolidPart};
use super::solids::solid;
use super::vector::Vector;
use crate::geometry::{bounds, length, subtract};
use crate::snapshot::Snapshot;
use lagrange_runtime::scene::Spatial;

/// The extent of a motion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Size {
    pub(super) low: Vector,
    pub(super) high: Vector,
}

/// Radius of rods and arrows relative to the diagonal.
const THIN: f64 = 0.006;

impl Size {
    pub(super) fn of(snapshots: &[Snapshot<Spatial>]) -> Size {
        let places = snapshots.iter().flat_map(Snapshot::places);
        let [low, high] =
            bounds(places.flat_map(|(at, room)| [at.map(|part| part - room), at.map(|part| part + room)]));
        if low[0] <= high[0] { Size { low, high } } else { Size { low: [0.0; 3], high: [0.0; 3] } }
    }

    /// Returns the diagonal; 1 if everything is at one point.
    pub(super) fn diagonal(&self) -> f64 {
        let diagonal = length(subtract(self.high, self.low));
        if diagonal > 0.0 { diagonal } else { 1.0 }
    }

    /// Returns the radius of rods and of the shafts of arrows.
    pub(super) fn thin(&self) -> f64 {
        THIN * self.diagonal()
    }
}

impl Snapshot<Spatial> {
    /// Returns the positions of items with an inherent size, with their extents around them.
    fn places(&self) -> impl Iterator<Item = (Vector, f64)> + '_ {
        let links = self.bodies.iter().flat_map(Link::places);
        let joints = self.joints.iter().map(|joint| (joint.at, 0.0));
        let spans = self.connectors.iter().flat_map(|connector| connector.ends.map(|end| (end, 0.0)));
        links.chain(joints).chain(spans)
    }
}

impl Link {
    fn places(&self) -> Vec<(Vector, f64)> {
        let part = |part: &SolidPart| {
            let corners = solid(part.shape, 0.0).corners;
            let radius = corners.iter().map(|corner| length(corner.at)).fold(0.0, f64::max);
            (self.place_of(part.at), radius)
        };
        let center = self.motion.map_or(self.origin, |motion| motion.center);
        self.parts.iter().map(part).chain([(center, 0.0)]).collect()
    }
}
