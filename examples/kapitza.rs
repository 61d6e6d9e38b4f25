//! Kapitza's pendulum: a pivot that vibrates fast enough makes the upright position stable.
//!
//! The pivot of a pendulum of length l moves as a cos ωt along the vertical. Averaged over a fast
//! vibration the upright position is a minimum of the effective potential if
//!
//! ```text
//! a² ω² > 2 g l,
//! ```
//!
//! and small deviations from it then oscillate with Ω² = a² ω²/(2 l²) − g/l (Landau, Lifshitz, *Mechanics*,
//! §30). Here l = 1 m and a = 0.1 m, so that the bound is ω = 44.3 rad/s. The reference states at t =
//! 5 s were computed in 200-bit arithmetic with two step counts that agree in all printed digits.
//!
//! The vibration does work at the power −∂L/∂t. Its integral, by Simpson's rule, is the change of
//! the energy.
//!
//! For any amplitude, deviations obey Mathieu's equation. The boundaries of stability are reached
//! when the multipliers of the upright, a periodic orbit at rest, become real. SciPy computes them
//! as characteristic values (`tools/optimal.py`). For a > 0.45 l there is a second one, above which
//! the pendulum swings about the upright with half the frequency of the pivot. An ensemble shows
//! both.
//!
//! Look for the largest deviation from upright, θ = π: small for ω = 60 rad/s, several turns for 30
//! rad/s. The chart has 400 × 400 cells with `--release`, otherwise 12 × 12.
//!
//! `cargo run --release --example kapitza --features ensemble,linear,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::{PI, TAU};

use common::compare;
use lagrange::ensemble::Grid;
use lagrange::event::Direction;
use lagrange::orbits::Orbits;
use lagrange::{Ensembles, Simulate};

lagrange::system! {
    /// A pendulum whose pivot vibrates along the vertical; θ is measured from the lower position.
    #[derive(Clone, Debug)]
    pub struct Kapitza;

    param m: kg = 1.0, l: m = 1.0, a: m = 0.1, omega: rad/s = 60.0, g: m/s^2 = 9.81;
    coord theta: rad;

    let (x, y) = (l * sin(theta), a * cos(omega * t) - l * cos(theta));
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    emit { power, jacobian }
}

/// A vibration and its state at t = 5 s.
struct Run {
    title: &'static str,
    omega: f64,
    end: [f64; 2],
}

const STABLE: Run =
    Run { title: "omega = 60 rad/s, stable", omega: 60.0, end: [3.1597313460929035, 0.46945385801884876] };
const UNSTABLE: Run =
    Run { title: "omega = 30 rad/s, unstable", omega: 30.0, end: [-8.12131262418247, -0.9455167958966941] };
const START: [f64; 2] = [3.0, 0.0];

/// Time between samples, more than a hundred per period of the pivot.
const STEP: f64 = 2.5e-4;

fn main() -> Result<(), Box<dyn Error>> {
    assert!(largest_deviation(&STABLE)? < 0.2);
    assert!(largest_deviation(&UNSTABLE)? > PI);
    for (a, lower, upper) in MATHIEU {
        let unit = (9.81_f64).sqrt();
        let found = boundaries(a)?;
        let mut rows = vec![("lower", found[0] / unit, lower)];
        assert_eq!(found[1].is_finite(), upper.is_finite(), "the upper boundary");
        if upper.is_finite() {
            rows.push(("upper", found[1] / unit, upper));
        }
        compare(&format!("boundaries for a = {a} l, in roots of g/l"), 1e-9, &rows);
    }
    chart()
}

/// Amplitudes in units of the length, and boundaries in units of √(g/l), by SciPy.
const MATHIEU: [(f64, f64, f64); 4] = [
    (0.1, 14.172890020818476, f64::INFINITY),
    (0.4, 3.6490955309290385, f64::INFINITY),
    (0.5, 2.9645457645213975, 6.0234183357883895),
    (0.6, 2.512926275747143, 3.3573316673945475),
];

/// Returns the frequencies between which the upright is stable; the upper one is infinite if it
/// does not exist.
fn boundaries(a: f64) -> Result<[f64; 2], Box<dyn Error>> {
    let sum = |omega| sum_of_multipliers(a, omega);
    // At slower drives the pendulum falls, and at faster ones it swings.
    let (slow, fast) = (2.0 * 9.81_f64.sqrt(), 1e3);
    let lower = first(|omega| Ok(sum(omega)? < 2.0), slow, fast)?;
    let upper =
        if sum(fast)? > -2.0 { f64::INFINITY } else { first(|omega| Ok(sum(omega)? < -2.0), lower, fast)? };
    Ok([lower, upper])
}

/// Returns the sum of both multipliers, whose product is one: between −2 and 2 they are complex.
fn sum_of_multipliers(a: f64, omega: f64) -> Result<f64, Box<dyn Error>> {
    let upright = Kapitza { a, omega, ..Kapitza::default() }.orbit([PI, 0.0], TAU / omega).solve()?;
    Ok(upright.monodromy[(0, 0)] + upright.monodromy[(1, 1)])
}

/// Returns the number above which a condition holds, by bisection.
fn first(
    holds: impl Fn(f64) -> Result<bool, Box<dyn Error>>,
    mut low: f64,
    mut high: f64,
) -> Result<f64, Box<dyn Error>> {
    while high - low > 1e-12 * high {
        let middle = f64::midpoint(low, high);
        *(if holds(middle)? { &mut high } else { &mut low }) = middle;
    }
    Ok(high)
}

const SIDE: usize = if cfg!(debug_assertions) { 12 } else { 400 };
/// Points on each boundary.
const POINTS: u32 = if cfg!(debug_assertions) { 4 } else { 120 };
/// Time up to which deviations must not grow to count as stable.
const UNTIL: f64 = 25.0;

/// Draws the time at which deviations from the upright have grown thirtyfold, over amplitude and
/// frequency.
fn chart() -> Result<(), Box<dyn Error>> {
    let (amplitudes, frequencies) = (0.12..0.7, 5.0..45.0);
    let grid = Grid::new(("a", amplitudes.clone(), SIDE), ("omega", frequencies.clone(), SIDE));
    let pendulum = Kapitza::default();
    let grows = pendulum.ensemble(grid.len()).start(|_, _| [PI + 0.005, 0.0]);
    let grows = grows.parameters(|i, pendulum| [pendulum.a, pendulum.omega] = grid.at(i));
    let grows = grows.until(UNTIL).tolerance(1e-8);
    let grows = grows.stop_at("grows", Direction::Rising, |_, _, y| (y[0] - PI).powi(2) - 0.15 * 0.15);
    let ends = grows.observe("growth", |_, t, _| if t < UNTIL { t } else { f64::NAN }).run()?;
    assert!(ends.failures().is_empty());

    let span = amplitudes.end - amplitudes.start;
    let curves = (0..=POINTS).map(|k| {
        let a = amplitudes.start + span * f64::from(k) / f64::from(POINTS);
        let inside = |omega: f64| if frequencies.contains(&omega) { omega } else { f64::NAN };
        Ok((a, boundaries(a)?.map(inside)))
    });
    let curves = curves.collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    check(&grid, ends.column("growth").unwrap_or_default())?;
    let map = ends.map(&grid, "growth")?.logarithmic().named("time until the deviation is thirtyfold in s");
    let map = map.curve("lower boundary", curves.iter().map(|(a, [lower, _])| (*a, *lower)));
    // The boundary enters through the upper edge, nearly vertically.
    let edge = frequencies.end;
    let entrance = first(|a| Ok(sum_of_multipliers(a, edge)? < -2.0), amplitudes.start, amplitudes.end)?;
    let upper = curves.iter().map(|(a, [_, upper])| (*a, *upper)).filter(|(a, _)| *a > entrance);
    let map = map.curve("upper boundary", [(entrance, edge)].into_iter().chain(upper));
    Ok(map.save(gallery::picture("kapitza.png")?)?)
}

/// Compares growth with the boundaries, except for cells within 3 % of a boundary, where growth is
/// slow.
fn check(grid: &Grid, grows: &[f64]) -> Result<(), Box<dyn Error>> {
    let mut compared = 0;
    // Cells in a column share the amplitude of the first row.
    for column in (0..SIDE).step_by(SIDE / 12) {
        let [lower, upper] = boundaries(grid.at(column)[0])?;
        for cell in (column..grid.len()).step_by(SIDE) {
            let [a, omega] = grid.at(cell);
            if [lower, upper].iter().any(|boundary| (omega / boundary - 1.0).abs() < 0.03) {
                continue;
            }
            compared += 1;
            let is_stable = lower < omega && omega < upper;
            assert_eq!(grows[cell].is_nan(), is_stable, "a = {a} m, omega = {omega} rad/s");
        }
    }
    println!("{compared} cells are stable or not as the multipliers say");
    Ok(())
}

/// Compares a run with its reference, and returns the largest deviation from the upright position.
fn largest_deviation(run: &Run) -> Result<f64, Box<dyn Error>> {
    let pendulum = Kapitza { omega: run.omega, ..Kapitza::default() };
    let simulation = pendulum.simulate(START).until(5.0).tolerance(1e-13).every(STEP);
    let trajectory = simulation.energy().outputs().run()?;
    let largest = trajectory.theta().iter().map(|theta| (theta - PI).abs()).fold(0.0, f64::max);
    let [theta, theta_dot] = trajectory.last();
    let rows = [("theta", theta, run.end[0]), ("theta_dot", theta_dot, run.end[1])];
    compare(run.title, 1e-10, &rows);
    let power = trajectory.column("power_time").ok_or("no power")?;
    let supplied = simpson(power, STEP);
    let energy = trajectory.column("energy").ok_or("no energy")?;
    let stored = energy[energy.len() - 1] - energy[0];
    compare("energy, J", 1e-6, &[("stored", stored, supplied)]);
    let bound = 2.0 * pendulum.g * pendulum.l;
    println!("a^2 omega^2 = {:.1}, 2 g l = {bound:.1}", (pendulum.a * pendulum.omega).powi(2));
    println!("largest deviation from upright: {largest:.3} rad\n");
    Ok(largest)
}

/// Integrates values at an odd number of equidistant points.
fn simpson(values: &[f64], step: f64) -> f64 {
    values.windows(3).step_by(2).map(|v| step / 3.0 * (v[0] + 4.0 * v[1] + v[2])).sum()
}
