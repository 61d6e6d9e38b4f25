use crate::pipeline::parse;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::expr::evaluate;
use lagrange_expr::symbol::Role;

fn statements(value: &str) -> String {
    format!(
        "param m = 2, l = 3; coord x; kinetic = kinetic_energy(m, dot(x)); output value = {value}; output other = l;"
    )
}

/// Evaluates the components of an expression with m = 2 and l = 3.
fn values(expression: &str) -> Vec<f64> {
    let model = parse(&statements(expression)).expect("a correct declaration").model;
    evaluate(&model.graph, &model.outputs[0].components, |role| match role {
        Role::Parameter(index) => [2.0, 3.0][index as usize],
        _ => f64::NAN,
    })
}

fn mistakes(expression: &str) -> String {
    parse(&statements(expression)).err().as_ref().map(Report::to_string).unwrap_or_default()
}

#[track_caller]
fn assert_values(expression: &str, expected: &[f64]) {
    let found = values(expression);
    assert_eq!(found.len(), expected.len(), "{expression}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() <= 1e-14 * expected.abs().max(1.0),
            "{expression} is {found}, not {expected}"
        );
    }
}

#[test]
fn solids_have_moments_of_inertia_and_centres_by_name() {
    assert_values("point_mass(m)", &[0.0]);
    assert_values("slender_rod(m, l)", &[1.5]);
    assert_values("rod(m, l) + disk(m, l)", &[1.5 + 9.0]);
    assert_values("slender_rod_end(m, l)", &[6.0]);
    assert_values("polygon(m, (0, 0), (l, 0), (0, l))", &[2.0]);
    assert_values("polygon_center((0, 0), (l, 0), (0, l))", &[1.0, 1.0]);
    assert_values("right_triangle_center(l, 6)", &[1.0, 2.0]);
    assert_values("triangle_center(l, 5, 4)", &[1.0, 4.0 / 3.0]);
    assert_values("circular_sector_center(l, pi).x - semicircular_disk_center(l).y", &[0.0]);
    assert_values("m.slender_rod(l)", &[1.5]);
}

#[test]
fn the_parallel_axis_theorem_takes_a_rod_from_its_centre_to_its_end() {
    assert_values("steiner(slender_rod(m, l), m, l / 2) - slender_rod_end(m, l)", &[0.0]);
}

#[test]
fn wrong_numbers_of_arguments_are_answered_with_the_usage() {
    for (call, usage) in [
        (
            "rectangle(m, l)",
            "`rectangle` takes 3 arguments, but 2 are given\n  help: write `rectangle(m, a, b)`",
        ),
        ("point_mass()", "`point_mass` takes 1 argument, but none is given\n  help: write `point_mass(m)`"),
        ("hollow_cylinder(m)", "write `hollow_cylinder(m, inner, outer)`"),
        ("triangle_center(l)", "write `triangle_center(a, b, c)`"),
        ("steiner(m, l)", "write `steiner(j, m, r)`"),
        ("slender_rod_end(m)", "write `slender_rod_end(m, l)`"),
        (
            "polygon(m, (0, 0))",
            "`polygon` takes at least 4 arguments, but only 2 are given\n  help: write `polygon(m, p1, p2, p3, …)`",
        ),
        ("polygon_center()", "`polygon_center` takes at least 3 arguments, but none is given"),
    ] {
        assert!(mistakes(call).contains(usage), "{}", mistakes(call));
    }
}

#[test]
fn arguments_of_the_wrong_kind_are_refused() {
    for (call, message) in [
        ("disk(m, (1, 2))", "an argument of `disk` must be a scalar"),
        ("polygon(m, (0, 0), (1, 0), l)", "a corner of `polygon` must be a vector, but this is a scalar"),
        (
            "polygon(m, (0, 0), (1, 0), (0, 1, 0))",
            "must be a vector of 2 components, but this is a vector of 3",
        ),
        ("polygon((0, 0), (1, 0), (0, 1), (1, 1))", "an argument of `polygon` must be a scalar"),
    ] {
        assert!(mistakes(call).contains(message), "{}", mistakes(call));
    }
}

#[test]
fn solids_that_do_not_exist_are_refused_where_their_size_is_known() {
    for call in [
        "triangle(m, 1, 2, 4)",
        "triangle_center(1, 2, 4)",
        "hollow_cylinder(m, 2, 1)",
        "hollow_sphere(m, 0, 0)",
        "circular_sector(m, l, 0)",
        "circular_sector(m, 1, 0)",
        "hollow_cylinder(m, -1, l)",
        "triangle(m, l, -1, l)",
        "circular_sector(m, 1, 360)",
        "regular_polygon(m, 2, 1)",
        "regular_polygon(m, 5/2, 1)",
        "polygon(m, (0, 0), (1, 1), (2, 2))",
        "slender_rod(m, -1)",
    ] {
        assert!(
            mistakes(call).contains("cannot have these dimensions\n  help: "),
            "{call}: {}",
            mistakes(call)
        );
    }
    assert!(mistakes("disk(m, ln(-1))").contains("this is not a real number"));
    for call in [
        "triangle(m, 1, 2, 3)",
        "regular_polygon(m, 6, 1)",
        "hollow_sphere(m, 1, 1)",
        "circular_sector(m, 1, 2*pi)",
    ] {
        assert_eq!(mistakes(call), "");
    }
}

#[test]
fn names_of_solids_are_free() {
    let text = "param disk = 2, rod = 3; coord polygon; kinetic = kinetic_energy(disk, dot(polygon));
        let triangle = disk(disk, rod); output steiner = triangle;";
    assert_eq!(parse(text).err().as_ref().map(Report::to_string), None);
}

#[test]
fn unknown_solids_are_answered_with_the_nearest_function() {
    assert!(mistakes("solid_cilinder(m, l)").contains("did you mean `solid_cylinder`?"));
    assert!(mistakes("disk").contains("the function `disk` needs arguments: `disk(…)`"));
}
