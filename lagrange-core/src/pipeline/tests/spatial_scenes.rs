//! Drawn items of bodies in space.

use super::{derived, expand, parse};
use crate::model::{DrawnItem, Scene};
use lagrange_expr::expr::evaluate;
use lagrange_expr::symbol::Role;
use lagrange_language::bodies::{DrawnKind, SpatialJointForm};
use lagrange_language::syntax::ast::MobilizerKind;
use quote::quote;

/// An arm with everything that can be drawn, declared in a different order than it is drawn.
const ARM: &str = "
    param m = 2, l = 0.5, c = 0.1;
    input u;
    gravity = (0, 0, -9.81);
    spring k1 { from: (0, 0, 1); to: (1, 0, 0); stiffness: 3; }
    frame tool;
    body arm { mass: m; shape: cone(l / 4, l); centroid: (0, 0, l); }
    revolute q = ground to arm { at: (0, 0, l); turned: (0, pi/2, 0); axis: (1, 0, 0); damping: c; }
    weld arm to tool { at: (0, 0, 2 * l); }
    body nut { mass: m; inertia: (0.1, 0.1, 0.1); }
    screw s = arm to nut { pitch: l; }
    coord x, y, z;
    body bob { mass: m; center: (x, y, z); }
    pin hook = bob to tool;
    force q = u;
    force s = u;
    torque u on q + s;
    force (1, 0, u) at tool;
    torque (u, 0, 0) on arm;
";

fn scene(text: &str) -> Scene {
    parse(text).unwrap_or_else(|report| panic!("{text}\n{report}")).model.scene
}

fn described(item: &DrawnItem) -> String {
    let on = |body: &Option<String>| body.clone().unwrap_or_else(|| "nothing".to_owned());
    match &item.kind {
        DrawnKind::Body { body, outlines } => format!("body {body} of {}", outlines.len()),
        DrawnKind::Frame { name } => format!("frame {name}"),
        DrawnKind::Connector { name, .. } => format!("connector {name}"),
        DrawnKind::SpatialJoint { name, kind, links: [carrier, placed] } => {
            format!("{kind:?} {name}: {} to {}", on(carrier), on(placed))
        }
        DrawnKind::Force { name, body, .. } => format!("force {name} on {}", on(body)),
        DrawnKind::Moment { name, body, .. } => format!("moment {name} on {}", on(body)),
        DrawnKind::Omitted { name } => format!("omitted {name}"),
        other => format!("{other:?} of the plane"),
    }
}

fn kinds(text: &str) -> Vec<String> {
    scene(text).drawing.iter().map(described).collect()
}

#[test]
fn items_come_in_the_order_in_which_they_are_drawn() {
    let expected = [
        "frame tool",
        "body 0 of 1",
        "body 1 of 0",
        "body 2 of 0",
        "connector k1",
        "Mobilizer(Revolute) q: nothing to arm",
        "Mobilizer(Weld) tool: arm to tool",
        "Mobilizer(Screw) s: arm to nut",
        "Pin hook: bob to tool",
        "moment damping on arm",
        "force gravity on arm",
        "force gravity on nut",
        "force gravity on bob",
        "force hook on bob",
        "force hook on arm",
        "moment torque on arm",
        "force force on arm",
        "moment torque on arm",
        "omitted force on `s`",
        "omitted torque on an angle",
    ];
    assert_eq!(kinds(&format!("{ARM} emit {{ drawing }}")), expected);
}

#[test]
fn nothing_is_derived_or_emitted_that_nobody_asks_for() {
    let silent = scene(ARM);
    assert!(silent.motions.is_empty() && silent.drawing.is_empty());
    let items = |emit: &str| {
        let text = format!("struct Arm; {ARM} emit {{ {emit} }}");
        expand(text.parse().expect("tokens"), &quote!(::lagrange)).to_string()
    };
    let [silent, drawn, broken] =
        ["no drawing", "drawing", "drawing } output o = unknown; emit {"].map(items);
    assert!(!silent.contains("scene"));
    for text in [drawn, broken] {
        assert!(text.contains(":: scene :: Scene for Arm") && !text.contains("fn arm_motion"));
    }
    let all = items("drawing, motion, frames, frame_jacobians");
    assert!(all.contains("fn arm_motion") && all.contains("fn tool_frame"));
}

#[test]
fn requested_products_leave_the_equations_unchanged() {
    let [silent, asked] = ["", "emit { drawing }"].map(|emit| {
        let derived = derived(&format!("{ARM} {emit}"));
        let accelerations = derived.equations.accelerations.clone();
        let value = |role| match role {
            Role::Parameter(i) => [2.0, 0.5, 0.1][i as usize],
            Role::Input(_) => 0.7,
            Role::Coordinate(i) => [0.3, -0.5, 0.2, 0.1, 0.6][i as usize],
            Role::Velocity(i) => [-0.2, 0.1, 0.9, 0.4, -0.8][i as usize],
            _ => f64::NAN,
        };
        (derived.equations.costs, evaluate(&derived.model.graph, &accelerations, value))
    });
    assert_eq!(silent, asked);
}

#[test]
fn frames_and_springs_are_drawn_without_bodies() {
    let frame = "frame tip; revolute q = ground to tip { axis: (0, 1, 0); } kinetic = dot(q)^2;";
    let found = kinds(&format!("{frame} emit {{ drawing }}"));
    assert_eq!(found, ["frame tip", "Mobilizer(Revolute) q: nothing to tip"]);
}

#[test]
fn pins_that_hold_by_themselves_are_omitted_by_name() {
    let text = "body arm { mass: 1; inertia: (1, 1, 1); } revolute q = ground to arm { axis: (0, 0, 1); }
        pin shaft = arm.point(0, 0, 1) to (0, 0, 1); emit { drawing }";
    let found = kinds(text);
    assert_eq!(found[2..], ["Pin shaft: arm to nothing", "omitted shaft"]);
}

#[test]
fn loads_act_along_the_coordinates_of_joints() {
    let on = |joint: &str, load: &str| {
        let bodies =
            "body a { mass: 1; inertia: (1, 1, 1); } free a; body b { mass: 1; inertia: (1, 1, 1); }";
        let found = kinds(&format!("{bodies} {joint} {load} emit {{ drawing }}"));
        found.into_iter().skip(4).collect::<Vec<_>>()
    };
    let (moments, forces) =
        (["moment torque on b", "moment torque on a"], ["force force on b", "force force on a"]);
    assert_eq!(on("revolute q = a to b;", "force q = 2;"), moments);
    assert_eq!(on("revolute q = a to b;", "torque 2 on q;"), moments);
    assert_eq!(on("prismatic q = a to b;", "force q = 2;"), forces);
    assert_eq!(on("cylindrical (q, s) = a to b;", "force q = 2; force s = 1;"), [moments, forces].concat());
    assert_eq!(on("planar (x, y, p) = a to b;", "force y = 2; torque 1 on p;"), [forces, moments].concat());
    assert_eq!(on("universal (p, q) = a to b;", "force q = 2;"), moments);
    assert_eq!(on("ball hip = a to b;", "force hip_wx = 2;"), moments);
    assert_eq!(on("weld a to b;", "force a_x = 2; force a_vz = 1;"), [forces[1]; 2]);
    assert_eq!(on("weld a to b;", "coord e; kinetic = dot(e)^2; force e = 2;"), ["omitted force on `e`"]);
    assert_eq!(on("screw q = a to b { pitch: 1; damping: 2; }", ""), ["omitted damping of `q`"]);
}

#[test]
fn every_joint_is_drawn_as_what_it_is() {
    let joints = [
        ("revolute j = ground to b", MobilizerKind::Revolute),
        ("prismatic j = ground to b", MobilizerKind::Prismatic),
        ("screw j = ground to b { pitch: 1; }", MobilizerKind::Screw),
        ("cylindrical (j, k) = ground to b", MobilizerKind::Cylindrical),
        ("universal (j, k) = ground to b", MobilizerKind::Universal),
        ("planar (j, k, l) = ground to b", MobilizerKind::Planar),
        ("ball j = ground to b", MobilizerKind::Ball),
    ];
    for (joint, kind) in joints {
        let text = format!("body b {{ mass: 1; inertia: (1, 1, 1, 0, 0, 0); }} {joint}; emit {{ drawing }}");
        let expected = DrawnKind::SpatialJoint {
            name: "j".to_owned(),
            kind: SpatialJointForm::Mobilizer(kind),
            links: [None, Some("b".to_owned())],
        };
        assert_eq!(format!("{:?}", scene(&text).drawing[1].kind), format!("{expected:?}"));
    }
}

#[test]
fn solids_have_their_centers_where_the_declaration_says() {
    let scene = scene(&format!("{ARM} emit {{ drawing }}"));
    let derived = derived(&format!("{ARM} emit {{ drawing }}"));
    let cone = &scene.drawing[1].parts[0];
    assert_eq!((cone.variant, cone.dimension_count, cone.is_hole), ("Cone", 2, false));
    let parts = &derived.model.scene.drawing[1].parts[0].values;
    let found = evaluate(&derived.model.graph, parts, |role| match role {
        Role::Parameter(i) => [2.0, 0.5, 0.1][i as usize],
        _ => f64::NAN,
    });
    // The centre of mass of a cone is a quarter of its height above its base.
    let expected = [0.125, 0.5, 0.0, 0.0, 0.5 - 0.125, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    assert_eq!(found, expected);
}

#[test]
fn reduced_types_draw_where_coordinates_are_frozen() {
    // Systems with constraints are not reduced.
    let free = ARM.replace("pin hook = bob to tool;", "");
    let text = format!("{free} emit {{ drawing }} reduce Held {{ freeze s = 0; }}");
    let system = parse(&text).unwrap_or_else(|report| panic!("{report}"));
    let reduced = &system.model.reduced[0].model.scene;
    assert_eq!(reduced.drawing.len(), system.model.scene.drawing.len());
    assert_eq!(reduced.motions.len(), 3);
}
