//! Solids with known moments of inertia: one row each.
//!
//! The coordinates of a solid are those of `lagrange::scene::Outline`. Moments of inertia are about
//! the axis through the centre of mass, normal to the plane, for a mass of one: squares of lengths.
//!
//! Sources: Meriam, Kraige, *Engineering Mechanics: Dynamics*, table D/4, for all but polygons; for
//! those Steger, *On the calculation of arbitrary moments of polygons* (1996).
//! `tests/api/inertia.rs` of `lagrange` derives each by integration.

mod formulas;
mod polygon;

use crate::diagnostics;
use crate::expr::{ExprId, Graph};
use formulas::{
    about_center, fraction, hollow_sphere, regular_polygon, sector_center, semicircular_center,
    sum_of_squares, triangle_center,
};
pub use polygon::double_area;

/// Formula for a quantity that follows from the size of a solid.
pub type Formula<T> = fn(&mut Graph, &[ExprId]) -> T;

/// A solid that inertia functions and shapes can refer to.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// Its name: that of the function `name(m, …)` and of the shape `name(…)`.
    pub name: &'static str,
    /// Dimensions that give its size.
    pub dimensions: Dimensions,
    /// Moment of inertia about the centre of mass for a mass of one, a function with one scalar per
    /// dimension. Corners contribute their coordinates, one corner after the other, in either
    /// orientation.
    pub inertia: Formula<ExprId>,
    /// Centre of mass in the solid's coordinates, from the same scalars; `None` for the origin.
    pub centroid: Option<Formula<[ExprId; 2]>>,
    /// True if no solid has these dimensions. NaN represents a dimension that is not yet known.
    pub is_impossible: fn(&[f64]) -> bool,
    /// Condition that must hold instead, as text for users.
    pub condition: &'static str,
    /// The variant of `lagrange::scene::Outline` for drawing, which has the same dimensions.
    pub outline: &'static str,
    /// The dimension that is the radius on which it rolls, if it is round.
    pub radius: Option<usize>,
}

/// Dimensions of a solid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dimensions {
    /// Scalars with these names.
    Scalars(&'static [&'static str]),
    /// Corners, at least [`FEWEST_CORNERS`], each a vector.
    Corners,
}

/// Minimum number of corners of a polygon.
pub const FEWEST_CORNERS: usize = 3;

impl Dimensions {
    /// True if this is the correct number of dimensions.
    pub fn accept(self, count: usize) -> bool {
        match self {
            Dimensions::Scalars(names) => count == names.len(),
            Dimensions::Corners => count >= FEWEST_CORNERS,
        }
    }

    /// Returns the spelling in a call.
    pub fn written(self) -> String {
        match self {
            Dimensions::Scalars(names) => names.join(", "),
            Dimensions::Corners => "p1, p2, p3, …".to_owned(),
        }
    }
}

impl Solid {
    /// Creates a solid with these lengths that has its centre of mass at the origin and does not
    /// roll.
    const fn new(
        name: &'static str,
        lengths: &'static [&'static str],
        outline: &'static str,
        inertia: Formula<ExprId>,
    ) -> Self {
        Solid {
            name,
            dimensions: Dimensions::Scalars(lengths),
            inertia,
            centroid: None,
            is_impossible: has_negative,
            condition: LENGTHS,
            outline,
            radius: None,
        }
    }

    /// Returns the spelling as a shape: `rectangle(a, b)`.
    pub fn shape_usage(&self) -> String {
        format!("{}({})", self.name, self.dimensions.written())
    }

    /// Returns the call of its moment of inertia: `rectangle(m, a, b)`.
    pub fn inertia_usage(&self) -> String {
        match self.dimensions {
            Dimensions::Scalars([]) => format!("{}(m)", self.name),
            dimensions => format!("{}(m, {})", self.name, dimensions.written()),
        }
    }

    /// Returns the call of its centre of mass: `triangle_center(a, b, c)`.
    pub fn center_usage(&self) -> String {
        format!("{}{CENTER_SUFFIX}({})", self.name, self.dimensions.written())
    }

    /// Returns the name of the function for its centre of mass, if that is not the origin:
    /// `triangle_center`.
    pub fn center_function(&self) -> Option<String> {
        self.centroid.map(|_| format!("{}{CENTER_SUFFIX}", self.name))
    }
}

/// Suffix that turns the name of a solid into the name of the function for its centre of mass.
const CENTER_SUFFIX: &str = "_center";

/// Returns the solid of this name.
pub fn by_name(name: &str) -> Option<&'static Solid> {
    SOLIDS.iter().find(|solid| solid.name == name)
}

/// Returns the solid whose centre of mass is a function of this name.
pub fn by_center_function(name: &str) -> Option<&'static Solid> {
    by_name(name.strip_suffix(CENTER_SUFFIX)?).filter(|solid| solid.centroid.is_some())
}

/// Returns the name of the solid that was probably intended.
pub fn nearest(name: &str) -> Option<&'static str> {
    diagnostics::nearest(name, SOLIDS.iter().map(|solid| solid.name))
}

const SLENDER_ROD: Solid =
    Solid::new("slender_rod", &["l"], "SlenderRod", |g, x| sum_of_squares(g, x, 1, 12));

const SOLID_CYLINDER: Solid = Solid {
    radius: Some(0),
    ..Solid::new("solid_cylinder", &["r"], "Disk", |g, x| sum_of_squares(g, x, 1, 2))
};

const RECTANGLE: Solid =
    Solid::new("rectangle", &["a", "b"], "Rectangle", |g, x| sum_of_squares(g, x, 1, 12));

const LENGTHS: &str = "lengths are not negative";
const INNER_AND_OUTER: &str =
    "the inner radius comes first; radii are not negative, and the outer one is the larger";

fn has_negative(x: &[f64]) -> bool {
    x.iter().any(|&length| length < 0.0)
}

/// Every solid; other names of one follow it.
pub const SOLIDS: [Solid; 19] = [
    Solid::new("point_mass", &[], "PointMass", |g, _| g.number(0)),
    SLENDER_ROD,
    Solid { name: "rod", ..SLENDER_ROD },
    SOLID_CYLINDER,
    Solid { name: "disk", ..SOLID_CYLINDER },
    Solid {
        is_impossible: |x| has_negative(x) || x[0] > x[1],
        condition: INNER_AND_OUTER,
        radius: Some(1),
        ..Solid::new("hollow_cylinder", &["inner", "outer"], "Annulus", |g, x| sum_of_squares(g, x, 1, 2))
    },
    Solid { radius: Some(0), ..Solid::new("thin_ring", &["r"], "Ring", |g, x| g.square(x[0])) },
    RECTANGLE,
    Solid { name: "cuboid", ..RECTANGLE },
    Solid {
        centroid: Some(semicircular_center),
        ..Solid::new("semicircular_disk", &["r"], "SemicircularDisk", |g, x| {
            let [_, s] = semicircular_center(g, x);
            about_center(g, x[0], s)
        })
    },
    Solid {
        centroid: Some(sector_center),
        is_impossible: |x| x[0] < 0.0 || x[1] <= 0.0 || x[1] > std::f64::consts::TAU,
        condition: "the radius is a length, and the angle is positive and no more than a full turn, in radians",
        ..Solid::new("circular_sector", &["r", "angle"], "CircularSector", |g, x| {
            let [s, _] = sector_center(g, x);
            about_center(g, x[0], s)
        })
    },
    Solid {
        centroid: Some(|g, x| [0, 1].map(|i| fraction(g, 1, x[i], 3))),
        ..Solid::new("right_triangle", &["a", "b"], "RightTriangle", |g, x| sum_of_squares(g, x, 1, 18))
    },
    Solid {
        centroid: Some(triangle_center),
        is_impossible: |x| has_negative(x) || x.iter().any(|&side| 2.0 * side > x.iter().sum()),
        condition: "sides are lengths, and none is longer than the other two together",
        ..Solid::new("triangle", &["a", "b", "c"], "Triangle", |g, x| sum_of_squares(g, x, 1, 36))
    },
    Solid::new("ellipse", &["a", "b"], "Ellipse", |g, x| sum_of_squares(g, x, 1, 4)),
    Solid {
        is_impossible: |x| has_negative(x) || x[0] < 3.0 || x[0].fract() > 0.0,
        condition: "the first number is that of corners, a whole number from 3 upwards, the second the radius of the circle on which they lie",
        ..Solid::new("regular_polygon", &["n", "r"], "RegularPolygon", regular_polygon)
    },
    Solid {
        radius: Some(0),
        ..Solid::new("solid_sphere", &["r"], "Disk", |g, x| sum_of_squares(g, x, 2, 5))
    },
    Solid {
        is_impossible: |x| has_negative(x) || x[0] > x[1] || x[1] <= 0.0,
        condition: INNER_AND_OUTER,
        radius: Some(1),
        ..Solid::new("hollow_sphere", &["inner", "outer"], "Annulus", hollow_sphere)
    },
    Solid { radius: Some(0), ..Solid::new("thin_sphere", &["r"], "Ring", |g, x| sum_of_squares(g, x, 2, 3)) },
    Solid {
        name: "polygon",
        dimensions: Dimensions::Corners,
        inertia: polygon::inertia,
        centroid: Some(polygon::center),
        is_impossible: |_| false,
        condition: "corners are given in their order around the polygon and enclose an area",
        outline: "Polygon",
        radius: None,
    },
];

#[cfg(test)]
mod tests;
