//! A billiard ball struck off-centre: it slides along a parabola until it rolls, then along a line
//! in a different direction.
//!
//! Friction on the cloth opposes the slip velocity s of the lowest point of the ball, in any
//! direction of the plane: Coulomb's cone. Let d be the initial direction of s. It never changes,
//! because force and moment of friction change s along itself, at the rate 7/2 μ g. Hence
//!
//! ```text
//! T = |s|/(7/2 μ g),    v = v₀ − μ g t d,    x = v₀ t − ½ μ g t² d    up to T,    then v = v(T).
//! ```
//!
//! (Coriolis, *Théorie mathématique des effets du jeu de billard*, 1835). Look for the time at
//! which sliding ends, found as an event, and for the subsequent position of the ball.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::EventKind;

lagrange::system! {
    /// A ball on the cloth of a table.
    #[derive(Clone, Debug)]
    pub struct Billiard;

    param m: kg > 0 = 0.17, r: m > 0 = 0.0286, mu in 0..=1 = 0.2, g: m/s^2 = 9.81;
    gravity = (0, 0, -g);
    body ball { mass: m; shape: solid_sphere(r); }
    free ball;
    start ball_z = r;

    let slip = velocity(ball) + cross(angular_velocity(ball), (0, 0, -r));
    event cloth = ball.origin.z - r, falling => impact(0);
    friction rub = (slip.x, slip.y), mu * cloth;
}

/// Duration of the motion, in s.
const DURATION: f64 = 2.0;

fn main() -> Result<(), Box<dyn Error>> {
    let billiard = Billiard::default();
    let &Billiard { r, mu, g, .. } = &billiard;
    // The ball is struck along x with backspin and side spin, in m/s and rad/s.
    let (velocity, spin) = ([3.0, 0.0], [60.0, -80.0, 40.0]);
    let begin = BilliardState {
        ball_vx: velocity[0],
        ball_wx: spin[0],
        ball_wy: spin[1],
        ball_wz: spin[2],
        ..billiard.start()
    };
    let trajectory = billiard.simulate(begin).until(DURATION).tolerance(1e-12).run()?;

    let slip = [velocity[0] - r * spin[1], velocity[1] + r * spin[0]];
    let speed = slip[0].hypot(slip[1]);
    let (stop, slowing) = (speed / (3.5 * mu * g), slip.map(|component| mu * g * component / speed));
    let [event] = trajectory.events() else { return Err("it comes to roll once".into()) };
    assert_eq!(event.kind, EventKind::Stuck);
    let end = BilliardState::from(trajectory.last());
    let rolling = [0, 1].map(|axis| velocity[axis] - slowing[axis] * stop);
    let place = [0, 1].map(|axis| {
        velocity[axis] * stop - 0.5 * slowing[axis] * stop * stop + rolling[axis] * (DURATION - stop)
    });
    let rows = [
        ("time of rolling, s", event.time, stop),
        ("x at the end, m", end.ball_x, place[0]),
        ("y at the end, m", end.ball_y, place[1]),
        ("speed along x, m/s", end.ball_vx, rolling[0]),
        ("speed along y, m/s", end.ball_vy, rolling[1]),
    ];
    compare("a ball struck off its centre", 1e-10, &rows);
    Ok(())
}
