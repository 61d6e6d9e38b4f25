//! A bead on a hoop that rotates about its vertical diameter: a bifurcation of equilibria.
//!
//! Relative to the hoop of radius R the bead has the potential −m g R cos θ − ½ m ω² R² sin² θ.
//! Below ω² = g/R it rests at the bottom. Above, the bottom is unstable, and two stable equilibria
//! have branched off,
//!
//! ```text
//! cos θ = g/(ω² R),
//! ```
//!
//! about which small deviations oscillate with Ω² = ω² sin² θ (Goldstein, Poole, Safko, *Classical
//! Mechanics*, 3rd ed., ch. 2). The top is unstable at every speed. Friction along the hoop makes
//! stable equilibria asymptotically stable.
//!
//! Look for the pitchfork in the plot, and for the speed at which it branches.
//!
//! `cargo run --example hoop --features linear,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::linear::{Linearise, Stability};
use lagrange::plot::label::Label;
use lagrange::plot::notation::formula;
use lagrange::plot::{Curve, Figure, Panel};

lagrange::system! {
    /// A bead by its angle from the bottom of the hoop.
    #[derive(Clone, Debug)]
    pub struct Hoop;

    param m: kg = 0.1, r: m = 0.5, c: N*m*s = 0.01, omega: rad/s = 0, g: m/s^2 = 9.81;
    coord theta: rad;
    kinetic = 1/2 * m * r^2 * (dot(theta)^2 + omega^2 * sin(theta)^2);
    potential = -m * g * r * cos(theta);
    dissipation = 1/2 * c * dot(theta)^2;
    emit { system_matrix }
}

/// An equilibrium at a speed of the hoop.
#[derive(Clone, Copy)]
struct Resting {
    omega: f64,
    theta: f64,
    is_stable: bool,
    /// Product of both eigenvalues, Ω².
    stiffness: f64,
}

const FASTEST: f64 = 10.0;
const SPEEDS: u32 = 500;

fn main() -> Result<(), Box<dyn Error>> {
    let hoop = Hoop::default();
    let speed = |k: u32| FASTEST * f64::from(k) / f64::from(SPEEDS);
    let bottom = branch(&hoop, 0.0, (0..=SPEEDS).map(speed))?;
    let top = branch(&hoop, PI, (0..=SPEEDS).map(speed))?;
    // Downwards from the fastest speed, until the branch merges with the bottom.
    let mut raised = branch(&hoop, 1.4, (0..=SPEEDS).rev().map(speed))?;
    raised.retain(|resting| resting.theta > 1e-6);

    let critical = (hoop.g / hoop.r).sqrt();
    compare("the pitchfork, rad/s", 1e-14, &[("bottom", lost(&hoop, 0.0, FASTEST)?, critical)]);
    assert_eq!(raised.len(), (0..=SPEEDS).filter(|k| speed(*k) > critical).count(), "it ends there");
    for Resting { omega, theta, stiffness, .. } in raised.iter().copied() {
        assert!((theta.cos() - hoop.g / (omega * omega * hoop.r)).abs() < 1e-14, "at {omega}");
        assert!((stiffness - (omega * theta.sin()).powi(2)).abs() < 1e-11, "at {omega}");
    }
    assert!(bottom.iter().all(|at| at.theta.abs() < 1e-12 && at.is_stable == (at.omega < critical)));
    assert!(top.iter().all(|at| (at.theta - PI).abs() < 1e-12 && !at.is_stable));
    assert!(raised.iter().all(|at| at.is_stable));
    let fastest = raised[0];
    let closed = (hoop.g / (FASTEST * FASTEST * hoop.r)).acos();
    compare("raised at 10 rad/s", 1e-14, &[("theta", fastest.theta, closed)]);

    draw(&[bottom, top, raised])
}

/// Returns the equilibria near an angle at successive speeds, each search starting at the previous
/// result.
fn branch(hoop: &Hoop, near: f64, speeds: impl Iterator<Item = f64>) -> Result<Vec<Resting>, Box<dyn Error>> {
    let mut theta = near;
    let mut found = Vec::new();
    for omega in speeds {
        let hoop = Hoop { omega, ..hoop.clone() };
        let resting = at(&hoop, theta)?;
        theta = resting.theta;
        found.push(resting);
    }
    Ok(found)
}

/// Returns the equilibrium near an angle.
fn at(hoop: &Hoop, near: f64) -> Result<Resting, Box<dyn Error>> {
    let state = hoop.equilibrium([near, 0.0]).solve()?.state;
    let model = hoop.linearise(0.0, state)?;
    let is_stable = model.modes()?.stability() == Stability::AsymptoticallyStable;
    Ok(Resting { omega: hoop.omega, theta: state[0], is_stable, stiffness: -model.a()[(1, 0)] })
}

/// Returns the speed at which the equilibrium at an angle becomes unstable, by bisection.
fn lost(hoop: &Hoop, theta: f64, fastest: f64) -> Result<f64, Box<dyn Error>> {
    let (mut stable, mut unstable) = (0.0, fastest);
    loop {
        let omega = f64::midpoint(stable, unstable);
        if omega == stable || omega == unstable {
            return Ok(omega);
        }
        let end = at(&Hoop { omega, ..hoop.clone() }, theta)?;
        *(if end.stiffness > 0.0 { &mut stable } else { &mut unstable }) = omega;
    }
}

/// Draws angles over speeds, for the raised bead on both sides.
fn draw(branches: &[Vec<Resting>]) -> Result<(), Box<dyn Error>> {
    let curve = |name: &str, is_stable: bool| {
        let shown = move |sign: f64, at: &Resting| {
            (at.omega, if at.is_stable == is_stable { sign * at.theta } else { f64::NAN })
        };
        let points = branches.iter().flat_map(|branch| {
            let sides = [1.0, -1.0].into_iter();
            // Branches are not connected.
            let gap = [(f64::NAN, f64::NAN)];
            sides.flat_map(move |sign| branch.iter().map(move |at| shown(sign, at)).chain(gap))
        });
        Curve { name: Label::parse(name), points: points.collect() }
    };
    let panel = Panel {
        x: Label::parse(&format!("{} in rad/s", formula("omega"))),
        y: Label::parse(&format!("{} in rad", formula("theta"))),
        curves: vec![curve("stable", true), curve("unstable", false)],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, size: (720, 420) }.save(&gallery::picture("hoop.svg")?)?;
    Ok(())
}
