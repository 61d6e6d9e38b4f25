//! Scenes of bodies mean the same as the same systems written by hand.

mod contacts;
mod joints;
mod space;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::expr::Node;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};

fn derive(text: &str) -> Derived {
    let system = parse(text).unwrap_or_else(|report| panic!("{text}\n{report}"));
    system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{text}\n{report}"))
}

/// Returns the accelerations and multipliers at a generic state.
fn motion(text: &str) -> Vec<f64> {
    let derived = derive(text);
    let count = derived.model.coordinates.len();
    let entries = |phase: f64| (0..count).map(|i| (1.3 * i as f64 + phase).sin()).collect::<Vec<_>>();
    let (q, v) = (entries(0.4), entries(2.1));
    let numeric = NumericSystem::new(&derived);
    let mut all = numeric.acceleration(0.7, &q, &v);
    all.extend(numeric.multipliers(0.7, &q, &v));
    all
}

#[track_caller]
fn assert_same(scene: &str, by_hand: &str) {
    let (scene, by_hand) = (motion(scene), motion(by_hand));
    assert_eq!(scene.len(), by_hand.len());
    for (a, b) in scene.iter().zip(&by_hand) {
        assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{scene:?}\n{by_hand:?}");
    }
}

#[track_caller]
fn mistakes(text: &str) -> Vec<String> {
    let report = parse(text).err().unwrap_or_else(|| panic!("no mistake in {text}"));
    report.diagnostics().iter().map(|diagnostic| diagnostic.message.clone()).collect()
}

#[test]
fn a_body_is_its_energies() {
    assert_same(
        "param m = 2, l = 3, g = 9.81;
        coord a;
        gravity = (0, -g);
        body rod { mass: m; inertia: slender_rod(m, l); center: (l/2 * sin(a), -l/2 * cos(a)); angle: a; }",
        "param m = 2, l = 3, g = 9.81;
        coord a;
        kinetic = 1/6 * m * l^2 * dot(a)^2;
        potential = -m * g * l/2 * cos(a);",
    );
}

#[test]
fn a_pin_is_two_constraints_and_its_force_acts_on_the_first_body() {
    assert_same(
        "param m = 2, l = 3;
        coord x, y, a;
        body rod { mass: m; shape: slender_rod(l); center: (x, y); angle: a; }
        pin hinge = rod.point(-l/2, 0) to (0, 0);
        gravity = (0, -9.81);",
        "param m = 2, l = 3;
        coord x, y, a;
        kinetic = kinetic_energy(m, dot((x, y))) + kinetic_energy(m * l^2 / 12, dot(a));
        potential = m * 9.81 * y;
        constraint hx = x - l/2 * cos(a);
        constraint hy = y - l/2 * sin(a);",
    );
}

#[test]
fn a_round_body_rolls() {
    assert_same(
        "param m = 2, r = 0.5, slope = 0.3;
        coord x, y, a;
        gravity = (0, -9.81);
        line floor { through: (1, 2); angle: -slope; }
        body wheel { mass: m; shape: disk(r); center: (x, y); angle: a; }
        roll wheel on floor;",
        "param m = 2, r = 0.5, slope = 0.3;
        coord x, y, a;
        kinetic = kinetic_energy(m, dot((x, y))) + kinetic_energy(m * r^2 / 2, dot(a));
        potential = m * 9.81 * y;
        constraint normal = sin(slope) * (x - 1) + cos(slope) * (y - 2) - r;
        constraint friction = cos(slope) * dot(x) - sin(slope) * dot(y) + r * dot(a);",
    );
}

#[test]
fn a_wheel_rolls_on_a_line_that_a_body_carries() {
    assert_same(
        "param r = 0.2;
        coord b, u, a;
        gravity = (0, -9.81);
        body plank { mass: 3; shape: rectangle(2, 0.1); center: (0, 0); angle: b; }
        line top { on: plank; through: (0, 0.05); }
        body wheel { mass: 1; shape: disk(r); origin: plank.point(u, 0.05 + r); angle: a; }
        roll wheel on top;",
        "param r = 0.2;
        coord b, u, a;
        let (x, y) = (u * cos(b) - (0.05 + r) * sin(b), u * sin(b) + (0.05 + r) * cos(b));
        kinetic = kinetic_energy(3 * 4.01 / 12, dot(b)) + kinetic_energy(1, dot((x, y))) + kinetic_energy(r^2 / 2, dot(a));
        potential = 9.81 * y;
        constraint rolling = dot(u) + r * (dot(a) - dot(b));",
    );
}

#[test]
fn a_point_slides_on_a_line_that_a_body_carries() {
    assert_same(
        "coord s, x, y;
        gravity = (0, -9.81);
        body wedge { mass: 3; center: (s, 0); }
        line ramp { on: wedge; angle: -0.4; }
        body bead { mass: 1; center: (x, y); }
        slide bead on ramp;",
        "coord s, x, y;
        kinetic = kinetic_energy(3, dot(s)) + kinetic_energy(1, dot((x, y)));
        potential = 9.81 * y;
        constraint ramp = sin(0.4) * (x - s) + cos(0.4) * y;",
    );
}

#[test]
fn springs_and_dampers_act_between_points_and_between_angles() {
    assert_same(
        "param m = 2, j = 0.3, k = 40, c = 3;
        coord x, y, a;
        body plate { mass: m; inertia: j; center: (x, y); angle: a; }
        spring { from: (0, 2); to: plate.point(1, 0); stiffness: k; rest: 1/2; }
        spring slack { from: (5, 2); to: plate; stiffness: k; }
        damper { from: (0, 2); to: plate.point(1, 0); damping: c; }
        torsion_spring { from: ground; to: plate; stiffness: k; rest: 0.1; }
        torsion_damper { from: ground; to: plate; damping: c; }",
        "param m = 2, j = 0.3, k = 40, c = 3;
        coord x, y, a;
        kinetic = kinetic_energy(m, dot((x, y))) + kinetic_energy(j, dot(a));
        let d = hypot(x + cos(a), y + sin(a) - 2);
        potential = 1/2 * k * (d - 1/2)^2 + 1/2 * k * ((x - 5)^2 + (y - 2)^2) + 1/2 * k * (a - 0.1)^2;
        dissipation = 1/2 * c * dot(d)^2 + 1/2 * c * dot(a)^2;",
    );
}

#[test]
fn a_compound_is_the_sum_of_its_parts_less_the_holes() {
    assert_same(
        "param a = 2, r = 0.3;
        coord x, y, phi;
        gravity = (1, -9.81);
        body plate {
            compound {
                rectangle(a, 1), mass: 4;
                hole disk(r), mass: 1/2, at: (0.6, 0.1);
                semicircular_disk(0.5), mass: 0.7, at: (a/2, 0), angle: -pi/2;
            }
            origin: (x, y);
            angle: phi;
        }",
        "param a = 2, r = 0.3;
        coord x, y, phi;
        let s = 4 * 0.5 / (3 * pi);
        let m = 4 - 0.5 + 0.7;
        let cx = (-0.5 * 0.6 + 0.7 * (a/2 + s)) / m;
        let cy = -0.5 * 0.1 / m;
        let j = 4 * (a^2 + 1) / 12 + 4 * (cx^2 + cy^2)
            - 0.5 * (r^2 / 2 + (0.6 - cx)^2 + (0.1 - cy)^2)
            + 0.7 * ((1/2 - 16 / (9 * pi^2)) * 0.5^2 + (a/2 + s - cx)^2 + cy^2);
        let (px, py) = (x + cos(phi) * cx - sin(phi) * cy, y + sin(phi) * cx + cos(phi) * cy);
        kinetic = kinetic_energy(m, dot((px, py))) + kinetic_energy(j, dot(phi));
        potential = -m * px + m * 9.81 * py;",
    );
}

#[test]
fn a_joint_that_the_coordinates_fulfil_adds_nothing() {
    let scene = "coord x, a;
        line floor { }
        body wheel { mass: 2; shape: disk(1/2); center: (x, 1/2); angle: a; }
        roll contact = wheel on floor;";
    let derived = derive(scene);
    assert_eq!(derived.model.implied, ["contact_normal"]);
    assert_eq!(derived.model.constraints.len(), 1);
    let complaint = mistakes(&format!("{scene} output n = contact.normal;"));
    assert!(complaint[0].contains("no separate force"), "{complaint:?}");
}

#[test]
fn a_force_that_is_missing_is_missed_where_it_is_used() {
    let report = parse(
        "coord a;
        body rod { mass: 1; shape: slender_rod(2); center: (cos(a), sin(a)); angle: a; }
        pin h = rod.point(-1, 0) to (0, 0);
        output f = h.force;",
    );
    let report = report.expect_err("no force").to_string();
    assert!(report.starts_with("error at 4:20: this joint has no separate force"), "{report}");
}

#[test]
fn functions_of_points_and_bodies_are_their_formulas() {
    let declared = "param j = 2;
        coord x, y, a;
        line ramp { through: (1, 0); angle: 0.3; }
        body b { mass: 3; inertia: j; center: (x, y); angle: a; }";
    let outputs = [
        ("velocity(b.point(1, 2)).x", "dot(x) - dot(a) * (sin(a) + 2 * cos(a))"),
        ("acceleration(b).y", "ddot(y)"),
        ("angular_acceleration(b)", "ddot(a)"),
        ("instant_center(b).x", "x - dot(y) / dot(a)"),
        ("instant_center(b).y", "y + dot(x) / dot(a)"),
        ("tangential_acceleration(b, b.point(1, 0)).x", "-ddot(a) * sin(a)"),
        ("radial_acceleration(b, b.point(1, 0), b.point(-1, 0)).y", "-2 * dot(a)^2 * sin(a)"),
        ("b.linear_momentum().x", "3 * dot(x)"),
        ("angular_momentum(b)", "3 * (x * dot(y) - y * dot(x)) + j * dot(a)"),
        ("angular_momentum(b, (1, 2))", "3 * ((x - 1) * dot(y) - (y - 2) * dot(x)) + j * dot(a)"),
        ("ramp.distance(b)", "-sin(0.3) * (x - 1) + cos(0.3) * y"),
        ("ramp.along(b.point(0, 0))", "cos(0.3) * (x - 1) + sin(0.3) * y"),
        ("b.mass * b.inertia + b.angle", "3 * j + a"),
        ("b.vector(0, 1).x", "-sin(a)"),
    ];
    for (scene, by_hand) in outputs {
        let derived = derive(&format!("{declared} output o = {scene}; output h = {by_hand};"));
        let numeric = NumericSystem::new(&derived);
        let (q, v) = ([0.3, 0.8, 0.5], [1.1, -0.2, 0.7]);
        let values = ["o", "h"].map(|name| numeric.output(name, 0.0, &q, &v).expect("an output")[0]);
        assert!((values[0] - values[1]).abs() < 1e-14, "{scene}: {values:?}");
    }
}

#[test]
fn mistakes_are_reported_together() {
    let complaints = mistakes(
        "coord x;
        output early = body_b.center.x;
        body body_b { inertia: 1; center: (x, 0); origin: (x, 0); angle: x; shape: dsk(1); }
        gravity = (0, -1);
        gravity = (0, -2);
        pin body_b.point(0, 1) to body_b;
        slide body_b on flor;
        roll body_b on floor;
        line floor { }
        spring { from: body_b; to: (0, 0); }
        output a = rood.point(1, 2).x;
        output b = body_b;
        output c = body_b.size;
        output d = body_b.point(1);",
    );
    let expected = [
        "is used before it is declared",
        "no mass",
        "unknown solid `dsk`",
        "both a `center` and an `origin`",
        "`gravity` is declared twice",
        "pinned to itself",
        "unknown line `flor`",
        "`floor` is used before it is declared",
        "no `stiffness`",
        "`point` needs a body, but `rood` is not one",
        "is a body and has no value",
        "has no `size`",
        "does not take 1 argument",
    ];
    for expected in expected {
        assert!(complaints.iter().any(|line| line.contains(expected)), "{expected}\n{complaints:#?}");
    }
    assert_eq!(complaints.len(), expected.len(), "{complaints:#?}");
}

#[test]
fn generated_names_avoid_those_of_the_user() {
    assert_same(
        "param rod_center = 2;
        coord a;
        gravity = (0, -rod_center);
        body rod { mass: 1; shape: slender_rod(1); center: (sin(a), cos(a)); angle: a; }",
        "coord a;
        kinetic = kinetic_energy(13/12, dot(a));
        potential = 2 * cos(a);",
    );
}

#[test]
fn multipliers_keep_their_names_where_a_joint_before_them_is_left_out() {
    let derived = derive(
        "coord a, x, y;
        body arm { mass: 1; shape: slender_rod(2); center: (cos(a), sin(a)); angle: a; }
        body load { mass: 1; center: (x, y); }
        pin base = arm.point(-1, 0) to (0, 0);
        pin tip = arm.point(1, 0) to load;",
    );
    let names = derived.model.multipliers().into_iter().map(|id| match *derived.model.graph.node(id) {
        Node::Symbol(symbol) => derived.model.graph.symbols().get(symbol).name.clone(),
        _ => panic!("a multiplier is a symbol"),
    });
    assert_eq!(names.collect::<Vec<_>>(), ["tip_x", "tip_y"]);
}

/// Two arms turn about parallel axes at the same height, so nothing holds their tips together along
/// the axes.
#[test]
fn a_pin_has_the_components_of_its_force_that_the_motion_determines() {
    let derived = derive(
        "body a { mass: 1; inertia: (1, 1, 1); }
        body b { mass: 2; inertia: (1, 1, 1); }
        revolute p = ground to a;
        revolute q = ground to b { at: (3, 0, 0); }
        pin tip = a.point(1, 1, 0) to b.point(-2, 1, 0);
        force p = 1;
        output f = tip.force;
        emit { drawing }",
    );
    assert_eq!(derived.model.implied, ["tip_z"]);
    let system = NumericSystem::new(&derived);
    let force = system.output("f", 0.0, &[0.0; 2], &[0.0; 2]).expect("an output");
    assert!(force[0] != 0.0 && force[1].is_finite() && force[2] == 0.0, "{force:?}");
    // The moment about the axis of a, and the moment that drives it: J p̈, where J = 1 about its
    // own axis.
    let acceleration = system.acceleration(0.0, &[0.0; 2], &[0.0; 2])[0];
    assert!((force[1] - force[0] + 1.0 - acceleration).abs() < 1e-14, "{force:?} {acceleration}");
}

#[test]
fn one_mistake_in_a_joint_is_one_message() {
    let body = "param l = 1;
        coord x, y, a;
        body rod { mass: 1; shape: slender_rod(l); center: (x, y); angle: a; }
        line floor { }";
    for (statements, expected) in [
        ("pin rod and (0, 0);", "expected `to`, found `and`"),
        ("slide rod at floor;", "expected `on`, found `at`"),
        ("slide rod on floor; slide rod on floor;", "this joint repeats another constraint"),
        ("line rail { on: rod; } body bead { mass: 1; center: rod.point(l, 0); } pin p = bead to rod.point(l, 0);
            output f = p.force;", "this joint has no separate force, since the coordinates already satisfy it"),
    ] {
        assert_eq!(mistakes(&format!("{body} {statements}")), [expected], "{statements}");
    }
}

#[test]
fn statements_without_effect_are_mistakes() {
    let still = "param m; coord x, y; body b { mass: m; center: (x, y); shape: disk(1); } line f { }";
    for (statement, expected) in [
        ("torque 1 on b;", "`b` never rotates, so a torque"),
        ("torque 1 on ground;", "`ground` never rotates, so a torque"),
        ("torsion_spring { from: ground; to: b; stiffness: 1; }", "`b` never rotates, and neither"),
        ("torsion_damper { from: b; to: ground; damping: 1; }", "`ground` never rotates, and neither"),
        ("roll b on f;", "`b` never rotates, so it cannot roll"),
    ] {
        let complaints = mistakes(&format!("{still} {statement}"));
        assert_eq!(complaints.len(), 1, "{statement}: {complaints:?}");
        assert!(complaints[0].starts_with(expected), "{complaints:?}");
    }
    let complaints = mistakes("coord x; kinetic = kinetic_energy(1, dot(x)); gravity = (0, -1);");
    assert_eq!(complaints, ["`gravity` acts on bodies, but none is declared"]);
}

#[test]
fn points_are_no_angles_and_the_ground_is_no_point() {
    let body = |angle: &str| {
        format!("param m; coord x, y, p; body b {{ mass: m; center: (x, y); angle: {angle}; inertia: 1; }}")
    };
    for (angle, statement, expected) in [
        ("(p, p)", "", "this is a point"),
        ("p", "torsion_spring { from: (0, 0); to: b.center; stiffness: 1; }", "this is a point"),
        ("p", "torque 1 on b.point(1, 0);", "this is a point"),
        ("p", "spring { from: ground; to: b; stiffness: 1; }", "the ground is not a point"),
    ] {
        let complaints = mistakes(&format!("{} {statement}", body(angle)));
        assert!(complaints.iter().all(|line| line.starts_with(expected)), "{statement}: {complaints:?}");
    }
}

#[test]
fn masses_and_gravity_are_no_matter_of_motion() {
    for (mass, gravity, expected) in [
        ("dot(x)", "", "the mass of `b` must not depend on coordinates or velocities"),
        ("1 + x", "", "the mass of `b` must not depend on coordinates or velocities"),
        (
            "u",
            "input u;",
            "the mass of `b` must not depend on inputs or delayed values, since their rates are unknown",
        ),
        ("1", "gravity = (0, -x);", "`gravity` must not depend on coordinates: it is the same everywhere"),
    ] {
        let text = format!("coord x, y; {gravity} body b {{ mass: {mass}; center: (x, y); }}");
        assert_eq!(mistakes(&text), [expected]);
    }
    motion("coord x, y; body b { mass: 1; center: (x, y); } gravity = (0, -9 - sin(t));");
}

#[test]
fn distributions_of_mass_must_be_constant() {
    for items in [
        "mass: 1; shape: disk(1 + x);",
        "mass: 1; inertia: 1; centroid: (x, 0);",
        "compound { disk(1), mass: x; }",
        "compound { disk(1), mass: 1, at: (x, 0); }",
        "compound { disk(1), mass: 1, angle: x; }",
    ] {
        let complaints = mistakes(&format!("coord x, y; body b {{ {items} origin: (x, y); angle: y; }}"));
        assert_eq!(complaints.len(), 1, "{items}: {complaints:?}");
        assert!(complaints[0].ends_with("must not change during the motion"), "{complaints:?}");
    }
}

#[test]
fn inertia_changes_with_the_mass_only() {
    let scene = |items: &str, other: &str| {
        format!(
            "coord x, y; state m = 1; dot(m) = -1; {other} body b {{ {items} center: (x, x); angle: y; }}"
        )
    };
    motion(&scene("mass: m; inertia: 1 + m^2;", ""));
    motion(&scene("mass: m; shape: disk(1);", "let late = 2 * m;"));
    motion(&scene("mass: c; inertia: 2 * c;", "param a = 1; let c = 2 * a; emit { regressor }"));
    for (items, other, expected) in [
        ("mass: 1; inertia: m;", "", "the moment of inertia of `b` changes without its mass"),
        ("mass: m; inertia: 1 + t^2;", "", "the moment of inertia of `b` changes without its mass"),
        (
            "mass: 1; inertia: x^2;",
            "",
            "the moment of inertia of `b` must not depend on coordinates or velocities",
        ),
        (
            "mass: m; inertia: 1;",
            "emit { regressor }",
            "`regressor` needs constant parameters, but the mass of `b` changes",
        ),
        (
            "mass: 1 + c; inertia: 1;",
            "discrete c = 1; emit { regressor }",
            "`regressor` needs constant parameters, but the mass of `b` changes",
        ),
        (
            "mass: 1 + c; inertia: 1;",
            "solve c: 0 = c - cos(x); emit { regressor }",
            "the mass of `b` must not depend on coordinates or velocities",
        ),
        ("mass: 1 + c; inertia: 1;", "noise c, density: 1;", "the noise `c` has no values here"),
        (
            "mass: 1 + late; inertia: 1;",
            "let late = delay(m, 1);",
            "the mass of `b` must not depend on inputs or delayed values, since their rates are unknown",
        ),
    ] {
        assert_eq!(mistakes(&scene(items, other)), [expected]);
    }
}

#[test]
fn another_centroid_needs_another_inertia() {
    let body = |inertia: &str| {
        let shape = "mass: 1; shape: slender_rod(1); centroid: (1/4, 0);";
        format!("coord x, y, a; body b {{ {shape} {inertia} origin: (x, y); angle: a; }}")
    };
    assert_eq!(mistakes(&body("")), ["the moment of inertia of `b` about this centroid is unknown"]);
    motion(&body("inertia: 1/9;"));
}

#[test]
fn places_are_made_of_coordinates_and_time() {
    for items in ["center: (x, dot(y));", "origin: (x, dot(y));"] {
        let complaints = mistakes(&format!("coord x, y; body b {{ mass: 1; {items} }}"));
        assert_eq!(complaints.len(), 1, "{complaints:?}");
        assert!(complaints[0].ends_with("must be made of coordinates and time"), "{complaints:?}");
    }
}

#[test]
fn bodies_do_not_go_with_a_lagrangian() {
    let complaints =
        mistakes("coord x; lagrangian = dot(x)^2; gravity = (0, -1); body b { mass: 1; center: (x, 0); }");
    assert_eq!(complaints, ["body `b` cannot be combined with `lagrangian`"]);
}

#[test]
fn ground_is_free_as_a_name_and_a_line_of_that_name_is_the_ground() {
    assert_same(
        "coord x, y, p;
        body ground { mass: 1; inertia: 2; center: (x, y); angle: p; }
        torque 3 on ground;
        spring { from: ground; to: (0, 0); stiffness: 5; }",
        "coord x, y, p;
        kinetic = kinetic_energy(1, dot((x, y))) + kinetic_energy(2, dot(p));
        potential = spring_energy(5, (x, y));
        torque 3 on p;",
    );
    assert_same(
        "coord x, y, p;
        body b { mass: 1; inertia: 2; center: (x, y); angle: p; }
        torsion_spring { from: ground; to: b; stiffness: 3; }
        line ground { angle: 1; }",
        "coord x, y, p;
        kinetic = kinetic_energy(1, dot((x, y))) + kinetic_energy(2, dot(p));
        potential = spring_energy(3, p);",
    );
}
