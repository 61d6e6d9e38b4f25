//! Drawings in space, by emitted code: Newton's and Euler's laws for bodies without joints, and a
//! scene with known positions, axes and loads.
//!
//! With the centre of mass S of a body, m a_S = F and J ω̇ + ω × J ω = M_S.

use lagrange::Scalar;
use lagrange::body::SpatialMotion;
use lagrange::scene::{
    Connector, Frame, Item, LoadOrigin, Part, Scene, Solid, Spatial, SpatialJoint, SpatialJointKind,
};
use lagrange::system::MechanicalSystem;

type Vector = [f64; 3];

/// Number of random states for each scene.
const TRIALS: u64 = 40;

lagrange::system! {
    /// Three flying bodies: with a quaternion, with angles, and as a point.
    #[accuracy(fast)]
    struct Flock;

    param m = 1.3, l = 0.7, k = 20, c = 0.6;
    input push;
    coord x, y, z, a, b, e, px, py, pz;

    gravity = (0.5, 0, -9.81);
    body bird {
        compound {
            cuboid(l, l / 2, l / 3), mass: m;
            cone(l / 4, l), mass: m / 3, at: (l / 2, 0, 0), turned: (0.2, pi / 2, -0.4);
            hole solid_sphere(l / 8), mass: m / 20, at: (-l / 4, 0, 0);
        }
    }
    free bird;
    frame beak;
    weld bird to beak { at: (l, 0, 0); turned: (0, 0, 0.3); }
    body plate {
        mass: m;
        inertia: (0.3, 0.25, 0.4, 0.02, -0.01, 0.03);
        origin: (x, y + z^2 / 4, z);
        angles: (a, b, e);
        sequence: zxy;
        centroid: (l / 5, -l / 7, 0.1);
    }
    body bob { mass: m / 2; center: (px, py, pz); }
    pin beak.origin to plate.point(0, l, 0);
    spring { from: bird.point(0, l, 0); to: plate; stiffness: k; rest: l; }
    spring { from: bob; to: (1, 2, 3); stiffness: k; }
    damper { from: beak; to: bob; damping: c; }
    force (push, dot(x), 1) at beak.point(0, l / 3, 0);
    force bob.center - (1, t, 0) at bob;
    force bird.vector(1, push, 0) at bird.point(0, 0, l);
    torque plate.vector(0.3, 0, push) on plate;
    torque (m, 0, px) on beak;
    force bird_wy = push;
    force bird_z = c;
    emit { motion, drawing }
}

/// Knuth's 64-bit generator with the constants of MMIX.
struct Random(u64);

impl Random {
    /// Draws a number in [−1, 1).
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) as f64 / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn vector<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| 1.5 * self.number())
    }
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn plus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn size(a: Vector) -> f64 {
    a.map(|component| component * component).iter().sum::<f64>().sqrt()
}

/// Returns J ω̇ + ω × J ω in the axes of the world.
fn change_of_spin(motion: &SpatialMotion<f64>) -> Vector {
    let [spin, change] =
        [motion.angular_velocity, motion.angular_acceleration].map(|vector| motion.to_body(vector));
    let times = |a: Vector| motion.inertia.map(|row| (0..3).map(|i| row[i] * a[i]).sum::<f64>());
    motion.vector(plus(times(change), cross(spin, times(spin))))
}

/// Returns the total force on a body, the moment about a place, and the magnitude of the summands.
fn loads<T: Scene<Scalar = f64, Space = Spatial>>(
    system: &T,
    (q, v): (&T::Coordinates, &T::Velocities),
    wanted: &str,
    about: Vector,
) -> (Vector, Vector, f64) {
    let (mut sum, mut turning, mut summed) = ([0.0; 3], [0.0; 3], 0.0);
    system.items(0.3, q, v, &mut |item| match item {
        Item::Force { body: Some(body), at, force, .. } if body == wanted => {
            let arm = minus(at, about);
            (sum, turning) = (plus(sum, force), plus(turning, cross(arm, force)));
            summed += size(force) * (1.0 + size(arm));
        }
        Item::Moment { body: Some(body), moment, .. } if body == wanted => {
            turning = plus(turning, moment);
            summed += size(moment);
        }
        Item::Omitted { name } => panic!("{name} is left out"),
        _ => {}
    });
    (sum, turning, summed)
}

#[test]
fn forces_on_free_bodies_are_those_that_move_them() {
    let mut random = Random(5);
    for _ in 0..TRIALS {
        let flock = Flock { push: random.number(), ..Flock::default() };
        let (mut q, v): ([f64; 16], [f64; 15]) = (random.vector(), random.vector());
        Flock::normalise(&mut q);
        let mut bodies = Vec::new();
        flock.items(0.3, &q, &v, &mut |item| {
            if let Item::Body { name, motion, .. } = item {
                bodies.push((name.to_owned(), motion));
            }
        });
        assert_eq!(
            bodies.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(),
            ["bird", "plate", "bob"]
        );
        let motion = flock.bird_motion(0.3, &q, &v);
        assert_near(bodies[0].1.center, motion.center);
        assert_eq!(bodies[0].1.angular_velocity, motion.angular_velocity);
        for (name, motion) in bodies {
            let (force, moment, summed) = loads(&flock, (&q, &v), &name, motion.center);
            assert!(summed.is_finite() && summed > 1.0, "{name}: {summed}");
            let bound = 1e-10 * (1.0 + summed);
            let rate = motion.acceleration.map(|component| motion.mass * component);
            assert!(size(minus(rate, force)) < bound, "{name}: m a = {rate:?}, F = {force:?}");
            // A point has no orientation, and no moment acts on it.
            let change = change_of_spin(&motion);
            assert!(size(minus(change, moment)) < bound, "{name}: {change:?}, M = {moment:?}");
        }
    }
}

lagrange::system! {
    /// A crane: a turning column, a trolley on its boom, and a load on a universal joint.
    #[accuracy(strict)]
    struct Crane<S>;

    param m = 2, l = 0.5, k = 30;
    input drive, pull;

    gravity = (0, 0, -10);
    body column { mass: 4 * m; shape: hollow_cylinder(l / 5, l / 4, 4 * l); centroid: (0, 0, 2 * l); }
    revolute turn = ground to column;
    body trolley { mass: m; shape: thin_sphere(l / 6); }
    prismatic way = column to trolley { at: (0, 0, 4 * l); axis: (0, 2 * l, 0); }
    frame hook;
    weld trolley to hook { at: (0, 0, -l / 6); }
    body load { mass: m; shape: cone(l, 2 * l); centroid: (0, 0, -l); }
    universal (p, r) = hook to load { turned: (0, 0, pi / 2); }
    spring rope { from: trolley; to: (0, 0, 0); stiffness: k; rest: l; }
    force turn = drive;
    force way = pull;
    force (1, 2, 3) at load.point(0, 0, -l);
    emit { drawing, frames }
}

const Q: [f64; 4] = [0.4, 0.8, -0.3, 0.2];
const V: [f64; 4] = [0.5, -0.6, 0.7, 0.1];

/// A joint as plain numbers.
struct Place {
    name: String,
    kind: SpatialJointKind,
    at: Vector,
    axis: Vector,
    bodies: [Option<String>; 2],
}

fn crane<S: Scalar>() -> Crane<S> {
    Crane { drive: S::from_f64(7.0), pull: S::from_f64(-3.0), ..Crane::default() }
}

#[track_caller]
fn assert_near(found: Vector, expected: Vector) {
    assert!(size(minus(found, expected)) < 1e-14, "{found:?} is not {expected:?}");
}

/// Returns the z-axis and the position of the trolley's frame.
fn trolley() -> (Vector, Vector) {
    let (sin, cos) = Q[0].sin_cos();
    ([-sin, cos, 0.0], [-0.8 * sin, 0.8 * cos, 2.0])
}

#[test]
fn joints_are_where_geometry_puts_them() {
    let mut joints = Vec::new();
    crane::<f64>().items(0.0, &Q, &V, &mut |item| {
        if let Item::Joint { name, kind: SpatialJoint { kind, axis, bodies }, at } = item {
            let bodies = bodies.map(|body| body.map(str::to_owned));
            joints.push(Place { name: name.to_owned(), kind, at, axis, bodies });
        }
    });
    let (boom, trolley) = trolley();
    let hook = [trolley[0], trolley[1], 2.0 - 0.5 / 6.0];
    let expected = [
        ("turn", SpatialJointKind::Revolute, [0.0; 3], [0.0, 0.0, 1.0], [None, Some("column")]),
        ("way", SpatialJointKind::Prismatic, [0.0, 0.0, 2.0], boom, [Some("column"), Some("trolley")]),
        ("hook", SpatialJointKind::Weld, hook, [0.0, 0.0, 1.0], [Some("trolley"), Some("hook")]),
        // A quarter turn, so that its x-axis is the boom.
        ("p", SpatialJointKind::Universal, hook, boom, [Some("hook"), Some("load")]),
    ];
    assert_eq!(joints.len(), expected.len());
    for (joint, (name, kind, at, axis, bodies)) in joints.iter().zip(expected) {
        assert_eq!((joint.name.as_str(), joint.kind), (name, kind));
        assert_eq!(joint.bodies.each_ref().map(Option::as_deref), bodies, "{name}");
        assert_near(joint.at, at);
        assert_near(joint.axis, axis);
    }
}

#[test]
fn motors_springs_and_weights_act_where_they_are() {
    let crane = crane::<f64>();
    let (boom, trolley) = trolley();
    let (rotation, origin) = crane.load_frame(0.0, &Q);
    let below = |depth: f64| [0, 1, 2].map(|row| origin[row] - depth * rotation[row][2]);
    let stretch = size(trolley) - 0.5;
    let rope = trolley.map(|component| -30.0 * stretch * component / size(trolley));
    let pull = boom.map(|component| -3.0 * component);
    let weights = [(Some("column"), [0.0, 0.0, 1.0], -80.0), (Some("trolley"), trolley, -20.0)];
    let mut expected = weights.map(|(body, at, weight)| (body, at, [0.0, 0.0, weight])).to_vec();
    expected.push((Some("load"), below(0.5), [0.0, 0.0, -20.0]));
    expected.push((Some("trolley"), trolley, rope));
    expected.push((Some("trolley"), trolley, pull));
    expected.push((Some("column"), trolley, pull.map(|component| -component)));
    expected.push((Some("load"), below(0.5), [1.0, 2.0, 3.0]));
    let (mut number, mut moments) = (0, 0);
    crane.items(0.0, &Q, &V, &mut |item| match item {
        Item::Force { body, at, force, .. } => {
            assert_eq!(body, expected[number].0);
            assert_near(at, expected[number].1);
            assert!(
                size(minus(force, expected[number].2)) < 1e-12,
                "{force:?} is not {:?}",
                expected[number]
            );
            number += 1;
        }
        Item::Moment { body, cause, at, moment, .. } => {
            assert_eq!(
                (body, cause, at, moment),
                (Some("column"), LoadOrigin::Applied, [0.0; 3], [0.0, 0.0, 7.0])
            );
            moments += 1;
        }
        Item::Connector { name, kind, from, to, tension } => {
            assert_eq!((name, kind, to), ("rope", Connector::Spring, [0.0; 3]));
            assert_near(from, trolley);
            assert!((tension - 30.0 * stretch).abs() < 1e-12);
        }
        Item::Omitted { name } => panic!("{name} is left out"),
        _ => {}
    });
    assert_eq!((number, moments), (expected.len(), 1));
}

#[test]
fn solids_and_frames_lie_where_the_declaration_puts_them() {
    let crane = crane::<f64>();
    let mut solids = Vec::new();
    crane.items(0.0, &Q, &V, &mut |item| match item {
        Item::Body { parts, .. } => solids.extend(parts.iter().map(|part| (part.shape, part.at))),
        Item::Frame(Frame { name, rotation, origin }) => {
            assert_eq!((name, (rotation, origin)), ("hook", crane.hook_frame(0.0, &Q)));
        }
        _ => {}
    });
    let expected = [
        (Solid::HollowCylinder(0.1, 0.125, 2.0), [0.0, 0.0, 1.0]),
        (Solid::Sphere(0.5 / 6.0), [0.0; 3]),
        // Its centre of mass is a quarter of its height above its base.
        (Solid::Cone(0.5, 1.0), [0.0, 0.0, -0.75]),
    ];
    for ((solid, at), (expected, place)) in solids.iter().zip(expected) {
        assert_eq!(*solid, expected);
        assert_near(*at, place);
    }
    assert_eq!(solids.len(), expected.len());
}

#[test]
fn drawings_are_the_same_in_single_precision() {
    let single = |item: Item<'_, f32, Spatial>| match item {
        Item::Body { name, parts, .. } => (name.to_owned(), parts.first().map(|part| part.at[2])),
        Item::Joint { name, at, .. } => (name.to_owned(), Some(at[1])),
        Item::Force { name, force, .. } => (name.to_owned(), Some(force[2])),
        _ => (String::new(), None),
    };
    let double = |item: Item<'_, f64, Spatial>| match item {
        Item::Body { name, parts, .. } => {
            (name.to_owned(), parts.first().map(|part: &Part<'_, _, _>| part.at[2]))
        }
        Item::Joint { name, at, .. } => (name.to_owned(), Some(at[1])),
        Item::Force { name, force, .. } => (name.to_owned(), Some(force[2])),
        _ => (String::new(), None),
    };
    let (mut rough, mut fine) = (Vec::new(), Vec::new());
    let (q, v) = (Q.map(|number| number as f32), V.map(|number| number as f32));
    crane::<f32>().items(0.0, &q, &v, &mut |item| rough.push(single(item)));
    crane::<f64>().items(0.0, &Q, &V, &mut |item| fine.push(double(item)));
    assert_eq!(rough.len(), fine.len());
    for ((name, rough), (other, fine)) in rough.iter().zip(&fine) {
        assert_eq!(name, other);
        let near = |(a, b): (f32, f64)| (f64::from(a) - b).abs() < 1e-5 * (1.0 + b.abs());
        assert!(
            rough.is_some() == fine.is_some() && rough.zip(*fine).is_none_or(near),
            "{name}: {rough:?}, {fine:?}"
        );
    }
}
