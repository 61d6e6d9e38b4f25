//! Robots: links and the joints between them, as a validated tree, independent of the file format.

use crate::decimal::Decimal;

/// Products of moments of inertia below this fraction of the largest ones are attributed to
/// cancellation.
const NEGLIGIBLE: f64 = 1e-12;

/// A tree of links. Each joint is carried by the root or by a link that an earlier joint places.
#[derive(Clone, Debug)]
pub(crate) struct Robot {
    pub(crate) name: String,
    pub(crate) links: Vec<Link>,
    /// Index of the link that no joint places.
    pub(crate) root: usize,
    pub(crate) joints: Vec<Joint>,
}

#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub(crate) name: String,
    /// `None` for a massless link.
    pub(crate) inertial: Option<Inertial>,
    /// Shapes that are primitives.
    pub(crate) shapes: Vec<Shape>,
    /// True if a collision shape is a mesh or another shape that is not a primitive.
    pub(crate) collides_as_mesh: bool,
    /// Offset of the declaration in the file.
    pub(crate) place: usize,
}

/// Mass and its distribution, in the axes of the link.
#[derive(Clone, Debug)]
pub(crate) struct Inertial {
    pub(crate) mass: Decimal,
    pub(crate) centroid: [Decimal; 3],
    /// Entries xx, yy, zz, xy, xz, yz about the centre of mass.
    pub(crate) tensor: [Decimal; 6],
    /// True if a body can have this tensor.
    pub(crate) is_physical: bool,
    /// Offset of the tensor in the file.
    pub(crate) place: usize,
}

/// A primitive, with its place in the axes of the link.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) is_visual: bool,
    pub(crate) solid: Solid,
    /// Dimensions in the order of the language.
    pub(crate) dimensions: Vec<Decimal>,
    pub(crate) at: [Decimal; 3],
    pub(crate) turned: [Decimal; 3],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Solid {
    Box,
    Cylinder,
    Sphere,
}

#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    pub(crate) parent: usize,
    pub(crate) child: usize,
    pub(crate) at: [Decimal; 3],
    /// Roll, pitch and yaw.
    pub(crate) turned: [Decimal; 3],
    /// Axis of any nonzero length.
    pub(crate) axis: [Decimal; 3],
    pub(crate) limit: Limit,
    pub(crate) damping: Option<Decimal>,
    pub(crate) friction: Option<Decimal>,
    pub(crate) mimic: Option<Mimic>,
    /// Offset of the declaration in the file.
    pub(crate) place: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Revolute,
    Prismatic,
    Planar,
    Floating,
    Fixed,
    /// A joint that could move, but moves no mass, so its motion is undetermined.
    Held,
}

/// Kinds of joints by their names in files.
pub(crate) const KINDS: [(&str, Kind); 6] = [
    ("revolute", Kind::Revolute),
    ("continuous", Kind::Revolute),
    ("prismatic", Kind::Prismatic),
    ("fixed", Kind::Fixed),
    ("floating", Kind::Floating),
    ("planar", Kind::Planar),
];

impl Kind {
    /// True if it has a single coordinate.
    pub(crate) fn is_simple(self) -> bool {
        matches!(self, Kind::Revolute | Kind::Prismatic)
    }

    /// True if the joint is rigid.
    pub(crate) fn is_rigid(self) -> bool {
        matches!(self, Kind::Fixed | Kind::Held)
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Limit {
    pub(crate) lower: Option<Decimal>,
    pub(crate) upper: Option<Decimal>,
    pub(crate) effort: Option<Decimal>,
    pub(crate) velocity: Option<Decimal>,
}

/// The coupling: coordinate = multiplier · coordinate of another joint + offset.
#[derive(Clone, Debug)]
pub(crate) struct Mimic {
    /// Index of the other joint.
    pub(crate) joint: usize,
    pub(crate) multiplier: Decimal,
    pub(crate) offset: Decimal,
}

/// The motion of a joint: factor · motion of an independent one + offset.
pub(crate) struct Following {
    pub(crate) leader: usize,
    pub(crate) factor: f64,
    pub(crate) offset: f64,
}

impl Link {
    /// Returns the primitives of the collision shape.
    pub(crate) fn collisions(&self) -> impl Iterator<Item = &Shape> {
        self.shapes.iter().filter(|shape| !shape.is_visual)
    }

    /// True if the link has inertia about every axis.
    pub(crate) fn has_all_moments(&self) -> bool {
        let Some(inertial) = &self.inertial else { return false };
        let [xx, yy, zz, xy, xz, yz] = inertial.tensor.each_ref().map(Decimal::value);
        let minor = xx * yy - xy * xy;
        let determinant = zz * minor - xx * yz * yz - yy * xz * xz + 2.0 * xy * xz * yz;
        let size = xx.max(yy).max(zz);
        xx > 0.0 && minor > NEGLIGIBLE * size * size && determinant > NEGLIGIBLE * size * size * size
    }
}

impl Robot {
    /// Follows the chain of joints that mimic each other to the one that mimics none.
    pub(crate) fn following(&self, joint: usize) -> Following {
        let mut following = Following { leader: joint, factor: 1.0, offset: 0.0 };
        while let Some(mimic) = &self.joints[following.leader].mimic {
            following.offset += following.factor * mimic.offset.value();
            following.factor *= mimic.multiplier.value();
            following.leader = mimic.joint;
        }
        following
    }

    /// Returns true for each link that has or carries mass.
    pub(crate) fn carries_mass(&self) -> Vec<bool> {
        let mut carries = self.links.iter().map(|link| link.inertial.is_some()).collect::<Vec<_>>();
        for joint in self.joints.iter().rev() {
            carries[joint.parent] |= carries[joint.child];
        }
        carries
    }

    /// Returns true for each link that is fixed to the root.
    pub(crate) fn fixed_in_root(&self) -> Vec<bool> {
        let mut fixed = vec![false; self.links.len()];
        fixed[self.root] = true;
        for joint in &self.joints {
            fixed[joint.child] = fixed[joint.parent] && joint.kind.is_rigid();
        }
        fixed
    }

    /// Returns the first link that moves and that, together with all links fixed to it, lacks
    /// inertia about some axis.
    ///
    /// If there is no such link, every motion has inertia.
    pub(crate) fn first_without_moment(&self, is_free: bool) -> Option<usize> {
        // The link that carries all links fixed to it.
        let mut carriers = (0..self.links.len()).collect::<Vec<_>>();
        for joint in self.joints.iter().filter(|joint| joint.kind.is_rigid()) {
            carriers[joint.child] = carriers[joint.parent];
        }
        let mut has_moments = vec![false; self.links.len()];
        has_moments[self.root] = !is_free;
        for (link, &carrier) in self.links.iter().zip(&carriers) {
            has_moments[carrier] |= link.has_all_moments();
        }
        (0..self.links.len()).find(|&link| carriers[link] == link && !has_moments[link])
    }
}
