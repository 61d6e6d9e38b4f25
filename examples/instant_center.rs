//! The geometric construction of the instantaneous centre of a connecting rod.
//!
//! The crank rotates about O, so its pin A moves perpendicularly to OA; the slider's pin B moves
//! along its guide. The normals to both velocities intersect in M, the point of the rod that is at
//! rest. Here M is on the line through O and A, straight above B. From there
//!
//! ```text
//! r_M = r_P + e_z × v_P/ω    for any point P of the rod,    ω = v_B/|MB|.
//! ```
//!
//! Look for M, which is the same from A, from B and by construction. The slider does not rotate and
//! therefore has none.
//!
//! `cargo run --example instant_center --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::draw::{Drawing, Moment, Sketch};

lagrange::system! {
    /// Crank, connecting rod and slider, by the angle of the crank.
    #[derive(Clone, Debug)]
    pub struct Engine;

    param r: m = 0.4, l: m = 1.0, h: m = 0.2, m1: kg = 1.0, m2: kg = 1.5, m3: kg = 0.8;
    coord theta: rad;
    let tilt = -asin(r / l * sin(theta));
    let wrist = (r * cos(theta) + l * cos(tilt), 0);
    line guide { through: (0, -h / 2); }
    body crank { mass: m1; shape: slender_rod(r); origin: r / 2 * (cos(theta), sin(theta)); angle: theta; }
    body rod { mass: m2; shape: slender_rod(l); origin: wrist - l / 2 * (cos(tilt), sin(tilt)); angle: tilt; }
    body slider { mass: m3; shape: rectangle(h * 3 / 2, h); center: wrist; }
    pin crank.point(-r / 2, 0) to (0, 0);
    pin crank.point(r / 2, 0) to rod.point(-l / 2, 0);
    pin rod.point(l / 2, 0) to slider;
    slide slider.point(0, -h / 2) on guide;
    output center = instant_center(rod);
    emit { motion, drawing }
}

const STATE: [f64; 2] = [55.0 * PI / 180.0, 2.0];

fn main() -> Result<(), Box<dyn Error>> {
    let engine = Engine::default();
    let (q, v) = ([STATE[0]], [STATE[1]]);
    let rod = engine.rod_motion(0.0, &q, &v);
    let [a, b] = ends(&engine).map(|end| rod.point(end));
    // On the line O A, straight above B.
    let expected = [b[0], b[0] * STATE[0].tan()];
    let found = rod.instant_center().ok_or("the rod does not turn")?;
    let declared = engine.center(0.0, &q, &v);
    for (title, center) in [("from the motion", found), ("from the declaration", declared)] {
        compare(title, 1e-13, &[("x_M, m", center[0], expected[0]), ("y_M, m", center[1], expected[1])]);
    }
    let speed = rod.velocity_at(ends(&engine)[1])[0];
    let rows = [
        ("omega, rad/s", rod.angular_velocity, speed / expected[1]),
        (
            "|MA| omega, m/s",
            rod.angular_velocity.abs() * (found[0] - a[0]).hypot(found[1] - a[1]),
            engine.r * STATE[1],
        ),
    ];
    compare("speeds are distances from M", 1e-13, &rows);
    assert_eq!(engine.slider_motion(0.0, &q, &v).instant_center(), None);
    println!("the slider does not turn: no instantaneous centre\n");

    Drawing::of(&engine)
        .title("Construction of the instantaneous centre")
        .nameless()
        .annotate(explain)
        .picture(0.0, &STATE)?
        .save(gallery::picture("instant_center.svg")?)?;
    Ok(())
}

/// Returns A and B in the rod's own coordinates.
fn ends(&Engine { l, .. }: &Engine) -> [[f64; 2]; 2] {
    [[-l / 2.0, 0.0], [l / 2.0, 0.0]]
}

/// Draws both velocities, their normals and the intersection of these.
fn explain(sketch: &mut Sketch, moment: &Moment<'_, Engine>) {
    let Some(rod) = moment.motion("rod") else { return };
    let Some(center) = rod.instant_center() else { return };
    let [a, b] = ends(moment.system);
    sketch.ink(0).dashed(rod.point(a), center).dashed(rod.point(b), center);
    sketch.velocity(rod.point(a), rod.velocity_at(a), "v_A").velocity(
        rod.point(b),
        rod.velocity_at(b),
        "v_B",
    );
    sketch.ink(0).point([0.0, 0.0], "O").point(rod.point(a), "A").point(rod.point(b), "B");
    sketch.ink(2).point(center, "M");
}
