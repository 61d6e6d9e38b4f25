//! A cart balances a pendulum in wind. An integral compensates for the wind: a first-order state of
//! the declaration.
//!
//! The force on the cart is u = 4.7 x − 39.7 (θ − π) + 5.3 ẋ − 8.3 θ̇ + K z, with ż = x. Without
//! the integral, K = 0, the cart ends where the feedback of its position balances the wind, at x =
//! −w/4.7. With it, the cart ends at zero and the integral balances the wind, z = −w/K (Åström,
//! Hägglund, *Advanced PID Control*, §3.2). The state at 5 s is computed by `tools/control.py` in
//! multi-precision arithmetic.
//!
//! The gains place the poles of the motion linearised about the upright position at −1.06, −1.34 ±
//! 0.10 i and −4.00 ± 0.67 i s⁻¹.

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A cart that carries a pendulum, in wind, with its controller; θ is measured from the lower
    /// position.
    #[derive(Clone, Debug)]
    pub struct Balanced;

    param mc: kg = 1.0, mp: kg = 0.1, l: m = 0.5, c: N*m*s = 0.01, g: m/s^2 = 9.81, wind: N = 0.3, gain: N/(m*s) = 1.6;
    coord x: m, theta: rad;
    state integral: m*s;

    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;

    dot(integral) = x;
    let u = 4.7 [N/m] * x - 39.7 [N] * (theta - pi) + 5.3 [N*s/m] * dot(x) - 8.3 [N*s] * dot(theta) + gain * integral;
    force x = wind + u;
    output push = u;
}

/// State x, θ, integral, ẋ, θ̇ at 5 s.
const REFERENCE: [f64; 5] = [
    -0.07127790070504682,
    3.144071801805709,
    -0.09935608157707461,
    0.05035453488871282,
    0.0003231483919184119,
];
/// Initial state at rest, leaning by 0.2 rad.
const START: [f64; 5] = [0.0, PI - 0.2, 0.0, 0.0, 0.0];

fn main() -> Result<(), Box<dyn Error>> {
    let cart = Balanced::default();
    let motion = cart.simulate(START).until(5.0).tolerance(1e-13).run()?;
    let end = motion.last();
    let rows: [_; 5] = std::array::from_fn(|i| (motion.names()[i].as_str(), end[i], REFERENCE[i]));
    compare("in wind, t = 5 s", 1e-12, &rows);

    let [x, theta, integral, ..] = cart.simulate(START).until(30.0).run()?.last();
    let learned = -cart.wind / cart.gain;
    compare(
        "with the integral",
        1e-8,
        &[("x", x, 0.0), ("theta", theta, PI), ("integral", integral, learned)],
    );
    let plain = Balanced { gain: 0.0, ..cart };
    let [x, theta, ..] = plain.simulate(START).until(30.0).run()?.last();
    compare("without it", 1e-8, &[("x", x, -cart.wind / 4.7), ("theta", theta, PI)]);
    Ok(())
}
