//! Moments of inertia and centres of mass of a solid by name, from the library and from the table
//! of the language.

use lagrange::inertia;
use lagrange_core::expr::Graph;
use lagrange_core::expr::evaluate;
use lagrange_core::solids;
use lagrange_core::symbol::Role;

/// The moment of inertia for a mass of one, and the centre of mass.
type Geometry = (f64, [f64; 2]);

/// Returns the geometry of a solid from the library and from the language.
pub(super) fn both(name: &str, dimensions: &[f64]) -> [Geometry; 2] {
    [of_library(name, dimensions), of_language(name, dimensions)]
}

fn of_library(name: &str, dimensions: &[f64]) -> Geometry {
    let origin = [0.0; 2];
    match (name, dimensions) {
        ("point_mass", []) => (inertia::point_mass(1.0), origin),
        ("slender_rod", &[l]) => (inertia::slender_rod(1.0, l), origin),
        ("rod", &[l]) => (inertia::rod(1.0, l), origin),
        ("solid_cylinder", &[r]) => (inertia::solid_cylinder(1.0, r), origin),
        ("disk", &[r]) => (inertia::disk(1.0, r), origin),
        ("hollow_cylinder", &[inner, outer]) => (inertia::hollow_cylinder(1.0, inner, outer), origin),
        ("thin_ring", &[r]) => (inertia::thin_ring(1.0, r), origin),
        ("rectangle", &[a, b]) => (inertia::rectangle(1.0, a, b), origin),
        ("cuboid", &[a, b]) => (inertia::cuboid(1.0, a, b), origin),
        ("semicircular_disk", &[r]) => {
            (inertia::semicircular_disk(1.0, r), inertia::semicircular_disk_center(r))
        }
        ("circular_sector", &[r, angle]) => {
            (inertia::circular_sector(1.0, r, angle), inertia::circular_sector_center(r, angle))
        }
        ("right_triangle", &[a, b]) => {
            (inertia::right_triangle(1.0, a, b), inertia::right_triangle_center(a, b))
        }
        ("triangle", &[a, b, c]) => (inertia::triangle(1.0, a, b, c), inertia::triangle_center(a, b, c)),
        ("ellipse", &[a, b]) => (inertia::ellipse(1.0, a, b), origin),
        ("regular_polygon", &[n, r]) => (inertia::regular_polygon(1.0, n as u32, r), origin),
        ("solid_sphere", &[r]) => (inertia::solid_sphere(1.0, r), origin),
        ("hollow_sphere", &[inner, outer]) => (inertia::hollow_sphere(1.0, inner, outer), origin),
        ("thin_sphere", &[r]) => (inertia::thin_sphere(1.0, r), origin),
        ("polygon", coordinates) => {
            let corners =
                coordinates.chunks_exact(2).map(|corner| [corner[0], corner[1]]).collect::<Vec<_>>();
            (inertia::polygon(1.0, &corners), inertia::polygon_center(&corners))
        }
        _ => panic!("the library has no {name}{dimensions:?}"),
    }
}

fn of_language(name: &str, dimensions: &[f64]) -> Geometry {
    let solid = solids::by_name(name).expect("a solid of the language");
    let mut graph = Graph::new();
    let symbols = (0..dimensions.len() as u32).map(|i| graph.symbol(&format!("d{i}"), Role::Parameter(i)));
    let symbols = symbols.collect::<Vec<_>>();
    let mut roots = vec![(solid.inertia)(&mut graph, &symbols)];
    roots.extend(solid.centroid.into_iter().flat_map(|center| center(&mut graph, &symbols)));
    let values = evaluate(&graph, &roots, |role| match role {
        Role::Parameter(index) => dimensions[index as usize],
        _ => f64::NAN,
    });
    let center = if roots.len() == 3 { [values[1], values[2]] } else { [0.0; 2] };
    (values[0], center)
}
