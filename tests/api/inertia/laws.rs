//! Laws of all moments of inertia, and textbook results that follow.

use std::f64::consts::{PI, TAU};

use lagrange::inertia::{
    circular_sector, hollow_cylinder, hollow_sphere, polygon, polygon_center, regular_polygon,
    semicircular_disk, semicircular_disk_center, slender_rod, slender_rod_end, solid_cylinder, solid_sphere,
    steiner, triangle, triangle_center,
};

use super::assert_same;
use super::quadrature::{Element, measure, moment};

const M: f64 = 2.5;
const R: f64 = 0.8;

fn half_disk([u, v, _]: [f64; 3]) -> Element {
    let (sine, cosine) = (PI * v).sin_cos();
    ([R * u * cosine, R * u * sine], PI * R * R * u)
}

/// Returns scattered numbers between −1 and 1: fractional parts of multiples of the golden ratio.
fn scattered() -> impl Iterator<Item = f64> {
    (1..).map(|i| 2.0 * (f64::from(i) * 0.618_033_988_749_894_9).fract() - 1.0)
}

#[test]
fn the_moment_of_inertia_is_smallest_about_the_centre_of_mass() {
    let about_center = measure(&[&half_disk]);
    let mut numbers = scattered();
    for _ in 0..8 {
        let point = [numbers.next().expect("a number"), numbers.next().expect("a number")];
        let about_point = moment(point, &half_disk);
        assert!(about_center.inertia < about_point);
        let distance = (point[0] - about_center.center[0]).hypot(point[1] - about_center.center[1]);
        assert_same("Steiner", steiner(about_center.inertia, about_center.mass, distance), about_point, 0.0);
    }
}

/// The moment of inertia about the centre of the circle is half that of the whole disk of twice the
/// mass, m R²/2. The centre of mass lies elsewhere, so the moment about it is *less* by Steiner's
/// term. Adding the term by mistake gives 0.6801265486 m R², more than about the centre of the
/// circle. That contradicts the law of the test above.
#[test]
fn half_a_disk_has_less_inertia_about_its_centre_of_mass_than_about_the_centre_of_the_circle() {
    let measured = measure(&[&half_disk]);
    let unit = measured.mass * R * R;
    let about_circle = moment([0.0; 2], &half_disk) / unit;
    assert_same("J_M", about_circle, 0.5, 0.0);
    let s = measured.center[1] / R;
    assert_same("s", s, 4.0 / (3.0 * PI), 0.0);
    assert_same("s", semicircular_disk_center(R)[1], s * R, 0.0);

    let about_center = measured.inertia / unit;
    assert!((about_center - 0.319_873_451_3).abs() < 5e-11, "{about_center}");
    assert_same("J_S", semicircular_disk(M, R), about_center * M * R * R, 0.0);
    assert_same("J_S", about_circle - s * s, about_center, 0.0);

    let term_added = about_circle + s * s;
    assert!((term_added - 0.680_126_548_6).abs() < 1e-10, "{term_added}");
    assert!(about_center < about_circle && about_circle < term_added);
}

#[test]
fn a_rod_is_a_thin_plate_seen_edge_on() {
    let (length, width) = (3.0, 0.7);
    let plate = |[u, _, _]: [f64; 3]| ([length * u, 0.0], length * width);
    let about_end = moment([0.0; 2], &plate) / (length * width);
    assert_same("end", slender_rod_end(M, length), M * about_end, 0.0);
    assert_same("centre", slender_rod(M, length), M * measure(&[&plate]).inertia / (length * width), 0.0);
    assert_same("end", slender_rod_end(M, length), M * length * length / 3.0, 0.0);
    assert_same("centre", slender_rod(M, length), M * length * length / 12.0, 0.0);
}

#[test]
fn a_prism_has_the_polar_moment_of_its_area_times_height_and_density() {
    let (density, height) = (7.8, 0.25);
    let area = |[u, v, _]: [f64; 3]| ([2.0 * u - 1.0, v], 2.0);
    let prism = |point| {
        let (place, amount) = area(point);
        (place, amount * density * height)
    };
    let corner = [-1.0, 0.0];
    assert_same("J_P", moment(corner, &prism), density * height * moment(corner, &area), 0.0);
    let corners = [[-1.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-1.0, 1.0]];
    assert_same(
        "J_S",
        polygon(density * height * 2.0, &corners),
        density * height * measure(&[&area]).inertia,
        0.0,
    );
}

#[test]
fn spheres_are_stacks_of_disks() {
    // With z = R sin θ the disks have the radius R cos θ and the height R cos θ dθ.
    let stack = |of_disk: &dyn Fn(f64, f64) -> f64| {
        let element = |[u, _, _]: [f64; 3]| {
            let radius = R * (PI * (u - 0.5)).cos();
            let mass = PI * radius * radius * radius * PI;
            ([0.0; 2], of_disk(mass, radius))
        };
        measure(&[&element]).mass
    };
    let mass = stack(&|mass, _| mass);
    assert_same("volume", mass, 4.0 / 3.0 * PI * R.powi(3), 0.0);
    assert_same("inertia", stack(&solid_cylinder), solid_sphere(mass, R), 0.0);
}

#[test]
fn polygons_are_the_same_wherever_they_are_and_however_they_are_turned() {
    let corners = [[0.0, 0.0], [2.0, -0.5], [1.2, 0.4], [2.2, 1.5], [0.3, 1.1]];
    let (inertia, center) = (polygon(M, &corners), polygon_center(&corners));
    let mut numbers = scattered();
    for _ in 0..20 {
        let mut next = || numbers.next().expect("a number");
        let (angle, shift) = (PI * next(), [10.0 * next(), 10.0 * next()]);
        let (sine, cosine) = angle.sin_cos();
        let place = |[x, y]: [f64; 2]| [cosine * x - sine * y + shift[0], sine * x + cosine * y + shift[1]];
        let mut moved = corners.map(place);
        moved.rotate_left(2);
        assert_same("inertia", polygon(M, &moved), inertia, 0.0);
        for axis in [0, 1] {
            assert_same("centre", polygon_center(&moved)[axis], place(center)[axis], 10.0);
        }
        moved.reverse();
        assert_same("other orientation", polygon(M, &moved), inertia, 0.0);
    }
}

#[test]
fn solids_become_each_other_at_the_ends_of_their_dimensions() {
    assert_same("sector", circular_sector(M, R, PI), semicircular_disk(M, R), 0.0);
    assert_same("sector", circular_sector(M, R, TAU), solid_cylinder(M, R), 0.0);
    assert_same("tube", hollow_cylinder(M, 0.0, R), solid_cylinder(M, R), 0.0);
    assert_same("ball", hollow_sphere(M, 0.0, R), solid_sphere(M, R), 0.0);
    let (many, disk) = (regular_polygon(M, 10_000, R), solid_cylinder(M, R));
    assert!(many < disk && (disk - many) / disk < 1e-6);
}

#[test]
fn impossible_solids_give_nan() {
    assert!(triangle(M, 1.0, 2.0, 4.0).is_nan());
    assert!(triangle_center(-1.0_f64, 2.0, 2.0)[0].is_nan());
    assert!(hollow_cylinder(M, 2.0, 1.0).is_nan());
    assert!(hollow_sphere(M, 2.0, 1.0).is_nan() && hollow_sphere(M, 0.0, 0.0).is_nan());
    assert!(regular_polygon(M, 2, 1.0).is_nan());
    assert!(circular_sector(M, R, 0.0).is_nan() && circular_sector(M, R, 7.0).is_nan());
    assert!(polygon::<f64>(M, &[]).is_nan() && polygon(M, &[[0.0, 1.0], [1.0, 1.0]]).is_nan());
    assert!(polygon(M, &[[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]]).is_nan());
    assert!(polygon_center::<f64>(&[])[0].is_nan());
}

#[test]
fn nothing_hides_that_something_is_not_a_number() {
    assert!(lagrange::inertia::point_mass(f64::NAN).is_nan());
    assert!(hollow_cylinder(M, f64::NAN, R).is_nan() && hollow_sphere(M, 0.1, f64::NAN).is_nan());
    assert!(circular_sector(M, R, f64::NAN).is_nan() && triangle(M, 1.0, f64::NAN, 1.0).is_nan());
    assert!(polygon(M, &[[0.0, 0.0], [1.0, 0.0], [f64::NAN, 1.0]]).is_nan());
    assert!(steiner(1.0, M, f64::NAN).is_nan());
}

#[test]
fn single_precision_gives_the_same_to_its_rounding() {
    let pairs = [
        (f64::from(semicircular_disk(1.0_f32, 1.0)), semicircular_disk(1.0, 1.0)),
        (f64::from(circular_sector(1.0_f32, 1.0, std::f32::consts::TAU)), 0.5),
        (f64::from(regular_polygon(1.0_f32, 6, 1.0)), regular_polygon(1.0, 6, 1.0)),
    ];
    for (single, double) in pairs {
        assert!((single - double).abs() < 1e-6, "{single} is not {double}");
    }
}
