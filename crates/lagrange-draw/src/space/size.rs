//! The size of a motion, which determines all sizes that are not specified.

use super::snapshot::{Link, SolidPart};
use super::solids::solid;
use super::vector::Vector;
use crate::geometry::{bounds, length, subtract};
use crate::snapshot::{Form, Snapshot};
use lagrange_runtime::scene::Spatial;

/// The extent of a motion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Size {
    pub(super) low: Vector,
    pub(super) high: Vector,
}

/// Radius relative to the diagonal of a motion beyond which round surfaces look flat.
pub(super) const LARGE: f64 = 30.0;
/// Radius of rods and arrows relative to the diagonal.
const THIN: f64 = 0.006;

impl Size {
    pub(super) fn of(snapshots: &[Snapshot<Spatial>]) -> Size {
        let places = snapshots.iter().flat_map(Snapshot::places);
        let [low, high] =
            bounds(places.flat_map(|(at, room)| [at.map(|part| part - room), at.map(|part| part + room)]));
        if low[0] > high[0] || !low.into_iter().chain(high).all(f64::is_finite) {
            return Size { low: [0.0; 3], high: [0.0; 3] };
        }
        Size { low, high }.with_spheres(snapshots)
    }

    /// Extends over surfaces of similar size.
    fn with_spheres(self, snapshots: &[Snapshot<Spatial>]) -> Size {
        let most = LARGE * self.diagonal();
        let supports = snapshots.iter().flat_map(|snapshot| &snapshot.supports);
        let spheres = supports.filter_map(|support| match support.form {
            Form::Round(radius) if radius <= most => {
                Some([support.at.map(|part| part - radius), support.at.map(|part| part + radius)])
            }
            _ => None,
        });
        let [low, high] = bounds(spheres.flatten().chain([self.low, self.high]));
        Size { low, high }
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
    pub(super) fn places(&self) -> impl Iterator<Item = (Vector, f64)> + '_ {
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
