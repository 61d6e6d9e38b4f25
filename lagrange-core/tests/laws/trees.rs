//! Random trees of bodies whose kinetic energy is a sum of squares, in the plane and in space, as
//! declarations.

use std::fmt::Write;

use proptest::prelude::{Just, Strategy, any, prop, prop_oneof};

use crate::machines::Machine;

/// The largest number of bodies, and of coordinates, of a tree.
const MAX_BODIES: usize = 5;

/// Supports of the tree: a point and a direction.
const SUPPORTS: [&str; 3] = [
    "let p0 = (0, 0, 0); let a0 = 0;",
    "let p0 = (sin(3*t)/5, t^2/7, cos(t)/3); let a0 = 0;",
    "let p0 = (1/3, 0, t/9); let a0 = t/2 + cos(t)/4;",
];

/// Position of body `#` in its coordinate `q#` and the position of its parent `@`.
const JOINTS: [&str; 6] = [
    "let a# = q#; let p# = p@ + (l#*sin(a#), -l#*cos(a#), 0);",
    "let a# = a@ + q#; let p# = p@ + (l#*sin(a#), -l#*cos(a#), 0);",
    "let a# = a@ - q#/2; let p# = p@ + (l#*sin(a#) + q#, -l#*cos(a#), 0);",
    "let a# = a@; let p# = p@ + ((l# + q#)*sin(a@), -(l# + q#)*cos(a@), q#/3);",
    "let a# = a@; let p# = p@ + (l#*cos(q#)*sin(a@), -l#*cos(q#)*cos(a@), l#*sin(q#));",
    "let a# = a@ + 1/2; let p# = p@ + (q#, -l#, q#/2);",
];

/// The kinetic energy of body `#`, which is definite in `dot(q#)` while its parent rests.
const INERTIAS: [&str; 7] = [
    "kinetic = kinetic_energy(m#, dot(p#));",
    "kinetic = kinetic_energy(m#, dot(p#)) + 1/2*m#/9*dot(a#)^2;",
    "kinetic = kinetic_energy(m#, dot((p# + p@)/2)) + 1/2*m#*l#^2/12*dot(a#)^2 + kinetic_energy(1/4, dot(p#));",
    "kinetic = kinetic_energy(m#, dot(p#)) + 1/2*m#/4*dot(q#)^2 + 1/2*m#/7*dot(a# - a@)^2;",
    "kinetic = kinetic_energy(m#*(1 + sin(q#)^2), dot(p#));",
    "kinetic = kinetic_energy(m#*(2 + sin(t)), dot(p#)) + 1/2*m#*dot(q# - cos(t))^2;",
    "kinetic = kinetic_energy(m#, dot(p#)) + kinetic_energy(m#/2, dot(p# + (cos(a#), sin(a#), 1)/5));",
];

/// Further loads on body `#`.
const EXTRAS: [&str; 11] = [
    "potential = gravitational_energy(m#, g, p#.y);",
    "potential = spring_energy(k, q# - 1/4);",
    "potential = spring_energy(k, norm(p# - p@ - (1, 9, 2)) - 1/2);",
    "potential = spring_energy(k, a# - a@);",
    "potential = k*cos(q# - t)/5 + u*p#.x;",
    "dissipation = 1/2*c*dot(q#)^2;",
    "dissipation = c*inner(dot(p#), dot(p#)) + 1/2*c*dot(a# - a@)^2;",
    "force q# = u*cos(2*t) - c*q#*dot(q#);",
    "force (u, -c*norm(dot(p#))*dot(p#.y), t) at p#;",
    "force -c*dot(p#) at p# + (sin(q#), t, 0);",
    "torque u - c*t on a# - a@ + q#;",
];

/// A body: its parent, joint, inertia, mass and length in tenths, and loads.
#[derive(Clone, Debug)]
struct Body {
    parent: prop::sample::Index,
    joint: &'static str,
    inertia: &'static str,
    tenths: (u32, u32),
    extras: Vec<&'static str>,
}

/// Returns any tree.
pub(crate) fn trees() -> impl Strategy<Value = Machine> {
    let bodies = prop::collection::vec(body(), 1..=MAX_BODIES);
    // At zero, single squares lose an unknown.
    let number = || prop_oneof![1 => Just(0.0), 3 => (-150..150).prop_map(|n: i32| f64::from(n) / 100.0)];
    let vector = || prop::collection::vec(number(), MAX_BODIES);
    let state = (number(), vector(), vector());
    (prop::sample::select(SUPPORTS.to_vec()), bodies, state).prop_map(|(support, bodies, (t, q, v))| {
        let n = bodies.len();
        Machine { text: declaration(support, &bodies), t, q: q[..n].into(), v: v[..n].into() }
    })
}

fn body() -> impl Strategy<Value = Body> {
    let choice = |list: &[&'static str]| prop::sample::select(list.to_vec());
    let extras = prop::sample::subsequence(EXTRAS.to_vec(), 0..=3);
    let tenths = (2..20_u32, 3..12_u32);
    (any::<prop::sample::Index>(), choice(&JOINTS), choice(&INERTIAS), tenths, extras)
        .prop_map(|(parent, joint, inertia, tenths, extras)| Body { parent, joint, inertia, tenths, extras })
}

fn declaration(support: &str, bodies: &[Body]) -> String {
    let mut text = "const g = 9.81; param k = 2.5, c = 0.3; input u = 0.8;\n".to_owned();
    writeln!(text, "let q0 = 0; {support}").expect("a string takes it");
    for (i, body) in (1..).zip(bodies) {
        let (mass, length) = (f64::from(body.tenths.0) / 10.0, f64::from(body.tenths.1) / 10.0);
        writeln!(text, "param m{i} = {mass}, l{i} = {length}; coord q{i};").expect("a string takes it");
        let parent = body.parent.index(i).to_string();
        for template in [&body.joint, &body.inertia].into_iter().chain(&body.extras) {
            text.push_str(&template.replace('#', &i.to_string()).replace('@', &parent));
            text.push('\n');
        }
    }
    text
}
