//! A step ladder that slips, and the circular path of its instantaneous centre.
//!
//! Both halves have the length l; the left foot is fixed at O, the right one slips along the floor.
//! Let φ be the angle of the left half to the floor. The hinge is at (l cos φ, l sin φ) and the
//! right foot at (2 l cos φ, 0). The left half rotates about its foot. The normals to the
//! velocities of hinge and right foot intersect in
//!
//! ```text
//! M = (2 l cos φ, 2 l sin φ),
//! ```
//!
//! the instantaneous centre of the right half, on a circle of radius 2 l about O. The man on top
//! does not rotate: he moves on an arc of radius l about the point at his height above O.
//!
//! Look for the circle, for the man, who has no instantaneous centre, and for the energy, which
//! stays constant.
//!
//! `cargo run --example step_ladder --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::{Drawing, Moment, Sketch};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// A step ladder with a man on top, on a smooth floor.
    #[derive(Clone, Debug)]
    pub struct StepLadder;

    param m: kg = 6.0, man: kg = 75.0, l: m = 2.0, h: m = 0.85, g: m/s^2 = 9.81;
    coord phi: rad;
    gravity = (0, -g);
    line floor {}
    body left { mass: m; shape: slender_rod(l); origin: l / 2 * (cos(phi), sin(phi)); angle: phi; }
    body right { mass: m; shape: slender_rod(l); origin: l / 2 * (3 * cos(phi), sin(phi)); angle: -phi; }
    body person { mass: man; shape: ellipse(h / 4, h); center: left.point(l / 2, 0) + (0, h); }
    pin fixed = left.point(-l / 2, 0) to (0, 0);
    pin hinge = left.point(l / 2, 0) to right.point(-l / 2, 0);
    slide foot = right.point(l / 2, 0) on floor;

    output center = instant_center(right);
    event slipped = phi - 25 deg, falling => stop;
    emit { motion, drawing }
}

const START: StepLadderState = StepLadderState { phi: 70.0 * PI / 180.0, phi_dot: -0.05 };
/// Time of the still picture in s.
const SHOWN: f64 = 0.6;

fn main() -> Result<(), Box<dyn Error>> {
    let ladder = StepLadder::default();
    let run = ladder.simulate(START).until(10.0).tolerance(1e-13).every(0.04).energy().dense().run()?;
    check_centers(&ladder, &run)?;

    let drawing = Drawing::of(&ladder)
        .title("A step ladder slips")
        .nameless()
        .trace("", |ladder, t, y| {
            ladder.right_motion(t, &[y[0]], &[y[1]]).instant_center().unwrap_or([f64::NAN; 2])
        })
        .annotate(explain);
    let past = run.iter().filter(|(t, _)| *t < SHOWN);
    let still = drawing.clone().past(past).picture(SHOWN, &run.at(SHOWN)?)?;
    still.save(gallery::picture("step_ladder.svg")?)?;
    drawing.film(&run)?.save(gallery::picture("step_ladder.gif")?)?;
    Ok(())
}

/// Compares the centres with the circle throughout the motion.
fn check_centers(ladder: &StepLadder, run: &Trajectory<StepLadder>) -> Result<(), Box<dyn Error>> {
    let (l, h) = (ladder.l, ladder.h);
    let mut worst = [0.0_f64; 5];
    for (t, y) in run.iter() {
        let (q, v) = ([y[0]], [y[1]]);
        let (sine, cosine) = y[0].sin_cos();
        let [left, right, person] =
            [ladder.left_motion(t, &q, &v), ladder.right_motion(t, &q, &v), ladder.person_motion(t, &q, &v)];
        let center = right.instant_center().ok_or("the right half does not turn")?;
        let foot = left.instant_center().ok_or("the left half does not turn")?;
        let met = meeting_point(l, y[0], right.velocity_at([-l / 2.0, 0.0]));
        let errors = [
            (center[0] - 2.0 * l * cosine).hypot(center[1] - 2.0 * l * sine),
            center[0].hypot(center[1]) - 2.0 * l,
            foot[0].hypot(foot[1]),
            (met[0] - center[0]).hypot(met[1] - center[1]),
            person.center[0].hypot(person.center[1] - h) - l,
        ];
        worst.iter_mut().zip(errors).for_each(|(worst, error)| *worst = worst.max(error.abs()));
        assert_eq!(person.instant_center(), None);
    }
    let [formula, circle, foot, normals, arc] = worst;
    let rows = [
        ("M, m", formula, 0.0),
        ("circle, m", circle, 0.0),
        ("left half, m", foot, 0.0),
        ("normals, m", normals, 0.0),
        ("man's arc, m", arc, 0.0),
    ];
    compare("largest errors on the way", 1e-12, &rows);
    let energy = run.column("energy").unwrap_or_default();
    compare("energy, J", 1e-12, &[("at the end", energy[energy.len() - 1], energy[0])]);
    println!("slips to 25 degrees in {:.6} s\n", run.end_time());
    Ok(())
}

/// Returns the point where the normal to the velocity `v` of the hinge meets the vertical through
/// the right foot.
fn meeting_point(l: f64, phi: f64, [vx, vy]: [f64; 2]) -> [f64; 2] {
    let (hinge, foot) = ([l * phi.cos(), l * phi.sin()], 2.0 * l * phi.cos());
    [foot, hinge[1] - vx / vy * (foot - hinge[0])]
}

/// Draws the circle, both normals, the velocities and the centre.
fn explain(sketch: &mut Sketch, moment: &Moment<'_, StepLadder>) {
    let (Some(right), Some(person)) = (moment.motion("right"), moment.motion("person")) else { return };
    let l = moment.system.l;
    let (hinge, foot) = ([-l / 2.0, 0.0], [l / 2.0, 0.0]);
    let arc = (0..=60)
        .map(|i| f64::from(i) * PI / 120.0)
        .map(|angle| [2.0 * l * angle.cos(), 2.0 * l * angle.sin()]);
    sketch.ink(6).polyline(&arc.collect::<Vec<_>>()).ink(0).point([0.0, 0.0], "O");
    if let Some(center) = right.instant_center() {
        sketch.dashed([0.0, 0.0], center).dashed(right.point(foot), center).ink(2).point(center, "M");
    }
    sketch.velocity(right.point(hinge), right.velocity_at(hinge), "v_T");
    sketch.velocity(right.point(foot), right.velocity_at(foot), "v_F").velocity(
        person.center,
        person.velocity,
        "",
    );
}
