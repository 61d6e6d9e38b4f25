//! Newton's and Euler's laws for every body of random scenes: the forces handed out for drawing are
//! complete.
//!
//! With ρ from P to the centre of mass, `m a = F` and `J_P ω̇ + m (ρ × a_P)_z = M_P` for any point
//! P of the body.

use lagrange::body::Motion;
use lagrange::scene::{Item, Plane, Scene};

/// Number of random states and parameters for each scene.
const TRIALS: u64 = 60;

lagrange::system! {
    /// Three bodies with every kind of connector, two pins and a slide.
    struct Linkage;

    param m, l, k, c, slope, push, twist;
    coord x1, y1, a1, x2, y2, a2, x3, y3, a3;

    gravity = (1/2, -9.81);
    line ramp { through: (0, -1); angle: slope; }
    body crank { mass: m; shape: slender_rod(l); center: (x1, y1); angle: a1; }
    body rod {
        mass: 2 * m;
        inertia: m * l^2;
        origin: (x2, y2);
        centroid: (l / 5, -l / 7);
        angle: a2;
    }
    body plate {
        compound {
            rectangle(l, l / 2), mass: m;
            hole semicircular_disk(l / 6), mass: m / 9, at: (l / 9, 0), angle: 0.4;
        }
        center: (x3, y3);
        angle: a3;
    }
    pin crank.point(-l / 2, 0) to (0, 0);
    pin crank.point(l / 2, 0) to rod.point(0, l / 9);
    slide plate.point(-l / 3, 0) on ramp;
    spring { from: rod.point(l, 0); to: plate.point(0, l / 4); stiffness: k; rest: l; }
    spring { from: plate; to: (3, 2); stiffness: k; }
    damper { from: crank; to: plate.point(l / 3, 0); damping: c; }
    torsion_spring { from: crank; to: plate; stiffness: k; rest: 1/3; }
    torsion_spring { from: ground; to: rod; stiffness: k; }
    torsion_damper { from: rod; to: plate; damping: c; }
    force (push, m * dot(x2)) at rod.point(l / 2, l / 3);
    force (x1, push) at plate;
    torque twist * dot(a1) on crank;
    emit { motion, drawing }
}

lagrange::system! {
    /// A wheel that rolls on a cart, which slides and turns on slides of its own.
    struct Carried;

    param m, r, k, slope, push;
    coord x1, y1, a1, x2, y2, a2, x3, y3, a3;

    gravity = (0, -9.81);
    line floor { angle: slope; }
    body cart { mass: 3 * m; shape: rectangle(4 * r, r); center: (x1, y1); angle: a1; }
    line deck { on: cart; through: (0, r / 2); angle: 0.2; }
    body wheel { mass: m; shape: disk(r); center: (x2, y2); angle: a2; }
    body ball { mass: m; shape: solid_sphere(r); center: (x3, y3); angle: a3; }
    slide cart.point(-2 * r, -r / 2) on floor;
    slide cart.point(2 * r, -r / 3) on floor;
    roll wheel on deck;
    roll ball on floor;
    spring { from: wheel; to: cart.point(-2 * r, r); stiffness: k; rest: r; }
    spring { from: ball.point(0, r / 2); to: cart; stiffness: k; rest: r; }
    force (push, 0) at wheel;
    emit { motion, drawing }
}

/// Knuth's 64-bit generator with the constants of MMIX.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Random {
        let mut random = Random(seed);
        // The first numbers of neighbouring seeds are similar.
        let _: [f64; 4] = random.vector();
        random
    }

    /// Draws a number in [−1, 1).
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) as f64 / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn positive(&mut self) -> f64 {
        1.5 + self.number()
    }

    fn vector<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| 2.0 * self.number())
    }
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The load on one body: the force, the moment about a place, and the magnitude of the summands
/// there.
#[derive(Default)]
struct Load {
    force: [f64; 2],
    moment: f64,
    size: f64,
}

fn loads<T: Scene<Scalar = f64, Space = Plane>>(
    system: &T,
    (q, v): (&T::Coordinates, &T::Velocities),
    wanted: &str,
    about: [f64; 2],
) -> Load {
    let mut load = Load::default();
    system.items(0.3, q, v, &mut |item| match item {
        Item::Force { body: Some(body), at, force, .. } if body == wanted => {
            let arm = [at[0] - about[0], at[1] - about[1]];
            load.force = [load.force[0] + force[0], load.force[1] + force[1]];
            load.moment += cross(arm, force);
            load.size += force[0].hypot(force[1]) * (1.0 + arm[0].hypot(arm[1]));
        }
        Item::Moment { body: Some(body), moment, .. } if body == wanted => {
            load.moment += moment;
            load.size += moment.abs();
        }
        _ => {}
    });
    load
}

/// Returns the bodies of a scene with their motions.
fn bodies<T: Scene<Scalar = f64, Space = Plane>>(
    system: &T,
    q: &T::Coordinates,
    v: &T::Velocities,
) -> Vec<(String, Motion<f64>)> {
    let mut bodies = Vec::new();
    system.items(0.3, q, v, &mut |item| {
        if let Item::Body { name, motion, .. } = item {
            bodies.push((name.to_owned(), motion));
        }
    });
    bodies
}

#[track_caller]
fn assert_laws<T: Scene<Scalar = f64, Space = Plane>>(
    system: &T,
    q: &T::Coordinates,
    v: &T::Velocities,
    random: &mut Random,
) {
    for (name, motion) in bodies(system, q, v) {
        let own = random.vector();
        let Load { force, moment, size } = loads(system, (q, v), &name, motion.point(own));
        assert!(size.is_finite() && size > 0.0, "{name}: {size}");
        let bound = 1e-10 * (1.0 + size);
        let rates = motion.acceleration.map(|acceleration| motion.mass * acceleration);
        for (found, expected) in rates.into_iter().zip(force) {
            assert!((found - expected).abs() <= bound, "{name}: m a = {rates:?}, F = {force:?}");
        }
        let change = motion.moment_about(own);
        assert!((change - moment).abs() <= bound, "{name}: {change} is not the moment {moment}");
    }
}

#[test]
fn forces_on_the_bodies_of_a_linkage_are_those_that_move_them() {
    for seed in 0..TRIALS {
        let mut random = Random::new(seed);
        let linkage = Linkage {
            m: random.positive(),
            l: random.positive(),
            k: random.positive(),
            c: random.positive(),
            slope: random.number(),
            push: random.number(),
            twist: random.number(),
        };
        let (q, v) = (random.vector(), random.vector());
        assert_laws(&linkage, &q, &v, &mut random);
    }
}

#[test]
fn forces_on_what_rolls_and_slides_are_those_that_move_it() {
    let mut projected = 0;
    for seed in 0..TRIALS {
        let mut random = Random::new(seed);
        let carried = Carried {
            m: random.positive(),
            r: 0.5 * random.positive(),
            k: random.positive(),
            slope: 0.5 * random.number(),
            push: random.number(),
        };
        let (mut q, mut v) = (random.vector(), random.vector());
        // The contact of a wheel is at the point of contact only if the wheel touches.
        if carried.project(0.3, &mut q, &mut v).is_ok() {
            assert_laws(&carried, &q, &v, &mut random);
            projected += 1;
        }
    }
    assert!(projected > TRIALS / 2, "only {projected}");
}

#[test]
fn joint_forces_act_on_both_bodies_with_opposite_signs() {
    let mut random = Random::new(7);
    let linkage = Linkage { m: 1.0, l: 1.0, k: 2.0, c: 0.5, slope: 0.2, push: 0.3, twist: 0.1 };
    let (mut q, mut v) = (random.vector(), random.vector());
    linkage.project(0.3, &mut q, &mut v).expect("a state that satisfies the constraints");
    let mut forces = Vec::new();
    linkage.items(0.3, &q, &v, &mut |item| {
        if let Item::Force { cause: lagrange::scene::LoadOrigin::Joint, body, at, force, .. } = item {
            forces.push((body.map(str::to_owned), at, force));
        }
    });
    let of = |name: &'static str| forces.iter().filter(move |(body, ..)| body.as_deref() == Some(name));
    let on_rod = of("rod").next().expect("a pin").clone();
    let opposite = of("crank").find(|(_, _, force)| (force[0] + on_rod.2[0]).abs() < 1e-12 * force[0].abs());
    let (_, at, force) = opposite.expect("an opposite force on the crank");
    assert!((force[1] + on_rod.2[1]).abs() < 1e-12 * force[1].abs());
    assert!((at[0] - on_rod.1[0]).abs() < 1e-10 && (at[1] - on_rod.1[1]).abs() < 1e-10);
}

#[test]
fn moments_stand_at_the_centers_of_their_bodies() {
    let mut random = Random::new(11);
    let linkage = Linkage { m: 1.0, l: 1.0, k: 2.0, c: 0.5, slope: 0.2, push: 0.3, twist: 0.1 };
    let (q, v) = (random.vector(), random.vector());
    let bodies = bodies(&linkage, &q, &v);
    let mut found = Vec::new();
    linkage.items(0.3, &q, &v, &mut |item| {
        if let Item::Moment { body: Some(body), at, .. } = item {
            let (_, motion) = bodies.iter().find(|(name, _)| name == body).expect("a body of the scene");
            assert_eq!(at, motion.center, "{body}");
            found.push(body.to_owned());
        }
    });
    found.dedup();
    assert!(found.len() > 1, "moments on several bodies: {found:?}");
}
