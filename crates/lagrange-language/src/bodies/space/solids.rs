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
    /// Creates a solid with its centre of mass at the origin.
    const fn new(
        name: &'static str,
        variant: &'static str,
        dimensions: &'static [&'static str],
        moments: fn(&mut TermWriter<'_>, &[AstId]) -> Triple,
    ) -> Self {
        SolidInSpace { name, variant, dimensions, moments, centroid: |t, _| zero_triple(t) }
    }

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
    SolidInSpace::new("point_mass", "PointMass", &[], |t, _| zero_triple(t)),
    SolidInSpace::new("slender_rod", "SlenderRod", &["l"], |t, x| {
        let across = fraction_of_squares(t, &[(1, 12, x[0])]);
        [t.number(0), across, across]
    }),
    SolidInSpace::new("solid_sphere", "Sphere", &["r"], |t, x| [fraction_of_squares(t, &[(2, 5, x[0])]); 3]),
    SolidInSpace::new("thin_sphere", "Sphere", &["r"], |t, x| [fraction_of_squares(t, &[(2, 3, x[0])]); 3]),
    SolidInSpace::new("ellipsoid", "Ellipsoid", &["a", "b", "c"], |t, x| {
        [[1, 2], [2, 0], [0, 1]].map(|sides| fraction_of_squares(t, &sides.map(|side| (1, 5, x[side]))))
    }),
    SolidInSpace::new("cuboid", "Cuboid", &["a", "b", "c"], |t, x| {
        [[1, 2], [2, 0], [0, 1]].map(|sides| fraction_of_squares(t, &sides.map(|side| (1, 12, x[side]))))
    }),
    SolidInSpace::new("disk", "Disk", &["r"], |t, x| about_axis(t, &[(1, 4, x[0])], &[(1, 2, x[0])])),
    SolidInSpace::new("thin_ring", "Ring", &["r"], |t, x| about_axis(t, &[(1, 2, x[0])], &[(1, 1, x[0])])),
    SolidInSpace::new("solid_cylinder", "Cylinder", &["r", "h"], |t, x| {
        about_axis(t, &[(1, 4, x[0]), (1, 12, x[1])], &[(1, 2, x[0])])
    }),
    SolidInSpace::new("hollow_cylinder", "HollowCylinder", &["inner", "outer", "h"], |t, x| {
        about_axis(t, &[(1, 4, x[0]), (1, 4, x[1]), (1, 12, x[2])], &[(1, 2, x[0]), (1, 2, x[1])])
    }),
    // Its base is at z = 0, its tip at z = h.
    SolidInSpace {
        centroid: |t, x| {
            let [_, _, up] = zero_triple(t);
            let four = t.number(4);
            [up, up, t.divide(x[1], four)]
        },
        ..SolidInSpace::new("cone", "Cone", &["r", "h"], |t, x| {
            about_axis(t, &[(3, 20, x[0]), (3, 80, x[1])], &[(3, 10, x[0])])
        })
    },
];

/// Squares of lengths, each with the numerator and the denominator of its factor.
type Squares<'a> = &'a [(i64, i64, AstId)];

/// Returns the moments of a solid that is symmetric about the z-axis, across and along this axis.
fn about_axis(terms: &mut TermWriter<'_>, across: Squares<'_>, along: Squares<'_>) -> Triple {
    let [across, along] = [across, along].map(|parts| fraction_of_squares(terms, parts));
    [across, across, along]
}

/// Returns Σ n/d x².
fn fraction_of_squares(terms: &mut TermWriter<'_>, parts: Squares<'_>) -> AstId {
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
