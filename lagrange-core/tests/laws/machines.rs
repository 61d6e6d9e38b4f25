//! Random machines as declarations: plane trees of bodies in absolute or relative coordinates, with
//! loads.

use std::fmt::Write;

use proptest::prelude::{Just, Strategy, any, prop, prop_oneof};

/// The largest number of bodies, and of coordinates, of a machine.
const MAX_BODIES: usize = 5;

/// Supports of the machine: a point and a direction.
const SUPPORTS: [&str; 3] = [
    "let (x0, y0) = (0, 0); let a0 = 0;",
    "let (x0, y0) = (sin(3*t)/5, t^2/7); let a0 = 0;",
    "let (x0, y0) = (1/3, 0); let a0 = t/2 + cos(t)/4;",
];

/// Position of body `#` in its coordinate `q#` and the position of its parent `@`.
const JOINTS: [&str; 5] = [
    "let a# = q#; let (x#, y#) = (x@ + l#*sin(a#), y@ - l#*cos(a#));",
    "let a# = a@ + q#; let (x#, y#) = (x@ + l#*sin(a#), y@ - l#*cos(a#));",
    "let a# = a@; let (x#, y#) = (x@ + (l# + q#)*sin(a@), y@ - (l# + q#)*cos(a@));",
    "let a# = a@ + 1/2; let (x#, y#) = (x@ + q#, y@ - l#);",
    "let a# = a@ + q#/2; let (x#, y#) = (x@ + 2*q# - l#*sin(a#), y@ + 1 - l#*cos(a#));",
];

/// The kinetic energy of body `#`, which is definite in `dot(q#)` while its parent rests.
const INERTIAS: [&str; 11] = [
    "kinetic = 1/2*m#*(dot(x#)^2 + dot(y#)^2);",
    "kinetic = kinetic_energy(m#, (dot(x#), dot(y#))) + 1/2*m#*dot(a#)^2;",
    "let p# = ((x# + x@)/2, (y# + y@)/2); kinetic = kinetic_energy(m#, dot(p#)) + m#*l#^2/24*dot(a#)^2;",
    "kinetic = 1/2*m#*(1 + sin(x# + q#)/4)*(dot(x#)^2 + dot(y#)^2);",
    "kinetic = 1/2*(m# + exp(-q#^2))*dot(x#)^2 + 1/2*m#*dot(y#)^2;",
    "kinetic = 1/2*m#*(dot(x#)^2 + dot(y#)^2 + (dot(a#) + sin(t))^2);",
    "kinetic = 1/2*m#*(dot(x#)^2 + dot(y#)^2) + dot(q#)^4/40;",
    "kinetic = 1/2*m#*(1 + sin(t)^2)*(dot(x#)^2 + dot(y#)^2) + m#/5*dot(x#)*dot(y#);",
    "kinetic = 1/2*m#*(dot(x#) + dot(y#))^2 + 1/3*m#*(dot(x#) - 2*dot(y#))^2;",
    "let s# = dot(x#)^2 + dot(y#)^2; kinetic = 1/2*m#*s# + s#^2/50;",
    "kinetic = (if x# < y# { m# } else { m# + (x# - y#)^5/9 })*inner(dot((x#, y#)), dot((x#, y#)))/2;",
];

/// Further loads on body `#`.
const EXTRAS: [&str; 13] = [
    "potential = gravitational_energy(m#, g, y#);",
    "potential = spring_energy(k, q# - 1/4);",
    "potential = spring_energy(k, norm((x# - 1, y# + 9)) - 1/2);",
    "potential = k*cos(q# - t)/5 + u*x#;",
    "potential = if q# < 1/5 { 0 } else { k*(q# - 1/5)^5 };",
    "potential = g*m#*max(y#, 0)^5/(1 + abs(x#)^3);",
    "dissipation = 1/2*c*dot(q#)^2;",
    "dissipation = c*(dot(x#)^2 + dot(y#)^2) + c*sqrt(1 + dot(a#)^2);",
    "force q# = u*cos(2*t) - c*q#*dot(q#);",
    "force (u, -c*norm(dot((x#, y#)))*dot(y#)) at (x#, y#);",
    "force -c*dot((x#, y#)) at (x# + sin(q#), y# + t);",
    "torque u - c*t on a# + q#;",
    "torque c*dot(q#) on q# - q@;",
];

/// Potentials that depend on velocities, for declarations of the Lagrangian itself.
const GYROSCOPIC: [&str; 3] = [
    "lagrangian = b/2*(x#*dot(y#) - y#*dot(x#));",
    "lagrangian = b*sin(t + q#)*dot(q#);",
    "lagrangian = dot(q#)^2*sqrt(1 + dot(q#)^2)/9;",
];

/// A declaration and a state.
#[derive(Clone, Debug)]
pub(crate) struct Machine {
    pub(crate) text: String,
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
}

impl Machine {
    /// Returns the same machine at the level of accuracy `strict`.
    pub(crate) fn strict(&self) -> Machine {
        Machine { text: format!("#[accuracy(strict)] struct Machine;\n{}", self.text), ..self.clone() }
    }
}

/// A body: its parent, joint, inertia, mass and length in tenths, and loads.
#[derive(Clone, Debug)]
struct Body {
    parent: usize,
    joint: &'static str,
    inertia: &'static str,
    tenths: (u32, u32),
    extras: Vec<&'static str>,
}

/// Returns any machine.
pub(crate) fn machines() -> impl Strategy<Value = Machine> {
    let formulation = prop_oneof![3 => Just(false), 1 => Just(true)];
    let bodies = prop::collection::vec(body(), 1..=MAX_BODIES);
    let number = || (-150..150).prop_map(|hundredths: i32| f64::from(hundredths) / 100.0);
    let vector = || prop::collection::vec(number(), MAX_BODIES);
    let state = (number(), vector(), vector());
    (prop::sample::select(SUPPORTS.to_vec()), bodies, formulation, state).prop_map(
        |(support, bodies, as_lagrangian, (t, q, v))| {
            let n = bodies.len();
            Machine {
                text: declaration(support, &bodies, as_lagrangian),
                t,
                q: q[..n].into(),
                v: v[..n].into(),
            }
        },
    )
}

fn body() -> impl Strategy<Value = Body> {
    let choice = |list: &[&'static str]| prop::sample::select(list.to_vec());
    let extras = prop::sample::subsequence([EXTRAS.as_slice(), &GYROSCOPIC].concat(), 0..=4);
    (any::<prop::sample::Index>(), choice(&JOINTS), choice(&INERTIAS), (2..20_u32, 3..12_u32), extras)
        .prop_map(|(parent, joint, inertia, tenths, extras)| {
            let parent = parent.index(usize::MAX);
            Body { parent, joint, inertia, tenths, extras }
        })
}

fn declaration(support: &str, bodies: &[Body], as_lagrangian: bool) -> String {
    let mut text =
        "const g = 9.81; param k = 2.5, c = 0.3, b = 0.7; input u = 0.8; emit { bias, momentum_rates, latex };\n".to_owned();
    for (i, body) in (1..).zip(bodies) {
        let (mass, length) = (f64::from(body.tenths.0) / 10.0, f64::from(body.tenths.1) / 10.0);
        writeln!(text, "param m{i} = {mass}, l{i} = {length}; coord q{i};").expect("a string takes it");
    }
    writeln!(text, "let q0 = 0; {support}").expect("a string takes it");
    for (i, body) in (1..).zip(bodies) {
        let parent = (body.parent % i).to_string();
        let extras = body.extras.iter().filter(|extra| as_lagrangian || !extra.starts_with("lagrangian"));
        for template in [&body.joint, &body.inertia].into_iter().chain(extras) {
            let statement = template.replace('#', &i.to_string()).replace('@', &parent);
            text.push_str(&if as_lagrangian { joined(&statement) } else { statement });
            text.push('\n');
        }
    }
    text
}

/// Joins the energies of a statement as terms of the Lagrangian.
fn joined(statement: &str) -> String {
    match statement.strip_prefix("potential = ") {
        Some(potential) => format!("lagrangian = -({});", potential.trim_end_matches(';')),
        None => statement.replace("kinetic = ", "lagrangian = "),
    }
}
