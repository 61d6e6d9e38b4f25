//! A weight turns a dynamo that feeds a resistor through a diode: the voltage across the diode is
//! an algebraic unknown.
//!
//! The voltage k ω of the dynamo is the sum of u across the diode and R i across the resistor. The
//! diode obeys i = I (exp(u/U) − 1) (Shockley). This has no solution for u in elementary functions.
//! Three results are known:
//!
//! - the state 3 s after the weight was thrown up, by `tools/control.py` in multi-precision
//!   arithmetic: the diode blocks until it falls;
//! - in the end the current holds the weight, k i = m g r, at the speed (u + R i)/k with u = U ln(1 +
//!   i/I);
//! - what the weight loses is in the motion or has become heat.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A weight on a drum with a dynamo; θ grows as the weight falls.
    #[derive(Clone, Debug)]
    pub struct Dynamo;

    param m: kg = 0.2, radius: cm = 2, drum: kg*m^2 = 0.002, g: m/s^2 = 9.81;
    param k: V*s = 0.05, r: ohm = 5, leak: nA = 1, thermal: mV = 50;
    coord theta: rad;
    state heat: J;

    let emf = k * dot(theta);
    // From an estimate somewhat above the solution, a few steps suffice at any speed.
    solve drop: V: 0 = leak * (exp(drop / thermal) - 1) - (emf - drop) / r,
        start: thermal / 2 * ln(1 + (emf / (r * leak))^2);
    let current = (emf - drop) / r;

    kinetic = 1/2 * (drum + m * radius^2) * dot(theta)^2;
    potential = -m * g * radius * theta;
    force theta = -k * current;
    dot(heat) = emf * current;
    output amperes: A = current;
    emit { jacobian }
}

/// Values of θ, heat and θ̇ at 3 s.
const REFERENCE: [f64; 3] = [66.06650748219049, 0.46217396671431374, 45.533966473126505];

fn main() -> Result<(), Box<dyn Error>> {
    let dynamo = Dynamo::default();
    let thrown = DynamoState { theta: 0.0, heat: 0.0, theta_dot: -5.0 };
    let fall = dynamo.simulate(thrown).until(3.0).tolerance(1e-13).run()?;
    let end = fall.last();
    let rows: [_; 3] = std::array::from_fn(|i| (fall.names()[i].as_str(), end[i], REFERENCE[i]));
    compare("t = 3 s", 1e-12, &rows);

    let motion = dynamo.simulate(thrown).until(160.0).tolerance(1e-13).energy().outputs().run()?;
    let last = |name: &str| motion.column(name).and_then(|column| column.last().copied()).unwrap_or(f64::NAN);
    let held = dynamo.m * dynamo.g * dynamo.radius / dynamo.k;
    let drop = dynamo.thermal * (held / dynamo.leak).ln_1p();
    let speed = (drop + dynamo.r * held) / dynamo.k;
    compare(
        "in the end",
        1e-11,
        &[("theta_dot", last("theta_dot"), speed), ("current", last("amperes"), held)],
    );
    let start = dynamo.energy(0.0, &[0.0, 0.0], &[-5.0]);
    compare("energy", 1e-11, &[("heat", last("heat"), start - last("energy"))]);
    Ok(())
}
