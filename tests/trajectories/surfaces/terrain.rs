//! Terrain: slopes as lines and planes, bowls, hills and roads as in `tools/terrain.py`.

use lagrange::Simulate;
use lagrange::contact::{Contact, EventKind, Friction, Stepped};

use crate::{G, assert_near, distance, drift, flat};

/// Declares a disk on a slope that descends along x, and moves up.
macro_rules! slope {
    ($name:ident, $($surface:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name<S>;

            param r = 0.3, mu = 0.3, angle = 0.3, lift = 0;
            coord x, y, phi;
            gravity = (0, -9.81);
            $($surface)*
            body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
            contact touch = wheel on slope { friction: mu; restitution: 0.5; }
            output slip = touch.slip;
            output point = touch.point;
        }
    };
}

slope!(Line, line slope { through: (0, lift * t); angle: -angle; });
slope!(Slope, terrain slope { height(x): lift * t - x * tan(angle); });

/// Declares a ball on a plane whose normal depends on parameters, by events or by a stiffness.
macro_rules! incline {
    ($name:ident, { $($surface:tt)* } $($compliance:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;

            param mu = 0.4, r = 0.1, a = 0.1, b = 0.2, c = 0.9;
            gravity = (0, 0, -9.81);
            $($surface)*
            body ball { mass: 1; shape: thin_sphere(r); }
            free ball;
            contact touch = ball on slope { friction: mu; $($compliance)* }
        }
    };
}

incline!(Plane, { plane slope { through: (0, 0, 1); normal: (a, b, c); } });
incline!(Incline, { terrain slope { height(x, y): 1 - (a * x + b * y) / c; } });
incline!(SoftPlane, { plane slope { through: (0, 0, 1); normal: (a, b, c); } }
    stiffness: 1e5; dissipation: 0.2; stiction: 0.01;);
incline!(SoftIncline, { terrain slope { height(x, y): 1 - (a * x + b * y) / c; } }
    stiffness: 1e5; dissipation: 0.2; stiction: 0.01;);

/// Declares a ball on a wedge that glides and rotates.
macro_rules! wedge {
    ($name:ident, $($surface:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;

            param r = 0.2, mu = 0.8, angle = 0.5;
            gravity = (0, 0, -9.81);
            frame slider;
            body wedge { mass: 3; inertia: (1, 1, 1); }
            prismatic s = ground to slider { axis: (1, 0, 0); }
            revolute turn = slider to wedge { axis: (0, 1, 1); }
            $($surface)*
            body ball { mass: 2; shape: solid_sphere(r); }
            free ball;
            contact touch = ball on slope { friction: mu; }
        }
    };
}

wedge!(Wedge, plane slope { on: wedge; through: (0, 0, 1); normal: (sin(angle), 0, cos(angle)); });
wedge!(TerrainOnWedge, terrain slope { on: wedge; height(x, y): 1 - x * tan(angle) + 0 * y; });

/// Declares a point on a platform, which its weight presses against a spring.
macro_rules! platform {
    ($name:ident, $($surface:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;

            coord s, x, y;
            gravity = (0, -9.81);
            body platform { mass: 3; center: (0, s); }
            spring { from: (0, -1); to: platform; stiffness: 300; rest: 1; }
            $($surface)*
            body bead { mass: 1; center: (x, y); }
            contact touch = bead on slope { friction: 0.1; }
        }
    };
}

platform!(Platform, line slope { on: platform; angle: -0.3; });
platform!(Lifted, terrain slope { height(x): s - x * tan(0.3); });
platform!(Carried, terrain slope { on: platform; height(x): -x * tan(0.3); });

lagrange::system! {
    /// A bead in a bowl.
    #[derive(Clone, Debug)]
    struct Bead;

    gravity = (0, 0, -9.81);
    terrain bowl { height(x, y): (x^2 + y^2) / 2; }
    coord x, y, z;
    body bead { mass: 2; center: (x, y, z); inertia: (0, 0, 0); }
    contact touch = bead on bowl;
}

lagrange::system! {
    /// A ball in a bowl whose smallest radius of curvature is `size`.
    #[derive(Clone, Debug)]
    struct Ball<S>;

    param r = 0.25, size = 1;
    gravity = (0, 0, -9.81);
    terrain bowl { height(x, y): (x^2 + y^2) / (2 * size); }
    body ball { mass: 2; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on bowl;
}

lagrange::system! {
    /// The ball with a stiffness.
    #[derive(Clone, Debug)]
    struct SoftBall;

    param r = 0.25, k = 1e5;
    gravity = (0, 0, -9.81);
    terrain bowl { height(x, y): (x^2 + y^2) / 2; }
    body ball { mass: 2; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on bowl { stiffness: k; }
}

lagrange::system! {
    /// A ball on hills.
    #[derive(Clone, Debug)]
    struct Hills;

    gravity = (0, 0, -9.81);
    terrain hills { height(x, y): 1/10 * sin(2 * x) * cos(3 * y); }
    body ball { mass: 2; shape: solid_sphere(0.05); }
    free ball;
    contact touch = ball on hills;
}

/// Declares a wheel on a road.
macro_rules! road {
    ($name:ident, $($surface:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name<S>;

            param r = 0.1;
            coord x, y, phi;
            gravity = (0, -9.81);
            $($surface)*
            body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
            contact touch = wheel on road { friction: 10; }
        }
    };
}

road!(Road, terrain road { height(s): 1/20 * sin(4 * s); });
road!(RoadOfCrate,
    function wave(s) { derivative: slope; second_derivative: bend; third_derivative: jerk; }
    terrain road { height(s): wave(s); });
road!(RoadOfTable,
    table bumps(s) = [(-2, 0), (-1, 0.05), (0, 0), (1, 0.08), (2, 0), (3, 0.02)], interpolation: natural, outside: extend;
    terrain road { height(s): bumps(s); });

fn wave<S: lagrange::Scalar>(s: S) -> S {
    S::from_f64(0.05) * (S::from_f64(4.0) * s).sin()
}
fn slope<S: lagrange::Scalar>(s: S) -> S {
    S::from_f64(0.2) * (S::from_f64(4.0) * s).cos()
}
fn bend<S: lagrange::Scalar>(s: S) -> S {
    S::from_f64(-0.8) * (S::from_f64(4.0) * s).sin()
}
fn jerk<S: lagrange::Scalar>(s: S) -> S {
    S::from_f64(-3.2) * (S::from_f64(4.0) * s).cos()
}

/// Returns times and states of a scene of `tools/terrain.py`.
fn reference(scene: &str) -> Vec<(f64, Vec<f64>)> {
    let rows = include_str!("terrain.csv").lines().filter_map(|line| line.strip_prefix(scene));
    let rows = rows.map(|row| row.split(',').skip(1).map(|entry| entry.parse().expect("a number")));
    rows.map(|mut row| (row.next().expect("a time"), row.collect())).collect()
}

/// Returns the state of a free ball with known position and velocity.
fn of_ball(row: &[f64]) -> [f64; 13] {
    flat([row[0], row[1], row[2]], [row[3], row[4], row[5]])
}

fn place_and_velocity(state: &[f64; 13]) -> Vec<f64> {
    [&state[..3], &state[7..10]].concat()
}

/// Returns the state of a rolling wheel.
fn of_wheel(row: &[f64], r: f64) -> [f64; 6] {
    [row[0], row[1], row[2], row[3], row[4], -row[3].hypot(row[4]) / r]
}

#[test]
fn a_slope_is_a_line() {
    for (angle, lift) in [(0.3_f64, 0.0), (0.7, 0.0), (0.8, 0.0), (0.3, 0.5), (0.8, -0.2)] {
        let (sin, cos) = angle.sin_cos();
        let line = Line::<f64> { angle, lift, ..Line::default() };
        let slope = Slope::<f64> { angle, lift, ..Slope::default() };
        for above in [0.0, 0.2] {
            let start = [0.3 * sin, 0.3 * cos + above, 0.0, 0.0, lift, 0.0];
            let line = line.simulate(start).until(1.0).tolerance(1e-12).outputs().run().expect("moves");
            let slope = slope.simulate(start).until(1.0).tolerance(1e-12).outputs().run().expect("moves");
            // Each of many bounces propagates rounding.
            let tolerance = if above > 0.0 { 1e-8 } else { 1e-11 };
            assert_near(&slope.last(), &line.last(), tolerance);
            for name in ["slip", "point.x", "point.y"] {
                let last = |column: Option<&[f64]>| *column.expect("recorded").last().expect("an end");
                assert_near(&[last(slope.column(name))], &[last(line.column(name))], tolerance);
            }
        }
        let start = [0.3 * sin, 0.3 * cos, 0.0, 0.0, lift, 0.0];
        let stepped = Stepped::every(1e-3);
        let line_steps = line.simulate(start).until(1.0).method(stepped).run().expect("moves");
        let slope_steps = slope.simulate(start).until(1.0).method(stepped).run().expect("moves");
        assert_near(&slope_steps.last(), &line_steps.last(), 1e-9);
    }
    let single = Slope::<f32>::default();
    let (sin, cos) = 0.3_f32.sin_cos();
    let start = [0.3 * sin, 0.3 * cos, 0.0, 0.0, 0.0, 0.0];
    let run = single.simulate(start).until(1.0).run().expect("moves");
    let wanted = Line::<f32>::default().simulate(start).until(1.0).run().expect("moves");
    assert_near(&run.last().map(f64::from), &wanted.last().map(f64::from), 1e-4);
}

#[test]
fn a_slope_is_a_plane() {
    let length = (0.01_f64 + 0.04 + 0.81).sqrt();
    let place = [0.1 / length, 0.2 / length, 0.9 / length].map(|part| 0.1 * part);
    let start = flat([place[0], place[1], place[2] + 1.0], [0.0, 1.0, -1.0]);
    for mu in [0.4, 0.05] {
        let (plane, incline) = (Plane { mu, ..Plane::default() }, Incline { mu, ..Incline::default() });
        let wanted = plane.simulate(start).until(1.0).tolerance(1e-12).run().expect("moves");
        let found = incline.simulate(start).until(1.0).tolerance(1e-12).run().expect("moves");
        assert_near(&found.last(), &wanted.last(), 1e-10);
        assert_eq!(found.system_at_end().map(|end| end.touch), Some(Contact::Closed));
        let wanted = plane.simulate(start).until(1.0).method(Stepped::every(1e-3)).run().expect("moves");
        let found = incline.simulate(start).until(1.0).method(Stepped::every(1e-3)).run().expect("moves");
        assert_near(&found.last(), &wanted.last(), 1e-8);
        let (plane, incline) =
            (SoftPlane { mu, ..SoftPlane::default() }, SoftIncline { mu, ..SoftIncline::default() });
        let wanted = plane.simulate(start).until(1.0).tolerance(1e-11).run().expect("moves");
        let found = incline.simulate(start).until(1.0).tolerance(1e-11).run().expect("moves");
        assert_near(&found.last(), &wanted.last(), 1e-8);
    }
}

#[test]
fn terrain_is_carried() {
    let (sin, cos) = 0.5_f64.sin_cos();
    let ball = flat([0.2 * sin, 0.0, 1.0 + 0.2 * cos], [0.0; 3]);
    let start: Vec<f64> = [&[0.0, 0.0][..], &ball[..7], &[0.3, 0.1], &ball[7..]].concat();
    let start: [f64; 17] = start.try_into().expect("seventeen");
    let wanted = Wedge::default().simulate(start).until(0.4).tolerance(1e-12).run().expect("moves");
    let found = TerrainOnWedge::default().simulate(start).until(0.4).tolerance(1e-12).run().expect("moves");
    assert_near(&found.last(), &wanted.last(), 1e-10);
    assert_eq!(found.events().len(), wanted.events().len());
}

#[test]
fn terrain_rises_with_coordinates() {
    let start = [0.0, 0.0, 0.1, 0.0, 0.2, 0.0];
    let wanted = Platform::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("moves");
    let lifted = Lifted::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("moves");
    let carried = Carried::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("moves");
    assert!(wanted.events().iter().any(|event| matches!(event.kind, EventKind::Closed { .. })));
    assert_near(&lifted.last(), &wanted.last(), 1e-10);
    assert_near(&carried.last(), &wanted.last(), 1e-10);
}

#[test]
fn beads_and_balls_move_as_in_the_reference() {
    let bead = reference("bead");
    let start: [f64; 6] = bead[0].1.clone().try_into().expect("six");
    let ball = reference("ball");
    let hills = reference("hills");
    for row in 1..=4 {
        let (time, wanted) = &bead[row];
        let run =
            Bead::default().simulate(start).until(*time).tolerance(1e-12).energy().run().expect("glides");
        assert_near(&run.last(), wanted, 1e-11);
        assert!(drift(run.column("energy")) < 1e-11);
        let (time, wanted) = &ball[row];
        let start = of_ball(&ball[0].1);
        let run = Ball::<f64>::default().simulate(start).until(*time).tolerance(1e-12).energy().run();
        let run = run.expect("glides");
        assert_near(&place_and_velocity(&run.last()), wanted, 1e-11);
        assert!(drift(run.column("energy")) < 1e-11);
        let (time, wanted) = &hills[row];
        let run = Hills::default().simulate(of_ball(&hills[0].1)).until(*time).tolerance(1e-12).run();
        assert_near(&place_and_velocity(&run.expect("glides").last()), wanted, 1e-11);
    }
    let start = of_ball(&ball[0].1).map(|entry| entry as f32);
    let single = Ball::<f32>::default().simulate(start).until(1.0).run().expect("glides");
    assert_near(&place_and_velocity(&single.last().map(f64::from)), &ball[4].1, 1e-3);
}

#[test]
fn a_wheel_rolls_as_in_the_reference() {
    let rows = reference("road");
    let start = of_wheel(&rows[0].1, 0.1);
    for (time, wanted) in &rows[1..] {
        let run = Road::<f64>::default().simulate(start).until(*time).tolerance(1e-12).run().expect("rolls");
        assert_near(&run.last()[..5], wanted, 1e-11);
        assert_eq!(run.system_at_end().map(|end| end.touch_friction), Some(Friction::Sticks));
        let run = RoadOfCrate::<f64>::default().simulate(start).until(*time).tolerance(1e-12).run();
        assert_near(&run.expect("rolls").last()[..5], wanted, 1e-11);
    }
    let single = Road::<f32>::default().simulate(start.map(|entry| entry as f32)).until(1.0).run();
    assert_near(&single.expect("rolls").last().map(f64::from)[..5], &rows[4].1, 2e-3);
}

#[test]
fn a_wheel_keeps_its_energy_on_a_table() {
    let road = RoadOfTable::<f64>::default();
    let fall =
        road.simulate([-0.5, 1.0, 0.0, 0.0, 0.0, 0.0]).until(2.0).tolerance(1e-10).run().expect("rolls");
    let end = fall.system_at_end().expect("it touches").clone();
    assert_eq!(end.touch, Contact::Closed);
    let run = end.simulate(fall.last()).until(2.0).tolerance(1e-10).energy().run().expect("rolls");
    assert!(drift(run.column("energy")) < 1e-6, "{:e}", drift(run.column("energy")));
}

#[test]
fn other_ways_converge_to_rigid_contact() {
    let rows = reference("ball");
    let start = of_ball(&rows[0].1);
    let (time, wanted) = &rows[4];
    let stepped = [1e-2, 1e-3, 1e-4].map(|step| {
        let run = Ball::<f64>::default().simulate(start).until(*time).method(Stepped::every(step)).run();
        distance(&place_and_velocity(&run.expect("glides").last()), wanted)
    });
    assert!(stepped[1] < 0.15 * stepped[0] && stepped[2] < 0.15 * stepped[1], "{stepped:?}");
    assert!(stepped[2] < 1e-3, "{stepped:?}");
    let soft = [1e4, 1e5, 1e6].map(|k| {
        let ball = SoftBall { k, ..SoftBall::default() };
        let run = ball.simulate(start).until(*time).tolerance(1e-11).energy().run().expect("glides");
        assert!(drift(run.column("energy")) < 1e-8);
        distance(&run.last()[..3], &wanted[..3])
    });
    assert!(soft[1] < 0.6 * soft[0] && soft[2] < 0.4 * soft[1] && soft[2] < 7e-3, "{soft:?}");
}

/// A ball of radius 0.25 fits at the bottom of the bowl if this is less than the radius of
/// curvature.
#[test]
fn a_ball_that_does_not_fit_is_an_error() {
    for x in [0.0, 0.05] {
        let start = flat([x, 0.0, 0.6], [0.0; 3]);
        let fitting = Ball::<f64> { size: 0.26, ..Ball::default() };
        fitting.simulate(start).until(1.0).run().expect("it fits");
        let large = Ball::<f64> { size: 0.24, ..Ball::default() };
        let failure = large.simulate(start).until(1.0).run().expect_err("it does not fit");
        let said = failure.to_string();
        assert!(said.contains("contact `touch`") && said.contains("does not fit terrain"), "{said}");
    }
}

#[test]
fn a_ball_falls_from_far_above() {
    let start = flat([0.3, 0.1, 5.0], [0.0; 3]);
    let run = Ball::<f64>::default().simulate(start).until(2.0).tolerance(1e-10).run().expect("falls");
    let closed =
        run.events().iter().find(|event| matches!(event.kind, EventKind::Closed { .. })).expect("it lands");
    let fall = 5.0 - 0.5 * G * closed.time * closed.time;
    assert_near(&[closed.state[2]], &[fall], 1e-9);
}
