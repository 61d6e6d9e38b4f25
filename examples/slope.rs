//! A cuboid slides after a cylinder that rolls down the same slope, and catches up with it.
//!
//! Both have the mass m. The cuboid slides without friction and starts a distance d above the
//! cylinder, which rolls without slipping and is slowed down by friction. Joints keep both on the
//! slope and make the cylinder roll; their forces are those of a free-body diagram:
//!
//! ```text
//! N = m g cos α  (both bodies),    H = m g sin α/3,    a = 2/3 g sin α  and  g sin α,    t = sqrt(6 d/(g sin α)).
//! ```
//!
//! The bodies touch when the distance between them, a function of the state, falls to zero: an
//! event.
//!
//! The statements that replace bodies and joints, and that are differentiated, are printed first.
//!
//! Look for the time, which is the same for every mass, and for the two free-body diagrams.
//!
//! `cargo run --example slope --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::{Drawing, Moment, Picture, Sketch};

lagrange::system! {
    /// Cuboid and cylinder, each by the place of its centre; phi turns clockwise, as the cylinder
    /// does.
    #[derive(Clone, Debug)]
    pub struct Slope;

    param m: kg = 1.0, r: m = 0.25, alpha: deg = 30, g: m/s^2 = 9.81;
    coord x1: m, y1: m, x2: m, y2: m, phi: rad;

    gravity = (0, -g);
    line slope { angle: -alpha; }
    body cuboid { mass: m; shape: rectangle(2 * r, 2 * r); center: (x1, y1); angle: -alpha; }
    body cylinder { mass: m; shape: solid_cylinder(r); center: (x2, y2); angle: -phi; }
    slide foot = cuboid.point(0, -r) on slope;
    roll contact = cylinder on slope;

    event touch = slope.along(cylinder) - slope.along(cuboid) - 2 * r, falling => stop;
    output forces = (foot.normal, contact.normal, contact.friction);
    output places = (slope.along(cuboid), slope.along(cylinder));
    output accelerations = (norm(acceleration(cuboid)), norm(acceleration(cylinder)));
    emit { drawing, statements }
}

/// Distance d in m.
const DISTANCE: f64 = 10.0;
/// Shorter distance for pictures, so that both bodies are visible.
const SHORT: f64 = 2.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}\n", Slope::STATEMENTS);
    for m in [1e-3, 1.0, 40.0] {
        race(&Slope { m, ..Slope::default() })?;
    }
    diagrams(&Slope::default())?;
    film(&Slope::default())
}

/// Returns the state at rest, with the cuboid at position 0 along the slope and the cylinder at a
/// distance below it.
fn start(slope: &Slope, distance: f64) -> SlopeState {
    let (sine, cosine) = slope.alpha.sin_cos();
    let on_slope = |s: f64| [s * cosine + slope.r * sine, slope.r * cosine - s * sine];
    let ([x1, y1], [x2, y2]) = (on_slope(0.0), on_slope(distance + 2.0 * slope.r));
    SlopeState { x1, y1, x2, y2, ..SlopeState::from([0.0; 10]) }
}

fn race(slope: &Slope) -> Result<(), Box<dyn Error>> {
    let &Slope { m, alpha, g, .. } = slope;
    let begin = start(slope, DISTANCE);
    let trajectory = slope.simulate(begin).until(100.0).tolerance(1e-13).run()?;
    let (t, end) = (trajectory.end_time(), SlopeState::from(trajectory.last()));
    let (q, v) = (end.coordinates(), end.velocities());
    let [of_cuboid, of_cylinder, friction] = slope.forces(t, &q, &v);
    let [cuboid, cylinder] = slope.accelerations(t, &q, &v);
    let [[s1, s2], [s10, s20]] =
        [slope.places(t, &q, &v), slope.places(0.0, &begin.coordinates(), &[0.0; 5])];
    let (weight, drive) = (m * g, g * alpha.sin());
    let rows = [
        ("time, s", t, 3.497_487_084),
        ("cuboid, m", s1 - s10, drive * t * t / 2.0),
        ("cylinder, m", s2 - s20, drive * t * t / 3.0),
        ("cuboid, m/s^2", cuboid, drive),
        ("cylinder, m/s^2", cylinder, 2.0 / 3.0 * drive),
        ("N of cuboid, N", of_cuboid, weight * alpha.cos()),
        ("N of cylinder, N", of_cylinder, weight * alpha.cos()),
        ("H, N", -friction, m * drive / 3.0),
    ];
    compare(&format!("m = {m} kg"), 1e-10, &rows);
    assert!((t - (6.0 * DISTANCE / drive).sqrt()).abs() < 1e-13 * t);
    Ok(())
}

/// Draws each body alone, with the forces on it.
fn diagrams(slope: &Slope) -> Result<(), Box<dyn Error>> {
    let state = start(slope, SHORT).into();
    let alone = |body: &str, title: &str| {
        Drawing::of(slope)
            .size(400.0, 400.0)
            .title(title)
            .nameless()
            .free_body(body)
            .accelerations()
            .picture(0.0, &state)
    };
    let pictures = [alone("cuboid", "The cuboid slides")?, alone("cylinder", "The cylinder rolls")?];
    Picture::beside(&pictures).save(gallery::picture("slope_forces.svg")?)?;
    Ok(())
}

/// Films a shorter race, so that both bodies are visible.
fn film(slope: &Slope) -> Result<(), Box<dyn Error>> {
    let trajectory = slope.simulate(start(slope, SHORT)).until(100.0).tolerance(1e-10).every(0.04).run()?;
    let drawing = Drawing::of(slope).title("The cuboid catches up").nameless().velocities().annotate(angle);
    drawing.picture(0.0, &start(slope, SHORT).into())?.save(gallery::picture("slope.svg")?)?;
    drawing.film(&trajectory)?.save(gallery::picture("slope_race.svg")?)?;
    Ok(())
}

/// Draws the angle of the slope at the start of the cuboid.
fn angle(sketch: &mut Sketch, moment: &Moment<'_, Slope>) {
    let (alpha, end) = (moment.system.alpha, 2.0 * SHORT);
    let foot = [end * alpha.cos(), -end * alpha.sin()];
    sketch.ink(0).dashed(foot, [foot[0] - end / 3.0, foot[1]]);
    sketch.angle(foot, std::f64::consts::PI - alpha, std::f64::consts::PI, "alpha");
}
