//! A ladder that slides down, and leaves the wall before it lands.
//!
//! A uniform ladder of length l stands at the angle θ₀ to a smooth floor against a smooth wall.
//! Both ends slide, and the multipliers of these joints are the forces that push the ladder away.
//! The wall pushes until
//!
//! ```text
//! sin θ = 2/3 sin θ₀,
//! ```
//!
//! where its multiplier changes sign: an event (Beer, Johnston, *Vector Mechanics for Engineers:
//! Dynamics*, chapter 17). From then on the ladder only touches the floor, and its centre moves
//! sideways at the speed ⅓ sqrt(g l sin³ θ₀). Energy alone gives the angular velocity at landing.
//! Times are integrals over the angle, computed with 40 digits. A second declaration has floor and
//! wall as contacts that only push, and runs through from the start to the landing.
//!
//! Look for the floor's force when the ladder leaves the wall, which is a quarter of its weight for
//! any θ₀.

mod common;

use std::error::Error;
use std::f64::consts::FRAC_PI_3;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::EventKind;
use lagrange::event::Direction;

lagrange::system! {
    /// A ladder between floor and wall, by its centre and its angle to the floor.
    #[derive(Clone, Debug)]
    pub struct Leaning;

    param m: kg = 10.0, l: m = 3.0, g: m/s^2 = 9.81;
    coord x: m, y: m, theta: rad;
    gravity = (0, -g);
    line ground {}
    line house { angle: -pi / 2; }
    body ladder { mass: m; shape: slender_rod(l); center: (x, y); angle: -theta; }
    slide floor = ladder.point(l / 2, 0) on ground;
    slide wall = ladder.point(-l / 2, 0) on house;
    output forces = (floor.normal, wall.normal);
}

lagrange::system! {
    /// The ladder when floor and wall only push.
    #[derive(Clone, Debug)]
    pub struct Ladder;

    param m: kg = 10.0, l: m = 3.0, g: m/s^2 = 9.81;
    coord x: m, y: m, theta: rad;
    gravity = (0, -g);
    line ground {}
    line house { angle: -pi / 2; }
    body ladder { mass: m; shape: slender_rod(l); center: (x, y); angle: -theta; }
    event floor = ground.distance(ladder.point(l / 2, 0)), falling => impact(0);
    event wall = house.distance(ladder.point(-l / 2, 0)), falling => impact(0);
    event lands = theta, falling => stop;
}

/// Angle at release.
const ANGLE: f64 = FRAC_PI_3;
/// Times at which it leaves the wall and lands, in s.
const TIMES: [f64; 2] = [0.562_969_689_175_059_9, 0.840_345_852_953_131_5];

fn main() -> Result<(), Box<dyn Error>> {
    let leaning = Leaning::default();
    let &Leaning { m, l, g } = &leaning;
    let (sine, cosine) = ANGLE.sin_cos();
    let start = [l / 2.0 * cosine, l / 2.0 * sine, ANGLE, 0.0, 0.0, 0.0];
    let forces = |t: f64, y: &[f64; 6]| {
        let state = LeaningState::from(*y);
        leaning.forces(t, &state.coordinates(), &state.velocities())
    };
    let wall_force = |_: &Leaning, t: f64, y: &[f64; 6]| forces(t, y)[1];
    let fall = leaning
        .simulate(start)
        .until(2.0)
        .tolerance(1e-13)
        .stop_at("leaves", Direction::Falling, wall_force)
        .run()?;
    let (time, end) = (fall.end_time(), LeaningState::from(fall.last()));
    let sideways = (g * l * sine.powi(3)).sqrt() / 3.0;
    let rows = [
        ("time, s", time, TIMES[0]),
        ("angle", end.theta, (2.0 / 3.0 * sine).asin()),
        ("rate, rad/s", end.theta_dot, -(g / l * sine).sqrt()),
        ("sideways, m/s", end.x_dot, sideways),
        ("floor, N", forces(time, &fall.last())[0], m * g / 4.0),
    ];
    compare("leaves the wall", 1e-11, &rows);

    whole_motion(start, sideways)
}

/// Runs from release to landing; the contacts themselves detect when they end.
fn whole_motion(start: [f64; 6], sideways: f64) -> Result<(), Box<dyn Error>> {
    let ladder = Ladder::default();
    let motion = ladder.simulate(start).until(2.0).tolerance(1e-13).run()?;
    let [opens, lands] = motion.events() else {
        return Err(format!("{:?} are not two events", motion.events()).into());
    };
    assert_eq!((opens.name.as_str(), opens.kind), ("wall", EventKind::Opened));
    let landed = LadderState::from(lands.state);
    let sine = ANGLE.sin();
    let rate = (ladder.g / ladder.l * (3.0 * sine - sine.powi(3) / 3.0)).sqrt();
    let rows = [
        ("leaves at, s", opens.time, TIMES[0]),
        ("lands at, s", lands.time, TIMES[1]),
        ("rate, rad/s", landed.theta_dot, -rate),
        ("sideways, m/s", landed.x_dot, sideways),
    ];
    compare("contacts that only push", 1e-11, &rows);
    Ok(())
}
