//! Chaplygin's sleigh: a body on a blade that does not slide sideways.
//!
//! The constraint ẏ cos θ − ẋ sin θ = 0 restricts velocities but not positions: it is nonholonomic.
//! The centre of mass is ahead of the blade by a. Released with a spin Ω and without speed, the
//! sleigh speeds up along its blade and stops turning,
//!
//! ```text
//! u = U tanh(τ),  θ̇ = Ω sech(τ),  τ = a Ω² t/U,  U = Ω sqrt((J + m a²)/m)
//! ```
//!
//! (Neimark, Fufaev, *Dynamics of Nonholonomic Systems*). No work is done, since the blade pushes
//! perpendicularly to its path.
//!
//! Look for heading and speed, and for the side force of the blade, m (u θ̇ + a θ̈): the
//! multiplier.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A body whose centre of mass is ahead of its blade.
    #[derive(Clone, Debug)]
    pub struct Sleigh;

    param m: kg = 1.2, j: kg*m^2 = 0.3, a: m = 0.4;
    coord x: m, y: m, theta: rad;
    let (cx, cy) = (x + a * cos(theta), y + a * sin(theta));
    kinetic = 1/2 * m * (dot(cx)^2 + dot(cy)^2) + 1/2 * j * dot(theta)^2;
    constraint blade = dot(y) * cos(theta) - dot(x) * sin(theta);
    output speed = dot(x) * cos(theta) + dot(y) * sin(theta);
}

const SPIN: f64 = 2.0;
/// Times and positions of the blade, integrated with 40 digits.
const PLACES: [(f64, [f64; 2]); 2] = [
    (1.0, [0.256_328_452_133_423_3, 0.550_293_679_359_788]),
    (10.0, [-8.361_927_302_556_358, 7.841_497_303_673_439]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let sleigh = Sleigh::default();
    let &Sleigh { m, j, a } = &sleigh;
    let fastest = SPIN * ((j + m * a * a) / m).sqrt();
    let pace = a * SPIN * SPIN / fastest;
    for (t, [x, y]) in PLACES {
        let trajectory =
            sleigh.simulate([0.0, 0.0, 0.0, 0.0, 0.0, SPIN]).until(t).tolerance(1e-13).ends_only().run()?;
        let end = SleighState::from(trajectory.last());
        let (q, v) = (end.coordinates(), end.velocities());
        let (u, spin) = (fastest * (pace * t).tanh(), SPIN / (pace * t).cosh());
        let spin_dot = -pace * spin * (pace * t).tanh();
        let rows = [
            ("x, m", end.x, x),
            ("y, m", end.y, y),
            ("heading", end.theta, 2.0 * SPIN / pace * (pace * t / 2.0).tanh().atan()),
            ("speed, m/s", sleigh.speed(t, &q, &v), u),
            ("spin, rad/s", end.theta_dot, spin),
            ("side force, N", sleigh.multipliers(t, &q, &v)[0], m * (u * spin + a * spin_dot)),
            ("slip, m/s", sleigh.constraints(t, &q, &v)[0], 0.0),
            ("energy, J", sleigh.energy(t, &q, &v), 0.5 * m * fastest * fastest),
        ];
        compare(&format!("t = {t} s"), 1e-12, &rows);
    }
    Ok(())
}
