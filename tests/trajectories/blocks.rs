//! Cuboids and rods that touch with faces and edges, in steps, against closed forms.
//!
//! `cargo motions --test blocks` runs these tests.
#![cfg(any(not(debug_assertions), clippy))]

mod stacks;
mod walls;

use lagrange::Simulate;
use lagrange::contact::{Contact, Stepped};
use lagrange::simulate::Trajectory;

const G: f64 = 9.81;

/// A box on a long one, which is fixed to the ground, pushed at a height above its centre.
mod pair {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Pair;
        param mu = 0.5, e = 0, push = 0, height = 0;
        gravity = (0, 0, -9.81);
        body plank { mass: 50; shape: cuboid(4, 1, 0.2); }
        body case { mass: 2; shape: cuboid(0.4, 0.4, 0.8); }
        free plank; free case;
        for i in 0..4 { contact foot[i] = plank.corner(i) on ground { friction: 0.9; } }
        contact touch = case on plank { friction: mu; restitution: e; }
        force (push, 0, 0) at case.point(0, 0, height);
        for i in 0..4 { output corner[i] = touch[i].normal; }
        output load = sum(i in 0..8, touch[i].normal);
    }
}
use pair::Pair;

/// A plank below a box: the normal points down.
mod reversed {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Reversed;
        gravity = (0, 0, -9.81);
        body plank { mass: 50; shape: cuboid(1, 1, 0.2); }
        body case { mass: 2; shape: cuboid(0.4, 0.4, 0.4); }
        free plank; free case;
        for i in 0..4 { contact foot[i] = plank.corner(i) on ground { friction: 0.9; } }
        contact touch = plank on case { friction: 0.5; }
    }
}
use reversed::Reversed;

/// A stack of three cubes.
mod stack {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Stack;
        param push = 0;
        gravity = (0, 0, -9.81);
        for i in 0..3 { body cube[i] { mass: 1; shape: cuboid(0.2, 0.2, 0.2); } free cube[i]; }
        for i in 0..4 { contact foot[i] = cube[0].corner(i) on ground { friction: 0.5; } }
        contact lower = cube[1] on cube[0] { friction: 0.2; }
        contact upper = cube[2] on cube[1] { friction: 0.1; }
        force (push, 0, 0) at cube[1].center;
    }
}
use stack::Stack;

/// A round bar on two blocks, which are fixed to the ground.
mod bar {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Bar;
        param slope = 0;
        gravity = (0, slope, -9.81);
        for i in 0..2 { body block[i] { mass: 50; shape: cuboid(0.4, 0.4, 0.4); } free block[i]; }
        body bar { mass: 3; inertia: (0.02, 0.5, 0.5); shape: slender_rod(1.4); }
        free bar;
        for i in 0..2 { for k in 0..4 { contact foot[i][k] = block[i].corner(k) on ground { friction: 0.9; } } }
        contact left = bar on block[0] { friction: 0.6; radius: 0.1; }
        contact right = bar on block[1] { friction: 0.6; radius: 0.1; }
        output load_left = left[0].normal + left[1].normal;
        output load_right = right[0].normal + right[1].normal;
    }
}
use bar::Bar;

/// Rods in nested parts, with units and single precision.
mod rafts {
    lagrange::system! {
        #[scalar(f32)]
        #[derive(Clone, Debug)]
        pub struct Rafts;
        param m: kg = 1, j: kg*m^2 = 0.1, l: m = 1, r: m = 0.1;
        part Pair(m, j, l, r) {
            for i in 0..2 {
                body log[i] { mass: m; inertia: (j / 10, j, j); shape: slender_rod(l); }
                free log[i];
            }
            contact touch = log[1] on log[0] { friction: 0.5; radius: r; }
        }
        part Raft(m, j, l, r) { pair[i in 0..2]: Pair { m: m; j: j; l: l; r: r; } }
        raft: Raft { m: m; j: j; l: l; r: r; }
        output gap = raft.pair[1].touch[0].gap;
    }
}
use rafts::Rafts;

/// Returns a position at rest, upright.
fn at(x: f64, y: f64, z: f64) -> [f64; 7] {
    [x, y, z, 1.0, 0.0, 0.0, 0.0]
}

/// Returns the state of bodies at rest in these positions.
fn state<const BODIES: usize, const LENGTH: usize>(places: [[f64; 7]; BODIES]) -> [f64; LENGTH] {
    let mut state = [0.0; LENGTH];
    state.chunks_mut(7).zip(places).for_each(|(entries, place)| entries.copy_from_slice(&place));
    state
}

fn pushed(pair: &Pair, speed: f64, end: f64, h: f64) -> Trajectory<Pair> {
    let mut start: [f64; 26] = state([at(0.0, 0.0, 0.1), at(-1.0, 0.0, 0.6)]);
    start[20] = speed;
    pair.simulate(start).until(end).method(Stepped::every(h)).energy().outputs().run().expect("it runs")
}

#[test]
fn a_box_presses_on_a_box_with_its_weight() {
    let run = pushed(&Pair::default(), 0.0, 0.2, 1e-3);
    let load = run.column("load").expect("recorded");
    assert!((load[load.len() - 1] - 2.0 * G).abs() < 1e-9, "{load:?}");
    let system = run.system_at_end().expect("it stands");
    assert_eq!([system.touch_0, system.touch_4], [Contact::Closed, Contact::Open]);
}

/// Rounding of gaps and velocities would decide which corners press, anew in each step.
#[test]
fn corners_share_a_load_evenly_in_each_step() {
    let run = pushed(&Pair::default(), 0.0, 0.1, 1e-3);
    for name in ["corner[0]", "corner[1]", "corner[2]", "corner[3]"] {
        let loads = run.column(name).expect("recorded");
        let worst = loads[1..].iter().map(|load| (load - 0.5 * G).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-9, "{name}: {worst:e}");
    }
}

#[test]
fn the_body_below_may_be_named_first() {
    let start: [f64; 26] = state([at(0.0, 0.0, 0.1), at(0.1, 0.0, 0.4)]);
    let run =
        Reversed::default().simulate(start).until(0.2).method(Stepped::every(1e-3)).run().expect("it stands");
    let moved = run.last().iter().zip(&start).map(|(end, start)| (end - start).abs()).fold(0.0, f64::max);
    assert!(moved < 1e-12, "{moved}");
}

/// The distance v²/(2 μ g), with an error of the order of the step.
#[test]
fn a_box_slides_on_a_box_until_friction_stops_it() {
    let distance = 1.0 / (2.0 * 0.3 * G);
    for h in [1e-3, 5e-4] {
        let run = pushed(&Pair { mu: 0.3, ..Pair::default() }, 1.0, 0.4, h);
        let [plank, x, y, z] = [0, 7, 8, 9].map(|entry| run.last()[entry]);
        assert!((x + 1.0 - distance).abs() < 0.6 * h, "{x}");
        assert!(plank.abs() < 1e-9 && y.abs() < 1e-9 && (z - 0.6).abs() < 1e-9, "{plank} {y} {z}");
        let energy = run.column("energy").expect("recorded");
        assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9));
    }
}

/// A push F at the height h over the base tips a box of the width b if F h > m g b/2.
#[test]
fn a_box_tips_over_its_edge_beyond_the_threshold() {
    let least = 2.0 * G * 0.2 / 0.6;
    for (part, tips) in [(0.98, false), (1.02, true)] {
        let run =
            pushed(&Pair { mu: 0.9, push: part * least, height: 0.2, ..Pair::default() }, 0.0, 0.6, 2e-3);
        let [w, _, y, _] = [10, 11, 12, 13].map(|entry| run.last()[entry]);
        let angle = 2.0 * y.atan2(w);
        assert_eq!(angle > 0.01, tips, "{part}: {angle}");
        assert!(tips || angle.abs() < 1e-9, "{angle}");
    }
}

#[test]
fn a_stack_stands() {
    let start: [f64; 39] = state([at(0.0, 0.0, 0.1), at(0.0, 0.0, 0.3), at(0.0, 0.0, 0.5)]);
    let run =
        Stack::default().simulate(start).until(2.0).method(Stepped::every(5e-3)).run().expect("it stands");
    let creep = run.last().iter().zip(&start).map(|(end, start)| (end - start).abs()).fold(0.0, f64::max);
    assert!(creep < 1e-9, "{creep}");
    assert_eq!(run.work().inexact, 0);
}

/// The middle cube slides out under friction on both of its faces, followed by the upper one.
#[test]
fn a_pushed_stack_keeps_its_supports() {
    let start: [f64; 39] = state([at(0.0, 0.0, 0.1), at(0.01, 0.0, 0.3), at(-0.01, 0.0, 0.5)]);
    let stack = Stack { push: 8.0, ..Stack::default() };
    let run = stack.simulate(start).until(0.15).method(Stepped::every(5e-4)).run().expect("it slides");
    let ends = run.last();
    let path = |acceleration: f64| 0.5 * acceleration * 0.15 * 0.15;
    assert!(ends[0].abs() < 1e-9, "{ends:?}");
    assert!((ends[7] - 0.01 - path(8.0 - 0.2 * 2.0 * G - 0.1 * G)).abs() < 2e-4, "{ends:?}");
    assert!((ends[14] + 0.01 - path(0.1 * G)).abs() < 2e-4, "{ends:?}");
    for (entry, height) in [(2, 0.1), (9, 0.3), (16, 0.5)] {
        assert!((ends[entry] - height).abs() < 1e-9, "{ends:?}");
    }
    let let_go = Stack { push: 0.0, ..run.system_at_end().expect("it moves").clone() };
    let run = let_go.simulate(ends).until(0.6).method(Stepped::every(2e-3)).run().expect("it stops");
    assert!((run.last()[16] - 0.5).abs() < 1e-9, "it keeps its supports: {:?}", run.last());
    assert!(run.last()[21..].iter().all(|rate| rate.abs() < 1e-9));
}

fn bar_on_blocks() -> [f64; 39] {
    state([at(-0.5, 0.0, 0.2), at(0.5, 0.0, 0.2), at(0.0, 0.0, 0.5)])
}

#[test]
fn a_bar_lies_on_two_blocks() {
    let bar = Bar::default();
    let run = bar.simulate(bar_on_blocks()).until(0.2).method(Stepped::every(1e-3));
    let run = run.record("load_left").record("load_right").run().expect("it lies");
    for name in ["load_left", "load_right"] {
        let load = run.column(name).expect("recorded");
        assert!((load[load.len() - 1] - 1.5 * G).abs() < 1e-8, "{name}: {load:?}");
    }
    assert!((run.last()[16] - 0.5).abs() < 1e-12);
}

/// The acceleration g/(1 + J/(m r²)) along a slope, with an error of the order of the step.
#[test]
fn a_bar_rolls_over_faces() {
    for h in [2e-3, 1e-3] {
        let bar = Bar { slope: 1.0, ..Bar::default() };
        let run = bar.simulate(bar_on_blocks()).until(0.5).method(Stepped::every(h)).run().expect("it rolls");
        let path = 0.5 * 0.25 / (1.0 + 0.02 / (3.0 * 0.01));
        assert!((run.last()[15] - path).abs() < 0.5 * h, "{} {path}", run.last()[15]);
        assert!((run.last()[16] - 0.5).abs() < 1e-6, "{}", run.last()[16]);
    }
}

/// Parallel rods and crossed ones collide at 1 m/s, and move on together at half that speed.
#[test]
fn rods_of_parts_in_parts_meet_in_single_precision() {
    let places = [at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.15), at(0.0, 5.0, 0.0), at(0.0, 5.0, 0.15)];
    let mut start = state::<4, 52>(places).map(|entry| entry as f32);
    let across = std::f32::consts::FRAC_1_SQRT_2;
    (start[24], start[27]) = (across, across);
    (start[36], start[48]) = (-1.0, -1.0);
    let rafts = Rafts::default();
    let run = rafts.simulate(start).until(0.2).method(Stepped::every(1e-3)).record("gap");
    let run = run.run().expect("they meet");
    for entry in [30, 36, 42, 48] {
        assert!((run.last()[entry] + 0.5).abs() < 1e-4, "{entry}: {:?}", run.last());
    }
    let gap = run.column("gap").expect("recorded");
    assert!((gap[0] - 0.05).abs() < 1e-6 && gap[gap.len() - 1].abs() < 1e-5, "{gap:?}");
}

fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// Computes the rise of the energy in a step of a pair, without the work of displacements that
/// remove overlaps. Positions move with the velocities at the end of a step, which adds half of
/// h m g Δv.
fn rise([before, after]: [[f64; 26]; 2], [from, to]: [f64; 2], h: f64) -> f64 {
    let bodies = [(50.0, 2, 16), (2.0, 9, 22)];
    let work = bodies.map(|(mass, z, rate): (f64, usize, usize)| {
        let lift = after[z] - before[z] - h * after[rate];
        mass * G * (lift + 0.5 * h * (after[rate] - before[rate]))
    });
    to - from - work.iter().sum::<f64>()
}

/// Only explicit gyroscopic moments remain, with up to half of h² |ω × J ω|²/J. The energy itself
/// rises where overlaps are removed. `LAGRANGE_THROWS=1000` throws more often.
#[test]
fn thrown_boxes_gain_no_energy_but_by_displacements() {
    let count = std::env::var("LAGRANGE_THROWS").ok().and_then(|count| count.parse().ok()).unwrap_or(20);
    let (mut seed, mut worst, mut largest) = (1, 0.0_f64, 0.0_f64);
    for throw in 0..count {
        let mut start: [f64; 26] = state([at(0.0, 0.0, 0.1), at(0.0, 0.0, 0.9)]);
        let q: [f64; 4] = std::array::from_fn(|_| random(&mut seed));
        let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        start[10..14].copy_from_slice(&q.map(|x| x / length));
        start[20..23].fill_with(|| random(&mut seed));
        start[23..].fill_with(|| 4.0 * random(&mut seed));
        let pair = Pair { e: 0.3, ..Pair::default() };
        let run = pair.simulate(start).until(1.5).method(Stepped::every(1e-3)).energy().run();
        let run = run.unwrap_or_else(|error| panic!("throw {throw}: {error}"));
        let energy = run.column("energy").expect("recorded");
        let states = run.states().collect::<Vec<_>>();
        for (states, energy) in states.windows(2).zip(energy.windows(2)) {
            let gained = rise([states[0], states[1]], [energy[0], energy[1]], 1e-3);
            (worst, largest) = (worst.max(gained), largest.max(energy[1] - energy[0]));
            assert!(gained < 5e-5, "throw {throw} gains {gained}; before, at most {worst}");
        }
    }
    println!("without displacements {worst:e} J, with them {largest:e} J");
    assert!(largest < 3e-3, "{largest}");
}

#[test]
fn other_methods_name_the_contact_and_the_method() {
    let start: [f64; 26] = state([at(0.0, 0.0, 0.1), at(0.0, 0.0, 0.6)]);
    let failure =
        Pair::default().simulate(start).until(1.0).run().map(drop).expect_err("it is refused").to_string();
    assert!(
        failure.contains("the contact `touch[0]` of faces and edges needs the method `Stepped`"),
        "{failure}"
    );
}
