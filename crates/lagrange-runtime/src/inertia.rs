//! Moments of inertia and centres of mass of plane and solid bodies.
//!
//! Every moment of inertia in this module is J = ∫ (X² + Y²) dm of a homogeneous body with the mass
//! `mass`. Its axis passes through the *centre of mass*, normal to the plane of motion. The unit is
//! kg m² for masses in kg and lengths in m. For a prismatic body of height h and density γ, J is γ
//! h times the polar second moment of its area. [`steiner`] shifts it to a parallel axis;
//! [`MassGeometry`] combines parts and holes into bodies.
//!
//! If the centre of mass is not obvious, a function ending in `_center` returns it in the body's
//! own coordinates, as defined by [`Outline`](crate::scene::Outline). The language of `system!` has
//! the same functions.
//!
//! NaN stays NaN, and NaN is returned for impossible shapes, such as a triangle with a side longer
//! than the other two together. Signs of lengths are irrelevant unless stated otherwise.
//!
//! ```
//! use lagrange::inertia::{MassGeometry, disk, rectangle, semicircular_disk, semicircular_disk_center};
//!
//! assert!((semicircular_disk(1.0, 1.0_f64) - 0.319_873_451_3).abs() < 1e-10);
//! assert!((semicircular_disk_center(1.0_f64)[1] - 0.424_413_181_6).abs() < 1e-10);
//!
//! // A plate with a round hole beside its middle.
//! let plate = MassGeometry::new(3.0, [0.0, 0.0], rectangle(3.0, 2.0, 1.0));
//! let hole = MassGeometry::new(0.3, [0.5, 0.0], disk(0.3, 0.25_f64));
//! let rest = plate.without(hole);
//! assert!((rest.mass - 2.7).abs() < 1e-15);
//! assert!(rest.center[0] < 0.0 && rest.inertia < plate.inertia);
//! ```
//!
//! Sources: Meriam, Kraige, *Engineering Mechanics: Dynamics*, app. B and table D/4; for polygons
//! Steger, *On the calculation of arbitrary moments of polygons* (1996).

mod compound;
mod polygon;
mod solids;

pub use self::compound::MassGeometry;
pub use self::polygon::{polygon, polygon_center};
pub use self::solids::{
    circular_sector, circular_sector_center, cuboid, disk, ellipse, hollow_cylinder, hollow_sphere,
    point_mass, rectangle, regular_polygon, right_triangle, right_triangle_center, rod, semicircular_disk,
    semicircular_disk_center, slender_rod, slender_rod_end, solid_cylinder, solid_sphere, steiner, thin_ring,
    thin_sphere, triangle, triangle_center,
};
