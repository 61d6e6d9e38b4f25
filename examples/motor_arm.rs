//! A motor lifts an arm against gravity. Its current is a first-order state, and so are the
//! supplied energy and the heat.
//!
//! The current of a motor with inductance L and resistance R obeys L i̇ = u − R i − N k θ̇. Here N
//! is the ratio of the gear and k the motor constant. The motor turns the arm with the torque N k
//! i. Three results are known:
//!
//! - the state half a second after 1 V is applied, by `tools/control.py` in multi-precision
//!   arithmetic;
//! - the arm comes to rest where the torque of the current u/R holds its weight: sin θ = 2 N k u /
//!   (R m g l);
//! - the supplied energy is in the motion, in the field of the coil or has become heat.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// An arm on a motor with a gear, which θ measures from below.
    #[derive(Clone, Debug)]
    pub struct MotorArm;

    param m: kg = 1, l: m = 0.5, rotor: kg*m^2 = 1/10000, gear = 50, c: N*m*s = 0.02, g: m/s^2 = 9.81;
    param k: N*m/A = 0.05, r: ohm = 1.2, inductance: H = 0.05;
    coord theta: rad;
    state current: A, supplied: J, heat: J;
    input voltage: V;

    kinetic = 1/2 * (m * l^2 / 3 + gear^2 * rotor) * dot(theta)^2;
    potential = -m * g * l / 2 * cos(theta);
    dissipation = 1/2 * c * dot(theta)^2;
    force theta = gear * k * current;

    dot(current) = (voltage - r * current - gear * k * dot(theta)) / inductance;
    dot(supplied) = voltage * current;
    dot(heat) = r * current^2 + c * dot(theta)^2;
    output field = 1/2 * inductance * current^2;
}

/// Values of θ, current, supplied energy, heat and θ̇ at 0.5 s.
const REFERENCE: [f64; 5] =
    [0.15893305523490608, 0.14099674041060242, 0.0796812707435039, 0.030514598888832695, 0.32643611220981816];

fn main() -> Result<(), Box<dyn Error>> {
    let arm = MotorArm { voltage: 1.0, ..MotorArm::default() };
    let rise = arm.simulate([0.0; 5]).until(0.5).tolerance(1e-13).run()?;
    let end = rise.last();
    let rows: [_; 5] = std::array::from_fn(|i| (rise.names()[i].as_str(), end[i], REFERENCE[i]));
    compare("t = 0.5 s", 1e-12, &rows);

    let motion = arm.simulate([0.0; 5]).until(160.0).tolerance(1e-13).energy().outputs().run()?;
    let last = |name: &str| motion.column(name).and_then(|column| column.last().copied()).unwrap_or(f64::NAN);
    let held = 2.0 * arm.gear * arm.k * arm.voltage / (arm.r * arm.m * arm.g * arm.l);
    compare(
        "at rest",
        1e-9,
        &[("theta", last("theta"), held.asin()), ("current", last("current"), 1.0 / 1.2)],
    );
    let gained = last("energy") - arm.energy(0.0, &[0.0; 4], &[0.0]);
    let balance = [("supplied", last("supplied"), gained + last("field") + last("heat"))];
    compare("energy", 1e-11, &balance);
    Ok(())
}
