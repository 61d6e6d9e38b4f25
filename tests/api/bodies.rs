//! Motions of bodies and drawings of them, from the methods emitted for `motion` and `drawing`.

use lagrange::Scalar;
use lagrange::body::Motion;
use lagrange::scene::{Item, Outline, Scene};
use lagrange::system::OdeSystem;

use crate::assert_close;

lagrange::system! {
    /// A trolley on a shaking track, with a boom that carries a wheel.
    #[derive(Clone, Debug)]
    pub struct Crane<S>;

    param m = 2.0, l = 1.5, k = 20.0, g = 9.81;
    coord x, a, b;
    input u;

    gravity = (0, -g);
    line track { through: (0, sin(3 * t) / 10); }
    body trolley { mass: 3 * m; shape: rectangle(0.4, 0.2); center: (x, sin(3 * t) / 10); }
    body boom {
        compound {
            rectangle(l, l / 8), mass: m, at: (l / 2, 0);
            hole disk(l / 32), mass: m / 20, at: (l / 4, 0);
            polygon((0, 0), (l / 5, 0), (0, l / 5)), mass: m / 3, at: (l, 0), angle: 0.3;
        }
        origin: trolley.point(0.1, 0.1);
        angle: a;
    }
    body wheel { mass: m / 2; shape: disk(l / 8); center: boom.point(l, 0); angle: a + b; }
    pin axle = boom.point(l, 0) to wheel;
    spring cable { from: boom.point(l / 2, 0); to: trolley; stiffness: k; rest: l / 3; }
    torsion_damper { from: boom; to: wheel; damping: 1/10; }
    force (u, 0) at wheel.point(0, l / 8);
    emit { motion, drawing, statements }
}

lagrange::system! {
    /// A rod in single precision.
    #[scalar(f32)]
    pub struct Rod;

    param l = 2.0;
    coord x, y, a;
    body rod { mass: 3; inertia: slender_rod(3, l); shape: slender_rod(l); origin: (x, y); centroid: (l / 4, 0); angle: a; }
    spring { from: rod; to: (0, 0); stiffness: 2; }
    emit { motion }
}

lagrange::system! {
    /// A system whose names also occur in generated code.
    pub struct Visit<Item>;

    param visit = 2.0, Motion = 1.0;
    coord motion, items;
    let scene = (motion, items);
    let Part = motion * items;
    body q { mass: visit; shape: disk(Motion); center: scene; angle: Part; }
    body Body { mass: visit; center: 2 * scene; }
    output statements = scene;
    emit { motion, drawing }
}

const TIME: f64 = 0.4;
const STATE: [f64; 6] = [0.3, -0.6, 0.8, 0.5, 1.1, -0.7];

fn crane() -> Crane<f64> {
    Crane { u: 0.7, ..Crane::default() }
}

/// Returns the state a short while later, by a Runge–Kutta step whose error of fifth order is below
/// rounding here.
fn later(system: &Crane<f64>, time: f64) -> [f64; 6] {
    let moved = |by: &[f64; 6], h: f64| std::array::from_fn(|i| STATE[i] + h * by[i]);
    let half = TIME + 0.5 * time;
    let k1 = OdeSystem::rhs(system, TIME, &STATE);
    let k2 = OdeSystem::rhs(system, half, &moved(&k1, 0.5 * time));
    let k3 = OdeSystem::rhs(system, half, &moved(&k2, 0.5 * time));
    let k4 = OdeSystem::rhs(system, TIME + time, &moved(&k3, time));
    let mean = std::array::from_fn(|i| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0);
    moved(&mean, time)
}

type Method = fn(&Crane<f64>, f64, &[f64; 3], &[f64; 3]) -> Motion<f64>;

const BODIES: [(&str, Method); 3] =
    [("trolley", Crane::trolley_motion), ("boom", Crane::boom_motion), ("wheel", Crane::wheel_motion)];

fn halves([x, a, b, dx, da, db]: [f64; 6]) -> ([f64; 3], [f64; 3]) {
    ([x, a, b], [dx, da, db])
}

/// Returns the rate of a function of the motion of a body along the motion of the system, by
/// differences of sixth order.
fn rate<const N: usize>(motion: Method, f: impl Fn(&Motion<f64>) -> [f64; N]) -> [f64; N] {
    const STEP: f64 = 1e-3;
    let system = crane();
    let at = |steps: f64| {
        let (q, v) = halves(later(&system, steps * STEP));
        f(&motion(&system, TIME + steps * STEP, &q, &v))
    };
    let [a, b, c] = [1.0, 2.0, 3.0].map(|steps| {
        let (ahead, behind) = (at(steps), at(-steps));
        std::array::from_fn::<f64, N, _>(|i| ahead[i] - behind[i])
    });
    std::array::from_fn(|i| (45.0 * a[i] - 9.0 * b[i] + c[i]) / (60.0 * STEP))
}

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], expected: [f64; N]) {
    for (found, expected) in found.into_iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(error <= 1e-10 * expected.abs().max(1.0), "{found} is not {expected}");
    }
}

#[test]
fn velocities_and_accelerations_of_bodies_are_rates_along_the_motion() {
    let (q, v) = halves(STATE);
    for (_, method) in BODIES {
        let now = method(&crane(), TIME, &q, &v);
        assert_near(now.velocity, rate(method, |motion| motion.center));
        assert_near([now.angular_velocity], rate(method, |motion| [motion.angle]));
        assert_near(now.acceleration, rate(method, |motion| motion.velocity));
        assert_near([now.angular_acceleration], rate(method, |motion| [motion.angular_velocity]));
        for own in [[0.0, 0.0], [0.7, -0.3], now.centroid] {
            assert_near(now.velocity_at(own), rate(method, |motion| motion.point(own)));
            assert_near(now.acceleration_at(own).total(), rate(method, |motion| motion.velocity_at(own)));
        }
    }
}

#[test]
fn energies_of_bodies_add_up_to_that_of_the_system() {
    let (q, v) = halves(STATE);
    let energy =
        BODIES.iter().map(|(_, method)| method(&crane(), TIME, &q, &v).kinetic_energy()).sum::<f64>();
    assert_close(energy, crane().kinetic_energy(TIME, &q, &v));
}

#[test]
fn bodies_stand_where_their_declaration_says() {
    let ((q, v), system) = (halves(STATE), crane());
    let boom = system.boom_motion(TIME, &q, &v);
    let trolley = [q[0], (3.0 * TIME).sin() / 10.0];
    let [x, y] = boom.point([0.0, 0.0]);
    assert_close(x, trolley[0] + 0.1);
    assert_close(y, trolley[1] + 0.1);
    let wheel = system.wheel_motion(TIME, &q, &v);
    let [x, y] = boom.point([system.l, 0.0]);
    assert_close(wheel.center[0], x);
    assert_close(wheel.center[1], y);
    assert_eq!(wheel.angle, q[1] + q[2]);
    assert_eq!(wheel.mass, 1.0);
}

#[test]
fn scenes_hand_out_the_same_motions_with_shapes() {
    let ((q, v), system) = (halves(STATE), crane());
    let mut names = Vec::new();
    system.items(TIME, &q, &v, &mut |item| {
        if let Item::Body { name, motion, parts } = item {
            let (_, method) = BODIES[names.len()];
            assert_eq!(motion, method(&system, TIME, &q, &v));
            names.push((name.to_owned(), parts.len()));
        }
    });
    let expected = [("trolley", 1), ("boom", 3), ("wheel", 1)];
    assert_eq!(names, expected.map(|(name, parts)| (name.to_owned(), parts)));
}

#[test]
fn shapes_are_the_declared_ones() {
    let ((q, v), system) = (halves(STATE), crane());
    let (l, mut seen) = (system.l, 0);
    system.items(TIME, &q, &v, &mut |item| {
        let Item::Body { name: "boom", parts: [bar, hole, corner], .. } = item else { return };
        assert_eq!((bar.shape, bar.at, bar.is_hole), (Outline::Rectangle(l, l / 8.0), [l / 2.0, 0.0], false));
        assert_eq!((hole.shape, hole.at, hole.is_hole), (Outline::Disk(l / 32.0), [l / 4.0, 0.0], true));
        let corners = [[0.0, 0.0], [l / 5.0, 0.0], [0.0, l / 5.0]];
        let Outline::Polygon(found) = corner.shape else { panic!("{corner:?}") };
        let pairs = found.iter().flatten().zip(corners.as_flattened());
        pairs.for_each(|(found, expected)| assert_close(*found, *expected));
        assert_eq!((found.len(), corner.rotation), (3, 0.3));
        seen += 1;
    });
    assert_eq!(seen, 1);
}

/// Returns the kinds of the items with the names of what they show or act on.
fn listed(system: &Crane<f64>) -> Vec<String> {
    let ((q, v), mut list) = (halves(STATE), Vec::new());
    system.items(TIME, &q, &v, &mut |item| {
        list.push(match item {
            Item::Surface(surface) => format!("surface {}", surface.name),
            Item::Cone { name, .. } => format!("cone {name}"),
            Item::Body { name, .. } => format!("body {name}"),
            Item::Connector { name, kind, .. } => format!("{kind:?} {name}"),
            Item::Joint { name, kind, .. } => format!("{kind:?} {name}"),
            Item::Force { cause, body, .. } => format!("force {cause:?} {}", body.unwrap_or("?")),
            Item::Moment { cause, body, .. } => format!("moment {cause:?} {}", body.unwrap_or("?")),
            Item::Omitted { name } => format!("omitted {name}"),
        });
    });
    list
}

#[test]
fn items_come_in_the_order_in_which_they_are_drawn() {
    let list = listed(&crane());
    let head = ["surface track", "body trolley", "body boom", "body wheel", "Spring cable"];
    assert_eq!(list[..5], head);
    assert!(list[5].starts_with("TorsionDamper "), "{list:?}");
    assert_eq!(list[6], "Pin axle");
    // The coordinates imply the axle, so its force is unknown.
    assert!(!list.iter().any(|item| item.contains("Joint")), "{list:?}");
    assert_eq!(list.last().map(String::as_str), Some("omitted axle"));
    for load in ["force Applied wheel", "force Gravity boom", "force Connector trolley"] {
        assert!(list.contains(&load.to_owned()), "{load}: {list:?}");
    }
}

#[test]
fn statements_are_plain() {
    let statements = Crane::<f64>::STATEMENTS;
    assert!(statements.contains("kinetic = kinetic_energy("), "{statements}");
    assert!(!statements.contains("body") && !statements.contains("emit"), "{statements}");
}

#[test]
fn motions_of_other_scalars_are_the_same() {
    let rod = Rod::default();
    let motion: Motion<f32> = rod.rod_motion(0.0, &[1.0, 2.0, 0.0], &[0.5, 0.0, 2.0]);
    assert_eq!(motion.center, [1.5, 2.0]);
    assert_eq!(motion.velocity, [0.5, 1.0]);
    assert_eq!(motion.instant_center(), Some([1.0, 2.25]));
    let (q, v) = halves(STATE);
    let single = Crane::<f32> { u: 0.7, ..Crane::default() };
    let [q32, v32] = [q, v].map(|list| list.map(|x| x as f32));
    let (found, expected) = (single.boom_motion(TIME as f32, &q32, &v32), crane().boom_motion(TIME, &q, &v));
    for (found, expected) in found.acceleration.into_iter().zip(expected.acceleration) {
        assert!((f64::from(found) - expected).abs() < 1e-4 * expected.abs().max(1.0));
    }
}

/// Counts the items that a scene of any scalar hands out.
fn count<S: Scalar, T: Scene<Scalar = S, Coordinates = [S; 2], Velocities = [S; 2]>>(system: &T) -> usize {
    let mut count = 0;
    system.items(S::ZERO, &[S::ONE, S::ONE], &[S::ONE, S::ZERO], &mut |_| count += 1);
    count
}

#[test]
fn names_of_the_user_do_not_disturb_those_of_generated_code() {
    let system = Visit::<f64>::default();
    let motion = system.q_motion(0.0, &[1.0, 2.0], &[3.0, 4.0]);
    assert_eq!((motion.center, motion.angular_velocity), ([1.0, 2.0], 10.0));
    assert_eq!(system.Body_motion(0.0, &[1.0, 2.0], &[3.0, 4.0]).velocity, [6.0, 8.0]);
    assert_eq!(system.statements(0.0, &[1.0, 2.0], &[3.0, 4.0]), [1.0, 2.0]);
    assert_eq!(count(&system), 2);
}

#[test]
fn motions_that_are_no_numbers_stay_so() {
    let (q, v) = halves(STATE);
    let motion = crane().wheel_motion(f64::NAN, &q, &v);
    assert!(motion.center[1].is_nan() && motion.acceleration[0].is_nan());
    assert_eq!(motion.instant_center(), None);
}
