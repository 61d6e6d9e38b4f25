//! The price of motions with contacts, by adaptive methods and by fixed steps: the final error,
//! evaluations and time. `docs/contacts.md` has the table.
//!
//! Errors are those of the final position, against closed forms. For compliant contacts these
//! include creep and the depth of 0.1 mm.
//!
//! `cargo bench -p lagrange-benches --bench contacts`

use std::hint::black_box;
use std::time::Instant;

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::integrate::{Radau5, RungeKutta4, Verner98};

lagrange::system! {
    /// A sliding block.
    #[derive(Clone, Debug)]
    pub struct Block;

    param mu = 0.3, g = 9.81;
    coord x, y;
    kinetic = kinetic_energy(2, dot((x, y)));
    potential = gravitational_energy(2, g, y);
    event floor = y, falling => impact(0);
    friction rub = dot(x), mu * floor;
}

lagrange::system! {
    /// A bouncing ball.
    #[derive(Clone, Debug)]
    pub struct Ball;

    param bounce = 0.8, g = 9.81;
    coord y;
    kinetic = kinetic_energy(1, dot(y));
    potential = gravitational_energy(1, g, y);
    event floor = y, falling => impact(bounce);
}

lagrange::system! {
    /// A box on its four lower corners.
    #[derive(Clone, Debug)]
    pub struct Case;

    param mu = 0.3;
    gravity = (0, 0, -9.81);
    body case { mass: 2; shape: cuboid(0.4, 0.2, 0.1); }
    free case;
    for i in 0..4 { contact foot[i] = case.corner(i) on ground { friction: mu; } }
}

lagrange::system! {
    /// The block on soft ground, into which it sinks by 0.1 mm.
    #[derive(Clone, Debug)]
    pub struct SoftBlock;

    param mu = 0.3, v = 1e-3, k = 2e5;
    coord x, y;
    gravity = (0, -9.81);
    body block { mass: 2; center: (x, y); }
    contact floor = block on ground { friction: mu; stiffness: k; dissipation: 1; stiction: v; }
    emit { jacobian }
}

lagrange::system! {
    /// The box on soft ground, into which it sinks by 0.1 mm.
    #[derive(Clone, Debug)]
    pub struct SoftCase;

    param mu = 0.3, v = 1e-3, k = 5e4;
    gravity = (0, 0, -9.81);
    body case { mass: 2; shape: cuboid(0.4, 0.2, 0.1); }
    free case;
    for i in 0..4 {
        contact foot[i] = case.corner(i) on ground { friction: mu; stiffness: k; dissipation: 1; stiction: v; }
    }
    emit { jacobian }
}

/// Prints a row for each method, with the error of the last state.
macro_rules! scene {
    ($name:literal, $system:expr, $start:expr, $end:expr, $error:expr) => {
        let tolerance = Verner98::tolerance;
        scene!(@row $name, $system, $start, $end, $error, "`Verner98`, tolerance 1e-6", tolerance(1e-6));
        scene!(@row $name, $system, $start, $end, $error, "`Verner98`, tolerance 1e-10", tolerance(1e-10));
        scene!(@row $name, $system, $start, $end, $error, "`RungeKutta4`, step 1 ms", RungeKutta4 { step: 1e-3 });
        scene!(@row $name, $system, $start, $end, $error, "`Radau5`, tolerance 1e-8", Radau5::tolerance(1e-8));
        scene!(@row $name, $system, $start, $end, $error, "`Stepped`, step 1 ms", Stepped::every(1e-3));
        scene!(@row $name, $system, $start, $end, $error, "`Stepped`, step 0.1 ms", Stepped::every(1e-4));
    };
    (soft: $name:literal, $system:expr, $start:expr, $end:expr, $error:expr) => {
        scene!(@row $name, $system, $start, $end, $error, "`Verner98`, tolerance 1e-6", Verner98::tolerance(1e-6));
        scene!(@row $name, $system, $start, $end, $error, "`Radau5`, tolerance 1e-6", Radau5::tolerance(1e-6));
        scene!(@row $name, $system, $start, $end, $error, "`Radau5`, tolerance 1e-8", Radau5::tolerance(1e-8));
    };
    (@row $name:literal, $system:expr, $start:expr, $end:expr, $error:expr, $label:literal, $method:expr) => {{
        let run = || $system.simulate(black_box($start)).until($end).ends_only().method($method).run();
        let mut least = f64::INFINITY;
        for _ in 0..REPEATS {
            let began = Instant::now();
            let _ = black_box(run());
            least = least.min(began.elapsed().as_secs_f64());
        }
        match run() {
            Ok(run) => {
                let evaluations = run.work().evaluations as f64 / $end;
                let error: f64 = $error(run.last());
                println!("| {} | {} | {error:.1e} | {evaluations:.0} | {:.3} |", $name, $label, 1e3 * least / $end);
            }
            Err(error) => println!("| {} | {} | {error} | | |", $name, $label),
        }
    }};
}

/// Number of runs, the shortest of which counts.
const REPEATS: usize = 20;
/// The box on its corners, pushed along the diagonal.
const START: [f64; 13] = [0.0, 0.0, 0.05, 1.0, 0.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0];

/// Depth to which block and box sink into soft ground.
const DEPTH: f64 = 2.0 * 9.81 / 2e5;

fn main() {
    println!("| scene | method | error, m | evaluations for 1 s | ms for 1 s |");
    println!("|---|---|---|---|---|");
    let block = |y: [f64; 4]| (y[0] - 4.5 / (0.3 * 9.81)).abs();
    scene!("block slides and stops", Block::default(), [0.0, 0.0, 3.0, 0.0], 2.0, block);
    let ball = |y: [f64; 2]| (y[0] - bounced(1.0, 0.8, 3.0)).abs();
    scene!("ball bounces", Ball::default(), [1.0, 0.0], 3.0, ball);
    let path = 5.0_f64.sqrt() / (2.0 * 0.3 * 9.81);
    let case = |y: [f64; 13]| (y[0] - 2.0 * path).hypot(y[1] - path);
    scene!("box slides on four corners", Case::default(), START, 2.0, case);
    for v in [1e-3, 1e-4] {
        println!("stiction speed {v} m/s:");
        let (soft_block, soft_case) =
            (SoftBlock { v, ..Default::default() }, SoftCase { v, ..Default::default() });
        scene!(soft: "block, compliant", soft_block, [0.0, -DEPTH, 3.0, 0.0], 2.0, block);
        scene!(soft: "box, compliant", soft_case, sunk(START), 2.0, case);
    }
}

/// Returns the state of the box at rest on soft ground, with its velocities.
fn sunk(start: [f64; 13]) -> [f64; 13] {
    let mut sunk = start;
    sunk[2] -= DEPTH;
    sunk
}

/// Returns the height of a ball dropped from a height, with this coefficient of restitution.
fn bounced(height: f64, restitution: f64, end: f64) -> f64 {
    let g = 9.81;
    let (mut speed, mut t) = ((2.0 * g * height).sqrt(), (2.0 * height / g).sqrt());
    loop {
        speed *= restitution;
        let flight = 2.0 * speed / g;
        if t + flight > end {
            return (end - t) * (speed - 0.5 * g * (end - t));
        }
        t += flight;
    }
}
