//! Bodies in space with unusual numbers, places and points.

use super::{assert_same, derive, mistakes};
use lagrange_core::pipeline::NumericSystem;

/// Returns an arm of two bodies whose second joint is given.
fn arm(joint: &str) -> String {
    format!(
        "param e = 0.00003;
        gravity = (0, 0, -9.81);
        body upper {{ mass: 2; centroid: (0.4, 0, 0.1); inertia: (0.02, 0.1, 0.11, 0.01, 0, -0.005); }}
        body lower {{ mass: 1; centroid: (0.3, 0.05, 0); inertia: (0.01, 0.05, 0.055); }}
        revolute a = ground to upper {{ axis: (0, 1, 0); }}
        revolute b = upper to lower {{ at: (0.8, 0, 0); {joint} }}"
    )
}

#[test]
fn small_turns_and_tilts_are_no_rounding_errors() {
    for angles in ["(E, 0, 0)", "(0, E, pi/2)", "(-pi/2, 0, E)"] {
        let with = |e: &str| arm(&format!("turned: {};", angles.replace('E', e)));
        assert_same(&with("0.00003"), &with("e"));
    }
    assert_same(&arm("axis: (0.00003, 0, 1);"), &arm("axis: (e, 0, 1);"));
    assert_same(&arm("axis: (0, -2, 0);"), &arm("axis: (0, -e, 0);"));
    assert_same(&arm("turned: (1.570796326794897, 0, 0);"), &arm("turned: (pi/2, 0, 0);"));
}

#[test]
fn constants_are_numbers_and_circles_of_them_mistakes() {
    let sized =
        |constants: &str, axis: &str| format!("{constants} {}", arm(&format!("axis: ({axis}, 0, 1);")));
    assert_same(&sized("const c = 1/2, d = 2 * c + 1;", "d"), &sized("", "2"));
    for circle in ["const c = c;", "const c = d, d = c;", "const c = c + 1;"] {
        assert!(!mistakes(&sized(circle, "c")).is_empty());
    }
    let chain = (1..60).map(|i| format!("const c{i} = c{} + c{};", i - 1, i - 1)).collect::<String>();
    assert_same(&sized(&format!("const c0 = 1; {chain}"), "c59 / c59"), &sized("", "1"));
}

#[test]
fn points_that_move_in_a_body_move_with_it_and_in_it() {
    let text = "coord s;
        kinetic = 1/2 * dot(s)^2;
        body arm { mass: 2; centroid: (0, 0, 0.1); inertia: (0.1, 0.1, 0.02); }
        universal (a, b) = ground to arm;
        output named = velocity(arm.point(s, 0, 1));
        output plain = dot(arm.point(s, 0, 1));
        output faster = acceleration(arm.point(s, 0, 1));
        output twice = ddot(arm.point(s, 0, 1));";
    let numeric = NumericSystem::new(&derive(text));
    let (q, v) = ([0.7, 0.3, -0.4], [1.5, -0.2, 0.9]);
    let output = |name: &str| numeric.output(name, 0.0, &q, &v).expect("an output");
    assert_eq!(output("named"), output("plain"));
    assert_eq!(output("faster"), output("twice"));
}

#[test]
fn a_shape_stands_where_its_centroid_is() {
    let body = |rest: &str| {
        format!(
            "gravity = (0, 0, -1); body b {{ mass: 3; centroid: (0, 0.2, 0.1); {rest} }} universal (p, r) = ground to b;"
        )
    };
    assert_same(
        &body("shape: solid_cylinder(0.2, 0.6);"),
        &body("inertia: (3 * (0.04/4 + 0.36/12), 3 * (0.04/4 + 0.36/12), 3 * 0.04/2);"),
    );
}

#[test]
fn in_takes_the_whole_expression_before_it() {
    let text = "body p { mass: 1; inertia: (1, 1, 1); } body r { mass: 1; inertia: (1, 1, 1); }
        revolute a = ground to p { axis: (1, 0, 0); }
        revolute b = p to r { axis: (0, 1, 0); }
        output all = angular_velocity(r) - angular_velocity(p) in r;
        output bracketed = (angular_velocity(r) - angular_velocity(p)) in r;";
    let numeric = NumericSystem::new(&derive(text));
    let output = |name: &str| numeric.output(name, 0.0, &[0.3, 0.8], &[1.0, 2.0]).expect("an output");
    assert_eq!(output("all"), output("bracketed"));
    for (found, wanted) in output("all").into_iter().zip([0.0, 2.0, 0.0]) {
        assert!((found - wanted).abs() < 1e-15);
    }
}

#[test]
fn joints_alone_place_their_bodies() {
    let message =
        mistakes("coord e; body rod { mass: 1; inertia: 1; angle: e; } revolute a = ground to rod;");
    assert_eq!(message[0], "the joint that places `rod` determines its angle");
    let message =
        mistakes("body rod { mass: 1; inertia: 1; } output p = rod.center; revolute a = ground to rod;");
    assert_eq!(message[0], "`rod` has no position yet");
}
