//! One body relative to two reference points: the angular velocity is the same.
//!
//! A rod with a plate at its end swings. The velocity of its point Q is composed once from point P
//! and once from point P′,
//!
//! ```text
//! v_Q = v_P + ω e_z × ρ = v_P′ + ω′ e_z × ρ′,
//! ```
//!
//! and the velocities of any two points give back ω = (e_z × ρ)·(v_Q − v_P)/ρ². Look for ω′, which
//! is ω from every reference point, whereas both parts of v_Q differ.
//!
//! `cargo run --example reference_points --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::body::Motion;
use lagrange::draw::{Drawing, Moment, Picture, Sketch};

lagrange::system! {
    /// A plate on a rod, as one body.
    #[derive(Clone, Debug)]
    pub struct Paddle;

    param m: kg = 1.5, a: m = 0.9, b: m = 0.5, g: m/s^2 = 9.81;
    coord x: m, y: m, phi: rad;
    gravity = (0, -g);
    body paddle { mass: m; shape: rectangle(a, b); center: (x, y); angle: phi; }
    emit { motion, drawing }
}

const STATE: [f64; 6] = [0.0, 0.0, 0.35, 0.5, 0.3, 1.4];
/// Points P, P′ and Q in the body's own coordinates.
const POINTS: [[f64; 2]; 3] = [[-0.38, -0.15], [0.05, -0.2], [0.3, 0.18]];

fn main() -> Result<(), Box<dyn Error>> {
    let system = Paddle::default();
    let state = PaddleState::from(STATE);
    let paddle = system.paddle_motion(0.0, &state.coordinates(), &state.velocities());
    let [p, p_dash, q] = POINTS;
    let velocity = paddle.velocity_at(q);
    for (name, from) in [("P", p), ("P′", p_dash)] {
        let [moving, turning] = paddle.velocity_from(q, from);
        println!("from {name}: v_{name} = {moving:.4?} m/s, omega e_z x rho = {turning:.4?} m/s");
        let rows = [
            ("v_Q x, m/s", moving[0] + turning[0], velocity[0]),
            ("v_Q y, m/s", moving[1] + turning[1], velocity[1]),
            ("omega, rad/s", spin(&paddle, from, q), state.phi_dot),
        ];
        compare(&format!("seen from {name}"), 1e-14, &rows);
    }
    let pictures = [picture(&system, p, "P")?, picture(&system, p_dash, "P′")?];
    Picture::beside(&pictures).save(gallery::picture("reference_points.svg")?)?;
    Ok(())
}

/// Computes ω from the velocities of two points.
fn spin(body: &Motion<f64>, p: [f64; 2], q: [f64; 2]) -> f64 {
    let ([x, y], [vx, vy]) =
        (difference(body.point(q), body.point(p)), difference(body.velocity_at(q), body.velocity_at(p)));
    (x * vy - y * vx) / (x * x + y * y)
}

/// Draws the velocity of Q, composed from the velocity of a reference point.
fn picture(system: &Paddle, reference: [f64; 2], name: &str) -> Result<Picture, Box<dyn Error>> {
    let label = name.to_owned();
    let drawing = Drawing::of(system)
        .size(420.0, 420.0)
        .title(&format!("Seen from {name}"))
        .nameless()
        .annotate(move |sketch, moment| explain(sketch, moment, reference, &label));
    Ok(drawing.picture(0.0, &STATE)?)
}

fn explain(sketch: &mut Sketch, moment: &Moment<'_, Paddle>, p: [f64; 2], name: &str) {
    let Some(paddle) = moment.motion("paddle") else { return };
    let dash = name.trim_start_matches('P');
    let [.., q] = POINTS;
    let (at_p, at_q) = (paddle.point(p), paddle.point(q));
    let [moving, turning] = paddle.velocity_from(q, p);
    let label = format!("v_{{P{dash}}}");
    sketch.ink(4).arrow(at_p, difference(at_q, at_p), "");
    sketch.text([(at_p[0] + at_q[0]) / 2.0 - 0.03, (at_p[1] + at_q[1]) / 2.0 + 0.02], &format!("ρ{dash}"));
    sketch.velocity(at_p, moving, &label).velocity(at_q, moving, &label);
    sketch.velocity(at_q, turning, &format!("omega e_z × rho{dash}"));
    sketch.velocity(at_q, paddle.velocity_at(q), "v_Q");
    sketch.ink(0);
    for (place, label) in POINTS.into_iter().zip(["P", "P′", "Q"]) {
        sketch.point(paddle.point(place), label);
    }
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
