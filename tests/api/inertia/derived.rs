//! Each formula against the integral over the area or the volume, in the library and in the table of the language.

use std::f64::consts::{PI, TAU};

use lagrange::inertia;
use lagrange_core::calculus::evaluate;
use lagrange_core::expr::Graph;
use lagrange_core::solids::{self, SOLIDS};
use lagrange_core::symbol::Role;

use super::assert_same;
use super::quadrature::{Element, Measured, measure};

const MASS: f64 = 2.5;

/// A solid of certain dimensions, what the library says of it, and what integration finds.
struct Case {
    name: &'static str,
    dimensions: Vec<f64>,
    inertia: f64,
    center: [f64; 2],
    measured: Measured,
}

fn case(
    name: &'static str,
    dimensions: &[f64],
    inertia: f64,
    center: [f64; 2],
    element: &dyn Fn([f64; 3]) -> Element,
) -> Case {
    Case { name, dimensions: dimensions.to_vec(), inertia, center, measured: measure(&[element]) }
}

/// A sector of an elliptic ring between two fractions of the semi-axes and between two angles.
fn elliptic(axes: [f64; 2], fractions: [f64; 2], angles: [f64; 2]) -> impl Fn([f64; 3]) -> Element {
    move |[u, v, _]| {
        let fraction = fractions[0] + (fractions[1] - fractions[0]) * u;
        let (sine, cosine) = (angles[0] + (angles[1] - angles[0]) * v).sin_cos();
        let area = axes[0] * axes[1] * (fractions[1] - fractions[0]) * (angles[1] - angles[0]) * fraction;
        ([axes[0] * fraction * cosine, axes[1] * fraction * sine], area)
    }
}

fn parallelogram(sides: [[f64; 2]; 2], corner: [f64; 2]) -> impl Fn([f64; 3]) -> Element {
    let area = sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0];
    move |[u, v, _]| ([0, 1].map(|axis| corner[axis] + u * sides[0][axis] + v * sides[1][axis]), area)
}

/// A triangle from its corners in counterclockwise order; lines from the first corner shrink towards it.
fn triangle([a, b, c]: [[f64; 2]; 3]) -> impl Fn([f64; 3]) -> Element {
    let double_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    move |[u, v, _]| {
        let place = [0, 1].map(|i| a[i] + u * ((b[i] - a[i]) * (1.0 - v) + (c[i] - a[i]) * v));
        (place, double_area * u)
    }
}

/// A spherical shell in spherical coordinates.
fn shell(inner: f64, outer: f64) -> impl Fn([f64; 3]) -> Element {
    move |[u, v, w]| {
        let radius = inner + (outer - inner) * u;
        let (sine, cosine) = (TAU * w).sin_cos();
        let ring = radius * (PI * v).sin();
        ([ring * cosine, ring * sine], (outer - inner) * PI * TAU * ring * radius)
    }
}

/// The third corner of a triangle of three sides, by the law of cosines.
fn third_corner([a, b, c]: [f64; 3]) -> [f64; 2] {
    let cosine = (a * a + c * c - b * b) / (2.0 * a * c);
    [c * cosine, c * cosine.acos().sin()]
}

fn straight_cases() -> Vec<Case> {
    let rod = |[u, _, _]: [f64; 3]| ([3.0 * (u - 0.5), 0.0], 3.0);
    let rectangle = parallelogram([[3.0, 0.0], [0.0, 0.7]], [-1.5, -0.35]);
    let right = triangle([[0.0, 0.0], [1.2, 0.0], [0.0, 0.9]]);
    let right_center = inertia::right_triangle_center(1.2, 0.9);
    let mut cases = vec![
        case("point_mass", &[], inertia::point_mass(MASS), [0.0; 2], &|_| ([0.0; 2], 1.0)),
        case("slender_rod", &[3.0], inertia::slender_rod(MASS, 3.0), [0.0; 2], &rod),
        case("rod", &[3.0], inertia::rod(MASS, 3.0), [0.0; 2], &rod),
        case("rectangle", &[3.0, 0.7], inertia::rectangle(MASS, 3.0, 0.7), [0.0; 2], &rectangle),
        case("cuboid", &[3.0, 0.7], inertia::cuboid(MASS, 3.0, 0.7), [0.0; 2], &rectangle),
        case("right_triangle", &[1.2, 0.9], inertia::right_triangle(MASS, 1.2, 0.9), right_center, &right),
    ];
    // An acute, an obtuse and a flat one.
    for sides in [[2.0, 1.7, 1.4], [1.1, 2.9, 2.0], [3.0, 2.0, 1.001]] {
        let [a, b, c] = sides;
        let element = triangle([[0.0, 0.0], [a, 0.0], third_corner(sides)]);
        let center = inertia::triangle_center(a, b, c);
        cases.push(case("triangle", &sides, inertia::triangle(MASS, a, b, c), center, &element));
    }
    cases
}

fn polygonal_cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for corners in [3, 4, 5, 6, 17] {
        let at = |i: u32| {
            let (sine, cosine) = (TAU * f64::from(i) / f64::from(corners)).sin_cos();
            [1.3 * cosine, 1.3 * sine]
        };
        let pieces = (0..corners).map(|i| triangle([[0.0, 0.0], at(i), at(i + 1)])).collect::<Vec<_>>();
        let pieces = pieces.iter().map(|piece| piece as &dyn Fn([f64; 3]) -> Element).collect::<Vec<_>>();
        let inertia = inertia::regular_polygon(MASS, corners, 1.3);
        let dimensions = vec![f64::from(corners), 1.3];
        cases.push(Case {
            name: "regular_polygon",
            dimensions,
            inertia,
            center: [0.0; 2],
            measured: measure(&pieces),
        });
    }
    // An angle profile, which is not convex, as two rectangles, in both orientations.
    let pieces: [&dyn Fn([f64; 3]) -> Element; 2] = [
        &parallelogram([[3.0, 0.0], [0.0, 0.5]], [1.0, 2.0]),
        &parallelogram([[0.4, 0.0], [0.0, 2.0]], [1.0, 2.5]),
    ];
    let mut corners = [[1.0, 2.0], [4.0, 2.0], [4.0, 2.5], [1.4, 2.5], [1.4, 4.5], [1.0, 4.5]];
    for _ in 0..2 {
        cases.push(Case {
            name: "polygon",
            dimensions: corners.concat(),
            inertia: inertia::polygon(MASS, &corners),
            center: inertia::polygon_center(&corners),
            measured: measure(&pieces),
        });
        corners.reverse();
    }
    cases
}

fn round_cases() -> Vec<Case> {
    let r = 0.8;
    let disk = elliptic([r, r], [0.0, 1.0], [0.0, TAU]);
    let annulus = elliptic([r, r], [0.3 / r, 1.0], [0.0, TAU]);
    let ring = |[_, v, _]: [f64; 3]| ([r * (TAU * v).cos(), r * (TAU * v).sin()], TAU * r);
    let half = elliptic([r, r], [0.0, 1.0], [0.0, PI]);
    let half_center = inertia::semicircular_disk_center(r);
    let sphere = |[_, v, w]: [f64; 3]| {
        let ring = r * (PI * v).sin();
        ([ring * (TAU * w).cos(), ring * (TAU * w).sin()], PI * TAU * r * ring)
    };
    let mut cases = vec![
        case("solid_cylinder", &[r], inertia::solid_cylinder(MASS, r), [0.0; 2], &disk),
        case("disk", &[r], inertia::disk(MASS, r), [0.0; 2], &disk),
        case("hollow_cylinder", &[0.3, r], inertia::hollow_cylinder(MASS, 0.3, r), [0.0; 2], &annulus),
        case("thin_ring", &[r], inertia::thin_ring(MASS, r), [0.0; 2], &ring),
        case("semicircular_disk", &[r], inertia::semicircular_disk(MASS, r), half_center, &half),
        case("solid_sphere", &[r], inertia::solid_sphere(MASS, r), [0.0; 2], &shell(0.0, r)),
        case("hollow_sphere", &[0.3, r], inertia::hollow_sphere(MASS, 0.3, r), [0.0; 2], &shell(0.3, r)),
        case("hollow_sphere", &[0.0, r], inertia::hollow_sphere(MASS, 0.0, r), [0.0; 2], &shell(0.0, r)),
        case("thin_sphere", &[r], inertia::thin_sphere(MASS, r), [0.0; 2], &sphere),
    ];
    let ellipse = elliptic([1.4, 0.6], [0.0, 1.0], [0.0, TAU]);
    cases.push(case("ellipse", &[1.4, 0.6], inertia::ellipse(MASS, 1.4, 0.6), [0.0; 2], &ellipse));
    for angle in [0.1, 1.0, PI, 5.0, TAU] {
        let element = elliptic([r, r], [0.0, 1.0], [-angle / 2.0, angle / 2.0]);
        let center = inertia::circular_sector_center(r, angle);
        cases.push(case(
            "circular_sector",
            &[r, angle],
            inertia::circular_sector(MASS, r, angle),
            center,
            &element,
        ));
    }
    cases
}

fn cases() -> impl Iterator<Item = Case> {
    straight_cases().into_iter().chain(polygonal_cases()).chain(round_cases())
}

/// Moment of inertia for a mass of one and centre of mass by the table of the language.
fn of_language(case: &Case) -> (f64, [f64; 2]) {
    let solid = solids::by_name(case.name).expect("a solid of the language");
    let mut graph = Graph::new();
    let symbols =
        (0..case.dimensions.len() as u32).map(|i| graph.symbol(&format!("d{i}"), Role::Parameter(i)));
    let symbols = symbols.collect::<Vec<_>>();
    let mut roots = vec![(solid.inertia)(&mut graph, &symbols)];
    roots.extend(solid.centroid.into_iter().flat_map(|center| center(&mut graph, &symbols)));
    let values = evaluate(&graph, &roots, |role| match role {
        Role::Parameter(index) => case.dimensions[index as usize],
        _ => f64::NAN,
    });
    let center = if roots.len() == 3 { [values[1], values[2]] } else { [0.0; 2] };
    (values[0], center)
}

#[test]
fn formulas_of_the_library_are_the_integrals() {
    for case in cases() {
        let expected = MASS * case.measured.inertia / case.measured.mass;
        let what = format!("{}{:?}", case.name, case.dimensions);
        assert_same(&what, case.inertia, expected, 0.0);
        for axis in [0, 1] {
            assert_same(&what, case.center[axis], case.measured.center[axis], 1.0);
        }
    }
}

#[test]
fn formulas_of_the_language_are_the_integrals() {
    for case in cases() {
        let (inertia, center) = of_language(&case);
        let what = format!("{}{:?}", case.name, case.dimensions);
        assert_same(&what, inertia, case.measured.inertia / case.measured.mass, 0.0);
        for axis in [0, 1] {
            assert_same(&what, center[axis], case.measured.center[axis], 1.0);
        }
    }
}

#[test]
fn every_solid_of_the_language_is_derived_here() {
    let derived = cases().map(|case| case.name).collect::<Vec<_>>();
    for solid in &SOLIDS {
        assert!(derived.contains(&solid.name), "{} is not derived", solid.name);
    }
}
