//! A step ladder of two halves of length l: the left foot is fixed at the origin, the right one
//! slips along the floor.

use std::f64::consts::PI;

use crate::assert_within;
use crate::pairs::Random;

lagrange::system! {
    /// A step ladder by the angle of its left half to the floor; the coordinate satisfies joints
    /// and floor.
    #[derive(Debug)]
    struct Ladder;

    param m = 6.0, man = 75.0, l = 2.0, h = 0.85, g = 9.81;
    coord phi;
    gravity = (0, -g);
    line floor {}
    body left { mass: m; shape: slender_rod(l); center: l/2 * (cos(phi), sin(phi)); angle: phi; }
    body right { mass: m; shape: slender_rod(l); center: l/2 * (3 * cos(phi), sin(phi)); angle: -phi; }
    body person { mass: man; center: left.point(l/2, 0) + (0, h); }
    pin foot = left.point(-l/2, 0) to (0, 0);
    pin hinge = left.point(l/2, 0) to right.point(-l/2, 0);
    slide toe = right.point(l/2, 0) on floor;
    output top = right.point(-l/2, 0);
    output end = right.point(l/2, 0);
    output top_velocity = velocity(left.point(l/2, 0));
    output end_velocity = velocity(right.point(l/2, 0));
    output center_of_left = instant_center(left);
    output center_of_right = instant_center(right);
    output spins = (angular_velocity(left), angular_velocity(right), angular_velocity(person));
    emit { motion }
}

fn states() -> impl Iterator<Item = ([f64; 1], [f64; 1])> {
    let mut random = Random::new(3);
    (0..50).map(move |_| ([PI / 4.0 + 0.7 * random.next()], [0.1 + random.next().abs()]))
}

#[test]
fn coordinates_that_fulfil_all_joints_leave_no_constraint() {
    use lagrange::system::OdeSystem;
    const { assert!(!Ladder::IS_CONSTRAINED) };
}

#[test]
fn hinge_and_foot_are_where_the_angle_puts_them() {
    let ladder = Ladder::default();
    for (q, v) in states() {
        let (sine, cosine) = q[0].sin_cos();
        let ([x, y], [toe, floor]) = (ladder.top(0.0, &q, &v), ladder.end(0.0, &q, &v));
        assert_within(1e-14, x, ladder.l * cosine);
        assert_within(1e-14, y, ladder.l * sine);
        assert_within(1e-14, toe, 2.0 * ladder.l * cosine);
        assert_within(1e-14, floor, 0.0);
    }
}

#[test]
fn the_center_of_the_right_half_runs_on_a_circle_about_the_left_foot() {
    let ladder = Ladder::default();
    for (q, v) in states() {
        let [x, y] = ladder.center_of_right(0.0, &q, &v);
        let (sine, cosine) = q[0].sin_cos();
        assert_within(1e-13, x, 2.0 * ladder.l * cosine);
        assert_within(1e-13, y, 2.0 * ladder.l * sine);
        assert_within(1e-13, x.hypot(y), 2.0 * ladder.l);
        let found = ladder.right_motion(0.0, &q, &v).instant_center().expect("it turns");
        assert_within(1e-13, found[0], x);
        assert_within(1e-13, found[1], y);
    }
}

/// The normal to the velocity of the toe is vertical, the normal to that of the hinge passes
/// through the left foot.
#[test]
fn the_center_is_where_the_normals_to_two_velocities_meet() {
    let ladder = Ladder::default();
    for (q, v) in states() {
        let ([ux, uy], [wx, wy]) = (ladder.top_velocity(0.0, &q, &v), ladder.end_velocity(0.0, &q, &v));
        let (top, end) = (ladder.top(0.0, &q, &v), ladder.end(0.0, &q, &v));
        // u·(M − top) = 0 and w·(M − end) = 0.
        let right = [ux * top[0] + uy * top[1], wx * end[0] + wy * end[1]];
        let determinant = ux * wy - uy * wx;
        let met =
            [(right[0] * wy - right[1] * uy) / determinant, (ux * right[1] - wx * right[0]) / determinant];
        let center = ladder.center_of_right(0.0, &q, &v);
        assert_within(1e-12, met[0], center[0]);
        assert_within(1e-12, met[1], center[1]);
    }
}

#[test]
fn the_left_half_turns_about_its_foot() {
    let ladder = Ladder::default();
    for (q, v) in states() {
        let [x, y] = ladder.center_of_left(0.0, &q, &v);
        assert_within(1e-13, x, 0.0);
        assert_within(1e-13, y, 0.0);
        let [left, right, person] = ladder.spins(0.0, &q, &v);
        assert_eq!([left, right, person], [v[0], -v[0], 0.0]);
    }
}

#[test]
fn the_man_on_top_translates_along_an_arc() {
    let ladder = Ladder::default();
    for (q, v) in states() {
        let person = ladder.person_motion(0.0, &q, &v);
        assert_eq!((person.angle, person.angular_velocity, person.angular_acceleration), (0.0, 0.0, 0.0));
        assert_eq!(person.instant_center(), None);
        assert_within(1e-14, person.center[0].hypot(person.center[1] - ladder.h), ladder.l);
        assert_eq!(person.velocity_at([0.3, -0.4]), person.velocity);
    }
}
