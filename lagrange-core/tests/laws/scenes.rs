//! In any scene of rigid bodies, the forces and moments handed out for drawing are complete.
//!
//! With ρ from a point P of the body to its centre of mass, m a = F and J_P ω̇ + m (ρ × a_P)_z =
//! M_P.

use std::fmt::Write;

use lagrange_core::bodies::DrawnKind;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::expr::ExprId;
use lagrange_core::expr::evaluate;
use lagrange_core::model::BodyMotion;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use lagrange_core::symbol::Role;
use proptest::prelude::{Strategy, any, prop, prop_assert, proptest};

use crate::one_in;

/// The largest number of bodies in a scene.
const MAX_BODIES: usize = 3;

/// Placements of body `#`: any three coordinates that let it move freely.
const PLACES: [&str; 4] = [
    "center: (x#, y#); angle: a#;",
    "origin: (x# - sin(y#)/3, y# + t*x#); angle: a# + t^2/5;",
    "origin: (x#, y#); angle: -a# + x#/2;",
    "center: ((2 + x#^2)*x#, y# - 1); angle: 2*a# - y#;",
];

/// Inertias of a body; `%` is a number between 1 and 2.
const MATTER: [&str; 5] = [
    "mass: %; inertia: 1/%; centroid: (1/5, -%/4);",
    "mass: %; shape: rectangle(%, 0.4);",
    "mass: %; shape: semicircular_disk(%);",
    "mass: %; shape: triangle(1, %, 1.5); inertia: 0.7;",
    "compound { disk(%), mass: 2; hole slender_rod(1), mass: 1/3, at: (%/5, 0), angle: 0.3; }",
];

/// Joints of body `#`, with the earlier body `@` if there is one.
const JOINTS: [(&str, &str); 5] = [
    ("", ""),
    ("pin b#.point(0.3, %) to b@.point(-%, 0.4);", "pin b#.point(0.3, %) to (sin(t), %);"),
    (
        "line r# { on: b@; through: (0.1, %); angle: %; } slide b#.point(0.5, -%) on r#;",
        "line r# { through: (0, t); angle: %; } slide b#.point(0.5, -%) on r#;",
    ),
    ("pin b@ to b#.point(%, 0);", "pin (0, 1) to b#.point(%, 0);"),
    (
        "line r# { angle: %*t; } roll b# on r#, radius: %;",
        "line r# { through: (1, 0); } roll b# on r#, radius: %;",
    ),
];

/// Further loads on body `#`, and on `@` if there is one.
const LOADS: [(&str, &str); 6] = [
    (
        "spring { from: b#.point(%, 0); to: b@; stiffness: %; rest: 1/2; }",
        "spring { from: b#; to: (0, 9); stiffness: %; }",
    ),
    (
        "damper { from: b@; to: b#.point(0.1, %); damping: %; }",
        "damper { from: b#; to: (%, 8); damping: %; }",
    ),
    (
        "torsion_spring { from: b#; to: b@; stiffness: %; rest: 0.1; }",
        "torsion_spring { from: ground; to: b#; stiffness: %; }",
    ),
    (
        "torsion_damper { from: b@; to: b#; damping: %; }",
        "torsion_damper { from: b#; to: ground; damping: %; }",
    ),
    ("force (%, dot(x#)) at b#.point(0.2, %); torque t*% on b@;", "force b#.center - (1, t) at b#;"),
    ("torque dot(a@) - % on b#;", "torque %*x# on b#;"),
];

/// A declaration and a state.
#[derive(Clone, Debug)]
struct Stage {
    text: String,
    q: Vec<f64>,
    v: Vec<f64>,
}

/// The indices of the choices from the lists above for one body.
type Choice = (usize, usize, usize, usize, Vec<usize>);

fn stages() -> impl Strategy<Value = Stage> {
    let loads = prop::collection::vec(0..LOADS.len(), 0..=3);
    let body = (0..PLACES.len(), 0..MATTER.len(), 0..JOINTS.len(), any::<usize>(), loads);
    let number = || (-150..150).prop_map(|hundredths: i32| f64::from(hundredths) / 100.0);
    let state = || prop::collection::vec(number(), 3 * MAX_BODIES);
    let numbers = prop::collection::vec(10..20_u32, 16);
    (prop::collection::vec(body, 1..=MAX_BODIES), state(), state(), numbers).prop_map(
        |(bodies, q, v, tenths)| {
            let count = 3 * bodies.len();
            Stage { text: declaration(&bodies, &tenths), q: q[..count].into(), v: v[..count].into() }
        },
    )
}

fn declaration(bodies: &[Choice], tenths: &[u32]) -> String {
    let mut text = "gravity = (1/3, -9.81); emit { motion, drawing }\n".to_owned();
    for (i, (place, matter, joint, parent, loads)) in bodies.iter().enumerate() {
        let parent = i.checked_sub(1).map(|last| parent % (last + 1));
        let pick = |(with, without): (&str, &str)| match parent {
            Some(parent) => with.replace('@', &parent.to_string()),
            None => without.to_owned(),
        };
        let mut lines = format!("coord x#, y#, a#; body b# {{ {} {} }}\n", MATTER[*matter], PLACES[*place]);
        writeln!(lines, "{}", pick(JOINTS[*joint])).expect("a string");
        for &load in loads {
            writeln!(lines, "{}", pick(LOADS[load])).expect("a string");
        }
        text += &lines.replace('#', &i.to_string());
    }
    let mut numbers = tenths.iter().cycle();
    let pieces = text.split('%').map(str::to_owned).collect::<Vec<_>>();
    let (first, rest) = pieces.split_first().expect("a piece");
    rest.iter().fold(first.clone(), |text, piece| {
        let tenth = numbers.next().expect("a cycle");
        format!("{text}{}.{}{piece}", tenth / 10, tenth % 10)
    })
}

/// A scene at one moment.
struct Scene {
    derived: Derived,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    multipliers: Vec<f64>,
}

const TIME: f64 = 0.7;

impl Scene {
    fn new(stage: Stage) -> Scene {
        let Stage { text, q, v } = stage;
        let system = parse(&text).unwrap_or_else(|report| panic!("{text}\n{report}"));
        let derived =
            system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{text}\n{report}"));
        let numeric = NumericSystem::new(&derived);
        let (a, multipliers) = (numeric.acceleration(TIME, &q, &v), numeric.multipliers(TIME, &q, &v));
        Scene { derived, q, v, a, multipliers }
    }

    fn values(&self, roots: &[ExprId]) -> Vec<f64> {
        evaluate(&self.derived.model.graph, roots, |role| match role {
            Role::Time => TIME,
            Role::Coordinate(i) => self.q[i as usize],
            Role::Velocity(i) => self.v[i as usize],
            Role::Acceleration(i) => self.a[i as usize],
            Role::Multiplier(i) => self.multipliers[i as usize],
            other => panic!("{other:?}"),
        })
    }

    /// Returns the total force and the total moment about a place on a body, with the magnitude of
    /// their summands.
    fn load(&self, wanted: &str, about: [f64; 2]) -> ([f64; 2], f64, f64) {
        let (mut force, mut moment, mut size) = ([0.0; 2], 0.0, 1.0);
        for item in &self.derived.model.scene.drawing {
            let values = self.values(&item.values);
            match (&item.kind, values.as_slice()) {
                (DrawnKind::Force { body: Some(body), .. }, &[x, y, fx, fy]) if body == wanted => {
                    let arm = [x - about[0], y - about[1]];
                    force = [force[0] + fx, force[1] + fy];
                    moment += arm[0] * fy - arm[1] * fx;
                    size += fx.hypot(fy) * (1.0 + arm[0].hypot(arm[1]));
                }
                (DrawnKind::Moment { body: Some(body), .. }, &[_, _, value]) if body == wanted => {
                    moment += value;
                    size += value.abs();
                }
                _ => {}
            }
        }
        (force, moment, size)
    }
}

/// Returns `m a` of a body, and `J_P ω̇ + m (ρ × a_P)_z` with the position of P, which is at ρ
/// before the centre of mass.
fn rates(motion: &[f64], rho: [f64; 2]) -> ([f64; 2], f64, [f64; 2]) {
    let &[m, j, _, _, x, y, _, _, _, omega, ax, ay, alpha] = motion else { panic!("{motion:?}") };
    let acceleration =
        [ax + alpha * rho[1] + omega * omega * rho[0], ay - alpha * rho[0] + omega * omega * rho[1]];
    let about = j + m * (rho[0] * rho[0] + rho[1] * rho[1]);
    let moment = about * alpha + m * (rho[0] * acceleration[1] - rho[1] * acceleration[0]);
    ([m * ax, m * ay], moment, [x - rho[0], y - rho[1]])
}

proptest! {
    #![proptest_config(one_in(16))]

    #[test]
    fn forces_that_are_drawn_are_those_that_move_the_bodies(stage in stages(), rho in [-2.0..2.0, -2.0..2.0_f64]) {
        let scene = Scene::new(stage);
        for BodyMotion { body, values } in &scene.derived.model.scene.motions {
            let (change, spin, place) = rates(&scene.values(values), rho);
            let (force, moment, size) = scene.load(&body.text, place);
            let bound = 1e-9 * size;
            for (found, expected) in force.iter().zip(change) {
                prop_assert!((found - expected).abs() <= bound, "{}: {force:?} is not {change:?}", body.text);
            }
            prop_assert!((moment - spin).abs() <= bound, "{}: {moment} is not {spin}", body.text);
        }
    }
}
