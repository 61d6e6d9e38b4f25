//! The two modes of a double pendulum of rods, as films and as a picture of their extremes.
//!
//! Each rod has its own position and angle, and two pins impose four constraints. Two of the six
//! coordinates are free, and the others follow from the mode shapes. Two equal rods of length l
//! oscillate with
//!
//! ```text
//! ω² = (3 ± 6/√7) g/l,
//! ```
//!
//! and with ω² = μ g/l the equation of the lower rod, b̈/3 + ä/2 + (g/l) b/2 = 0, relates the
//! angles by b/a = 3 μ/(3 − 2 μ).
//!
//! Look for rods that swing together in the slow mode, and against each other in the fast one.
//!
//! `cargo run --example modes --features draw,linear`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::draw::{Drawing, Picture};
use lagrange::linear::{Linearise, Modes};

lagrange::system! {
    /// Two equal rods, hanging; angles are measured from the vertical.
    #[derive(Debug)]
    pub struct Rods;

    param m: kg = 1, l: m = 1, g: m/s^2 = 9.81;
    coord x1: m, y1: m, a: rad, x2: m, y2: m, b: rad;
    start y1 = -l / 2, y2 = -3 * l / 2;
    gravity = (0, -g);
    body upper { mass: m; shape: slender_rod(l); center: (x1, y1); angle: a - pi/2; }
    body lower { mass: m; shape: slender_rod(l); center: (x2, y2); angle: b - pi/2; }
    pin upper.point(-l/2, 0) to (0, 0);
    pin upper.point(l/2, 0) to lower.point(-l/2, 0);
    emit { system_matrix, drawing }
}

/// Largest angular displacement in rad.
const AMPLITUDE: f64 = 0.35;
const NAMES: [&str; 2] = ["slow", "fast"];

fn main() -> Result<(), Box<dyn Error>> {
    let rods = Rods::default();
    let hanging = rods.equilibrium(rods.start()).solve()?.state;
    let modes = rods.linearise(0.0, hanging)?.modes()?;
    println!("{modes}\n");
    check(&rods, &modes)?;

    let mut pictures = Vec::new();
    for (mode, name) in modes.modes().iter().zip(NAMES) {
        let title = format!("{name}: {:.3} Hz", mode.frequency());
        let drawing = Drawing::of(&rods).title(&title).size(240.0, 320.0).nameless();
        let swinging = rods.mode_motion(0.0, hanging, mode, AMPLITUDE).level().periods(1.0);
        pictures.extend(drawing.pictures(swinging.extremes()?)?);
        let film = drawing.timed_film(swinging.moments(25.0)?)?;
        film.save(gallery::picture(&format!("mode_{name}.svg"))?)?;
    }
    Picture::beside(&pictures).save(gallery::picture("modes.svg")?)?;
    Ok(())
}

fn check(rods: &Rods, modes: &Modes) -> Result<(), Box<dyn Error>> {
    for (index, (sign, name)) in [-1.0, 1.0].into_iter().zip(NAMES).enumerate() {
        let mu = 3.0 + sign * 6.0 / 7.0_f64.sqrt();
        let angle = |name: &str| modes.component(index, name).ok_or("no such angle");
        let ratio = angle("b")?.0 / angle("a")?.0;
        let rows = [
            ("frequency", modes.modes()[index].imaginary, (mu * rods.g / rods.l).sqrt()),
            ("lower / upper", ratio, 3.0 * mu / (3.0 - 2.0 * mu)),
        ];
        compare(&format!("{name} mode"), 1e-12, &rows);
    }
    Ok(())
}
