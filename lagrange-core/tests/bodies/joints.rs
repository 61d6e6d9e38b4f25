//! Joints with coordinates of their own in the plane.

use super::{assert_same, mistakes};

#[test]
fn revolutes_place_bodies_one_on_the_other() {
    assert_same(
        "param m1 = 2, m2 = 0.7, l1 = 1.5, l2 = 0.8, c = 0.3;
        gravity = (0, -9.81);
        body upper { mass: m1; shape: slender_rod(l1); centroid: (0, -l1/2); inertia: slender_rod(m1, l1); }
        body lower { mass: m2; inertia: slender_rod(m2, l2); centroid: (0, -l2/2); }
        revolute a = ground to upper { at: (1, 2); damping: c; }
        revolute b = upper to lower { at: (0, -l1); turned: 0.2; }",
        "param m1 = 2, m2 = 0.7, l1 = 1.5, l2 = 0.8, c = 0.3;
        gravity = (0, -9.81);
        coord a, b;
        let (x, y) = (1 + l1 * sin(a), 2 - l1 * cos(a));
        let e = a + b + 0.2;
        body upper { mass: m1; inertia: slender_rod(m1, l1); center: (1 + l1/2 * sin(a), 2 - l1/2 * cos(a)); angle: a; }
        body lower { mass: m2; inertia: slender_rod(m2, l2); center: (x + l2/2 * sin(e), y - l2/2 * cos(e)); angle: e; }
        dissipation = 1/2 * c * dot(a)^2;",
    );
}

#[test]
fn prismatic_joints_move_along_their_axis_of_any_length() {
    assert_same(
        "param m = 2, k = 5;
        gravity = (0, -9.81);
        body cart { mass: 3; inertia: 1; }
        body slider { mass: m; inertia: 0.1; }
        prismatic x = ground to cart;
        prismatic s = cart to slider { at: (0, 1); axis: (3, 4); }
        potential = spring_energy(k, s);",
        "param m = 2, k = 5;
        coord x, s;
        kinetic = kinetic_energy(3, dot(x)) + kinetic_energy(m, dot((x + 0.6 * s, 0.8 * s)));
        potential = spring_energy(k, s) + gravitational_energy(m, 9.81, 0.8 * s);",
    );
}

#[test]
fn frames_and_welds_carry_what_is_behind_them() {
    assert_same(
        "gravity = (0, -9.81);
        body arm { mass: 1; inertia: 0.2; centroid: (0.5, 0); }
        frame wrist;
        body hand { mass: 0.4; inertia: 0.05; centroid: (0.1, 0); }
        revolute a = ground to arm;
        weld arm to wrist { at: (1, 0); turned: pi/2; }
        revolute b = wrist to hand;
        force (0, 1) at wrist;",
        "gravity = (0, -9.81);
        coord a, b;
        let e = a + b + pi/2;
        let (x, y) = (cos(a), sin(a));
        body arm { mass: 1; inertia: 0.2; center: (cos(a) / 2, sin(a) / 2); angle: a; }
        body hand { mass: 0.4; inertia: 0.05; center: (x + 0.1 * cos(e), y + 0.1 * sin(e)); angle: e; }
        force (0, 1) at (x, y);",
    );
}

#[test]
fn planar_joints_are_free_bodies_in_the_plane() {
    assert_same(
        "gravity = (0, -9.81);
        body puck { mass: 2; inertia: 0.3; centroid: (0.1, 0.2); }
        planar (x, y, phi) = ground to puck;
        spring { from: (0, 0); to: puck.point(1, 0); stiffness: 7; rest: 0.3; }",
        "gravity = (0, -9.81);
        coord x, y, phi;
        body puck { mass: 2; inertia: 0.3; centroid: (0.1, 0.2); origin: (x, y); angle: phi; }
        spring { from: (0, 0); to: puck.point(1, 0); stiffness: 7; rest: 0.3; }",
    );
}

#[test]
fn the_same_arm_moves_in_space_as_in_the_plane() {
    assert_same(
        "gravity = (0, -9.81, 0);
        body upper { mass: 2; centroid: (0.4, 0, 0); inertia: (0.001, 0.1, 0.1); }
        body lower { mass: 1; centroid: (0.3, 0, 0); inertia: (0.001, 0.05, 0.05); }
        revolute a = ground to upper;
        revolute b = upper to lower { at: (0.8, 0, 0); }
        force (1, 2, 0) at lower.point(0.6, 0, 0);",
        "gravity = (0, -9.81);
        body upper { mass: 2; centroid: (0.4, 0); inertia: 0.1; }
        body lower { mass: 1; centroid: (0.3, 0); inertia: 0.05; }
        revolute a = ground to upper;
        revolute b = upper to lower { at: (0.8, 0); }
        force (1, 2) at lower.point(0.6, 0);",
    );
}

#[test]
fn mistakes_about_joints_are_named() {
    let rod = "body rod { mass: 1; inertia: 0.1; } ";
    let with = |rest: &str| mistakes(&format!("{rod}{rest}"));
    assert_eq!(
        with("revolute a = ground to rod { axis: (0, 1); }"),
        ["bodies in the plane rotate about its normal"]
    );
    assert_eq!(
        with("revolute a = ground to rod; revolute b = ground to rod;"),
        ["`rod` already has a position"]
    );
    assert_eq!(with("revolute a = rod to ground;").len(), 2);
    assert_eq!(with("prismatic s = ground to rod { axis: (0, 0); }"), ["this axis has no direction"]);
}
