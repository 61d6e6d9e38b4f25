//! Surfaces that bodies carry.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction};

use crate::{G, assert_near, flat};

lagrange::system! {
    /// A disk on a wedge that glides along the ground.
    #[derive(Clone, Debug)]
    struct Wedge;

    param heavy = 3, light = 2, r = 0.2, mu = 0.8, angle = 0.5;
    coord s, x, y, phi;
    gravity = (0, -9.81);
    body wedge { mass: heavy; origin: (s, 0); }
    line slope { on: wedge; through: (0, 1); angle: -angle; }
    body wheel { mass: light; center: (x, y); angle: phi; shape: disk(r); }
    contact touch = wheel on slope { friction: mu; }
    output slip = touch.slip;
}

lagrange::system! {
    /// A ball on a wedge that glides along x.
    #[derive(Clone, Debug)]
    struct WedgeInSpace;

    param heavy = 3, light = 2, r = 0.2, mu = 0.8, angle = 0.5;
    gravity = (0, 0, -9.81);
    body wedge { mass: heavy; inertia: (1, 1, 1); }
    prismatic s = ground to wedge { axis: (1, 0, 0); }
    plane slope { on: wedge; through: (0, 0, 1); normal: (sin(angle), 0, cos(angle)); }
    body ball { mass: light; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on slope { friction: mu; }
}

lagrange::system! {
    /// A plate that rotates about a vertical axis, with a ball on it.
    #[derive(Clone, Debug)]
    struct Turntable;

    param r = 0.05, mu = 2;
    gravity = (0, 0, -9.81);
    body table { mass: 1; inertia: (1e9, 1e9, 1e9); }
    revolute turn = ground to table;
    plane top { on: table; }
    body ball { mass: 0.5; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on top { friction: mu; }
}

lagrange::system! {
    /// A freely falling and rotating box with a ball inside: no external forces act.
    #[derive(Clone, Debug)]
    struct Lid;

    param r = 0.1, mu = 0.3, e = 0.6;
    gravity = (0, 0, 0);
    body plate { mass: 2; shape: cuboid(1, 1, 0.2); }
    free plate;
    plane top { on: plate; through: (0, 0, 0.1); }
    body ball { mass: 1; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on top { friction: mu; restitution: e; }
    output momentum = linear_momentum(plate) + linear_momentum(ball);
    output spin = angular_momentum(plate, (0, 0, 0)) + angular_momentum(ball, (0, 0, 0));
}

lagrange::system! {
    /// The box with a ball in the plane.
    #[derive(Clone, Debug)]
    struct LidInThePlane;

    param r = 0.1, mu = 0.3, e = 0.6;
    coord a, b, alpha, x, y, phi;
    gravity = (0, 0);
    body plate { mass: 2; center: (a, b); angle: alpha; shape: rectangle(1, 0.2); }
    line top { on: plate; through: (0, 0.1); }
    body ball { mass: 1; center: (x, y); angle: phi; shape: disk(r); }
    contact touch = ball on top { friction: mu; restitution: e; }
    output momentum = linear_momentum(plate) + linear_momentum(ball);
    output spin = angular_momentum(plate, (0, 0)) + angular_momentum(ball, (0, 0));
}

lagrange::system! {
    /// A parcel on an obliquely moving belt.
    #[derive(Clone, Debug)]
    struct Belt;

    param mu = 0.3, along = 1.2, across = 0.5;
    gravity = (0, 0, -9.81);
    plane belt { through: (along * t, across * t, 0); }
    body parcel { mass: 3; inertia: (1, 1, 1); }
    free parcel;
    contact touch = parcel on belt { friction: mu; }
}

/// It moves with the belt after |v|/μg, |v|²/2μg behind.
#[test]
fn a_parcel_is_taken_along_by_a_belt() {
    let belt = Belt::default();
    let run = belt.simulate(flat([0.0; 3], [0.0; 3], [0.0; 3])).until(1.0).tolerance(1e-12).run();
    let run = run.expect("is taken along");
    let stop = 1.3 / (0.3 * G);
    let [event] = run.events() else { panic!("{:?}", run.events()) };
    assert!((event.time - stop).abs() < 1e-11, "{}", event.time);
    let last = run.last();
    let part = 1.0 - 0.5 * stop;
    assert_near([last[0], last[1], last[7], last[8]], [1.2 * part, 0.5 * part, 1.2, 0.5], 1e-11);
}

/// Returns accelerations with s along the slope and κ = 1 + J/mr² of the rolling body. They satisfy
/// s̈ (κ − m cos²α/(M + m)) = g sin α, and the wedge moves by −m cos α s̈/(M + m).
fn rolling(kappa: f64) -> (f64, f64) {
    let (sin, cos) = 0.5_f64.sin_cos();
    let along = G * sin / (kappa - 2.0 * cos * cos / 5.0);
    (along, -2.0 * cos * along / 5.0)
}

#[test]
fn a_disk_rolls_down_a_wedge_that_recoils() {
    let (sin, cos) = 0.5_f64.sin_cos();
    let start = [0.0, 0.2 * sin, 1.0 + 0.2 * cos, 0.0, 0.0, 0.0, 0.0, 0.0];
    let run = Wedge::default().simulate(start).until(0.5).tolerance(1e-12).run().expect("rolls");
    let (along, back) = rolling(1.5);
    let [s, x, y, phi, vs, vx, ..] = run.last();
    assert_near([s, vs], [0.125 * back, 0.5 * back], 1e-11);
    let place = [0.2 * sin + 0.125 * (back + along * cos), 1.0 + 0.2 * cos - 0.125 * along * sin];
    assert_near([x, y, phi], [place[0], place[1], -0.125 * along / 0.2], 1e-11);
    assert!((3.0 * vs + 2.0 * vx).abs() < 1e-12);
    assert_eq!(run.system_at_end().expect("touches").touch_friction, Friction::Sticks);
}

#[test]
fn a_ball_rolls_down_a_wedge_that_recoils() {
    let (sin, cos) = 0.5_f64.sin_cos();
    let ball = flat([0.2 * sin, 0.0, 1.0 + 0.2 * cos], [0.0; 3], [0.0; 3]);
    let [place, motion] = [&ball[..7], &ball[7..]];
    let start: Vec<f64> = [&[0.0], place, &[0.0], motion].concat();
    let start: [f64; 15] = start.try_into().expect("fifteen");
    let run = WedgeInSpace::default().simulate(start).until(0.5).tolerance(1e-12).run().expect("rolls");
    let (along, back) = rolling(1.4);
    let last = run.last();
    assert_near([last[0], last[8]], [0.125 * back, 0.5 * back], 1e-11);
    let x = 0.2 * sin + 0.125 * (back + along * cos);
    assert_near([last[1], last[2]], [x, 0.0], 1e-11);
    assert_near([last[13]], [0.5 * along / 0.2], 1e-10);
}

/// On a turntable with Ω a rolling ball moves on a circle with 2/7 Ω (Weltner, *American Journal of
/// Physics* 47, 1979).
#[test]
fn a_ball_on_a_turntable_moves_on_a_circle() {
    let spin = 4.0;
    let ball = flat([0.3, 0.0, 0.05], [0.1, 0.2, 0.0], [0.0; 3]);
    // It rolls where −r ω × n cancels the velocity relative to the table.
    let relative = [0.1, 0.2 - spin * 0.3];
    let omega = [-relative[1] / 0.05, relative[0] / 0.05, 0.7];
    let start: Vec<f64> = [&[0.0], &ball[..7], &[spin], &[0.1, 0.2, 0.0], &omega].concat();
    let start: [f64; 15] = start.try_into().expect("fifteen");
    let period = std::f64::consts::TAU / (2.0 / 7.0 * spin);
    let run = Turntable::default().simulate(start).until(period).tolerance(1e-12).run().expect("rolls");
    let last = run.last();
    assert_near([last[1], last[2], last[9], last[10]], [0.3, 0.0, 0.1, 0.2], 1e-7);
    let run =
        Turntable::default().simulate(start).until(0.25 * period).tolerance(1e-12).run().expect("rolls");
    let last = run.last();
    let rate = 2.0 / 7.0 * spin;
    // v turns by a quarter; the position follows.
    assert_near([last[9], last[10]], [-0.2, 0.1], 1e-7);
    assert_near([last[1], last[2]], [0.3 + (0.1 - 0.2) / rate, (0.2 + 0.1) / rate], 1e-7);
}

/// Force and moment are opposite on both bodies, whatever their positions and motions.
#[test]
fn a_collision_of_free_bodies_keeps_their_momenta() {
    let plate = flat([0.0; 3], [0.3, -0.2, 0.5], [0.4, -0.3, 0.6]);
    let ball = flat([0.2, 0.1, 0.6], [0.5, 0.7, -2.0], [9.0, -7.0, 3.0]);
    let start: Vec<f64> = [&plate[..7], &ball[..7], &plate[7..], &ball[7..]].concat();
    let start: [f64; 26] = start.try_into().expect("twenty-six");
    let lid = Lid::default();
    let run = lid.simulate(start).until(0.5).tolerance(1e-12).energy().outputs().run().expect("collides");
    assert_eq!(run.events().len(), 1);
    let column = |name: &str| run.column(name).unwrap_or_else(|| panic!("no {name}"));
    for name in ["momentum.x", "momentum.y", "momentum.z", "spin.x", "spin.y", "spin.z"] {
        let values = column(name);
        assert!(values.iter().all(|value| (value - values[0]).abs() < 1e-9), "{name}");
    }
    let energy = column("energy");
    assert!(
        energy.windows(2).all(|pair| pair[1] < pair[0] + 1e-9) && energy[energy.len() - 1] < 0.99 * energy[0]
    );
}

#[test]
fn a_collision_in_the_plane_keeps_momenta() {
    for e in [0.0, 0.6] {
        let start = [0.0, 0.0, 0.0, 0.2, 0.6, 0.0, 0.3, 0.5, 0.6, 0.5, -2.0, 9.0];
        let lid = LidInThePlane { e, ..LidInThePlane::default() };
        let run = lid.simulate(start).until(0.6).tolerance(1e-12).energy().outputs().run().expect("collides");
        assert!(!run.events().is_empty());
        for name in ["momentum.x", "momentum.y", "spin"] {
            let values = run.column(name).unwrap_or_else(|| panic!("no {name}"));
            assert!(values.iter().all(|value| (value - values[0]).abs() < 1e-9), "{name}");
        }
        let end = run.system_at_end().expect("touched");
        assert_eq!(end.touch == Contact::Closed, e == 0.0);
    }
}
