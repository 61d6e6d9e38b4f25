//! A cuboid slides after a cylinder that rolls, down the same slope, and catches up with it.
//!
//! Both have the mass m. The cuboid slides without friction and starts a distance d above the cylinder, which rolls
//! without slipping, its friction slowing it down. That both stay on the slope and that the cylinder rolls are
//! constraints, whose multipliers are the forces of a free-body diagram:
//!
//! ```text
//! N = m g cos α  (both bodies),    H = m g sin α/3,    a = 2/3 g sin α  and  g sin α,    t = sqrt(6 d/(g sin α)).
//! ```
//!
//! The bodies touch where the distance between them, a function of the state, falls to zero: an event.
//!
//! Look for the time, which is the same for every mass.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// Cuboid and cylinder; x points down the slope from where each body starts, y away from the slope.
    #[derive(Clone, Debug)]
    pub struct Slope;

    param m = 1.0, r = 0.25, d = 10.0, alpha = 30 * pi / 180, g = 9.81;
    coord x1, y1, x2, y2, phi;

    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2);
    kinetic = 1/2 * m * (dot(x2)^2 + dot(y2)^2) + 1/4 * m * r^2 * dot(phi)^2;
    potential = -m * g * sin(alpha) * (x1 + x2) + m * g * cos(alpha) * (y1 + y2);
    constraint on_slope = y1;
    constraint normal = y2;
    constraint rolling = x2 - r * phi;
    event touch = d + x2 - x1, falling => stop;
}

fn main() -> Result<(), Box<dyn Error>> {
    for m in [1e-3, 1.0, 40.0] {
        race(&Slope { m, ..Slope::default() })?;
    }
    Ok(())
}

fn race(slope: &Slope) -> Result<(), Box<dyn Error>> {
    let &Slope { m, d, alpha, g, .. } = slope;
    let trajectory = slope.simulate([0.0; 10]).until(100.0).tolerance(1e-13).run()?;
    let (t, end) = (trajectory.end_time(), SlopeState::from(trajectory.last()));
    let (q, v) = (end.coordinates(), end.velocities());
    let [on_slope, normal, rolling] = slope.multipliers(t, &q, &v);
    let [cuboid, _, cylinder, ..] = slope.acceleration(t, &q, &v);
    let (weight, drive) = (m * g, g * alpha.sin());
    let rows = [
        ("time, s", t, 3.497_487_084),
        ("cuboid, m", end.x1, drive * t * t / 2.0),
        ("cylinder, m", end.x2, drive * t * t / 3.0),
        ("cuboid, m/s^2", cuboid, drive),
        ("cylinder, m/s^2", cylinder, 2.0 / 3.0 * drive),
        ("N of cuboid, N", on_slope, weight * alpha.cos()),
        ("N of cylinder, N", normal, weight * alpha.cos()),
        ("H, N", -rolling, m * drive / 3.0),
    ];
    compare(&format!("m = {m} kg"), 1e-10, &rows);
    assert!((t - (6.0 * d / drive).sqrt()).abs() < 1e-13 * t);
    Ok(())
}
