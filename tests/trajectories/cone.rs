//! Friction in a plane, against closed forms, a regularised reference and its own law.
//!
//! `cargo motions --test cone` runs these tests.
#![cfg(any(not(debug_assertions), clippy))]

mod feet;
mod sliding_disk;

use lagrange::Simulate;
use lagrange::contact::{EventKind, Friction};
use lagrange::integrate::{Radau5, RungeKutta4};

lagrange::system! {
    /// A puck on a table.
    #[derive(Clone, Debug)]
    struct Puck<S>;

    param mu = 0.5, g = 9.81, wind = 0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    force y = wind * t;
    friction rub = dot((x, y)), kinetic: mu * g, static: 1.2 * mu * g;
    output grip = rub;
}

lagrange::system! {
    /// A block on a slope, x downhill.
    #[derive(Clone, Debug)]
    struct Slope;

    param mu = 0.5, angle = 0.4, g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -g * sin(angle) * x;
    friction rub = dot((x, y)), mu * g * cos(angle);
}

lagrange::system! {
    /// A ball above a floor.
    #[derive(Clone, Debug)]
    struct Ball<S>;

    param mu = 0.3, e = 0, r = 0.1;
    gravity = (0, 0, -9.81);
    body b { mass: 1; shape: solid_sphere(r); }
    free b;
    let slip = velocity(b) + cross(angular_velocity(b), (0, 0, -r));
    event floor = b.origin.z - r, falling => impact(e);
    friction rub = (slip.x, slip.y), mu * floor;
    output height = b.origin.z - r;
    output load = floor;
    output grip = rub;
    output drift = (slip.x, slip.y);
}

lagrange::system! {
    /// A box above a floor, which its corners touch.
    #[derive(Clone, Debug)]
    struct Cuboid;

    param mu = 0.5, e = 0;
    const x[8] = [0.2, 0.2, 0.2, 0.2, -0.2, -0.2, -0.2, -0.2];
    const y[8] = [0.15, 0.15, -0.15, -0.15, 0.15, 0.15, -0.15, -0.15];
    const z[8] = [0.1, -0.1, 0.1, -0.1, 0.1, -0.1, 0.1, -0.1];
    gravity = (0, 0, -9.81);
    body b { mass: 1; shape: cuboid(0.4, 0.3, 0.2); }
    free b;
    for i in 0..8 {
        let corner[i] = b.point(x[i], y[i], z[i]);
        event floor[i] = corner[i].z, falling => impact(e);
        friction rub[i] = (dot(corner[i]).x, dot(corner[i]).y), mu * floor[i];
    }
}

lagrange::system! {
    /// A box with four corners on a plane, which tilts at the rate `w` from the angle `angle`.
    /// Downhill is the direction `heading` of the box.
    #[derive(Clone, Debug)]
    struct Tilting<S>;

    param mu = 0.5, angle = 0, w = 0.1, heading = 0;
    const x[4] = [0.2, 0.2, -0.2, -0.2], y[4] = [0.15, -0.15, 0.15, -0.15];
    let slope = angle + w * t;
    gravity = (9.81 * cos(heading) * sin(slope), 9.81 * sin(heading) * sin(slope), -9.81 * cos(slope));
    body b { mass: 1; shape: cuboid(0.4, 0.3, 0.2); }
    free b;
    for i in 0..4 {
        let corner[i] = b.point(x[i], y[i], -0.1);
        event floor[i] = corner[i].z, falling => impact(0);
        friction rub[i] = (dot(corner[i]).x, dot(corner[i]).y), mu * floor[i];
        output load[i] = floor[i];
        output grip_x[i] = rub[i].x;
        output grip_y[i] = rub[i].y;
    }
}

const G: f64 = 9.81;

fn assert_near<const N: usize>(found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance, "{found} instead of {wanted}");
    }
}

/// Returns the state of a free body: position, orientation about the vertical, velocities.
fn flat(height: f64, v: [f64; 3], omega: [f64; 3]) -> [f64; 13] {
    let [a, b, c] = v;
    let [p, q, r] = omega;
    [0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0, a, b, c, p, q, r]
}

/// The distance |v|²/2μg in the direction of v. Separate limits would stop it after half of that.
#[test]
fn a_puck_stops_in_a_straight_line() {
    let wanted = [1.0, 1.0].map(|v| v * 2_f64.sqrt() / (2.0 * 0.5 * G));
    let puck = Puck::default();
    let start = [0.0, 0.0, 1.0, 1.0];
    let runs = [
        puck.simulate(start).until(1.0).tolerance(1e-12).run(),
        puck.simulate(start).until(1.0).method(RungeKutta4 { step: 0.01 }).run(),
        puck.simulate(start).until(1.0).method(Radau5::tolerance(1e-12)).run(),
    ];
    for run in runs {
        let run = run.expect("stops");
        let [x, y, vx, vy] = run.last();
        assert_near([x, y], wanted, 1e-12);
        assert_near([vx, vy], [0.0; 2], 1e-14);
        let [event] = run.events() else { panic!("{:?}", run.events()) };
        assert_eq!(event.kind, EventKind::Stuck);
        assert_eq!(run.system_at_end().expect("stopped").rub, Friction::Sticks);
    }
    let single: Puck<f32> = Puck { mu: 0.5, g: 9.81, wind: 0.0, ..Puck::default() };
    let run = single.simulate([0.0, 0.0, 1.0, 1.0]).until(1.0).run().expect("stops");
    let [x, y, ..] = run.last().map(f64::from);
    assert_near([x, y], wanted, 1e-6);
}

/// It starts when the force reaches the static limit, and slides with the kinetic one.
#[test]
fn a_puck_starts_at_its_static_limit() {
    let puck = Puck { wind: 2.0, ..Puck::default() };
    let run = puck.simulate([0.0; 4]).until(5.0).tolerance(1e-12).run().expect("starts");
    let starts = 1.2 * 0.5 * G / 2.0;
    assert!((run.events()[0].time - starts).abs() < 1e-11, "{:?}", run.events());
    let wanted = 25.0 - starts * starts - 0.5 * G * (5.0 - starts);
    let [x, _, vx, vy] = run.last();
    assert_near([x, vx, vy], [0.0, 0.0, wanted], 1e-8);
    assert_near(puck.grip(1.0, &[0.0; 2], &[0.3, -0.4]), [-0.3 * G, 0.4 * G], 1e-12);
}

/// With θ between the velocity and the downhill direction, v sin θ tan(θ/2)^−k is constant, k =
/// μ/tan α.
#[test]
fn a_block_pushed_across_a_slope_curves_downhill() {
    for ratio in [0.6, 0.9] {
        let slope = Slope { mu: ratio * 0.4_f64.tan(), ..Slope::default() };
        let run = slope.simulate([0.0, 0.0, 0.0, 2.0]).until(3.0).tolerance(1e-12).run().expect("slides");
        assert!(run.events().is_empty(), "{:?}", run.events());
        let mut steepest = 0.0_f64;
        for state in run.states() {
            let [_, _, down, across] = state;
            let (speed, half) = (down.hypot(across), 0.5 * across.atan2(down));
            let constant = speed * (2.0 * half).sin() / half.tan().powf(ratio);
            assert!((constant - 2.0).abs() < 1e-9, "{constant} at {half}");
            steepest = steepest.max(down / across);
        }
        assert!(steepest > 2.0, "{steepest}");
    }
    let rough = Slope { mu: 1.3 * 0.4_f64.tan(), ..Slope::default() };
    let run = rough.simulate([0.0, 0.0, 0.0, 2.0]).until(3.0).tolerance(1e-12).run().expect("stops");
    assert_eq!(run.system_at_end().expect("stopped").rub, Friction::Sticks);
}

/// The slip (2, 1.5) decreases at 7/2 μg in a constant direction, then the ball rolls.
#[test]
fn a_ball_slides_along_a_parabola_until_it_rolls() {
    let (mu, stop) = (0.3, 2.5 / (3.5 * 0.3 * G));
    let start = flat(0.1, [2.0, 0.0, 0.0], [15.0, 0.0, 3.0]);
    let run = Ball::<f64>::default().simulate(start).until(2.0).tolerance(1e-12).run().expect("rolls");
    let [event] = run.events() else { panic!("{:?}", run.events()) };
    assert!((event.time - stop).abs() < 1e-11 && event.kind == EventKind::Stuck);
    let slowing = [0.8, 0.6].map(|part| mu * G * part);
    let [vx, vy] = [2.0 - slowing[0] * stop, -slowing[1] * stop];
    let x = 2.0 * stop - 0.5 * slowing[0] * stop * stop + vx * (2.0 - stop);
    let y = -0.5 * slowing[1] * stop * stop + vy * (2.0 - stop);
    let last = run.last();
    assert_near([last[0], last[1], last[7], last[8]], [x, y, vx, vy], 1e-10);
    let straight = Ball::<f64>::default().simulate(flat(0.1, [3.0, 0.0, 0.0], [0.0; 3])).until(2.0).run();
    assert!((straight.expect("rolls").last()[7] - 15.0 / 7.0).abs() < 1e-9);
}

/// An impact changes the slip by 7/2 of the impulse per mass. It either stops the slip or takes
/// from it μ(1 + e) times the approach speed.
#[test]
fn a_ball_thrown_with_spin_leaves_by_the_law_of_impact() {
    for (mu, e) in [(0.05, 0.6), (0.6, 0.6), (0.1, 1.0), (0.3, 0.2)] {
        let ball: Ball<f64> = Ball { mu, e, ..Ball::default() };
        let start = flat(0.5, [2.0, 0.5, 1.0], [15.0, 0.0, 3.0]);
        let run = ball.simulate(start).until(0.45).tolerance(1e-12).run().expect("bounces");
        let hit = run.events().first().expect("an impact");
        let EventKind::Impact(impact) = hit.kind else { panic!("{:?}", hit.kind) };
        let approach = -(1.0 - G * hit.time);
        assert!((impact.impulse - (1.0 + e) * approach).abs() < 1e-10);
        let slip = [2.0_f64, 0.5 + 1.5];
        let size = slip[0].hypot(slip[1]);
        let change = (mu * (1.0 + e) * approach).min(2.0 / 7.0 * size);
        let wanted = [2.0, 0.5].into_iter().zip(slip).map(|(v, part)| v - change * part / size);
        let wanted: Vec<f64> = wanted.collect();
        let last = run.last();
        assert_near([last[7], last[8]], [wanted[0], wanted[1]], 1e-10);
    }
}

/// v²/2μg, and for the spin, μ m g times the distance of the corners against the moment of inertia.
#[test]
fn a_box_on_its_face_stops_as_a_puck_does() {
    let stop = |start: [f64; 13]| {
        let run = Cuboid::default().simulate(start).until(1.0).tolerance(1e-11).run().expect("stops");
        let last = run.last();
        assert!(last[7..].iter().all(|v| v.abs() < 1e-12), "{last:?}");
        [last[0], last[1], last[2], 2.0 * last[6].atan2(last[3])]
    };
    let part = 1.0 / (2.0 * 0.5 * G);
    let diagonal = stop(flat(0.1, [1.0, 1.0, 0.0], [0.0; 3]));
    assert_near(diagonal, [2_f64.sqrt() * part, 2_f64.sqrt() * part, 0.1, 0.0], 1e-9);
    assert_near(stop(flat(0.1, [1.0, 0.0, 0.0], [0.0; 3])), [part, 0.0, 0.1, 0.0], 1e-9);
    let angle = 25.0 * (0.16 + 0.09) / 12.0 * part / 0.25;
    assert_near(stop(flat(0.1, [0.0; 3], [0.0, 0.0, 5.0])), [0.0, 0.0, 0.1, angle], 1e-9);
}

#[test]
fn resting_bodies_stay_at_rest() {
    let still = Cuboid { e: 0.3, ..Cuboid::default() };
    let run = still.simulate(flat(0.1, [0.0; 3], [0.0; 3])).until(100.0).run().expect("rests");
    assert!(run.events().is_empty());
    let last = run.last();
    assert_near([last[0], last[1], last[2], last[3]], [0.0, 0.0, 0.1, 1.0], 1e-14);
}

struct Random(u64);

impl Random {
    fn within(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The floor pushes and is not penetrated. Its friction is in the cone and against the slip, and
/// energy decreases. `LAGRANGE_SCENES=2000` takes more balls.
#[test]
fn balls_thrown_at_random_obey_the_law() {
    let mut random = Random(30);
    let count = std::env::var("LAGRANGE_SCENES").ok();
    let count = count.map_or(200, |count| count.parse().expect("LAGRANGE_SCENES is a whole number"));
    for case in 0..count {
        let ball: Ball<f64> =
            Ball { mu: random.within(0.02, 1.0), e: random.within(0.0, 0.9), ..Ball::default() };
        let v = std::array::from_fn(|_| random.within(-2.0, 2.0));
        let omega = std::array::from_fn(|_| random.within(-20.0, 20.0));
        let start = flat(random.within(0.1, 0.6), v, omega);
        let run = ball.simulate(start).until(4.0).tolerance(1e-10).energy().outputs().run();
        let run = run.unwrap_or_else(|error| panic!("{error} in case {case}"));
        let column = |name: &str| run.column(name).unwrap_or_else(|| panic!("no column {name}"));
        let energies = column("energy");
        for pair in energies.windows(2) {
            assert!(pair[1] - pair[0] < 1e-9 * energies[0], "energy {pair:?} in case {case}");
        }
        let (height, load) = (column("height"), column("load"));
        let [grip_x, grip_y] = ["grip.x", "grip.y"].map(column);
        let [slip_x, slip_y] = ["drift.x", "drift.y"].map(column);
        for row in 0..energies.len() {
            let (load, power) = (load[row], grip_x[row] * slip_x[row] + grip_y[row] * slip_y[row]);
            let (size, speed) = (grip_x[row].hypot(grip_y[row]), slip_x[row].hypot(slip_y[row]));
            let is_against = speed < 1e-5 || (power + ball.mu * load * speed).abs() < 1e-7 * speed;
            let holds = height[row] > -1e-9 && load >= 0.0 && size <= ball.mu * load + 1e-7;
            assert!(holds && is_against, "{load} {size} {speed} {power} at row {row} of case {case}");
        }
    }
}

/// The smallest friction forces share the pull equally, which the uphill corners cannot bear. Other
/// forces hold the box until tan = mu, when all corners slip together.
#[test]
fn a_box_on_a_tilting_plane_starts_where_no_forces_hold_it() {
    let start = 0.5_f64.atan() / 0.1;
    // The box slides with g (sin - mu cos) in the direction of the slope.
    let rate = |t: f64| (-(0.1 * t).cos() - 0.5 * (0.1 * t).sin()) / 0.1;
    let place = |t: f64| (-(0.1 * t).sin() + 0.5 * (0.1 * t).cos()) / 0.01;
    let end = 8.0;
    let way = G * (place(end) - place(start) - rate(start) * (end - start));
    for heading in [0.0, 0.3, 1.1, std::f64::consts::FRAC_PI_2, 2.5, 4.0, 5.9] {
        let tilting = Tilting { heading, ..Tilting::default() };
        let run = tilting.simulate(flat(0.1, [0.0; 3], [0.0; 3])).until(end).outputs().run().expect("slides");
        let [event] = run.events() else { panic!("{heading}: {:?}", run.events()) };
        assert_eq!(event.kind, EventKind::Slipped);
        assert!((event.time - start).abs() < 1e-4, "{heading}: {} instead of {start}", event.time);
        let [x, y, ..] = run.last();
        assert_near([x, y], [way * heading.cos(), way * heading.sin()], 1e-7);
        for i in 0..4 {
            let column = |name: &str| run.column(&format!("{name}[{i}]")).expect("a column");
            let (load, grip_x, grip_y) = (column("load"), column("grip_x"), column("grip_y"));
            // At the event itself no force within the limits holds the box.
            let away = |row: &usize| (run.times()[*row] - start).abs() > 1e-3;
            for row in (0..run.len()).filter(away) {
                let (load, x, y) = (load[row], grip_x[row], grip_y[row]);
                assert!(load > 0.0 && x.hypot(y) <= 0.5 * load * (1.0 + 1e-6), "{heading}: {load} {x} {y}");
            }
        }
    }
}

/// Just below the slope at which sliding begins it rests, whatever its orientation.
#[test]
fn a_box_rests_on_any_slope_that_is_not_too_steep() {
    for step in 0..12 {
        let heading = 0.55 * f64::from(step);
        let steep = Tilting { heading, angle: 0.499_f64.atan(), w: 0.0, ..Tilting::default() };
        let run = steep.simulate(flat(0.1, [0.0; 3], [0.0; 3])).until(2.0).run().expect("rests");
        assert!(run.events().is_empty(), "{heading}: {:?}", run.events());
        assert_near(run.last(), flat(0.1, [0.0; 3], [0.0; 3]), 1e-12);
        let single: Tilting<f32> = Tilting {
            heading: heading as f32,
            angle: 0.499_f32.atan(),
            w: 0.0,
            mu: 0.5,
            ..Tilting::default()
        };
        let run = single.simulate(flat(0.1, [0.0; 3], [0.0; 3]).map(|x| x as f32)).until(2.0).run();
        let last = run.expect("rests").last().map(f64::from);
        assert_near(last, flat(0.1, [0.0; 3], [0.0; 3]), 1e-5);
    }
}

/// They tumble over their corners and come to rest on a face, and their energy never increases.
#[test]
fn boxes_thrown_at_random_come_to_rest_on_a_face() {
    for seed in 0..12 {
        let mut random = Random(seed * 7919 + 17);
        for _ in 0..5 {
            random.within(0.0, 1.0);
        }
        let mu = random.within(0.05, 0.9);
        let e = if seed % 3 == 0 { 0.0 } else { random.within(0.0, 0.6) };
        let orientation: [f64; 4] = std::array::from_fn(|_| random.within(-1.0, 1.0));
        let length = orientation.iter().map(|part| part * part).sum::<f64>().sqrt();
        let mut start = flat(0.5, [0.0; 3], [0.0; 3]);
        start[3..7].copy_from_slice(&orientation.map(|part| part / length));
        start[7..10].fill_with(|| random.within(-2.0, 2.0));
        start[10..13].fill_with(|| random.within(-5.0, 5.0));
        let thrown = Cuboid { mu, e, ..Cuboid::default() };
        let run = thrown.simulate(start).until(8.0).tolerance(1e-8).energy().run();
        let run = run.unwrap_or_else(|error| panic!("{seed}: {error}"));
        let energy = run.column("energy").expect("a column");
        assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-6), "{seed}: the energy rises");
        let last = run.last();
        assert!(last[7..].iter().all(|speed| speed.abs() < 1e-9), "{seed}: {last:?}");
        assert!([0.2, 0.15, 0.1].iter().any(|half| (last[2] - half).abs() < 1e-9), "{seed}: {last:?}");
    }
}

lagrange::system! {
    /// A puck pulled by a slowly growing, rotating force.
    #[derive(Clone, Debug)]
    struct Pulled;

    param mu = 0.5, g = 9.81, since = 0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    force x = t - since;
    force y = 0.3 * (t - since)^2;
    friction rub = dot((x, y)), mu * g;
}

/// Friction turns a slow slip at a rate that decreases as the puck speeds up. The explicit method
/// takes the few steps at its limit, and agrees with the implicit one. Nothing depends on the
/// origin of time.
#[test]
fn what_starts_slowly_while_its_drive_turns_is_not_stiff_for_long() {
    let pulled = Pulled::default();
    let run = pulled.simulate([0.0; 4]).until(6.0).tolerance(1e-10).run().expect("starts");
    assert!(run.len() < 1000, "{} steps", run.len());
    let implicit =
        pulled.simulate([0.0; 4]).until(6.0).method(Radau5::tolerance(1e-10)).run().expect("starts");
    assert_near(run.last(), implicit.last(), 1e-7);
    for since in [1e3, 1e6, 1e9] {
        let later = Pulled { since, ..pulled.clone() };
        let found = later.simulate([0.0; 4]).from(since).until(since + 6.0).tolerance(1e-10).run();
        assert_near(found.expect("starts").last(), run.last(), 1e-7 + 1e-14 * since);
    }
}

lagrange::system! {
    /// A block whose friction grows with its speed, like that of a damper.
    #[derive(Clone, Debug)]
    struct Damped<S>;

    param c = 2;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = cos(t);
    friction rub = dot(x), c * abs(dot(x));
}

/// The limit vanishes with the speed, and is negative by rounding where the block reverses.
#[test]
fn friction_in_proportion_to_the_speed_is_a_damper() {
    for start in [0.0, 1.0, -0.5] {
        let speed = |t: f64| (2.0 * t.cos() + t.sin() + (5.0 * start - 2.0) * (-2.0 * t).exp()) / 5.0;
        let damped = Damped::<f64>::default();
        let run = damped.simulate([0.0, start]).until(20.0).tolerance(1e-12).run().expect("turns");
        assert_near([run.last()[1]], [speed(20.0)], 1e-10);
        let single: Damped<f32> = Damped { c: 2.0, ..Damped::default() };
        let run = single.simulate([0.0, start as f32]).until(20.0).run().expect("turns");
        assert_near([f64::from(run.last()[1])], [speed(20.0)], 1e-4);
    }
}

/// In single precision, too, a ball slides until it rolls.
#[test]
fn a_ball_rolls_in_single_precision() {
    let ball: Ball<f32> = Ball { mu: 0.3, ..Ball::default() };
    let mut start = [0.0_f32; 13];
    (start[2], start[3], start[7], start[8]) = (0.1, 1.0, 2.0, -1.0);
    let run = ball.simulate(start).until(1.0).run().expect("rolls");
    let [event] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!(event.kind, EventKind::Stuck);
    let [vx, vy] = [run.last()[7], run.last()[8]].map(f64::from);
    assert_near([vx, vy], [10.0 / 7.0, -5.0 / 7.0], 1e-5);
}

/// Other balls do, too, at tolerances down to rounding in single precision.
#[test]
fn balls_roll_in_single_precision() {
    for (case, tolerance) in [1e-3, 1e-4, 1e-5, 1e-6].into_iter().cycle().take(200).enumerate() {
        let (angle, mu) = (0.37 * case as f32, [0.1, 0.3, 0.7][case % 3]);
        let ball: Ball<f32> = Ball { mu, ..Ball::default() };
        let [x, y] = [2.0 * angle.cos(), -1.0 - angle.sin()];
        let mut start = [0.0_f32; 13];
        (start[2], start[3], start[7], start[8]) = (0.1, 1.0, x, y);
        let run = ball.simulate(start).until(5.0).tolerance(tolerance).run().expect("rolls");
        let [event] = run.events() else { panic!("{case}: {:?}", run.events()) };
        assert_eq!(event.kind, EventKind::Stuck);
        let found = [run.last()[7], run.last()[8]].map(f64::from);
        let bound = f64::from(tolerance).mul_add(10.0, 1e-5);
        assert_near(found, [x, y].map(|speed| 5.0 / 7.0 * f64::from(speed)), bound);
    }
}
