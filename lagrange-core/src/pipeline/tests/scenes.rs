//! Derived and emitted results for rigid bodies.

use super::{derived, expand, parse};
use crate::model::{BodyMotion, Model, Scene};
use lagrange_expr::expr::evaluate;
use lagrange_expr::symbol::Role;
use lagrange_language::bodies::DrawnKind;
use quote::quote;

const ROD: &str = "
    param m = 2, l = 3;
    coord x, y, a;
    body rod { mass: m; shape: slender_rod(l); center: (x, y); angle: a; }
";

/// A rod with everything that can be drawn, declared in a different order than it is drawn.
const FULL: &str = "
    param m = 2, l = 3;
    coord x, y, a;
    gravity = (0, -9.81);
    body rod { mass: m; shape: slender_rod(l); center: (x, y); angle: a; }
    pin rod.point(-l/2, 0) to (0, 1);
    spring k1 { from: rod; to: (1, 2); stiffness: 3; }
    torque 2 on rod;
    line floor { angle: 0.1; }
    emit { drawing }
";

fn scene(text: &str) -> Scene {
    parse(text).unwrap_or_else(|report| panic!("{text}\n{report}")).model.scene
}

/// Returns the first line of the errors.
#[track_caller]
fn mistake(text: &str) -> String {
    let report = parse(text).err().unwrap_or_else(|| panic!("no mistake in {text}"));
    report.diagnostics()[0].message.clone()
}

fn items(text: &str) -> String {
    let tokens = text.parse().expect("tokens");
    expand(tokens, &quote!(::lagrange)).to_string()
}

/// Returns the kind of a drawn item: rod, line, spring, joint or force.
fn kind(kind: &DrawnKind) -> &'static str {
    match kind {
        DrawnKind::Surface { .. } => "surface",
        DrawnKind::Cone { .. } => "cone",
        DrawnKind::Body { .. } => "body",
        DrawnKind::Connector { .. } => "connector",
        DrawnKind::Joint { .. } => "joint",
        DrawnKind::Force { .. } => "force",
        DrawnKind::Moment { .. } => "moment",
        DrawnKind::Torque { .. } => "torque",
        DrawnKind::Omitted { .. } => "omitted",
        DrawnKind::Frame { .. } => "frame",
        DrawnKind::SpatialJoint { .. } => "joint in space",
    }
}

fn kinds(text: &str) -> Vec<&'static str> {
    scene(text).drawing.iter().map(|item| kind(&item.kind)).collect()
}

#[test]
fn nothing_is_derived_or_emitted_that_nobody_asks_for() {
    let silent = scene(ROD);
    assert!(silent.motions.is_empty() && silent.drawing.is_empty());
    let text = items(&format!("struct Rod; {ROD}"));
    // Members that only serve compiler messages take `&mut self`.
    for absent in ["rod_motion (& self", "scene", "STATEMENTS"] {
        assert!(!text.contains(absent), "{absent}");
    }
    let text = items(&format!("struct Rod; {ROD} emit {{ motion, drawing, statements }}"));
    for present in ["rod_motion", ":: scene :: Scene for Rod", "STATEMENTS"] {
        assert!(text.contains(present), "{present}");
    }
    let text = items(&format!("struct Rod; {ROD} emit {{ motion, drawing, no motion }}"));
    assert!(!text.contains("rod_motion (& self") && text.contains("scene :: Scene for Rod"));
}

#[test]
fn requested_products_leave_the_equations_unchanged() {
    let [silent, asked] = ["", "emit { motion, drawing }"].map(|emit| {
        let text = FULL.replace("emit { drawing }", emit);
        let derived = derived(&text);
        let accelerations = derived.equations.accelerations.clone();
        let value = |role| match role {
            Role::Parameter(i) => [2.0, 3.0][i as usize],
            Role::Coordinate(i) => [0.3, 0.5, 0.7][i as usize],
            Role::Velocity(i) => [-0.2, 0.1, 0.9][i as usize],
            _ => f64::NAN,
        };
        (derived.equations.costs, evaluate(&derived.model.graph, &accelerations, value))
    });
    assert_eq!(silent, asked);
}

#[test]
fn items_come_in_the_order_in_which_they_are_drawn() {
    let kinds = kinds(FULL);
    assert_eq!(kinds[..4], ["surface", "body", "connector", "joint"]);
    assert!(
        kinds.len() > 4 && kinds[4..].iter().all(|kind| matches!(*kind, "force" | "moment")),
        "{kinds:?}"
    );
    assert!(kinds.contains(&"moment"));
}

#[test]
fn forces_of_joints_that_hold_by_themselves_are_omitted_by_name() {
    let text = "param l = 3; coord a;
        body rod { mass: 2; shape: slender_rod(l); center: (l/2 * cos(a), l/2 * sin(a)); angle: a; }
        pin rod.point(-l/2, 0) to (0, 0);
        emit { drawing }";
    assert_eq!(kinds(text), ["body", "joint", "omitted"]);
    let named = scene(&text.replace("pin rod", "pin hinge = rod"));
    assert!(matches!(&named.drawing[2].kind, DrawnKind::Omitted { name } if name == "hinge"));
    let held = format!("{ROD} pin rod.point(-l/2, 0) to (0, 0); emit {{ drawing }}");
    assert_eq!(kinds(&held), ["body", "joint", "force"]);
}

#[test]
fn forces_in_space_have_no_place_in_the_picture() {
    let with = |force: &str, point: &str| {
        kinds(&format!("{ROD} let f = {force}; let p = {point}; force f at p; emit {{ drawing }}"))
    };
    assert_eq!(with("(1, 2)", "(x, y)"), ["body", "force"]);
    assert_eq!(with("(1, 2, 3)", "(x, y, 0)"), ["body"]);
}

#[test]
fn products_of_bodies_need_bodies() {
    for product in ["motion", "drawing"] {
        let text = format!("coord x; kinetic = dot(x)^2; emit {{ {product} }}");
        assert_eq!(mistake(&text), format!("`{product}` is not defined for a system without rigid bodies"));
        let left_out = text.replace("emit { ", "emit { no ");
        assert!(parse(&left_out).is_ok());
    }
}

#[test]
fn names_of_products_of_bodies_are_free_but_those_of_their_methods_are_not() {
    for name in ["motion", "drawing", "statements", "items", "other_motion"] {
        assert!(parse(&format!("{ROD} output {name} = x; emit {{ motion, drawing, statements }}")).is_ok());
    }
    assert!(parse(&format!("{ROD} output rod_motion = x;")).is_ok());
    let clash = mistake(&format!("{ROD} output rod_motion = x; emit {{ motion }}"));
    assert!(clash.starts_with("an output cannot be called `rod_motion`"), "{clash}");
    let constant = mistake(&format!("{ROD} output STATEMENTS = x;"));
    assert!(constant.starts_with("an output cannot be called `STATEMENTS`"), "{constant}");
}

#[test]
fn bodies_cannot_be_named_like_a_method_that_exists() {
    let text = ROD.replace("body rod", "body redundant") + "emit { motion }";
    assert!(parse(&text).is_ok());
    let held = mistake(&format!("{text} constraint c = x - y;"));
    assert!(held.contains("`redundant_motion`"), "{held}");
}

/// Returns the numbers that describe the motion of the first body, at x = 0.3, y = 0.5 and
/// velocities 0.2, 0.1.
fn numbers(model: &Model) -> [f64; BodyMotion::VALUES[0]] {
    let value = |role| match role {
        Role::Parameter(i) => [2.0, 3.0][i as usize],
        Role::Coordinate(i) => [0.3, 0.5][i as usize],
        Role::Velocity(i) => [0.2, 0.1][i as usize],
        Role::Acceleration(i) => [-0.7, 0.4][i as usize],
        _ => f64::NAN,
    };
    let found = evaluate(&model.graph, &model.scene.motions[0].values, value);
    found.try_into().expect("as many as there are")
}

#[test]
fn bodies_of_reduced_types_stand_where_coordinates_are_frozen() {
    let text = "param m = 2, l = 3; coord a, x, y;
        body rod { mass: m; shape: slender_rod(l); center: (x^2, y); angle: a; }
        emit { motion, drawing }
        reduce Held { freeze a = l; }";
    let system = parse(text).expect("a correct declaration");
    let reduced = &system.model.reduced[0].model;
    assert_eq!(reduced.scene.drawing.len(), 1);
    let found = numbers(reduced);
    let expected = [
        [2.0, 1.5, 0.0, 0.0].as_slice(),
        &[0.3 * 0.3, 0.5, 3.0],
        &[2.0 * 0.3 * 0.2, 0.1, 0.0],
        &[2.0 * (0.2 * 0.2 - 0.7 * 0.3), 0.4, 0.0],
    ];
    for (found, expected) in found.iter().zip(expected.concat()) {
        assert!((found - expected).abs() < 1e-15, "{found} is not {expected}");
    }
}

#[test]
fn requested_members_exist_even_after_a_mistake() {
    let text = format!("struct Rod; {ROD} output o = unknown; emit {{ motion, drawing, statements }}");
    let skeleton = items(&text);
    for present in ["fn rod_motion", ":: scene :: Scene for Rod", "STATEMENTS", "compile_error"] {
        assert!(skeleton.contains(present), "{present}");
    }
    let silent = items(&text.replace("motion, drawing, ", ""));
    assert!(!silent.contains("rod_motion (& self") && !silent.contains("scene"));
}

#[test]
fn plain_statements_are_a_declaration_of_the_same_system() {
    let system = parse(FULL).expect("a correct declaration");
    let statements = system.statements();
    assert!(statements.contains("kinetic_energy(m, dot(rod_center))"), "{statements}");
    assert!(!statements.contains("body") && !statements.contains("drawing"), "{statements}");
    let again = parse(&statements).unwrap_or_else(|report| panic!("{statements}\n{report}"));
    assert_eq!(again.statements(), statements);
    assert_eq!(derived(&statements).equations.costs, derived(FULL).equations.costs);
}
