//! A marble that rolls in a round bowl, declared in one line: `contact touch = marble inside bowl`.
//!
//! The compiler writes the gap R − r − |c − p| and the slip velocity of the lowest point of the
//! marble. Without slip, its centre moves like a pendulum of the length
//!
//! ```text
//! l = 7/5 (R − r),    because    T = ½ (m + J/r²) v²    with    J = 2/5 m r².
//! ```
//!
//! Its period is 2π √(l/g) / M(1, cos θ₀/2), with the arithmetic-geometric mean M (Gauss). Look for
//! the marble back at its start after one period, at an amplitude of 60 degrees. With less friction
//! it slips on the steep part, and no longer comes back.

mod common;
#[cfg(feature = "draw")]
#[path = "common/gallery.rs"]
mod gallery;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::{Contact, EventKind, Friction};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// A marble in a bowl.
    #[derive(Clone, Debug)]
    pub struct Marble;

    param m: kg > 0 = 0.02, r: m > 0 = 0.01, size: m > 0 = 0.15, mu >= 0 = 0.8, g: m/s^2 = 9.81;
    gravity = (0, 0, -g);
    sphere bowl { center: (0, 0, size); radius: size; }
    body marble { mass: m; shape: solid_sphere(r); }
    free marble;
    start marble_z = r;
    contact touch = marble inside bowl { friction: mu; }
    emit { drawing }
}

/// Computes the period of a pendulum.
fn period(length: f64, amplitude: f64, g: f64) -> f64 {
    let (mut mean, mut root) = (1.0, (0.5 * amplitude).cos());
    while (mean - root).abs() > 1e-15 {
        (mean, root) = (0.5 * (mean + root), f64::sqrt(mean * root));
    }
    TAU * (length / g).sqrt() / mean
}

/// Draws the marble with the forces of the bowl, and a film.
#[cfg(feature = "draw")]
fn draw(marble: &Marble, run: &Trajectory<Marble>) -> Result<(), Box<dyn Error>> {
    let drawing = lagrange::draw::Drawing::of(marble).title("A marble in a bowl").nameless().forces();
    drawing.picture(0.05, &run.at(0.05)?)?.save(gallery::picture("marble.png")?)?;
    drawing.film_at(30.0, run)?.save(gallery::picture("marble.html")?)?;
    Ok(())
}

#[cfg(not(feature = "draw"))]
fn draw(_marble: &Marble, _run: &Trajectory<Marble>) -> Result<(), Box<dyn Error>> {
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let marble = Marble::default();
    let &Marble { r, size, g, .. } = &marble;
    let (amplitude, path) = (60_f64.to_radians(), size - r);
    let (x, z) = (path * amplitude.sin(), size - path * amplitude.cos());
    let begin = MarbleState { marble_x: x, marble_z: z, ..marble.start() };
    let period = period(1.4 * path, amplitude, g);
    let trajectory = marble.simulate(begin).until(period).tolerance(1e-12).dense().run()?;
    let end = MarbleState::from(trajectory.last());
    let there = trajectory.system_at_end().ok_or("it touches the bowl")?;
    assert_eq!((there.touch, there.touch_friction), (Contact::Closed, Friction::Sticks));
    let rows = [
        ("x after a period, m", end.marble_x, x),
        ("z after a period, m", end.marble_z, z),
        ("speed after a period, m/s", end.marble_vx, 0.0),
        ("spin after a period, rad/s", end.marble_wy, 0.0),
    ];
    compare("a marble in a bowl", 1e-9, &rows);
    draw(&marble, &trajectory)?;

    let smooth = Marble { mu: 0.1, ..marble };
    let trajectory = smooth.simulate(begin).until(period).tolerance(1e-10).run()?;
    assert!(trajectory.events().iter().any(|event| event.kind == EventKind::Stuck));
    let end = MarbleState::from(trajectory.last());
    println!("with less friction, x after that time is {:.4} m", end.marble_x);
    Ok(())
}
