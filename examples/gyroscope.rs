//! A gyroscope: a disk on an axle with a fixed end, released at 60° from the vertical.
//!
//! It falls, and precesses as it falls, which lifts it again. The axis thus nods between two angles
//! as it goes around. By quadratures, energy and two angular momenta give both angles, the time of
//! a nod and the precession of the axis in that time. See Goldstein, Poole, Safko, *Classical
//! Mechanics*, §5.7. `tools/spatial_examples.py` computes them with twenty digits. The declaration
//! has a body and a ball joint; the state has a quaternion, so that no position of the axis is
//! special.
//!
//! Look for the axis after one nod: at rest again, and rotated about the vertical by the reference
//! precession. In the picture its end traces the cusps at which it rests.

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::FRAC_PI_6;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;

lagrange::system! {
    /// A disk on a thin axle.
    #[derive(Clone, Debug)]
    pub struct Gyroscope;
    param m: kg = 1.0, r: m = 0.1, h: m = 0.02, l: m = 0.12, g: m/s^2 = 9.81;
    /// Mass and length of the axle.
    param mass: kg = 0.05, length: m = 0.2;
    gravity = (0, 0, -g);
    body disk {
        compound {
            solid_cylinder(r, h), mass: m, at: (0, 0, l);
            slender_rod(length), mass: mass, at: (0, 0, length/2), turned: (0, pi/2, 0);
        }
    }
    ball pivot = ground to disk;
    output tip = disk.point(0, 0, length);
    emit { drawing }
}

/// Smallest angle of the axis from the vertical.
const LEAST: f64 = 1.047_197_551_196_597_7;
/// Largest angle of the axis from the vertical.
const MOST: f64 = 1.550_191_274_704_819;
/// Time of a nod.
const PERIOD: f64 = 0.397_596_435_589_004_5;
/// Precession in the time of a nod.
const PRECESSION: f64 = 1.633_556_050_800_379;
/// Spin about the axis in rad/s.
const SPIN: f64 = 60.0;

fn main() -> Result<(), Box<dyn Error>> {
    let gyroscope = Gyroscope::default();
    // Rotated by 60° about the x-axis.
    let (sin, cos) = FRAC_PI_6.sin_cos();
    let start = GyroscopeState {
        pivot_qw: cos,
        pivot_qx: sin,
        pivot_qy: 0.0,
        pivot_qz: 0.0,
        pivot_wx: 0.0,
        pivot_wy: 0.0,
        pivot_wz: SPIN,
    };
    let axis = |y: &[f64; 7]| {
        let tip = gyroscope.tip(0.0, &[y[0], y[1], y[2], y[3]], &[y[4], y[5], y[6]]);
        tip.map(|component| component / gyroscope.length)
    };
    let inclination = |y: &[f64; 7]| axis(y)[2].acos();
    let after = |nods: f64| {
        let end = nods * PERIOD;
        gyroscope.simulate(start).until(end).tolerance(1e-13).ends_only().run().map(|motion| motion.last())
    };
    let (half, whole) = (after(0.5)?, after(1.0)?);
    // The axis started above −y.
    let [x, y, _] = axis(&whole);
    let rows = [
        ("lowest, rad", inclination(&half), MOST),
        ("after a nod, rad", inclination(&whole), LEAST),
        ("at rest, rad/s", whole[4].hypot(whole[5]), 0.0),
        ("precession, rad", x.atan2(-y), PRECESSION),
    ];
    compare("a gyroscope nods", 1e-10, &rows);

    let motion =
        gyroscope.simulate(start).until(4.0 * PERIOD).tolerance(1e-10).every(PERIOD / 50.0).energy().run()?;
    let drawing = Drawing::of(&gyroscope)
        .title("A gyroscope nods while it precesses")
        .view(0.4, 0.35)
        .nameless()
        .trace("", |gyroscope, t, y| gyroscope.tip(t, &[y[0], y[1], y[2], y[3]], &[y[4], y[5], y[6]]));
    let film = drawing.film(&motion)?;
    film.save(gallery::picture("gyroscope.html")?)?;
    let last = film.pictures().last().cloned().ok_or("a film has pictures")?;
    last.save(gallery::picture("gyroscope.svg")?)?;
    Ok(())
}
