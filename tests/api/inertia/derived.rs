//! Each formula against the integral over the area or the volume, from the library and from the
//! table of the language.

use std::f64::consts::{PI, TAU};

use lagrange_core::solids::SOLIDS;

use super::assert_same;
use super::formulas::both;
use super::quadrature::{Element, Measured, measure};

/// A solid with given dimensions, or corners for a polygon, and its integrals.
struct Case {
    name: &'static str,
    dimensions: Vec<f64>,
    measured: Measured,
}

fn case(name: &'static str, dimensions: &[f64], element: &dyn Fn([f64; 3]) -> Element) -> Case {
    Case { name, dimensions: dimensions.to_vec(), measured: measure(&[element]) }
}

/// Returns a sector of an elliptic ring between two fractions of the semi-axes and between two
/// angles.
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

/// Returns a triangle from its corners in counterclockwise order; lines from the first corner
/// shrink towards it.
fn triangle([a, b, c]: [[f64; 2]; 3]) -> impl Fn([f64; 3]) -> Element {
    let double_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    move |[u, v, _]| {
        let place = [0, 1].map(|i| a[i] + u * ((b[i] - a[i]) * (1.0 - v) + (c[i] - a[i]) * v));
        (place, double_area * u)
    }
}

/// Returns a spherical shell in spherical coordinates.
fn shell(inner: f64, outer: f64) -> impl Fn([f64; 3]) -> Element {
    move |[u, v, w]| {
        let radius = inner + (outer - inner) * u;
        let (sine, cosine) = (TAU * w).sin_cos();
        let ring = radius * (PI * v).sin();
        ([ring * cosine, ring * sine], (outer - inner) * PI * TAU * ring * radius)
    }
}

/// Returns the third corner of a triangle of three sides, by the law of cosines.
fn third_corner([a, b, c]: [f64; 3]) -> [f64; 2] {
    let cosine = (a * a + c * c - b * b) / (2.0 * a * c);
    [c * cosine, c * cosine.acos().sin()]
}

fn straight_cases() -> Vec<Case> {
    let rod = |[u, _, _]: [f64; 3]| ([3.0 * (u - 0.5), 0.0], 3.0);
    let rectangle = parallelogram([[3.0, 0.0], [0.0, 0.7]], [-1.5, -0.35]);
    let mut cases = vec![
        case("point_mass", &[], &|_| ([0.0; 2], 1.0)),
        case("slender_rod", &[3.0], &rod),
        case("rod", &[3.0], &rod),
        case("rectangle", &[3.0, 0.7], &rectangle),
        case("cuboid", &[3.0, 0.7], &rectangle),
        case("right_triangle", &[1.2, 0.9], &triangle([[0.0, 0.0], [1.2, 0.0], [0.0, 0.9]])),
    ];
    // An acute, an obtuse and a flat triangle.
    for sides in [[2.0, 1.7, 1.4], [1.1, 2.9, 2.0], [3.0, 2.0, 1.001]] {
        let element = triangle([[0.0, 0.0], [sides[0], 0.0], third_corner(sides)]);
        cases.push(case("triangle", &sides, &element));
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
        let dimensions = vec![f64::from(corners), 1.3];
        cases.push(Case { name: "regular_polygon", dimensions, measured: measure(&pieces) });
    }
    // A nonconvex angle profile as two rectangles, in both orientations.
    let pieces: [&dyn Fn([f64; 3]) -> Element; 2] = [
        &parallelogram([[3.0, 0.0], [0.0, 0.5]], [1.0, 2.0]),
        &parallelogram([[0.4, 0.0], [0.0, 2.0]], [1.0, 2.5]),
    ];
    let mut corners = [[1.0, 2.0], [4.0, 2.0], [4.0, 2.5], [1.4, 2.5], [1.4, 4.5], [1.0, 4.5]];
    for _ in 0..2 {
        cases.push(Case { name: "polygon", dimensions: corners.concat(), measured: measure(&pieces) });
        corners.reverse();
    }
    cases
}

fn round_cases() -> Vec<Case> {
    let r = 0.8;
    let sector = |from: f64, to: f64| elliptic([r, r], [0.0, 1.0], [from, to]);
    let disk = sector(0.0, TAU);
    let ring = |[_, v, _]: [f64; 3]| ([r * (TAU * v).cos(), r * (TAU * v).sin()], TAU * r);
    let sphere = |[_, v, w]: [f64; 3]| {
        let ring = r * (PI * v).sin();
        ([ring * (TAU * w).cos(), ring * (TAU * w).sin()], PI * TAU * r * ring)
    };
    let mut cases = vec![
        case("solid_cylinder", &[r], &disk),
        case("disk", &[r], &disk),
        case("hollow_cylinder", &[0.3, r], &elliptic([r, r], [0.3 / r, 1.0], [0.0, TAU])),
        case("thin_ring", &[r], &ring),
        case("semicircular_disk", &[r], &sector(0.0, PI)),
        case("ellipse", &[1.4, 0.6], &elliptic([1.4, 0.6], [0.0, 1.0], [0.0, TAU])),
        case("solid_sphere", &[r], &shell(0.0, r)),
        case("hollow_sphere", &[0.3, r], &shell(0.3, r)),
        case("hollow_sphere", &[0.0, r], &shell(0.0, r)),
        case("thin_sphere", &[r], &sphere),
    ];
    for angle in [0.1, 1.0, PI, 5.0, TAU] {
        cases.push(case("circular_sector", &[r, angle], &sector(-angle / 2.0, angle / 2.0)));
    }
    cases
}

fn cases() -> impl Iterator<Item = Case> {
    straight_cases().into_iter().chain(polygonal_cases()).chain(round_cases())
}

#[test]
fn formulas_are_the_integrals() {
    for case in cases() {
        let Case { name, dimensions, measured } = &case;
        let (inertia, center) = (measured.inertia / measured.mass, measured.center);
        for (found_inertia, found_center) in both(name, dimensions) {
            let what = format!("{name}{dimensions:?}");
            assert_same(&what, found_inertia, inertia, 0.0);
            assert_same(&what, found_center[0], center[0], 1.0);
            assert_same(&what, found_center[1], center[1], 1.0);
        }
    }
}

/// `tools/inertia.py` integrates symbolically and writes the file.
#[test]
fn formulas_are_those_found_by_symbolic_integration() {
    let rows = include_str!("../../references/inertia.csv").lines().skip(1);
    let mut count = 0;
    for row in rows {
        let columns = row.split(',').collect::<Vec<_>>();
        let number = |text: &str| text.parse::<f64>().expect("a number");
        let dimensions = columns[1].split_whitespace().map(number).collect::<Vec<_>>();
        let [inertia, x, y] = [2, 3, 4].map(|column| number(columns[column]));
        for (found_inertia, found_center) in both(columns[0], &dimensions) {
            for (found, expected) in [(found_inertia, inertia), (found_center[0], x), (found_center[1], y)] {
                let error = (found - expected).abs();
                assert!(error <= 2e-15 * expected.abs(), "{row}: {found}");
            }
        }
        count += 1;
    }
    assert!(count >= 28, "{count} rows");
}

#[test]
fn every_solid_of_the_language_is_derived_here() {
    let derived = cases().map(|case| case.name).collect::<Vec<_>>();
    for solid in &SOLIDS {
        assert!(derived.contains(&solid.name), "{} is not derived", solid.name);
    }
}
