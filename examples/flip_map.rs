//! Double pendulums released from rest, at every angle of a grid: when does each lower rod first go
//! over the top?
//!
//! The map shows the time until the lower angle passes ±π; it is white if this takes more than 20
//! s. Inside the line, the energy is too small for any flip. In areas of one colour, neighbours
//! move alike; where colours mix, motions are chaotic.
//!
//! A hundred starts within a thousandth of a radian show the consequence. Their angles agree for
//! five seconds; in the next five their quantiles separate by whole turns.
//!
//! References: `tools/flip_map.py`, SciPy's DOP853 with handwritten equations, and the energy.
//!
//! With `--release` the map has 1000 × 1000 cells and takes some minutes on two processors,
//! otherwise 16 × 16. A number after `--` changes this size.

mod common;
#[path = "common/gallery.rs"]
mod gallery;

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

use common::compare;
use gallery::picture;
use lagrange::ensemble::Grid;
use lagrange::event::Direction;
use lagrange::{Ensembles, Simulate};

lagrange::system! {
    /// Two equal point masses on massless rods of equal lengths.
    #[derive(Clone, Debug)]
    pub struct DoublePendulum;

    param m: kg = 1, l: m = 1, g: m/s^2 = 9.81;
    coord theta1: rad, theta2: rad;

    let upper = l * (sin(theta1), -cos(theta1));
    let lower = upper + l * (sin(theta2), -cos(theta2));
    kinetic = kinetic_energy(m, dot(upper)) + kinetic_energy(m, dot(lower));
    potential = m * g * (upper.y + lower.y);
}

/// Final time of motions without a flip.
const UNTIL: f64 = 20.0;
const SIDE: usize = if cfg!(debug_assertions) { 16 } else { 1000 };
/// Initial angles, and the time at which the lower one passes ±π.
const REFERENCES: [([f64; 2], f64); 3] =
    [([1.0, -3.0], 0.216797574832), ([-2.0, 2.0], 1.387988078458), ([2.5, 1.0], 1.443001229979)];

/// Returns zero if the lower rod is upright, and rises as it goes over the top.
fn beyond_the_top([_, theta2, ..]: &[f64; 4]) -> f64 {
    theta2 * theta2 - PI * PI
}

/// True if the energy suffices for an upright lower rod: at least the energy with the upper rod
/// hanging.
fn can_flip([theta1, theta2]: [f64; 2]) -> bool {
    2.0 * theta1.cos() + theta2.cos() <= 1.0
}

/// Returns the angles at which the energy just suffices.
fn threshold() -> impl Iterator<Item = (f64, f64)> {
    let angle = |k: i32| FRAC_PI_2 * f64::from(k) / 200.0;
    let half =
        |sign: f64| (-200..=200).map(move |k| (sign * angle(k), sign * (1.0 - 2.0 * angle(k).cos()).acos()));
    half(1.0).chain(half(-1.0))
}

fn agree_with_references(pendulum: &DoublePendulum) -> Result<(), Box<dyn Error>> {
    for ([theta1, theta2], reference) in REFERENCES {
        let run = pendulum.simulate([theta1, theta2, 0.0, 0.0]).until(UNTIL).tolerance(1e-14);
        let run = run.stop_at("over the top", Direction::Rising, |_, _, y| beyond_the_top(y)).run()?;
        compare(&format!("{theta1}, {theta2}"), 2e-12, &[("t / s", run.end_time(), reference)]);
    }
    Ok(())
}

/// Draws the time of the first flip over both angles.
fn draw_map(pendulum: &DoublePendulum, side: usize) -> Result<(), Box<dyn Error>> {
    let grid = Grid::new(("theta1", -PI..PI, side), ("theta2", -PI..PI, side));
    let start = |i| {
        let [theta1, theta2] = grid.at(i);
        [theta1, theta2, 0.0, 0.0]
    };
    let flips = pendulum.ensemble(grid.len()).start(|i, _| start(i)).until(UNTIL).tolerance(1e-6);
    let flips = flips.stop_at("over the top", Direction::Rising, |_, _, y| beyond_the_top(y));
    let ends = flips.observe("flip", |_, t, _| if t < UNTIL { t } else { f64::NAN }).run()?;

    let times = ends.column("flip").unwrap_or_default();
    let has_flipped = |i: &usize| times[*i].is_finite();
    let flipped: Vec<usize> = (0..grid.len()).filter(has_flipped).collect();
    println!("{} of {} go over the top, {} motions failed", flipped.len(), grid.len(), ends.failures().len());
    assert!(ends.failures().is_empty() && !flipped.is_empty());
    assert!(flipped.iter().all(|i| can_flip(grid.at(*i))), "too little energy for that");

    let map = ends.map(&grid, "flip")?.logarithmic().named("time of the first flip in s");
    Ok(map.curve("least energy", threshold()).save(picture("flip_map.png")?)?)
}

/// Draws the separation of neighbouring motions.
fn draw_spread(pendulum: &DoublePendulum) -> Result<(), Box<dyn Error>> {
    let neighbours = pendulum.ensemble(100).start(|_, random| {
        let mut within = || 5e-4 * random.uniform(-1.0..1.0);
        [2.0 + within(), 1.0 + within(), 0.0, 0.0]
    });
    let samples = neighbours.until(12.0).tolerance(1e-8).every(0.05).run()?;
    Ok(samples.plot_quantiles("theta2", picture("flip_spread.svg")?)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = DoublePendulum::default();
    agree_with_references(&pendulum)?;
    draw_spread(&pendulum)?;
    draw_map(&pendulum, std::env::args().nth(1).map_or(Ok(SIDE), |side| side.parse())?)
}
