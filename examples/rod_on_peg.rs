//! A rod that moves broadside hits a fixed peg with its end.
//!
//! The impulse of the peg acts at the distance l/2 from the centre of mass, so the rod starts to
//! rotate. At the peg the rod has the effective mass 1/(1/m + (l/2)²/J) = m/4, and with the
//! coefficient of restitution e
//!
//! ```text
//! impulse = (1 + e) m v/4,    ω = (1 + e) 3 v/(2 l),    loss = (1 − e²)/4 of the kinetic energy:
//! ```
//!
//! a case of the general v⁺ = v⁻ − (1 + e) M⁻¹ Jᵀ (J M⁻¹ Jᵀ)⁻¹ J v⁻ with the gradient J of the gap.
//! See Pfeiffer, Glocker, *Multibody Dynamics with Unilateral Contacts*, chapter 8. Look for the
//! plastic impact, e = 0: ω = 3 v/(2 l), and a quarter of the energy is lost.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::EventKind;

lagrange::system! {
    /// A uniform rod in the plane without gravity; the peg is at height 0 below its left end.
    #[derive(Clone, Debug)]
    pub struct Rod;

    param m: kg = 2.0, l: m = 1.5, e = 0.0;
    coord x: m, y: m, theta: rad;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/24 * m * l^2 * dot(theta)^2;
    event peg = y - l / 2 * sin(theta), falling => impact(e);
}

const SPEED: f64 = 2.0;
const HEIGHT: f64 = 0.3;

fn main() -> Result<(), Box<dyn Error>> {
    for e in [0.0, 0.5, 1.0] {
        meet(&Rod { e, ..Rod::default() })?;
    }
    Ok(())
}

fn meet(rod: &Rod) -> Result<(), Box<dyn Error>> {
    let start = RodState { x: 0.0, y: HEIGHT, theta: 0.0, x_dot: 0.0, y_dot: -SPEED, theta_dot: 0.0 };
    let trajectory = rod.simulate(start).until(0.3).tolerance(1e-13).dense().run()?;
    let event = trajectory.events().first().ok_or("the rod meets nothing")?;
    let (EventKind::Impact(hit) | EventKind::Closed { impact: hit, .. }) = event.kind else {
        return Err("the event is no impact".into());
    };
    let after = RodState::from(trajectory.at(event.time)?);
    let &Rod { m, l, e, .. } = rod;
    let energy = 0.5 * m * SPEED * SPEED;
    let rows = [
        ("time, s", event.time, HEIGHT / SPEED),
        ("impulse, N s", hit.impulse, (1.0 + e) * m * SPEED / 4.0),
        ("y_dot, m/s", after.y_dot, -SPEED + (1.0 + e) * SPEED / 4.0),
        ("omega, rad/s", after.theta_dot.abs(), (1.0 + e) * 1.5 * SPEED / l),
        ("part lost", hit.energy_loss / energy, (1.0 - e * e) / 4.0),
    ];
    compare(&format!("e = {e}"), 1e-13, &rows);
    Ok(())
}
