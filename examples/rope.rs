//! A cylinder rolls down a slope and pulls a cuboid along a floor that is smooth at first and then
//! rough.
//!
//! Both have the mass m; the rope runs over a massless pulley. The cuboid, 2 r long, is on smooth
//! floor up to s = l1. Then the friction grows with the fraction of its length on rough floor, up
//! to μ m g. The cylinder may meet a wall at s = l3. From rest
//!
//! ```text
//! 5/4 v² = g s sin α                                on smooth floor,
//! 5/4 v² = g s sin α − μ g (s − l1)²/(4 r)          while the cuboid enters the rough floor,
//! 5/4 v² = g s sin α − μ g (s − l1 − r)             on rough floor,
//! ```
//!
//! so that it comes to rest at s = μ (l1 + r)/(μ − sin α), unless this is beyond the wall.
//!
//! The rolling is a joint, the rope a separate constraint. Their multipliers are the friction below
//! the cylinder and the force of the rope. Another coordinate, w, has no inertia and a constraint
//! on its velocity: it is the work of the friction, integrated along with the motion. Look for T +
//! V − w, which stays constant, and for both ends: at rest for μ = 0.8, at the wall for μ = 0.6.
//!
//! `cargo run --example rope --features draw,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::{Drawing, Moment, Picture, Sketch};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// The cuboid at s, the cylinder at x down the slope, turned by phi; the pulley is near the
    /// edge, the origin.
    #[derive(Clone, Debug)]
    pub struct Rope;

    param m: kg = 1.0, r: m = 0.25, l1: m = 1.0, l3: m = 4.0, mu = 0.8, alpha: deg = 30, g: m/s^2 = 9.81;
    coord s: m, x: m, phi: rad, w: J;

    gravity = (0, -g);
    line ground {}
    line slope { angle: -alpha; }
    body cuboid { mass: m; shape: rectangle(2 * r, 2 * r); center: (s - l3 - 3 * r, r); }
    body cylinder {
        mass: m;
        shape: solid_cylinder(r);
        center: (x + 3 * r) * (cos(alpha), -sin(alpha)) + r * (sin(alpha), cos(alpha));
        angle: -phi;
    }
    slide cuboid.point(0, -r) on ground;
    roll contact = cylinder on slope;
    constraint rope = s - x;

    let full = mu * m * g;
    let grip = if s < l1 { 0 } else if s < l1 + 2 * r { full * (s - l1) / (2 * r) } else { full };
    friction floor = dot(s), grip;
    constraint work = dot(w) + grip * dot(s);

    event enters = s - l1, rising => record;
    event rough = s - l1 - 2 * r, rising => record;
    event wall = s - l3, rising => stop;
    output rope_force = rope;
    output pull = ddot(s);
    emit { drawing }
}

/// Columns plotted against s.
const ENERGIES: [&str; 4] = ["T in J", "V in J", "heat in J", "sum in J"];

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Rope::default();
    let run = motion(&scene, "mu = 0.8")?;
    let (last, system) = (RopeState::from(run.last()), run.system_at_end().unwrap_or(&scene));
    let (q, v) = (last.coordinates(), last.velocities());
    let held = scene.m * scene.g * scene.alpha.sin();
    let [grip] = system.reactions(0.0, &q, &v);
    let rows = [
        ("s, m", last.s, 10.0 / 3.0),
        ("s_dot, m/s", last.s_dot, 0.0),
        ("friction, N", grip, -held),
        ("rope, N", system.rope_force(0.0, &q, &v), held),
    ];
    compare("mu = 0.8, at rest", 1e-9, &rows);
    states(&scene, &run)?;
    run.plot_against("s", &ENERGIES, gallery::picture("rope_energy.svg")?)?;

    let last = RopeState::from(motion(&Rope { mu: 0.6, ..scene }, "mu = 0.6")?.last());
    let speed = (0.8_f64 * 9.81 * 0.35).sqrt();
    compare("mu = 0.6, at the wall", 1e-10, &[("s, m", last.s, 4.0), ("s_dot, m/s", last.s_dot, speed)]);
    Ok(())
}

/// Simulates the motion from rest, and compares the events with the formulas.
fn motion(scene: &Rope, title: &str) -> Result<Trajectory<Rope>, Box<dyn Error>> {
    let trajectory = scene
        .simulate([0.0; 8])
        .until(10.0)
        .tolerance(1e-13)
        .every(0.01)
        .observe_each(ENERGIES, energies)
        .observe_each(["rope", "sag"], rope_force)
        .run()?;
    for event in trajectory.events() {
        let state = RopeState::from(event.state);
        let row = ("s_dot^2", state.s_dot.powi(2), squared_speed(scene, state.s));
        compare(
            &format!("{title}, {} at {:.6} s, s = {:.6} m", event.name, event.time, state.s),
            1e-12,
            &[row],
        );
    }
    let column = |name| trajectory.column(name).unwrap_or_default();
    let total = column(ENERGIES[3]);
    let drift = total.iter().map(|now| (now - total[0]).abs()).fold(0.0, f64::max);
    let sag = column("sag").iter().copied().map(f64::abs).fold(0.0, f64::max);
    let slack = column("rope").iter().copied().fold(f64::INFINITY, f64::min);
    println!("largest error of T + V - w {drift:.1e} J, of the rope's force {sag:.1e} N");
    println!("smallest force of the rope {slack:.3} N\n");
    assert!(drift < 1e-10 && sag < 1e-10 && slack > 0.0);
    Ok(trajectory)
}

/// Returns T, V relative to the start, the heat −w and their sum.
fn energies(rope: &Rope, t: f64, y: &[f64; 8]) -> [f64; 4] {
    let state = RopeState::from(*y);
    let kinetic = rope.kinetic_energy(t, &state.coordinates(), &state.velocities());
    let potential = rope.potential_energy(t, &state.coordinates()) - rope.potential_energy(t, &[0.0; 4]);
    [kinetic, potential, -state.w, kinetic + potential - state.w]
}

/// Returns the force of the rope, and its difference from m g sin α − 3/2 m s̈.
fn rope_force(rope: &Rope, t: f64, y: &[f64; 8]) -> [f64; 2] {
    let state = RopeState::from(*y);
    let (q, v) = (state.coordinates(), state.velocities());
    let force = rope.rope_force(t, &q, &v);
    let wanted = rope.m * (rope.g * rope.alpha.sin() - 1.5 * rope.pull(t, &q, &v));
    [force, force - wanted]
}

/// Returns the square of the speed at s, by the formulas above.
fn squared_speed(rope: &Rope, s: f64) -> f64 {
    let &Rope { r, l1, mu, alpha, g, .. } = rope;
    let lost = if s < l1 {
        0.0
    } else if s < l1 + 2.0 * r {
        (s - l1).powi(2) / (4.0 * r)
    } else {
        s - l1 - r
    };
    0.8 * g * (s * alpha.sin() - mu * lost)
}

/// Draws four states side by side: at the start, at the rough floor, on it, and at the end.
fn states(scene: &Rope, run: &Trajectory<Rope>) -> Result<(), Box<dyn Error>> {
    let events = run.events().iter().filter(|event| ["enters", "rough"].contains(&event.name.as_str()));
    let states = [(0.0, run.first())].into_iter().chain(events.map(|event| (event.time, event.state)));
    let states = states.chain([(run.end_time(), run.last())]);
    let titles = ["Start", "The rough floor is reached", "All of it is rough", "At rest"];
    let pictures = states.zip(titles).map(|((t, y), title)| {
        let drawing = Drawing::of(scene).size(420.0, 260.0).title(title).nameless().annotate(surroundings);
        drawing.past(run.iter()).picture(t, &y)
    });
    let pictures = pictures.collect::<Result<Vec<Picture>, _>>()?;
    Picture::beside(&pictures).save(gallery::picture("rope.svg")?)?;
    Ok(())
}

/// Draws the rough part of the floor, the rope, the pulley and the wall.
fn surroundings(sketch: &mut Sketch, moment: &Moment<'_, Rope>) {
    let (Some(cuboid), Some(cylinder)) = (moment.motion("cuboid"), moment.motion("cylinder")) else { return };
    let &Rope { r, l1, l3, alpha, .. } = moment.system;
    let down = |along: f64, away: f64| {
        [along * alpha.cos() + away * alpha.sin(), away * alpha.cos() - along * alpha.sin()]
    };
    // Initial position of the cuboid's front.
    let front = -l3 - 2.0 * r;
    let wall = 3.0 * r + l3 + r;
    sketch.ink(0).segment(down(wall, 0.0), down(wall, 3.0 * r));
    sketch.ink(2).segment([front + l1, 0.0], [0.0, 0.0]);
    let pulley = [r * (alpha / 2.0).tan(), r];
    sketch.ink(0).polyline(&[cuboid.point([r, 0.0]), pulley, cylinder.center]).point(pulley, "");
}
