use super::{Dimensions, SOLIDS, by_center_function, by_name, nearest, polygon};
use crate::expr::evaluate;
use crate::expr::{ExprId, Graph};
use crate::number::Number;

/// Evaluates a formula for exact decimals.
fn value(text: &[&str], formula: impl Fn(&mut Graph, &[ExprId]) -> Vec<ExprId>) -> Vec<f64> {
    let mut graph = Graph::new();
    let number = |text: &&str| Number::parse_decimal(text.trim_start_matches('-')).expect("a decimal");
    let signed = |text: &&str| if text.starts_with('-') { -&number(text) } else { number(text) };
    let numbers = text.iter().map(|text| graph.number(signed(text))).collect::<Vec<_>>();
    let roots = formula(&mut graph, &numbers);
    evaluate(&graph, &roots, |_| f64::NAN)
}

fn inertia(name: &str, dimensions: &[&str]) -> f64 {
    let solid = by_name(name).expect("a solid");
    value(dimensions, |graph, x| vec![(solid.inertia)(graph, x)])[0]
}

fn center(name: &str, dimensions: &[&str]) -> Vec<f64> {
    let centroid = by_name(name).and_then(|solid| solid.centroid).expect("a centre");
    value(dimensions, |graph, x| centroid(graph, x).to_vec())
}

#[track_caller]
fn assert_close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-15 * expected.abs().max(1.0), "{found} is not {expected}");
}

#[test]
fn names_are_unique_and_found() {
    for solid in &SOLIDS {
        assert_eq!(SOLIDS.iter().filter(|other| other.name == solid.name).count(), 1, "{}", solid.name);
        let center = solid.center_function().and_then(|name| by_center_function(&name));
        assert_eq!(center.map(|found| found.name), solid.centroid.map(|_| solid.name));
    }
    assert!(by_name("banana").is_none());
    assert!(by_center_function("disk_center").is_none());
    assert_eq!(nearest("semicircle_disk"), Some("semicircular_disk"));
}

#[test]
fn radii_are_dimensions() {
    for solid in &SOLIDS {
        let count = match solid.dimensions {
            Dimensions::Scalars(names) => names.len(),
            Dimensions::Corners => 0,
        };
        assert!(solid.radius.is_none_or(|index| index < count), "{}", solid.name);
    }
}

#[test]
fn the_half_disk_is_a_sector_of_half_a_turn() {
    assert!((inertia("semicircular_disk", &["1"]) - 0.319_873_451_3).abs() < 5e-11);
    let sector = by_name("circular_sector").expect("a solid");
    let of_half_turn = value(&["1"], |graph, x| {
        vec![{
            let pi = graph.pi();
            (sector.inertia)(graph, &[x[0], pi])
        }]
    });
    assert_close(of_half_turn[0], inertia("semicircular_disk", &["1"]));
}

#[test]
fn polygons_have_the_inertia_of_the_solids_they_are() {
    let corners = ["1", "2", "4", "2", "4", "4", "1", "4"];
    assert_close(inertia("polygon", &corners), inertia("rectangle", &["3", "2"]));
    let center_of_rectangle = center("polygon", &corners);
    assert_close(center_of_rectangle[0], 2.5);
    assert_close(center_of_rectangle[1], 3.0);
    let clockwise = ["0", "0", "0", "4", "3", "0"];
    assert_close(inertia("polygon", &clockwise), inertia("right_triangle", &["3", "4"]));
    assert_close(inertia("polygon", &clockwise), inertia("triangle", &["3", "5", "4"]));
    let centers = [
        center("polygon", &clockwise),
        center("right_triangle", &["3", "4"]),
        center("triangle", &["3", "5", "4"]),
    ];
    for found in centers {
        assert_close(found[0], 1.0);
        assert_close(found[1], 4.0 / 3.0);
    }
    assert_close(inertia("regular_polygon", &["4", "1"]), 1.0 / 3.0);
}

#[test]
fn the_area_of_a_polygon_has_the_sign_of_its_orientation() {
    let area = |corners: &[&str]| value(corners, |graph, x| vec![polygon::double_area(graph, x)])[0];
    assert_close(area(&["1", "1", "3", "1", "1", "4"]), 6.0);
    assert_close(area(&["1", "1", "1", "4", "3", "1"]), -6.0);
    assert_close(area(&["1", "1", "2", "2", "-3", "-3"]), 0.0);
}

#[test]
fn a_hollow_sphere_is_between_a_solid_and_a_thin_one() {
    assert_close(inertia("hollow_sphere", &["0", "2"]), inertia("solid_sphere", &["2"]));
    assert_close(inertia("hollow_sphere", &["2", "2"]), inertia("thin_sphere", &["2"]));
}

#[test]
fn calls_are_written_with_the_names_of_dimensions() {
    let usage = |name: &str| by_name(name).map(|solid| (solid.shape_usage(), solid.inertia_usage()));
    let written = |shape: &str, inertia: &str| Some((shape.to_owned(), inertia.to_owned()));
    assert_eq!(usage("point_mass"), written("point_mass()", "point_mass(m)"));
    assert_eq!(usage("cuboid"), written("cuboid(a, b)", "cuboid(m, a, b)"));
    assert_eq!(usage("polygon"), written("polygon(p1, p2, p3, …)", "polygon(m, p1, p2, p3, …)"));
}
