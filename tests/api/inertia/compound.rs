//! Composite bodies against the same bodies in one piece.

use std::f64::consts::{FRAC_PI_2, PI};

use lagrange::inertia::{
    MassGeometry, disk, hollow_cylinder, point_mass, rectangle, semicircular_disk, semicircular_disk_center,
    slender_rod, slender_rod_end,
};

use super::assert_same;

#[track_caller]
fn assert_bodies_agree(found: MassGeometry<f64>, expected: MassGeometry<f64>) {
    assert_same("mass", found.mass, expected.mass, 0.0);
    assert_same("inertia", found.inertia, expected.inertia, 0.0);
    for axis in [0, 1] {
        assert_same("centre", found.center[axis], expected.center[axis], 1.0);
    }
}

#[test]
fn an_angle_profile_is_two_plates_or_a_plate_without_another() {
    let corners = [[1.0, 2.0], [4.0, 2.0], [4.0, 2.5], [1.4, 2.5], [1.4, 4.5], [1.0, 4.5]];
    let plate = |from: [f64; 2], to: [f64; 2]| {
        let (a, b) = (to[0] - from[0], to[1] - from[1]);
        let middle = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
        MassGeometry::new(a * b, middle, rectangle(a * b, a, b))
    };
    let expected = MassGeometry::polygon(2.3, &corners);
    assert_bodies_agree(plate([1.0, 2.0], [4.0, 2.5]).with(plate([1.0, 2.5], [1.4, 4.5])), expected);
    assert_bodies_agree(plate([1.0, 2.0], [4.0, 4.5]).without(plate([1.4, 2.5], [4.0, 4.5])), expected);
}

#[test]
fn a_tube_is_a_cylinder_without_a_thinner_one() {
    let of_radius = |r: f64| MassGeometry::new(r * r, [0.3, -0.2], disk(r * r, r));
    let tube = of_radius(0.8).without(of_radius(0.3));
    let expected = MassGeometry::new(0.55, [0.3, -0.2], hollow_cylinder(0.55, 0.3, 0.8));
    assert_bodies_agree(tube, expected);
}

#[test]
fn parts_come_in_any_order_and_what_is_added_can_be_taken_away() {
    let rod = MassGeometry::new(2.0, [0.0, 0.5], slender_rod(2.0, 1.0)).turned(0.4);
    let half = MassGeometry::new(3.0, semicircular_disk_center(0.4), semicircular_disk(3.0, 0.4));
    let half = half.turned(FRAC_PI_2).moved([0.7, -0.1]);
    let ball = MassGeometry::new(0.5, [-1.0, 2.0], point_mass(0.5));
    assert_bodies_agree(rod.with(half).with(ball), ball.with(rod.with(half)));
    assert_bodies_agree(rod.with(half).with(ball).without(half), rod.with(ball));
}

#[test]
fn moved_and_turned_bodies_are_put_together_alike() {
    let rod = MassGeometry::new(2.0, [0.0, 0.5], slender_rod(2.0, 1.0));
    let half = MassGeometry::new(3.0, semicircular_disk_center(0.4), semicircular_disk(3.0, 0.4));
    let place = |body: MassGeometry<f64>| body.turned(2.0).moved([3.0, -1.0]);
    assert_bodies_agree(place(rod).with(place(half)), place(rod.with(half)));
}

#[test]
fn a_body_about_a_point_is_the_body_with_a_mass_there_that_does_not_give_way() {
    let rod = MassGeometry::new(2.0, [0.0, 0.0], slender_rod(2.0, 3.0)).turned(PI / 3.0);
    let end = [1.5 * (PI / 3.0).cos(), 1.5 * (PI / 3.0).sin()];
    assert_same("end", rod.about(end), slender_rod_end(2.0, 3.0), 0.0);
    assert_same("centre", rod.about(rod.center), rod.inertia, 0.0);
    let heavy = MassGeometry::new(1e12, end, 0.0);
    assert!((rod.with(heavy).inertia - rod.about(end)).abs() < 1e-10);
}

#[test]
fn nothing_left_has_no_centre_of_mass() {
    let body = MassGeometry::new(2.0, [1.0, 0.0], 0.5_f64);
    assert!(!body.without(MassGeometry::new(2.0, [0.0, 0.0], 0.5)).center[0].is_finite());
    assert!(!body.without(body).center[0].is_finite());
    assert!(MassGeometry::polygon(1.0, &[[0.0, 0.0], [1.0, 0.0_f64]]).center[0].is_nan());
}

lagrange::system! {
    /// A plate with a round hole, and half a disk on its edge, turned.
    struct Plate;

    param m = 3.0, a = 2.0, b = 1.0, r = 0.25, e = 0.3;
    coord x, y, phi;
    body plate {
        origin: (x, y);
        angle: phi;
        compound {
            rectangle(a, b), mass: m;
            hole disk(r), mass: m / 10, at: (a / 4, 0);
            semicircular_disk(b / 2), mass: m / 3, at: (a / 2, 0), angle: e - pi / 2;
        }
    }
    output mass = plate.mass;
    output inertia = plate.inertia;
    output place = plate.center;
}

#[test]
fn compounds_of_the_language_are_those_of_the_library() {
    let system = Plate::default();
    let Plate { m, a, b, r, e } = system;
    let plate = MassGeometry::new(m, [0.0, 0.0], rectangle(m, a, b));
    let hole = MassGeometry::new(m / 10.0, [a / 4.0, 0.0], disk(m / 10.0, r));
    let half =
        MassGeometry::new(m / 3.0, semicircular_disk_center(b / 2.0), semicircular_disk(m / 3.0, b / 2.0));
    let half = half.turned(e - FRAC_PI_2).moved([a / 2.0, 0.0]);
    let expected = plate.without(hole).with(half);
    let (q, v) = (&[0.0; 3], &[0.0; 3]);
    let found = MassGeometry::new(system.mass(0.0, q, v), system.place(0.0, q, v), system.inertia(0.0, q, v));
    assert_bodies_agree(found, expected);
    // The turned plate has its centre of mass turned about the origin of its own coordinates.
    let turned = expected.turned(0.7).moved([5.0, -2.0]);
    let place = system.place(0.0, &[5.0, -2.0, 0.7], v);
    assert_same("centre", place[0], turned.center[0], 1.0);
    assert_same("centre", place[1], turned.center[1], 1.0);
}
