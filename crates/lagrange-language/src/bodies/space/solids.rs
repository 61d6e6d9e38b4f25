//! Solids in space: one row each.
//!
//! Axes of symmetry are z, long sides of rods x. Moments of inertia are the principal moments about
//! the centre of mass, along x, y and z, for a mass of one.
//!
//! Source: Meriam, Kraige, *Engineering Mechanics: Dynamics*, table D/4.

use super::vectors::{Triple, zero_triple};
use crate::bodies::terms::TermWriter;
use crate::syntax::ast::{AstId, Shape};
use lagrange_expr::diagnostics;
use lagrange_expr::solids as plane;

/// A solid with its principal moments of inertia.
pub(super) struct SolidInSpace {
    pub(super) name: &'static str,
    /// The variant of `lagrange::scene::Solid` that draws it.
    pub(super) variant: &'static str,
    pub(super) dimensions: &'static [&'static str],
    /// Principal moments for a mass of one, from the dimensions.
    pub(super) moments: fn(&mut TermWriter<'_>, &[AstId]) -> Triple,
    /// Centre of mass in the solid's coordinates.
    pub(super) centroid: fn(&mut TermWriter<'_>, &[AstId]) -> Triple,
}

impl SolidInSpace {
    /// Returns the spelling as a shape: `cuboid(a, b, c)`.
    pub(super) fn usage(&self) -> String {
        format!("{}({})", self.name, self.dimensions.join(", "))
    }
}

/// Returns the solid with this name.
pub(super) fn by_name(name: &str) -> Option<&'static SolidInSpace> {
    SOLIDS_IN_SPACE.iter().find(|solid| solid.name == name)
}

/// True for a shape whose number of dimensions matches a solid in space, but not one in the plane.
pub(super) fn is_only_in_space(shape: &Shape) -> bool {
    let (name, count) = (shape.solid.text.as_str(), shape.dimensions.len());
    let is_in_space = by_name(name).is_some_and(|solid| solid.dimensions.len() == count);
    is_in_space && !plane::by_name(name).is_some_and(|solid| solid.dimensions.accept(count))
}

/// Returns the name of the solid that was probably intended.
pub(super) fn nearest(name: &str) -> Option<&'static str> {
    diagnostics::nearest(name, SOLIDS_IN_SPACE.iter().map(|solid| solid.name))
}

/// Every solid.
pub(super) const SOLIDS_IN_SPACE: &[SolidInSpace] = &[
    SolidInSpace {
        name: "point_mass",
        variant: "PointMass",
        dimensions: &[],
        moments: |t, _| zero_triple(t),
        centroid: at_origin,
    },
    SolidInSpace {
        name: "slender_rod",
        variant: "SlenderRod",
        dimensions: &["l"],
        moments: |t, x| {
            let across = fraction_of_squares(t, &[(1, 12, x[0])]);
            [t.number(0), across, across]
        },
        centroid: at_origin,
    },
    SolidInSpace {
        name: "solid_sphere",
        variant: "Sphere",
        dimensions: &["r"],
        moments: |t, x| [fraction_of_squares(t, &[(2, 5, x[0])]); 3],
        centroid: at_origin,
    },
    SolidInSpace {
        name: "thin_sphere",
        variant: "Sphere",
        dimensions: &["r"],
        moments: |t, x| [fraction_of_squares(t, &[(2, 3, x[0])]); 3],
        centroid: at_origin,
    },
    SolidInSpace {
        name: "ellipsoid",
        variant: "Ellipsoid",
        dimensions: &["a", "b", "c"],
        moments: |t, x| {
            [[1, 2], [2, 0], [0, 1]].map(|sides| fraction_of_squares(t, &sides.map(|side| (1, 5, x[side]))))
        },
        centroid: at_origin,
    },
    SolidInSpace {
        name: "cuboid",
        variant: "Cuboid",
        dimensions: &["a", "b", "c"],
        moments: |t, x| {
            [[1, 2], [2, 0], [0, 1]].map(|sides| fraction_of_squares(t, &sides.map(|side| (1, 12, x[side]))))
        },
        centroid: at_origin,
    },
    SolidInSpace {
        name: "disk",
        variant: "Disk",
        dimensions: &["r"],
        moments: |t, x| {
            let across = fraction_of_squares(t, &[(1, 4, x[0])]);
            [across, across, fraction_of_squares(t, &[(1, 2, x[0])])]
        },
        centroid: at_origin,
    },
    SolidInSpace {
        name: "thin_ring",
        variant: "Ring",
        dimensions: &["r"],
        moments: |t, x| {
            let across = fraction_of_squares(t, &[(1, 2, x[0])]);
            [across, across, fraction_of_squares(t, &[(1, 1, x[0])])]
        },
        centroid: at_origin,
    },
    SolidInSpace {
        name: "solid_cylinder",
        variant: "Cylinder",
        dimensions: &["r", "h"],
        moments: |t, x| {
            let across = fraction_of_squares(t, &[(1, 4, x[0]), (1, 12, x[1])]);
            [across, across, fraction_of_squares(t, &[(1, 2, x[0])])]
        },
        centroid: at_origin,
    },
    SolidInSpace {
        name: "hollow_cylinder",
        variant: "HollowCylinder",
        dimensions: &["inner", "outer", "h"],
        moments: |t, x| {
            let across = fraction_of_squares(t, &[(1, 4, x[0]), (1, 4, x[1]), (1, 12, x[2])]);
            [across, across, fraction_of_squares(t, &[(1, 2, x[0]), (1, 2, x[1])])]
        },
        centroid: at_origin,
    },
    // Its base is at z = 0, its tip at z = h.
    SolidInSpace {
        name: "cone",
        variant: "Cone",
        dimensions: &["r", "h"],
        moments: |t, x| {
            let across = fraction_of_squares(t, &[(3, 20, x[0]), (3, 80, x[1])]);
            [across, across, fraction_of_squares(t, &[(3, 10, x[0])])]
        },
        centroid: |t, x| {
            let [_, _, up] = zero_triple(t);
            let four = t.number(4);
            [up, up, t.divide(x[1], four)]
        },
    },
];

fn at_origin(terms: &mut TermWriter<'_>, _: &[AstId]) -> Triple {
    zero_triple(terms)
}

/// Returns Σ n/d x².
fn fraction_of_squares(terms: &mut TermWriter<'_>, parts: &[(i64, i64, AstId)]) -> AstId {
    let mut sum = terms.number(0);
    for &(numerator, denominator, length) in parts {
        let square = terms.square(length);
        let weighed = match (numerator, denominator) {
            (1, 1) => square,
            _ => {
                let (numerator, denominator) = (terms.number(numerator), terms.number(denominator));
                let fraction = terms.divide(numerator, denominator);
                terms.times(fraction, square)
            }
        };
        sum = terms.plus(sum, weighed);
    }
    sum
}
