//! The trade of the three ways to simulate contacts on four scenes: the error of the end,
//! evaluations or steps, and time. It prints the table of `docs/contacts.md`.
//!
//! Errors are distances of the final position from closed forms of rigid bodies. For compliant
//! contacts these include creep, and depths of 0.1 mm. The bouncing ball on soft ground has the
//! restitution 0.8 at the speed of its first impact only.
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
    /// A ball that slides on the ground until it rolls.
    #[derive(Clone, Debug)]
    pub struct Bowl;

    param mu = 0.3;
    gravity = (0, 0, -9.81);
    body ball { mass: 2; shape: solid_sphere(0.1); }
    free ball;
    contact touch = ball.point(0, 0, 0) on ground { radius: 0.1; friction: mu; }
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
    /// The ball on soft ground, with the restitution 0.8 at the speed of its first impact.
    #[derive(Clone, Debug)]
    pub struct SoftBall;

    param k = 1e5, d = 0.08424216618169522;
    coord y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (0, y); }
    contact floor = ball on ground { stiffness: k; dissipation: d; }
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

lagrange::system! {
    /// The ball that slides and rolls on soft ground, into which it sinks by 0.1 mm.
    #[derive(Clone, Debug)]
    pub struct SoftBowl;

    param mu = 0.3, v = 1e-3, k = 2e5;
    gravity = (0, 0, -9.81);
    body ball { mass: 2; shape: solid_sphere(0.1); }
    free ball;
    contact touch = ball.point(0, 0, 0) on ground {
        radius: 0.1; friction: mu; stiffness: k; dissipation: 1; stiction: v;
    }
    emit { jacobian }
}

/// Prints a row for each method, with the error of the last state.
macro_rules! scene {
    (rigid: $name:literal, $system:expr, $start:expr, $end:expr, $error:expr) => {
        let row = [$name, "events"];
        scene!(@row row, "`Verner98`, tolerance 1e-6", $system, $start, $end, $error, Verner98::tolerance(1e-6));
        scene!(@row row, "`Verner98`, tolerance 1e-10", $system, $start, $end, $error, Verner98::tolerance(1e-10));
        scene!(@row row, "`RungeKutta4`, step 1 ms", $system, $start, $end, $error, RungeKutta4 { step: 1e-3 });
        scene!(@row row, "`Radau5`, tolerance 1e-8", $system, $start, $end, $error, Radau5::tolerance(1e-8));
        let row = [$name, "steps"];
        scene!(@row row, "`Stepped`, step 10 ms", $system, $start, $end, $error, Stepped::every(1e-2));
        scene!(@row row, "`Stepped`, step 1 ms", $system, $start, $end, $error, Stepped::every(1e-3));
        scene!(@row row, "`Stepped`, step 0.1 ms", $system, $start, $end, $error, Stepped::every(1e-4));
    };
    (soft: $name:literal, $setting:literal, $system:expr, $start:expr, $end:expr, $error:expr) => {
        let row = [$name, "compliance"];
        let label = concat!("`Verner98`, tolerance 1e-6, ", $setting);
        scene!(@row row, label, $system, $start, $end, $error, Verner98::tolerance(1e-6));
        let label = concat!("`Radau5`, tolerance 1e-6, ", $setting);
        scene!(@row row, label, $system, $start, $end, $error, Radau5::tolerance(1e-6));
    };
    (@row $row:ident, $label:expr, $system:expr, $start:expr, $end:expr, $error:expr, $method:expr) => {{
        let [scene, way] = $row;
        let run = || $system.simulate(black_box($start)).until($end).ends_only().method($method).run();
        let mut least = f64::INFINITY;
        for _ in 0..REPEATS {
            let began = Instant::now();
            let _ = black_box(run());
            least = least.min(began.elapsed().as_secs_f64());
        }
        let price = match run() {
            Ok(run) => {
                let work = if way == "steps" { run.work().steps } else { run.work().evaluations };
                let error: f64 = $error(run.last());
                format!("{error:.1e} | {:.0} | {:.3}", work as f64 / $end, 1e3 * least / $end)
            }
            Err(error) => {
                let words = error.to_string();
                format!("{} | |", words.split(':').next().unwrap_or(&words))
            }
        };
        println!("| {scene} | {way} | {} | {price} |", $label);
    }};
}

/// Number of runs, the shortest of which counts.
const REPEATS: usize = 20;
/// The box on its corners, pushed along the diagonal.
const START: [f64; 13] = [0.0, 0.0, 0.05, 1.0, 0.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0];
/// The ball on the ground, which turns about its path and backwards.
const THROWN: [f64; 13] = [0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 15.0, -10.0, 4.0];
/// Depth to which block, box and rolling ball sink into soft ground.
const DEPTH: f64 = 2.0 * 9.81 / 2e5;

fn main() {
    println!("| scene | way | method and setting | error, m | evaluations or steps for 1 s | ms for 1 s |");
    println!("|---|---|---|---|---|---|");
    block();
    ball();
    case();
    bowl();
}

fn block() {
    let error = |y: [f64; 4]| (y[0] - 4.5 / (0.3 * 9.81)).abs();
    scene!(rigid: "block slides and stops", Block::default(), [0.0, 0.0, 3.0, 0.0], 2.0, error);
    let start = [0.0, -DEPTH, 3.0, 0.0];
    let soft = |v: f64| SoftBlock { v, ..Default::default() };
    scene!(soft: "block slides and stops", "stiction 1e-3 m/s", soft(1e-3), start, 2.0, error);
    scene!(soft: "block slides and stops", "stiction 1e-4 m/s", soft(1e-4), start, 2.0, error);
}

fn ball() {
    let error = |y: [f64; 2]| (y[0] - bounced(1.0, 0.8, 3.0)).abs();
    scene!(rigid: "ball bounces", Ball::default(), [1.0, 0.0], 3.0, error);
    let soft = |k: f64| SoftBall { k, ..Default::default() };
    scene!(soft: "ball bounces", "stiffness 1e5 N/m", soft(1e5), [1.0, 0.0], 3.0, error);
    scene!(soft: "ball bounces", "stiffness 1e7 N/m", soft(1e7), [1.0, 0.0], 3.0, error);
}

fn case() {
    let path = 5.0_f64.sqrt() / (2.0 * 0.3 * 9.81);
    let error = |y: [f64; 13]| (y[0] - 2.0 * path).hypot(y[1] - path);
    scene!(rigid: "box slides on four corners", Case::default(), START, 2.0, error);
    let soft = |v: f64| SoftCase { v, ..Default::default() };
    scene!(soft: "box slides on four corners", "stiction 1e-3 m/s", soft(1e-3), sunk(START), 2.0, error);
    scene!(soft: "box slides on four corners", "stiction 1e-4 m/s", soft(1e-4), sunk(START), 2.0, error);
}

fn bowl() {
    let [x, y] = rolled(THROWN, 2.0);
    let error = |state: [f64; 13]| (state[0] - x).hypot(state[1] - y);
    scene!(rigid: "spinning ball slides, then rolls", Bowl::default(), THROWN, 2.0, error);
    let soft = |v: f64| SoftBowl { v, ..Default::default() };
    scene!(soft: "spinning ball slides, then rolls", "stiction 1e-3 m/s", soft(1e-3), sunk(THROWN), 2.0, error);
    scene!(soft: "spinning ball slides, then rolls", "stiction 1e-4 m/s", soft(1e-4), sunk(THROWN), 2.0, error);
}

/// Returns a state at rest on soft ground, with its velocities.
fn sunk(start: [f64; 13]) -> [f64; 13] {
    let mut sunk = start;
    sunk[2] -= DEPTH;
    sunk
}

/// Returns where a solid ball of radius 0.1 m is after sliding along a parabola, then rolling.
///
/// Its slip velocity s keeps its direction, and shrinks by 7/2 μ g. Rolling begins at the velocity
/// v − 2/7 s.
fn rolled(start: [f64; 13], end: f64) -> [f64; 2] {
    let (mu, g, radius) = (0.3, 9.81, 0.1);
    let (v, turning) = ([start[7], start[8]], [start[10], start[11]]);
    let slip = [v[0] - radius * turning[1], v[1] + radius * turning[0]];
    let speed = slip[0].hypot(slip[1]);
    let sliding = 2.0 * speed / (7.0 * mu * g);
    std::array::from_fn(|i| {
        let slid = v[i] * sliding - 0.5 * mu * g * slip[i] / speed * sliding * sliding;
        slid + (v[i] - 2.0 / 7.0 * slip[i]) * (end - sliding)
    })
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
