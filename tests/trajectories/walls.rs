//! A wall of bricks that stands, and a row of dominoes that falls, in steps.
//!
//! Times of the dominoes are those of `tools/dominoes.py`, which turns them about their edges and
//! computes impacts and motions without contact forces.

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::integrate::{Method, Stepper};
use lagrange::simulate::Trajectory;

use super::{G, at, state};

/// Three courses of bricks, with halves at the ends of the second one.
mod wall {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Wall;
        param mu = 0.6;
        gravity = (0, 0, -9.81);
        for i in 0..5 { body brick[i] { mass: 2; shape: cuboid(0.4, 0.2, 0.1); } free brick[i]; }
        for i in 0..2 { body half[i] { mass: 1; shape: cuboid(0.2, 0.2, 0.1); } free half[i]; }
        for i in 0..2 { for k in 0..4 { contact foot[i][k] = brick[i].corner(k) on ground { friction: mu; } } }
        for i in 0..2 {
            contact end[i] = half[i] on brick[i] { friction: mu; }
            contact middle[i] = brick[2] on brick[i] { friction: mu; }
            contact side[i] = brick[i + 3] on half[i] { friction: mu; }
            contact centre[i] = brick[i + 3] on brick[2] { friction: mu; }
        }
        output load = sum(i in 0..2, sum(k in 0..4, foot[i][k].normal));
    }
}
use wall::Wall;

/// Dominoes that do not rub on each other, and do not slip on the ground.
mod row {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Row;
        gravity = (0, 0, -9.81);
        for i in 0..8 {
            body domino[i] { mass: 1; shape: cuboid(0.1, 0.3, 0.5); }
            free domino[i];
            for k in 0..4 { contact foot[i][k] = domino[i].corner(k) on ground { friction: 3; } }
        }
        for i in 0..7 { contact touch[i] = domino[i + 1] on domino[i] {} }
    }
}
use row::Row;

const DOMINOES: usize = 8;
/// Height and thickness of a domino, the distance to the next one's place, and the rate of the
/// first one.
const HEIGHT: f64 = 0.5;
const THICKNESS: f64 = 0.1;
const PITCH: f64 = 0.3;
const RATE: f64 = 1.5;
/// Times at which each domino is hit by the one before it.
const HITS: [f64; DOMINOES - 1] =
    [0.338_561_128, 0.655_459_866, 0.832_198_899, 0.959_524_934, 1.065_077_607, 1.159_506_948, 1.247_739_098];

/// `LAGRANGE_SECONDS=60` lets the wall stand for longer.
#[test]
fn a_wall_of_bricks_stands() {
    let seconds = std::env::var("LAGRANGE_SECONDS").ok().and_then(|count| count.parse().ok()).unwrap_or(2.0);
    let places =
        [[-0.2, 0.05], [0.2, 0.05], [0.0, 0.15], [-0.2, 0.25], [0.2, 0.25], [-0.3, 0.15], [0.3, 0.15]];
    let start: [f64; 91] = state::<7, 91>(places.map(|[x, z]| at(x, 0.0, z)));
    let wall = Wall::default();
    let run = wall.simulate(start).until(seconds).method(Stepped::every(5e-3)).record("load");
    let run = run.run().expect("it stands");
    let creep = run.last().iter().zip(&start).map(|(end, start)| (end - start).abs()).fold(0.0, f64::max);
    println!("creep {creep:e} in {seconds} s; {:?}", run.work());
    assert!(creep < 1e-9, "{creep}");
    assert_eq!(run.work().inexact, 0);
    let load = run.column("load").expect("recorded");
    assert!((load[load.len() - 1] - 12.0 * G).abs() < 1e-6, "{}", load[load.len() - 1]);
}

/// Pushes the first domino, which turns about its front edge.
fn fall(h: f64, end: f64) -> Trajectory<Row> {
    let mut start: [f64; 104] =
        state::<DOMINOES, 104>(std::array::from_fn(|i| at(PITCH * i as f64, 0.0, HEIGHT / 2.0)));
    (start[56], start[58], start[60]) = (RATE * HEIGHT / 2.0, RATE * THICKNESS / 2.0, RATE);
    Row::default().simulate(start).until(end).method(Stepped::every(h)).energy().run().expect("they fall")
}

/// Returns the times at which dominoes start to turn.
fn hits(run: &Trajectory<Row>) -> [f64; DOMINOES - 1] {
    std::array::from_fn(|i| {
        let turns = |(_, state): &(f64, [f64; 104])| state[56 + 6 * (i + 1) + 4] > 1e-3;
        run.iter().find(turns).map_or(f64::NAN, |(time, _)| time)
    })
}

/// Each domino topples the next one, at times whose errors fall as the step.
#[test]
fn a_row_of_dominoes_falls_as_fast_as_edges_and_impacts_require() {
    for (h, allowed) in [(2e-3, 4.0), (1e-3, 4.0)] {
        let run = fall(h, 1.3);
        let found = hits(&run);
        println!("{h}: {:?}", std::array::from_fn::<f64, 7, _>(|i| (found[i] - HITS[i]) / h));
        for (found, wanted) in found.into_iter().zip(HITS) {
            assert!((found - wanted).abs() < allowed * h, "{found} for {wanted}");
        }
    }
}

/// Steps are of first order: each may raise the energy of 20 J by a term in h².
#[test]
fn falling_dominoes_gain_energy_in_proportion_to_the_step() {
    for h in [2e-3, 1e-3] {
        let run = fall(h, 1.7);
        let energy = run.column("energy").expect("recorded");
        let rise = energy.windows(2).map(|pair| (pair[1] - pair[0]).max(0.0)).sum::<f64>();
        println!("{h}: rise {rise:e}; {:?}", run.work());
        assert!(rise < 80.0 * h, "{h}: {rise}");
    }
}

/// The dominoes lie on each other, with many more contact points than velocities.
#[test]
fn fallen_dominoes_obey_the_law_of_contacts() {
    let run = fall(2e-3, 4.0);
    println!("{:?}", run.work());
    assert!(run.work().inexact <= 20, "{:?}", run.work());
    assert!(run.work().iterations < 100 * 2000, "{:?}", run.work());
}

/// Cubes that fall onto each other.
mod pile {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Pile;
        param mu = 0.5;
        gravity = (0, 0, -9.81);
        for i in 0..3 {
            body cube[i] { mass: 1; shape: cuboid(0.2, 0.2, 0.2); }
            free cube[i];
            for k in 0..8 { contact foot[i][k] = cube[i].corner(k) on ground { friction: mu; } }
        }
        for i in 0..2 { for j in (i + 1)..3 { contact touch[i][j] = cube[j] on cube[i] { friction: mu; } } }
    }
}
use pile::Pile;

/// Each cube ends at rest, with its centre at one, three or five halves of its edge, or leans.
#[test]
fn thrown_cubes_come_to_rest_in_a_pile() {
    let mut sines = (1..).map(|k: i32| (f64::from(k) * 1.7).sin());
    let mut next = || sines.next().expect("endless");
    for mu in [0.1, 0.5, 1.0] {
        let mut start = [0.0; 39];
        for i in 0..3 {
            let turn: [f64; 4] = std::array::from_fn(|_| next());
            let size = turn.iter().map(|part| part * part).sum::<f64>().sqrt();
            start[7 * i..7 * i + 3].copy_from_slice(&[0.04 * next(), 0.04 * next(), 0.25 + 0.36 * i as f64]);
            start[7 * i + 3..7 * i + 7].copy_from_slice(&turn.map(|part| part / size));
            start[24 + 6 * i..27 + 6 * i]
                .copy_from_slice(&std::array::from_fn::<f64, 3, _>(|_| 4.0 * next()));
        }
        let pile = Pile { mu, ..Pile::default() };
        let mut stepper = Stepped::every(2e-3).start(&pile, 0.0, &start, 4.0).expect("they fall");
        while stepper.time() < 4.0 {
            stepper.step(&pile, 4.0).expect("a step");
        }
        let residual = stepper.worst_residual();
        println!("{mu}: {residual:e}, {:?}", stepper.work());
        assert!(residual < 1e-8, "{mu}: steps that are not exact miss the law by {residual:e}");
        let run = pile.simulate(start).until(4.0).method(Stepped::every(2e-3)).energy().run();
        let run = run.expect("they fall");
        assert!(run.last()[21..].iter().all(|rate| rate.abs() < 1e-9), "{mu}: {:?}", run.last());
        assert!(run.work().inexact < 40, "{mu}: {:?}", run.work());
        let energy = run.column("energy").expect("recorded");
        assert!(energy[energy.len() - 1] > 3.0 * G * 0.1 - 1e-6, "{mu}: none is below the floor");
    }
}
