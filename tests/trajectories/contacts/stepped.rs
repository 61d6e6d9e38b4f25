//! Steps in velocities, against closed forms, rigid contacts and conserved quantities.

use std::f64::consts::TAU;

use lagrange::contact::{Contact, Friction, Stepped};
use lagrange::event::Direction;
use lagrange::simulate::Trajectory;
use lagrange::{Simulate, integrate};

use super::robot::compiled::{Walker, WalkerState};
use super::robot::{WEIGHT, gaps};
use super::{G, assert_near, flat};

/// A box on its lower corners.
mod slider {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Slider;
        param mu = 0.5;
        gravity = (0, 0, -9.81);
        body case { mass: 2; shape: cuboid(0.2, 0.2, 0.2); }
        free case;
        for i in 0..4 { contact foot[i] = case.corner(i) on ground { friction: mu; } }
        output load = foot[0].normal + foot[1].normal + foot[2].normal + foot[3].normal;
    }
}
use slider::Slider;

/// A box that may hit the ground with any of its corners.
mod thrown {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Thrown;
        param mu = 0.5, e = 0.3;
        gravity = (0, 0, -9.81);
        body case { mass: 2; shape: cuboid(0.4, 0.3, 0.2); }
        free case;
        for i in 0..8 { contact foot[i] = case.corner(i) on ground { friction: mu; restitution: e; } }
    }
}
use thrown::Thrown;

/// Balls on top of each other.
mod stack {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Stack;
        coord x[5];
        let below[0] = 0;
        for i in 1..5 { let below[i] = x[i - 1]; }
        kinetic = sum(i in 0..5, 1/2 * (1 + i) * dot(x[i])^2);
        potential = sum(i in 0..5, (1 + i) * 9.81 * x[i]);
        for i in 0..5 { event touch[i] = x[i] - below[i], falling => impact(0); }
    }
}
use stack::Stack;

/// A pendulum between rods held by constraints, with a floor and a dry joint.
mod held {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Held;
        param l = 1, strength = 0.2;
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 9.81 * y;
        constraint rod = x^2 + y^2 - l^2;
        friction dry = x * dot(y) - y * dot(x), strength;
        event stop = x + 0.25, falling => impact(0.5);
        event lowest = x, crossing => record;
    }
}
use held::Held;

/// A block pushed by an input.
mod pushed {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Pushed;
        param mu >= 0 = 0.5;
        coord x, y;
        input u;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 9.81 * y;
        force x = u;
        event floor = y, falling => impact(0);
        friction rub = dot(x), mu * floor;
    }
}
use pushed::{Pushed, PushedInputs};

/// The block in single precision.
mod single {
    lagrange::system! {
        #[derive(Clone, Debug)]
        #[scalar(f32)]
        pub struct Single;
        param mu = 0.5;
        gravity = (0, 0, -9.81);
        body case { mass: 2; shape: cuboid(0.2, 0.2, 0.2); }
        free case;
        for i in 0..4 { contact foot[i] = case.corner(i) on ground { friction: mu; } }
    }
}
use single::Single;

/// Returns the distance in which friction stops a speed.
fn stopping(speed: f64, mu: f64) -> f64 {
    speed * speed / (2.0 * mu * G)
}

#[test]
fn a_box_that_slides_across_its_edges_stops_where_coulombs_cone_stops_it() {
    let each = stopping(2.0_f64.sqrt(), 0.5) / 2.0_f64.sqrt();
    assert!((each - 0.14416).abs() < 1e-5);
    let start = flat([0.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0; 3]);
    let error = |h: f64| {
        let slider = Slider::default();
        let run = slider.simulate(start).until(0.5).method(Stepped::every(h)).record("load");
        let run = run.run().expect("it slides");
        let [x, y, z, ..] = run.last();
        assert!((x - y).abs() < 1e-12 && (z - 0.1).abs() < 1e-12, "it is not lifted: {x} {y} {z}");
        let loads = run.column("load").expect("recorded");
        assert!((loads[loads.len() - 1] - 2.0 * G).abs() < 1e-9);
        let end = run.system_at_end().expect("in other modes");
        assert_eq!((end.foot_0, end.foot_0_friction), (Contact::Closed, Friction::Sticks));
        assert_eq!(run.work().inexact, 0);
        each - x
    };
    let errors = [4e-3, 2e-3, 1e-3].map(error);
    for pair in errors.windows(2) {
        assert!((1.8..2.2).contains(&(pair[0] / pair[1])), "first order: {errors:?}");
    }
    assert!(errors[2] < 6e-4, "{errors:?}");
}

#[test]
fn single_precision_slides_as_far() {
    let mut start = [0.0_f32; 13];
    (start[2], start[3], start[7], start[8]) = (0.1, 1.0, 1.0, 1.0);
    let run = Single::default().simulate(start).until(0.5).method(Stepped::every(1e-3)).run();
    let run = run.expect("it slides");
    let [x, y, z, ..] = run.last();
    assert!(
        (x - 0.14366).abs() < 1e-4 && (y - 0.14366).abs() < 1e-4 && (z - 0.1).abs() < 1e-4,
        "{x} {y} {z}"
    );
    assert!(run.last()[7..].iter().all(|v| v.abs() < 1e-5), "{:?}", run.last());
}

/// Returns the times of the events of this name.
fn times(run: &Trajectory<Held>, name: &str) -> Vec<f64> {
    run.events().iter().filter(|event| event.name == name).map(|event| event.time).collect()
}

/// Draws a number between −1 and 1.
fn random(seed: &mut u64) -> f64 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// `LAGRANGE_THROWS=2000` takes more throws.
#[test]
fn a_box_thrown_a_hundred_times_ends_on_a_face_and_gains_no_energy() {
    let (mut seed, mut inexact, mut steps) = (0x2545_f491_4f6c_dd1d, 0, 0);
    let count = std::env::var("LAGRANGE_THROWS").ok().and_then(|count| count.parse().ok()).unwrap_or(100);
    for throw in 0..count {
        let q: [f64; 4] = std::array::from_fn(|_| random(&mut seed));
        let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        let mut start = flat([0.0, 0.0, 0.6], [0.0; 3], [0.0; 3]);
        start[3..7].copy_from_slice(&q.map(|x| x / length));
        start[7..10].fill_with(|| 2.0 * random(&mut seed));
        start[10..].fill_with(|| 8.0 * random(&mut seed));
        let run = Thrown::default().simulate(start).until(4.0).method(Stepped::every(1e-3)).energy().run();
        let run = run.unwrap_or_else(|error| panic!("throw {throw}: {error}"));
        let energy = run.column("energy").expect("recorded");
        let rise = energy.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        // Overlaps are removed upwards, by less than a micrometre in total.
        assert!(rise < 2e-6, "throw {throw} gains {rise}");
        let [_, _, z, a, b, c, d, velocities @ ..] = run.last();
        let up = [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d];
        let face = up.iter().position(|part| part.abs() > 1.0 - 1e-9);
        let face = face.unwrap_or_else(|| panic!("throw {throw} ends on no face: {up:?}"));
        assert!((z - [0.2, 0.15, 0.1][face]).abs() < 1e-7, "throw {throw}: {z}");
        assert!(velocities.iter().all(|v| v.abs() < 1e-6), "throw {throw}: {velocities:?}");
        (inexact, steps) = (inexact + run.work().inexact, steps + run.work().steps);
    }
    assert!(inexact * 500 < steps, "{inexact} of {steps} steps miss the law by more than rounding");
}

/// The reactions of both ends of an edge are indeterminate along it. From zero, it takes thousands
/// of sweeps to find those that obey the law.
#[test]
fn a_box_is_thrown_back_from_its_edge() {
    let hits = [
        [0.100, 0.095, 0.174_217_269, -0.314_184_981, -0.426_007_871, 0.681_351_641, 0.505_534_404]
            .into_iter()
            .chain([
                0.441_591_997,
                0.416_525_763,
                -2.984_224_85,
                6.860_063_146,
                -3.730_543_94,
                0.499_770_132,
            ]),
        [0.257, -0.253, 0.178_413_147, 0.387_483_884, -0.166_056_174, 0.357_563_897, -0.833_325_962]
            .into_iter()
            .chain([
                1.530_507_816,
                -1.506_316_841,
                -3.328_558_552,
                -5.900_333_384,
                0.727_326_364,
                -2.782_139_564,
            ]),
        [0.034, -0.116, 0.219_339_428, -0.339_208_308, -0.658_097_945, -0.436_609_055, 0.511_093_274]
            .into_iter()
            .chain([
                0.123_966_673,
                -0.423_902_849,
                -2.728_521_068,
                0.948_181_965,
                -1.220_669_115,
                2.623_196_015,
            ]),
    ];
    for hit in hits {
        let mut start = [0.0; 13];
        start.iter_mut().zip(hit).for_each(|(entry, value)| *entry = value);
        let run = Thrown::default().simulate(start).until(2e-3).method(Stepped::every(1e-3)).run();
        let run = run.expect("thrown back");
        assert_eq!(run.work().inexact, 0);
        assert!(run.last()[9] > -1.5, "{:?}", run.last());
    }
}

#[test]
fn a_stack_falls_together_and_stands() {
    let start = [0.0, 0.1, 0.3, 0.35, 0.6, 0.0, 0.0, 0.0, 0.0, 0.0];
    let stack = Stack::default();
    let run = stack.simulate(start).until(2.0).method(Stepped::every(1e-3)).energy();
    let run = run.run().expect("it falls");
    assert!(run.last().iter().all(|entry| entry.abs() < 1e-9), "{:?}", run.last());
    let energy = run.column("energy").expect("recorded");
    assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-12));
    let end = run.system_at_end().expect("closed");
    let forces = end.reactions(2.0, &[0.0; 5], &[0.0; 5]);
    assert_near(forces, [15.0 * G, 14.0 * G, 12.0 * G, 9.0 * G, 5.0 * G], 1e-9);
}

#[test]
fn a_robot_that_is_dropped_stands_within_the_limits_of_its_file() {
    let walker = Walker::default();
    let mut state = walker.start();
    (state.trunk_z, state.trunk_qx, state.trunk_qw) = (0.35, 0.05, (1.0_f64 - 0.05 * 0.05).sqrt());
    let run = walker.simulate(state).until(3.0).method(Stepped::every(1e-3)).energy().run();
    let run = run.expect("it lands");
    for (time, state) in run.iter() {
        let gaps = gaps(&WalkerState::from(state));
        assert!(gaps.iter().all(|gap| *gap > -1e-5), "{time}: {gaps:?}");
    }
    let energy = run.column("energy").expect("recorded");
    let rise = energy.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    assert!(rise < 1e-6, "{rise}");
    let end = WalkerState::from(run.last());
    let speed = end.velocities().iter().fold(0.0_f64, |speed, v| speed.max(v.abs()));
    assert!(speed < 1e-6, "it is at rest: {speed}");
    let walker = run.system_at_end().expect("in other modes");
    assert_eq!((walker.lift_lower, walker.lift_friction), (Contact::Closed, Friction::Sticks));
    let reactions = walker.reactions(3.0, &end.coordinates(), &end.velocities());
    let normal = (0..4).map(|foot| reactions[11 + 3 * foot]).sum::<f64>();
    assert!((normal - WEIGHT).abs() < 1e-6 * WEIGHT, "{normal} carry {WEIGHT}");
}

#[test]
fn constraints_dry_joints_stops_and_other_events_go_together() {
    let angle = 1.0_f64;
    let start = [angle.sin(), -angle.cos(), 0.0, 0.0];
    let held = Held::default();
    let rigid = held.simulate(start).until(1.2).run().expect("it swings");
    let error = |h: f64| {
        let run =
            held.simulate(start).until(1.2).method(Stepped::every(h)).energy().run().expect("it swings");
        let [x, y, ..] = run.last();
        assert!((x.hypot(y) - 1.0).abs() < 1e-12, "on the rod");
        assert!(times(&run, "stop").is_empty(), "contacts of steps are no events");
        let [stepped, exact] = [&run, &rigid].map(|run| times(run, "lowest")[0]);
        assert!((stepped - exact).abs() < 2.0 * h, "{stepped} for {exact}");
        (x - rigid.last()[0]).abs()
    };
    let errors = [2e-3, 2.5e-4].map(error);
    assert!(errors[1] < 0.25 * errors[0] && errors[1] < 1e-3, "{errors:?}");
}

#[test]
fn steps_are_the_same_bits_whatever_is_seen_of_them() {
    let start = flat([0.0, 0.0, 0.5], [1.0, 0.2, 0.0], [3.0, -2.0, 1.0]);
    let thrown = Thrown::default();
    let method = Stepped::every(2e-3);
    let plain = thrown.simulate(start).until(1.0).method(method).run().expect("it lands");
    let seen = thrown.simulate(start).until(1.0).every(7e-4).method(method).dense();
    let seen = seen.event("up", Direction::Crossing, |_, _, y| y[9]).run().expect("it lands");
    assert_eq!(plain.last(), seen.last());
    let middle = seen.at(0.3333).expect("within the run");
    let length = middle[3..7].iter().map(|x| x * x).sum::<f64>();
    assert!((length - 1.0).abs() < 1e-14);
    let mut count = 0;
    let end = integrate::integrate(&thrown, 0.0, start, 1.0, &method, |_, _| count += 1);
    assert_eq!(end.expect("it lands"), plain.last());
    assert_eq!(count, 501);
    let last = thrown.simulate(start).until(1e-3).method(method).run().expect("one short step");
    assert_eq!(last.work().steps, 1);
}

#[test]
fn invalid_settings_are_refused() {
    let words = |h: f64, mu: f64, e: f64| {
        let thrown = Thrown { mu, e, ..Thrown::default() };
        let start = flat([0.0, 0.0, 0.11], [0.0; 3], [0.0; 3]);
        let run = thrown.simulate(start).until(0.1).method(Stepped::every(h)).run();
        run.err().map(|error| error.to_string()).unwrap_or_default()
    };
    for h in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        assert!(words(h, 0.5, 0.3).contains("the step size must be positive and finite"), "{h}");
    }
    assert!(words(1e-3, -0.5, 0.3).contains("is negative"), "{}", words(1e-3, -0.5, 0.3));
    assert!(words(1e-3, 0.5, 1.5).contains("coefficient of restitution"), "{}", words(1e-3, 0.5, 1.5));
    assert!(words(1e-3, f64::NAN, 0.3).contains("NaN"), "{}", words(1e-3, f64::NAN, 0.3));
    let method = Stepped::every(1e-3).largest_residual(0.0);
    let start = flat([0.0, 0.0, 0.11], [0.0; 3], [0.0; 3]);
    let refused = Thrown::default().simulate(start).until(0.1).method(method).run();
    assert!(refused.expect_err("zero").to_string().contains("the largest residual must be positive"));
    let back = Thrown::default().simulate(start).until(-0.1).method(Stepped::every(1e-3)).run();
    assert!(back.expect_err("backwards").to_string().contains("forwards in time only"));
}

#[test]
fn laws_drive_what_steps_and_ranges_hold() {
    let pushed = Pushed::default();
    let start = [0.0; 4];
    let run = pushed.simulate(start).until(2.0).drive(|_, t, _| PushedInputs { u: 0.5 * G * t });
    let run = run.method(Stepped::every(1e-3)).run().expect("it is pushed");
    // It starts at t = 1: v̇ = ½ g (t − 1).
    let speed = 0.25 * G;
    assert!((run.last()[2] - speed).abs() < 0.01, "{} for {speed}", run.last()[2]);
    let refused = Pushed { mu: -1.0, ..Pushed::default() };
    let run = refused.simulate(start).until(1.0).method(Stepped::every(1e-3)).run();
    assert!(run.expect_err("out of range").to_string().contains("`mu`"));
}

#[test]
fn overlaps_are_taken_out_as_positions() {
    let mut start = flat([0.0, 0.0, 0.08], [0.0; 3], [0.0; 3]);
    start[3..7].copy_from_slice(&[(TAU / 500.0).cos(), (TAU / 500.0).sin(), 0.0, 0.0]);
    let run =
        Slider::default().simulate(start).until(0.5).method(Stepped::every(1e-3)).run().expect("it rises");
    let highest = run.iter().map(|(_, y)| y[9].abs()).fold(0.0, f64::max);
    assert!(highest < 0.2, "depth is no speed: {highest}");
    let [_, _, z, ..] = run.last();
    assert!((z - 0.1).abs() < 1e-6, "{z}");
}
